// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "frame/frame.h"
#include "occlusion/occlusion.h"

namespace shd::occlusion {

/// Sets the values of points by depth maps of the draws from 2 * options.rays directions, one after the other, on the
/// context's executor. Throws Failure and std::bad_alloc.
void sum_depth_maps(const core::Context& context, const Options& options, const frame::Draw* draws, size_t draw_count,
                    const Points& points);

/// Direction i of n, unit, towards the sky.
void sky_direction(uint32_t i, uint32_t n, uint32_t seed, float (&out)[3]);

}  // namespace shd::occlusion
