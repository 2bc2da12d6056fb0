// SPDX-License-Identifier: MIT
#include <cerrno>
#include <cmath>
#include <cstring>

#include <assimp/BaseImporter.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>

#include "core/printable.h"
#include "core/regular_file.h"
#include "scene/assimp_parts.h"
#include "scene/bounds.h"
#include "scene/import.h"

namespace shd::scene {
namespace {

constexpr size_t kNothing = ~size_t{0};

/// State of one import.
struct Import {
  const aiScene& scene;
  const Limits& limits;
  std::vector<size_t> geometry_of;  // aiMesh -> Model::geometries, or kNothing
  Model model;
};

/// Stops assimp between its steps.
class Stopwatch : public Assimp::ProgressHandler {
 public:
  explicit Stopwatch(const Deadline& deadline) : deadline_(deadline) {}
  bool Update(float) override { return !deadline_.has_passed(); }

 private:
  const Deadline& deadline_;
};

/// Throws Failure, with the reason, unless the path is a regular file that can be read.
void check_file(const std::string& path, const Limits& limits) {
  const std::string name = text_of(path.c_str());
  const core::RegularFile opened = core::open_regular(path.c_str());
  if (opened.other_kind) core::refuse(SHD_ERROR_IO, "\"%s\" is not a regular file", name.c_str());
  if (opened.error) {
    const bool missing = opened.error == ENOENT || opened.error == ENOTDIR;
    core::refuse(missing ? SHD_ERROR_NOT_FOUND : SHD_ERROR_IO, "cannot open \"%s\": %s", name.c_str(),
                 std::strerror(opened.error));
  }
  const uint64_t size = opened.size;
  if (size == 0) core::refuse(SHD_ERROR_CORRUPT, "\"%s\" is empty", name.c_str());
  if (size > limits.file_bytes) {
    core::refuse(SHD_ERROR_LIMIT, "\"%s\" has %llu bytes, above scene.max_file_bytes %llu", name.c_str(),
                 static_cast<unsigned long long>(size), static_cast<unsigned long long>(limits.file_bytes));
  }
}

void append(std::vector<float>& to, const aiVector3D& from) {
  for (unsigned c = 0; c < 3; ++c) to.push_back(from[c]);
}

void copy_vertices(const aiMesh& mesh, Geometry& geometry) {
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    append(geometry.position, mesh.mVertices[i]);
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
}

void add_geometries(Import& import) {
  for (unsigned i = 0; i < import.scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *import.scene.mMeshes[i];
    Geometry geometry;
    geometry.name = text_of(mesh.mName.C_Str());
    if (mesh.HasPositions()) copy_vertices(mesh, geometry);
    for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
      const aiFace& face = mesh.mFaces[k];
      if (face.mNumIndices == 3) geometry.indices.insert(geometry.indices.end(), face.mIndices, face.mIndices + 3);
    }
    import.geometry_of.push_back(geometry.indices.empty() ? kNothing : import.model.geometries.size());
    if (!geometry.indices.empty()) import.model.geometries.push_back(std::move(geometry));
  }
}

/// Converts a matrix from assimp's row-major order. Returns false if it is not finite.
bool copy_matrix(const aiMatrix4x4& matrix, std::array<float, 16>& out) {
  bool finite = true;
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      const float value = row < 3 ? matrix[row][column] : (column == 3 ? 1.0f : 0.0f);
      out[4 * column + row] = value;
      finite = finite && std::isfinite(value);
    }
  }
  return finite;
}

void place_meshes(Import& import, const aiNode& node, const aiMatrix4x4& matrix) {
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const unsigned mesh = node.mMeshes[i];
    if (mesh >= import.geometry_of.size() || import.geometry_of[mesh] == kNothing) continue;
    Instance instance;
    instance.geometry = import.geometry_of[mesh];
    instance.surface = import.scene.mMeshes[mesh]->mMaterialIndex;
    if (instance.surface >= import.model.surfaces.size()) instance.surface = 0;
    if (!copy_matrix(matrix, instance.object_to_world)) {
      import.model.warnings.push_back("node \"" + text_of(node.mName.C_Str()) + "\": its matrix is not finite");
      continue;
    }
    import.model.instances.push_back(instance);
    check_limit("instances", import.model.instances.size(), "max_instances", import.limits.instances);
  }
}

