// SPDX-License-Identifier: MIT
/// @file
/// Cuts a parallelogram in space into the unit cells of a lattice and finds the moments of every piece, for integrals
/// of functions that are linear along each axis of a cell. Pieces are polygons of the parameters (s, t), whose domain
/// is a unit square for every parallelogram: lines and points need no rule of their own. Arithmetic is + - * / and
/// floor on doubles only, so every machine computes the same bits.
#pragma once

#include <cmath>
#include <cstdint>

#include "texture/domain/parallelogram.h"

namespace shd::texture {

struct Vec3 : Vec2 {
  double z;
};

/// Integrals of 1, x, y, z and their products over a piece of the square of parameters.
struct SpaceMoments {
  double one = 0, x = 0, y = 0, z = 0, xy = 0, xz = 0, yz = 0, xyz = 0;
};

/// A coordinate of the parallelogram: middle + a s + b t.
struct Coordinate {
  double middle, a, b;

  double at(Vec2 p) const { return middle + (a * p.x + b * p.y); }
  Interval over(const Polygon& polygon) const {
    Interval out;
    for (size_t i = 0; i < polygon.count; ++i) out.add(at(polygon.corner[i]));
    return out;
  }
  /// Returns the coordinate within cell `cell`, 0..1, of a point that lies there within rounding errors.
  double within(Vec2 p, double cell) const {
    const double x = at(p) - cell;
    return x < 0 ? 0 : x > 1 ? 1 : x;
  }
};

/// Returns the part of a polygon where a coordinate is at least (sign = 1) or at most (sign = -1) a bound.
inline Polygon cut(const Polygon& polygon, const Coordinate& coordinate, double bound, double sign) {
  Polygon out;
  for (size_t i = 0; i < polygon.count; ++i) {
    const Vec2 from = polygon.corner[i], to = polygon.corner[i + 1 < polygon.count ? i + 1 : 0];
    const double d0 = sign * (coordinate.at(from) - bound), d1 = sign * (coordinate.at(to) - bound);
    if (d0 >= 0) out.add(from);
    if ((d0 >= 0) == (d1 >= 0)) continue;
    const double s = d0 / (d0 - d1);
    out.add({from.x + s * (to.x - from.x), from.y + s * (to.y - from.y)});
  }
  return out;
}

/// Calls body(k, part) for the part of a polygon in each interval [k, k + 1] of a coordinate.
template <class Body>
void visit_slabs(const Polygon& polygon, const Coordinate& coordinate, const Body& body) {
  const Interval extent = coordinate.over(polygon);
  if (polygon.count < 3) return;
  const auto first = static_cast<int64_t>(std::floor(extent.low));
  const auto end = -static_cast<int64_t>(std::floor(-extent.high));
  if (end <= first + 1) return body(first, polygon);
  Polygon rest = polygon;
  for (int64_t k = first; k < end - 1; ++k) {
    const auto bound = static_cast<double>(k + 1);
    body(k, cut(rest, coordinate, bound, -1));
    rest = cut(rest, coordinate, bound, 1);
  }
  body(end - 1, rest);
}

/// Returns the moments of a polygon about cell (i, j, k), by triangles. The mean of a product of three linear functions
/// over a triangle is a sum of products of their corner values, because the mean of l1^p l2^q l3^r over barycentric
/// coordinates is 2 p! q! r! / (p + q + r + 2)! (Eisenberg and Malvern, "On Finite Element Integration in Natural
/// Co-ordinates", 1973).
inline SpaceMoments space_moments(const Polygon& polygon, const Coordinate (&axes)[3], const double (&cell)[3]) {
  SpaceMoments m;
  const auto corner = [&](size_t i, double(&at)[3]) {
    for (size_t a = 0; a < 3; ++a) at[a] = axes[a].within(polygon.corner[i], cell[a]);
  };
  double p[3], q[3], r[3];
  corner(0, p);
  if (polygon.count > 1) corner(1, q);
  for (size_t i = 2; i < polygon.count; ++i) {
    corner(i, r);
    const Vec2 first = polygon.corner[0], left = polygon.corner[i - 1], right = polygon.corner[i];
    const double area = 0.5 * cross({left.x - first.x, left.y - first.y}, {right.x - first.x, right.y - first.y});
    const auto sum = [&](size_t a) { return p[a] + q[a] + r[a]; };
    const auto product = [&](size_t a, size_t b) { return p[a] * p[b] + q[a] * q[b] + r[a] * r[b]; };
    const double x = sum(0), y = sum(1), z = sum(2), xy = product(0, 1), xz = product(0, 2), yz = product(1, 2);
    const double xyz = p[0] * p[1] * p[2] + q[0] * q[1] * q[2] + r[0] * r[1] * r[2];
    m.one += area;
    m.x += area * x / 3;
    m.y += area * y / 3;
    m.z += area * z / 3;
    m.xy += area * (x * y + xy) / 12;
    m.xz += area * (x * z + xz) / 12;
    m.yz += area * (y * z + yz) / 12;
    m.xyz += area * (x * y * z + x * yz + y * xz + z * xy + 2 * xyz) / 60;
    for (size_t a = 0; a < 3; ++a) q[a] = r[a];
  }
  return m;
}

/// Visits the cells of the parallelogram center + s a + t b, |s|, |t| <= 1/2. Calls visitor.cell(i, j, k, moments) for
/// each cell [i, i + 1] x [j, j + 1] x [k, k + 1] that it crosses, with the moments about (i, j, k). The areas of all
/// pieces have the sum 1. It visits at most cell_bound() cells.
template <class Visitor>
void visit_cells_in_space(const Vec3& center, const Vec3& a, const Vec3& b, Visitor* visitor) {
  const Coordinate axes[3] = {{center.x, a.x, b.x}, {center.y, a.y, b.y}, {center.z, a.z, b.z}};
  visit_slabs(parallelogram({0, 0}, {1, 0}, {0, 1}), axes[2], [&](int64_t k, const Polygon& slab) {
    visit_slabs(slab, axes[1], [&](int64_t j, const Polygon& bar) {
      visit_slabs(bar, axes[0], [&](int64_t i, const Polygon& piece) {
        const double cell[3] = {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
        const SpaceMoments m = space_moments(piece, axes, cell);
        if (m.one > 0) visitor->cell(i, j, k, m);
      });
    });
  });
}

/// Returns the sum of the areas of the images of a parallelogram on the planes of two axes.
inline double area_bound(const Vec3& a, const Vec3& b) {
  const double beside = std::fabs(a.x * b.z - a.z * b.x) + std::fabs(a.y * b.z - a.z * b.y);
  return std::fabs(cross(a, b)) + beside;
}

/// Returns an upper bound of the number of cells that visit_cells_in_space() visits for sides a and b. The lattice cuts
/// the parallelogram into at most 1 + lines + crossings pieces. An axis has at most its extent + 1 lines. Lines of two
/// axes cross at most as often as the lattice has points in the parallelogram's image on their plane: at most its area
/// + half its outline + 1 (Nosarzewska, "Evaluation de la difference entre l'aire d'une region plane convexe et le
/// nombre des points aux coordonnees entieres couverts par elle", 1948). The bound of a parallelogram in the plane of x
/// and y is that of 2D.
inline double cell_bound(const Vec3& a, const Vec3& b) {
  const double extent = std::fabs(a.x) + std::fabs(b.x) + std::fabs(a.y) + std::fabs(b.y);
  return area_bound(a, b) + 4 * (extent + (std::fabs(a.z) + std::fabs(b.z))) + 16;
}

}  // namespace shd::texture
