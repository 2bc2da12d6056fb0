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

/// Copies a level of a layer to an image of its size and of the format of decoded texels.
void read_level(const Texture& texture, uint32_t layer, uint32_t level, const shd_image& out);

/// Copies the blocks of a level of a layer, which the callback gives again because the cache keeps them decoded.
void read_blocks(const Texture& texture, uint32_t layer, uint32_t level, const shd_image& out);

}  // namespace shd::texture