/// Places the meshes of all nodes, depth first.
void place_nodes(Import& import) {
  struct Visit {
    const aiNode* node;
    aiMatrix4x4 parent;
  };
  std::vector<Visit> open = {{import.scene.mRootNode, aiMatrix4x4()}};
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    const aiMatrix4x4 matrix = visit.parent * visit.node->mTransformation;
    place_meshes(import, *visit.node, matrix);
    for (unsigned i = visit.node->mNumChildren; i-- > 0;) {
      open.push_back({visit.node->mChildren[i], matrix});
    }
  }
}

/// Throws Failure if assimp did not make `scene`.
void require_scene(const aiScene* scene, const Assimp::Importer& importer, const Limits& limits,
                   const FileBudget& budget, const Deadline& deadline) {
  deadline.check();
  if (!budget.exceeded.empty()) {
    core::refuse(SHD_ERROR_LIMIT, "with \"%s\" its files have more bytes than scene.max_file_bytes %llu",
                 text_of(budget.exceeded.c_str()).c_str(), static_cast<unsigned long long>(limits.file_bytes));
  }
  if (scene && scene->mRootNode) return;
  const std::string reason = text_of(importer.GetErrorString());
  if (reason.find("No suitable reader") != std::string::npos)
    core::refuse(SHD_ERROR_UNSUPPORTED, "assimp has no reader for this format or version");
  core::refuse(SHD_ERROR_CORRUPT, "%s", reason.c_str());
}

/// Reads the file without assimp's post-processing, removes data that the post-processing steps do not expect, and then
/// runs these steps.
const aiScene& read_scene(Assimp::Importer& importer, const std::string& path, const Limits& limits,
                          const FileBudget& budget, const Deadline& deadline, Model& model) {
  const aiScene* scene = importer.ReadFile(path, 0);
  require_scene(scene, importer, limits, budget, deadline);
  sanitize(const_cast<aiScene&>(*scene), limits, model);
  // Degenerate triangles stay: shd skips them, and assimp's own check would remove all triangles of a very small model.
  // In files of glTF 2.0 each texture has its own transform of uv, which slots apply; other formats leave it to assimp.
  const unsigned steps =
      aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices | aiProcess_GenUVCoords;
  scene = importer.ApplyPostProcessing(steps);
  if (scene && !is_gltf2(*scene)) scene = importer.ApplyPostProcessing(aiProcess_TransformUVCoords);
  require_scene(scene, importer, limits, budget, deadline);
  return *scene;
}

/// Removes the readers that print. The one of OpenGEX writes about damaged files to stderr.
void remove_loud_readers(Assimp::Importer& importer) {
  Assimp::BaseImporter* const reader = importer.GetImporter("ogex");
  if (reader && importer.UnregisterLoader(reader) == aiReturn_SUCCESS) delete reader;
}

Model import_checked(const std::string& path, const Limits& limits, const Deadline& deadline) {
  FileBudget budget;
  budget.left = limits.file_bytes;
  Assimp::Importer importer;
  remove_loud_readers(importer);
  importer.SetIOHandler(make_file_system(budget, deadline).release());
  importer.SetProgressHandler(new Stopwatch(deadline));
  Model model;
  const aiScene& scene = read_scene(importer, path, limits, budget, deadline, model);
  Import import = {scene, limits, {}, std::move(model)};
  add_surfaces(import.scene, path, import.model);
  if (import.model.surfaces.empty()) import.model.surfaces.emplace_back();
  add_geometries(import);
  place_nodes(import);
  if (import.model.instances.empty()) refuse_empty(import.model);
  add_lights(import.scene, bounds_of(import.model).radius(), import.model);
  add_cameras(import.scene, import.model);
  return std::move(import.model);
}

}  // namespace

std::string text_of(const char* text) {
  std::string copy(text, strnlen(text, 400));
  core::make_printable(copy.data(), copy.size());
  return copy;
}

Model import_file(const std::string& path, const Limits& limits, const Deadline& deadline) {
  check_file(path, limits);
  try {
    return import_checked(path, limits, deadline);
  } catch (const core::Failure& failure) {
    core::refuse(failure.code, "\"%s\": %s", text_of(path.c_str()).c_str(), failure.what());
  }
}

}  // namespace shd::scene
