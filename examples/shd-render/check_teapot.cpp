// SPDX-License-Identifier: MIT
/// Checks that the teapot is complete, by counting edges: every edge belongs to two triangles with consistent
/// orientation, except around the lid, its opening, and the ends of handle and spout.
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "teapot.h"

namespace {

using Point = std::array<float, 3>;

Point point_of(const Geometry& g, uint32_t vertex) {
  const float* p = &g.position[size_t{3} * vertex];
  return {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f};  // -0 becomes 0
}

/// Numbers of edges without a partner, and of edges along which two triangles run in the same direction.
struct Edges {
  size_t open = 0, wrong = 0;
};

Edges count_edges(const Geometry& g) {
  std::map<std::pair<Point, Point>, int> directed;
  for (size_t i = 0; i < g.indices.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k) {
      ++directed[{point_of(g, g.indices[i + k]), point_of(g, g.indices[i + (k + 1) % 3])}];
    }
  }
  Edges edges;
  for (const auto& [edge, count] : directed) {
    edges.wrong += count != 1;
    edges.open += directed.count({edge.second, edge.first}) == 0;
  }
  return edges;
}

/// Counts vertices whose normal is not a unit vector on the front of every triangle around them.
size_t count_bad_normals(const Geometry& g) {
  size_t bad = 0;
  for (size_t i = 0; i < g.indices.size(); i += 3) {
    Point p[3];
    for (size_t k = 0; k < 3; ++k) p[k] = point_of(g, g.indices[i + k]);
    double a[3], b[3];
    for (int c = 0; c < 3; ++c) {
      a[c] = double(p[1][c]) - p[0][c];
      b[c] = double(p[2][c]) - p[0][c];
    }
    const double face[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    for (size_t k = 0; k < 3; ++k) {
      const float* n = &g.normal[size_t{3} * g.indices[i + k]];
      const double length = std::sqrt(double(n[0]) * n[0] + double(n[1]) * n[1] + double(n[2]) * n[2]);
      const double facing = face[0] * n[0] + face[1] * n[1] + face[2] * n[2];
      bad += !(std::fabs(length - 1.0) < 1e-5 && facing > 0.0);
    }
  }
  return bad;
}

/// Volume under the surface, by the divergence theorem; close to the volume of the pot, because the openings are small.
double volume(const Geometry& g) {
  double six = 0.0;
  for (size_t i = 0; i < g.indices.size(); i += 3) {
    const Point a = point_of(g, g.indices[i]), b = point_of(g, g.indices[i + 1]), c = point_of(g, g.indices[i + 2]);
    six += a[0] * (double(b[1]) * c[2] - double(b[2]) * c[1]) + a[1] * (double(b[2]) * c[0] - double(b[0]) * c[2]) +
           a[2] * (double(b[0]) * c[1] - double(b[1]) * c[0]);
  }
  return six / 6.0;
}

}  // namespace

int main() {
  bool good = true;
  for (const int steps : {2, 3, 8, 16}) {
    const Geometry g = make_teapot(steps).geometries[0];
    const size_t n = static_cast<size_t>(steps);
    const Edges edges = count_edges(g);
    const size_t bad = steps >= 8 ? count_bad_normals(g) : 0;  // coarser faces deviate from the surface
    const double size = volume(g);
    const bool fine = g.indices.size() / 3 == 64 * n * n - 8 * n && edges.open == 16 * n && edges.wrong == 0 &&
                      bad == 0 && size > 10.0 && size < 30.0;
    std::printf("%2d steps: %zu triangles, %zu open and %zu wrong edges, %zu bad normals, volume %.3f: %s\n", steps,
                g.indices.size() / 3, edges.open, edges.wrong, bad, size, fine ? "whole" : "BROKEN");
    good = good && fine;
  }
  return good ? 0 : 1;
}
