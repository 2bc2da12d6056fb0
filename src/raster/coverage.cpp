// SPDX-License-Identifier: MIT
#include "raster/coverage.h"

#include <cstring>

#include "raster/wide_coverage.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/coverage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/depth_bounds-inl.h"
#include "raster/small_triangles-inl.h"
#include "raster/traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The depths whose outcome differs from the outcome of equal depths: only smaller ones (LESS, GREATER_EQUAL), only
/// larger ones (GREATER, LESS_EQUAL), or any (the other comparisons).
enum class Unlike { kSmaller, kLarger, kAny };

constexpr Unlike unlike_of(const DepthTest& test) {
  if ((test.less != test.equal) == (test.greater != test.equal)) return Unlike::kAny;
  return test.less != test.equal ? Unlike::kSmaller : Unlike::kLarger;
}

/// passes() for vectors.
template <Unlike kUnlike>
class Passes {
 public:
  HWY_INLINE explicit Passes(const DepthTest& test)
      : smaller_(All(test.less != test.equal)), larger_(All(test.greater != test.equal)), equal_(All(test.equal)) {}

  HWY_INLINE MaskV operator()(V z, V stored) const {
    if (kUnlike == Unlike::kSmaller) return hn::Xor(hn::Lt(z, stored), equal_);
    if (kUnlike == Unlike::kLarger) return hn::Xor(hn::Lt(stored, z), equal_);
    const auto smaller = hn::And(smaller_, hn::Lt(z, stored)), larger = hn::And(larger_, hn::Lt(stored, z));
    return hn::Xor(hn::Or(smaller, larger), equal_);
  }

 private:
  static HWY_INLINE MaskV All(bool set) { return hn::FirstN(Tag(), set ? hn::Lanes(Tag()) : 0); }

  const MaskV smaller_, larger_, equal_;
};

/// Passes for one depth.
template <Unlike kUnlike>
HWY_INLINE bool PassesOne(const DepthTest& test, float z, float stored) {
  if (kUnlike == Unlike::kSmaller) return (z < stored) != test.equal;
  if (kUnlike == Unlike::kLarger) return (stored < z) != test.equal;
  const bool smaller = test.less != test.equal && z < stored, larger = test.greater != test.equal && stored < z;
  return (smaller || larger) != test.equal;
}

/// Compile-time variant of a kernel. Rejected alternatives: a kernel for each of the eight comparisons was five times
/// the code and no faster; one kernel for all of them, always clipped, was a quarter of the code but up to a third
/// slower.
template <Samples kSamples_, Unlike kUnlike_, bool kClipped_>
struct Variant {
  static constexpr Samples kSamples = kSamples_;
  static constexpr Unlike kUnlike = kUnlike_;
  static constexpr bool kClipped = kClipped_;
};

/// Calls body(variant) with the kernel variant for a tile.
template <Samples kSamples, class Body>
HWY_INLINE void WithTest(const DepthTest& test, bool clipped, const Body& body) {
  const Unlike unlike = unlike_of(test);
  if (unlike == Unlike::kAny) return body(Variant<kSamples, Unlike::kAny, true>());
  if (unlike == Unlike::kSmaller) {
    return clipped ? body(Variant<kSamples, Unlike::kSmaller, true>())
                   : body(Variant<kSamples, Unlike::kSmaller, false>());
  }
  return clipped ? body(Variant<kSamples, Unlike::kLarger, true>()) : body(Variant<kSamples, Unlike::kLarger, false>());
}
template <class Body>
HWY_INLINE void WithVariant(uint32_t samples, const DepthTest& test, bool clipped, const Body& body) {
  if (samples == 1) return WithTest<Samples::kSingle>(test, clipped, body);
  if (samples <= hn::Lanes(Tag())) return WithTest<Samples::kOneVector>(test, clipped, body);
  return WithTest<Samples::kVectors>(test, clipped, body);
}

/// For a smaller box, covering the pixels costs less than testing the bounds.
constexpr int32_t kMinBoundedPixels = 128;

