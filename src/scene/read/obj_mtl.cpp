// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "scene/read/obj.h"
#include "scene/read/text_lines.h"
#include "scene/text.h"

namespace shd::scene {
namespace {

using Color = std::array<float, 3>;

/// A map statement: a file with options.
struct MtlMap {
  std::string file;  // "" = none
  double scale[3] = {1, 1, 1}, offset[3] = {0, 0, 0};
  double bump = 1;
  bool clamp = false;
  bool names_channel = false;  // by -imfchan
  uint32_t channel = 0;
};

/// The statements of one material.
struct Mtl {
  std::string folder;  // folder of its library
  std::optional<Color> diffuse, specular, ambient, emission;
  std::optional<float> exponent, opacity, transparency, ior, roughness, metallic, clearcoat, clearcoat_roughness;
  int illum = 2;
  std::map<std::string, MtlMap> maps;  // by the statement in small letters
};

struct Mtls {
  const Source& source;
  Model& model;
  Warnings& warnings;
  std::map<std::string, Mtl> materials;
  std::map<std::pair<std::string, bool>, int32_t> texture_of;  // by the path, and whether it is data
};

/// r [g b] as a colour of 0..1e6; further numbers of 0 are of `g` and `b`. False for spectra and XYZ.
bool parse_color(std::string_view values, std::optional<Color>& out) {
  double c[3] = {};
  if (!take_number(&values, &c[0])) return false;
  c[1] = c[2] = c[0];
  if (take_number(&values, &c[1]) && !take_number(&values, &c[2])) return false;
  if (!values.empty()) return false;
  out.emplace();
  for (size_t i = 0; i < 3; ++i) (*out)[i] = c[i] >= 0 && c[i] <= 1e6 ? static_cast<float>(c[i]) : 0.0f;
  return true;
}

bool parse_number(std::string_view values, double low, double high, std::optional<float>& out) {
  double number = 0;
  if (!take_number(&values, &number) || std::isnan(number)) return false;
  out = static_cast<float>(std::clamp(number, low, high));
  return true;
}

/// Takes one to three numbers, but never the last word, which is the name of the file.
bool take_numbers(std::string_view* rest, double* out, size_t most) {
  size_t count = 0;
  for (; count < most; ++count) {
    std::string_view after = *rest;
    if (!take_number(&after, &out[count]) || after.empty()) break;
    if (!std::isfinite(out[count])) return false;
    *rest = after;
  }
  return count > 0;
}

std::optional<uint32_t> channel_of(std::string_view name) {
  if (name == "r" || name == "l") return 0;  // libshd reads the luminance of grey images from red
  if (name == "g") return 1;
  if (name == "b") return 2;
  if (name == "m") return 3;
  return std::nullopt;
}

/// Reads the option whose name was taken off. Returns false if the picture does not follow it.
bool parse_option(std::string_view option, std::string_view* rest, MtlMap& map) {
  double ignored[3];
  if (option == "-s") return take_numbers(rest, map.scale, 3);
  if (option == "-o") return take_numbers(rest, map.offset, 3);
  if (option == "-bm") return take_numbers(rest, &map.bump, 1);
  if (option == "-t") {
    take_numbers(rest, ignored, 3);
    return ignored[0] == 0;
  }
  if (option == "-mm") return take_numbers(rest, ignored, 2) && ignored[0] == 0 && ignored[1] == 1;
  if (option == "-boost" || option == "-texres") {
    take_numbers(rest, ignored, 1);
    return false;
  }
  const std::string value = lower_case(take_word(rest));
  if (option == "-clamp") map.clamp = value == "on";
  if (option == "-imfchan") {
    const std::optional<uint32_t> channel = channel_of(value);
    map.channel = channel.value_or(0);
    map.names_channel = true;
    return channel.has_value();
  }
  return option == "-clamp" || ((option == "-blendu" || option == "-blendv") && value == "on") ||
         (option == "-cc" && value == "off");
}

void parse_map(Mtls& mtls, const std::string& statement, std::string_view rest, Mtl& material) {
  MtlMap map;
  while (!rest.empty() && rest.front() == '-') {
    std::string_view after = rest;
    const std::string option = lower_case(take_word(&after));
    constexpr std::string_view kOptions[] = {"-s",      "-o",      "-t",     "-bm",        "-mm",
                                             "-boost",  "-texres", "-clamp", "-imfchan",   "-blendu",
                                             "-blendv", "-cc",     "-type",  "-colorspace"};
    if (after.empty() || std::find(std::begin(kOptions), std::end(kOptions), option) == std::end(kOptions)) break;
    rest = after;
    if (!parse_option(option, &rest, map)) {
      mtls.warnings.add("MTL: option " + option + " of " + statement + " is left out");
    }
  }
  if (rest.size() > 2 && rest.front() == '"' && rest.back() == '"') rest = rest.substr(1, rest.size() - 2);
  map.file = std::string(rest);
  if (map.file.empty()) {
    mtls.warnings.add("MTL: " + statement + " has no file");
    return;
  }
  if (material.maps.count(statement)) mtls.warnings.add("MTL: " + statement + " is given twice; the last one counts");
  material.maps[statement] = std::move(map);
}

/// The maps that are drawn; other statements of files are named in warnings.
bool is_drawn_map(const std::string& word) {
  constexpr std::string_view kMaps[] = {"map_kd", "map_ks", "map_ke",   "map_ns", "map_d",  "map_bump", "bump",
                                        "norm",   "map_kn", "map_norm", "map_pr", "map_pm", "map_ka"};
  return std::find(std::begin(kMaps), std::end(kMaps), word) != std::end(kMaps);
}

/// d [-halo] factor
bool parse_dissolve(Mtls& mtls, std::string_view values, Mtl& material) {
  std::string_view after = values;
  if (take_word(&after) == "-halo") {
    mtls.warnings.add("MTL: option -halo of d is left out");
    values = after;
  }
  return parse_number(values, 0, 1, material.opacity);
}

/// Statements with numbers of which the picture shows only `neutral`.
bool parse_ignored(Mtls& mtls, const std::string& word, std::string_view values, double neutral) {
  double number = 0;
  bool shown = false;
  while (take_number(&values, &number)) shown = shown || number != neutral;
  if (shown) mtls.warnings.add("MTL: " + text_of(word) + " is left out");
  return true;
}

/// Reads a statement of a material. False if it is not understood.
bool parse_statement(Mtls& mtls, const std::string& word, std::string_view values, Mtl& material) {
  std::optional<float> number;
  if (word == "kd") return parse_color(values, material.diffuse);
  if (word == "ks") return parse_color(values, material.specular);
  if (word == "ka") return parse_color(values, material.ambient);
  if (word == "ke") return parse_color(values, material.emission);
  if (word == "ns") return parse_number(values, 0, 1e6, material.exponent);
  if (word == "ni") return parse_number(values, 0, 1e3, material.ior);
  if (word == "d") return parse_dissolve(mtls, values, material);
  if (word == "tr") return parse_number(values, 0, 1, material.transparency);
  if (word == "pr") return parse_number(values, 0, 1, material.roughness);
  if (word == "pm") return parse_number(values, 0, 1, material.metallic);
  if (word == "pc") return parse_number(values, 0, 1, material.clearcoat);
  if (word == "pcr") return parse_number(values, 0, 1, material.clearcoat_roughness);
  if (word == "tf") return parse_ignored(mtls, "Tf (transmission filter)", values, 1);
  if (word == "ps") return parse_ignored(mtls, "Ps (sheen)", values, 0);
  if (word == "aniso") return parse_ignored(mtls, "aniso (anisotropy)", values, 0);
  if (word == "anisor") return parse_ignored(mtls, "anisor (rotation of anisotropy)", values, 0);
  if (word == "illum") {
    if (!parse_number(values, -1, 100, number) || *number < 0) return false;
    material.illum = static_cast<int>(*number);
    return true;
  }
  if (is_drawn_map(word)) {
    parse_map(mtls, word, values, material);
  } else {
    mtls.warnings.add("MTL: " + text_of(word) + " is left out");
  }
  return true;
}

void parse_library(Mtls& mtls, const std::string& name, const Bytes& bytes) {
  const std::string text = utf8_of(bytes);
  std::string folder = name;
  std::replace(folder.begin(), folder.end(), '\\', '/');
  const size_t slash = folder.find_last_of('/');
  folder.resize(slash == std::string::npos ? 0 : slash + 1);
  TextLines lines(text);
  std::string_view statement;
  Mtl* material = nullptr;
  for (uint64_t i = 0; lines.next(&statement); ++i) {
    if (i % 4096 == 0) mtls.source.deadline.check();
    const std::string word = lower_case(take_word(&statement));
    if (word == "newmtl") {
      statement = without_comment(statement);
      const auto [at, is_new] = mtls.materials.insert_or_assign(std::string(statement), Mtl());
      if (!is_new)
        mtls.warnings.add("MTL: material \"" + text_of(at->first) + "\" is defined twice; the last one counts");
      material = &at->second;
      material->folder = folder;
    } else if (!material) {
      mtls.warnings.add("MTL: statements before newmtl are left out");
    } else if (!parse_statement(mtls, word, without_comment(statement), *material)) {
      mtls.warnings.add("MTL: the values of " + word + " are not understood");
    }
  }
}

/// The file names of a mtllib statement: one name, with blanks in it, or several ones. Names with blanks end with .mtl.
std::vector<std::string> names_of(const Source& source, const std::string& rest) {
  if (rest.find_first_of(" \t") == std::string::npos || source.files.find(rest)) return {rest};
  const bool has_suffix = lower_case(rest).find(".mtl") != std::string::npos;
  std::vector<std::string> names;
  std::string name;
  for (std::string_view left = without_comment(rest); !left.empty();) {
    const std::string_view word = take_word(&left);
    name.append(name.empty() ? "" : " ").append(word);
    const bool ends = !has_suffix || (word.size() >= 4 && lower_case(word.substr(word.size() - 4)) == ".mtl");
    if (!ends && !left.empty()) continue;
    names.push_back(std::move(name));
    name.clear();
  }
  return names;
}

/// Returns whether all libraries were found.
bool parse_libraries(Mtls& mtls, const std::vector<std::string>& libraries) {
  std::set<std::string> seen;
  bool all = true;
  for (const std::string& rest : libraries) {
    if (!seen.insert(rest).second) continue;
    for (const std::string& name : names_of(mtls.source, rest)) {
      if (name != rest && !seen.insert(name).second) continue;
      mtls.source.deadline.check();
      if (const Bytes* bytes = mtls.source.files.find(name)) {
        parse_library(mtls, name, *bytes);
      } else {
        mtls.warnings.add("cannot open \"" + text_of(name) + "\" of mtllib; its materials are plain");
        all = false;
      }
    }
  }
  return all;
}

int32_t texture_of(Mtls& mtls, const std::string& folder, const std::string& name, bool data) {
  const auto next = static_cast<int32_t>(mtls.model.textures.size());
  const auto [at, is_new] = mtls.texture_of.try_emplace({folder + name, data}, next);
  if (!is_new) return at->second;
  TextureSource texture;
  texture.name = name;
  texture.folder = folder;
  texture.data = data;
  mtls.model.textures.push_back(std::move(texture));
  return next;
}

/// Sets the map of a slot from the first of the statements that the material has. Returns it, or null.
const MtlMap* set_map(Mtls& mtls, const Mtl& material, std::initializer_list<const char*> statements,
                      shd_slot_target target, Surface& surface) {
  for (const char* const statement : statements) {
    const auto at = material.maps.find(statement);
    if (at == material.maps.end()) continue;
    const MtlMap& from = at->second;
    Map& map = surface.maps[target];
    const bool is_color = target == SHD_SLOT_DIFFUSE || target == SHD_SLOT_SPECULAR || target == SHD_SLOT_EMISSION;
    map.texture = texture_of(mtls, material.folder, from.file, !is_color);
    map.channel = is_color ? 0 : from.channel;
    if (is_color && from.names_channel) {
      mtls.warnings.add("MTL: option -imfchan of " + std::string(statement) + " is left out");
    }
    map.wrap_u = map.wrap_v = from.clamp ? SHD_WRAP_CLAMP : SHD_WRAP_REPEAT;
    // u' = s u + o in coordinates whose v grows upwards
    map.uv_transform = {static_cast<float>(from.scale[0]),  0,
                        static_cast<float>(from.offset[0]), 0,
                        static_cast<float>(from.scale[1]),  static_cast<float>(1 - from.scale[1] - from.offset[1])};
    for (float& c : map.uv_transform) c = std::isfinite(c) ? c : 0.0f;
    return &from;
  }
  return nullptr;
}

/// 0: Kd without light; 1: no highlight; 3 and more: with reflections and refraction of other things.
void set_illum(Mtls& mtls, const Mtl& material, Surface& surface) {
  surface.unlit = material.illum == 0;
  if (material.illum == 1) surface.specular = {0, 0, 0};
  if (material.illum > 2) {
    mtls.warnings.add("MTL: illum " + std::to_string(material.illum) + ": reflections and refractions are left out");
  }
}

/// Ks, Ns and their maps.
void set_classic(Mtls& mtls, const Mtl& material, Surface& surface) {
  const bool has_ns = material.exponent.has_value();
  if (material.specular || has_ns) surface.specular = material.specular.value_or(Color{0, 0, 0});
  if (has_ns) surface.exponent = std::max(*material.exponent, 1.0f);
  // Exporters write `Ns 0` beside a white Ks for surfaces without a highlight. As an exponent it would make them white.
  if (has_ns && *material.exponent == 0) surface.specular = {0, 0, 0};
  if (material.clearcoat.value_or(0.0f) > 0) mtls.warnings.add("MTL: Pc without Pr or Pm is left out");
  set_map(mtls, material, {"map_ks"}, SHD_SLOT_SPECULAR, surface);
  set_map(mtls, material, {"map_ns"}, SHD_SLOT_EXPONENT, surface);
}

/// The PBR statements: Pr, Pm and their maps. Ks and Ns beside them are for programs without these.
void set_metallic_roughness(Mtls& mtls, const Mtl& material, Surface& surface) {
  surface.metallic_roughness = true;
  const bool has_roughness = set_map(mtls, material, {"map_pr"}, SHD_SLOT_ROUGHNESS, surface) != nullptr;
  const bool has_metallic = set_map(mtls, material, {"map_pm"}, SHD_SLOT_METALLIC, surface) != nullptr;
  surface.roughness = material.roughness.value_or(has_roughness ? 1.0f : 0.5f);
  surface.metallic = material.metallic.value_or(has_metallic ? 1.0f : 0.0f);
  if (has_roughness && surface.roughness == 0) surface.roughness = 1;
  if (has_metallic && surface.metallic == 0) surface.metallic = 1;
  for (const char* const word : {"map_ks", "map_ns"}) {
    if (material.maps.count(word)) mtls.warnings.add("MTL: " + std::string(word) + " beside Pr or Pm is left out");
  }
}

/// Whether a map_d is the fourth channel of a map_Kd, which counts already.
bool is_alpha_of(const MtlMap& map, const MtlMap& color) {
  const bool same_place = std::equal(map.scale, map.scale + 3, color.scale) &&
                          std::equal(map.offset, map.offset + 3, color.offset) && map.clamp == color.clamp;
  return map.file == color.file && same_place && (!map.names_channel || map.channel == 3);
}

void set_opacity(Mtls& mtls, const Mtl& material, Surface& surface) {
  const auto map = material.maps.find("map_d"), color = material.maps.find("map_kd");
  if (material.opacity) {
    surface.opacity = *material.opacity;
  } else if (material.transparency) {
    surface.opacity = 1 - *material.transparency;
  }
  if (surface.opacity == 0) surface.opacity = 1;  // files in which opacity 0 means opaque are common
  const bool is_alpha =
      map != material.maps.end() && color != material.maps.end() && is_alpha_of(map->second, color->second);
  if (map != material.maps.end() && !is_alpha) set_map(mtls, material, {"map_d"}, SHD_SLOT_OPACITY, surface);
  if (surface.opacity < 1 || map != material.maps.end()) surface.alpha = Alpha::kBlend;
}

/// Ambient light takes the diffuse colour. A grey Ka only weighs it.
void warn_of_ambient(Mtls& mtls, const Mtl& material, const Surface& surface) {
  const auto map = material.maps.find("map_ka"), color = material.maps.find("map_kd");
  const bool other =
      map != material.maps.end() && (color == material.maps.end() || map->second.file != color->second.file);
  if (other) mtls.warnings.add("MTL: map_ka is left out; ambient light takes the diffuse colour");
  if (!material.ambient || *material.ambient == surface.diffuse) return;
  const Color& a = *material.ambient;
  if (a[0] != a[1] || a[1] != a[2]) mtls.warnings.add("MTL: Ka is left out; ambient light takes the diffuse colour");
}

Surface surface_of(Mtls& mtls, const std::string& name, const Mtl& material) {
  Surface surface;
  surface.name = text_of(name);
  const bool has_color = set_map(mtls, material, {"map_kd"}, SHD_SLOT_DIFFUSE, surface) != nullptr;
  const Color black = {0, 0, 0}, white = {1, 1, 1}, grey = {0.6f, 0.6f, 0.6f};
  surface.diffuse = material.diffuse.value_or(has_color ? white : grey);
  if (has_color && surface.diffuse == black) surface.diffuse = white;
  const bool has_glow = set_map(mtls, material, {"map_ke"}, SHD_SLOT_EMISSION, surface) != nullptr;
  surface.emission = material.emission.value_or(black);
  if (has_glow && surface.emission == black) surface.emission = white;
  if (material.ior && *material.ior > 1) surface.ior = *material.ior;  // 1 is what programs write for "none"
  const bool pbr =
      material.roughness || material.metallic || material.maps.count("map_pr") || material.maps.count("map_pm");
  if (pbr) {
    set_metallic_roughness(mtls, material, surface);
  } else {
    set_classic(mtls, material, surface);
  }
  set_illum(mtls, material, surface);
  surface.clearcoat = material.clearcoat.value_or(0.0f);
  surface.clearcoat_roughness = material.clearcoat_roughness.value_or(0.0f);
  const MtlMap* const normal = set_map(mtls, material, {"norm", "map_kn", "map_norm"}, SHD_SLOT_NORMAL, surface);
  if (normal) surface.normal_scale = static_cast<float>(std::clamp(normal->bump, -1e6, 1e6));
  const MtlMap* const bump = set_map(mtls, material, {"map_bump", "bump"}, SHD_SLOT_HEIGHT, surface);
  if (bump) surface.bump_scale = static_cast<float>(std::clamp(bump->bump, -1e6, 1e6));
  set_opacity(mtls, material, surface);
  warn_of_ambient(mtls, material, surface);
  return surface;
}

}  // namespace

std::vector<int32_t> add_mtl_surfaces(const Source& source, const std::vector<std::string>& libraries,
                                      const std::vector<std::string>& names, Model& model, Warnings& warnings) {
  Mtls mtls{source, model, warnings, {}, {}};
  const bool all_libraries = parse_libraries(mtls, libraries);
  std::vector<int32_t> out;
  std::map<const Mtl*, int32_t> surface_of_mtl;
  const auto add = [&](const std::string& name, const Mtl& material) {
    const auto next = static_cast<int32_t>(model.surfaces.size());
    const auto [at, is_new] = surface_of_mtl.try_emplace(&material, next);
    if (is_new) model.surfaces.push_back(surface_of(mtls, name, material));
    return at->second;
  };
  for (const std::string& name : names) {
    auto at = mtls.materials.find(name);
    if (at == mtls.materials.end()) at = mtls.materials.find(std::string(without_comment(name)));
    const bool found = at != mtls.materials.end();
    if (!found && all_libraries)
      warnings.add("material \"" + text_of(name) + "\" is in no MTL file; its faces are plain");
    out.push_back(found ? add(at->first, at->second) : kNone);
  }
  for (const auto& [name, material] : mtls.materials) add(name, material);
  return out;
}

}  // namespace shd::scene
