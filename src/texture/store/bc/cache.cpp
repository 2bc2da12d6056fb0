// SPDX-License-Identifier: MIT
#include "texture/store/bc/cache.h"

#include <algorithm>

#include "texture/store/storage.h"

namespace shd::texture {
namespace {

/// Memory of a pool: room for kMaxPlaces blocks of texels of 4 bytes, or half as many of 8 bytes.
struct Pooled {
  BlockCache cache;
  uint32_t block[BlockCache::kMaxPlaces + BlockCache::kAfter], turn[BlockCache::kMaxPlaces + BlockCache::kAfter];
  alignas(64) uint8_t texels[4 * (4 * BlockCache::kMaxPlaces * 4 + BlockCache::kMargin * 8) + BlockCache::kSpare * 8 +
                             SHD_TEXTURE_PADDING];
};
static_assert(sizeof(Pooled) <= core::kCacheSize);

void begin(uint32_t places, uint32_t* block, uint32_t* turn, uint8_t* texels, BlockCache* cache) {
  cache->texels = texels;
  cache->block = block;
  cache->turn = turn;
  cache->places = places;
  cache->pitch = 4 * places + BlockCache::kMargin;
  cache->spare = 4 * cache->pitch;
  cache->now = 0;
  std::fill_n(block, places + BlockCache::kAfter, BlockCache::kUnused);
  std::fill_n(turn, places + BlockCache::kAfter, 0u);
}

}  // namespace

CacheLease::CacheLease(const Texture& texture) : texture_(texture), pool_(texture.blocks.caches) {
  if (pool_) lease_ = pool_->take(texture.blocks.owner);
  if (!lease_.memory) {
    begin(kFewPlaces, few_block_, few_turn_, few_texels_, &few_);
    cache_ = &few_;
    return;
  }
  auto* pooled = static_cast<Pooled*>(lease_.memory);
  cache_ = &pooled->cache;
  const uint32_t places = texel_size(texture) <= 4 ? BlockCache::kMaxPlaces : BlockCache::kMaxPlaces / 2;
  if (!lease_.left_by_owner) begin(places, pooled->block, pooled->turn, pooled->texels, cache_);
}

CacheLease::~CacheLease() {
  if (lease_.memory) pool_->put(lease_);
}

}  // namespace shd::texture
