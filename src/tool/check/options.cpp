// SPDX-License-Identifier: MIT
#include "tool/check/options.h"

#include <charconv>
#include <cstring>
#include <functional>

#include "command/failure.h"
#include "tool/check/table.h"

const char* const kHelp =
    R"(Usage: shd-check [options] TEXTURE LOOKUPS
Judges the texture lookups of any implementation: which results are outside of what a graphics API allows.

TEXTURE is a .npy array [height][width][channels], or [layers][height][width][channels], of uint8, uint16, float16 or
float32, or an image file that libshd_io reads. LOOKUPS is one of
  CSV           the first line names the columns
  .npy          a structured array, or [rows][columns] with --columns
  SHDLOOK1      this word, uint32 columns, uint64 rows, names of 16 bytes, columns of float32; little-endian
Columns: u v w dudx dvdx dwdx dudy dvdy dwdy lod reference layer, and the results r g b a.

  --results FILE       results as a .npy array or an image of floats, row by row, in place of the columns r g b a
  --columns LIST       names of the columns of a .npy array [rows][columns]
  --rules NAME         vulkan (default), d3d11, webgpu or opengl
  --subtexel-bits N    --level-bits N    --weight-bits N    --result-bits N
  --coordinate-error X --derivative-error X --level-error X --relative-error X --srgb-error X
  --filter NAME        nearest, bilinear, nearest-mip, nearest-mip-linear, bilinear-mip, trilinear (default) or
                       anisotropic
  --compare NAME       compare reference NAME texel: less, less-equal, equal, greater-equal, greater, not-equal, always
                       or never
  --wrap U[,V]         repeat (default), clamp, mirror, border or mirror-once
  --border R,G,B,A     --bias X  --lod-min X  --lod-max X  --max-anisotropy X
  --srgb               8-bit texels are sRGB
  --cube               the six layers are the faces +X -X +Y -Y +Z -Z
  --level FILE         mip level 1, then 2 and so on, in place of averages
  --no-mipmap          level 0 alone
  --list N             most illegal lookups to describe, default 20

Exit codes: 0 all results are legal, 1 some are not, 2 bad command line, 3 bad file.
)";

namespace {

struct Name {
  const char* name;
  int value;
};
constexpr Name kRules[] = {{"vulkan", SHD_RULES_VULKAN},
                           {"d3d11", SHD_RULES_D3D11},
                           {"webgpu", SHD_RULES_WEBGPU},
                           {"opengl", SHD_RULES_OPENGL}};
constexpr Name kFilters[] = {{"nearest", SHD_FILTER_NEAREST},
                             {"bilinear", SHD_FILTER_BILINEAR},
                             {"nearest-mip", SHD_FILTER_NEAREST_MIP},
                             {"bilinear-mip", SHD_FILTER_BILINEAR_MIP},
                             {"trilinear", SHD_FILTER_TRILINEAR},
                             {"anisotropic", SHD_FILTER_ANISOTROPIC},
                             {"nearest-mip-linear", SHD_FILTER_NEAREST_MIP_LINEAR}};
constexpr Name kComparisons[] = {{"less", SHD_COMPARE_LESS},       {"less-equal", SHD_COMPARE_LESS_EQUAL},
                                 {"equal", SHD_COMPARE_EQUAL},     {"greater-equal", SHD_COMPARE_GREATER_EQUAL},
                                 {"greater", SHD_COMPARE_GREATER}, {"not-equal", SHD_COMPARE_NOT_EQUAL},
                                 {"always", SHD_COMPARE_ALWAYS},   {"never", SHD_COMPARE_NEVER}};
constexpr Name kWraps[] = {{"repeat", SHD_WRAP_REPEAT},
                           {"clamp", SHD_WRAP_CLAMP},
                           {"mirror", SHD_WRAP_MIRROR},
                           {"border", SHD_WRAP_BORDER},
                           {"mirror-once", SHD_WRAP_MIRROR_ONCE}};

template <size_t kCount>
int value_of(const std::string& option, const std::string& text, const Name (&names)[kCount]) {
  std::string known;
  for (const Name& name : names) {
    if (text == name.name) return name.value;
    known += std::string(" ") + name.name;
  }
  throw Failure(kExitUsage, option + ": \"" + text + "\" is not one of" + known);
}

template <class T>
T number_of(const std::string& option, const std::string& text) {
  T value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw Failure(kExitUsage, option + ": \"" + text + "\" is not a number of this option");
  }
  return value;
}

