// SPDX-License-Identifier: MIT
#include "tool/shapes.h"

#include <algorithm>
#include <vector>

#include "command/failure.h"
#include "tool/uv.h"

namespace {

/// The box of positions that are `stride` floats apart.
Box box_around(const std::vector<float>& vertices, size_t stride) {
  Box box;
  for (size_t i = 0; i < vertices.size(); i += stride) {
    for (size_t c = 0; c < 3; ++c) {
      box.low[c] = std::min<double>(box.low[c], vertices[i + c]);
      box.high[c] = std::max<double>(box.high[c], vertices[i + c]);
    }
  }
  return box;
}

}  // namespace

Mesh make_shape(shd_context* context, shd_shape shape, uint32_t steps, uint32_t mesh_flags,
                shd_uv_projection projection) {
  shd_shape_desc desc = shd_shape_desc_default();
  desc.kind = shape;
  for (uint32_t& segments : desc.segments) segments = steps;
  if (shape == SHD_SHAPE_SPHERE) desc.segments[0] = 4 * steps, desc.segments[1] = 2 * steps;
  if (shape == SHD_SHAPE_TORUS) desc.segments[0] = 4 * steps, desc.segments[1] = 2 * steps + 1;
  if (shape == SHD_SHAPE_TEAPOT) desc.segments[0] = std::max(steps, 2u);
  shd_shape_columns columns = shd_shape_columns_default();
  check(shd_shape_count(&desc, &columns.vertex_count, &columns.index_count), "shape");
  std::vector<float> vertices(size_t{8} * columns.vertex_count);
  std::vector<uint32_t> indices(columns.index_count);
  shd_mesh_desc mesh = shd_mesh_desc_default();
  for (size_t c = 0; c < 8; ++c) {
    const shd_f32_out column = {vertices.data() + c, 8 * sizeof(float)};
    (c < 3 ? columns.position[c] : c < 6 ? columns.normal[c - 3] : columns.uv[c - 6]) = column;
    (c < 3 ? mesh.position[c] : c < 6 ? mesh.normal[c - 3] : mesh.uv[c - 6]) = {column.data, column.stride};
  }
  columns.indices.data = indices.data();
  check(shd_shape_fill(&desc, &columns), "shape");
  mesh.vertex_count = columns.vertex_count;
  mesh.indices.data = indices.data();
  mesh.index_count = indices.size();
  mesh.flags = mesh_flags | SHD_MESH_TANGENTS;
  if (projection != SHD_UV_PROJECTION_NONE) {
    const std::array<float, 16> fit = fit_box(box_around(vertices, 8), 0.0, 2.0);
    mesh.uv_projection = projection;
    std::copy(fit.begin(), fit.end(), mesh.object_to_projection);
    mesh.uv[0] = mesh.uv[1] = shd_f32_in{nullptr, 0};
  }
  Mesh made;
  check(shd_mesh_create(context, &mesh, made.out()), "mesh");
  return made;
}
