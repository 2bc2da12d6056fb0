// SPDX-License-Identifier: MIT
#include "scene/objects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "extension/error.h"
#include "scene/normals.h"
#include "scene/project.h"
#include "scene/stage.h"
#include "scene/textures.h"

namespace shd::scene {
namespace {

using extension::require;

bool is_deformed(const MeshRow& row) {
  return row.skin >= 0 || row.node >= 0;
}

void set_columns(shd_f32_in* out, size_t count, const std::vector<float>& from) {
  for (size_t c = 0; c < count && !from.empty(); ++c) out[c] = {from.data() + c, count * sizeof(float)};
}

/// A mesh of a row, whose positions, normals, tangents and indices are those of `vertices`.
Mesh make_mesh(const Parts& parts, const MeshRow& row, Vertices&& vertices, uint32_t flags) {
  const Geometry& geometry = parts.model.geometries[row.geometry];
  if (!vertices.normal.empty()) fill_normals(vertices.position, vertices.indices, &vertices.normal);
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = static_cast<uint32_t>(vertices.position.size() / 3);
  set_columns(desc.position, 3, vertices.position);
  set_columns(desc.normal, 3, vertices.normal);
  set_columns(desc.tangent, 4, vertices.tangent);
  set_columns(desc.uv, 2, geometry.uv);
  set_columns(desc.uv1, 2, geometry.uv1);
  shd_f32_in color[4] = {};
  set_columns(color, 4, geometry.color);
  desc.attributes = color;
  desc.attribute_count = geometry.color.empty() ? 0 : 4;
  desc.indices.data = vertices.indices.data();
  desc.index_count = vertices.indices.size();
  desc.flags = flags;
  if (!geometry.uv.empty() && vertices.tangent.empty() && !row.second_uv) desc.flags |= SHD_MESH_TANGENTS;
  Mesh mesh;
  require(shd_mesh_create(parts.context, &desc, mesh.out()));
  return mesh;
}

/// Finds the meshes: one for each geometry, skin and node with weights of morph targets that are placed.
void find_rows(Parts& parts) {
  const Model& model = parts.model;
  std::map<std::tuple<uint32_t, int32_t, int32_t>, uint32_t> known;
  for (const Placement& placement : model.placements) {
    const Geometry& geometry = model.geometries[placement.geometry];
    MeshRow row = {placement.geometry, geometry.joint.empty() ? -1 : placement.skin, -1};
    if (!geometry.morphs.empty()) row.node = static_cast<int32_t>(placement.node);
    const auto added =
        known.emplace(std::make_tuple(row.geometry, row.skin, row.node), static_cast<uint32_t>(parts.rows.size()));
    parts.row_of.push_back(added.first->second);
    if (added.second) {
      parts.rows.push_back(row);
      parts.mesh_names.push_back(geometry.name);
    }
    for (const shd_slot_target target : {SHD_SLOT_NORMAL, SHD_SLOT_CLEARCOAT_NORMAL}) {
      const Map& map = model.surfaces[placement.surface].maps[target];
      if (map.texture >= 0 && map.uv_set == 1) parts.rows[added.first->second].second_uv = true;
    }
  }
}

void make_rigid_meshes(Parts& parts, const Deadline& deadline) {
  for (const MeshRow& row : parts.rows) {
    deadline.check();
    parts.meshes.emplace_back();
    if (is_deformed(row)) continue;
    const Geometry& g = parts.model.geometries[row.geometry];
    parts.meshes.back() =
        make_mesh(parts, row, {g.origin, g.position, g.normal, g.tangent, g.indices}, parts.mesh_flags);
  }
}

/// Drops the columns of geometries that no pose needs.
void drop_columns(Parts& parts) {
  std::vector<bool> deformed(parts.model.geometries.size());
  for (const MeshRow& row : parts.rows) {
    if (is_deformed(row)) deformed[row.geometry] = true;
  }
  for (size_t i = 0; i < deformed.size(); ++i) {
    if (deformed[i]) continue;
    Geometry& geometry = parts.model.geometries[i];
    Geometry kept;
    kept.origin = geometry.origin;
    kept.position = std::move(geometry.position);
    kept.indices = std::move(geometry.indices);
    geometry = std::move(kept);
  }
  for (TextureSource& source : parts.model.textures) source = TextureSource();
}

void warn_about_joints(Parts& parts) {
  for (const Placement& placement : parts.model.placements) {
    const Geometry& geometry = parts.model.geometries[placement.geometry];
    if (placement.skin < 0 || geometry.joint.empty()) continue;
    const size_t count = parts.model.skins[static_cast<size_t>(placement.skin)].joints.size();
    const bool good = std::all_of(geometry.joint.begin(), geometry.joint.end(), [&](auto j) { return j < count; });
    if (!good) parts.warnings.push_back("mesh \"" + geometry.name + "\": some of its joints are not in its skin");
  }
}

void add_animations(Parts& parts) {
  for (const Animation& animation : parts.model.animations) {
    Times out;
    bool first = true;
    size_t useless = 0;
    for (const Channel& channel : animation.channels) {
      const auto from = static_cast<double>(channel.times.front()), to = static_cast<double>(channel.times.back());
      out.first = first ? from : std::min(out.first, from);
      out.last = first ? to : std::max(out.last, to);
      first = false;
      if (!is_usable(parts.model, channel)) ++useless;
    }
    parts.animations.push_back(out);
    parts.animation_names.push_back(animation.name);
    if (useless == 0) continue;
    parts.warnings.push_back("animation \"" + animation.name +
                             "\": channels that do not fit their node: " + std::to_string(useless));
  }
}

/// Meshes and instances of a pose.
void add_meshes(const Parts& parts, const Pose& pose, const Deadline* deadline, std::vector<Vertices>* deformed,
                Objects* out) {
  for (size_t i = 0; i < parts.rows.size(); ++i) {
    if (deadline) deadline->check();
    const MeshRow& row = parts.rows[i];
    deformed->emplace_back();
    out->meshes.emplace_back();
    if (is_deformed(row)) {
      deformed->back() = deform(parts.model, row, pose);
      Vertices vertices = deformed->back();
      out->meshes.back() = make_mesh(parts, row, std::move(vertices), parts.mesh_flags | SHD_MESH_KEEP_NONFINITE);
    } else {
      shd_mesh_retain(parts.meshes[i].get());
      *out->meshes.back().out() = parts.meshes[i].get();
    }
    shd_mesh_info info = shd_mesh_info_default();
    require(shd_mesh_get_info(out->meshes.back().get(), &info));
    out->vertex_count += info.vertex_count - info.split_count;
    out->triangle_count += info.triangle_count;
  }
}

/// A mesh at its place in the world of the file.
struct Placed {
  uint32_t row, surface;
  Matrix object_to_world;  // positions of the mesh, without their origin
};

std::vector<Placed> place_rows(const Parts& parts, const Pose& pose, const std::vector<Vertices>& deformed) {
  std::vector<Placed> out;
  for (size_t i = 0; i < parts.row_of.size(); ++i) {
    const Placement& placement = parts.model.placements[i];
    const uint32_t row = parts.row_of[i];
    const bool moves = is_deformed(parts.rows[row]), skinned = parts.rows[row].skin >= 0;
    const auto& origin = moves ? deformed[row].origin : parts.model.geometries[placement.geometry].origin;
    const Matrix& world = skinned ? kIdentity : pose.worlds[placement.node];
    if (placement.copies.empty() || skinned) out.push_back({row, placement.surface, with_origin(world, origin)});
    for (size_t k = 0; k < placement.copies.size() && !skinned; ++k) {
      out.push_back({row, placement.surface, with_origin(multiply(world, placement.copies[k]), origin)});
    }
  }
  return out;
}

Bounds bounds_of(const Parts& parts, const std::vector<Placed>& placed, const std::vector<Vertices>& deformed) {
  Bounds box;
  for (const Placed& one : placed) {
    const bool moves = is_deformed(parts.rows[one.row]);
    const Geometry& geometry = parts.model.geometries[parts.rows[one.row].geometry];
    const Vertices& vertices = deformed[one.row];
    grow(moves ? vertices.position : geometry.position, moves ? vertices.indices : geometry.indices,
         one.object_to_world, &box);
  }
  return box;
}

/// Faces that are not drawn: the back of surfaces that are not double-sided. A mirror turns the winding (glTF 2.0,
/// 3.7.4); a matrix without a determinant has no front.
shd_cull cull_of(const Surface& surface, const Matrix& m) {
  const double det = determinant(m);
  if (surface.double_sided || !(std::fabs(det) > 0.0)) return SHD_CULL_NONE;
  return det > 0.0 ? SHD_CULL_BACK : SHD_CULL_FRONT;
}

void add_instances(const Parts& parts, const std::vector<Placed>& placed, Objects* out) {
  size_t lost = 0;
  for (const Placed& one : placed) {
    shd_scene_instance instance = shd_scene_instance_default();
    instance.mesh = one.row;
    instance.material = one.surface;
    instance.cull = cull_of(parts.model.surfaces[one.surface], one.object_to_world);
    bool finite = true;
    for (size_t i = 0; i < 16; ++i) {
      const double moved = i >= 12 && i < 15 ? one.object_to_world[i] - parts.origin[i - 12] : one.object_to_world[i];
      instance.object_to_world[i] = static_cast<float>(moved);
      finite = finite && std::isfinite(instance.object_to_world[i]);
    }
    if (!finite) {
      ++lost;
      continue;
    }
    shd_draw draw = shd_draw_default();
    draw.mesh = out->meshes[one.row].get();
    draw.material = parts.materials.materials[one.surface].get();
    draw.cull = instance.cull;
    std::copy_n(instance.object_to_world, 16, draw.object_to_world);
    out->instances.push_back(instance);
    out->draws.push_back(draw);
  }
  if (lost == 0) return;
  out->warnings.push_back("instances whose matrices are not finite as floats: " + std::to_string(lost));
  if (out->instances.empty()) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "no triangles in it: %s", out->warnings.back().c_str());
  }
}

