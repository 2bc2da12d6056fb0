// SPDX-License-Identifier: MIT
#include "light/shadow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/shadow_pcss.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/shadow_receiver-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

constexpr float kReach = 2.0f;  // [texels] size of a texel and of the bilinear comparison around it

/// n x n taps in the square -1..1, one in each cell of a grid, in the canonical arrangement of multi-jittered samples
/// (Chiu, Shirley and Wang, "Multi-Jittered Sampling", 1994). An edge parallel to the axes of the map crosses the taps
/// one by one instead of n together. Within its cell, each tap of a point is shifted by the same random vector and
/// wrapped around (Cranley and Patterson, "Randomization of Number Theoretic Methods for Multiple Integration", 1976),
/// so that errors appear as noise between neighbours instead of as copies of an edge.
template <class D>
class TapGrid {
 public:
  using V = hn::Vec<D>;

  HWY_INLINE TapGrid(D d, uint32_t taps, ShadowBits<D> random) : step_(2.0f / static_cast<float>(taps)) {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const V scale = hn::Set(d, 0x1p-16f * step_);
    const V shift_x = hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<16>(random))) * scale;
    const V shift_y = hn::ConvertTo(d, hn::BitCast(di, hn::And(random, hn::Set(du, 0xffffu)))) * scale;
    for (uint32_t k = 0; k < taps; ++k) {
      const float part = (static_cast<float>(k) + 0.5f) * 0.5f * step_ * step_;
      hn::Store(within_cell(d, shift_x, part), d, in_row_[k]);
      hn::Store(within_cell(d, shift_y, part), d, in_column_[k]);
    }
  }
  HWY_INLINE V x(D d, uint32_t column, uint32_t row) const {
    return hn::Load(d, in_row_[row]) + hn::Set(d, static_cast<float>(column) * step_);
  }
  HWY_INLINE V y(D d, uint32_t column, uint32_t row) const {
    return hn::Load(d, in_column_[column]) + hn::Set(d, static_cast<float>(row) * step_);
  }

 private:
  /// Place in the first cell, -1..-1 + step.
  HWY_INLINE V within_cell(D d, V shift, float part) const {
    const V at = shift + hn::Set(d, part), step = hn::Set(d, step_);
    return at - hn::IfThenElseZero(hn::Ge(at, step), step) - hn::Set(d, 1.0f);
  }

  const float step_;  // edge length of a cell
  alignas(64) float in_row_[kMaxTaps][kMaxReceiverLanes];
  alignas(64) float in_column_[kMaxTaps][kMaxReceiverLanes];
};

/// Compares the plane of the surface with texels. Texels outside the map are empty.
template <class D>
class Comparison {
 public:
  using V = hn::Vec<D>;

  HWY_INLINE Comparison(D d, const ShadowMap& map, const Receiver<D>& at)
      : map_(map), at_(at), first_(PlaneDepth(d, at, hn::Zero(d), hn::Zero(d))) {}

  /// Depth of a texel and of the plane at its centre.
  HWY_INLINE V depth(D d, V column, V row) const {
    const auto size = static_cast<float>(map_.size);
    const V x = Clamp(d, column, -1.0f, size), y = Clamp(d, row, -1.0f, size);
    return GatherDepths(d, map_, TexelIndex(d, map_, at_.face, x, y));
  }
  HWY_INLINE V plane(V column, V row) const { return first_ + (at_.dx * column + at_.dy * row); }

  /// The bilinear mean of four comparisons around (x, y).
  HWY_INLINE V bilinear(D d, V x, V y) const {
    const hn::RebindToSigned<D> di;
    const V half = hn::Set(d, 0.5f);
    const V left = x - half, top = y - half;
    const V column = RoundDown(left), row = RoundDown(top);
    const V fx = left - column, fy = top - row;
    const V z = plane(column, row);
    const auto size = static_cast<float>(map_.size);
    const V inner_column = Clamp(d, column, -2.0f, size), inner_row = Clamp(d, row, -2.0f, size);
    const auto index = TexelIndex(d, map_, at_.face, inner_column, inner_row);
    const auto below = index + hn::Set(di, static_cast<int32_t>(map_.pitch));
    return Mix(lit_pair(d, index, z, fx), lit_pair(d, below, z + at_.dy, fx), fy);
  }

 private:
  static HWY_INLINE V Mix(V a, V b, V f) { return a + f * (b - a); }
  /// Mean of the comparisons with a texel and its right neighbour.
  HWY_INLINE V lit_pair(D d, ShadowInts<D> index, V z, V fx) const {
    const V one = hn::Set(d, 1.0f);
    V depth, next_depth;
    GatherPairs(d, map_.depth.data(), index, &depth, &next_depth);
    const V lit = hn::IfThenElseZero(hn::Le(z, depth), one);
    return Mix(lit, hn::IfThenElseZero(hn::Le(z + at_.dx, next_depth), one), fx);
  }

  const ShadowMap& map_;
  const Receiver<D>& at_;
  const V first_;  // depth of the plane at the centre of texel 0, 0
};

