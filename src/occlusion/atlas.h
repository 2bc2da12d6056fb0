// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/context.h"
#include "frame/bake.h"

namespace shd::occlusion {

/// The points of the shaded texels of a texture, in the order of texels.
struct AtlasPoints {
  frame::Bake bake;
  shd_render_stats stats;
  core::Buffer<uint32_t> texel;  // row * width + column
  core::Buffer<float> position[3], normal[3];
};

/// A texture without its draws.
struct AtlasSize {
  uint32_t width, height, uv_set;
};

/// Finds the points of the draws in a texture, without dilation. Throws Failure and std::bad_alloc.
/// @param draws  their materials are replaced
void find_points(const core::Context& context, const AtlasSize& size, frame::Draw* draws, size_t draw_count,
                 AtlasPoints* out);

}  // namespace shd::occlusion
