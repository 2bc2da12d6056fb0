// SPDX-License-Identifier: MIT
// Rows of blocks in the cache of a call.

#if defined(SHD_TEXTURE_WINDOWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_WINDOWS_INL_H_
#undef SHD_TEXTURE_WINDOWS_INL_H_
#else
#define SHD_TEXTURE_WINDOWS_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

#include "texture/format/bc/kernels-inl.h"
#include "texture/lanes-inl.h"
#include "texture/store/bc/cache.h"
#include "texture/store/bc/levels.h"
#include "texture/store/storage.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

alignas(64) inline constexpr uint32_t kOrdinals[kMaxLanes] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// Base of the placers of a call: blocks side by side, decoded to their places in a cache.
class BcWindows {
 protected:
  using DI = hn::RebindToSigned<BatchTag>;
  using DU = hn::RebindToUnsigned<BatchTag>;
  using VI = hn::Vec<DI>;

  BcWindows(const Texture& texture, BcCache* cache)
      : texture_(texture),
        cache_(*cache),
        decode_(KernelOf(texture.bc.decode)),
        size_(static_cast<uint32_t>(texel_size(texture))) {}

  /// The level of an image: its first block, its width in blocks, and the places of its blocks.
  struct Image {
    uint32_t first, across, zeroth;
  };

  HWY_INLINE Image image_at(uint32_t first, uint32_t width) const {
    return {first, units_along(width, 2), cache_.zeroth_place(first, width)};
  }

  /// Begins a stream.
  void begin() {
    if (++cache_.now != 0) return;
    std::memset(cache_.turn, 0, cache_.places * sizeof *cache_.turn);
    cache_.now = 1;
  }

  static HWY_INLINE VI load(const int32_t* values) { return hn::Load(DI(), values); }

  /// Decodes a block to its place, unless the stream reads another block there. Returns whether it lies there.
  HWY_INLINE bool load_block(uint32_t block, uint32_t place) {
    if (HWY_LIKELY(cache_.block[place] == block)) return true;
    if (HWY_UNLIKELY(cache_.turn[place] == cache_.now)) return false;
    decode_(block_at(texture_, block), cache_.texels + size_t{4} * place * size_, size_t{cache_.pitch} * size_);
    cache_.block[place] = block;
    return true;
  }

  /// Columns of a row of blocks that this stream has found side by side. Column x of texel row y of a block is texel
  /// x + y * pitch + offset of the cache.
  struct Window {
    uint32_t first = UINT32_MAX, row = 0;  // first block of the image; row of blocks
    int32_t begin = 0, end = 0, offset = 0;
  };

  /// Loads the blocks of columns low..high of a row of blocks. Columns after known ones make more of them known:
  /// vectors of tags that were written lately would wait for the writes.
  HWY_NOINLINE bool open_window(const Image& image, uint32_t row, int32_t low, int32_t high, Window* window) {
    const bool follows =
        window->first == image.first && window->row == row && window->begin <= low && low <= window->end;
    const auto begin = static_cast<uint32_t>(follows ? window->begin : low) / 4;
    const uint32_t from = follows ? static_cast<uint32_t>(window->end) / 4 : begin;
    const uint32_t end = static_cast<uint32_t>(high) / 4 + 1, place = cache_.place_of(begin, row, image.zeroth);
    const uint32_t block = image.first + row * image.across;
    const uint32_t found = load_run(block + from, place + from - begin, end - from);
    if (HWY_UNLIKELY(found == 0)) return false;
    *window = {image.first, row, 4 * static_cast<int32_t>(begin), 4 * static_cast<int32_t>(from + found),
               4 * static_cast<int32_t>(place - begin)};
    return true;
  }

  /// Loads blocks of a row, and marks their places as read. Returns the number of blocks that lie there, `count` or
  /// more, or 0 if the stream reads others at their places.
  HWY_INLINE uint32_t load_run(uint32_t block, uint32_t place, uint32_t count) {
    const DU du;
    const auto lanes = static_cast<uint32_t>(hn::Lanes(du));
    const auto ordinals = hn::Load(du, kOrdinals);  // hn::Iota() would write them one by one, and wait for the writes
    if (HWY_UNLIKELY(place + count > cache_.places)) return 0;
    uint32_t found = 0;
    while (found < count) {
      const auto there = hn::Eq(hn::LoadU(du, cache_.block + place + found), hn::Set(du, block + found) + ordinals);
      const intptr_t other = hn::FindFirstTrue(du, hn::Not(there));
      uint32_t run = other < 0 ? lanes : static_cast<uint32_t>(other);
      const uint32_t wanted = count - found < lanes ? count - found : lanes;
      if (HWY_UNLIKELY(run < wanted)) {
        if (!load_blocks(block + found, place + found, wanted)) return 0;
        run = wanted;
      }
      hn::BlendedStore(hn::Set(du, cache_.now), hn::FirstN(du, run), du, cache_.turn + place + found);
      found += run;
    }
    return found;
  }

  /// Loads at most a vector of blocks of a row.
  HWY_NOINLINE bool load_blocks(uint32_t block, uint32_t place, uint32_t count) {
    for (uint32_t k = 0; k < count; ++k) {
      if (HWY_UNLIKELY(!load_block(block + k, place + k))) return false;
    }
    return true;
  }

  const Texture& texture_;
  BcCache& cache_;
  const DecodeBc decode_;
  const uint32_t size_;  // bytes of a texel
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_WINDOWS_INL_H_
