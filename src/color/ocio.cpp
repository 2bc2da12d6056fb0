// SPDX-License-Identifier: MIT
#include <locale.h>

#include <exception>
#include <locale>
#include <new>
#include <optional>
#include <sstream>

#include "color/config.h"
#include "color/cycle.h"
#include "color/ocio_transform.h"
#include "core/fork.h"
#include "core/regular_file.h"
#include "extension/error.h"

namespace shd::color {
namespace {

namespace ocio = OCIO_NAMESPACE;
using extension::refuse;

core::StaticForkMutex g_build(core::ForkLevel::kColorBuild);

/// Silences OpenColorIO and makes it read numbers with decimal points, for the duration of a scope. Both settings are
/// process-wide, so that one thread builds while the others wait.
class GlobalScope {
 public:
  GlobalScope() : lock_(g_build) {
    swap_locale_in();
    level_ = ocio::GetLoggingLevel();
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
  }
  ~GlobalScope() {
    ocio::SetLoggingLevel(level_);
    swap_locale_out();
  }
  GlobalScope(const GlobalScope&) = delete;
  GlobalScope& operator=(const GlobalScope&) = delete;

 private:
  // yaml-cpp reads numbers through streams of the global C++ locale. The locale is replaced only if it would read
  // numbers wrongly. The replacement has no name, because a named locale would also change the C locale.
  void swap_locale_in() {
    const std::locale host;
    const auto& numbers = std::use_facet<std::numpunct<char>>(host);
    if (numbers.decimal_point() == '.' && numbers.grouping().empty()) return;
    const std::locale plain(std::locale::classic(), new std::numpunct<char>);
    locale_.emplace(host);
    std::locale::global(plain);
  }
  void swap_locale_out() {
    if (!locale_) return;
    const char* name = setlocale(LC_ALL, nullptr);
    const std::string c_locale = name ? name : "C";
    std::locale::global(*locale_);
    setlocale(LC_ALL, c_locale.c_str());
  }

  const std::lock_guard<core::StaticForkMutex> lock_;
  ocio::LoggingLevel level_ = ocio::LOGGING_LEVEL_DEFAULT;
  std::optional<std::locale> locale_;  // the host's locale while it is replaced
};

/// Sets the C locale on this thread, so that the C library uses decimal points.
class ThreadLocale {
 public:
#if defined(__unix__) || defined(__APPLE__)
  ThreadLocale() : c_(newlocale(LC_ALL_MASK, "C", locale_t{})), saved_(uselocale(c_)) {}
  ~ThreadLocale() {
    uselocale(saved_);
    if (c_) freelocale(c_);
  }

 private:
  locale_t c_, saved_;
#else
  ThreadLocale() {}
#endif
 public:
  ThreadLocale(const ThreadLocale&) = delete;
  ThreadLocale& operator=(const ThreadLocale&) = delete;
};

/// Runs `body` on OpenColorIO and turns its exceptions into Failures.
template <class Body>
auto call_ocio(const char* what, shd_result otherwise, Body&& body) {
  const GlobalScope globals;
  const ThreadLocale locale;
  try {
    return body();
  } catch (const core::Failure&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const ocio::ExceptionMissingFile& error) {
    refuse(SHD_ERROR_NOT_FOUND, "%s: %s", what, error.what());
  } catch (const std::exception& error) {
    const bool newer = std::string(error.what()).find("not able to load that config version") != std::string::npos;
    refuse(newer ? SHD_ERROR_UNSUPPORTED : otherwise, "%s: %s", what, error.what());
  }
}

/// Collects the definitions that each definition of a config uses, for each direction, as OpenColorIO follows them.
class ReferenceReader {
 public:
  ReferenceReader(const std::string& source, const ocio::Config& config) : source_(source), config_(config) {}

