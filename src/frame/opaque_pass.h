// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"

namespace shd::frame {

/// Draws a run of an is_plain() material, or of depth alone, into the visibility buffer.
void cover_run(TileState* tile, const Run& run);

/// Shades what the visibility buffer shows, and empties it.
void shade_visible(TileState* tile);

}  // namespace shd::frame
