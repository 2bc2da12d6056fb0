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

Corner corner(const geometry::Vertices& vertices, uint32_t row) {
  const float* world = &vertices.world[4 * size_t{row}];
  const float* normal = &vertices.normal[4 * size_t{row}];
  return {{world[0], world[1], world[2]}, {normal[0], normal[1], normal[2]}, world[3], normal[3]};
}

float varying(const geometry::Vertices& vertices, uint32_t row, uint32_t c) {
  return vertices.varying[size_t{vertices.varying_count} * row + c];
}

// In double, where neither sums nor products of floats over- or underflow.

float mean(float a, float b, float c) {
  return static_cast<float>((static_cast<double>(a) + static_cast<double>(b) + static_cast<double>(c)) / 3.0);
}

Vec3d widened(const Vec3& a) {
  return {double{a.x}, double{a.y}, double{a.z}};
}

/// Unit normal of a triangle, counter-clockwise = towards the viewer; 0 without area.
Vec3 face_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3d origin = widened(a), n = cross(widened(b) - origin, widened(c) - origin);
  const double length = data::length(n);
  if (!(length > 0.0)) return {0.0f, 0.0f, 0.0f};
  return {static_cast<float>(n.x / length), static_cast<float>(n.y / length), static_cast<float>(n.z / length)};
}

/// Component c of four at three vertices, in the shares of each; 0 where there are none.
float mixed(const core::Array<float>& rows, const uint32_t vertex[3], size_t c, int corner) {
  if (rows.size() == 0) return 0.0f;
  const auto at = [&](int k) { return rows[4 * size_t{vertex[k]} + c]; };
  return corner < 0 ? mean(at(0), at(1), at(2)) : at(corner);
}

/// What only some materials read.
/// @param corner  of the triangle; negative = its centroid
void set_extras(const geometry::Vertices& vertices, uint32_t triangle, int corner, size_t row,
                raster::Fragments* rows) {
  uint32_t vertex[3];
  for (size_t k = 0; k < 3; ++k) vertex[k] = geometry::row_of(vertices, triangle, k);
  float* const tangent[4] = {rows->tx, rows->ty, rows->tz, rows->tw};
  for (size_t c = 0; c < 4; ++c) tangent[c][row] = mixed(vertices.tangent, vertex, c, corner);
  rows->u1[row] = mixed(vertices.texture1, vertex, 0, corner);
  rows->v1[row] = mixed(vertices.texture1, vertex, 1, corner);
  for (size_t c = 0; c < SHD_MAX_ATTRIBUTES; ++c) {
    rows->attribute[c][row] = mixed(vertices.attribute[c / 4], vertex, c % 4, corner);
  }
}

void set_row(const Corner& c, const float eye[3], uint32_t triangle, size_t row, raster::Fragments* rows) {
  const Vec3 o = data::normalized(Vec3{eye[0], eye[1], eye[2]} - c.p);
  rows->triangle[row] = triangle;
  rows->px[row] = c.p.x;
  rows->py[row] = c.p.y;
  rows->pz[row] = c.p.z;
  rows->nx[row] = c.n.x;
  rows->ny[row] = c.n.y;
  rows->nz[row] = c.n.z;
  rows->ox[row] = o.x;
  rows->oy[row] = o.y;
  rows->oz[row] = o.z;
  rows->u[row] = c.u;
  rows->v[row] = c.v;
}

}  // namespace

void set_corners(const geometry::Vertices& vertices, const float eye[3], uint32_t triangle, size_t row,
                 raster::Fragments* rows) {
  for (size_t k = 0; k < 3; ++k) {
    set_row(corner(vertices, geometry::row_of(vertices, triangle, k)), eye, triangle, row + k, rows);
    set_extras(vertices, triangle, static_cast<int>(k), row + k, rows);
  }
}

void set_centroid(const geometry::Vertices& vertices, const float eye[3], float orientation, uint32_t triangle,
                  size_t row, raster::Fragments* rows) {
  const auto corner_of = [&](size_t k) { return corner(vertices, geometry::row_of(vertices, triangle, k)); };
  const Corner a = corner_of(0), b = corner_of(1), c = corner_of(2);
  const Vec3 normal = face_normal(a.p, b.p, c.p);
  const Corner centroid = {{mean(a.p.x, b.p.x, c.p.x), mean(a.p.y, b.p.y, c.p.y), mean(a.p.z, b.p.z, c.p.z)},
                           orientation * normal,
                           mean(a.u, b.u, c.u),
                           mean(a.v, b.v, c.v)};
  set_row(centroid, eye, triangle, row, rows);
  set_extras(vertices, triangle, -1, row, rows);
}

void set_corner_varyings(const geometry::Vertices& vertices, const shd_interpolation* modes,
                         const raster::Fragments& rows, raster::Varyings* out) {
  for (size_t row = 0; row < rows.count; ++row) {
    const uint32_t first = geometry::row_of(vertices, rows.triangle[row], 0);
    const uint32_t own = geometry::row_of(vertices, rows.triangle[row], row % 3);
    for (uint32_t c = 0; c < vertices.varying_count; ++c) {
      out->column[c][row] = varying(vertices, modes[c] == SHD_INTERPOLATION_FLAT ? first : own, c);
    }
  }
}

void set_centroid_varyings(const geometry::Vertices& vertices, const shd_interpolation* modes,
                           const raster::Fragments& rows, raster::Varyings* out) {
  for (size_t row = 0; row < rows.count; ++row) {
    uint32_t corner[3];
    for (size_t k = 0; k < 3; ++k) corner[k] = geometry::row_of(vertices, rows.triangle[row], k);
    for (uint32_t c = 0; c < vertices.varying_count; ++c) {
      const float first = varying(vertices, corner[0], c);
      const bool flat = modes[c] == SHD_INTERPOLATION_FLAT;
      out->column[c][row] =
          flat ? first : mean(first, varying(vertices, corner[1], c), varying(vertices, corner[2], c));
    }
  }
}

}  // namespace shd::shade
