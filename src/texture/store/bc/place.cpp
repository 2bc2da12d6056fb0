// SPDX-License-Identifier: MIT
#include <cstring>

#include "texture/store/bc/cache.h"
#include "texture/store/bc/levels.h"
#include "texture/store/storage.h"
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/store/bc/place.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/bc/kernels-inl.h"
#include "texture/lanes-inl.h"
#include "texture/store/bc/place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

alignas(64) constexpr uint32_t kOrdinals[kMaxLanes] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

class Placer {
 public:
  Placer(const Texture& texture, BlockCache* cache)
      : texture_(texture),
        cache_(*cache),
        decode_(KernelOf(texture.blocks.decode)),
        size_(static_cast<uint32_t>(texel_size(texture))) {}

  void place(size_t end, Stream* stream) {
    const size_t lanes = hn::Lanes(BatchTag());
    begin();
    for (size_t e = 0; e < end; ++e) {
      const uint32_t op = stream->op[e];
      const size_t at = e * lanes;
      if (op & kNeighbours) {
        if (op & kQuad ? place_quad(at, stream) : place_row(at, stream)) continue;
        stream->op[e] = static_cast<uint16_t>(op & ~kNeighbours);
      } else if (!(op & kMerge)) {
        const size_t count = op & (kQuad | kRow) ? 4 : 1;
        for (size_t k = 0; k < count; ++k) place_texels(stream->index[k] + at, k * Stream::kCapacity + at);
      }
    }
  }

 private:
  using DI = hn::RebindToSigned<BatchTag>;
  using DU = hn::RebindToUnsigned<BatchTag>;

  /// Texels of a row of a level that lie in the cache side by side: texel i is texel i + offset of the cache.
  struct Run {
    bool found = false;
    int32_t offset = 0;
    uint32_t y = 0, column = 0, count = 0;  // row of texels; blocks
    const BlockLevel* level = nullptr;
  };

  void begin() {
    if (++cache_.now != 0) return;
    std::memset(cache_.turn, 0, cache_.places * sizeof *cache_.turn);
    cache_.now = 1;
  }

  /// Blocks that this stream has found side by side.
  struct Known {
    uint32_t block = 0, count = 0, place = 0;
  };

  HWY_INLINE static bool is_in(uint32_t texel, const BlockLevel& level) {
    return texel - level.first < level.end - level.first;
  }

  /// Returns the level of a texel. The two latest levels are kept, because elements often alternate between two.
  HWY_INLINE const BlockLevel& level_at(uint32_t texel) {
    if (HWY_LIKELY(is_in(texel, cache_.latest[recent_]))) return cache_.latest[recent_];
    recent_ ^= 1;
    if (HWY_UNLIKELY(!is_in(texel, cache_.latest[recent_]))) know(texel);
    return cache_.latest[recent_];
  }
  HWY_NOINLINE void know(uint32_t texel) { cache_.latest[recent_] = block_level_of(texture_, texel); }

  /// Decodes a block to its place, unless the stream reads another block there. Returns whether it lies there.
  HWY_INLINE bool load(uint32_t block, uint32_t place) {
    if (HWY_LIKELY(cache_.block[place] == block)) return true;
    if (HWY_UNLIKELY(cache_.turn[place] == cache_.now)) return false;
    decode_(block_at(texture_, block), cache_.texels + size_t{4} * place * size_, size_t{cache_.pitch} * size_);
    cache_.block[place] = block;
    return true;
  }

  /// Decodes the blocks of a vector of indices if they lie in one row of texels, with `more` texels after the last one.
  HWY_INLINE Run find_run(const int32_t* index, int32_t more) {
    const DI di;
    const DU du;
    const size_t lanes = hn::Lanes(di);
    const int32_t begin = index[0], last = index[lanes - 1];
    const int32_t low = begin < last ? begin : last, span = (begin < last ? last : begin) - low;
    const auto from_low = hn::BitCast(du, hn::Load(di, index) - hn::Set(di, low));
    const auto most = hn::Set(du, static_cast<uint32_t>(span));
    if (low < 0 || span > kLongest || !hn::AllTrue(du, hn::Eq(hn::Min(from_low, most), from_low))) return {};
    return find_between(low, low + span, more);
  }

