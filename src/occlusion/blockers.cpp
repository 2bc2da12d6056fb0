// SPDX-License-Identifier: MIT
#include "occlusion/blockers.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "occlusion/blockers.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/shadow_receiver-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::occlusion::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
namespace receiver = light::HWY_NAMESPACE;

void FindOpen(const light::Shadow& shadow, float reach, const light::ShadowLookups& in, float* open) {
  const light::ShadowMap& map = shadow.map;
  receiver::ForEachReceiver<receiver::ReceiverTag>(shadow, in, open, [&](auto d, const auto& at) {
    const auto last = hn::Set(d, static_cast<float>(map.size - 1));
    const auto column = hn::Min(RoundDown(at.x), last), row = hn::Min(RoundDown(at.y), last);
    const auto depth = receiver::GatherDepths(d, map, receiver::TexelIndex(d, map, at.face, column, row));
    const auto plane = receiver::PlaneDepth(d, at, column, row);
    const auto is_open = hn::Or(hn::Le(plane, depth), hn::Gt(at.bias + plane - depth, hn::Set(d, reach)));
    return hn::IfThenElseZero(is_open, hn::Set(d, 1.0f));
  });
}

}  // namespace shd::occlusion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::occlusion {

HWY_EXPORT(FindOpen);

void find_open(const core::SimdTarget& simd, const light::Shadow& shadow, float reach, const light::ShadowLookups& in,
               float* open) {
  SHD_DISPATCH(FindOpen, simd)(shadow, reach, in, open);
}

}  // namespace shd::occlusion
#endif  // HWY_ONCE
