// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"

namespace shd::frame {

/// Shades each texel of a tile that a triangle touches once, at the point of the triangle that is nearest to the centre
/// of the texel, and stores the state of the texels in the bake.
void bake_tile(TileState* tile);

}  // namespace shd::frame
