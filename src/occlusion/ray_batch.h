// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "occlusion/occlusion.h"

namespace shd::occlusion {

/// The points of the unit square that all points of a call share, in 2^-32: a Hammersley set.
struct RaySet {
  uint32_t count;
  core::Array<uint32_t> u, v;  // [padded]
};

/// Throws std::bad_alloc.
RaySet make_ray_set(const core::Allocator& allocator, uint32_t count);

/// Largest number of rays in one call of a tracer.
constexpr size_t kRayBatch = 4096;

/// Columns of up to kRayBatch rays, in one block; whole vectors may run past the last one.
struct RayBatch {
  size_t count = 0;
  core::Array<float> block;
  float *ox, *oy, *oz, *dx, *dy, *dz, *length;
  core::Array<uint32_t> blocked;
};

/// Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, float length, RayBatch* out);

/// A point from which rays start.
struct RayOrigin {
  float origin[3];                            // above the surface
  float normal[3], tangent[3], bitangent[3];  // unit
  uint32_t shift[2];                          // added to each point of the ray set, modulo 2^32
};

/// Makes the origin of the rays of a point. Returns false if the position is not finite or there is no normal.
bool make_origin(const Points& points, size_t index, const Options& options, RayOrigin* out);

/// Appends rays [begin, end) of the set at an origin, which must fit.
void append_rays(const core::SimdTarget& simd, const RaySet& set, const RayOrigin& origin, size_t begin, size_t end,
                 RayBatch* out);

}  // namespace shd::occlusion
