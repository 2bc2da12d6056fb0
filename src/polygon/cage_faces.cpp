// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "polygon/cage.h"

namespace shd::polygon {
namespace {

/// Neighbours whose vertices lie closer to the plane of a triangle belong to its face.
constexpr double kCoplanar = 0x1p-21;

/// Distance of a vertex from a plane, positive outside.
double distance(const Cage& cage, const double* plane, uint32_t vertex) {
  const double* p = cage.doubles.position.data() + 3 * size_t{vertex};
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] - plane[3];
}

/// The plane of one triangle.
void triangle_plane(const Cage& cage, uint32_t t, double* out) {
  std::copy_n(&cage.doubles.normal[4 * size_t{t}], 3, out);
  out[3] = 0.0;
  out[3] = distance(cage, out, cage.triangle[t].vertex[0]);
}

/// Whether a triangle and its neighbour across edge i lie in one plane.
bool is_flat(const Cage& cage, uint32_t t, uint32_t i) {
  const CageTriangle& own = cage.triangle[t];
  const CageTriangle& other = cage.triangle[own.neighbor[i]];
  double plane[4];
  triangle_plane(cage, t, plane);
  for (const uint32_t vertex : other.vertex) {
    if (std::fabs(distance(cage, plane, vertex)) > kCoplanar) return false;
  }
  return true;
}

/// Numbers the faces: triangles that flat edges connect.
void number_planes(const core::Allocator& allocator, Cage* cage) {
  core::Array<uint32_t> stack(allocator, cage->triangle_count);
  const uint32_t none = cage->triangle_count;
  for (uint32_t t = 0; t < cage->triangle_count; ++t) cage->triangle[t].plane = none;
  for (uint32_t first = 0; first < cage->triangle_count; ++first) {
    if (cage->triangle[first].plane != none) continue;
    uint32_t depth = 0;
    stack[depth++] = first;
    cage->triangle[first].plane = cage->plane_count;
    while (depth > 0) {
      const uint32_t t = stack[--depth];
      for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t next = cage->triangle[t].neighbor[i];
        if (cage->triangle[next].plane != none) continue;
        if (!is_flat(*cage, t, i)) continue;
        cage->triangle[next].plane = cage->plane_count;
        stack[depth++] = next;
      }
    }
    ++cage->plane_count;
  }
}

/// Sets the planes of the faces: the means of normals and distances, by area.
void fit_planes(const core::Allocator& allocator, Cage* cage) {
  cage->plane = core::Array<double>(allocator, 4 * size_t{cage->plane_count});
  core::Array<double> area(allocator, cage->plane_count);
  cage->plane.fill_zero();
  area.fill_zero();
  for (uint32_t t = 0; t < cage->triangle_count; ++t) {
    const double* normal = &cage->doubles.normal[4 * size_t{t}];
    for (size_t c = 0; c < 3; ++c) cage->plane[4 * size_t{cage->triangle[t].plane} + c] += normal[c] / normal[3];
  }
  for (uint32_t p = 0; p < cage->plane_count; ++p) {
    double* plane = &cage->plane[4 * size_t{p}];
    const double length = std::sqrt(plane[0] * plane[0] + plane[1] * plane[1] + plane[2] * plane[2]);
    for (size_t c = 0; c < 3; ++c) plane[c] /= length;
  }
  for (uint32_t t = 0; t < cage->triangle_count; ++t) {
    const uint32_t p = cage->triangle[t].plane;
    double plane[4];
    std::copy_n(&cage->plane[4 * size_t{p}], 3, plane);
    plane[3] = 0.0;
    const double twice = 1.0 / cage->doubles.normal[4 * size_t{t} + 3];
    area[p] += twice;
    for (const uint32_t v : cage->triangle[t].vertex)
      cage->plane[4 * size_t{p} + 3] += distance(*cage, plane, v) * twice / 3.0;
  }
  for (uint32_t p = 0; p < cage->plane_count; ++p) cage->plane[4 * size_t{p} + 3] /= area[p];
}

