// SPDX-License-Identifier: MIT
#include "polygon/cage.h"

#include <algorithm>
#include <cmath>

#include "data/column.h"

namespace shd::polygon {
namespace {

/// Triangles whose twice the area is below this part of the square of their longest edge have no area.
constexpr double kThin = 1e-10;
/// Volumes below this part of the cube of half the longest side are flat.
constexpr double kFlat = 1e-12;

struct Vec {
  double x, y, z;
};
Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec at(const Cage& cage, uint32_t vertex) {
  const double* p = cage.doubles.position.data() + 3 * size_t{vertex};
  return {p[0], p[1], p[2]};
}

/// Sets the positions, and the map to [-1, 1].
void normalise(const shd_polyhedron_desc& desc, Cage* cage) {
  double half = 0.0;
  for (int c = 0; c < 3; ++c) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t i = 0; i < desc.vertex_count; ++i) {
      const double value = double{data::load(desc.position[c], i)};
      low = std::min(low, value);
      high = std::max(high, value);
    }
    cage->center[c] = 0.5 * (low + high);
    half = std::max(half, 0.5 * (high - low));
  }
  int exponent = 0;
  std::frexp(half, &exponent);
  cage->scale = std::ldexp(1.0, -exponent);
  cage->longest = 2.0 * half * cage->scale;
  for (size_t i = 0; i < desc.vertex_count; ++i) {
    for (int c = 0; c < 3; ++c) {
      const double value = double{data::load(desc.position[c], i)};
      cage->doubles.position[3 * i + static_cast<size_t>(c)] = (value - cage->center[c]) * cage->scale;
    }
  }
}

CageFlaw read_triangles(const shd_polyhedron_desc& desc, Cage* cage) {
  for (uint32_t t = 0; t < cage->triangle_count; ++t) {
    uint32_t(&vertex)[3] = cage->triangle[t].vertex;
    for (uint32_t i = 0; i < 3; ++i) {
      vertex[i] = data::load(desc.indices, 3 * size_t{t} + i);
      if (vertex[i] >= cage->vertex_count) return {CageFlaw::kIndex, 3 * t + i, vertex[i], cage->vertex_count - 1};
    }
    for (uint32_t i = 0; i < 3; ++i) {
      if (vertex[i] == vertex[(i + 1) % 3]) return {CageFlaw::kTwice, t, vertex[i], 0};
    }
    const Vec a = at(*cage, vertex[0]), b = at(*cage, vertex[1]), c = at(*cage, vertex[2]);
    const Vec area = cross(b - a, c - a);
    const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    if (!(dot(area, area) > kThin * kThin * longest * longest)) return {CageFlaw::kThin, t, 0, 0};
  }
  return {CageFlaw::kNone, 0, 0, 0};
}

CageFlaw find_unused(const core::Allocator& allocator, const Cage& cage) {
  core::Array<bool> is_used(allocator, cage.vertex_count);
  is_used.fill_zero();
  for (uint32_t t = 0; t < cage.triangle_count; ++t) {
    for (const uint32_t vertex : cage.triangle[t].vertex) is_used[vertex] = true;
  }
  for (uint32_t v = 0; v < cage.vertex_count; ++v) {
    if (!is_used[v]) return {CageFlaw::kUnused, v, 0, 0};
  }
  return {CageFlaw::kNone, 0, 0, 0};
}

/// A side of a triangle.
struct Side {
  uint32_t low, high;  // its vertices
  uint32_t triangle, corner;
  bool is_rising;  // runs from low to high
};

/// Turns a triangle by its corners.
void turn_corners(uint32_t by, CageTriangle* triangle) {
  for (uint32_t(*part)[3] : {&triangle->vertex, &triangle->edge, &triangle->neighbor}) {
    std::rotate(*part, *part + by, *part + 3);
  }
}