/// Where cover() draws, and how.
struct CoverTarget {
  const CoverArea& area;
  const DepthState& state;
  Tile& tile;
  bool has_slots;
};

template <class Variant>
HWY_INLINE void CoverSmall(const CoverTarget& target, const SmallTriangles& triangles, size_t i, uint32_t number) {
  const DepthTest test = depth_test(target.state.compare);
  float* depth = target.tile.depth.data();
  uint32_t* slot = target.tile.slot.data();
  const bool writes = target.state.writes, has_slots = target.has_slots;
  ForEachSmall<Variant::kSamples>(triangles, i, target.area.pattern.count, [&](size_t at, float z) {
    const float stored = depth[at];
    const bool pass = PassesOne<Variant::kUnlike>(test, z, stored);
    if (writes) depth[at] = pass ? z : stored;
    if (has_slots) slot[at] = pass ? number : slot[at];
  });
}

/// Whether all depths of one range pass against all depths of another. Conservative: false for the comparisons that
/// are not ordered.
HWY_INLINE bool AllPass(const DepthTest& test, const DepthRange& z, const DepthRange& stored) {
  if (test.less == test.greater) return false;
  return test.less ? passes(test, z.high, stored.low) : passes(test, z.low, stored.high);
}

/// Draws a triangle that covers the whole tile and passes at every sample. Returns false for other triangles.
HWY_NOINLINE bool CoverWhole(const CoverTarget& target, const TriangleSetup& setup, uint32_t number) {
  Tile& tile = target.tile;
  const DepthRange range = {setup.slope.low, setup.slope.high};
  if (!covers_tile(setup) || !AllPass(depth_test(target.state.compare), range, tile.range)) return false;
  if (target.has_slots) tile.sole_slot = number;
  if (!target.state.writes) return true;
  tile.range = range;
  float* depth = tile.depth.data();
  ForEachCovered<Variant<Samples::kSingle, Unlike::kAny, false>>(
      setup, [&](size_t at, MaskV, V z) { hn::Store(z, Tag(), depth + at); });
  return true;
}

template <class Variant>
HWY_NOINLINE void CoverLarge(const CoverTarget& target, const geometry::ScreenTriangle& triangle, uint32_t number,
                             Bounds& bounds) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  const DepthState& state = target.state;
  const geometry::PixelBox box = box_in_tile(triangle, target.area);
  if (geometry::is_empty(box)) return;
  const int32_t pixels = (box.max_x - box.min_x + 1) * (box.max_y - box.min_y + 1);
  if (pixels >= kMinBoundedPixels && !is_biased(state) && !bounds.MayPass(BlockBox(box), triangle)) return;
  TriangleSetup setup;
  if (!set_up(triangle, target.area, state, box, &setup)) return;
  if (Variant::kSamples == Samples::kSingle && CoverWhole(target, setup, number)) return;
  begin_samples(&target.tile);
  if (!setup.is_narrow) return cover_wide(setup, state, number, &target.tile);
  const Passes<Variant::kUnlike> passes(depth_test(state.compare));
  float* depth = target.tile.depth.data();
  uint32_t* slot = target.tile.slot.data();
  const bool has_slots = target.has_slots;
  const auto id = hn::Set(du, number);
  ForEachCovered<Variant>(setup, [&](size_t at, MaskV inside, V z) {
    const auto stored = hn::Load(d, depth + at);
    const auto pass = hn::And(inside, passes(z, stored));
    if (state.writes) hn::Store(hn::IfThenElse(pass, z, stored), d, depth + at);
    if (has_slots) {
      hn::Store(hn::IfThenElse(hn::RebindMask(du, pass), id, hn::Load(du, slot + at)), du, slot + at);
    }
  });
}

