// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>

#include "scene/bounds.h"
#include "scene/pose.h"
#include "scene/read/assimp_parts.h"
#include "scene/read/colors.h"
#include "scene/read/creases.h"
#include "scene/read/join.h"
#include "scene/read/positions.h"

namespace shd::scene {
namespace {

constexpr size_t kNothing = ~size_t{0};

/// State of one import.
struct Import {
  const aiScene& scene;
  const Limits& limits;
  const Deadline& deadline;
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

void append(std::vector<float>& to, const aiVector3D& from) {
  for (unsigned c = 0; c < 3; ++c) to.push_back(from[c]);
}

/// Colours of vertices are sRGB codes, except in glTF.
void append_color(std::vector<float>& to, const aiColor4D& from, bool linear) {
  for (unsigned c = 0; c < 3; ++c) {
    const float channel = std::isfinite(from[c]) ? std::max(from[c], 0.0f) : 0.0f;
    to.push_back(linear ? channel : linear_of_srgb(channel));
  }
  to.push_back(from.a >= 0.0f ? std::min(from.a, 1.0f) : 0.0f);
}

/// Appends a normal. One that is not finite becomes 0. Returns whether it has a direction.
bool append_normal(std::vector<float>& to, const aiVector3D& from) {
  const bool good = std::isfinite(from.x) && std::isfinite(from.y) && std::isfinite(from.z) &&
                    (from.x != 0 || from.y != 0 || from.z != 0);
  append(to, good ? from : aiVector3D(0, 0, 0));
  return good;
}

void copy_vertices(const aiMesh& mesh, bool linear_colors, Geometry& geometry, Warnings& warnings) {
  std::vector<double> positions;
  bool good = true;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    for (unsigned c = 0; c < 3; ++c) positions.push_back(static_cast<double>(mesh.mVertices[i][c]));
    if (mesh.HasNormals()) good = append_normal(geometry.normal, mesh.mNormals[i]) && good;
    if (mesh.HasVertexColors(0)) append_color(geometry.color, mesh.mColors[0][i], linear_colors);
    // assimp's v grows upwards for any file format. Its own aiProcess_FlipUVs runs before aiProcess_GenUVCoords creates
    // coordinates, and does not flip these.
    for (unsigned set = 0; set < 2; ++set) {
      if (!mesh.HasTextureCoords(set)) continue;
      std::vector<float>& uv = set == 0 ? geometry.uv : geometry.uv1;
      uv.push_back(mesh.mTextureCoords[set][i].x);
      uv.push_back(1.0f - mesh.mTextureCoords[set][i].y);
    }
  }
  set_positions(geometry, positions, {0, 0, 0});
  if (!good) warnings.add("normals of length 0 or not finite: those of the faces are used");
  if (geometry.origin != Point{0, 0, 0}) {
    warnings.add("mesh \"" + geometry.name + "\": assimp reads positions as floats; this far away they lose detail");
  }
}

/// Parts of a mesh that the picture has not.
void warn_of_parts(const aiMesh& mesh, Warnings& warnings) {
  if (mesh.mNumBones) warnings.add("skins are left out");
  if (mesh.mNumAnimMeshes) warnings.add("morph targets are left out");
  if (mesh.HasVertexColors(1)) warnings.add("second sets of colours are left out");
}

void add_geometries(Import& import) {
  Warnings warnings(import.model);
  if (import.scene.mNumAnimations) warnings.add("animations are left out");
  const bool linear_colors = format_of(import.scene).find("glTF") != std::string::npos;
  for (unsigned i = 0; i < import.scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *import.scene.mMeshes[i];
    Geometry geometry;
    geometry.name = text_of(mesh.mName.C_Str());
    for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
      const aiFace& face = mesh.mFaces[k];
      if (face.mNumIndices == 3) geometry.indices.insert(geometry.indices.end(), face.mIndices, face.mIndices + 3);
    }
    import.geometry_of.push_back(geometry.indices.empty() ? kNothing : import.model.geometries.size());
    if (geometry.indices.empty()) continue;
    warn_of_parts(mesh, warnings);
    copy_vertices(mesh, linear_colors, geometry, warnings);
    join_identical(geometry);
    if (!mesh.HasNormals()) add_creased_normals(&geometry, 1, import.limits, import.deadline);
    import.model.geometries.push_back(std::move(geometry));
  }
}

/// Converts a matrix from assimp's row-major order. Returns false if it is not finite.
bool copy_matrix(const aiMatrix4x4& matrix, Matrix& out) {
  bool finite = true;
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      const float value = row < 3 ? matrix[row][column] : (column == 3 ? 1.0f : 0.0f);
      out[4 * column + row] = static_cast<double>(value);
      finite = finite && std::isfinite(value);
    }
  }
  return finite;
}

