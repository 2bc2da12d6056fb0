// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "frame/frame.h"

namespace shd::frame {

/// Renders a frame from a picture n = frame.supersampling times as large. Colour and targets of a pixel are the plain
/// average of its n x n large pixels, summed in double, row by row, and rounded once. The other planes take the values
/// of the top left large pixel. The large picture is drawn in blocks of at most kBlockEdge^2 pixels; the bits do not
/// depend on the blocks. Throws like render().
void render_supersampled(const core::Context& context, const Frame& frame, shd_render_stats* stats);

constexpr uint32_t kBlockEdge = 1024;

}  // namespace shd::frame