  References read() {
    const int spaces = config_.getNumColorSpaces(ocio::SEARCH_REFERENCE_SPACE_ALL, ocio::COLORSPACE_ALL);
    for (int i = 0; i < spaces; ++i) {
      read_space(config_.getColorSpaceNameByIndex(ocio::SEARCH_REFERENCE_SPACE_ALL, ocio::COLORSPACE_ALL, i));
    }
    for (int i = 0; i < config_.getNumViewTransforms(); ++i) {
      const char* name = config_.getViewTransformNameByIndex(i);
      const auto view = config_.getViewTransform(name);
      add(view_node(name), view->getTransform(ocio::VIEWTRANSFORM_DIR_TO_REFERENCE), false);
      add(view_node(name), view->getTransform(ocio::VIEWTRANSFORM_DIR_FROM_REFERENCE), false);
    }
    for (int i = 0; i < config_.getNumLooks(); ++i) {
      const char* name = config_.getLookNameByIndex(i);
      const auto look = config_.getLook(name);
      add(look_node(name), look->getTransform(), false);
      add(look_node(name), look->getInverseTransform(), false);
    }
    for (int i = 0; i < config_.getNumNamedTransforms(ocio::NAMEDTRANSFORM_ALL); ++i) {
      const char* name = config_.getNamedTransformNameByIndex(ocio::NAMEDTRANSFORM_ALL, i);
      const auto named = config_.getNamedTransform(name);
      add(named_node(name), named->getTransform(ocio::TRANSFORM_DIR_FORWARD), false);
      add(named_node(name), named->getTransform(ocio::TRANSFORM_DIR_INVERSE), false);
    }
    return std::move(references_);
  }

 private:
  static std::string view_node(const std::string& name) { return "view transform " + name; }
  static std::string look_node(const std::string& name) { return "look " + name; }
  static std::string named_node(const std::string& name) { return "named transform " + name; }

  void read_space(const char* name) {
    const auto space = config_.getColorSpace(name);
    const auto to = space->getTransform(ocio::COLORSPACE_DIR_TO_REFERENCE);
    const auto from = space->getTransform(ocio::COLORSPACE_DIR_FROM_REFERENCE);
    add(std::string("to reference from ") + name, to ? to : from, !to);
    add(std::string("from reference to ") + name, from ? from : to, !from);
  }

  void add(const std::string& node, const ocio::ConstTransformRcPtr& transform, bool inverse) {
    collect(transform, inverse, references_[node]);
  }

  /// Adds the definition that converts between `name` and its reference space.
  void collect_space(const char* name, bool to_reference, std::vector<std::string>& out) const {
    const char* resolved = config_.getCurrentContext()->resolveStringVar(name);
    if (const auto space = config_.getColorSpace(resolved)) {
      out.push_back(std::string(to_reference ? "to reference from " : "from reference to ") + space->getName());
    } else if (config_.getNamedTransform(resolved)) {
      out.push_back(named_node(resolved));
    }
  }

  /// Looks are separated as in "a, -b | c".
  void collect_looks(const std::string& looks, std::vector<std::string>& out) const {
    for (int i = 0; i < config_.getNumLooks(); ++i) {
      const std::string name = config_.getLookNameByIndex(i);
      if (looks.find(name) == std::string::npos) continue;
      out.push_back(look_node(name));
      const char* process = config_.getLook(name.c_str())->getProcessSpace();
      collect_space(process, true, out);
      collect_space(process, false, out);
    }
  }

  void collect_default_view(std::vector<std::string>& out) const {
    if (const auto view = config_.getDefaultSceneToDisplayViewTransform()) out.push_back(view_node(view->getName()));
  }

  void collect(const ocio::ConstTransformRcPtr& transform, bool inverse, std::vector<std::string>& out) const {
    if (!transform) return;
    if (transform->getDirection() == ocio::TRANSFORM_DIR_INVERSE) inverse = !inverse;
    if (const auto group = ocio::DynamicPtrCast<const ocio::GroupTransform>(transform)) {
      for (int i = 0; i < group->getNumTransforms(); ++i) collect(group->getTransform(i), inverse, out);
    } else if (const auto file = ocio::DynamicPtrCast<const ocio::FileTransform>(transform)) {
      check_table(file->getSrc());
    } else if (const auto space = ocio::DynamicPtrCast<const ocio::ColorSpaceTransform>(transform)) {
      collect_space(space->getSrc(), !inverse, out);
      collect_space(space->getDst(), inverse, out);
      if (crosses_references(space->getSrc(), space->getDst())) collect_default_view(out);
    } else if (const auto look = ocio::DynamicPtrCast<const ocio::LookTransform>(transform)) {
      collect_space(look->getSrc(), !inverse, out);
      collect_space(look->getDst(), inverse, out);
      collect_looks(look->getLooks(), out);
    } else if (const auto view = ocio::DynamicPtrCast<const ocio::DisplayViewTransform>(transform)) {
      collect_space(view->getSrc(), !inverse, out);
      collect_space(config_.getDisplayViewColorSpaceName(view->getDisplay(), view->getView()), inverse, out);
      const std::string named = config_.getDisplayViewTransformName(view->getDisplay(), view->getView());
      if (!named.empty()) out.push_back(view_node(named));
      collect_looks(config_.getDisplayViewLooks(view->getDisplay(), view->getView()), out);
      collect_default_view(out);
    }
  }

