// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include "scene/read/assimp_parts.h"

namespace shd::scene {
namespace {

constexpr int kMaxDepth = 512;  // depth of the node tree

bool is_finite(const aiVector3D& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool is_usable(const aiMesh& mesh, const aiFace& face) {
  for (unsigned k = 0; k < face.mNumIndices; ++k) {
    if (face.mIndices[k] >= mesh.mNumVertices || !is_finite(mesh.mVertices[face.mIndices[k]])) return false;
  }
  return true;
}

/// Faces that were removed.
struct Removed {
  size_t bad = 0;       // polygons of three or more vertices
  uint64_t others = 0;  // points and lines
};

/// Keeps polygons of three or more valid vertices.
Removed keep_polygons(aiMesh& mesh) {
  Removed removed;
  unsigned kept = 0;
  mesh.mPrimitiveTypes = 0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices < 3 || !face.mIndices) {
      ++removed.others;
      continue;
    }
    if (!mesh.mVertices || !is_usable(mesh, face)) {
      ++removed.bad;
      continue;
    }
    mesh.mPrimitiveTypes |= face.mNumIndices == 3 ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_POLYGON;
    if (kept != i) {
      std::swap(mesh.mFaces[kept].mIndices, face.mIndices);
      std::swap(mesh.mFaces[kept].mNumIndices, face.mNumIndices);
    }
    ++kept;
  }
  mesh.mNumFaces = kept;
  for (unsigned i = 0; mesh.mVertices && i < mesh.mNumVertices; ++i) {
    if (!is_finite(mesh.mVertices[i])) mesh.mVertices[i] = aiVector3D(0, 0, 0);
  }
  return removed;
}

uint64_t count_triangles(const aiMesh& mesh) {
  uint64_t count = 0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) count += mesh.mFaces[i].mNumIndices - 2u;
  return count;
}

void check_nodes(const aiScene& scene, const Limits& limits) {
  std::vector<std::pair<const aiNode*, int>> open = {{scene.mRootNode, 0}};
  uint64_t count = 0;
  while (!open.empty()) {
    const auto [node, depth] = open.back();
    open.pop_back();
    check_limit("nodes", ++count, "max_nodes", limits.nodes);
    if (depth > kMaxDepth) core::refuse(SHD_ERROR_LIMIT, "its nodes are nested more than %d deep", kMaxDepth);
    for (unsigned i = 0; i < node->mNumChildren; ++i) open.push_back({node->mChildren[i], depth + 1});
  }
}

/// Removes the meshes without faces, on which assimp's steps would fail.
void remove_empty_meshes(aiScene& scene) {
  std::vector<unsigned> new_of(scene.mNumMeshes);
  unsigned kept = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    new_of[i] = scene.mMeshes[i]->mNumFaces ? kept : scene.mNumMeshes;
    if (scene.mMeshes[i]->mNumFaces) std::swap(scene.mMeshes[kept++], scene.mMeshes[i]);
  }
  std::vector<aiNode*> open = {scene.mRootNode};
  while (!open.empty()) {
    aiNode& node = *open.back();
    open.pop_back();
    unsigned count = 0;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const unsigned mesh = node.mMeshes[i] < new_of.size() ? new_of[node.mMeshes[i]] : scene.mNumMeshes;
      if (mesh < scene.mNumMeshes) node.mMeshes[count++] = mesh;
    }
    node.mNumMeshes = count;
    for (unsigned i = 0; i < node.mNumChildren; ++i) open.push_back(node.mChildren[i]);
  }
  for (unsigned i = kept; i < scene.mNumMeshes; ++i) {
    delete scene.mMeshes[i];
    scene.mMeshes[i] = nullptr;
  }
  scene.mNumMeshes = kept;
}

}  // namespace

void sanitize(aiScene& scene, const Limits& limits, Model& model) {
  check_nodes(scene, limits);
  uint64_t vertices = 0, triangles = 0, others = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    aiMesh& mesh = *scene.mMeshes[i];
    vertices += mesh.mNumVertices;
    const Removed removed = keep_polygons(mesh);
    others += removed.others;
    if (removed.bad) {
      model.warnings.push_back("mesh \"" + text_of(mesh.mName.C_Str()) + "\": " + std::to_string(removed.bad) +
                               " faces with indices out of range or positions that are not finite");
    }
    triangles += count_triangles(mesh);
  }
  check_limit("vertices", vertices, "max_vertices", limits.vertices);
  check_limit("triangles", triangles, "max_triangles", limits.triangles);
  if (triangles == 0) refuse_empty(model);
  if (others) model.warnings.push_back(std::to_string(others) + " lines and points are left out");
  remove_empty_meshes(scene);
}

}  // namespace shd::scene
