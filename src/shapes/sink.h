// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>

#include <shd/column.h>

#include "data/column.h"
#include "data/vec3.h"

namespace shd::shapes {

using data::Vec3d;

/// The caller's columns, and the next element to write. Absent columns are skipped.
struct Sink {
  shd_f32_out position[3], normal[3], uv[2];
  shd_u32_out indices;
  uint32_t vertex = 0;
  size_t index = 0;
};

inline void put(const shd_f32_out& column, size_t row, double value) {
  if (column.data) data::store(column, row, static_cast<float>(value));
}

inline void put(const shd_f32_out (&columns)[3], size_t row, const Vec3d& value) {
  put(columns[0], row, value.x);
  put(columns[1], row, value.y);
  put(columns[2], row, value.z);
}

/// The normal has unit length up to the rounding of double.
inline void add_vertex(Sink& out, const Vec3d& position, const Vec3d& normal, double u, double v) {
  put(out.position, out.vertex, position);
  put(out.normal, out.vertex, normal);
  put(out.uv[0], out.vertex, u);
  put(out.uv[1], out.vertex, v);
  ++out.vertex;
}

/// Counter-clockwise seen from outside.
inline void add_triangle(Sink& out, uint32_t a, uint32_t b, uint32_t c) {
  for (const uint32_t corner : {a, b, c}) {
    if (out.indices.data) data::store(out.indices, out.index, corner);
    ++out.index;
  }
}

}  // namespace shd::shapes
