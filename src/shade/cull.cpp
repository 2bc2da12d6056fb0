// SPDX-License-Identifier: MIT
#include "shade/cull.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/cull.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Span {
  float low, high;
};

/// Of the rows that are finite, and some whose distance is 0 if there are none.
Span SpanOf(const float* column, size_t count) {
  const hn::ScalableTag<float> d;
  const auto limit = hn::Set(d, __builtin_inff());
  auto low = limit, high = hn::Neg(limit);
  // Rows past count repeat the last one.
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto x = hn::Load(d, column + i);
    const auto finite = hn::Lt(hn::Abs(x), limit);
    low = hn::Min(low, hn::IfThenElse(finite, x, limit));
    high = hn::Max(high, hn::IfThenElse(finite, x, hn::Neg(limit)));
  }
  return {hn::GetLane(hn::MinOfLanes(d, low)), hn::GetLane(hn::MaxOfLanes(d, high))};
}

size_t CullLights(const LightTable& lights, const raster::Fragments& rows, uint32_t* out) {
  const hn::ScalableTag<float> d;
  const size_t lanes = hn::Lanes(d);
  const Span span[3] = {SpanOf(rows.px, rows.count), SpanOf(rows.py, rows.count), SpanOf(rows.pz, rows.count)};
  const float* const columns[3] = {lights.x.data(), lights.y.data(), lights.z.data()};
  size_t kept = 0;
  for (size_t i = 0; i < lights.count; i += lanes) {
    auto squared = hn::Zero(d);
    for (int c = 0; c < 3; ++c) {
      const auto at = hn::Load(d, columns[c] + i);
      const auto before = hn::Sub(hn::Set(d, span[c].low), at), after = hn::Sub(at, hn::Set(d, span[c].high));
      const auto away = hn::Max(hn::Max(before, after), hn::Zero(d));
      squared = hn::Add(squared, hn::Mul(away, away));
    }
    const auto reaches = hn::Le(squared, hn::Load(d, lights.reach.data() + i));
    HWY_ALIGN uint8_t bits[8] = {};
    hn::StoreMaskBits(d, reaches, bits);
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

size_t cull_lights(const core::SimdTarget& simd, const LightTable& lights, const raster::Fragments& rows,
                   uint32_t* out) {
  if (lights.any_range) return SHD_DISPATCH(CullLights, simd)(lights, rows, out);
  for (size_t i = 0; i < lights.count; ++i) out[i] = static_cast<uint32_t>(i);
  return lights.count;
}

}  // namespace shd::shade
#endif  // HWY_ONCE
