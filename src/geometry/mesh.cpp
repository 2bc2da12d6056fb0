// SPDX-License-Identifier: MIT
#include "geometry/mesh.h"

#include <cmath>
#include <cstring>

#include "core/status.h"
#include "data/column.h"
#include "data/data.h"
#include "data/vec3.h"
#include "geometry/edges.h"
#include "geometry/indices.h"
#include "geometry/normals.h"
#include "geometry/tangents.h"
#include "geometry/uv_projection.h"

namespace shd::geometry {
namespace {

using Column = core::Array<float>;

Column zero_column(const core::Allocator& allocator, size_t count) {
  Column column(allocator, data::padded(count));
  column.fill_zero();
  return column;
}

/// Copies the caller's column, packed and padded with zeros.
Column copy_column(const core::Allocator& allocator, const shd_f32_in& in, size_t count) {
  Column column(allocator, data::padded(count));
  if (data::is_packed(in.stride)) {
    if (count) std::memcpy(column.data(), in.data, count * sizeof(float));
  } else {
    for (size_t i = 0; i < count; ++i) column[i] = data::load(in, i);
  }
  for (size_t i = count; i < column.size(); ++i) column[i] = 0.0f;
  return column;
}

/// Copies a column; non-finite values become 0.
Column copy_finite(const core::Allocator& allocator, const shd_f32_in& in, size_t count) {
  if (!in.data) return zero_column(allocator, count);
  Column column = copy_column(allocator, in, count);
  for (size_t i = 0; i < count; ++i) {
    if (!std::isfinite(column[i])) column[i] = 0.0f;
  }
  return column;
}

void require_finite(int axis, const Column& column, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (std::isfinite(column[i])) continue;
    const char* what = std::isnan(column[i]) ? "nan" : column[i] < 0.0f ? "-inf" : "inf";
    core::refuse(SHD_ERROR_INVALID_ARGUMENT, "mesh.position[%d][%zu]: %s is not finite", axis, i, what);
  }
}

void copy_positions(const core::Allocator& allocator, const shd_mesh_desc& desc, Mesh* out) {
  Column* const columns[3] = {&out->px, &out->py, &out->pz};
  for (int axis = 0; axis < 3; ++axis) {
    *columns[axis] = copy_column(allocator, desc.position[axis], desc.vertex_count);
    if (!(desc.flags & SHD_MESH_KEEP_NONFINITE)) require_finite(axis, *columns[axis], desc.vertex_count);
  }
}

/// Normalises the caller's normals. Zero and non-finite normals become (0, 0, 1); returns their number.
uint32_t copy_normals(const shd_mesh_desc& desc, Mesh* out) {
  uint32_t normalless = 0;
  for (size_t i = 0; i < desc.vertex_count; ++i) {
    const data::Vec3 given = {data::load(desc.normal[0], i), data::load(desc.normal[1], i),
                              data::load(desc.normal[2], i)};
    data::Vec3 n = {0.0f, 0.0f, 0.0f};
    if (std::isfinite(given.x) && std::isfinite(given.y) && std::isfinite(given.z)) n = data::normalized(given);
    if (n.x == 0.0f && n.y == 0.0f && n.z == 0.0f) {
      n.z = 1.0f;
      ++normalless;
    }
    out->nx[i] = n.x;
    out->ny[i] = n.y;
    out->nz[i] = n.z;
  }
  return normalless;
}

void copy_tangents(const core::Allocator& allocator, const shd_mesh_desc& desc, Mesh* out) {
  if (!desc.tangent[0].data) return;
  out->tx = copy_column(allocator, desc.tangent[0], desc.vertex_count);
  out->ty = copy_column(allocator, desc.tangent[1], desc.vertex_count);
  out->tz = copy_column(allocator, desc.tangent[2], desc.vertex_count);
  out->tw = copy_finite(allocator, desc.tangent[3], desc.vertex_count);
  for (size_t i = 0; i < desc.vertex_count; ++i) {
    if (std::isfinite(out->tx[i]) && std::isfinite(out->ty[i]) && std::isfinite(out->tz[i])) continue;
    out->tx[i] = out->ty[i] = out->tz[i] = 0.0f;
  }
}

/// Copies the second uv set and the caller's own columns, if present.
void copy_attributes(const core::Allocator& allocator, const shd_mesh_desc& desc, Mesh* out) {
  if (desc.uv1[0].data) {
    out->u1 = copy_finite(allocator, desc.uv1[0], desc.vertex_count);
    out->v1 = copy_finite(allocator, desc.uv1[1], desc.vertex_count);
  }
  for (uint32_t c = 0; c < desc.attribute_count; ++c) {
    if (desc.attributes[c].data) out->attribute[c] = copy_finite(allocator, desc.attributes[c], desc.vertex_count);
  }
}

}  // namespace

void measure(Mesh* mesh) {
  shd_mesh_info& info = mesh->info;
  info.vertex_count = mesh->vertex_count;
  info.triangle_count = mesh->triangle_count;
  info.nonfinite_count = 0;
  bool any = false;
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    const float p[3] = {mesh->px[i], mesh->py[i], mesh->pz[i]};
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
      ++info.nonfinite_count;
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (!any || p[axis] < info.bounds_min[axis]) info.bounds_min[axis] = p[axis];
      if (!any || p[axis] > info.bounds_max[axis]) info.bounds_max[axis] = p[axis];
    }
    any = true;
  }
}

void build(const core::Context& context, const shd_mesh_desc& desc, Mesh* out) {
  const core::Allocator& allocator = context.allocator;
  const size_t count = desc.vertex_count;
  Mesh mesh{};
  mesh.vertex_count = desc.vertex_count;
  copy_indices(allocator, desc, &mesh);
  if (count) copy_positions(allocator, desc, &mesh);
  mesh.u = copy_finite(allocator, desc.uv[0], count);
  mesh.v = copy_finite(allocator, desc.uv[1], count);
  copy_tangents(allocator, desc, &mesh);
  copy_attributes(allocator, desc, &mesh);
  mesh.nx = zero_column(allocator, count);
  mesh.ny = zero_column(allocator, count);
  mesh.nz = zero_column(allocator, count);
  mesh.info.normalless_count =
      desc.normal[0].data ? copy_normals(desc, &mesh) : compute_normals(allocator, desc.normal_weight, &mesh);
  project_uv(allocator, desc.uv_projection, desc.object_to_projection, &mesh);
  if ((desc.flags & SHD_MESH_TANGENTS) && mesh.tx.size() == 0) compute_tangents(allocator, &mesh);
  measure(&mesh);
  mesh.has_adjacency = (desc.flags & SHD_MESH_ADJACENCY) != 0;
  if (mesh.has_adjacency) mesh.across = find_across(allocator, mesh);
  *out = std::move(mesh);
}

}  // namespace shd::geometry
