// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/value.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/lattice-inl.h"
#include "procedural/octaves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One octave of value noise: hashes of the lattice points as multiples of 2^-23 in [-1, 1), interpolated.
struct ValueNoise {
  shd_solid_fade fade;

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, V x, V y, V z, uint32_t seed) const {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const Axis<D> ax = SplitAxis(d, x), ay = SplitAxis(d, y), az = SplitAxis(d, z);
    const auto hx = HashEnds(du, ax.cell, 0, hn::Set(du, seed));
    const auto hy = HashEnds(du, ay.cell, 1, hn::Zero(du));
    const auto hz = HashEnds(du, az.cell, 2, hn::Zero(du));
    const auto corner = [&](int i, int j, int k) {
      const auto hash = simd::HWY_NAMESPACE::MixBits(du, hx.of[i] + (hy.of[j] + hz.of[k]));
      Sample<V> out;
      out.value = hn::ConvertTo(d, hn::ShiftRight<8>(hn::BitCast(di, hash))) * hn::Set(d, 0x1p-23f);
      return out;
    };
    return Interpolate<kGradient, false>(FadeAt(d, fade, ax.at), FadeAt(d, fade, ay.at), FadeAt(d, fade, az.at),
                                         corner);
  }
};

size_t Value(const Solid& solid, const Places& places, const Values& out) {
  return EvaluateSum(solid, ValueNoise{solid.fade}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(Value);

size_t evaluate_value(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  return SHD_DISPATCH(Value, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
