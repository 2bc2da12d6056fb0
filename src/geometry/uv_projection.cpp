// SPDX-License-Identifier: MIT
#include "geometry/uv_projection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "data/box_sides.h"
#include "data/trig.h"
#include "data/vec3.h"
#include "geometry/buckets.h"
#include "geometry/copies.h"
#include "geometry/face.h"

namespace shd::geometry {
namespace {

using data::Vec3d;

struct Uv {
  float u, v;
};

bool same(const Uv& a, const Uv& b) {
  return a.u == b.u && a.v == b.v;
}

/// A vertex on its way to a sphere or a cylinder.
struct Round {
  Uv uv;
  bool is_finite, is_on_axis;
};

/// A copy of a vertex with coordinates of its own.
struct SplitVertex {
  uint32_t source;
  Uv uv;
};

Uv finite(double u, double v) {
  const Uv uv = {static_cast<float>(u), static_cast<float>(v)};
  return {std::isfinite(uv.u) ? uv.u : 0.0f, std::isfinite(uv.v) ? uv.v : 0.0f};
}

bool is_finite(const Vec3d& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

double component(const Vec3d& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// The place of a vertex in the space of the projection.
Vec3d place_of(const float* m, const Vec3d& p) {
  const auto row = [&](int r) {
    return double{m[r]} * p.x + double{m[4 + r]} * p.y + double{m[8 + r]} * p.z + double{m[12 + r]};
  };
  return {row(0), row(1), row(2)};
}

/// Sum of the magnitudes of the terms of place_of().
double reach_of(const float* m, const Vec3d& p) {
  double sum = 0.0;
  for (int r = 0; r < 3; ++r) {
    sum += std::fabs(double{m[r]} * p.x) + std::fabs(double{m[4 + r]} * p.y) + std::fabs(double{m[8 + r]} * p.z) +
           std::fabs(double{m[12 + r]});
  }
  return sum;
}

/// Turn around +Y from -Z over -X, in [0, 1).
double turn_of(const Vec3d& p) {
  const double half = data::angle_of(std::fabs(p.x), -p.z) / (2.0 * data::kPi);
  const double turn = p.x > 0.0 ? 1.0 - half : half;
  return static_cast<float>(turn) < 1.0f ? turn : 0.0;
}

Round to_round(bool is_sphere, const float* m, const Vec3d& position) {
  if (!is_finite(position)) return {{0.0f, 0.0f}, false, false};
  constexpr double kOnAxis = 1.0 / (1 << 20);
  const Vec3d p = place_of(m, position);
  const double distance = std::sqrt(p.x * p.x + p.z * p.z);
  const bool is_on_axis = distance <= kOnAxis * reach_of(m, position);
  const double latitude = data::is_zero(p) ? 0.5 : data::angle_of(distance, p.y) / data::kPi;
  return {finite(is_on_axis ? 0.0 : turn_of(p), is_sphere ? latitude : 0.5 * (1.0 - p.y)), true, is_on_axis};
}

/// Adds 1 to the smallest of `count` turns, 1..3, where this makes their range smaller.
void close_seam(int count, float* turns[3]) {
  for (int end = count; end > 1; --end) {
    for (int i = 1; i < end; ++i) {
      if (*turns[i] < *turns[i - 1]) std::swap(turns[i], turns[i - 1]);
    }
  }
  double widest = 1.0 + double{*turns[0]} - double{*turns[count - 1]};
  int raised = 0;
  for (int i = 1; i < count; ++i) {
    const double gap = double{*turns[i]} - double{*turns[i - 1]};
    if (gap > widest) widest = gap, raised = i;
  }
  for (int i = 0; i < raised; ++i) *turns[i] += 1.0f;
}

/// Coordinates of the corners of a triangle on a sphere or cylinder.
void find_round_corners(const Round* const (&corner)[3], Uv* out) {
  float* turns[3];
  int count = 0;
  bool all_finite = true;
  for (int k = 0; k < 3; ++k) {
    out[k] = corner[k]->uv;
    all_finite = all_finite && corner[k]->is_finite;
    if (!corner[k]->is_on_axis) turns[count++] = &out[k].u;
  }
  if (!all_finite || count == 0) return;
  close_seam(count, turns);
  const double mean = 0.5 * (double{*turns[0]} + double{*turns[count - 1]});
  for (int k = 0; k < 3; ++k) {
    if (corner[k]->is_on_axis) out[k].u = static_cast<float>(mean);
  }
}

/// The side that a triangle with the normal n faces.
const data::BoxSide& side_of(const Vec3d& n) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::fabs(component(n, k)) > std::fabs(component(n, axis))) axis = k;
  }
  return data::kBoxSides[2 * axis + (component(n, axis) < 0.0 ? 1 : 0)];
}

Uv on_side(const data::BoxSide& side, const Vec3d& p) {
  const auto along = [&](const data::Direction& direction) {
    const double at = component(p, direction.axis);
    return 0.5 * (1.0 + (direction.backwards ? -at : at));
  };
  return finite(along(side.right), along(side.down));
}

/// Coordinates of the corners of a triangle at three places on a box.
void find_box_corners(double orientation, const Vec3d (&p)[3], Uv* out) {
  const bool all_finite = is_finite(p[0]) && is_finite(p[1]) && is_finite(p[2]);
  const Vec3d n = all_finite ? orientation * cross(p[1] - p[0], p[2] - p[0]) : Vec3d{0.0, 0.0, 0.0};
  const data::BoxSide& side = side_of(n);
  for (int k = 0; k < 3; ++k) out[k] = on_side(side, p[k]);
}

/// 1, or -1 for a matrix that mirrors.
double orientation_of(const float* m) {
  const auto column = [&](int c) { return Vec3d{double{m[4 * c]}, double{m[4 * c + 1]}, double{m[4 * c + 2]}}; };
  return dot(cross(column(0), column(1)), column(2)) < 0.0 ? -1.0 : 1.0;
}

/// Gives the coordinates of corners to their vertices. Vertices with several ones are split.
void store_corners(const core::Allocator& allocator, const core::Array<Uv>& corners, Mesh* mesh) {
  Buckets of_vertex = make_buckets(allocator, static_cast<uint32_t>(corners.size()), mesh->vertex_count,
                                   [&](uint32_t corner) { return mesh->indices[corner]; });
  core::Buffer<SplitVertex> added(allocator);
  for (uint32_t v = 0; v < mesh->vertex_count; ++v) {
    uint32_t *begin = of_vertex.item.data() + of_vertex.start[v], *end = of_vertex.item.data() + of_vertex.start[v + 1];
    if (begin == end) continue;
    const Uv own = corners[*begin];
    mesh->u[v] = own.u, mesh->v[v] = own.v;
    if (std::all_of(begin, end, [&](uint32_t c) { return same(corners[c], own); })) continue;
    std::sort(begin, end, [&](uint32_t a, uint32_t b) {
      return corners[a].u != corners[b].u ? corners[a].u < corners[b].u : corners[a].v < corners[b].v;
    });
    for (const uint32_t* c = begin; c != end; ++c) {
      const Uv uv = corners[*c];
      if (same(uv, own)) continue;
      if (c == begin || !same(uv, corners[c[-1]])) added.push_back({v, uv});
      mesh->indices[*c] = mesh->vertex_count + static_cast<uint32_t>(added.size()) - 1;
    }
  }
  if (added.size() == 0) return;
  const size_t before = mesh->vertex_count;
  append_copies(
      allocator, added.size(), [&](size_t i) { return added[i].source; }, mesh);
  for (size_t i = 0; i < added.size(); ++i) {
    mesh->u[before + i] = added[i].uv.u;
    mesh->v[before + i] = added[i].uv.v;
  }
}

void project_planar(const float* m, Mesh* mesh) {
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    const Vec3d p = place_of(m, position(*mesh, i));
    const Uv uv = is_finite(p) ? finite(0.5 * (1.0 + p.x), 0.5 * (1.0 - p.y)) : Uv{0.0f, 0.0f};
    mesh->u[i] = uv.u, mesh->v[i] = uv.v;
  }
}

