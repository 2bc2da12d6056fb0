// SPDX-License-Identifier: MIT
#include "import.h"

#include <cmath>
#include <map>

#include <assimp/commonMetaData.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <shd/sampler.h>

#include "failure.h"
#include "find_file.h"

namespace {

/// Everything one import passes along.
struct Import {
  const aiScene* scene = nullptr;
  std::string folder;                     // of the model, for its textures
  bool texture_replaces_color = false;    // Collada: a texture stands in place of the colour
  std::map<std::string, int> texture_of;  // name in the model -> Model::textures
  std::vector<size_t> geometry_of;        // aiMesh -> Model::geometries, or kNothing
  Model model;
};

constexpr size_t kNothing = ~size_t{0};
constexpr int kMaxDepth = 512;  // of the node tree

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

int add_texture(Import& import, const std::string& name) {
  const auto known = import.texture_of.find(name);
  if (known != import.texture_of.end()) return known->second;
  TextureSource source;
  if (const aiTexture* embedded = import.scene->GetEmbeddedTexture(name.c_str())) {
    source.path = "embedded texture " + name;
    if (embedded->mHeight == 0) {  // a whole image file of mWidth bytes
      const auto* bytes = reinterpret_cast<const unsigned char*>(embedded->pcData);
      source.file.assign(bytes, bytes + embedded->mWidth);
    } else {
      copy_texels(*embedded, source);
    }
  } else {
    source.path = find_file(import.folder, name);
  }
  import.model.textures.push_back(std::move(source));
  const int index = static_cast<int>(import.model.textures.size()) - 1;
  import.texture_of[name] = index;
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

/// A colour of the material within the range shd takes. False if the material has none.
bool read_color(const aiMaterial& material, const char* key, unsigned type, unsigned index, std::array<float, 3>& out) {
  aiColor4D color;
  if (material.Get(key, type, index, color) != AI_SUCCESS) return false;
  const float channels[3] = {color.r, color.g, color.b};
  for (size_t c = 0; c < 3; ++c) out[c] = channels[c] >= 0.0f && channels[c] <= 1e6f ? channels[c] : 0.0f;
  return true;
}

Surface surface_of(Import& import, const aiMaterial& material) {
  Surface surface;
  aiString name;
  if (material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) surface.name = name.C_Str();
  if (!read_color(material, AI_MATKEY_BASE_COLOR, surface.diffuse)) {
    read_color(material, AI_MATKEY_COLOR_DIFFUSE, surface.diffuse);
  }
  float exponent = 0.0f;
  if (material.Get(AI_MATKEY_SHININESS, exponent) == AI_SUCCESS && exponent >= 1.0f && exponent <= 1e6f) {
    surface.exponent = exponent;
    read_color(material, AI_MATKEY_COLOR_SPECULAR, surface.specular);
  }
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    aiString path;
    aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    if (surface.texture >= 0 ||
        material.GetTexture(type, 0, &path, nullptr, nullptr, nullptr, nullptr, modes) != AI_SUCCESS) {
      continue;
    }
    surface.texture = add_texture(import, path.C_Str());
    surface.wrap_u = wrap_of(modes[0]);
    surface.wrap_v = wrap_of(modes[1]);
    const bool black = surface.diffuse == std::array<float, 3>{0, 0, 0};
    if (import.texture_replaces_color || black) surface.diffuse = {1, 1, 1};
  }
  return surface;
}

bool finite(const aiVector3D& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

Geometry geometry_of(const aiMesh& mesh) {
  Geometry geometry;
  const auto append = [](std::vector<float>& to, const aiVector3D& from) {
    for (unsigned c = 0; c < 3; ++c) to.push_back(from[c]);
  };
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    append(geometry.position, finite(mesh.mVertices[i]) ? mesh.mVertices[i] : aiVector3D(0, 0, 0));
    if (mesh.HasNormals()) append(geometry.normal, mesh.mNormals[i]);
    if (!mesh.HasTextureCoords(0)) continue;
    // assimp's v grows upwards whatever the format stores. Its own aiProcess_FlipUVs runs before the coordinates that
    // aiProcess_GenUVCoords makes, and leaves those as they are.
    geometry.uv.push_back(mesh.mTextureCoords[0][i].x);
    geometry.uv.push_back(1.0f - mesh.mTextureCoords[0][i].y);
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    bool usable = face.mNumIndices == 3;
    for (unsigned k = 0; usable && k < 3; ++k) {
      usable = face.mIndices[k] < mesh.mNumVertices && finite(mesh.mVertices[face.mIndices[k]]);
    }
    if (usable) geometry.indices.insert(geometry.indices.end(), face.mIndices, face.mIndices + 3);
  }
  return geometry;
}

/// Places the meshes of a node and of all below it. assimp's matrices are row-major.
void place_node(Import& import, const aiNode& node, const aiMatrix4x4& parent, int depth) {
  const aiMatrix4x4 matrix = parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const unsigned mesh = node.mMeshes[i];
    if (mesh >= import.geometry_of.size() || import.geometry_of[mesh] == kNothing) continue;
    Instance instance;
    instance.geometry = import.geometry_of[mesh];
    instance.surface = import.scene->mMeshes[mesh]->mMaterialIndex;
    bool usable = true;
    for (unsigned row = 0; row < 4; ++row) {
      for (unsigned column = 0; column < 4; ++column) {
        const float value = row < 3 ? matrix[row][column] : (column == 3 ? 1.0f : 0.0f);
        instance.object_to_world[4 * column + row] = value;
        usable = usable && std::isfinite(value);
      }
    }
    if (usable) import.model.instances.push_back(instance);
  }
  if (depth == kMaxDepth) throw Failure(kExitInput, "the model's nodes are nested too deeply");
  for (unsigned i = 0; i < node.mNumChildren; ++i) place_node(import, *node.mChildren[i], matrix, depth + 1);
}

