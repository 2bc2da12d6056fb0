// SPDX-License-Identifier: MIT
#pragma once

#include <shd/render.h>

#include "core/context.h"
#include "frame/bake.h"

namespace shd::abi {

/// Checks a desc that read_desc has read, and draws it with the memory of a context.
/// @param bake  where triangles are drawn at their texture coordinates; null = a frame
shd_result render_desc(const core::Context& context, const shd_render_desc& desc, frame::Bake* bake,
                       shd_render_stats* stats);

}  // namespace shd::abi
