// SPDX-License-Identifier: MIT
#include <shd/edges.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "data/column.h"
#include "geometry/edges.h"
#include "geometry/feature_edges.h"

namespace {

using namespace shd;
using namespace shd::abi;

shd_result check_edges_desc(const shd_edges_desc& desc) {
  SHD_TRY(check_flags("edges.edges", desc.edges, SHD_EDGE_ALL));
  SHD_TRY(check_finite("edges.eye", desc.eye, 4));
  if (desc.eye[0] == 0.0f && desc.eye[1] == 0.0f && desc.eye[2] == 0.0f && desc.eye[3] == 0.0f) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "edges.eye: 0 is neither a point nor a direction");
  }
  return check_range("edges.crease_cosine", static_cast<double>(desc.crease_cosine), -1.0, 1.0);
}

shd_result check_edge_columns(const shd_edges& out, size_t capacity) {
  SHD_TRY(check_column("out.vertex[0]", out.vertex[0], capacity));
  SHD_TRY(check_column("out.vertex[1]", out.vertex[1], capacity));
  SHD_TRY(check_column("out.triangle[0]", out.triangle[0], capacity));
  SHD_TRY(check_column("out.triangle[1]", out.triangle[1], capacity));
  return check_column("out.kinds", out.kinds, capacity);
}

void store_wanted(const shd_u32_out& column, size_t i, uint32_t value) {
  if (column.data) data::store(column, i, value);
}

void store_edge(const geometry::Mesh& mesh, size_t triangle, size_t k, uint32_t kinds, size_t row,
                const shd_edges& out) {
  const uint32_t *corner = &mesh.indices[3 * triangle], across = mesh.across[3 * triangle + k];
  store_wanted(out.vertex[0], row, corner[k]);
  store_wanted(out.vertex[1], row, corner[k == 2 ? 0 : k + 1]);
  store_wanted(out.triangle[0], row, static_cast<uint32_t>(triangle));
  store_wanted(out.triangle[1], row, geometry::is_triangle(across) ? geometry::triangle_of(across) : ~0u);
  store_wanted(out.kinds, row, kinds);
}

}  // namespace

extern "C" shd_result shd_mesh_find_edges(const shd_mesh* mesh, const shd_edges_desc* desc, size_t capacity,
                                          const shd_edges* out, size_t* out_count) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_count", out_count));
    *out_count = 0;
    const geometry::Mesh* body = nullptr;
    SHD_TRY(read_handle("mesh", mesh, core::ObjectType::kMesh, &body));
    if (!body->has_adjacency) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "mesh: made without SHD_MESH_ADJACENCY");
    }
    shd_edges_desc read = shd_edges_desc_default();
    SHD_TRY(read_desc("edges", desc, false, &read));
    SHD_TRY(check_edges_desc(read));
    shd_edges columns = shd_edges_default();
    SHD_TRY(read_desc("out", out, capacity == 0, &columns));
    SHD_TRY(check_edge_columns(columns, capacity));
    const geometry::EdgeQuery query = {
        read.edges,
        static_cast<double>(read.crease_cosine),
        {double{read.eye[0]}, double{read.eye[1]}, double{read.eye[2]}, double{read.eye[3]}}};
    size_t count = 0;
    for (size_t t = 0; t < body->triangle_count; ++t) {
      uint32_t kinds[3];
      geometry::find_edge_kinds(*body, query, t, kinds);
      for (size_t k = 0; k < 3; ++k) {
        if (kinds[k] && count < capacity) store_edge(*body, t, k, kinds[k], count, columns);
        count += kinds[k] != 0;
      }
    }
    *out_count = count;
    return SHD_OK;
  });
}
