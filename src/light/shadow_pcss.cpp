// SPDX-License-Identifier: MIT
#include "light/shadow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/shadow_pcss.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/shadow_receiver-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// n x n taps around a point, one in each cell of a square, in the canonical arrangement of multi-jittered samples
/// (Chiu, Shirley and Wang, "Multi-Jittered Sampling", 1994). An edge parallel to the axes of the map crosses the taps
/// one by one instead of n together.
template <class D, class V>
struct TapGrid {
  V step, first;
  float inverse;

  HWY_INLINE TapGrid(D d, uint32_t taps, V half) : inverse(1.0f / static_cast<float>(taps)) {
    step = half * hn::Set(d, 2.0f * inverse);
    first = half * hn::Set(d, inverse * inverse - 1.0f);
  }
  /// Offset along the axis that `cell` counts along.
  HWY_INLINE V offset(D d, uint32_t cell, uint32_t other) const {
    const float position = static_cast<float>(cell) + static_cast<float>(other) * inverse;
    return first + step * hn::Set(d, position);
  }
};

/// Compares the plane of the surface with texels. Texels outside the map are empty.
template <class D>
struct Comparison {
  const ShadowMap& map;
  const Receiver<D>& at;
  using V = hn::Vec<D>;

  HWY_INLINE V depth(D d, V column, V row) const {
    const auto size = static_cast<float>(map.size);
    const V x = Clamp(d, column, -1.0f, size), y = Clamp(d, row, -1.0f, size);
    return GatherDepths(d, map, TexelIndex(d, map, at.face, x, y));
  }
  /// The bilinear mean of four comparisons around (x, y).
  HWY_INLINE V bilinear(D d, V x, V y) const {
    const V half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f);
    const V left = x - half, top = y - half;
    const V column = hn::Floor(left), row = hn::Floor(top);
    const V fx = left - column, fy = top - row;
    const V plane = PlaneDepth(d, at, column, row);
    return Mix(lit_pair(d, column, row, plane, fx), lit_pair(d, column, row + one, plane + at.dy, fx), fy);
  }

 private:
  static HWY_INLINE V Mix(V a, V b, V f) { return a + f * (b - a); }
  /// Mean of the comparisons with a texel and its right neighbour.
  HWY_INLINE V lit_pair(D d, V column, V row, V plane, V fx) const {
    const auto size = static_cast<float>(map.size);
    const V x = Clamp(d, column, -2.0f, size), y = Clamp(d, row, -1.0f, size), one = hn::Set(d, 1.0f);
    V depth, next_depth;
    GatherPairs(d, map.depth.data(), TexelIndex(d, map, at.face, x, y), &depth, &next_depth);
    const V lit = hn::IfThenElseZero(hn::Le(plane, depth), one);
    return Mix(lit, hn::IfThenElseZero(hn::Le(plane + at.dx, next_depth), one), fx);
  }
};

/// Percentage-closer soft shadows (Fernando, 2005): finds the mean depth of the blockers in the part of the map that
/// rays to the light cross, derives the width of the penumbra from it, and averages comparisons over this width.
void SamplePcss(const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  const ShadowMap& map = shadow.map;
  const ShadowPlacement& placement = map.placement;
  const uint32_t taps = shadow.options.taps;
  const bool is_perspective = placement.projection != ShadowProjection::kOrthographic;
  const float max_width = static_cast<float>(map.size) / static_cast<float>(kMaxRadiusPart);
  ForEachReceiver<ReceiverTag>(shadow, in, visibility, [&](auto d, const auto& at) {
    using D = decltype(d);
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half_light = hn::Set(d, 0.5f * shadow.options.light_size);
    const auto half_width = [&](V blocker) {
      const V gap = half_light * hn::Max(at.z - blocker, zero);
      const V length = is_perspective ? gap / hn::Max(blocker, hn::Set(d, placement.near)) : gap;
      return Clamp(d, length / at.texel, 0.0f, max_width);
    };
    const Comparison<D> comparison = {map, at};
    const TapGrid<D, V> search(d, taps, hn::Max(half_width(hn::Set(d, placement.near)), one));
    V sum = zero, count = zero;
    for (uint32_t i = 0; i < taps; ++i) {
      for (uint32_t j = 0; j < taps; ++j) {
        const V column = hn::Floor(at.x + search.offset(d, j, i));
        const V row = hn::Floor(at.y + search.offset(d, i, j));
        const V depth = comparison.depth(d, column, row);
        const auto blocks = hn::Lt(depth, PlaneDepth(d, at, column, row));
        sum = sum + hn::IfThenElseZero(blocks, depth);
        count = count + hn::IfThenElseZero(blocks, one);
      }
    }
    if (hn::AllTrue(d, hn::Eq(count, zero))) return one;
    const TapGrid<D, V> grid(d, taps, half_width(sum / hn::Max(count, one)));
    V lit = zero;
    for (uint32_t i = 0; i < taps; ++i) {
      for (uint32_t j = 0; j < taps; ++j) {
        const V x = at.x + grid.offset(d, j, i), y = at.y + grid.offset(d, i, j);
        lit = lit + comparison.bilinear(d, x, y);
      }
    }
    const V mean = lit / hn::Set(d, static_cast<float>(taps * taps));
    return hn::IfThenElse(hn::Eq(count, zero), one, mean);
  });
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::light {

HWY_EXPORT(SamplePcss);

void sample_pcss(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  SHD_DISPATCH(SamplePcss, simd)(shadow, in, visibility);
}

}  // namespace shd::light
#endif  // HWY_ONCE
