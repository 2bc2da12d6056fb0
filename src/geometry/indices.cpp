// SPDX-License-Identifier: MIT
#include "geometry/indices.h"

#include <cstring>

#include "core/status.h"
#include "data/column.h"

namespace shd::geometry {
namespace {

uint32_t load(const shd_u16_in& column, size_t i) {
  const size_t stride = column.stride ? column.stride : sizeof(uint16_t);
  uint16_t value;
  std::memcpy(&value, reinterpret_cast<const char*>(column.data) + i * stride, sizeof value);
  return value;
}

/// The caller's indices as numbers: 16-bit, 32-bit, or 0, 1, 2, ... if there are none.
struct Indices {
  const shd_mesh_desc& desc;
  size_t count;
  bool restarts;

  explicit Indices(const shd_mesh_desc& from)
      : desc(from),
        count(has_any(from) || from.index_count ? from.index_count : from.vertex_count),
        restarts(has_any(from) && from.topology != SHD_TOPOLOGY_TRIANGLES) {}

  uint32_t operator[](size_t i) const {
    if (desc.indices16.data) return load(desc.indices16, i);
    return desc.indices.data ? data::load(desc.indices, i) : static_cast<uint32_t>(i);
  }
  bool is_restart(uint32_t index) const { return restarts && index == (desc.indices16.data ? 0xffffu : 0xffffffffu); }

 private:
  static bool has_any(const shd_mesh_desc& desc) { return desc.indices.data || desc.indices16.data; }
};

/// Calls body(first, second, third) for every triangle; the arguments are positions in the list.
template <class Body>
void for_each_triangle(const Indices& indices, const Body& body) {
  if (indices.desc.topology == SHD_TOPOLOGY_TRIANGLES) {
    for (size_t i = 0; i < indices.count; i += 3) body(i, i + 1, i + 2);
    return;
  }
  const bool fan = indices.desc.topology == SHD_TOPOLOGY_FAN;
  size_t start = 0;
  for (size_t i = 0; i < indices.count; ++i) {
    if (indices.is_restart(indices[i])) {
      start = i + 1;
    } else if (i >= start + 2) {
      const bool odd = (i - start) % 2 != 0;
      body(fan ? start : i - 2, odd && !fan ? i : i - 1, odd && !fan ? i - 1 : i);
    }
  }
}

void require_in_range(const Indices& indices) {
  for (size_t i = 0; i < indices.count; ++i) {
    const uint32_t index = indices[i];
    if (index < indices.desc.vertex_count || indices.is_restart(index)) continue;
    core::refuse(SHD_ERROR_INVALID_ARGUMENT, "mesh.%s[%zu]: %u is not below vertex_count %zu",
                 indices.desc.indices16.data ? "indices16" : "indices", i, index, indices.desc.vertex_count);
  }
}

}  // namespace

void copy_indices(const core::Allocator& allocator, const shd_mesh_desc& desc, Mesh* out) {
  const Indices indices(desc);
  require_in_range(indices);
  size_t triangles = 0;
  for_each_triangle(indices, [&](size_t, size_t, size_t) { ++triangles; });
  out->triangle_count = static_cast<uint32_t>(triangles);
  out->indices = core::Array<uint32_t>(allocator, 3 * triangles);
  uint32_t* next = out->indices.data();
  for_each_triangle(indices, [&](size_t a, size_t b, size_t c) {
    *next++ = indices[a];
    *next++ = indices[b];
    *next++ = indices[c];
  });
}

}  // namespace shd::geometry
