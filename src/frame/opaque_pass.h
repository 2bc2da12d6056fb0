// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"

namespace shd::frame {

/// Draws a run into the visibility buffer. Its material must be is_plain(), or the run draws only depth.
void cover_run(TileState* tile, const Run& run);

/// Shades the visible fragments, then empties the visibility buffer.
void shade_visible(TileState* tile);

}  // namespace shd::frame
