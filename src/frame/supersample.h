// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "frame/frame.h"

namespace shd::frame {

/// Renders a frame of which each pixel is the plain average of frame.supersampling^2 pixels of a picture as many times
/// as large: sums in double, row by row, rounded once; targets too. The other planes are those of the top left one of
/// them. The large picture is drawn in blocks of at most kBlockEdge^2 pixels, which leave no trace in the bits. Throws
/// as render() does.
void render_supersampled(const core::Context& context, const Frame& frame, shd_render_stats* stats);

constexpr uint32_t kBlockEdge = 1024;

}  // namespace shd::frame