/// Gives coordinates to geometries without any: in the pose of the file, the longest side of the model fills the cube
/// of the projection.
void project_uv(Parts& parts, shd_uv_projection projection, const Deadline& deadline) {
  if (projection == SHD_UV_PROJECTION_NONE) return;
  const Pose pose = pose_of(parts.model);
  std::vector<Vertices> deformed;
  for (const MeshRow& row : parts.rows) {
    deformed.push_back(is_deformed(row) ? deform(parts.model, row, pose) : Vertices());
  }
  const std::vector<Placed> placed = place_rows(parts, pose, deformed);
  const Matrix to_cube = cube_of(bounds_of(parts, placed, deformed));
  for (const Placed& one : placed) {
    deadline.check();
    const MeshRow& row = parts.rows[one.row];
    Geometry& geometry = parts.model.geometries[row.geometry];
    if (!geometry.uv.empty()) continue;
    const std::vector<float>& position = is_deformed(row) ? deformed[one.row].position : geometry.position;
    project_geometry(parts.context, projection, multiply(to_cube, one.object_to_world), position, &geometry);
  }
}

/// Everything of a scene that a pose changes. Sets the origin of the parts with `choose`.
void make_pose(const Parts& parts, const Pose& pose, const Deadline* deadline, std::array<double, 3>* choose,
               Objects* out) {
  std::vector<Vertices> deformed;
  out->warnings = parts.warnings;
  add_meshes(parts, pose, deadline, &deformed, out);
  const std::vector<Placed> placed = place_rows(parts, pose, deformed);
  out->bounds = bounds_of(parts, placed, deformed);
  if (choose) *choose = origin_of(out->bounds);
  add_instances(parts, placed, out);
  for (size_t c = 0; c < 3; ++c) {
    out->bounds.low[c] -= parts.origin[c];
    out->bounds.high[c] -= parts.origin[c];
  }
  add_lights(parts, pose, out);
  add_cameras(parts, pose, out);
}

}  // namespace

