// SPDX-License-Identifier: MIT
// Rays against triangles in double: the visibility of lights from which shadow maps are judged. A tree of boxes only
// skips triangles that a ray cannot hit (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986); each test of a triangle
// is that of Moller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace shd::ref {

struct Vec3 {
  double c[3];
  double operator[](size_t k) const { return c[k]; }
  double& operator[](size_t k) { return c[k]; }
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator*(double s, const Vec3& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec3 unit(const Vec3& a) {
  return 1.0 / std::sqrt(dot(a, a)) * a;
}

/// Corners and normals of a triangle.
struct RayTriangle {
  Vec3 corner[3], normal[3];
};

/// Mean of three vectors with barycentric coordinates 1 - u - v, u, v.
inline Vec3 mix(const Vec3 (&a)[3], double u, double v) {
  return (1 - u - v) * a[0] + u * a[1] + v * a[2];
}

/// A point that a ray meets: t along the ray, barycentric coordinates of corners 1 and 2.
struct RayHit {
  double t = INFINITY, u = 0, v = 0;
  size_t triangle = 0;
};

class RayScene {
 public:
  explicit RayScene(std::vector<RayTriangle> triangles) : triangles_(std::move(triangles)) {
    for (uint32_t i = 0; i < triangles_.size(); ++i) order_.push_back(i);
    if (!order_.empty()) split(0, static_cast<uint32_t>(order_.size()));
  }

  const RayTriangle& triangle(size_t i) const { return triangles_[i]; }

  /// The first point of a ray with t in (0, end).
  RayHit first(const Vec3& from, const Vec3& way, double end) const {
    RayHit hit;
    hit.t = end;
    if (!nodes_.empty()) visit(0, from, way, &hit, false);
    return hit.t < end ? hit : RayHit();
  }
  /// Whether a triangle lies between `from` and `from + way`.
  bool is_blocked(const Vec3& from, const Vec3& way) const {
    RayHit hit;
    hit.t = 1.0;
    return !nodes_.empty() && visit(0, from, way, &hit, true);
  }

 private:
  struct Node {
    Vec3 low, high;
    uint32_t begin, end;   // triangles, as positions in order_
    uint32_t left, right;  // 0 in leaves
  };

  uint32_t split(uint32_t begin, uint32_t end) {
    const auto index = static_cast<uint32_t>(nodes_.size());
    Node node = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, begin, end, 0, 0};
    for (uint32_t i = begin; i < end; ++i) {
      for (const Vec3& p : triangles_[order_[i]].corner) {
        for (size_t k = 0; k < 3; ++k) {
          node.low[k] = std::min(node.low[k], p[k]);
          node.high[k] = std::max(node.high[k], p[k]);
        }
      }
    }
    nodes_.push_back(node);
    if (end - begin <= 4) return index;
    const Vec3 size = node.high - node.low;
    const size_t axis = static_cast<size_t>(std::max_element(size.c, size.c + 3) - size.c);
    const auto middle_of = [&](uint32_t t) {
      const RayTriangle& triangle = triangles_[t];
      return triangle.corner[0][axis] + triangle.corner[1][axis] + triangle.corner[2][axis];
    };
    const uint32_t middle = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](uint32_t a, uint32_t b) { return middle_of(a) < middle_of(b); });
    const uint32_t left = split(begin, middle), right = split(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  static bool misses(const Node& node, const Vec3& from, const Vec3& way, double end) {
    double low = 0.0, high = end;
    for (size_t k = 0; k < 3; ++k) {
      if (way[k] == 0.0) {
        if (from[k] < node.low[k] || from[k] > node.high[k]) return true;
        continue;
      }
      const double a = (node.low[k] - from[k]) / way[k], b = (node.high[k] - from[k]) / way[k];
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    return low > high;
  }

  static bool meet(const RayTriangle& triangle, const Vec3& from, const Vec3& way, RayHit* hit) {
    const Vec3 e1 = triangle.corner[1] - triangle.corner[0], e2 = triangle.corner[2] - triangle.corner[0];
    const Vec3 p = cross(way, e2);
    const double det = dot(e1, p);
    if (det == 0.0) return false;
    const Vec3 s = from - triangle.corner[0], q = cross(s, e1);
    const double u = dot(s, p) / det, v = dot(way, q) / det, t = dot(e2, q) / det;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || !(t > 0.0) || !(t < hit->t)) return false;
    hit->t = t;
    hit->u = u;
    hit->v = v;
    return true;
  }

  bool visit(uint32_t index, const Vec3& from, const Vec3& way, RayHit* hit, bool any) const {
    const Node& node = nodes_[index];
    if (misses(node, from, way, hit->t)) return false;
    bool met = false;
    if (node.left == 0) {
      for (uint32_t i = node.begin; i < node.end; ++i) {
        if (!meet(triangles_[order_[i]], from, way, hit)) continue;
        hit->triangle = order_[i];
        met = true;
        if (any) return true;
      }
      return met;
    }
    met = visit(node.left, from, way, hit, any);
    if (met && any) return true;
    return visit(node.right, from, way, hit, any) || met;
  }

  std::vector<RayTriangle> triangles_;
  std::vector<uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace shd::ref
