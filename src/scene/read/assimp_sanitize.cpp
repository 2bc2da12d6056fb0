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

/// Keeps polygons of three or more valid vertices. Returns the number of removed polygons of three or more vertices.
size_t keep_polygons(aiMesh& mesh) {
  size_t bad = 0;
  unsigned kept = 0;
  mesh.mPrimitiveTypes = 0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices < 3 || !face.mIndices) continue;  // points and lines
    if (!mesh.mVertices || !is_usable(mesh, face)) {
      ++bad;
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
  return bad;
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

}  // namespace

void sanitize(aiScene& scene, const Limits& limits, Model& model) {
  check_nodes(scene, limits);
  uint64_t vertices = 0, triangles = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    aiMesh& mesh = *scene.mMeshes[i];
    vertices += mesh.mNumVertices;
    if (const size_t bad = keep_polygons(mesh)) {
      model.warnings.push_back("mesh \"" + text_of(mesh.mName.C_Str()) + "\": " + std::to_string(bad) +
                               " faces with indices out of range or positions that are not finite");
    }
    triangles += count_triangles(mesh);
  }
  check_limit("vertices", vertices, "max_vertices", limits.vertices);
  check_limit("triangles", triangles, "max_triangles", limits.triangles);
  if (triangles == 0) refuse_empty(model);
}

}  // namespace shd::scene
