// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "frame/frame.h"
#include "frame/scene.h"

namespace shd::frame {

/// Sorts the triangles of a scene into the order of painting of the frame's visibility method: draws that blend in
/// order first, far to near, then the other draws. Counts conflicts if frame.counts_conflicts. Throws Failure and
/// std::bad_alloc.
void order_triangles(const core::Context& context, const Frame& frame, Scene* scene, shd_render_stats* stats);

}  // namespace shd::frame