  /// Refuses a lookup table that is no regular file: OpenColorIO opens it later by its path, and could block forever. A
  /// table that is missing is refused by the transforms that need it.
  void check_table(const char* name) const {
    std::string path;
    try {
      path = config_.getCurrentContext()->resolveFileLocation(name);
    } catch (const ocio::ExceptionMissingFile&) {
      return;
    }
    if (core::open_regular(path.c_str()).other_kind) {
      refuse(SHD_ERROR_IO, "%s: its table \"%.256s\" is not a regular file", source_.c_str(), path.c_str());
    }
  }

  /// Whether a conversion is between scene-referred and display-referred, which uses the default view transform.
  bool crosses_references(const char* a, const char* b) const {
    const auto context = config_.getCurrentContext();
    const auto left = config_.getColorSpace(context->resolveStringVar(a));
    const auto right = config_.getColorSpace(context->resolveStringVar(b));
    return left && right && left->getReferenceSpaceType() != right->getReferenceSpaceType();
  }

  const std::string& source_;  // used in messages
  const ocio::Config& config_;
  References references_;
};

class OcioConfig final : public Config {
 public:
  explicit OcioConfig(ocio::ConstConfigRcPtr config) : config_(std::move(config)) {
    for (int i = 0; i < config_->getNumDisplays(); ++i) {
      Display display{config_->getDisplay(i), {}, {}};
      display.default_view = config_->getDefaultView(display.name.c_str());
      for (int v = 0; v < config_->getNumViews(display.name.c_str()); ++v) {
        display.views.emplace_back(config_->getView(display.name.c_str(), v));
      }
      catalog_.displays.push_back(std::move(display));
    }
    if (!catalog_.displays.empty()) catalog_.default_display = catalog_.find_display(config_->getDefaultDisplay());
    for (int i = 0; i < config_->getNumColorSpaces(); ++i) {
      catalog_.spaces.emplace_back(config_->getColorSpaceNameByIndex(i));
    }
  }

  std::string space(const char* field, const char* name) const override {
    if (const auto found = config_->getColorSpace(name)) return found->getName();
    refuse(SHD_ERROR_NOT_FOUND, "%s: no colour space '%.128s'; there are %s", field, name,
           quoted_list(catalog_.spaces).c_str());
  }

 protected:
  TransformRef build_to_display(const std::string& from, const std::string& display,
                                const std::string& view) const override {
    return call_ocio("color transform", SHD_ERROR_CORRUPT, [&]() -> TransformRef {
      return std::make_shared<OcioTransform>(
          config_->getProcessor(from.c_str(), display.c_str(), view.c_str(), ocio::TRANSFORM_DIR_FORWARD));
    });
  }

  std::vector<Part> split_to_display(const std::string& from, const std::string& display,
                                     const std::string& view) const override {
    return call_ocio("color transform", SHD_ERROR_CORRUPT, [&] {
      return split_processor(
          config_, config_->getProcessor(from.c_str(), display.c_str(), view.c_str(), ocio::TRANSFORM_DIR_FORWARD));
    });
  }

  TransformRef build_between(const std::string& from, const std::string& to) const override {
    return call_ocio("color transform", SHD_ERROR_CORRUPT, [&]() -> TransformRef {
      return std::make_shared<OcioTransform>(config_->getProcessor(from.c_str(), to.c_str()));
    });
  }

 private:
  ocio::ConstConfigRcPtr config_;
};

}  // namespace

std::unique_ptr<Config> load_config(const Source& source) {
  g_build.attach();
  auto loaded = call_ocio(source.name.c_str(), SHD_ERROR_CORRUPT, [&]() -> std::unique_ptr<Config> {
    std::istringstream stream(source.text);
    stream.imbue(std::locale::classic());
    const ocio::ConfigRcPtr config = ocio::Config::CreateFromStream(stream)->createEditableCopy();
    config->setWorkingDir(source.directory.c_str());
    check_references(source.name, ReferenceReader(source.name, *config).read());
    config->validate();
    return std::make_unique<OcioConfig>(config);
  });
  loaded->attach();
  return loaded;
}

}  // namespace shd::color
