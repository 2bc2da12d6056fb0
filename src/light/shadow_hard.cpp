// SPDX-License-Identifier: MIT
#include "light/shadow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/shadow_hard.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/shadow_receiver-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// A point is lit if the plane of its surface, at the centre of the nearest texel, is not behind the depth of the texel
/// (Williams 1978).
void SampleHard(const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  const ShadowMap& map = shadow.map;
  ForEachReceiver<ReceiverTag>(shadow, in, visibility, [&](auto d, const auto& at) {
    using D = decltype(d);
    using V = hn::Vec<D>;
    const V last = hn::Set(d, static_cast<float>(map.size - 1));
    const V column = hn::Min(RoundDown(at.x), last), row = hn::Min(RoundDown(at.y), last);
    const V depth = GatherDepths(d, map, TexelIndex(d, map, at.face, column, row));
    return hn::IfThenElseZero(hn::Le(PlaneDepth(d, at, column, row), depth), hn::Set(d, 1.0f));
  });
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::light {

HWY_EXPORT(SampleHard);

void sample_hard(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  SHD_DISPATCH(SampleHard, simd)(shadow, in, visibility);
}

}  // namespace shd::light
#endif  // HWY_ONCE