/// Numbers the edges in the order in which triangles use them first, and turns triangles so that their new edges come
/// first. Until then the numbers of edges are those of their pairs of sides.
void number_edges(const core::Allocator& allocator, Cage* cage) {
  cage->edge = core::Array<CageEdge>(allocator, cage->edge_count);
  core::Array<uint32_t> numbers(allocator, cage->edge_count);
  const uint32_t none = cage->edge_count;
  std::fill(numbers.begin(), numbers.end(), none);
  uint32_t next = 0;
  for (uint32_t t = 0; t < cage->triangle_count; ++t) {
    CageTriangle& triangle = cage->triangle[t];
    const auto is_new = [&](uint32_t i) { return numbers[triangle.edge[i]] == none; };
    triangle.new_edges = uint32_t{is_new(0)} + is_new(1) + is_new(2);
    for (uint32_t i = 0; i < 3; ++i) {
      if (is_new(i) && (triangle.new_edges == 3 || !is_new((i + 2) % 3))) {
        turn_corners(i, &triangle);
        break;
      }
    }
    for (uint32_t i = 0; i < 3; ++i) {
      if (is_new(i)) {
        cage->edge[next] = {triangle.vertex[(i + 1) % 3], triangle.vertex[(i + 2) % 3], t};
        numbers[triangle.edge[i]] = next++;
      }
      triangle.edge[i] = numbers[triangle.edge[i]];
    }
  }
}

/// Pairs the sides of triangles to edges.
CageFlaw connect(const core::Allocator& allocator, Cage* cage) {
  const uint32_t count = 3 * cage->triangle_count;
  core::Array<Side> sides(allocator, count);
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t t = k / 3, i = k % 3;
    const uint32_t from = cage->triangle[t].vertex[(i + 1) % 3], to = cage->triangle[t].vertex[(i + 2) % 3];
    sides[k] = {std::min(from, to), std::max(from, to), t, i, from < to};
  }
  const auto key = [](const Side& s) { return uint64_t{s.low} << 32 | s.high; };
  std::sort(sides.begin(), sides.end(),
            [&](const Side& a, const Side& b) { return key(a) != key(b) ? key(a) < key(b) : a.triangle < b.triangle; });
  for (uint32_t k = 0; k < count;) {
    uint32_t end = k + 1;
    while (end < count && key(sides[end]) == key(sides[k])) ++end;
    if (end - k != 2) return {CageFlaw::kOpen, sides[k].low, sides[k].high, end - k};
    k = end;
  }
  for (uint32_t k = 0; k < count; k += 2) {
    const Side &first = sides[k], &second = sides[k + 1];
    if (first.is_rising == second.is_rising) return {CageFlaw::kTurned, first.low, first.high, 0};
    CageTriangle &a = cage->triangle[first.triangle], &b = cage->triangle[second.triangle];
    a.edge[first.corner] = b.edge[second.corner] = k / 2;
    a.neighbor[first.corner] = second.triangle;
    b.neighbor[second.corner] = first.triangle;
  }
  cage->edge_count = count / 2;
  number_edges(allocator, cage);
  return {CageFlaw::kNone, 0, 0, 0};
}

double volume(const Cage& cage) {
  double sum = 0.0;
  for (uint32_t t = 0; t < cage.triangle_count; ++t) {
    const uint32_t(&v)[3] = cage.triangle[t].vertex;
    sum += dot(at(cage, v[0]), cross(at(cage, v[1]), at(cage, v[2])));
  }
  return sum / 6.0;
}

/// Makes the triangles counter-clockwise from outside.
void turn_outward(Cage* cage) {
  for (uint32_t t = 0; t < cage->triangle_count; ++t) {
    std::swap(cage->triangle[t].vertex[1], cage->triangle[t].vertex[2]);
  }
}

void measure(const core::Allocator& allocator, Cage* cage) {
  cage->doubles.along = core::Array<double>(allocator, 3 * size_t{cage->edge_count});
  for (uint32_t e = 0; e < cage->edge_count; ++e) {
    const Vec along = at(*cage, cage->edge[e].to) - at(*cage, cage->edge[e].from);
    double* to = &cage->doubles.along[3 * size_t{e}];
    to[0] = along.x, to[1] = along.y, to[2] = along.z;
  }
  cage->doubles.normal = core::Array<double>(allocator, 4 * size_t{cage->triangle_count});
  for (uint32_t t = 0; t < cage->triangle_count; ++t) {
    const uint32_t(&v)[3] = cage->triangle[t].vertex;
    const Vec a = at(*cage, v[0]), area = cross(at(*cage, v[1]) - a, at(*cage, v[2]) - a);
    const double inverse = 1.0 / std::sqrt(dot(area, area));
    double* to = &cage->doubles.normal[4 * size_t{t}];
    to[0] = area.x * inverse, to[1] = area.y * inverse, to[2] = area.z * inverse, to[3] = inverse;
  }
}