/// Relation of depths and widths on the map: the rays from a point to the light.
template <class D>
struct LightCone {
  using V = hn::Vec<D>;
  const Receiver<D>& at;
  bool is_perspective;
  float half_light, near, max_width;

  /// Half the width of the rays [texels] where they have a depth.
  HWY_INLINE V half_width(D d, V depth) const {
    const V gap = hn::Set(d, half_light) * hn::Max(at.z - depth, hn::Zero(d));
    const V length = is_perspective ? gap / hn::Max(depth, hn::Set(d, near)) : gap;
    return Clamp(d, length / at.texel, 0.0f, max_width);
  }
  /// Whether a ray meets a texel at a depth and a distance [texels] across or along the map from the point: whether
  /// distance - kReach is at most the half width before it is clamped, times the denominators.
  HWY_INLINE hn::Mask<D> RayHitsBlocker(D d, V depth, V distance) const {
    const V light = hn::Set(d, half_light), length = (distance - hn::Set(d, kReach)) * at.texel;
    const V scaled = is_perspective ? length * depth : length;
    return hn::Le(scaled, light * (at.z - depth));
  }
};

/// Mean depth of blockers, and the lanes that have one.
template <class D>
struct Blockers {
  hn::Vec<D> depth;
  hn::Mask<D> found;
};

/// Searches the part of the map that rays to the light cross. Distances of taps are cubed: half of the taps lie within
/// an eighth of the square, where the blockers of contacts are. A blocker that no ray to the light meets (Guennebaud,
/// Barthe and Paulin, "Real-Time Soft Shadow Mapping by Backprojection", 2006) counts only if there is no other,
/// because another part of the same object may hide the light. Without this test, distant blockers widen the shadows of
/// contacts until they vanish, and walls are darkened by the ground in front of them.
template <class D>
HWY_INLINE Blockers<D> FindBlockers(D d, const Comparison<D>& comparison, const LightCone<D>& cone,
                                    const TapGrid<D>& grid, uint32_t taps) {
  using V = hn::Vec<D>;
  const Receiver<D>& at = cone.at;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V half = hn::Max(cone.half_width(d, hn::Set(d, cone.near)), one);
  V sum = zero, count = zero, any_sum = zero, any_count = zero;
  for (uint32_t i = 0; i < taps; ++i) {
    for (uint32_t j = 0; j < taps; ++j) {
      const V u = grid.x(d, j, i), v = grid.y(d, j, i);
      const V x = half * (u * u * u), y = half * (v * v * v);
      const V column = RoundDown(at.x + x), row = RoundDown(at.y + y);
      const V depth = comparison.depth(d, column, row);
      const auto blocks = hn::Lt(depth, comparison.plane(column, row));
      const auto meets = hn::And(blocks, cone.RayHitsBlocker(d, depth, hn::Max(hn::Abs(x), hn::Abs(y))));
      sum = sum + hn::IfThenElseZero(meets, depth);
      count = count + hn::IfThenElseZero(meets, one);
      any_sum = any_sum + hn::IfThenElseZero(blocks, depth);
      any_count = any_count + hn::IfThenElseZero(blocks, one);
    }
  }
  const auto met = hn::Gt(count, zero);
  const V total = hn::IfThenElse(met, sum, any_sum), number = hn::IfThenElse(met, count, any_count);
  return {total / hn::Max(number, one), hn::Gt(any_count, zero)};
}

/// Percentage-closer soft shadows (Fernando, 2005): finds the mean depth of the blockers, derives the width of the
/// penumbra from it, and averages comparisons over this width.
void SamplePcss(const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  const ShadowMap& map = shadow.map;
  const ShadowPlacement& placement = map.placement;
  const uint32_t taps = shadow.options.taps;
  const bool is_perspective = placement.projection != ShadowProjection::kOrthographic;
  const float max_width = static_cast<float>(map.size) / static_cast<float>(kMaxRadiusPart);
  ForEachReceiver<ReceiverTag>(shadow, in, visibility, [&](auto d, const auto& at) {
    using D = decltype(d);
    using V = hn::Vec<D>;
    const Comparison<D> comparison(d, map, at);
    const LightCone<D> cone = {at, is_perspective, 0.5f * shadow.options.light_size, placement.near, max_width};
    const TapGrid<D> grid(d, taps, at.random);
    const Blockers<D> blockers = FindBlockers(d, comparison, cone, grid, taps);
    const V one = hn::Set(d, 1.0f);
    if (hn::AllFalse(d, blockers.found)) return one;
    const V half = cone.half_width(d, blockers.depth);
    V lit = hn::Zero(d);
    for (uint32_t i = 0; i < taps; ++i) {
      for (uint32_t j = 0; j < taps; ++j) {
        lit = lit + comparison.bilinear(d, at.x + half * grid.x(d, j, i), at.y + half * grid.y(d, j, i));
      }
    }
    return hn::IfThenElse(blockers.found, lit / hn::Set(d, static_cast<float>(taps * taps)), one);
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
