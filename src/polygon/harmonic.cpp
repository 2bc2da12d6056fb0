// SPDX-License-Identifier: MIT
#include "polygon/harmonic.h"

#include <algorithm>
#include <cmath>

#include "polygon/sparse_solver.h"

namespace shd::polygon {
namespace {

constexpr uint32_t kNoNode = ~0u;

/// A node of a triangle: i parts towards its second corner and j towards its third one.
struct Place {
  uint32_t i, j;
};

uint32_t& side_of(HarmonicField& field, uint32_t a, uint32_t b) {
  return field.side[size_t{std::min(a, b)} * field.vertex_count + std::max(a, b)];
}
uint32_t side_of(const HarmonicField& field, uint32_t a, uint32_t b) {
  return field.side[size_t{std::min(a, b)} * field.vertex_count + std::max(a, b)];
}

void number_sides(HarmonicField* field) {
  std::fill_n(field->side.data(), field->side.size(), kNoNode);
  uint32_t count = 0;
  for (uint32_t t = 0; t < field->triangles.count; ++t) {
    const uint32_t* const c = field->triangles.corner[t];
    for (int k = 0; k < 3; ++k) {
      uint32_t& side = side_of(*field, c[k], c[(k + 1) % 3]);
      if (side == kNoNode) side = count++;
    }
  }
  field->first_interior = field->vertex_count + count * (field->segments - 1);
}

/// Node `part` parts from vertex a on the side to vertex b.
uint32_t side_node(const HarmonicField& field, uint32_t a, uint32_t b, uint32_t part) {
  if (part == 0) return a;
  if (part == field.segments) return b;
  const uint32_t from_lower = a < b ? part : field.segments - part;
  return field.vertex_count + side_of(field, a, b) * (field.segments - 1) + from_lower - 1;
}

uint32_t node_of(const HarmonicField& field, uint32_t t, Place at) {
  const uint32_t* const c = field.triangles.corner[t];
  const uint32_t m = field.segments, k = m - at.i - at.j;
  if (at.j == 0) return side_node(field, c[0], c[1], at.i);
  if (at.i == 0) return side_node(field, c[0], c[2], at.j);
  if (k == 0) return side_node(field, c[1], c[2], at.j);
  // Rows j = 1, 2, ... have m - 1 - j nodes each.
  const uint32_t row = (at.j - 1) * (m - 1) - at.j * (at.j - 1) / 2;
  return field.first_interior + t * ((m - 1) * (m - 2) / 2) + row + at.i - 1;
}

/// Sets the values of the nodes on the polygon's edges, and the unknown of every other node; kNoNode on edges.
size_t set_edges(const Polygon& polygon, HarmonicField* field, uint32_t* unknown, size_t nodes) {
  const uint32_t n = field->vertex_count, m = field->segments;
  std::fill_n(unknown, nodes, 0u);
  std::fill_n(field->value.data(), field->value.size(), 0.0);
  for (uint32_t a = 0; a < n; ++a) {
    const uint32_t b = (a + 1) % polygon.count;
    for (uint32_t part = 0; part < m; ++part) {
      const uint32_t node = side_node(*field, a, b, part);
      const double t = static_cast<double>(part) / m;
      unknown[node] = kNoNode;
      field->value[size_t{node} * n + a] = 1.0 - t;
      field->value[size_t{node} * n + b] = t;
    }
  }
  uint32_t count = 0;
  for (size_t node = 0; node < nodes; ++node) {
    if (unknown[node] != kNoNode) unknown[node] = count++;
  }
  return count;
}

/// Cotangents of the corners of a triangle, halved.
void find_cotangents(const Polygon& p, const uint32_t (&corner)[3], double (&out)[3]) {
  const double area = turn(p, corner[0], corner[1], corner[2]);
  for (int k = 0; k < 3; ++k) {
    const uint32_t a = corner[k], b = corner[(k + 1) % 3], c = corner[(k + 2) % 3];
    const double product = (p.x[b] - p.x[a]) * (p.x[c] - p.x[a]) + (p.y[b] - p.y[a]) * (p.y[c] - p.y[a]);
    out[k] = 0.5 * product / area;
  }
}

/// The equations of the unknown nodes. Strang and Fix, "An Analysis of the Finite Element Method" (1973), with the
/// cotangent form of the stiffness of linear elements.
struct Equations {
  core::Buffer<SparseEntry> entries;
  core::Array<double> right;  // [vertex][unknown]
  size_t unknowns;

  /// Adds the energy w (u_a - u_b)^2 of a side of an element.
  void add(const HarmonicField& field, const uint32_t* unknown, uint32_t a, uint32_t b, double w) {
    add_row(field, unknown, a, b, w);
    add_row(field, unknown, b, a, w);
    if (unknown[a] == kNoNode || unknown[b] == kNoNode) return;
    entries.push_back({std::max(unknown[a], unknown[b]), std::min(unknown[a], unknown[b]), -w});
  }

