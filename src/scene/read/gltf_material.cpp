// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "scene/read/gltf_document.h"

namespace shd::scene::gltf {
namespace {

using Color = std::array<float, 3>;

constexpr float kMaxIor = 10.0f;  // largest index of materials

/// State of the materials of a file.
struct Palette {
  Document& document;
  std::map<std::pair<uint32_t, bool>, int32_t> texture_of;  // image, data -> Model::textures
};

/// Extensions of a texture that name another image.
constexpr const char* kImageExtensions[] = {"EXT_texture_webp", "MSFT_texture_dds"};

std::optional<uint32_t> image_of(Palette& palette, const Part& texture) {
  const size_t count = palette.document.root["images"].size();
  for (const char* name : kImageExtensions) {
    if (const std::optional<uint32_t> image = texture.extension(name).index("source", count)) return image;
  }
  const std::optional<uint32_t> core = texture.index("source", count);
  return core ? core : texture.extension("KHR_texture_basisu").index("source", count);
}

void read_image(Document& document, const Part& image, TextureSource& source) {
  const Part uri = image["uri"];
  if (!uri) {
    const std::optional<uint32_t> view = image.index("bufferView", document.root["bufferViews"].size());
    if (!view) image.refuse("has neither a uri nor a bufferView");
    const Bytes bytes = view_bytes(document, *view);
    spend_bytes(document, bytes.size);
    source.file.assign(bytes.data, bytes.data + bytes.size);
  } else if (std::optional<std::vector<unsigned char>> data = read_data_uri(document, uri)) {
    source.file = std::move(*data);
  } else {
    source.name = file_of_uri(document, uri.text());
    if (source.name.empty())
      uri.refuse("a URI of this scheme is not read: " + text_of(uri.text()), SHD_ERROR_UNSUPPORTED);
    return;
  }
  if (source.file.empty()) image.refuse("has no bytes");
  source.name = name_of(image);
}

/// The Model's texture of an image. Images without sRGB curve (`data`) are textures of their own.
int32_t texture_of(Palette& palette, uint32_t image, bool data) {
  const auto known = palette.texture_of.find({image, data});
  if (known != palette.texture_of.end()) return known->second;
  const Part part = palette.document.root["images"].at(image);
  TextureSource source;
  source.data = data;
  source.srgb = !data;  // 5.19: colour information of PNG and JPEG files is ignored
  int32_t index = -1;
  const bool good =
      attempt(palette.document, title_of("image", part), [&] { read_image(palette.document, part, source); });
  if (good) {
    index = static_cast<int32_t>(palette.document.model.textures.size());
    palette.document.model.textures.push_back(std::move(source));
  }
  palette.texture_of[{image, data}] = index;
  return index;
}

int32_t wrap_of(const Part& sampler, const char* name) {
  switch (sampler.integer(name, 10497)) {
    case 10497: return SHD_WRAP_REPEAT;
    case 33071: return SHD_WRAP_CLAMP;
    case 33648: return SHD_WRAP_MIRROR;
    default: sampler[name].refuse("is no wrap of glTF 2.0");
  }
}

/// Section 5.26.
void read_sampler(const Part& sampler, Map& map) {
  map.wrap_u = wrap_of(sampler, "wrapS");
  map.wrap_v = wrap_of(sampler, "wrapT");
  switch (sampler.integer("magFilter", 0)) {
    case 0: break;
    case 9728: map.magnify = Filter::kNearest; break;
    case 9729: map.magnify = Filter::kLinear; break;
    default: sampler["magFilter"].refuse("is no filter of glTF 2.0");
  }
  const uint64_t minify = sampler.integer("minFilter", 0);
  if (minify == 0) return;
  const bool levels = minify >= 9984 && minify <= 9987;
  if (!levels && minify != 9728 && minify != 9729) sampler["minFilter"].refuse("is no filter of glTF 2.0");
  map.no_mip = !levels;
  map.minify = minify % 2 == 0 ? Filter::kNearest : Filter::kLinear;
  if (levels) map.mip = minify >= 9986 ? Filter::kLinear : Filter::kNearest;
}

/// KHR_texture_transform: translation * rotation * scale.
void read_transform(const Part& transform, Map& map) {
  std::array<double, 2> offset = {0, 0}, scale = {1, 1};
  transform.numbers("offset", offset);
  transform.numbers("scale", scale);
  const double angle = transform.number("rotation", 0), c = std::cos(angle), s = std::sin(angle);
  const double numbers[6] = {scale[0] * c, scale[1] * s, offset[0], -scale[0] * s, scale[1] * c, offset[1]};
  for (size_t i = 0; i < 6; ++i) map.uv_transform[i] = static_cast<float>(numbers[i]);
}

/// Reads a textureInfo into a map; a fault is a warning, and the map is left out.
void read_map(Palette& palette, const Part& info, bool data, uint32_t channel, Map& out) {
  Document& document = palette.document;
  if (!info) return;
  attempt(document, "texture", [&] {
    const Part transform = info.extension("KHR_texture_transform");
    const uint64_t set = transform.integer("texCoord", info.integer("texCoord", 0));
    if (set > 1)
      info.refuse("texCoord " + std::to_string(set) + " is left out; sets 0 and 1 are read", SHD_ERROR_UNSUPPORTED);
    const Part textures = document.root["textures"];
    const std::optional<uint32_t> index = info.index("index", textures.size());
    if (!index) info.refuse("has no index");
    const Part texture = textures.at(*index);
    const std::optional<uint32_t> image = image_of(palette, texture);
    if (!image) texture.refuse("has no image that is read", SHD_ERROR_UNSUPPORTED);
    Map map;
    map.uv_set = static_cast<uint32_t>(set);
    map.channel = channel;
    const Part samplers = document.root["samplers"];
    if (const auto sampler = texture.index("sampler", samplers.size())) read_sampler(samplers.at(*sampler), map);
    if (transform) read_transform(transform, map);
    map.texture = texture_of(palette, *image, data);
    if (map.texture >= 0) out = map;
  });
}

/// Section 3.9.2.
void read_metallic_roughness(Palette& palette, const Part& pbr, Surface& s) {
  std::array<float, 4> base = {1, 1, 1, 1};
  pbr.numbers("baseColorFactor", base);
  s.diffuse = {base[0], base[1], base[2]};
  s.opacity = base[3];
  s.metallic = pbr.number_f("metallicFactor", 1.0f, 0.0, 1.0);
  s.roughness = pbr.number_f("roughnessFactor", 1.0f, 0.0, 1.0);
  read_map(palette, pbr["baseColorTexture"], false, 0, s.maps[SHD_SLOT_DIFFUSE]);
  read_map(palette, pbr["metallicRoughnessTexture"], true, 2, s.maps[SHD_SLOT_METALLIC]);
  read_map(palette, pbr["metallicRoughnessTexture"], true, 1, s.maps[SHD_SLOT_ROUGHNESS]);
}

void read_specular_glossiness(Palette& palette, const Part& part, Surface& s) {
  std::array<float, 4> diffuse = {1, 1, 1, 1};
  s.specular_glossiness = true;
  s.specular = {1, 1, 1};
  part.numbers("diffuseFactor", diffuse);
  part.numbers("specularFactor", s.specular);
  for (float& c : s.specular) c = std::clamp(c, 0.0f, 1.0f);
  s.diffuse = {diffuse[0], diffuse[1], diffuse[2]};
  s.opacity = diffuse[3];
  s.metallic = 0.0f;
  s.roughness = 1.0f - part.number_f("glossinessFactor", 1.0f, 0.0, 1.0);
  read_map(palette, part["diffuseTexture"], false, 0, s.maps[SHD_SLOT_DIFFUSE]);
  read_map(palette, part["specularGlossinessTexture"], false, 0, s.maps[SHD_SLOT_SPECULAR]);
}

void read_alpha(Document& document, const Part& material, Surface& s) {
  const std::string mode = material["alphaMode"] ? material.text("alphaMode") : "OPAQUE";
  s.alpha = mode == "MASK" ? Alpha::kMask : mode == "BLEND" ? Alpha::kBlend : Alpha::kOpaque;
  if (mode != "MASK" && mode != "BLEND" && mode != "OPAQUE") {
    document.warnings.add(title_of("material", material) + ": alphaMode \"" + text_of(mode) +
                          "\" is no mode of glTF 2.0");
  }
  s.alpha_cutoff = material.number_f("alphaCutoff", 0.5f, 0.0);
}

void read_clearcoat(Palette& palette, const Part& coat, Surface& s) {
  s.clearcoat = coat.number_f("clearcoatFactor", 0.0f, 0.0, 1.0);
  s.clearcoat_roughness = coat.number_f("clearcoatRoughnessFactor", 0.0f, 0.0, 1.0);
  read_map(palette, coat["clearcoatTexture"], true, 0, s.maps[SHD_SLOT_CLEARCOAT]);
  read_map(palette, coat["clearcoatRoughnessTexture"], true, 1, s.maps[SHD_SLOT_CLEARCOAT_ROUGHNESS]);
  read_map(palette, coat["clearcoatNormalTexture"], true, 0, s.maps[SHD_SLOT_CLEARCOAT_NORMAL]);
  if (coat["clearcoatNormalTexture"].number("scale", 1.0) != 1.0) {
    palette.document.warnings.add("KHR_materials_clearcoat: scale of clearcoatNormalTexture is left out");
  }
}

/// The reflection of a dielectric at normal incidence by KHR_materials_ior, where 0 means that all is reflected, and by
/// KHR_materials_specular. A strong one leaves little light for the base colour, as specular-glossiness does. With
/// maps, the index of refraction alone changes, without colour.
void set_reflection(Document& document, const Part& part, Surface& s) {
  Color color = {1, 1, 1};
  const float factor = part.number_f("specularFactor", 1.0f, 0.0, 1.0);
  part.numbers("specularColorFactor", color);
  const bool textured = part["specularTexture"] || part["specularColorTexture"];
  const bool plain = factor == 1.0f && color == Color{1, 1, 1} && !textured;
  const float f0 = s.ior > 0.0f ? std::pow((s.ior - 1.0f) / (s.ior + 1.0f), 2.0f) : 1.0f;
  constexpr float kStrong = 0.1f;
  if (plain && f0 < kStrong) return;
  const auto has_map = [&](shd_slot_target target) { return s.maps[target].texture >= 0; };
  if (s.metallic == 0.0f && s.transmission == 0.0f && !textured && !s.specular_glossiness &&
      !has_map(SHD_SLOT_DIFFUSE) && !has_map(SHD_SLOT_ROUGHNESS)) {
    const bool grey = color[0] == color[1] && color[1] == color[2];
    if (!grey && f0 < kStrong)
      document.warnings.add("KHR_materials_specular: the colour of a weak reflection is left out");
    s.specular_glossiness = true;
    for (size_t c = 0; c < 3; ++c) s.specular[c] = std::clamp(f0 * color[c], 0.0f, 1.0f) * factor;
    return;
  }
  if (!plain) {
    document.warnings.add("KHR_materials_specular: its factors change the index of refraction; the rest is left out");
  }
  float reflected = std::min(f0 * (color[0] + color[1] + color[2]) / 3.0f, 1.0f) * factor;
  // Converters of specular-glossiness write an index near infinity, and the reflection into the texture.
  if (textured && reflected >= kStrong) reflected = kDielectric;
  const float root = std::sqrt(reflected);
  s.ior = root < 1.0f ? (1.0f + root) / (1.0f - root) : 0.0f;
  if (s.ior == 0.0f || s.ior > kMaxIor) {
    document.warnings.add("KHR_materials_ior: an index of refraction of 0 or above 10 counts as 10");
  }
}

void read_extensions(Palette& palette, const Part& material, Surface& s) {
  Document& document = palette.document;
  const float strength = material.extension("KHR_materials_emissive_strength").number_f("emissiveStrength", 1.0f, 0.0);
  for (float& c : s.emission) c = std::min(c * strength, 1e30f);
  s.unlit = static_cast<bool>(material.extension("KHR_materials_unlit"));
  s.ior = material.extension("KHR_materials_ior").number_f("ior", s.ior, 0.0);
  if (s.ior > 0.0f && s.ior < 1.0f) {
    document.warnings.add(title_of("material", material) + ": ior is neither 0 nor at least 1; it counts as 1");
    s.ior = 1.0f;
  }
  const Part transmission = material.extension("KHR_materials_transmission");
  s.transmission = transmission.number_f("transmissionFactor", 0.0f, 0.0, 1.0);
  set_reflection(document, material.extension("KHR_materials_specular"), s);
  if (const Part coat = material.extension("KHR_materials_clearcoat")) read_clearcoat(palette, coat, s);
  if (transmission["transmissionTexture"]) {
    document.warnings.add("KHR_materials_transmission: transmissionTexture is left out");
  }
}

void read_material(Palette& palette, const Part& material, Surface& s) {
  const Part glossy = material.extension("KHR_materials_pbrSpecularGlossiness");
  s.double_sided = material.flag("doubleSided");
  if (glossy) {
    read_specular_glossiness(palette, glossy, s);
  } else {
    read_metallic_roughness(palette, material["pbrMetallicRoughness"], s);
  }
  read_alpha(palette.document, material, s);
  material.numbers("emissiveFactor", s.emission);
  const Part normal = material["normalTexture"], occlusion = material["occlusionTexture"];
  s.normal_scale = normal.number_f("scale", 1.0f);
  s.occlusion_strength = occlusion.number_f("strength", 1.0f, 0.0, 1.0);
  read_map(palette, normal, true, 0, s.maps[SHD_SLOT_NORMAL]);
  read_map(palette, occlusion, true, 0, s.maps[SHD_SLOT_OCCLUSION]);
  read_map(palette, material["emissiveTexture"], false, 0, s.maps[SHD_SLOT_EMISSION]);
  read_extensions(palette, material, s);
}

/// The default material of glTF 2.0 (section 3.9.6).
Surface plain_surface() {
  Surface s;
  s.metallic_roughness = true;
  s.diffuse = {1, 1, 1};
  s.metallic = s.roughness = 1.0f;
  s.double_sided = false;
  return s;
}

}  // namespace

void add_surfaces(Document& document) {
  Palette palette = {document, {}};
  const Part materials = document.root["materials"];
  for (size_t i = 0; i < materials.size(); ++i) {
    document.source.deadline.check();
    const Part material = materials.at(i);
    Surface s = plain_surface();
    s.name = name_of(material);
    attempt(document, title_of("material", material), [&] { read_material(palette, material, s); });
    document.model.surfaces.push_back(std::move(s));
  }
}

uint32_t default_surface(Document& document) {
  std::vector<Surface>& surfaces = document.model.surfaces;
  if (surfaces.size() == document.root["materials"].size()) {
    surfaces.push_back(plain_surface());
    surfaces.back().name = "default";
  }
  return static_cast<uint32_t>(surfaces.size() - 1);
}

}  // namespace shd::scene::gltf
