// SPDX-License-Identifier: MIT
// Oracle of the coordinates of polyhedra, in double: the pseudocode of Ju, Schaefer and Warren, "Mean Value Coordinates
// for Closed Triangular Meshes" (2005), and Wachspress coordinates as areas of faces of the polar dual: Ju, Schaefer,
// Warren and Desbrun, "A Geometric Construction of Coordinates for Convex Polyhedra Using Polar Duals" (2005).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ref {

struct PolyhedronPoint {
  double x, y, z;
};
inline PolyhedronPoint operator-(PolyhedronPoint a, PolyhedronPoint b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline PolyhedronPoint operator+(PolyhedronPoint a, PolyhedronPoint b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline PolyhedronPoint operator*(double s, PolyhedronPoint a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double polyhedron_dot(PolyhedronPoint a, PolyhedronPoint b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline PolyhedronPoint polyhedron_cross(PolyhedronPoint a, PolyhedronPoint b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double polyhedron_length(PolyhedronPoint a) {
  return std::sqrt(polyhedron_dot(a, a));
}

/// Triangles counter-clockwise from outside.
struct PolyhedronMesh {
  std::vector<PolyhedronPoint> vertex;
  std::vector<uint32_t> index;
};

/// Mean value coordinates of a point that does not lie on the surface.
inline std::vector<double> mean_value_weights(const PolyhedronMesh& mesh, PolyhedronPoint x) {
  std::vector<double> w(mesh.vertex.size());
  const double pi = 3.14159265358979324;
  for (size_t t = 0; t < mesh.index.size(); t += 3) {
    const uint32_t* v = &mesh.index[t];
    double d[3], theta[3], c[3], s[3];
    PolyhedronPoint u[3];
    for (int i = 0; i < 3; ++i) {
      const PolyhedronPoint to = mesh.vertex[v[i]] - x;
      d[i] = polyhedron_length(to);
      u[i] = 1 / d[i] * to;
    }
    double h = 0;
    for (int i = 0; i < 3; ++i) {
      theta[i] = 2 * std::asin(std::min(1.0, polyhedron_length(u[(i + 1) % 3] - u[(i + 2) % 3]) / 2));
      h += theta[i] / 2;
    }
    const double determinant = polyhedron_dot(u[0], polyhedron_cross(u[1], u[2]));
    bool is_beside = false;
    for (int i = 0; i < 3; ++i) {
      c[i] =
          2 * std::sin(h) * std::sin(h - theta[i]) / (std::sin(theta[(i + 1) % 3]) * std::sin(theta[(i + 2) % 3])) - 1;
      s[i] = std::copysign(std::sqrt(std::max(0.0, 1 - c[i] * c[i])), determinant);
      is_beside = is_beside || std::fabs(s[i]) < 1e-9;
    }
    if (is_beside || pi - h < 1e-9) continue;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      w[v[i]] += (theta[i] - c[j] * theta[k] - c[k] * theta[j]) / (d[i] * std::sin(theta[j]) * s[k]);
    }
  }
  double sum = 0;
  for (const double weight : w) sum += weight;
  for (double& weight : w) weight /= sum;
  return w;
}

/// Wachspress coordinates of a point inside a convex polyhedron. Each vertex has the area of a face of the polar dual:
/// the polygon of the points n / h of its triangles, in order. Triangles of one plane give one point of the dual.
inline std::vector<double> wachspress_weights(const PolyhedronMesh& mesh, PolyhedronPoint x) {
  std::vector<double> w(mesh.vertex.size());
  double sum = 0;
  for (uint32_t v = 0; v < mesh.vertex.size(); ++v) {
    std::vector<PolyhedronPoint> dual;
    std::vector<uint32_t> from, to;  // side of each triangle at v that is opposite to it
    for (size_t t = 0; t < mesh.index.size(); t += 3) {
      for (size_t i = 0; i < 3; ++i) {
        if (mesh.index[t + i] != v) continue;
        from.push_back(mesh.index[t + (i + 1) % 3]);
        to.push_back(mesh.index[t + (i + 2) % 3]);
      }
    }
    uint32_t at = from[0];
    for (size_t n = 0; n < from.size(); ++n) {
      const size_t k = static_cast<size_t>(std::find(from.begin(), from.end(), at) - from.begin());
      const PolyhedronPoint a = mesh.vertex[v], b = mesh.vertex[from[k]], c = mesh.vertex[to[k]];
      const PolyhedronPoint normal = polyhedron_cross(b - a, c - a);
      dual.push_back(1 / polyhedron_dot(normal, a - x) * normal);
      at = to[k];
    }
    PolyhedronPoint area = {0, 0, 0};
    for (size_t n = 1; n + 1 < dual.size(); ++n) {
      area = area + polyhedron_cross(dual[n] - dual[0], dual[n + 1] - dual[0]);
    }
    w[v] = polyhedron_length(area) / polyhedron_length(mesh.vertex[v] - x);
    sum += w[v];
  }
  for (double& weight : w) weight /= sum;
  return w;
}

}  // namespace ref
