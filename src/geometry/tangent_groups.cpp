// SPDX-License-Identifier: MIT
#include "geometry/tangent_groups.h"

#include <cmath>

#include "data/trig.h"
#include "geometry/buckets.h"
#include "geometry/face.h"
#include "geometry/weld.h"

namespace shd::geometry {
namespace {

using data::cross;
using data::dot;
using data::Vec3d;

constexpr uint32_t kNoCorner = 0xffffffffu;

uint32_t next_corner(uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
uint32_t previous_corner(uint32_t corner) {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

Vec3d in_plane(Vec3d a, Vec3d n) {
  return a - dot(n, a) * n;
}

enum TriangleKind : uint8_t {
  kUpright,   // uv area of (u, 1 - v) > 0
  kMirrored,  // uv area of (u, 1 - v) < 0
  kAny,       // no uv area: takes the sign of the first group that reaches it
  kLeftOut,   // two corners at one position, or a non-finite position
};

/// Uv orientation of a triangle.
struct Direction {
  TriangleKind kind;
  Vec3d along_u;  // direction of growing u, any length
};

Direction direction_of(const Mesh& mesh, const uint32_t* corners) {
  const Vec3d a = position(mesh, corners[0]);
  const Vec3d b = position(mesh, corners[1]) - a;
  const Vec3d c = position(mesh, corners[2]) - a;
  const double extent = dot(b, b) + dot(c, c);
  if (!(extent < INFINITY) || data::is_zero(b) || data::is_zero(c) || data::is_zero(b - c)) return {kLeftOut, {}};
  const double u = mesh.u[corners[0]];
  const double v = mesh.v[corners[0]];
  const double bu = mesh.u[corners[1]] - u, bv = mesh.v[corners[1]] - v;
  const double cu = mesh.u[corners[2]] - u, cv = mesh.v[corners[2]] - v;
  const double area = bu * cv - cu * bv;  // twice the area of (u, v); 1 - v flips its sign
  const Vec3d s = cv * b - bv * c;
  if (area == 0.0 || data::is_zero(s) || data::is_zero(bu * c - cu * b)) return {kAny, {}};
  return area < 0.0 ? Direction{kUpright, -1.0 * s} : Direction{kMirrored, s};
}

/// State of the growing groups.
class Grouping {
 public:
  Grouping(const core::Allocator& allocator, const Mesh& mesh)
      : mesh_(mesh),
        corner_count_(3 * mesh.triangle_count),
        welded_(allocator, mesh.vertex_count),
        kind_(allocator, mesh.triangle_count),
        along_u_(allocator, mesh.triangle_count),
        forward_(allocator, corner_count_),
        backward_(allocator, corner_count_) {
    out.group.attach(allocator);
    out.of_corner = core::Array<uint32_t>(allocator, corner_count_);
    const float* const columns[8] = {mesh.px.data(), mesh.py.data(), mesh.pz.data(), mesh.nx.data(),
                                     mesh.ny.data(), mesh.nz.data(), mesh.u.data(),  mesh.v.data()};
    weld(allocator, columns, 8, mesh.vertex_count, welded_.data());
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
      const Direction direction = direction_of(mesh, mesh.indices.data() + 3 * size_t{t});
      kind_[t] = direction.kind;
      along_u_[t] = direction.along_u;
    }
  }

  void link_corners(const core::Allocator& allocator);
  void grow_groups();
  void adopt(const core::Allocator& allocator);

  TangentGroups out;

 private:
  uint32_t vertex_of(uint32_t corner) const { return welded_[mesh_.indices[corner]]; }
  void link_vertex(const uint32_t* begin, const uint32_t* end, uint32_t* head, uint32_t* chain);
  bool join(uint32_t corner, uint32_t group);
  Vec3d contribution(uint32_t corner) const;

  const Mesh& mesh_;
  const uint32_t corner_count_;
  core::Array<uint32_t> welded_;  // [vertex]
  core::Array<TriangleKind> kind_;
  core::Array<Vec3d> along_u_;      // [triangle]
  core::Array<uint32_t> forward_;   // [corner] the corner at the same vertex across the edge to the next corner
  core::Array<uint32_t> backward_;  // [corner] the corner at the same vertex across the edge from the previous corner
};

/// Pairs the corners [begin, end) around one vertex, ascending, across the edges that they share. The first triangle
/// that leaves along an edge is paired with the first triangle that arrives along it, and so on. `head` must be
/// kNoCorner everywhere, and is left so.
void Grouping::link_vertex(const uint32_t* begin, const uint32_t* end, uint32_t* head, uint32_t* chain) {
  for (const uint32_t* c = end; c != begin;) {
    const uint32_t corner = *--c;
    uint32_t& first = head[vertex_of(previous_corner(corner))];
    chain[corner] = first;
    first = corner;
  }
  for (const uint32_t* c = begin; c != end; ++c) {
    uint32_t& first = head[vertex_of(next_corner(*c))];
    if (first == kNoCorner) continue;
    forward_[*c] = first;
    backward_[first] = *c;
    first = chain[first];
  }
  for (const uint32_t* c = begin; c != end; ++c) head[vertex_of(previous_corner(*c))] = kNoCorner;
}

void Grouping::link_corners(const core::Allocator& allocator) {
  for (uint32_t c = 0; c < corner_count_; ++c) forward_[c] = backward_[c] = kNoCorner;
  const Buckets corners = make_buckets(allocator, corner_count_, mesh_.vertex_count, [&](uint32_t corner) {
    return kind_[corner / 3] == kLeftOut ? kNoBucket : vertex_of(corner);
  });
  core::Array<uint32_t> head(allocator, mesh_.vertex_count);
  for (uint32_t& corner : head) corner = kNoCorner;
  for (size_t v = 0; v < mesh_.vertex_count; ++v) {
    link_vertex(corners.begin(v), corners.end(v), head.data(), out.of_corner.data());
  }
}

/// The u direction of a corner's triangle in the plane of the vertex normal; its length is the corner's angle there.
Vec3d Grouping::contribution(uint32_t corner) const {
  const Vec3d n = vertex_normal(mesh_, mesh_.indices[corner]);
  const Vec3d p = position(mesh_, mesh_.indices[corner]);
  const Vec3d a = in_plane(position(mesh_, mesh_.indices[previous_corner(corner)]) - p, n);
  const Vec3d b = in_plane(position(mesh_, mesh_.indices[next_corner(corner)]) - p, n);
  const double angle = data::angle_of(data::length(cross(a, b)), dot(a, b));
  return angle * data::normalized(in_plane(along_u_[corner / 3], n));
}

/// Adds the corner to the group. Returns false if it cannot be added.
bool Grouping::join(uint32_t corner, uint32_t group) {
  uint32_t* const of_corner = out.of_corner.data();
  if (of_corner[corner] != kNoGroup) return false;
  const uint32_t triangle = corner / 3;
  TangentGroup& body = out.group[group];
  if (kind_[triangle] == kAny) {
    // A triangle without uv area takes the sign of the groups of its other corners.
    for (uint32_t c = 3 * triangle; c < 3 * triangle + 3; ++c) {
      if (of_corner[c] != kNoGroup && out.group[of_corner[c]].mirrored != body.mirrored) return false;
    }
  } else {
    if ((kind_[triangle] == kMirrored) != body.mirrored) return false;
    body.sum = body.sum + contribution(corner);
  }
  of_corner[corner] = group;
  return true;
}

void Grouping::grow_groups() {
  for (uint32_t c = 0; c < corner_count_; ++c) out.of_corner[c] = kNoGroup;
  for (uint32_t c = 0; c < corner_count_; ++c) {
    const TriangleKind kind = kind_[c / 3];
    if (kind == kLeftOut || kind == kAny || out.of_corner[c] != kNoGroup) continue;
    const auto group = static_cast<uint32_t>(out.group.size());
    out.group.push_back({{0.0, 0.0, 0.0}, kind == kMirrored});
    join(c, group);
    for (uint32_t n = forward_[c]; n != kNoCorner && join(n, group);) n = forward_[n];
    for (uint32_t n = backward_[c]; n != kNoCorner && join(n, group);) n = backward_[n];
  }
}

/// Assigns the first group at the vertex to corners without a group.
void Grouping::adopt(const core::Allocator& allocator) {
  core::Array<uint32_t> first(allocator, mesh_.vertex_count);
  for (size_t v = 0; v < mesh_.vertex_count; ++v) first[v] = kNoGroup;
  for (uint32_t c = 0; c < corner_count_; ++c) {
    const uint32_t group = out.of_corner[c];
    uint32_t& known = first[vertex_of(c)];
    if (group < known) known = group;
  }
  for (uint32_t c = 0; c < corner_count_; ++c) {
    if (out.of_corner[c] == kNoGroup) out.of_corner[c] = first[vertex_of(c)];
  }
}

}  // namespace

TangentGroups group_tangents(const core::Allocator& allocator, const Mesh& mesh) {
  Grouping grouping(allocator, mesh);
  grouping.link_corners(allocator);
  grouping.grow_groups();
  grouping.adopt(allocator);
  return std::move(grouping.out);
}

}  // namespace shd::geometry
