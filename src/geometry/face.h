// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include "data/vec3.h"
#include "geometry/mesh.h"

namespace shd::geometry {

inline data::Vec3d position(const Mesh& mesh, size_t vertex) {
  return {double{mesh.px[vertex]}, double{mesh.py[vertex]}, double{mesh.pz[vertex]}};
}
inline data::Vec3d vertex_normal(const Mesh& mesh, size_t vertex) {
  return {double{mesh.nx[vertex]}, double{mesh.ny[vertex]}, double{mesh.nz[vertex]}};
}

/// Normal of a triangle, counter-clockwise around it; its length is twice the area.
inline data::Vec3d area_vector(const Mesh& mesh, size_t triangle) {
  const uint32_t* corner = &mesh.indices[3 * triangle];
  const data::Vec3d a = position(mesh, corner[0]);
  return data::cross(position(mesh, corner[1]) - a, position(mesh, corner[2]) - a);
}

/// Whether a triangle has an area; a triangle with a non-finite corner has none.
inline bool is_face(const Mesh& mesh, size_t triangle) {
  const data::Vec3d n = area_vector(mesh, triangle);
  const double square = data::dot(n, n);
  return square > 0.0 && std::isfinite(square);
}

}  // namespace shd::geometry