  /// Decodes the blocks of texels low to high + more, if they lie in one row.
  HWY_INLINE Run find_between(int32_t low, int32_t high, int32_t more) {
    const auto first = static_cast<uint32_t>(low), length = static_cast<uint32_t>(high - low + more);
    const BlockLevel& level = level_at(first);
    const uint32_t n = first - level.first, y = row_of_texel(n, level.inverse), x = n - y * level.width;
    if (HWY_UNLIKELY(x + length >= level.width)) return {};
    Run run;
    run.y = y;
    run.column = x / 4;
    run.count = (x + length) / 4 - run.column + 1;
    run.level = &level;
    uint32_t place;
    run.found = load_row(run, y / 4, &place);
    run.offset = static_cast<int32_t>(y % 4 * cache_.pitch + 4 * (place - run.column) + x - first);
    return run;
  }

  /// Finds the runs of a vector of indices in one row of texels, most of which lie near both ends of the row: where
  /// SHD_WRAP_REPEAT wraps around. Returns whether there are two, and the vector in the cache.
  HWY_NOINLINE bool find_two_runs(const int32_t* index, int32_t more, int32_t* out) {
    const DI di;
    const auto all = hn::Load(di, index);
    const auto low = hn::MinOfLanes(di, all), high = hn::MaxOfLanes(di, all);
    const auto behind = hn::Gt(all, low + hn::ShiftRight<1>(high - low));
    const int32_t first = hn::GetLane(low), before = hn::GetLane(hn::MaxOfLanes(di, hn::IfThenElse(behind, low, all)));
    const int32_t after = hn::GetLane(hn::MinOfLanes(di, hn::IfThenElse(behind, all, high))), last = hn::GetLane(high);
    if (first < 0 || before - first > kLongest || last - after > kLongest) return false;
    const Run left = find_between(first, before, more), right = left.found ? find_between(after, last, more) : Run();
    if (!right.found) return false;
    hn::Store(all + hn::IfThenElse(behind, hn::Set(di, right.offset), hn::Set(di, left.offset)), di, out);
    return true;
  }

  /// Returns the run below another one: of texels `step` behind those of `top`.
  HWY_INLINE Run find_below(const Run& top, const int32_t* upper, const int32_t* lower) {
    const DI di;
    const int32_t step = lower[0] - upper[0];
    const auto far = hn::Load(di, lower) - hn::Load(di, upper);
    if (HWY_UNLIKELY(!hn::AllTrue(di, hn::Eq(far, hn::Set(di, step))))) return find_run(lower, 1);
    if (step == 0) return top;
    if (HWY_UNLIKELY(step != static_cast<int32_t>(top.level->width))) return find_run(lower, 1);
    Run run = top;
    run.offset += static_cast<int32_t>(cache_.pitch) - step;
    if (top.y % 4 < 3) return run;  // the same blocks
    uint32_t place;
    const uint32_t above = cache_.place_of(top.column, top.y / 4, top.level->number);
    run.found = load_row(run, top.y / 4 + 1, &place);
    run.offset += 4 * static_cast<int32_t>(place - above) - 4 * static_cast<int32_t>(cache_.pitch);
    return run;
  }

  /// Loads the blocks of a run in a row of blocks, and returns the place of the first one. Blocks after known ones
  /// make more of them known: vectors of tags that were written lately would wait for the writes.
  HWY_INLINE bool load_row(const Run& run, uint32_t row, uint32_t* place) {
    Known& known = known_[recent_][row % 2];
    const BlockLevel& level = *run.level;
    const uint32_t block = level.block + row * level.across + run.column, after = block - known.block;
    *place = cache_.place_of(run.column, row, level.number);
    if (after <= known.count && *place == known.place + after) {
      const uint32_t end = after + run.count, more = end - known.count;
      if (end <= known.count) return true;
      if (HWY_UNLIKELY(!load_run(known.block + known.count, known.place + known.count, more))) return false;
      known.count = end;
      return true;
    }
    if (HWY_UNLIKELY(!load_run(block, *place, run.count))) return false;
    known.block = block;
    known.count = run.count;
    known.place = *place;
    return true;
  }

  /// Loads blocks of a row, and marks their places as read.
  HWY_INLINE bool load_run(uint32_t block, uint32_t place, uint32_t count) {
    const DU du;
    const auto ordinals = hn::Load(du, kOrdinals);  // hn::Iota() would write them one by one, and wait for the writes
    if (HWY_UNLIKELY(place + count > cache_.places)) return false;
    for (uint32_t k = 0; k < count; k += static_cast<uint32_t>(hn::Lanes(du))) {
      const auto wanted = hn::FirstN(du, count - k);
      const auto there = hn::Eq(hn::LoadU(du, cache_.block + place + k), hn::Set(du, block + k) + ordinals);
      if (!hn::AllFalse(du, hn::AndNot(there, wanted)) && !load_blocks(block + k, place + k, count - k)) return false;
      hn::BlendedStore(hn::Set(du, cache_.now), wanted, du, cache_.turn + place + k);
    }
    return true;
  }

