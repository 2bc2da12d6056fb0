// SPDX-License-Identifier: MIT
#include "tool/output.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "command/suggest.h"
#include "command/values.h"
#include "core/regular_file.h"
#include "tool/picture.h"

namespace {

using command::ends_with;

constexpr const char* kExtensions[] = {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr"};

/// The name of the output, with its extension also if it is standard output.
std::string output_of(const Options& options) {
  const std::string name = options.output.empty() && !options.hash ? "out.png" : options.output;
  const std::optional<std::string> type = stream_type(name);
  return type ? "-" + (type->empty() ? ".png" : *type) : name;
}

bool is_stream(const Options& options) {
  return stream_type(options.output).has_value();
}

/// Where %d or %04d is in a name.
struct Place {
  size_t at, size;
  int width;
};

std::vector<Place> find_numbers(const std::string& name) {
  std::vector<Place> places;
  for (size_t at = name.find('%'); at != std::string::npos; at = name.find('%', at + 1)) {
    const size_t end = name.find_first_not_of("0123456789", at + 1);
    if (end == std::string::npos || name[end] != 'd' || end - at > 3) continue;
    const int width = end == at + 1 ? 0 : std::stoi(name.substr(at + 1, end - at - 1));
    if (width <= 9) places.push_back({at, end + 1 - at, width});
  }
  return places;
}

constexpr int kEnding[] = {SIGHUP, SIGINT, SIGTERM};
volatile std::sig_atomic_t deferred_signal = 0;

/// Defers the signals that end the program to the end of its life.
struct DeferredSignals {
  using Handler = void (*)(int);
  DeferredSignals() {
    for (size_t i = 0; i < std::size(kEnding); ++i) {
      before[i] = std::signal(kEnding[i], [](int number) { deferred_signal = number; });
      if (before[i] == SIG_IGN) std::signal(kEnding[i], SIG_IGN);
    }
  }
  DeferredSignals(const DeferredSignals&) = delete;
  DeferredSignals& operator=(const DeferredSignals&) = delete;
  ~DeferredSignals() {
    for (size_t i = 0; i < std::size(kEnding); ++i) std::signal(kEnding[i], before[i]);
    const int number = deferred_signal;
    deferred_signal = 0;
    if (number) std::raise(number);
  }
  Handler before[std::size(kEnding)];
};

/// A folder for one file, which it removes together with the file, also if a signal ends the program.
struct ScratchFile {
  explicit ScratchFile(const std::string& extension) {
    const char* const place = std::getenv("TMPDIR");
    folder = std::string(place && *place ? place : "/tmp") + "/shd-render-XXXXXX";
    if (!::mkdtemp(folder.data())) throw Failure(kExitOutput, "\"" + folder + "\": " + std::strerror(errno));
    path = folder + "/picture" + extension;
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::remove(path.c_str());
    ::rmdir(folder.c_str());
  }
  const DeferredSignals signals;  // the first member, so that it ends after the removal
  std::string folder, path;
};

[[noreturn]] void refuse_stream() {
  throw Failure(kExitOutput, std::string("standard output: ") + std::strerror(errno));
}

std::string extension_of(const std::string& name) {
  return name.substr(name.rfind('.'));
}

/// Refuses a compression that the library does not write, by a picture of one pixel.
void check_compression(shd_context* context, const std::string& name, const std::string& compression) {
  shd_framebuffer_desc pixel = shd_framebuffer_desc_default();
  pixel.width = pixel.height = 1;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(context, &pixel, framebuffer.out()), "framebuffer");
  shd_save_desc desc = shd_save_desc_default();
  desc.compression = compression.c_str();
  const ScratchFile scratch(extension_of(name));
  check(shd_framebuffer_save(framebuffer.get(), scratch.path.c_str(), &desc), "--compression", kExitUsage);
}

/// Saves a file that has no name any longer: it goes with its descriptor, however the program ends.
shd::core::RegularFile save_unnamed(const shd_framebuffer* framebuffer, const std::string& name,
                                    const shd_save_desc& desc) {
  const ScratchFile scratch(extension_of(name));
  check(shd_framebuffer_save(framebuffer, scratch.path.c_str(), &desc), "-o", kExitOutput);
  shd::core::RegularFile file = shd::core::open_regular(scratch.path.c_str());
  if (file.file.fd < 0) throw Failure(kExitOutput, "\"" + scratch.path + "\": " + std::strerror(file.error));
  return file;
}

/// Copies a file to standard output.
void print_file(const shd::core::RegularFile& from) {
  std::vector<char> bytes(size_t{1} << 16);
  int error = 0;
  for (uint64_t at = 0, size = 1; size > 0; at += size) {
    size = shd::core::read_at(from.file.fd, at, bytes.size(), bytes.data(), &error);
    if (error) throw Failure(kExitOutput, std::string("-o: the scratch file: ") + std::strerror(error));
    if (std::fwrite(bytes.data(), 1, size, stdout) != size) refuse_stream();
  }
  flush_stream();
}

#ifdef SHD_RENDER_WITH_COLOR
void check_name(const char* option, const std::string& value, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), value) != names.end()) return;
  command::refuse(option, value, "one of " + command::join(names), names);
}
#endif

}  // namespace

void flush_stream() {
  if (std::fflush(stdout) != 0) refuse_stream();
}

std::optional<std::string> stream_type(const std::string& name) {
  if (name == "-") return "";
  const size_t size = name.size() < 3 ? 0 : name.size() - 2;
  const bool is_type = size > 0 && size <= 8 && name.compare(size, 2, ":-") == 0 &&
                       std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(size),
                                   [](unsigned char c) { return std::isalnum(c) != 0; });
  if (!is_type) return std::nullopt;
  return "." + name.substr(0, size);
}

