// SPDX-License-Identifier: MIT
#include "geometry/feature_edges.h"

#include <algorithm>
#include <cmath>

#include "geometry/edges.h"
#include "geometry/face.h"

namespace shd::geometry {
namespace {

using data::Vec3d;

/// Plane of a triangle relative to the eye.
struct Face {
  Vec3d normal;  // any length
  double side;   // > 0 if the eye is in front of the triangle
};

Face face_of(const Mesh& mesh, const EdgeQuery& query, size_t triangle) {
  const Vec3d normal = area_vector(mesh, triangle), p = position(mesh, mesh.indices[3 * triangle]);
  const double w = query.eye[3];
  const Vec3d to_eye = {query.eye[0] - w * p.x, query.eye[1] - w * p.y, query.eye[2] - w * p.z};
  return {normal, dot(to_eye, normal)};
}

bool is_silhouette(const Face& a, const Face& b) {
  return (a.side <= 0.0 && b.side >= 0.0) || (a.side >= 0.0 && b.side <= 0.0);
}

bool is_crease(const Face& a, const Face& b, double cosine) {
  return dot(a.normal, b.normal) <= cosine * std::sqrt(dot(a.normal, a.normal)) * std::sqrt(dot(b.normal, b.normal));
}

/// The kinds of an edge between two triangles.
uint32_t kinds_between(const EdgeQuery& query, const Face& a, Face b, bool same_direction) {
  if (same_direction) b = {{-b.normal.x, -b.normal.y, -b.normal.z}, -b.side};
  uint32_t kinds = 0;
  if (is_silhouette(a, b)) kinds |= SHD_EDGE_SILHOUETTE;
  if (is_crease(a, b, query.crease_cosine)) kinds |= SHD_EDGE_CREASE;
  return kinds & query.kinds;
}

/// Rows x, y and w of a matrix product, each divided by its largest magnitude.
struct Rows {
  double row[3][4];
};

/// Rows x, y and w of left x right; both matrices are column-major.
Rows project(const float* left, const double* right) {
  constexpr int kRow[3] = {0, 1, 3};
  Rows out;
  for (int r = 0; r < 3; ++r) {
    double largest = 0.0;
    for (int c = 0; c < 4; ++c) {
      double sum = 0.0;
      for (int k = 0; k < 4; ++k) sum += static_cast<double>(left[4 * k + kRow[r]]) * right[4 * c + k];
      out.row[r][c] = sum;
      largest = std::max(largest, std::fabs(sum));
    }
    for (int c = 0; c < 4 && largest > 0.0; ++c) out.row[r][c] /= largest;
  }
  return out;
}

/// Determinant of the columns a, b, c of three rows.
double minor_of(const Rows& m, int a, int b, int c) {
  const double *p = m.row[0], *q = m.row[1], *r = m.row[2];
  return p[a] * (q[b] * r[c] - q[c] * r[b]) - p[b] * (q[a] * r[c] - q[c] * r[a]) + p[c] * (q[a] * r[b] - q[b] * r[a]);
}

}  // namespace

void find_edge_kinds(const Mesh& mesh, const EdgeQuery& query, size_t triangle, uint32_t kinds[3]) {
  const uint32_t* across = &mesh.across[3 * triangle];
  Face own = {};
  bool has_own = false;
  for (int k = 0; k < 3; ++k) {
    kinds[k] = 0;
    if (across[k] == kAcrossBorder) {
      kinds[k] = query.kinds & SHD_EDGE_BORDER;
    } else if (across[k] == kAcrossMany) {
      kinds[k] = query.kinds & SHD_EDGE_NONMANIFOLD;
    } else if (is_triangle(across[k])) {
      if (!has_own) own = face_of(mesh, query, triangle);
      has_own = true;
      kinds[k] = kinds_between(query, own, face_of(mesh, query, triangle_of(across[k])), across[k] & kSameDirection);
    }
  }
}

void centre_of_projection(const shd_view& view, const float object_to_world[16], double out[4]) {
  double object_to_view[16];
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      double sum = 0.0;
      for (int k = 0; k < 4; ++k) {
        sum += static_cast<double>(view.world_to_view[4 * k + r]) * static_cast<double>(object_to_world[4 * c + k]);
      }
      object_to_view[4 * c + r] = sum;
    }
  }
  const Rows m = project(view.view_to_clip, object_to_view);
  out[0] = minor_of(m, 1, 2, 3);
  out[1] = -minor_of(m, 0, 2, 3);
  out[2] = minor_of(m, 0, 1, 3);
  out[3] = -minor_of(m, 0, 1, 2);
}

}  // namespace shd::geometry
