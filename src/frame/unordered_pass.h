// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"

namespace shd::frame {

/// Draws the runs of SHD_BLEND_WEIGHTED over the colours.
void draw_weighted(TileState* tile);

/// The same for SHD_BLEND_SORTED, in boxes of the tile that hold no more than kMaxNodes samples.
void draw_sorted(TileState* tile);

}  // namespace shd::frame
