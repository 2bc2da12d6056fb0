// SPDX-License-Identifier: MIT
#include "scene/read/creases.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "scene/columns.h"

namespace shd::scene {
namespace {

constexpr size_t kMostFaces = 256;
constexpr uint32_t kNoSplit = ~0u;

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A unit vector; {0, 0, 1} if it has no direction, which only triangles without area show.
Point direction_of(const Point& p) {
  const double length = std::sqrt(dot(p, p));
  return length > 0 && std::isfinite(length) ? Point{p[0] / length, p[1] / length, p[2] / length} : Point{0, 0, 1};
}

bool has_area(const Point& face) {
  return face[0] != 0 || face[1] != 0 || face[2] != 0;
}

/// State of one call of crease_normals().
struct Creaser {
  const std::vector<CreaseCorner>& corners;
  const std::vector<Point>& faces;
  std::vector<Point> units;  // [face]
  CornerNormals out;
};

/// Gives a corner the sum of these, as a row that equal sums at the place share.
void set_row(Creaser& state, size_t first_row, uint32_t corner, const Point& sum) {
  std::vector<Point>& sums = state.out.normals;
  const auto known = std::find(sums.begin() + static_cast<std::ptrdiff_t>(first_row), sums.end(), sum);
  state.out.row[corner] = static_cast<uint32_t>(known - sums.begin());
  if (known == sums.end()) sums.push_back(sum);
}

/// The normals of the corners at one place.
void crease_place(Creaser& state, const uint32_t* begin, const uint32_t* end) {
  const size_t first_row = state.out.normals.size();
  const bool crowded = static_cast<size_t>(end - begin) > kMostFaces;
  Point sum = {0, 0, 0};
  for (const uint32_t* at = begin; at != end; ++at) {
    const CreaseCorner& own = state.corners[*at];
    const bool any = crowded || !has_area(state.faces[own.face]);
    if (!crowded || at == begin) {
      sum = {0, 0, 0};
      for (const uint32_t* other = begin; other != end; ++other) {
        const uint32_t face = state.corners[*other].face;
        if (!any && !(dot(state.units[own.face], state.units[face]) >= own.cosine)) continue;
        for (size_t c = 0; c < 3; ++c) sum[c] += state.faces[face][c];
      }
    }
    set_row(state, first_row, *at, sum);
  }
}

Point position_of(const Geometry& g, uint32_t vertex) {
  const float* const p = &g.position[size_t{3} * vertex];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// Twice the area of a triangle times its normal.
Point triangle_normal(const Geometry& g, const uint32_t* corners) {
  const Point p = position_of(g, corners[0]), q = position_of(g, corners[1]), r = position_of(g, corners[2]);
  const Point a = {q[0] - p[0], q[1] - p[1], q[2] - p[2]}, b = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The places of the vertices of all geometries, one after another: equal positions have the same one.
std::vector<uint32_t> places_of(const Geometry* geometries, size_t count) {
  std::vector<Point> points;
  for (size_t i = 0; i < count; ++i) {
    const Geometry& g = geometries[i];
    for (uint32_t v = 0; v < g.position.size() / 3; ++v) {
      const Point p = position_of(g, v);
      points.push_back({p[0] + g.origin[0], p[1] + g.origin[1], p[2] + g.origin[2]});
    }
  }
  std::vector<uint32_t> order(points.size()), places(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return points[a] < points[b]; });
  uint32_t place = 0;
  for (size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && points[order[i - 1]] != points[order[i]]) ++place;
    places[order[i]] = place;
  }
  return places;
}

/// A vertex with one of its normals, and the next one with the same vertex.
struct Split {
  uint32_t vertex, row, next;
};

/// Sets the normals of a geometry. rows: of `normals`, one for each index.
void split_vertices(Geometry& g, const uint32_t* rows, const std::vector<Point>& normals) {
  std::vector<Split> splits;
  std::vector<uint32_t> first(g.position.size() / 3, kNoSplit);
  for (size_t i = 0; i < g.indices.size(); ++i) {
    const uint32_t vertex = g.indices[i];
    uint32_t at = first[vertex];
    while (at != kNoSplit && splits[at].row != rows[i]) at = splits[at].next;
    if (at == kNoSplit) {
      at = static_cast<uint32_t>(splits.size());
      splits.push_back({vertex, rows[i], first[vertex]});
      first[vertex] = at;
    }
    g.indices[i] = at;
  }
  std::vector<uint32_t> vertices;
  g.normal.clear();
  for (const Split& split : splits) vertices.push_back(split.vertex);
  take_vertices(g, vertices);
  for (const Split& split : splits) {
    for (const double c : normals[split.row]) g.normal.push_back(static_cast<float>(c));
  }
}

}  // namespace

CornerNormals crease_normals(const std::vector<CreaseCorner>& corners, const std::vector<Point>& faces, size_t places,
                             const Deadline& deadline) {
  constexpr size_t kPlacesPerCheck = 4096;
  std::vector<uint32_t> ends(places + 1), order(corners.size());
  for (const CreaseCorner& corner : corners) ++ends[corner.place + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<uint32_t> next(ends.begin(), ends.end() - 1);
  for (uint32_t i = 0; i < corners.size(); ++i) order[next[corners[i].place]++] = i;
  Creaser state = {corners, faces, {}, {std::vector<uint32_t>(corners.size()), {}}};
  for (const Point& face : faces) state.units.push_back(direction_of(face));
  for (size_t place = 0; place < places; ++place) {
    if (place % kPlacesPerCheck == 0) deadline.check();
    crease_place(state, order.data() + ends[place], order.data() + ends[place + 1]);
  }
  for (Point& normal : state.out.normals) normal = direction_of(normal);
  return std::move(state.out);
}

void add_creased_normals(Geometry* geometries, size_t count, const Limits& limits, const Deadline& deadline) {
  const std::vector<uint32_t> places = places_of(geometries, count);
  std::vector<CreaseCorner> corners;
  std::vector<Point> faces;
  uint32_t base = 0;
  for (size_t i = 0; i < count; ++i) {
    const Geometry& g = geometries[i];
    for (size_t k = 0; k < g.indices.size(); ++k) {
      if (k % 3 == 0) faces.push_back(triangle_normal(g, &g.indices[k]));
      corners.push_back({places[base + g.indices[k]], static_cast<uint32_t>(faces.size() - 1), kCrease});
    }
    base += static_cast<uint32_t>(g.position.size() / 3);
  }
  const CornerNormals normals = crease_normals(corners, faces, places.size(), deadline);
  const uint32_t* rows = normals.row.data();
  uint64_t vertices = 0;
  for (size_t i = 0; i < count; ++i) {
    const size_t corner_count = geometries[i].indices.size();
    split_vertices(geometries[i], rows, normals.normals);
    rows += corner_count;
    vertices += geometries[i].position.size() / 3;
  }
  check_limit("vertices", vertices, "max_vertices", limits.vertices);
}

}  // namespace shd::scene
