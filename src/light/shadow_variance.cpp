// SPDX-License-Identifier: MIT
#include "light/shadow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/shadow_variance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/shadow_receiver-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// Four adjacent texels of a map.
template <class V>
struct Corners {
  V value[4];

  template <class D>
  HWY_INLINE V bilinear(D d, V fx, V fy) const {
    const V one = hn::Set(d, 1.0f);
    const auto mix = [&](V a, V b, V f) { return a * (one - f) + b * f; };
    return mix(mix(value[0], value[1], fx), mix(value[2], value[3], fx), fy);
  }
};

/// Chebyshev's bound of the bilinear mixture of the distributions of four texels. Texels store a mean and a variance,
/// not two moments, so that the variance of the mixture, sum w (v + (m - mean)^2), loses no digits to cancellation.
void SampleVariance(const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  const ShadowMap& map = shadow.map;
  const float centre = shadow.options.taps % 2 ? 0.5f : 1.0f;  // centre of a blurred texel
  ForEachReceiver<ReceiverTag>(shadow, in, visibility, [&](auto d, const auto& at) {
    using D = decltype(d);
    using V = hn::Vec<D>;
    const hn::RebindToSigned<D> di;
    const V left = at.x - hn::Set(d, centre), top = at.y - hn::Set(d, centre);
    const V column = RoundDown(left), row = RoundDown(top);
    const V fx = left - column, fy = top - row;
    const auto pitch = hn::Set(di, static_cast<int32_t>(map.pitch));
    const auto start = TexelIndex(d, map, at.face, column, row);
    const auto below = start + pitch, next = hn::Set(di, 1);
    const ShadowInts<D> index[4] = {start, start + next, below, below + next};
    Corners<V> mean, variance;
    for (size_t k = 0; k < 4; ++k) {
      GatherPairs(d, map.moments.data(), hn::ShiftLeft<1>(index[k]), &mean.value[k], &variance.value[k]);
    }
    const V middle = mean.bilinear(d, fx, fy);
    for (size_t k = 0; k < 4; ++k) {
      const V away = mean.value[k] - middle;
      variance.value[k] = variance.value[k] + away * away;
    }
    const V z = hn::Min(at.z, hn::Set(d, map.placement.far));
    return Chebyshev(d, shadow.options, z, middle, variance.bilinear(d, fx, fy));
  });
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::light {

HWY_EXPORT(SampleVariance);

void sample_variance(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  SHD_DISPATCH(SampleVariance, simd)(shadow, in, visibility);
}

}  // namespace shd::light
#endif  // HWY_ONCE
