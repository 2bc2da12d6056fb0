// SPDX-License-Identifier: MIT
#include "shade/frequency.h"

#include <cmath>

#include "data/vec3.h"

namespace shd::shade {
namespace {

using data::Vec3;
using data::Vec3d;

/// A transformed vertex.
struct Corner {
  Vec3 p, n;
  float u, v;
};

Corner corner(const geometry::Vertices& vertices, uint32_t vertex) {
  const float* world = &vertices.world[4 * size_t{vertex}];
  const float* normal = &vertices.normal[4 * size_t{vertex}];
  return {{world[0], world[1], world[2]},
          {normal[0], normal[1], normal[2]},
          geometry::u_of(vertices)[vertex],
          geometry::v_of(vertices)[vertex]};
}

float varying(const geometry::Vertices& vertices, uint32_t vertex, uint32_t c) {
  return vertices.varying[size_t{vertices.varying_count} * vertex + c];
}

// The sum is computed in double, where sums and products of floats neither overflow nor underflow.

float mean(float a, float b, float c) {
  return static_cast<float>((static_cast<double>(a) + static_cast<double>(b) + static_cast<double>(c)) / 3.0);
}

Vec3d widened(const Vec3& a) {
  return {double{a.x}, double{a.y}, double{a.z}};
}

/// Unit normal of a triangle whose corners are counter-clockwise for the viewer; 0 without area.
Vec3 face_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3d origin = widened(a), n = cross(widened(b) - origin, widened(c) - origin);
  const double length = data::length(n);
  if (!(length > 0.0)) return {0.0f, 0.0f, 0.0f};
  return {static_cast<float>(n.x / length), static_cast<float>(n.y / length), static_cast<float>(n.z / length)};
}

/// Component c of rows of four, at a corner or averaged over the triangle; 0 if the vertices have no such values.
float mixed(const core::Array<float>& values, const uint32_t vertex[3], size_t c, int corner) {
  if (values.size() == 0) return 0.0f;
  const auto at = [&](int k) { return values[4 * size_t{vertex[k]} + c]; };
  return corner < 0 ? mean(at(0), at(1), at(2)) : at(corner);
}

/// Sets the columns that only some materials read.
/// @param corner  corner of the triangle; negative = its centroid
void set_extras(const geometry::Vertices& vertices, uint32_t triangle, int corner, size_t point,
                raster::Fragments* points) {
  uint32_t vertex[3];
  for (size_t k = 0; k < 3; ++k) vertex[k] = geometry::row_of(vertices, triangle, k);
  float* const tangent[4] = {points->tx, points->ty, points->tz, points->tw};
  for (size_t c = 0; c < 4; ++c) tangent[c][point] = mixed(vertices.tangent, vertex, c, corner);
  points->u1[point] = mixed(vertices.texture1, vertex, 0, corner);
  points->v1[point] = mixed(vertices.texture1, vertex, 1, corner);
  for (size_t c = 0; c < SHD_MAX_ATTRIBUTES; ++c) {
    points->attribute[c][point] = mixed(vertices.attribute[c / 4], vertex, c % 4, corner);
  }
}

void set_point(const Corner& c, const float eye[3], uint32_t triangle, size_t point, raster::Fragments* points) {
  const Vec3 o = data::normalized(Vec3{eye[0], eye[1], eye[2]} - c.p);
  points->triangle[point] = triangle;
  points->px[point] = c.p.x;
  points->py[point] = c.p.y;
  points->pz[point] = c.p.z;
  points->nx[point] = c.n.x;
  points->ny[point] = c.n.y;
  points->nz[point] = c.n.z;
  points->ox[point] = o.x;
  points->oy[point] = o.y;
  points->oz[point] = o.z;
  points->u[point] = c.u;
  points->v[point] = c.v;
}

}  // namespace

void set_corners(const geometry::Vertices& vertices, const float eye[3], uint32_t triangle, size_t point,
                 raster::Fragments* points) {
  for (size_t k = 0; k < 3; ++k) {
    set_point(corner(vertices, geometry::row_of(vertices, triangle, k)), eye, triangle, point + k, points);
    set_extras(vertices, triangle, static_cast<int>(k), point + k, points);
  }
}

void set_centroid(const geometry::Vertices& vertices, const float eye[3], float orientation, uint32_t triangle,
                  size_t point, raster::Fragments* points) {
  const auto corner_of = [&](size_t k) { return corner(vertices, geometry::row_of(vertices, triangle, k)); };
  const Corner a = corner_of(0), b = corner_of(1), c = corner_of(2);
  const Vec3 normal = face_normal(a.p, b.p, c.p);
  const Corner centroid = {{mean(a.p.x, b.p.x, c.p.x), mean(a.p.y, b.p.y, c.p.y), mean(a.p.z, b.p.z, c.p.z)},
                           orientation * normal,
                           mean(a.u, b.u, c.u),
                           mean(a.v, b.v, c.v)};
  set_point(centroid, eye, triangle, point, points);
  set_extras(vertices, triangle, -1, point, points);
}

void set_corner_varyings(const geometry::Vertices& vertices, const shd_interpolation* modes,
                         const raster::Fragments& points, raster::Varyings* out) {
  for (size_t point = 0; point < points.count; ++point) {
    const uint32_t first = geometry::row_of(vertices, points.triangle[point], 0);
    const uint32_t own = geometry::row_of(vertices, points.triangle[point], point % 3);
    for (uint32_t c = 0; c < vertices.varying_count; ++c) {
      out->column[c][point] = varying(vertices, modes[c] == SHD_INTERPOLATION_FLAT ? first : own, c);
    }
  }
}

void set_centroid_varyings(const geometry::Vertices& vertices, const shd_interpolation* modes,
                           const raster::Fragments& points, raster::Varyings* out) {
  for (size_t point = 0; point < points.count; ++point) {
    uint32_t corner[3];
    for (size_t k = 0; k < 3; ++k) corner[k] = geometry::row_of(vertices, points.triangle[point], k);
    for (uint32_t c = 0; c < vertices.varying_count; ++c) {
      const float first = varying(vertices, corner[0], c);
      const bool flat = modes[c] == SHD_INTERPOLATION_FLAT;
      out->column[c][point] =
          flat ? first : mean(first, varying(vertices, corner[1], c), varying(vertices, corner[2], c));
    }
  }
}

}  // namespace shd::shade
