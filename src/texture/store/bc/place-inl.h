// SPDX-License-Identifier: MIT
// The step between filters and consumers of compressed textures, declared for one target.

#if defined(SHD_TEXTURE_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PLACE_INL_H_
#undef SHD_TEXTURE_PLACE_INL_H_
#else
#define SHD_TEXTURE_PLACE_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Replaces the texels of elements 0..end - 1 by texels of a cache, and decodes the blocks that the cache lacks. Texels
/// whose place is taken by another block of the same stream get copies outside of the places. kNeighbours is cleared
/// where columns are not adjacent in the cache.
void PlaceStream(const Texture& texture, BlockCache* cache, size_t end, Stream* stream);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PLACE_INL_H_
