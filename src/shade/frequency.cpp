// SPDX-License-Identifier: MIT
#include "shade/frequency.h"

#include "data/matrix.h"

namespace shd::shade {
namespace {

using data::Vec3;

/// A transformed vertex.
struct Corner {
  Vec3 p, n;
  float u, v;
};

Corner corner(const geometry::Vertices& vertices, uint32_t index) {
  const float* world = &vertices.world[4 * size_t{index}];
  const float* normal = &vertices.normal[4 * size_t{index}];
  return {{world[0], world[1], world[2]}, {normal[0], normal[1], normal[2]}, world[3], normal[3]};
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

void set_corners(const geometry::Mesh& mesh, const geometry::Vertices& vertices, const float eye[3], uint32_t triangle,
                 size_t row, raster::Fragments* rows) {
  for (size_t k = 0; k < 3; ++k) {
    set_row(corner(vertices, mesh.indices[3 * size_t{triangle} + k]), eye, triangle, row + k, rows);
  }
}

void set_centroid(const geometry::Mesh& mesh, const geometry::Vertices& vertices, const float eye[3], float orientation,
                  uint32_t triangle, size_t row, raster::Fragments* rows) {
  const uint32_t* index = &mesh.indices[3 * size_t{triangle}];
  const Corner a = corner(vertices, index[0]), b = corner(vertices, index[1]), c = corner(vertices, index[2]);
  const Vec3 ab = b.p - a.p, ac = c.p - a.p;
  const float third = 1.0f / 3.0f;
  // Unit edges keep the product in range for triangles of any size.
  const Vec3 face = data::normalized(data::cross(data::normalized(ab), data::normalized(ac)));
  const Corner centroid = {a.p + third * (ab + ac), orientation * face, a.u + third * ((b.u - a.u) + (c.u - a.u)),
                           a.v + third * ((b.v - a.v) + (c.v - a.v))};
  set_row(centroid, eye, triangle, row, rows);
}

}  // namespace shd::shade