/// Rounds a table to floats.
core::Array<float> to_floats(const core::Allocator& allocator, const core::Array<double>& from) {
  core::Array<float> out(allocator, from.size());
  for (size_t i = 0; i < from.size(); ++i) out[i] = static_cast<float>(from[i]);
  return out;
}

}  // namespace

CageFlaw make_cage(const core::Allocator& allocator, const shd_polyhedron_desc& desc, Cage* cage) {
  cage->vertex_count = static_cast<uint32_t>(desc.vertex_count);
  cage->triangle_count = static_cast<uint32_t>(desc.index_count / 3);
  cage->plane_count = 0;
  cage->doubles.position = core::Array<double>(allocator, 3 * size_t{cage->vertex_count});
  cage->triangle = core::Array<CageTriangle>(allocator, cage->triangle_count);
  normalise(desc, cage);
  CageFlaw flaw = read_triangles(desc, cage);
  if (flaw.kind == CageFlaw::kNone) flaw = find_unused(allocator, *cage);
  if (flaw.kind != CageFlaw::kNone) return flaw;
  const double enclosed = volume(*cage);
  if (enclosed < 0.0) turn_outward(cage);
  flaw = connect(allocator, cage);
  if (flaw.kind != CageFlaw::kNone) return flaw;
  if (!(std::fabs(enclosed) > kFlat)) return {CageFlaw::kFlat, 0, 0, 0};
  measure(allocator, cage);
  const CageTables<double>& from = cage->doubles;
  cage->floats.position = to_floats(allocator, from.position);
  cage->floats.along = to_floats(allocator, from.along);
  cage->floats.normal = to_floats(allocator, from.normal);
  return {CageFlaw::kNone, 0, 0, 0};
}

SurfacePoint nearest_on_triangle(const Cage& cage, uint32_t triangle, const double (&point)[3]) {
  const uint32_t(&v)[3] = cage.triangle[triangle].vertex;
  const Vec x = {point[0], point[1], point[2]};
  const Vec s[3] = {at(cage, v[0]) - x, at(cage, v[1]) - x, at(cage, v[2]) - x};
  const double* n = &cage.doubles.normal[4 * size_t{triangle}];
  const Vec normal = {n[0], n[1], n[2]};
  double area[3], sum = 0.0;
  bool is_inside = true;
  for (size_t i = 0; i < 3; ++i) {
    area[i] = dot(normal, cross(s[(i + 1) % 3], s[(i + 2) % 3]));
    is_inside = is_inside && area[i] >= 0.0;
    sum += area[i];
  }
  if (is_inside) return {triangle, {area[0] / sum, area[1] / sum, area[2] / sum}};
  SurfacePoint nearest = {triangle, {1.0, 0.0, 0.0}};
  double least = HUGE_VAL;
  for (size_t i = 0; i < 3; ++i) {
    const size_t k = (i + 1) % 3;
    const Vec along = s[k] - s[i];
    const double t = std::min(std::max(-dot(s[i], along) / dot(along, along), 0.0), 1.0);
    const Vec apart = {s[i].x + t * along.x, s[i].y + t * along.y, s[i].z + t * along.z};
    if (!(dot(apart, apart) < least)) continue;
    least = dot(apart, apart);
    nearest.weight[i] = 1.0 - t;
    nearest.weight[k] = t;
    nearest.weight[(i + 2) % 3] = 0.0;
  }
  return nearest;
}

SurfacePoint nearest_on_cage(const Cage& cage, const double (&point)[3]) {
  SurfacePoint nearest = {0, {1.0, 0.0, 0.0}};
  double least = HUGE_VAL;
  for (uint32_t t = 0; t < cage.triangle_count; ++t) {
    const SurfacePoint found = nearest_on_triangle(cage, t, point);
    double squared = 0.0;
    for (size_t c = 0; c < 3; ++c) {
      double apart = -point[c];
      for (size_t i = 0; i < 3; ++i) {
        apart += found.weight[i] * cage.doubles.position[3 * size_t{cage.triangle[t].vertex[i]} + c];
      }
      squared += apart * apart;
    }
    if (!(squared < least)) continue;
    least = squared;
    nearest = found;
  }
  return nearest;
}

}  // namespace shd::polygon
