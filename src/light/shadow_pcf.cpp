// SPDX-License-Identifier: MIT
#include "light/shadow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/shadow_pcf.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/shadow_receiver-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// The mean of n x n bilinear comparisons one texel apart (Reeves, Salesin and Cook, "Rendering Antialiased Shadows
/// with Depth Maps", 1987). Each of (n + 1) x (n + 1) texels is compared with the plane of the surface at its centre.
/// Texels of the outermost rows and columns are weighted by their overlap with a square of n x n texels around the
/// point.
void SamplePcf(const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  const ShadowMap& map = shadow.map;
  const uint32_t taps = shadow.options.taps;
  ForEachReceiver<ReceiverTag>(shadow, in, visibility, [&](auto d, const auto& at) {
    using D = decltype(d);
    using V = hn::Vec<D>;
    const hn::RebindToSigned<D> di;
    const V one = hn::Set(d, 1.0f), radius = hn::Set(d, 0.5f * static_cast<float>(taps));
    const V left = at.x - radius, top = at.y - radius;
    const V column = RoundDown(left), row = RoundDown(top);
    const V last_x = left - column, last_y = top - row;
    const V first_x = one - last_x, first_y = one - last_y;
    const auto pitch = hn::Set(di, static_cast<int32_t>(map.pitch));
    auto start = TexelIndex(d, map, at.face, column, row);
    V start_z = PlaneDepth(d, at, column, row);
    V lit = hn::Zero(d), all = hn::Zero(d), all_row = hn::Zero(d);
    for (uint32_t j = 0; j <= taps; ++j) all_row = all_row + (j == 0 ? first_x : j == taps ? last_x : one);
    for (uint32_t i = 0; i <= taps; ++i) {
      V lit_row = hn::Zero(d), z = start_z;
      auto index = start;
      const auto compare = [&](V found, V weight) {
        lit_row = lit_row + hn::IfThenElseZero(hn::Le(z, found), weight);
        z = z + at.dx;
      };
      for (uint32_t j = 0; j < taps; j += 2) {
        V depth, next_depth;
        GatherPairs(d, map.depth.data(), index, &depth, &next_depth);
        compare(depth, j == 0 ? first_x : one);
        compare(next_depth, j + 1 == taps ? last_x : one);
        index = index + hn::Set(di, 2);
      }
      if (taps % 2 == 0) compare(GatherDepths(d, map, index), last_x);
      const V weight = i == 0 ? first_y : i == taps ? last_y : one;
      lit = lit + weight * lit_row;
      all = all + weight * all_row;  // rounds as `lit` does if all texels are lit
      start = start + pitch;
      start_z = start_z + at.dy;
    }
    return lit / all;
  });
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::light {

HWY_EXPORT(SamplePcf);

void sample_pcf(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  SHD_DISPATCH(SamplePcf, simd)(shadow, in, visibility);
}

}  // namespace shd::light
#endif  // HWY_ONCE