void set_wrap(const std::string& option, const std::string& text, shd_sampler_desc* sampler) {
  const std::vector<std::string> parts = split(text);
  if (parts.size() > 2) throw Failure(kExitUsage, option + ": more than two wraps");
  sampler->wrap_u = static_cast<shd_wrap>(value_of(option, parts.front(), kWraps));
  sampler->wrap_v = static_cast<shd_wrap>(value_of(option, parts.back(), kWraps));
}

void set_border(const std::string& option, const std::string& text, shd_sampler_desc* sampler) {
  const std::vector<std::string> parts = split(text);
  if (parts.size() != 4) throw Failure(kExitUsage, option + ": not four numbers");
  for (size_t c = 0; c < 4; ++c) sampler->border[c] = number_of<float>(option, parts[c]);
}

/// A number of the command line, and its place.
template <class Desc, class T>
struct Field {
  const char* option;
  T Desc::*field;
};
constexpr Field<shd_bounds_desc, uint32_t> kBits[] = {{"--subtexel-bits", &shd_bounds_desc::subtexel_bits},
                                                      {"--level-bits", &shd_bounds_desc::level_bits},
                                                      {"--weight-bits", &shd_bounds_desc::weight_bits},
                                                      {"--result-bits", &shd_bounds_desc::result_bits}};
constexpr Field<shd_bounds_desc, float> kErrors[] = {{"--coordinate-error", &shd_bounds_desc::coordinate_error},
                                                     {"--derivative-error", &shd_bounds_desc::derivative_error},
                                                     {"--level-error", &shd_bounds_desc::level_error},
                                                     {"--relative-error", &shd_bounds_desc::relative_error},
                                                     {"--srgb-error", &shd_bounds_desc::srgb_error}};
constexpr Field<shd_sampler_desc, float> kSampler[] = {{"--bias", &shd_sampler_desc::lod_bias},
                                                       {"--lod-min", &shd_sampler_desc::lod_min},
                                                       {"--lod-max", &shd_sampler_desc::lod_max},
                                                       {"--max-anisotropy", &shd_sampler_desc::max_anisotropy}};

template <class Desc, class T, size_t kCount>
bool set_field(const std::string& option, const std::string& text, const Field<Desc, T> (&fields)[kCount], Desc* desc) {
  for (const auto& field : fields) {
    if (option != field.option) continue;
    desc->*field.field = number_of<T>(option, text);
    return true;
  }
  return false;
}

bool set_flag(const std::string& option, Options* out) {
  if (option == "--help") return out->help = true;
  if (option == "--srgb") return out->srgb = true;
  if (option == "--cube") return out->cube = true;
  if (option == "--no-mipmap") return !(out->mipmap = false);
  return false;
}

void set_option(const std::string& option, const std::string& text, Options* out) {
  if (set_field(option, text, kBits, &out->bounds) || set_field(option, text, kErrors, &out->bounds) ||
      set_field(option, text, kSampler, &out->sampler)) {
    return;
  }
  if (option == "--rules") return;  // read before the numbers that change it
  if (option == "--filter") {
    out->sampler.filter = static_cast<shd_filter>(value_of(option, text, kFilters));
  } else if (option == "--compare") {
    out->sampler.compares = 1;
    out->sampler.compare = static_cast<shd_compare>(value_of(option, text, kComparisons));
  } else if (option == "--wrap") {
    set_wrap(option, text, &out->sampler);
  } else if (option == "--border") {
    set_border(option, text, &out->sampler);
  } else if (option == "--results") {
    out->results = text;
  } else if (option == "--columns") {
    out->columns = split(text);
  } else if (option == "--level") {
    out->levels.push_back(text);
  } else if (option == "--list") {
    out->list = number_of<size_t>(option, text);
  } else {
    throw Failure(kExitUsage, option + ": not an option; see --help");
  }
}

void read_rules(int argc, char** argv, Options* out) {
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--rules") == 0) {
      out->rules = static_cast<shd_rules>(value_of("--rules", argv[i + 1], kRules));
    }
  }
  check(shd_bounds_preset(out->rules, &out->bounds), "--rules");
}

}  // namespace

Options read_options(int argc, char** argv) {
  Options out;
  read_rules(argc, argv, &out);
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option.compare(0, 2, "--") != 0) {
      files.push_back(option);
    } else if (!set_flag(option, &out)) {
      if (i + 1 == argc) throw Failure(kExitUsage, option + ": no value follows");
      set_option(option, argv[++i], &out);
    }
  }
  if (out.help) return out;
  if (files.size() != 2) throw Failure(kExitUsage, "two files are needed, TEXTURE and LOOKUPS; see --help");
  out.texture = files[0];
  out.lookups = files[1];
  return out;
}
