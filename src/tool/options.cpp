// SPDX-License-Identifier: MIT
#include "tool/options.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "command/failure.h"

namespace {

constexpr const char* kSeeHelp = " (shd-render --help)";

/// Reads `count` numbers separated by commas and advances `text` behind them. Returns false if there are fewer.
bool read_numbers(const char*& text, float* out, int count) {
  for (int i = 0; i < count; ++i) {
    if (i > 0 && *text++ != ',') return false;
    char* end = nullptr;
    out[i] = std::strtof(text, &end);
    if (end == text || !std::isfinite(out[i])) return false;
    text = end;
  }
  return true;
}

float read_number(const std::string& option, const std::string& value, float low, float high, const char* wanted) {
  const char* text = value.c_str();
  float number = 0.0f;
  if (!read_numbers(text, &number, 1) || *text || number < low || number > high) refuse(option, value, wanted);
  return number;
}

template <class Value>
struct Name {
  const char* name;
  Value value;
};

template <class Value, size_t kCount>
Value pick(const std::string& option, const std::string& value, const Name<Value> (&names)[kCount]) {
  std::string wanted = "one of";
  for (const Name<Value>& name : names) {
    if (value == name.name) return name.value;
    wanted += std::string(" ") + name.name;
  }
  refuse(option, value, wanted.c_str());
}

constexpr Name<shd_filter> kFilters[] = {{"nearest", SHD_FILTER_NEAREST},
                                         {"bilinear", SHD_FILTER_BILINEAR},
                                         {"trilinear", SHD_FILTER_TRILINEAR},
                                         {"bicubic", SHD_FILTER_BICUBIC},
                                         {"nearest-mip", SHD_FILTER_NEAREST_MIP},
                                         {"bilinear-mip", SHD_FILTER_BILINEAR_MIP},
                                         {"ripmap", SHD_FILTER_RIPMAP},
                                         {"summed-area", SHD_FILTER_SUMMED_AREA},
                                         {"anisotropic", SHD_FILTER_ANISOTROPIC},
                                         {"ewa", SHD_FILTER_EWA},
                                         {"stochastic", SHD_FILTER_STOCHASTIC},
                                         {"exact", SHD_FILTER_EXACT},
                                         {"nearest-mip-linear", SHD_FILTER_NEAREST_MIP_LINEAR}};
constexpr Name<shd_solid> kSolids[] = {{"stripes", SHD_SOLID_STRIPES}, {"checker", SHD_SOLID_CHECKER},
                                       {"perlin", SHD_SOLID_PERLIN},   {"value", SHD_SOLID_VALUE},
                                       {"simplex", SHD_SOLID_SIMPLEX}, {"worley", SHD_SOLID_WORLEY},
                                       {"marble", SHD_SOLID_MARBLE},   {"wood", SHD_SOLID_WOOD}};
constexpr Name<shd_visibility> kVisibilities[] = {
    {"depth", SHD_VISIBILITY_DEPTH}, {"painter", SHD_VISIBILITY_PAINTER}, {"newell", SHD_VISIBILITY_NEWELL}};
constexpr Name<uint32_t> kAovs[] = {{"uv", SHD_AOV_UV},
                                    {"normal", SHD_AOV_NORMAL},
                                    {"triangle", SHD_AOV_TRIANGLE},
                                    {"position", SHD_AOV_POSITION},
                                    {"derivatives", SHD_AOV_DERIVATIVES},
                                    {"barycentrics", SHD_AOV_BARYCENTRICS},
                                    {"level", SHD_AOV_LEVEL},
                                    {"draw", SHD_AOV_DRAW},
                                    {"overdraw", SHD_AOV_OVERDRAW},
                                    {"all", 2 * SHD_AOV_OVERDRAW - 1}};
constexpr Name<shd_model> kModels[] = {{"lambert", SHD_MODEL_LAMBERT},
                                       {"phong", SHD_MODEL_PHONG},
                                       {"blinn-phong", SHD_MODEL_BLINN_PHONG},
                                       {"normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED},
                                       {"combined", SHD_MODEL_COMBINED},
                                       {"ggx", SHD_MODEL_METALLIC_ROUGHNESS},
                                       {"gooch", SHD_MODEL_GOOCH},
                                       {"toon", SHD_MODEL_TOON},
                                       {"unlit", SHD_MODEL_UNLIT},
                                       {"matcap", SHD_MODEL_MATCAP},
                                       {"glass", SHD_MODEL_GLASS}};
constexpr Name<shd_debug_view> kViews[] = {{"normal", SHD_DEBUG_VIEW_NORMAL},
                                           {"uv", SHD_DEBUG_VIEW_UV},
                                           {"level", SHD_DEBUG_VIEW_LEVEL},
                                           {"barycentrics", SHD_DEBUG_VIEW_BARYCENTRICS}};
constexpr Name<shd_frequency> kFrequencies[] = {
    {"flat", SHD_FREQUENCY_FLAT}, {"gouraud", SHD_FREQUENCY_GOURAUD}, {"phong", SHD_FREQUENCY_PHONG}};
constexpr Name<LightPreset> kPresets[] = {{"studio", LightPreset::kStudio},
                                          {"headlight", LightPreset::kHeadlight},
                                          {"course", LightPreset::kCourse},
                                          {"file", LightPreset::kFile},
                                          {"none", LightPreset::kNone}};
constexpr Name<shd_shape> kShapes[] = {{"teapot", SHD_SHAPE_TEAPOT},
                                       {"sphere", SHD_SHAPE_SPHERE},
                                       {"plane", SHD_SHAPE_PLANE},
                                       {"box", SHD_SHAPE_BOX},
                                       {"torus", SHD_SHAPE_TORUS}};
constexpr Name<KeepRoughness> kKeep[] = {
    {"none", KeepRoughness::kNone}, {"toksvig", KeepRoughness::kToksvig}, {"lean", KeepRoughness::kLean}};
constexpr Name<shd_shadow_filter> kShadows[] = {{"hard", SHD_SHADOW_FILTER_HARD},
                                                {"pcf", SHD_SHADOW_FILTER_PCF},
                                                {"variance", SHD_SHADOW_FILTER_VARIANCE},
                                                {"summed-area", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE},
                                                {"pcss", SHD_SHADOW_FILTER_PCSS}};
constexpr Name<shd_projection> kProjections[] = {{"lat-long", SHD_PROJECTION_LAT_LONG},
                                                 {"mirror-ball", SHD_PROJECTION_MIRROR_BALL},
                                                 {"angular", SHD_PROJECTION_ANGULAR},
                                                 {"cube", SHD_PROJECTION_CUBE},
                                                 {"octahedral", SHD_PROJECTION_OCTAHEDRAL}};
constexpr Name<shd_bump> kBumps[] = {
    {"none", SHD_BUMP_NONE}, {"gradient", SHD_BUMP_GRADIENT}, {"texel", SHD_BUMP_TEXEL}};
constexpr Name<shd_simd> kSimd[] = {{"best", SHD_SIMD_BEST},     {"baseline", SHD_SIMD_BASELINE},
                                    {"scalar", SHD_SIMD_SCALAR}, {"sse2", SHD_SIMD_SSE2},
                                    {"ssse3", SHD_SIMD_SSSE3},   {"sse4", SHD_SIMD_SSE4},
                                    {"avx2", SHD_SIMD_AVX2},     {"avx512", SHD_SIMD_AVX512},
                                    {"neon", SHD_SIMD_NEON},     {"wasm", SHD_SIMD_WASM}};

void read_size(const std::string& option, const std::string& value, Options& out) {
  char* end = nullptr;
  const unsigned long width = std::strtoul(value.c_str(), &end, 10);
  const unsigned long height = *end == 'x' ? std::strtoul(end + 1, &end, 10) : 0;
  if (*end || width < 1 || width > 16384 || height < 1 || height > 16384) {
    refuse(option, value, "WIDTHxHEIGHT, each 1..16384");
  }
  out.width = static_cast<uint32_t>(width);
  out.height = static_cast<uint32_t>(height);
}

void read_samples(const std::string& option, const std::string& value, Options& out) {
  const std::string counts[] = {"1", "2", "4", "8", "16"};
  for (uint32_t i = 0; i < 5; ++i) {
    if (value == counts[i]) return void(out.samples = 1u << i);
  }
  refuse(option, value, "1, 2, 4, 8 or 16");
}

/// Names between commas.
void read_aovs(const std::string& option, const std::string& value, Options& out) {
  for (size_t start = 0; start <= value.size();) {
    const size_t end = std::min(value.find(',', start), value.size());
    out.aovs |= pick(option, value.substr(start, end - start), kAovs);
    start = end + 1;
  }
}

uint32_t read_whole(const std::string& option, const std::string& value, float low, float high, const char* wanted) {
  const float number = read_number(option, value, low, high, wanted);
  if (number != std::floor(number)) refuse(option, value, wanted);
  return static_cast<uint32_t>(number);
}

void read_orbit(const std::string& option, const std::string& value, Options& out) {
  const char* wanted = "AZIMUTH,ELEVATION[,DISTANCE] in degrees (elevation -90..90) and radii (above 1)";
  const char* text = value.c_str();
  float angles[2];
  if (!read_numbers(text, angles, 2) || angles[1] < -90.0f || angles[1] > 90.0f) refuse(option, value, wanted);
  out.azimuth = angles[0];
  out.elevation = angles[1];
  if (*text == ',') {
    ++text;
    if (!read_numbers(text, &out.distance, 1) || !(out.distance > 1.0f) || out.distance > 1e4f) {
      refuse(option, value, wanted);
    }
  }
  if (*text) refuse(option, value, wanted);
}

void read_animation(const std::string& option, const std::string& value, Options& out) {
  if (value.empty()) refuse(option, value, "the number or the name of an animation of the file");
  out.animation = value;
}

LightOption read_light(const std::string& option, const std::string& value, shd_light_kind kind) {
  const char* wanted = "X,Y,Z or X,Y,Z:R,G,B (colour not negative; a direction is not 0,0,0)";
  const char* text = value.c_str();
  LightOption light;
  light.kind = kind;
  if (!read_numbers(text, light.place.data(), 3)) refuse(option, value, wanted);
  if (*text == ':') {
    ++text;
    if (!read_numbers(text, light.color.data(), 3)) refuse(option, value, wanted);
  }
  for (const float c : light.color) {
    if (c < 0.0f || c > 1e9f) refuse(option, value, wanted);
  }
  const bool directed = kind != SHD_LIGHT_KIND_POINT;
  if (*text || (directed && light.place == std::array<float, 3>{0, 0, 0})) refuse(option, value, wanted);
  return light;
}

/// Reads one number for all three channels, or three numbers.
std::array<float, 3> read_color(const std::string& option, const std::string& value) {
  const char* text = value.c_str();
  std::array<float, 3> color{};
  if (!read_numbers(text, color.data(), 1)) refuse(option, value, "R,G,B or one number");
  color[1] = color[2] = color[0];
  if (*text == ',' && (++text, !read_numbers(text, color.data() + 1, 2))) refuse(option, value, "R,G,B");
  for (const float c : color) {
    if (*text || c < 0.0f || c > 1e6f) refuse(option, value, "R,G,B, each 0..1e6");
  }
  return color;
}

/// Handles options without a value. Returns false if `name` is not one.
bool set_switch(const std::string& name, Options& out) {
  if (name == "--help" || name == "-h") return out.help = true;
  if (name == "--version") return out.version = true;
  if (name == "--sample-shading") return out.sample_shading = true;
  if (name == "--teapot") return out.model.clear(), true;
  if (name == "--any-folder") return out.any_folder = true;
  if (name == "--floor") return out.floor = true;
  if (name == "--no-color") return out.color = false, true;
  if (name == "--aov") return out.aovs |= SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE, true;
  if (name == "--dither") return out.dither = true;
  if (name == "--progress") return out.progress = true;
  if (name == "--stats") return out.stats = true;
  if (name == "--hash") return out.hash = true;
  return false;
}

void set_background(const std::string& name, const std::string& value, Options& out) {
  out.has_background = true;
  if (value == "none") {
    out.background = {0, 0, 0, 0};
    return;
  }
  const std::array<float, 3> color = read_color(name, value);
  out.background = {color[0], color[1], color[2], 1.0f};
}

/// Handles options of the picture and the machine. Returns false if `name` is not one.
bool set_output_value(const std::string& name, const std::string& value, Options& out) {
  if (name == "-o" || name == "--output") return out.output = value, true;
  if (name == "--size") return read_size(name, value, out), true;
  if (name == "--samples") return read_samples(name, value, out), true;
  if (name == "--supersampling") {
    return out.supersampling = read_whole(name, value, 1, 16, "a whole number 1..16"), true;
  }
  if (name == "--visibility") return out.visibility = pick(name, value, kVisibilities), true;
  if (name == "--aovs") return read_aovs(name, value, out), true;
  if (name == "--display") return out.display = value, true;
  if (name == "--view") return out.view = value, true;
  if (name == "--background") return set_background(name, value, out), true;
  if (name == "--simd") return out.simd = pick(name, value, kSimd), true;
  if (name == "--threads") {
    return out.threads = static_cast<uint32_t>(read_number(name, value, 0, 1024, "a number 0..1024")), true;
  }
  return false;
}

float read_scale(const std::string& option, const std::string& value) {
  return read_number(option, value, 0, 1e6f, "a number 0..1e6");
}

void read_cone(const std::string& option, const std::string& value, Options& out) {
  const char* text = value.c_str();
  float angles[2];
  if (!read_numbers(text, angles, 2) || *text || angles[0] < 0 || angles[0] > angles[1] || angles[1] < 1 ||
      angles[1] > 85) {
    refuse(option, value, "INNER,OUTER: half angles in degrees, 0..85, the outer one not smaller and at least 1");
  }
  out.inner_cone = angles[0];
  out.cone = angles[1];
}

/// Handles options of the eye and the lights. Returns false if `name` is not one.
bool set_light_value(const std::string& name, const std::string& value, Options& out) {
  if (name == "--orbit") return read_orbit(name, value, out), true;
  if (name == "--camera") return out.camera = read_whole(name, value, 0, 65535, "a whole number 0..65535"), true;
  if (name == "--turntable") {
    return out.turntable = read_whole(name, value, 1, 9999, "a whole number 1..9999"), true;
  }
  if (name == "--animation") return read_animation(name, value, out), true;
  if (name == "--time") {
    return out.time = static_cast<double>(read_number(name, value, -1e9f, 1e9f, "a number of seconds")), true;
  }
  if (name == "--frames") return out.frames = read_whole(name, value, 1, 9999, "a whole number 1..9999"), true;
  if (name == "--fov") return out.fov = read_number(name, value, 1, 170, "an angle 1..170 degrees"), true;
  if (name == "--light") return out.lights.push_back(read_light(name, value, SHD_LIGHT_KIND_POINT)), true;
  if (name == "--sun") return out.lights.push_back(read_light(name, value, SHD_LIGHT_KIND_DIRECTIONAL)), true;
  if (name == "--spot") return out.lights.push_back(read_light(name, value, SHD_LIGHT_KIND_SPOT)), true;
  if (name == "--cone") return read_cone(name, value, out), true;
  if (name == "--cookie") return out.cookie = value, true;
  if (name == "--lamps") {
    return out.lamps = static_cast<uint32_t>(read_number(name, value, 0, 65536, "a number 0..65536")), true;
  }
  if (name == "--shadows") return out.shadows = pick(name, value, kShadows), true;
  if (name == "--softness") return out.softness = read_number(name, value, 0, 10, "a number 0..10"), true;
  if (name == "--shadow-size") {
    return out.shadow_size = static_cast<uint32_t>(read_number(name, value, 16, 8192, "a number 16..8192")), true;
  }
  if (name == "--occlusion") return out.occlusion = read_whole(name, value, 1, 65536, "a whole number 1..65536"), true;
  if (name == "--occlusion-radius") {
    return out.occlusion_radius = read_number(name, value, 1e-6f, 1e6f, "a number 1e-6..1e6"), true;
  }
  if (name == "--lights") return out.preset = pick(name, value, kPresets), true;
  if (name == "--environment") return out.environment = value, true;
  if (name == "--environment-projection") return out.environment_projection = pick(name, value, kProjections), true;
  if (name == "--environment-turn") {
    return out.environment_turn = read_number(name, value, -360, 360, "an angle -360..360 degrees"), true;
  }
  if (name == "--environment-blur") {
    return out.environment_blur = read_number(name, value, 0, 1, "a number 0..1"), true;
  }
  if (name == "--ambient") return out.ambient = read_color(name, value), true;
  if (name == "--exposure") {
    return out.exposure = std::exp2(read_number(name, value, -20, 20, "a number -20..20")), true;
  }
  return false;
}

/// Handles options of the surface. Returns false if `name` is not one.
bool set_surface_value(const std::string& name, const std::string& value, Options& out) {
  if (name == "--model") return out.reflectance = pick(name, value, kModels), true;
  if (name == "--show") return out.debug_view = pick(name, value, kViews), true;
  if (name == "--frequency") return out.frequency = pick(name, value, kFrequencies), true;
  if (name == "--diffuse") return out.diffuse = read_color(name, value), true;
  if (name == "--exponent") return out.exponent = read_scale(name, value), true;
  if (name == "--specular") return out.specular = read_scale(name, value), true;
  if (name == "--metallic") return out.metallic = read_number(name, value, 0, 1, "a number 0..1"), true;
  if (name == "--roughness") return out.roughness = read_number(name, value, 0, 1, "a number 0..1"), true;
  if (name == "--filter") return out.filter = pick(name, value, kFilters), out.has_filter = true;
  if (name == "--lod-bias") return out.lod_bias = read_number(name, value, -15, 15, "a number -15..15"), true;
  if (name == "--texture") return out.texture = value, true;
  if (name == "--solid") return out.solid = pick(name, value, kSolids), true;
  if (name == "--solid-size") return out.solid_size = read_scale(name, value), true;
  if (name == "--uv-scale") return out.uv_scale = read_scale(name, value), true;
  if (name == "--normal-map") return out.normal_map = value, true;
  if (name == "--keep-roughness") return out.keep = pick(name, value, kKeep), true;
  return false;
}

/// Handles options of the shape and of bumps. Returns false if `name` is not one.
bool set_shape_value(const std::string& name, const std::string& value, Options& out) {
  if (name == "--shape") return out.model.clear(), out.shape = pick(name, value, kShapes), true;
  if (name == "--height") return out.height_map = value, true;
  if (name == "--bump") return out.bump_form = pick(name, value, kBumps), true;
  if (name == "--bump-scale") {
    return out.bump_scale = read_number(name, value, -1e6f, 1e6f, "a number -1e6..1e6"), true;
  }
  if (name == "--parallax") return out.parallax = read_scale(name, value), true;
  if (name == "--displace") {
    return out.displacement = read_number(name, value, -1e6f, 1e6f, "a number -1e6..1e6"), true;
  }
  if (name == "--edge-length") return out.edge_length = read_number(name, value, 0.5f, 1e4f, "pixels 0.5..1e4"), true;
  if (name == "--lines") return out.line_width = read_number(name, value, 0, 64, "a width 0..64 in pixels"), true;
  if (name == "--wireframe") {
    return out.wire_width = read_number(name, value, 0.0625f, 64, "a width 1/16..64 in pixels"), true;
  }
  if (name == "--crease") return out.crease = read_number(name, value, 0, 180, "an angle 0..180 degrees"), true;
  if (name == "--tessellation") {
    return out.tessellation = static_cast<int>(read_number(name, value, 1, 256, "a number 1..256")), true;
  }
  return false;
}

bool set_value(const std::string& name, const std::string& value, Options& out) {
  return set_output_value(name, value, out) || set_light_value(name, value, out) ||
         set_surface_value(name, value, out) || set_shape_value(name, value, out) ||
         set_volume_value(name, value, out.volume);
}

/// The error for an option at the end of the line: its value is missing, or the option is unknown.
std::string missing_value(const std::string& name) {
  Options scratch;
  bool known = true;
  try {
    known = set_value(name, "", scratch);
  } catch (const Failure&) {
  }
  return (known ? " needs a value" : " is not an option") + std::string(kSeeHelp);
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  bool named = false, only_files = false;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (!only_files && name == "--") {
      only_files = true;
    } else if (only_files || name.empty() || name[0] != '-') {
      if (named) throw Failure(kExitUsage, "one model at a time: \"" + options.model + "\" and \"" + name + "\"");
      if (name.empty()) throw Failure(kExitUsage, "the name of the model is empty");
      options.model = name;
      named = true;
    } else if (!set_switch(name, options)) {
      if (i + 1 == argc) throw Failure(kExitUsage, name + missing_value(name));
      if (!set_value(name, argv[i + 1], options)) throw Failure(kExitUsage, name + " is not an option" + kSeeHelp);
      ++i;
    }
  }
  if (named && !options.volume.file.empty()) throw Failure(kExitUsage, "--volume is drawn instead of a model");
  if (options.camera && options.turntable) throw Failure(kExitUsage, "--turntable turns no --camera of the file");
  if (options.animation.empty() && options.time) throw Failure(kExitUsage, "--time needs an --animation");
  if (options.animation.empty() && options.frames) throw Failure(kExitUsage, "--frames needs an --animation");
  if (options.time && options.frames) throw Failure(kExitUsage, "--frames has all times: --time is one");
  if (options.turntable && options.frames) throw Failure(kExitUsage, "--turntable and --frames: one of them");
  const bool lit = !options.lights.empty() || options.lamps > 0 || !options.environment.empty();
  if (!options.preset) options.preset = lit ? LightPreset::kNone : LightPreset::kStudio;
  if (!options.ambient) options.ambient.emplace().fill(options.environment.empty() ? 0.15f : 0.0f);
  return options;
}