void make_objects(shd_context* context, HostFiles& files, Model&& model, const ObjectOptions& options,
                  const Limits& limits, const Deadline& deadline, Objects* out) {
  const auto parts = std::make_shared<Parts>();
  out->parts = parts;
  parts->context = context;
  parts->mesh_flags = options.mesh_flags;
  parts->model = std::move(model);
  parts->warnings = std::move(parts->model.warnings);
  for (Geometry& geometry : parts->model.geometries) prepare_normals(geometry, limits, &parts->warnings);
  parts->textures = load_textures(context, files, parts->model, options.load, options.all_textures_required, limits,
                                  deadline, &parts->texture_names, &parts->warnings);
  for (const Texture& texture : parts->textures) {
    if (texture.get()) parts->found_textures.push_back(texture.get());
  }
  make_materials(context, parts->model, parts->textures, options.sampler, options.host_filters, &parts->materials,
                 &parts->warnings);
  for (const Surface& surface : parts->model.surfaces) parts->material_names.push_back(surface.name);
  find_rows(*parts);
  warn_about_joints(*parts);
  add_animations(*parts);
  project_uv(*parts, options.uv_projection, deadline);
  make_rigid_meshes(*parts, deadline);
  drop_columns(*parts);
  make_pose(*parts, pose_of(parts->model), &deadline, &parts->origin, out);
}

void pose_objects(const std::shared_ptr<const Parts>& parts, uint32_t animation, double seconds, Objects* out) {
  out->parts = parts;
  make_pose(*parts, pose_of(parts->model, &parts->model.animations[animation], seconds), nullptr, nullptr, out);
}

}  // namespace shd::scene
