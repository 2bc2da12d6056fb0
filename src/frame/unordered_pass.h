// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"

namespace shd::frame {

/// Draws the runs of SHD_BLEND_WEIGHTED over the colours.
void draw_weighted(TileState* tile);

/// Draws the runs of SHD_BLEND_SORTED over the colours, in boxes of the tile with at most film::kMaxNodes samples.
void draw_sorted(TileState* tile);

}  // namespace shd::frame
