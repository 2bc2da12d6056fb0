// SPDX-License-Identifier: MIT
#include "shade/cull.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/cull.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/finite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Bounds of one coordinate.
struct Interval {
  float low, high;
};

/// Bounds of the finite points. Without finite points the bounds are empty, and their distance to every light is 0.
Interval IntervalOf(const float* column, size_t count) {
  const hn::ScalableTag<float> d;
  const auto limit = hn::Inf(d);
  auto low = limit, high = hn::Neg(limit);
  // Points past count repeat the last one.
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto x = hn::Load(d, column + i);
    const auto finite = simd::HWY_NAMESPACE::IsFinite(d, x);
    low = hn::Min(low, hn::IfThenElse(finite, x, limit));
    high = hn::Max(high, hn::IfThenElse(finite, x, hn::Neg(limit)));
  }
  return {hn::GetLane(hn::MinOfLanes(d, low)), hn::GetLane(hn::MaxOfLanes(d, high))};
}

size_t CullLights(const LightTable& lights, const raster::Fragments& points, uint32_t* out) {
  const hn::ScalableTag<float> d;
  const size_t lanes = hn::Lanes(d);
  const Interval bounds[3] = {IntervalOf(points.px, points.count), IntervalOf(points.py, points.count),
                              IntervalOf(points.pz, points.count)};
  const float* const columns[3] = {lights.x.data(), lights.y.data(), lights.z.data()};
  size_t kept = 0;
  for (size_t i = 0; i < lights.count; i += lanes) {
    auto squared = hn::Zero(d);
    for (int c = 0; c < 3; ++c) {
      const auto at = hn::Load(d, columns[c] + i);
      const auto before = hn::Set(d, bounds[c].low) - at, after = at - hn::Set(d, bounds[c].high);
      const auto away = hn::Max(hn::Max(before, after), hn::Zero(d));
      squared = squared + away * away;
    }
    const auto affects = hn::Le(squared, hn::Load(d, lights.max_squared_distance.data() + i));
    HWY_ALIGN uint8_t bits[8] = {};
    hn::StoreMaskBits(d, affects, bits);
    for (size_t k = 0; k < lanes && i + k < lights.count; ++k) {
      out[kept] = static_cast<uint32_t>(i + k);
      kept += bits[k / 8] >> (k % 8) & 1;
    }
  }
  return kept;
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {

HWY_EXPORT(CullLights);

size_t cull_lights(const core::SimdTarget& simd, const LightTable& lights, const raster::Fragments& points,
                   uint32_t* out) {
  if (lights.any_range) return SHD_DISPATCH(CullLights, simd)(lights, points, out);
  for (size_t i = 0; i < lights.count; ++i) out[i] = static_cast<uint32_t>(i);
  return lights.count;
}

}  // namespace shd::shade
#endif  // HWY_ONCE
