// SPDX-License-Identifier: MIT
// Placements of the stores on one target (Placement in stream.h).

#if defined(SHD_TEXTURE_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PLACE_INL_H_
#undef SHD_TEXTURE_PLACE_INL_H_
#else
#define SHD_TEXTURE_PLACE_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/rows.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Places a stream in the cache of a CacheLease, and decodes the blocks that the cache lacks. Texels whose place is
/// taken by another block of the same stream get copies outside of the places.
void PlaceInBc(void* lease, size_t end, size_t lanes, Stream* stream);

/// Places a stream in the tiles of a TileCall. Loads the tiles that are missing, without a lease, and throws Failure if
/// that fails.
void PlaceInTiles(void* call, size_t end, size_t lanes, Stream* stream);

/// Place the quads of a block as PlaceInBc() and PlaceInTiles() do, if all texels are at hand (PlaceRows).
bool PlaceRowsInBc(void* lease, const RowLevel (&levels)[2], RowStream* rows);
bool PlaceRowsInTiles(void* call, const RowLevel (&levels)[2], RowStream* rows);

/// Returns the placement of rows of a store; null if filters address texels themselves.
inline PlaceRows PlaceRowsOf(Store store) {
  switch (store) {
    case Store::kMemory:
    case Store::kBorrowed: return nullptr;
    case Store::kBc: return PlaceRowsInBc;
    case Store::kTiles:
    case Store::kTilesOfBc: return PlaceRowsInTiles;
  }
  return nullptr;
}

/// Returns the placement of a store; null if filters address texels themselves.
inline PlaceStream PlaceOf(Store store) {
  switch (store) {
    case Store::kMemory:
    case Store::kBorrowed: return nullptr;
    case Store::kBc: return PlaceInBc;
    case Store::kTiles:
    case Store::kTilesOfBc: return PlaceInTiles;
  }
  return nullptr;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PLACE_INL_H_
