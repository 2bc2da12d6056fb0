// SPDX-License-Identifier: MIT
#include "import.h"

#include <cmath>

#include <assimp/commonMetaData.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "failure.h"
#include "import_surface.h"

namespace {

/// State of one import.
struct Import {
  const aiScene* scene = nullptr;
  std::vector<size_t> geometry_of;  // aiMesh -> Model::geometries, or kNothing
  Model model;
};

constexpr size_t kNothing = ~size_t{0};
constexpr int kMaxDepth = 512;  // depth of the node tree

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
    // assimp's v grows upwards for any file format. Its own aiProcess_FlipUVs runs before aiProcess_GenUVCoords creates
    // coordinates, and does not flip these.
    for (unsigned set = 0; set < 2; ++set) {
      if (!mesh.HasTextureCoords(set)) continue;
      std::vector<float>& uv = set == 0 ? geometry.uv : geometry.uv1;
      uv.push_back(mesh.mTextureCoords[set][i].x);
      uv.push_back(1.0f - mesh.mTextureCoords[set][i].y);
    }
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

/// Places the meshes of a node and of all nodes below it. assimp's matrices are row-major.
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
  // Degenerate triangles are kept: shd skips them, and assimp's own check would remove all triangles of a tiny model.
  const unsigned steps =
      aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices | aiProcess_GenUVCoords;
  const aiScene* scene = importer.ReadFile(path, steps);
  // Slots transform uv themselves, separately for each texture; the transforms that assimp reads from glTF 2.0 are used
  // there.
  if (scene && !is_gltf2(*scene)) scene = importer.ApplyPostProcessing(aiProcess_TransformUVCoords);
  if (!scene || !scene->mRootNode) throw Failure(kExitInput, path + ": " + importer.GetErrorString());
  return scene;
}

}  // namespace

Model import_model(const std::string& path) {
  Assimp::Importer importer;
  Import import;
  import.scene = read_scene(importer, path);
  add_surfaces(*import.scene, path, import.model);
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
