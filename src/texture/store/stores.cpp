// SPDX-License-Identifier: MIT
#include "texture/store/stores.h"

#include "core/status.h"
#include "image/format.h"

namespace shd::texture {

const StoreRow& functions_of(Store store) {
  switch (store) {
    case Store::kMemory:
    case Store::kBorrowed: return kMemoryStore;
    case Store::kBc: return kBcStore;
    case Store::kTiles: return kTileStore;
    case Store::kTilesOfBc: return kBcTileStore;
  }
  SHD_UNREACHABLE();
}

Store store_of(const shd_texture_desc& desc) {
  const bool blocks = image::is_block_format(static_cast<uint32_t>(desc.format));
  if (desc.tiles.cache) return blocks ? Store::kTilesOfBc : Store::kTiles;
  if (blocks) return Store::kBc;
  return desc.flags & SHD_TEXTURE_BORROW ? Store::kBorrowed : Store::kMemory;
}

}  // namespace shd::texture
