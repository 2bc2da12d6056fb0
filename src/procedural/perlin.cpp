// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/perlin.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/octaves-inl.h"
#include "procedural/perlin-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

size_t Perlin(const Solid& solid, const Places& places, const Values& out) {
  return EvaluateSum(solid, HashedPerlin{solid.fade}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(Perlin);

size_t evaluate_perlin(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  return SHD_DISPATCH(Perlin, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