  /// Loads at most a vector of blocks of a row.
  HWY_NOINLINE bool load_blocks(uint32_t block, uint32_t place, uint32_t count) {
    const auto lanes = static_cast<uint32_t>(hn::Lanes(DU()));
    const uint32_t end = count < lanes ? count : lanes;
    for (uint32_t k = 0; k < end; ++k) {
      if (HWY_UNLIKELY(!load(block + k, place + k))) return false;
    }
    return true;
  }

  static HWY_INLINE void move(int32_t* index, Run run) {
    const DI di;
    hn::Store(hn::Load(di, index) + hn::Set(di, run.offset), di, index);
  }

  static HWY_INLINE void set_after(const int32_t* index, int32_t step, int32_t* to) {
    const DI di;
    hn::Store(hn::Load(di, index) + hn::Set(di, step), di, to);
  }

  /// Places a quad of neighbours. Returns whether they still are neighbours.
  HWY_INLINE bool place_quad(size_t at, Stream* stream) {
    int32_t *const upper = stream->index[0] + at, *const lower = stream->index[2] + at;
    const Run top = find_run(upper, 1), bottom = top.found ? find_below(top, upper, lower) : top;
    if (HWY_LIKELY(bottom.found)) {
      move(upper, top);
      move(lower, bottom);
      return true;
    }
    alignas(64) int32_t placed[2][kMaxLanes];
    if (find_two_runs(upper, 1, placed[0]) && find_two_runs(lower, 1, placed[1])) {
      const DI di;
      hn::Store(hn::Load(di, placed[0]), di, upper);
      hn::Store(hn::Load(di, placed[1]), di, lower);
      return true;
    }
    set_after(upper, 1, stream->index[1] + at);
    set_after(lower, 1, stream->index[3] + at);
    for (size_t k = 0; k < 4; ++k) place_apart(stream->index[k] + at, k * Stream::kCapacity + at);
    return false;
  }

  /// Places a row of neighbours. Columns are in the order 1, 2, 0, 3.
  HWY_INLINE bool place_row(size_t at, Stream* stream) {
    int32_t* const first = stream->index[2] + at;
    const Run run = find_run(first, 3);
    if (HWY_LIKELY(run.found)) {
      move(first, run);
      return true;
    }
    set_after(first, 1, stream->index[0] + at);
    set_after(first, 2, stream->index[1] + at);
    set_after(first, 3, stream->index[3] + at);
    for (size_t k = 0; k < 4; ++k) place_apart(stream->index[k] + at, k * Stream::kCapacity + at);
    return false;
  }

  /// Places a vector of texels. `spare`: number of its first texel among those of the stream.
  HWY_INLINE void place_texels(int32_t* index, size_t spare) {
    const Run run = find_run(index, 0);
    if (run.found) return move(index, run);
    place_apart(index, spare);
  }

  /// Places a vector of texels anywhere: together if they lie in one level and at places of their own.
  HWY_NOINLINE void place_apart(int32_t* index, size_t spare) {
    if (index[0] >= 0 && place_in_level(index)) return;
    place_each(index, spare);
  }

