// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"

namespace shd::frame {

/// Blends the volumes of the frame over a finished tile, in order. Throws Failure and std::bad_alloc.
void draw_volumes(TileState* tile);

}  // namespace shd::frame