void check_output(shd_context* context, const Options& options) {
  const std::string name = output_of(options);
  const bool has_planes = options.aovs || options.mattes;
  if (name.empty() && has_planes) {
    throw Failure(kExitUsage, "--hash: --aov, --aovs and --cryptomatte need -o FILE.exr");
  }
  if (name.empty()) return;
  refuse_if(is_stream(options) && options.hash, "--hash prints to standard output, which gets the picture of -o");
  refuse_if(is_stream(options) && ::isatty(STDOUT_FILENO), "-o: standard output is a terminal");
  refuse_if(find_numbers(name).size() > 1, "-o: \"" + name + "\" has several places for a number");
  const size_t folder = name.rfind('/') + 1;
  struct stat status;
  if (folder > 0 && ::stat(name.substr(0, folder).c_str(), &status) != 0) {
    throw Failure(kExitOutput, "-o: there is no folder \"" + name.substr(0, folder) + "\"");
  }
  const bool exr = ends_with(name, ".exr");
  const std::string shown = "\"" + (options.output.empty() ? name : options.output) + "\"";
  refuse_if(options.aovs && !exr, "--aov: " + shown + " does not end in .exr");
  refuse_if(options.mattes && !exr, "--cryptomatte: " + shown + " does not end in .exr");
  refuse_if(options.mattes && options.compression.rfind("dwa", 0) == 0,
            "--compression: dwaa and dwab change the ids of --cryptomatte");
  if (std::none_of(std::begin(kExtensions), std::end(kExtensions),
                   [&](const char* end) { return ends_with(name, end); })) {
    throw Failure(kExitUsage, "-o: " + shown + " does not end in .png, .jpg, .tif, .exr or .hdr");
  }
  if (!options.compression.empty()) check_compression(context, name, options.compression);
}

std::string picture_name(const Options& options, uint32_t picture, uint32_t pictures) {
  const std::string name = output_of(options);
  const std::vector<Place> places = find_numbers(name);
  char number[16];
  if (!places.empty()) {
    std::snprintf(number, sizeof number, "%0*u", places[0].width, picture + 1);
    return name.substr(0, places[0].at) + number + name.substr(places[0].at + places[0].size);
  }
  if (pictures == 1 || name.empty() || is_stream(options)) return name;
  std::snprintf(number, sizeof number, "-%04u", picture + 1);
  const size_t dot = name.rfind('.');
  return name.substr(0, dot) + number + name.substr(dot);
}

uint64_t picture_hash(const shd_framebuffer* framebuffer) {
  const Picture picture = read_picture(framebuffer);
  // Fowler, Noll and Vo, "The FNV Non-Cryptographic Hash Algorithm", FNV-1a; the lowest byte of a float first.
  uint64_t hash = 0xcbf29ce484222325;
  for (const float value : picture.rgba) {
    uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ (bits >> shift & 0xff)) * 0x100000001b3;
  }
  return hash;
}

Color open_color([[maybe_unused]] shd_context* context, [[maybe_unused]] const Options& options) {
  Color color;
#ifdef SHD_RENDER_WITH_COLOR
  const std::string name = output_of(options);
  if (!options.color || name.empty() || ends_with(name, ".exr") || ends_with(name, ".hdr")) return color;
  check(shd_color_create(context, nullptr, color.out()), "colour config");
  std::vector<std::string> displays, views;
  for (uint32_t i = 0; i < shd_color_get_display_count(color.get()); ++i) {
    displays.push_back(shd_color_get_display_name(color.get(), i));
  }
  check_name("--display", options.display, displays);
  const char* const display = options.display.c_str();
  for (uint32_t i = 0; i < shd_color_get_view_count(color.get(), display); ++i) {
    views.push_back(shd_color_get_view_name(color.get(), display, i));
  }
  check_name("--view", options.view, views);
#endif
  return color;
}

void save_picture([[maybe_unused]] const Color& color, const shd_framebuffer* framebuffer, const Options& options,
                  const std::string& name, const FileExtras& extras) {
  shd_save_desc desc = shd_save_desc_default();
  if (!ends_with(name, ".exr") && !ends_with(name, ".hdr")) desc.bit_depth = 8;
  if (options.dither) desc.dither = SHD_DITHER_ORDERED;
#ifdef SHD_RENDER_WITH_COLOR
  shd_color_view view = {color.get(), options.display.c_str(), options.view.c_str()};
  if (color.get()) desc.display = {shd_color_apply_view, &view};
#endif
  const std::string software = "shd-render " + std::to_string(SHD_VERSION_MAJOR) + "." +
                               std::to_string(SHD_VERSION_MINOR) + "." + std::to_string(SHD_VERSION_PATCH);
  std::vector<shd_file_attribute> attributes = extras.attributes;
  attributes.push_back({"Software", software.c_str()});
  desc.view = extras.view;
  desc.channels = extras.channels.data();
  desc.channel_count = extras.channels.size();
  desc.attributes = attributes.data();
  desc.attribute_count = attributes.size();
  if (!options.compression.empty()) desc.compression = options.compression.c_str();
  if (is_stream(options)) {
    print_file(save_unnamed(framebuffer, name, desc));
    return;
  }
  check(shd_framebuffer_save(framebuffer, name.c_str(), &desc), name, kExitOutput);
  shd_framebuffer_info info = shd_framebuffer_info_default();
  check(shd_framebuffer_get_info(framebuffer, &info), name);
  std::printf("%s: %u x %u\n", name.c_str(), info.width, info.height);
  flush_stream();
}
