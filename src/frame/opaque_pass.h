// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"

namespace shd::frame {

/// Draws a run into the visibility buffer; its material is_plain(), or it draws depth alone.
void cover_run(TileState* tile, const Run& run);

/// Shades the visible fragments, and empties the visibility buffer.
void shade_visible(TileState* tile);

}  // namespace shd::frame