  void add_row(const HarmonicField& field, const uint32_t* unknown, uint32_t a, uint32_t b, double w) {
    if (unknown[a] == kNoNode) return;
    entries.push_back({unknown[a], unknown[a], w});
    if (unknown[b] != kNoNode) return;
    for (uint32_t v = 0; v < field.vertex_count; ++v) {
      right[v * unknowns + unknown[a]] += w * field.value[size_t{b} * field.vertex_count + v];
    }
  }
};

void add_element(const HarmonicField& field, const uint32_t* unknown, const uint32_t (&node)[3],
                 const double (&cotangent)[3], Equations* out) {
  for (int k = 0; k < 3; ++k) out->add(field, unknown, node[(k + 1) % 3], node[(k + 2) % 3], cotangent[k]);
}

void assemble(const Polygon& polygon, const HarmonicField& field, const uint32_t* unknown, Equations* out) {
  const uint32_t m = field.segments;
  for (uint32_t t = 0; t < field.triangles.count; ++t) {
    double cotangent[3];
    find_cotangents(polygon, field.triangles.corner[t], cotangent);
    const auto node = [&](uint32_t i, uint32_t j) { return node_of(field, t, {i, j}); };
    for (uint32_t j = 0; j < m; ++j) {
      for (uint32_t i = 0; i + j < m; ++i) {
        add_element(field, unknown, {node(i, j), node(i + 1, j), node(i, j + 1)}, cotangent, out);
        if (i + j + 1 == m) continue;
        add_element(field, unknown, {node(i + 1, j + 1), node(i, j + 1), node(i + 1, j)}, cotangent, out);
      }
    }
  }
}

/// Barycentric coordinates of a point in a triangle.
void find_coordinates(const Polygon& p, const uint32_t (&c)[3], double x, double y, double (&out)[3]) {
  const double area = turn(p, c[0], c[1], c[2]);
  for (int k = 0; k < 3; ++k) {
    const uint32_t a = c[(k + 1) % 3], b = c[(k + 2) % 3];
    out[k] = ((p.x[a] - x) * (p.y[b] - y) - (p.y[a] - y) * (p.x[b] - x)) / area;
  }
}

/// The triangle that holds a point, or the one that the point misses least.
uint32_t find_triangle(const Polygon& polygon, const Triangulation& triangles, double x, double y, double (&out)[3]) {
  uint32_t found = 0;
  double best = -HUGE_VAL;
  for (uint32_t t = 0; t < triangles.count; ++t) {
    double b[3];
    find_coordinates(polygon, triangles.corner[t], x, y, b);
    const double least = std::min(b[0], std::min(b[1], b[2]));
    if (!(least > best)) continue;
    best = least;
    found = t;
    std::copy_n(b, 3, out);
  }
  return found;
}

/// Position along a side in parts, as a whole part and a fraction.
struct Parts {
  uint32_t whole;
  double fraction;

  Parts(double t, uint32_t most, uint32_t segments) {
    const double position = std::max(t, 0.0) * segments;
    whole = std::min(static_cast<uint32_t>(std::min(position, static_cast<double>(segments))), most);
    fraction = std::min(position - whole, 1.0);
  }
};

}  // namespace

size_t harmonic_node_count(uint32_t vertex_count, uint32_t segments) {
  const size_t n = vertex_count, m = segments;
  return n + (2 * n - 3) * (m - 1) + (n - 2) * ((m - 1) * (m - 2) / 2);
}

bool solve_harmonic(const core::Allocator& allocator, const Polygon& polygon, uint32_t segments, HarmonicField* out) {
  if (!triangulate(polygon, &out->triangles)) return false;
  const size_t n = polygon.count, nodes = harmonic_node_count(polygon.count, segments);
  out->segments = segments;
  out->vertex_count = polygon.count;
  out->side = core::Array<uint32_t>(allocator, n * n);
  out->value = core::Array<double>(allocator, core::checked_mul(nodes, n));
  number_sides(out);
  core::Array<uint32_t> unknown(allocator, nodes);
  Equations equations;
  equations.unknowns = set_edges(polygon, out, unknown.data(), nodes);
  if (equations.unknowns == 0) return true;
  equations.entries.attach(allocator);
  equations.right = core::Array<double>(allocator, core::checked_mul(equations.unknowns, n));
  equations.right.fill_zero();
  assemble(polygon, *out, unknown.data(), &equations);
  if (!solve_sparse(equations.unknowns, equations.entries.data(), equations.entries.size(), equations.right.data(), n))
    return false;
  for (size_t node = 0; node < nodes; ++node) {
    for (size_t v = 0; v < n && unknown[node] != kNoNode; ++v) {
      out->value[node * n + v] = equations.right[v * equations.unknowns + unknown[node]];
    }
  }
  return true;
}

void harmonic_weights(const Polygon& polygon, const HarmonicField& field, double x, double y, double* weights) {
  double b[3] = {};
  const uint32_t t = find_triangle(polygon, field.triangles, x, y, b), m = field.segments;
  const Parts i(b[1], m - 1, m), j(b[2], m - 1 - i.whole, m);
  const double both = i.fraction + j.fraction;
  const bool is_last = i.whole + j.whole + 1 == m;
  const bool is_upper = both <= 1.0 || is_last;
  const Place place[3] = {is_upper ? Place{i.whole, j.whole} : Place{i.whole + 1, j.whole + 1},
                          {i.whole + is_upper, j.whole + !is_upper},
                          {i.whole + !is_upper, j.whole + is_upper}};
  const double share[3] = {is_upper ? 1.0 - both : both - 1.0, is_upper ? i.fraction : 1.0 - i.fraction,
                           is_upper ? j.fraction : 1.0 - j.fraction};
  std::fill_n(weights, field.vertex_count, 0.0);
  for (int k = 0; k < 3; ++k) {
    const double* const value = &field.value[size_t{node_of(field, t, place[k])} * field.vertex_count];
    for (uint32_t v = 0; v < field.vertex_count; ++v) weights[v] += share[k] * value[v];
  }
}

}  // namespace shd::polygon
