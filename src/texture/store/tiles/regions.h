// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/tiles.h>

#include "texture/texture.h"

namespace shd::texture {

/// Rectangles of tiles, of checked regions. They throw Failure if a callback fails.
void load_region(const Texture& texture, const shd_tile_region& region);

/// Returns false if too many tiles are pinned; then no tile is pinned by the call.
bool pin_region(const Texture& texture, const shd_tile_region& region);

/// Returns false if a tile is not pinned; then nothing changes.
bool unpin_region(const Texture& texture, const shd_tile_region& region);

void drop_region(const Texture& texture, const shd_tile_region& region);

}  // namespace shd::texture
