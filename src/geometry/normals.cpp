// SPDX-License-Identifier: MIT
#include "geometry/normals.h"

#include <cmath>
#include <cstddef>

#include "data/trig.h"
#include "geometry/face.h"

namespace shd::geometry {
namespace {

using data::Vec3d;

/// Contribution of one face to the normals of its corners.
struct FaceNormal {
  Vec3d normal;      // weighted, except for the factor `corner`
  double corner[3];  // weight of each corner
};

/// Returns false for a face that contributes nothing.
bool face_normal(const Mesh& mesh, const uint32_t* triangle, shd_normal_weight weight, FaceNormal* out) {
  const Vec3d a = position(mesh, triangle[0]);
  const Vec3d b = position(mesh, triangle[1]);
  const Vec3d c = position(mesh, triangle[2]);
  const Vec3d ab = b - a;
  const Vec3d bc = c - b;
  const Vec3d ca = a - c;
  const Vec3d n = cross(ab, c - a);
  const double length = std::sqrt(dot(n, n));  // twice the area, and |cross| at every corner
  if (!(length > 0.0) || std::isinf(length)) return false;
  *out = {n, {1.0, 1.0, 1.0}};
  if (weight == SHD_NORMAL_WEIGHT_AREA) return true;
  out->normal = {n.x / length, n.y / length, n.z / length};
  if (weight == SHD_NORMAL_WEIGHT_ANGLE) {
    out->corner[0] = data::angle_of(length, -dot(ab, ca));
    out->corner[1] = data::angle_of(length, -dot(bc, ab));
    out->corner[2] = data::angle_of(length, -dot(ca, bc));
  }
  return true;
}

void accumulate(const Mesh& mesh, shd_normal_weight weight, Vec3d* sums) {
  for (size_t t = 0; t < mesh.triangle_count; ++t) {
    const uint32_t* triangle = mesh.indices.data() + 3 * t;
    FaceNormal face;
    if (!face_normal(mesh, triangle, weight, &face)) continue;
    for (int k = 0; k < 3; ++k) {
      Vec3d& sum = sums[triangle[k]];
      sum.x += face.corner[k] * face.normal.x;
      sum.y += face.corner[k] * face.normal.y;
      sum.z += face.corner[k] * face.normal.z;
    }
  }
}

}  // namespace

uint32_t compute_normals(const core::Allocator& allocator, shd_normal_weight weight, Mesh* mesh) {
  core::Array<Vec3d> sums(allocator, mesh->vertex_count);
  sums.fill_zero();
  accumulate(*mesh, weight, sums.data());

  uint32_t normalless = 0;
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    const Vec3d sum = sums[i];
    const double length = std::sqrt(dot(sum, sum));
    if (length > 0.0) {
      mesh->nx[i] = static_cast<float>(sum.x / length);
      mesh->ny[i] = static_cast<float>(sum.y / length);
      mesh->nz[i] = static_cast<float>(sum.z / length);
    } else {
      mesh->nx[i] = mesh->ny[i] = 0.0f;
      mesh->nz[i] = 1.0f;
      ++normalless;
    }
  }
  return normalless;
}

}  // namespace shd::geometry
