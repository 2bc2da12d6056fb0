// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <utility>

#include <assimp/commonMetaData.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <shd/sampler.h>

#include "scene/read/assimp_parts.h"
#include "scene/read/text_lines.h"

namespace shd::scene {
namespace {

/// State that the materials of one scene share.
struct Materials {
  const aiScene& scene;
  bool texture_replaces_color = false;                     // Collada: a texture replaces the colour
  std::map<std::pair<std::string, bool>, int> texture_of;  // key: name in the model, and whether it is data
  Model& model;
};

// assimp stores texels of uncompressed embedded textures as b, g, r, a.
void copy_texels(const aiTexture& from, TextureSource& to) {
  to.width = from.mWidth;
  to.height = from.mHeight;
  to.rgba.resize(size_t{4} * to.width * to.height);
  for (size_t i = 0; i < to.rgba.size() / 4; ++i) {
    const aiTexel& texel = from.pcData[i];
    const unsigned char rgba[4] = {texel.r, texel.g, texel.b, texel.a};
    for (size_t c = 0; c < 4; ++c) to.rgba[4 * i + c] = rgba[c];
  }
}

int add_texture(Materials& materials, const std::string& name, bool data) {
  const auto known = materials.texture_of.find({name, data});
  if (known != materials.texture_of.end()) return known->second;
  TextureSource source;
  source.data = data;
  if (const aiTexture* embedded = materials.scene.GetEmbeddedTexture(name.c_str())) {
    source.name = "embedded texture " + text_of(name);
    if (embedded->mHeight == 0) {  // a whole image file of mWidth bytes
      const auto* bytes = reinterpret_cast<const unsigned char*>(embedded->pcData);
      source.file.assign(bytes, bytes + embedded->mWidth);
    } else {
      copy_texels(*embedded, source);
    }
  } else {
    source.name = std::string(trimmed(name));
  }
  materials.model.textures.push_back(std::move(source));
  const int index = static_cast<int>(materials.model.textures.size()) - 1;
  materials.texture_of[{name, data}] = index;
  return index;
}

int wrap_of(aiTextureMapMode mode) {
  switch (mode) {
    case aiTextureMapMode_Clamp: return SHD_WRAP_CLAMP;
    case aiTextureMapMode_Mirror: return SHD_WRAP_MIRROR;
    case aiTextureMapMode_Decal: return SHD_WRAP_BORDER;
    default: return SHD_WRAP_REPEAT;
  }
}

/// Reads a colour of the material, clamped to the range of shd. Returns false if the material has none.
bool read_color(const aiMaterial& material, const char* key, unsigned type, unsigned index, std::array<float, 3>& out) {
  aiColor4D color;
  if (material.Get(key, type, index, color) != AI_SUCCESS) return false;
  const float channels[3] = {color.r, color.g, color.b};
  for (size_t c = 0; c < 3; ++c) out[c] = channels[c] >= 0.0f && channels[c] <= 1e6f ? channels[c] : 0.0f;
  return true;
}

/// Reads a number of the material, clamped to low..high. Returns false and leaves `out` unchanged if there is none.
bool read_number(const aiMaterial& material, const char* key, unsigned type, unsigned index, float low, float high,
                 float& out) {
  float number = 0.0f;
  if (material.Get(key, type, index, number) != AI_SUCCESS || !(number >= low && number <= high)) return false;
  out = number;
  return true;
}

/// Reads a texture of a type, unless `map` already has a texture.
void read_map(Materials& materials, const aiMaterial& material, aiTextureType type, bool data, Map& map,
              unsigned index = 0) {
  aiString path;
  unsigned uv_set = 0;
  aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
  if (map.texture >= 0 ||
      material.GetTexture(type, index, &path, nullptr, &uv_set, nullptr, nullptr, modes) != AI_SUCCESS) {
    return;
  }
  if (uv_set > 1) {
    materials.model.warnings.push_back("texture \"" + text_of(path.C_Str()) +
                                       "\": its texture coordinates are not among the first two sets");
    return;
  }
  map.texture = add_texture(materials, path.C_Str(), data);
  map.uv_set = uv_set;
  map.wrap_u = wrap_of(modes[0]);
  map.wrap_v = wrap_of(modes[1]);
}

void read_metallic_roughness(Materials& materials, const aiMaterial& material, Surface& surface) {
  surface.metallic_roughness = true;
  read_number(material, AI_MATKEY_METALLIC_FACTOR, 0.0f, 1.0f, surface.metallic);
  Map& roughness = surface.maps[SHD_SLOT_ROUGHNESS];
  read_map(materials, material, aiTextureType_UNKNOWN, true, roughness);
  roughness.channel = 1;
  surface.maps[SHD_SLOT_METALLIC] = roughness;
  surface.maps[SHD_SLOT_METALLIC].channel = 2;
  read_map(materials, material, aiTextureType_NORMALS, true, surface.maps[SHD_SLOT_NORMAL]);
  read_map(materials, material, aiTextureType_LIGHTMAP, true, surface.maps[SHD_SLOT_OCCLUSION]);
  read_map(materials, material, aiTextureType_EMISSIVE, false, surface.maps[SHD_SLOT_EMISSION]);
  read_color(material, AI_MATKEY_COLOR_EMISSIVE, surface.emission);
}

/// Reads the coefficients besides colour of materials that are not metallic-roughness.
void read_classic(Materials& materials, const aiMaterial& material, Surface& surface) {
  read_map(materials, material, aiTextureType_SPECULAR, false, surface.maps[SHD_SLOT_SPECULAR]);
  read_map(materials, material, aiTextureType_SHININESS, true, surface.maps[SHD_SLOT_EXPONENT]);
  read_map(materials, material, aiTextureType_OPACITY, true, surface.maps[SHD_SLOT_OPACITY]);
  read_map(materials, material, aiTextureType_NORMALS, true, surface.maps[SHD_SLOT_NORMAL]);
  read_map(materials, material, aiTextureType_HEIGHT, true, surface.maps[SHD_SLOT_HEIGHT]);
  read_map(materials, material, aiTextureType_AMBIENT_OCCLUSION, true, surface.maps[SHD_SLOT_OCCLUSION]);
  read_map(materials, material, aiTextureType_EMISSIVE, false, surface.maps[SHD_SLOT_EMISSION]);
  read_color(material, AI_MATKEY_COLOR_EMISSIVE, surface.emission);
  const bool black = surface.emission == std::array<float, 3>{0, 0, 0};
  if (surface.maps[SHD_SLOT_EMISSION].texture >= 0 && black) surface.emission = {1, 1, 1};
  // Files in which opacity 0 means opaque are common, so 0 counts as 1.
  float opacity = 1.0f;
  if (read_number(material, AI_MATKEY_OPACITY, 0.0f, 1.0f, opacity) && opacity > 0.0f) surface.opacity = opacity;
  if (surface.opacity < 1.0f || surface.maps[SHD_SLOT_OPACITY].texture >= 0) surface.alpha = Alpha::kBlend;
}

Surface surface_of(Materials& materials, const aiMaterial& material) {
  Surface surface;
  aiString name;
  if (material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) surface.name = text_of(name.C_Str());
  if (!read_color(material, AI_MATKEY_BASE_COLOR, surface.diffuse)) {
    read_color(material, AI_MATKEY_COLOR_DIFFUSE, surface.diffuse);
  }
  if (read_number(material, AI_MATKEY_SHININESS, 1.0f, 1e6f, surface.exponent)) {
    read_color(material, AI_MATKEY_COLOR_SPECULAR, surface.specular);
  }
  Map& diffuse = surface.maps[SHD_SLOT_DIFFUSE];
  read_map(materials, material, aiTextureType_BASE_COLOR, false, diffuse);
  read_map(materials, material, aiTextureType_DIFFUSE, false, diffuse);
  const bool black = surface.diffuse == std::array<float, 3>{0, 0, 0};
  if (diffuse.texture >= 0 && (materials.texture_replaces_color || black)) surface.diffuse = {1, 1, 1};
  if (read_number(material, AI_MATKEY_ROUGHNESS_FACTOR, 0.0f, 1.0f, surface.roughness)) {
    read_metallic_roughness(materials, material, surface);
  } else {
    read_classic(materials, material, surface);
  }
  return surface;
}

}  // namespace

std::string format_of(const aiScene& scene) {
  aiString format;
  if (scene.mMetaData) scene.mMetaData->Get(AI_METADATA_SOURCE_FORMAT, format);
  return format.C_Str();
}

void add_surfaces(const aiScene& scene, Model& model) {
  Materials materials{scene, format_of(scene).find("Collada") != std::string::npos, {}, model};
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    model.surfaces.push_back(surface_of(materials, *scene.mMaterials[i]));
  }
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[i];
    if (!mesh.HasVertexColors(0) || mesh.mMaterialIndex >= model.surfaces.size()) continue;
    Surface& surface = model.surfaces[mesh.mMaterialIndex];
    if (surface.name == AI_DEFAULT_MATERIAL_NAME) surface.diffuse = {1, 1, 1};  // the grey that assimp adds
  }
}

}  // namespace shd::scene