  /// Places texels of one level. Returns false, and leaves the indices as they are, if they are not in one level or if
  /// the stream reads two blocks of the same place.
  HWY_INLINE bool place_in_level(int32_t* index) {
    const DI di;
    const DU du;
    const BatchTag d;
    const BlockLevel& level = level_at(static_cast<uint32_t>(index[0]));
    const auto n = hn::Load(di, index) - hn::Set(di, static_cast<int32_t>(level.first));
    const auto un = hn::BitCast(du, n);
    if (!hn::AllTrue(du, hn::Eq(hn::Min(un, hn::Set(du, level.end - level.first - 1)), un))) return false;
    // The product is off by less than 3 * 2^-24 of a quotient below 2^16, so its floor is off by one at most.
    const auto width = hn::Set(di, static_cast<int32_t>(level.width)), one = hn::Set(di, 1);
    auto y = hn::ConvertTo(di, hn::ConvertTo(d, n) * hn::Set(d, 1.0f / static_cast<float>(level.width)));
    auto x = n - y * width;
    const auto before = hn::Lt(x, hn::Zero(di)), behind = hn::Not(hn::Lt(x, width));
    y = y - hn::IfThenElseZero(before, one) + hn::IfThenElseZero(behind, one);
    x = x + hn::IfThenElseZero(before, width) - hn::IfThenElseZero(behind, width);
    const auto column = hn::ShiftRight<2>(x), row = hn::ShiftRight<2>(y);
    const uint32_t half = cache_.places / 2;
    const auto zeroth = hn::Set(di, static_cast<int32_t>(cache_.place_of(0, 0, level.number)));
    const auto mask = hn::Set(di, static_cast<int32_t>(half - 1)), bit = hn::Set(di, static_cast<int32_t>(half));
    const auto step = hn::Set(di, static_cast<int32_t>(BlockCache::kRowStep));
    const auto place = hn::Or(hn::And(column + row * step + zeroth, mask), hn::And(zeroth, bit));
    const auto block =
        hn::Set(di, static_cast<int32_t>(level.block)) + row * hn::Set(di, static_cast<int32_t>(level.across)) + column;
    const auto there = hn::GatherIndex(di, reinterpret_cast<const int32_t*>(cache_.block), place);
    if (!load_missing(place, block, hn::Eq(there, block))) return false;
    const auto low = hn::Set(di, 3), pitch = hn::Set(di, static_cast<int32_t>(cache_.pitch));
    hn::Store(hn::And(y, low) * pitch + hn::ShiftLeft<2>(place) + hn::And(x, low), di, index);
    return true;
  }

  /// Marks the places of a vector as read, and loads the blocks that are not there.
  template <class V, class M>
  HWY_INLINE bool load_missing(V place, V block, M there) {
    const DI di;
    alignas(64) uint32_t at[kMaxLanes], wanted[kMaxLanes];
    hn::Store(hn::BitCast(DU(), place), DU(), at);
    if (HWY_LIKELY(hn::AllTrue(di, there))) {
      for (size_t lane = 0; lane < hn::Lanes(di); ++lane) cache_.turn[at[lane]] = cache_.now;
      return true;
    }
    hn::Store(hn::BitCast(DU(), block), DU(), wanted);
    for (size_t lane = 0; lane < hn::Lanes(di); ++lane) {
      if (cache_.block[at[lane]] == wanted[lane]) {
        cache_.turn[at[lane]] = cache_.now;
      } else {
        __builtin_prefetch(block_at(texture_, wanted[lane]));
      }
    }
    for (size_t lane = 0; lane < hn::Lanes(di); ++lane) {
      if (!load(wanted[lane], at[lane])) return false;
      cache_.turn[at[lane]] = cache_.now;
    }
    return true;
  }

  /// Places texels one by one.
  HWY_NOINLINE void place_each(int32_t* index, size_t spare) {
    for (size_t lane = 0; lane < hn::Lanes(DI()); ++lane) {
      index[lane] = index[lane] < 0 ? ~0 : place_texel(static_cast<uint32_t>(index[lane]), spare + lane);
    }
  }

  HWY_INLINE int32_t place_texel(uint32_t texel, size_t spare) {
    const BlockLevel& level = level_at(texel);
    const uint32_t n = texel - level.first, y = row_of_texel(n, level.inverse), x = n - y * level.width;
    const uint32_t place = cache_.place_of(x / 4, y / 4, level.number);
    const uint32_t block = level.block + y / 4 * level.across + x / 4;
    if (HWY_LIKELY(load(block, place))) {
      cache_.turn[place] = cache_.now;
      return static_cast<int32_t>(y % 4 * cache_.pitch + 4 * place + x % 4);
    }
    const auto copy = static_cast<uint32_t>(cache_.spare + spare);
    std::memcpy(cache_.texels + size_t{copy} * size_, decoded_texel(texture_, texel, &decoded_), size_);
    return static_cast<int32_t>(copy);
  }

  static constexpr int32_t kLongest = 128;  // [texels]; runs with wider gaps are placed one by one

  const Texture& texture_;
  BlockCache& cache_;
  const DecodeBlock decode_;
  const uint32_t size_;
  Known known_[2][2];  // runs of the two latest levels, in even and in odd rows of blocks
  uint32_t recent_ = 0;
  DecodedBlock decoded_;
};

}  // namespace

void PlaceStream(const Texture& texture, BlockCache* cache, size_t end, Stream* stream) {
  Placer(texture, cache).place(end, stream);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
