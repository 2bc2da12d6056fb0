// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/context.h"
#include "frame/frame.h"
#include "light/shadow.h"

namespace shd::frame {

/// A checked shd_shadow_render_desc.
struct ShadowFrame {
  const light::Light* light;  // not ambient
  const Draw* draws;
  size_t draw_count;
  bool has_planes, has_bounds;
  float near, far;
  float bounds_min[3], bounds_max[3];
};

/// Renders the depth map of a shadow face by face on the context's executor, then builds the tables for its filter.
/// Memory that the shadow keeps is allocated from `owner`. Throws Failure and std::bad_alloc; then the shadow is
/// unchanged.
void render_shadow(const core::Context& context, const core::Context& owner, const ShadowFrame& frame,
                   light::Shadow* shadow);

}  // namespace shd::frame
