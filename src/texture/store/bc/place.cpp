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

#include "simd/kernel_part.h"
#include "texture/lanes-inl.h"
#include "texture/store/bc/windows-inl.h"
#include "texture/store/place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

class Placer : BcWindows {
 public:
  Placer(const Texture& texture, BcCache* cache, Stream* stream) : BcWindows(texture, cache), stream_(*stream) {}

  void place(size_t end) {
    const size_t lanes = hn::Lanes(BatchTag());
    begin();
    for (size_t e = 0; e < end; ++e) {
      const uint32_t op = stream_.op[e];
      const size_t at = e * lanes;
      if (op & kNeighbours) {
        if (op & kQuad ? place_quad(at) : place_row(at)) continue;
        stream_.op[e] = static_cast<uint16_t>(op & ~kNeighbours);
      }
      for (size_t k = 0; k < stream_.texels_of(e); ++k) {
        const size_t row = stream_.row_of(e, k), image = stream_.image_of(e, k);
        place_texels(k, at, {stream_.places->y[row] + at, stream_.places->first[image] + at});
      }
    }
  }

 private:
  /// Rows and images of a vector of texels.
  struct Lines {
    const int32_t *y, *first;
  };

  static HWY_INLINE bool all_equal(const int32_t* values) {
    return hn::AllTrue(DI(), hn::Eq(load(values), hn::Set(DI(), values[0])));
  }

  HWY_INLINE Image image_of(size_t at, const int32_t* first) const {
    const auto width = static_cast<uint32_t>(stream_.places->width[at]), number = static_cast<uint32_t>(first[0]);
    return image_at(number, width);
  }

  /// Finds the blocks of columns low..high of row y side by side. Column x is then texel x + *offset of the cache.
  HWY_INLINE bool find_run(size_t at, const int32_t* first, int32_t low, int32_t high, int32_t y, int32_t* offset) {
    const auto row = static_cast<uint32_t>(y) / 4;
    Window& window = windows_[latest_][row % 2];
    const bool known = window.first == static_cast<uint32_t>(first[0]) && window.row == row && window.begin <= low &&
                       high < window.end;
    if (HWY_UNLIKELY(!known) && !open_window(image_of(at, first), row, low, high, &window)) return false;
    *offset = (y & 3) * static_cast<int32_t>(cache_.pitch) + window.offset;
    return true;
  }

  /// Places columns side by side of a row of texels, with `more` columns after each. Returns false if they are too far
  /// apart.
  HWY_INLINE bool place_run(size_t at, const int32_t* first, const int32_t* x, int32_t more, int32_t y, VI* index) {
    const DI di;
    const DU du;
    const int32_t begin = x[0], last = x[hn::Lanes(di) - 1];
    const int32_t low = begin < last ? begin : last, span = (begin < last ? last : begin) - low;
    const VI columns = load(x);
    const auto from_low = hn::BitCast(du, columns - hn::Set(di, low));
    const auto most = hn::Set(du, static_cast<uint32_t>(span));
    int32_t offset;
    if (HWY_LIKELY(span <= kLongest && hn::AllTrue(du, hn::Eq(hn::Min(from_low, most), from_low)))) {
      if (!find_run(at, first, low, low + span + more, y, &offset)) return false;
      *index = columns + hn::Set(di, offset);
      return true;
    }
    return place_two_runs(at, first, columns, more, y, index);
  }

  /// Places columns near both ends of a row: where SHD_WRAP_REPEAT wraps around.
  HWY_NOINLINE bool place_two_runs(size_t at, const int32_t* first, VI columns, int32_t more, int32_t y, VI* index) {
    const DI di;
    const auto low = hn::MinOfLanes(di, columns), high = hn::MaxOfLanes(di, columns);
    const auto behind = hn::Gt(columns, low + hn::ShiftRight<1>(high - low));
    const int32_t begin = hn::GetLane(low);
    const int32_t before = hn::GetLane(hn::MaxOfLanes(di, hn::IfThenElse(behind, low, columns)));
    const int32_t after = hn::GetLane(hn::MinOfLanes(di, hn::IfThenElse(behind, columns, high)));
    const int32_t last = hn::GetLane(high);
    int32_t left, right;
    if (before - begin > kLongest || last - after > kLongest) return false;
    if (!find_run(at, first, begin, before + more, y, &left)) return false;
    if (!find_run(at, first, after, last + more, y, &right)) return false;
    *index = columns + hn::IfThenElse(behind, hn::Set(di, right), hn::Set(di, left));
    return true;
  }