void project_round(const core::Allocator& allocator, bool is_sphere, const float* m, Mesh* mesh) {
  core::Array<Round> vertices(allocator, mesh->vertex_count);
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    vertices[i] = to_round(is_sphere, m, position(*mesh, i));
    mesh->u[i] = vertices[i].uv.u, mesh->v[i] = vertices[i].uv.v;
  }
  core::Array<Uv> corners(allocator, mesh->indices.size());
  for (size_t c = 0; c < corners.size(); c += 3) {
    const uint32_t* const i = &mesh->indices[c];
    find_round_corners({&vertices[i[0]], &vertices[i[1]], &vertices[i[2]]}, &corners[c]);
  }
  store_corners(allocator, corners, mesh);
}

void project_box(const core::Allocator& allocator, const float* m, Mesh* mesh) {
  const auto place = [&](size_t i) { return place_of(m, position(*mesh, i)); };
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    const Uv uv = on_side(data::kBoxSides[0], place(i));
    mesh->u[i] = uv.u, mesh->v[i] = uv.v;
  }
  core::Array<Uv> corners(allocator, mesh->indices.size());
  for (size_t c = 0; c < corners.size(); c += 3) {
    const uint32_t* const i = &mesh->indices[c];
    find_box_corners(orientation_of(m), {place(i[0]), place(i[1]), place(i[2])}, &corners[c]);
  }
  store_corners(allocator, corners, mesh);
}

}  // namespace

void project_uv(const core::Allocator& allocator, shd_uv_projection projection, const float* to_projection,
                Mesh* mesh) {
  switch (projection) {
    case SHD_UV_PROJECTION_PLANAR: return project_planar(to_projection, mesh);
    case SHD_UV_PROJECTION_SPHERICAL: return project_round(allocator, true, to_projection, mesh);
    case SHD_UV_PROJECTION_CYLINDRICAL: return project_round(allocator, false, to_projection, mesh);
    case SHD_UV_PROJECTION_BOX: return project_box(allocator, to_projection, mesh);
    default: return;
  }
}

}  // namespace shd::geometry
