// SPDX-License-Identifier: MIT
// The step between filters and consumers of textures in tiles, declared for one target.

#if defined(SHD_TEXTURE_TILE_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_TILE_PLACE_INL_H_
#undef SHD_TEXTURE_TILE_PLACE_INL_H_
#else
#define SHD_TEXTURE_TILE_PLACE_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Replaces the columns of elements 0..end - 1 by indices of texels in the memory of the cache. kNeighbours is cleared
/// where columns are not adjacent there. Loads the tiles that are missing, without a lease, and throws Failure if that
/// fails.
void PlaceInTiles(TileCall* call, size_t end, Stream* stream);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_TILE_PLACE_INL_H_