  /// Places a quad of neighbours in two rows of texels. Returns whether they still are neighbours; otherwise the
  /// columns of all texels are written.
  HWY_INLINE bool place_quad(size_t at) {
    const DI di;
    int32_t *const upper = stream_.index[0] + at, *const lower = stream_.index[2] + at;
    const StreamPlaces& places = *stream_.places;
    const int32_t *const top = places.y[0] + at, *const bottom = places.y[1] + at, *const first = places.first[0] + at;
    VI index[2];
    const VI apart = hn::Or(hn::Or(load(first) ^ hn::Set(di, first[0]), load(top) ^ hn::Set(di, top[0])),
                            load(bottom) ^ hn::Set(di, bottom[0]));
    latest_ ^= 1;  // elements often alternate between two levels
    if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(apart, hn::Zero(di))))) {
      const int32_t step = bottom[0] - top[0];
      if (HWY_LIKELY(place_run(at, first, upper, 1, top[0], &index[0]))) {
        // The row below lies in the same blocks, unless it is in the next ones.
        const bool same = step == 0 || (step == 1 && (top[0] & 3) != 3);
        index[1] = index[0] + hn::Set(di, step * static_cast<int32_t>(cache_.pitch));
        if (same || place_run(at, first, upper, 1, bottom[0], &index[1])) {
          hn::Store(index[0], di, upper);
          hn::Store(index[1], di, lower);
          return true;
        }
      }
    }
    if (place_two_quads(at)) return true;
    const VI left = load(upper), right = left + hn::Set(di, 1);
    hn::Store(right, di, stream_.index[1] + at);
    hn::Store(left, di, lower);
    hn::Store(right, di, stream_.index[3] + at);
    return false;
  }

  /// Places quads of lanes of two kinds, each with its level and its rows: lookups that pick one of two levels have
  /// them. Returns false and changes nothing if there are more kinds, or if columns are far apart.
  HWY_NOINLINE bool place_two_quads(size_t at) {
    const DI di;
    const StreamPlaces& places = *stream_.places;
    const auto like = [&](size_t lane) SHD_INLINE_LAMBDA {
      auto equal = hn::Eq(load(places.first[0] + at), hn::Set(di, places.first[0][at + lane]));
      for (size_t k = 0; k < 2; ++k) {
        equal = hn::And(equal, hn::Eq(load(places.y[k] + at), hn::Set(di, places.y[k][at + lane])));
      }
      return equal;
    };
    const auto first = like(0);
    const intptr_t other = hn::FindFirstTrue(di, hn::Not(first));
    if (other < 0 || !hn::AllTrue(di, hn::Or(first, like(static_cast<size_t>(other))))) return false;
    VI index[2], rest[2];
    if (!place_lanes(at, 0, first, index)) return false;
    if (!place_lanes(at, static_cast<size_t>(other), hn::Not(first), rest)) return false;
    for (size_t k = 0; k < 2; ++k) {
      hn::Store(hn::IfThenElse(first, index[k], rest[k]), di, stream_.index[2 * k] + at);
    }
    return true;
  }

  /// Places the quads of some lanes, whose level and rows are those of lane `lane`.
  HWY_INLINE bool place_lanes(size_t at, size_t lane, hn::Mask<DI> lanes, VI (&index)[2]) {
    const DI di;
    const StreamPlaces& places = *stream_.places;
    const VI all = load(stream_.index[0] + at);
    const VI columns = hn::IfThenElse(lanes, all, hn::Set(di, stream_.index[0][at + lane]));
    const int32_t low = hn::GetLane(hn::MinOfLanes(di, columns)), high = hn::GetLane(hn::MaxOfLanes(di, columns));
    if (high - low > kLongest) return false;
    latest_ = BcCache::parity_of(static_cast<uint32_t>(places.width[at + lane]));
    for (size_t k = 0; k < 2; ++k) {
      int32_t offset;
      if (!find_run(at + lane, places.first[0] + at + lane, low, high + 1, places.y[k][at + lane], &offset))
        return false;
      index[k] = columns + hn::Set(di, offset);
    }
    return true;
  }

  /// Places a row of neighbours, as place_quad() does. Columns are in the order 1, 2, 0, 3.
  HWY_INLINE bool place_row(size_t at) {
    int32_t* const left = stream_.index[2] + at;
    const int32_t *const y = stream_.places->y[0] + at, *const first = stream_.places->first[0] + at;
    VI index;
    if (!all_equal(first) || !all_equal(y) || !place_run(at, first, left, 3, y[0], &index)) return false;
    hn::Store(index, DI(), left);
    return true;
  }

  /// Places texel k of an element.
  HWY_INLINE void place_texels(size_t k, size_t at, const Lines& lines) {
    int32_t* const x = stream_.index[k] + at;
    if (HWY_LIKELY(all_equal(lines.first))) {
      const DI di;
      const bool outside = !hn::AllFalse(di, hn::Lt(hn::Or(load(x), load(lines.y)), hn::Zero(di)));
      VI index;
      if (HWY_LIKELY(!outside)) {
        if (all_equal(lines.y) && place_run(at, lines.first, x, 0, lines.y[0], &index)) return hn::Store(index, di, x);
        if (place_in_level(image_of(at, lines.first), load(x), load(lines.y), &index)) return hn::Store(index, di, x);
      }
    }
    place_each(k, at, lines);
  }

  /// Places texels of one level. Returns false if the stream reads two blocks of the same place.
  HWY_NOINLINE bool place_in_level(const Image& image, VI x, VI y, VI* index) {
    const DI di;
    const auto column = hn::ShiftRight<2>(x), row = hn::ShiftRight<2>(y);
    const uint32_t half = cache_.places / 2;
    const auto zeroth = hn::Set(di, static_cast<int32_t>(image.zeroth));
    const auto mask = hn::Set(di, static_cast<int32_t>(half - 1)), bit = hn::Set(di, static_cast<int32_t>(half));
    const auto step = hn::Set(di, static_cast<int32_t>(BcCache::kRowStep));
    const auto place = hn::Or(hn::And(column + row * step + zeroth, mask), hn::And(zeroth, bit));
    const auto block =
        hn::Set(di, static_cast<int32_t>(image.first)) + row * hn::Set(di, static_cast<int32_t>(image.across)) + column;
    const auto there = hn::GatherIndex(di, reinterpret_cast<const int32_t*>(cache_.block), place);
    if (!load_missing(place, block, hn::Eq(there, block))) return false;
    const auto low = hn::Set(di, 3), pitch = hn::Set(di, static_cast<int32_t>(cache_.pitch));
    *index = hn::And(y, low) * pitch + hn::ShiftLeft<2>(place) + hn::And(x, low);
    return true;
  }

  /// Marks the places of a vector as read, and loads the blocks that are not there.
  template <class M>
  HWY_INLINE bool load_missing(VI place, VI block, M there) {
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
      if (!load_block(wanted[lane], at[lane])) return false;
      cache_.turn[at[lane]] = cache_.now;
    }
    return true;
  }

  /// Places texels one by one.
  HWY_NOINLINE void place_each(size_t k, size_t at, const Lines& lines) {
    int32_t* const x = stream_.index[k] + at;
    for (size_t lane = 0; lane < hn::Lanes(DI()); ++lane) {
      const int32_t y = lines.y[lane];
      const Image image = image_of(at + lane, lines.first + lane);
      const size_t spare = k * Stream::kCapacity + at + lane;
      x[lane] =
          (x[lane] | y) < 0 ? ~0 : place_texel(image, static_cast<uint32_t>(x[lane]), static_cast<uint32_t>(y), spare);
    }
  }

  HWY_INLINE int32_t place_texel(const Image& image, uint32_t x, uint32_t y, size_t spare) {
    const uint32_t place = cache_.place_of(x / 4, y / 4, image.zeroth);
    const uint32_t block = image.first + y / 4 * image.across + x / 4;
    if (HWY_LIKELY(load_block(block, place))) {
      cache_.turn[place] = cache_.now;
      return static_cast<int32_t>(y % 4 * cache_.pitch + 4 * place + x % 4);
    }
    const auto copy = static_cast<uint32_t>(cache_.spare + spare);
    std::memcpy(cache_.texels + size_t{copy} * size_, texel_of_block(texture_, block, x % 4, y % 4, &memory_), size_);
    return static_cast<int32_t>(copy);
  }

  static constexpr int32_t kLongest = 128;  // [texels]; runs with wider gaps are placed one by one

  Stream& stream_;
  Window windows_[2][2];  // windows of elements in turn, in even and in odd rows of blocks
  uint32_t latest_ = 0;
  TexelMemory memory_;
};

}  // namespace

void PlaceInBc(void* state, size_t end, size_t, Stream* stream) {
  const auto& lease = *static_cast<CacheLease*>(state);
  Placer(lease.texture(), lease.cache(), stream).place(end);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