const aiScene* read_scene(Assimp::Importer& importer, const std::string& path) {
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  // Degenerate triangles stay: shd skips them, and assimp's own check would take all of a very small model away.
  const unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices |
                         aiProcess_TransformUVCoords | aiProcess_GenUVCoords;
  const aiScene* scene = importer.ReadFile(path, steps);
  if (!scene || !scene->mRootNode) throw Failure(kExitInput, path + ": " + importer.GetErrorString());
  return scene;
}

}  // namespace

Model import_model(const std::string& path) {
  Assimp::Importer importer;
  Import import;
  import.scene = read_scene(importer, path);
  const size_t slash = path.find_last_of('/');
  import.folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  aiString format;
  if (import.scene->mMetaData) import.scene->mMetaData->Get(AI_METADATA_SOURCE_FORMAT, format);
  import.texture_replaces_color = std::string(format.C_Str()).find("Collada") != std::string::npos;

  for (unsigned i = 0; i < import.scene->mNumMaterials; ++i) {
    import.model.surfaces.push_back(surface_of(import, *import.scene->mMaterials[i]));
  }
  if (import.model.surfaces.empty()) import.model.surfaces.emplace_back();
  for (unsigned i = 0; i < import.scene->mNumMeshes; ++i) {
    Geometry geometry = geometry_of(*import.scene->mMeshes[i]);
    import.geometry_of.push_back(geometry.indices.empty() ? kNothing : import.model.geometries.size());
    if (!geometry.indices.empty()) import.model.geometries.push_back(std::move(geometry));
  }
  place_node(import, *import.scene->mRootNode, aiMatrix4x4(), 0);
  for (Instance& instance : import.model.instances) {
    if (instance.surface >= import.model.surfaces.size()) instance.surface = 0;
  }
  if (import.model.instances.empty()) throw Failure(kExitInput, path + ": no triangles in it");
  return std::move(import.model);
}
