// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/allocator.h"
#include "data/vec3.h"
#include "geometry/mesh.h"

namespace shd::geometry {

constexpr uint32_t kNoGroup = 0xffffffffu;

/// Corners around one vertex that share a tangent.
struct TangentGroup {
  data::Vec3d sum;  // sum of the corners' directions times their angles
  bool mirrored;    // the uv area is negative
};

/// Groups of a mesh, and the group of each corner.
struct TangentGroups {
  core::Buffer<TangentGroup> group;
  core::Array<uint32_t> of_corner;  // [3 * triangle_count], kNoGroup if no group touches the corner's vertex
};

/// Forms groups by the rules in tangents.h. Throws std::bad_alloc.
TangentGroups group_tangents(const core::Allocator& allocator, const Mesh& mesh);

}  // namespace shd::geometry
