// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/colors.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "simd/tail-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

void FindColors(const Solid& solid, const float* values, size_t count, float* const* out) {
  const hn::ScalableTag<float> d;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const uint32_t steps = solid.color_count - 1;
  const auto low = hn::Set(d, solid.low), scale = hn::Set(d, solid.color_scale);
  const auto last = hn::Set(d, static_cast<float>(static_cast<int32_t>(steps)));
  for (size_t at = 0; at < count; at += hn::Lanes(d)) {
    const auto value =
        simd::HWY_NAMESPACE::LoadFirst(d, values + at, count - at < hn::Lanes(d) ? count - at : hn::Lanes(d));
    const auto t = hn::Max(hn::Min((value - low) * scale, last), zero);
    const auto step = hn::Min(RoundDown(t), last - one);
    const auto next = t - step, here = one - next;
    for (int c = 0; c < 4; ++c) {
      if (!out[c]) continue;
      auto first = hn::Set(d, solid.color[c][0]), second = hn::Set(d, solid.color[c][1]);
      for (uint32_t k = 1; k < steps; ++k) {
        const auto reached = hn::Ge(step, hn::Set(d, static_cast<float>(static_cast<int32_t>(k))));
        first = hn::IfThenElse(reached, hn::Set(d, solid.color[c][k]), first);
        second = hn::IfThenElse(reached, hn::Set(d, solid.color[c][k + 1]), second);
      }
      simd::HWY_NAMESPACE::StoreFirst(d, first * here + second * next, count - at, out[c] + at);
    }
  }
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(FindColors);

void find_colors(const Solid& solid, const core::SimdTarget& simd, const float* values, size_t count,
                 float* const out[4]) {
  SHD_DISPATCH(FindColors, simd)(solid, values, count, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
