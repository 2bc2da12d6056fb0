// SPDX-License-Identifier: MIT
#include "raster/tile_words.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/tile_words.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<uint32_t>;

/// One bit for each lane in which two rows of values differ.
HWY_INLINE uint64_t Differences(const uint32_t* now, const uint32_t* before) {
  static_assert(hn::MaxLanes(Tag()) <= 16, "two bytes of mask");
  const Tag d;
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, hn::Ne(hn::LoadU(d, now), hn::LoadU(d, before)), bytes);
  return static_cast<uint64_t>(bytes[0]) | static_cast<uint64_t>(bytes[1]) << 8;
}

void FindChanges(const uint32_t* values, size_t count, uint64_t* bits) {
  const size_t lanes = hn::Lanes(Tag());
  uint32_t shifted[hn::MaxLanes(Tag())];
  for (size_t i = 0; i < lanes; ++i) shifted[i] = values[i ? i - 1 : 0];
  for (size_t word = 0; word < count / 64; ++word) {
    uint64_t changes = 0;
    for (size_t i = 0; i < 64; i += lanes) {
      const uint32_t* now = values + 64 * word + i;
      changes |= Differences(now, now == values ? shifted : now - 1) << i;
    }
    bits[word] = changes;
  }
  bits[0] |= 1;
}

/// Sets words of a tile. The value is volatile, so that gcc stores vectors: the library's memset stores single bytes,
/// and takes as long.
void FillWords(uint32_t word, size_t count, uint32_t* words) {
  const volatile uint32_t same = word;
  const auto value = hn::Set(Tag(), same);
  for (size_t i = 0; i < count; i += 4 * hn::Lanes(Tag())) {
    for (size_t k = 0; k < 4; ++k) hn::Store(value, Tag(), words + i + k * hn::Lanes(Tag()));
  }
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(FindChanges);
HWY_EXPORT(FillWords);

void find_changes(const core::SimdTarget& simd, const uint32_t* values, size_t count, uint64_t* bits) {
  SHD_DISPATCH(FindChanges, simd)(values, count, bits);
}

void clear_slots(const core::SimdTarget& simd, Tile* tile) {
  if (tile->sole_slot == kNoSlot) SHD_DISPATCH(FillWords, simd)(kNoSlot, tile->slot.size(), tile->slot.data());
  tile->sole_slot = kNoSlot;
}

void fill_depth(const core::SimdTarget& simd, float depth, Tile* tile) {
  uint32_t bits;
  std::memcpy(&bits, &depth, sizeof bits);
  SHD_DISPATCH(FillWords, simd)(bits, tile->depth.size(), reinterpret_cast<uint32_t*>(tile->depth.data()));
  forget_bounds(tile);
  tile->range = {depth, depth};
}

}  // namespace shd::raster
#endif  // HWY_ONCE
