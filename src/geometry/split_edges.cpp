// SPDX-License-Identifier: MIT
#include "geometry/split_edges.h"

#include <cmath>
#include <utility>

#include "data/matrix.h"
#include "data/vec3.h"
#include "geometry/buckets.h"
#include "geometry/weld.h"

namespace shd::geometry {
namespace {

using data::Vec3d;

constexpr uint32_t kNoEdge = 0xffffffffu;

Vec3d row_of(const double* matrix, int row) {
  return {matrix[row], matrix[4 + row], matrix[8 + row]};
}

}  // namespace

EdgeFactor::EdgeFactor(const shd_tessellation_desc& desc)
    : uniform_(desc.mode == SHD_TESSELLATION_MODE_UNIFORM ? desc.segments : 0),
      max_parts_(desc.max_segments),
      edge_length_(double{desc.edge_length}),
      in_pixels_(desc.picture_width != 0) {
  for (int i = 0; i < 16; ++i) to_world_[i] = double{desc.object_to_world[i]};
  if (!in_pixels_) return;
  double clip[16];
  data::multiply(desc.view.view_to_clip, desc.view.world_to_view, clip);
  const Vec3d w = row_of(clip, 3);
  w_[0] = w.x, w_[1] = w.y, w_[2] = w.z, w_[3] = clip[15];
  w_per_length_ = data::length(w);
  const double across = 0.5 * desc.picture_width * data::length(row_of(clip, 0));
  const double upwards = 0.5 * desc.picture_height * data::length(row_of(clip, 1));
  pixels_ = across > upwards ? across : upwards;
}

uint32_t EdgeFactor::operator()(const Mesh& mesh, uint32_t a, uint32_t b) const {
  return uniform_ ? uniform_ : adaptive(mesh, a, b);
}

uint32_t EdgeFactor::adaptive(const Mesh& mesh, uint32_t a, uint32_t b) const {
  const auto to_world = [&](double x, double y, double z, double w) -> Vec3d {
    const double* m = to_world_;
    return {m[0] * x + m[4] * y + m[8] * z + m[12] * w, m[1] * x + m[5] * y + m[9] * z + m[13] * w,
            m[2] * x + m[6] * y + m[10] * z + m[14] * w};
  };
  const double p[3] = {double{mesh.px[a]}, double{mesh.py[a]}, double{mesh.pz[a]}};
  const double q[3] = {double{mesh.px[b]}, double{mesh.py[b]}, double{mesh.pz[b]}};
  const double length = data::length(to_world(p[0] - q[0], p[1] - q[1], p[2] - q[2], 0.0));
  double parts = length / edge_length_;
  if (in_pixels_) {
    const Vec3d middle = to_world(0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]), 1.0);
    const double w = w_[0] * middle.x + w_[1] * middle.y + w_[2] * middle.z + w_[3];
    if (!(w > 0.0)) return w + 0.5 * length * w_per_length_ > 0.0 ? static_cast<uint32_t>(max_parts_) : 1;
    parts = length * pixels_ / w / edge_length_;
  }
  if (std::isnan(parts) || std::isinf(length)) return 1;
  parts = std::ceil(parts);
  return static_cast<uint32_t>(parts < 1.0 ? 1.0 : parts > max_parts_ ? max_parts_ : parts);
}

SplitEdges split_edges(const core::Allocator& allocator, const Mesh& mesh, const EdgeFactor& factor) {
  const size_t side_count = 3 * size_t{mesh.triangle_count};
  const auto ends = [&](size_t side) {
    const uint32_t a = mesh.indices[side], b = mesh.indices[side % 3 == 2 ? side - 2 : side + 1];
    return a < b ? std::pair<uint32_t, uint32_t>{a, b} : std::pair<uint32_t, uint32_t>{b, a};
  };
  core::Array<uint32_t> place(allocator, mesh.vertex_count);
  const float* const position[3] = {mesh.px.data(), mesh.py.data(), mesh.pz.data()};
  weld(allocator, position, 3, mesh.vertex_count, place.data());

  // Sorts the sides by their lower vertex. Then known[other] is the edge from that vertex to `other`.
  const Buckets sides = make_buckets(allocator, static_cast<uint32_t>(side_count), mesh.vertex_count,
                                     [&](uint32_t side) { return ends(side).first; });
  SplitEdges out = {core::Buffer<SplitEdge>(allocator), core::Array<uint32_t>(allocator, side_count),
                    mesh.vertex_count};
  struct Known {
    uint32_t from, edge;
  };
  core::Array<Known> known(allocator, mesh.vertex_count);  // [vertex] latest edge that ends there
  for (Known& k : known) k = {kNoEdge, 0};
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    for (const uint32_t* side = sides.begin(v); side < sides.end(v); ++side) {
      const uint32_t other = ends(*side).second;
      if (known[other].from != v) {
        known[other] = {v, static_cast<uint32_t>(out.edge.size())};
        const bool swapped = place[other] < place[v];
        const uint32_t segments = factor(mesh, v, other);
        out.edge.push_back({swapped ? other : v, swapped ? v : other, segments, out.vertex_count});
        out.vertex_count += segments - 1;
      }
      out.of_side[*side] = known[other].edge;
    }
  }
  return out;
}

}  // namespace shd::geometry