void place_meshes(Import& import, const aiNode& node, uint32_t index) {
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const unsigned mesh = node.mMeshes[i];
    if (mesh >= import.geometry_of.size() || import.geometry_of[mesh] == kNothing) continue;
    Placement placement;
    placement.geometry = static_cast<uint32_t>(import.geometry_of[mesh]);
    placement.surface = import.scene.mMeshes[mesh]->mMaterialIndex;
    if (placement.surface >= import.model.surfaces.size()) placement.surface = 0;
    placement.node = index;
    import.model.placements.push_back(placement);
    check_limit("instances", import.model.placements.size(), "max_instances", import.limits.instances);
  }
}

/// Copies all nodes, depth first. A node whose matrix is not finite is left out with all below it.
void add_nodes(Import& import) {
  struct Visit {
    const aiNode* node;
    int32_t parent;
  };
  std::vector<Visit> open = {{import.scene.mRootNode, -1}};
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    Node node;
    node.name = text_of(visit.node->mName.C_Str());
    node.parent = visit.parent;
    if (!copy_matrix(visit.node->mTransformation, node.matrix)) {
      import.model.warnings.push_back("node \"" + node.name + "\": its matrix is not finite");
      continue;
    }
    const auto index = static_cast<uint32_t>(import.model.nodes.size());
    import.model.nodes.push_back(std::move(node));
    place_meshes(import, *visit.node, index);
    for (unsigned i = visit.node->mNumChildren; i-- > 0;) {
      open.push_back({visit.node->mChildren[i], static_cast<int32_t>(index)});
    }
  }
}

/// Throws Failure if assimp did not make `scene`.
void require_scene(const aiScene* scene, const Assimp::Importer& importer, const std::optional<core::Failure>& failure,
                   const Deadline& deadline) {
  deadline.check();
  if (failure) throw *failure;
  if (scene && scene->mRootNode) return;
  const std::string reason = text_of(importer.GetErrorString());
  if (reason.find("No suitable reader") != std::string::npos)
    core::refuse(SHD_ERROR_UNSUPPORTED, "assimp has no reader for this format or version");
  core::refuse(SHD_ERROR_CORRUPT, "%s", reason.c_str());
}

/// The file system of an importer for the duration of a scope. Without a new one assimp forgets the old one.
class Lent {
 public:
  Lent(Assimp::Importer& importer, Assimp::IOSystem& files) : importer_(importer) { importer.SetIOHandler(&files); }
  ~Lent() { importer_.SetIOHandler(nullptr); }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;

 private:
  Assimp::Importer& importer_;
};

/// Reads the file without assimp's post-processing, removes data that the post-processing steps do not expect, and then
/// runs these steps.
const aiScene& read_scene(Assimp::Importer& importer, const Source& source, Model& model) {
  std::optional<core::Failure> failure;
  const auto files = make_file_system(source, failure);
  const Lent lent(importer, *files);
  const aiScene* scene = importer.ReadFile(source.name, 0);
  require_scene(scene, importer, failure, source.deadline);
  sanitize(const_cast<aiScene&>(*scene), source.limits, model);
  // Degenerate triangles stay: shd skips them, and assimp's own check would remove all triangles of a very small model.
  const unsigned steps = aiProcess_Triangulate | aiProcess_GenUVCoords | aiProcess_TransformUVCoords;
  scene = importer.ApplyPostProcessing(steps);
  require_scene(scene, importer, failure, source.deadline);
  return *scene;
}

/// Removes the readers of formats that have one of their own, and the one of OpenGEX, which writes about damaged files
/// to stderr.
void remove_readers(Assimp::Importer& importer) {
  for (const char* const extension : {"ogex", "obj", "ply", "stl"}) {
    Assimp::BaseImporter* const reader = importer.GetImporter(extension);
    if (reader && importer.UnregisterLoader(reader) == aiReturn_SUCCESS) delete reader;
  }
  for (size_t i = importer.GetImporterCount(); i-- > 0;) {  // glTF 1.0 has the extensions of glTF 2.0
    Assimp::BaseImporter* const reader = importer.GetImporter(i);
    const bool gltf2 = std::string_view(importer.GetImporterInfo(i)->mName).find("glTF2") == 0;
    if (gltf2 && importer.UnregisterLoader(reader) == aiReturn_SUCCESS) delete reader;
  }
}

}  // namespace

Model read_by_assimp(const Source& source) {
  Assimp::Importer importer;
  remove_readers(importer);
  importer.SetProgressHandler(new Stopwatch(source.deadline));
  Model model;
  const aiScene& scene = read_scene(importer, source, model);
  Import import = {scene, source.limits, source.deadline, {}, std::move(model)};
  add_surfaces(import.scene, import.model);
  if (import.model.surfaces.empty()) import.model.surfaces.emplace_back();
  add_geometries(import);
  add_nodes(import);
  if (import.model.placements.empty()) refuse_empty(import.model);
  add_lights(import.scene, bounds_of(import.model, place(import.model)).radius(), import.model);
  add_cameras(import.scene, import.model);
  return std::move(import.model);
}

}  // namespace shd::scene
