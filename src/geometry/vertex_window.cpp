// SPDX-License-Identifier: MIT
#include "geometry/vertex_window.h"

#include <algorithm>

#include "data/data.h"

namespace shd::geometry {
namespace {

struct IndexRange {
  uint32_t first, last;
};
IndexRange range_of(const uint32_t* indices, size_t count) {
  IndexRange range = {~0u, 0};
  for (size_t i = 0; i < count; ++i) {
    range.first = std::min(range.first, indices[i]);
    range.last = std::max(range.last, indices[i]);
  }
  return range;
}

}  // namespace

void allocate_window(const core::Allocator& allocator, const Mesh& mesh, size_t begin, size_t end,
                     uint32_t varying_count, Vertices* out) {
  const size_t corners = 3 * (end - begin), max_rows = data::padded(corners);
  if (data::padded(mesh.vertex_count) <= max_rows) return allocate(allocator, mesh, varying_count, out);
  out->indices = mesh.indices.data() + 3 * begin;
  out->first_triangle = static_cast<uint32_t>(begin);
  out->varying_count = varying_count;
  if (corners == 0) return;
  const IndexRange range = range_of(out->indices, corners);
  const size_t first = range.first / data::kRowPad * data::kRowPad;
  const size_t rows = data::padded(range.last + size_t{1}) - first;
  if (rows <= max_rows + data::kRowPad) {
    out->first_index = static_cast<uint32_t>(first);
    return allocate_rows(allocator, rows, varying_count, out);
  }
  allocate_rows(allocator, max_rows, varying_count, out);
  out->own_indices = core::Array<uint32_t>(allocator, corners);
  for (size_t i = 0; i < corners; ++i) {
    size_t row = i - i % 3;  // corners of a triangle with the same vertex share a row
    while (out->indices[row] != out->indices[i]) ++row;
    out->own_indices[i] = static_cast<uint32_t>(row);
  }
  out->corners = out->indices;
  out->indices = out->own_indices.data();
}

Mesh gather_corners(const core::Allocator& allocator, const Mesh& mesh, const Vertices& vertices, size_t begin,
                    size_t end) {
  const size_t filled = std::min(end, vertices.own_indices.size());
  const auto gather = [&](const core::Array<float>& from, core::Array<float>* to) {
    if (from.size() == 0) return;
    *to = core::Array<float>(allocator, end - begin);
    for (size_t row = begin; row < filled; ++row) (*to)[row - begin] = from[vertices.corners[row]];
    for (size_t row = std::max(begin, filled); row < end; ++row) (*to)[row - begin] = 0.0f;
  };
  Mesh out = {};
  out.vertex_count = static_cast<uint32_t>(filled - begin);
  gather(mesh.px, &out.px);
  gather(mesh.py, &out.py);
  gather(mesh.pz, &out.pz);
  gather(mesh.nx, &out.nx);
  gather(mesh.ny, &out.ny);
  gather(mesh.nz, &out.nz);
  gather(mesh.u, &out.u);
  gather(mesh.v, &out.v);
  gather(mesh.tx, &out.tx);
  gather(mesh.ty, &out.ty);
  gather(mesh.tz, &out.tz);
  gather(mesh.tw, &out.tw);
  gather(mesh.u1, &out.u1);
  gather(mesh.v1, &out.v1);
  for (int c = 0; c < SHD_MAX_ATTRIBUTES; ++c) gather(mesh.attribute[c], &out.attribute[c]);
  return out;
}

}  // namespace shd::geometry