/// Whether each face lies in a plane and all vertices behind it.
CageFlaw check_planes(const Cage& cage) {
  for (uint32_t t = 0; t < cage.triangle_count; ++t) {
    const double* plane = &cage.plane[4 * size_t{cage.triangle[t].plane}];
    for (const uint32_t v : cage.triangle[t].vertex) {
      if (std::fabs(distance(cage, plane, v)) > 2.0 * kCoplanar) return {CageFlaw::kCurved, t, v, 0};
    }
  }
  for (uint32_t t = 0; t < cage.triangle_count; ++t) {
    const double* plane = &cage.plane[4 * size_t{cage.triangle[t].plane}];
    for (uint32_t v = 0; v < cage.vertex_count; ++v) {
      if (distance(cage, plane, v) > 2.0 * kCoplanar) return {CageFlaw::kReflex, v, t, 0};
    }
  }
  return {CageFlaw::kNone, 0, 0, 0};
}

/// det(n_a, n_b, n_c) of three planes; rounding leaves no negative value.
double determinant(const Cage& cage, uint32_t a, uint32_t b, uint32_t c) {
  const double *p = &cage.plane[4 * size_t{a}], *q = &cage.plane[4 * size_t{b}], *r = &cage.plane[4 * size_t{c}];
  const double value =
      p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  return std::max(value, 0.0);
}

uint32_t corner_of(const CageTriangle& triangle, uint32_t vertex) {
  return triangle.vertex[0] == vertex ? 0 : triangle.vertex[1] == vertex ? 1 : 2;
}

/// Writes the faces around a vertex from a triangle on. Returns their number.
uint32_t walk(const Cage& cage, uint32_t vertex, uint32_t first, uint32_t* planes) {
  uint32_t count = 0, t = first;
  do {
    const CageTriangle& triangle = cage.triangle[t];
    if (count == 0 || planes[count - 1] != triangle.plane) planes[count++] = triangle.plane;
    t = triangle.neighbor[(corner_of(triangle, vertex) + 1) % 3];
  } while (t != first);
  while (count > 1 && planes[count - 1] == planes[0]) --count;
  return count;
}

}  // namespace

CageFlaw make_faces(const core::Allocator& allocator, Cage* cage) {
  number_planes(allocator, cage);
  fit_planes(allocator, cage);
  const CageFlaw flaw = check_planes(*cage);
  if (flaw.kind != CageFlaw::kNone) return flaw;
  core::Array<uint32_t> start(allocator, cage->vertex_count);
  for (uint32_t t = 0; t < cage->triangle_count; ++t) {
    for (const uint32_t v : cage->triangle[t].vertex) start[v] = t;
  }
  cage->fan_start = core::Array<uint32_t>(allocator, size_t{cage->vertex_count} + 1);
  cage->fan_plane = core::Array<uint32_t>(allocator, 3 * size_t{cage->triangle_count});
  cage->fan_volume = core::Array<double>(allocator, 3 * size_t{cage->triangle_count});
  uint32_t next = 0;
  for (uint32_t v = 0; v < cage->vertex_count; ++v) {
    uint32_t* planes = &cage->fan_plane[next];
    const uint32_t count = walk(*cage, v, start[v], planes);
    double sum = 0.0;
    for (uint32_t j = 0; j < count; ++j) {
      const bool has_next = j > 0 && j + 1 < count;
      cage->fan_volume[next + j] = has_next ? determinant(*cage, planes[0], planes[j], planes[j + 1]) : 0.0;
      sum += cage->fan_volume[next + j];
    }
    if (!(sum > 0.0)) return {CageFlaw::kNoCorner, v, 0, 0};
    cage->fan_start[v] = next;
    next += count;
  }
  cage->fan_start[cage->vertex_count] = next;
  return {CageFlaw::kNone, 0, 0, 0};
}

}  // namespace shd::polygon
