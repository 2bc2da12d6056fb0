// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "frame/frame.h"
#include "frame/scene.h"

namespace shd::frame {

/// Sorts the triangles of a scene into the order in which the frame's visibility method paints them: draws that blend
/// in order first, far to near, then the others. Counts conflicts if the frame wants them. Throws.
void order_triangles(const core::Context& context, const Frame& frame, Scene* scene, shd_render_stats* stats);

}  // namespace shd::frame
