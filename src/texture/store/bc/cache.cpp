// SPDX-License-Identifier: MIT
#include "texture/store/bc/cache.h"

#include <algorithm>

#include "texture/store/storage.h"

namespace shd::texture {
namespace {

/// Memory of a pool: room for kMaxPlaces blocks of texels of 4 bytes, or half as many of 8 bytes.
struct Pooled {
  BcCache cache;
  uint32_t block[BcCache::kMaxPlaces + BcCache::kAfter], turn[BcCache::kMaxPlaces + BcCache::kAfter];
  alignas(64) uint8_t
      texels[4 * (4 * BcCache::kMaxPlaces * 4 + BcCache::kMargin * 8) + BcCache::kSpare * 8 + SHD_TEXTURE_PADDING];
};
static_assert(sizeof(Pooled) <= core::kCacheSize);

void begin(uint32_t places, uint32_t* block, uint32_t* turn, uint8_t* texels, BcCache* cache) {
  cache->texels = texels;
  cache->block = block;
  cache->turn = turn;
  cache->places = places;
  cache->pitch = 4 * places + BcCache::kMargin;
  cache->spare = 4 * cache->pitch;
  cache->now = 0;
  std::fill_n(block, places + BcCache::kAfter, BcCache::kUnused);
  std::fill_n(turn, places + BcCache::kAfter, 0u);
}

}  // namespace

CacheLease::CacheLease(const Texture& texture) : texture_(texture), pool_(texture.bc.caches) {
  if (pool_) lease_ = pool_->take(texture.bc.owner);
  if (!lease_.memory) {
    begin(kFewPlaces, few_block_, few_turn_, few_texels_, &few_);
    cache_ = &few_;
    return;
  }
  auto* pooled = static_cast<Pooled*>(lease_.memory);
  cache_ = &pooled->cache;
  const uint32_t places = texel_size(texture) <= 4 ? BcCache::kMaxPlaces : BcCache::kMaxPlaces / 2;
  if (!lease_.left_by_owner) begin(places, pooled->block, pooled->turn, pooled->texels, cache_);
}

CacheLease::~CacheLease() {
  if (lease_.memory) pool_->put(lease_);
}

}  // namespace shd::texture