template <class Variant>
void CoverWith(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle* triangles,
               const uint32_t* entries, size_t count, uint32_t first_slot, Tile& tile) {
  const CoverTarget target = {area, state, tile, first_slot != kNoSlot};
  Bounds bounds(trend_of(depth_test(state.compare)), state.writes, tile);
  SmallTriangles small;
  small.is_small = 0;
  const size_t lanes = hn::Lanes(Tag());
  for (size_t begin = 0; begin < count; begin += lanes) {
    const size_t end = std::min(begin + lanes, count);
    if (!is_biased(state)) SetUpSmall(area, triangles, entries + begin, end - begin, small);
    if (small.is_small) begin_samples(&tile);
    for (size_t i = begin; i < end; ++i) {
      const uint32_t number = target.has_slots ? first_slot + static_cast<uint32_t>(i) : kNoSlot;
      if (small.is_small >> (i - begin) & 1) {
        CoverSmall<Variant>(target, small, i - begin, number);
      } else {
        CoverLarge<Variant>(target, triangles[entries[i]], number, bounds);
      }
    }
  }
}

/// Adds the samples of a vector to the masks of their pixels; the first sample lies at `at`.
template <class M>
HWY_INLINE void AddToMasks(M pass, size_t at, uint32_t samples, uint32_t* bits) {
  const Tag d;
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, pass, bytes);
  uint32_t rest = static_cast<uint32_t>(bytes[0]) | static_cast<uint32_t>(bytes[1]) << 8;
  uint32_t* pixel = bits + at / samples;
  const uint32_t all = (1u << samples) - 1;
  for (uint32_t shift = static_cast<uint32_t>(at % samples); rest; rest >>= samples, ++pixel) {
    *pixel |= (rest & all) << shift;
  }
}

template <class Variant>
void MaskWith(const TriangleSetup& setup, const DepthState& state, const Tile& tile, CoverMask& out) {
  static_assert(hn::MaxLanes(Tag()) <= 16, "two bytes of mask");
  const Passes<Variant::kUnlike> passes(depth_test(state.compare));
  const float* depth = tile.depth.data();
  ForEachCovered<Variant>(setup, [&](size_t at, MaskV inside, V z) {
    const auto pass = hn::And(inside, passes(z, hn::Load(Tag(), depth + at)));
    AddToMasks(pass, at, setup.pattern->count, out.bits);
  });
}

void Cover(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle* triangles,
           const uint32_t* entries, size_t count, uint32_t first_slot, Tile& tile) {
  WithVariant(area.pattern.count, depth_test(state.compare), is_clipped(area), [&](auto variant) {
    CoverWith<decltype(variant)>(area, state, triangles, entries, count, first_slot, tile);
  });
}

void Mask(const TriangleSetup& setup, const DepthState& state, bool clipped, const Tile& tile, CoverMask& out) {
  WithVariant(setup.pattern->count, depth_test(state.compare), clipped,
              [&](auto variant) { MaskWith<decltype(variant)>(setup, state, tile, out); });
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(Cover);
HWY_EXPORT(Mask);

void cover(const core::SimdTarget& simd, const CoverArea& area, const DepthState& state,
           const geometry::ScreenTriangle* triangles, const uint32_t* entries, size_t count, uint32_t first_slot,
           Tile* tile) {
  SHD_DISPATCH(Cover, simd)(area, state, triangles, entries, count, first_slot, *tile);
}

void cover_mask(const core::SimdTarget& simd, const CoverArea& area, const DepthState& state,
                const geometry::ScreenTriangle& triangle, const Tile& tile, CoverMask* out) {
  out->box = box_in_tile(triangle, area);
  if (geometry::is_empty(out->box)) return;
  const int32_t first = out->box.min_x & ~15, end = (out->box.max_x | 15) + 1;  // kernels write whole vectors
  for (int32_t y = out->box.min_y; y <= out->box.max_y; ++y) {
    std::memset(out->bits + y * kTile + first, 0, static_cast<size_t>(end - first) * sizeof(uint32_t));
  }
  TriangleSetup setup;
  if (!set_up(triangle, area, state, out->box, &setup)) return;
  if (setup.is_narrow) {
    SHD_DISPATCH(Mask, simd)(setup, state, is_clipped(area), tile, *out);
  } else {
    mask_wide(setup, state, tile, out);
  }
}

}  // namespace shd::raster
#endif  // HWY_ONCE
