// SPDX-License-Identifier: MIT
// Perlin noise with hashed gradients.

#if defined(SHD_PROCEDURAL_PERLIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROCEDURAL_PERLIN_INL_H_
#undef SHD_PROCEDURAL_PERLIN_INL_H_
#else
#define SHD_PROCEDURAL_PERLIN_INL_H_
#endif

#include <hwy/highway.h>

#include "procedural/lattice-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One octave, before it is normalised. Perlin, "Improving Noise" (2002), with a hash in place of the permutation.
struct HashedPerlin {
  shd_solid_fade fade;

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, V x, V y, V z, uint32_t seed) const {
    const hn::RebindToUnsigned<D> du;
    const Axis<D> ax = SplitAxis(d, x), ay = SplitAxis(d, y), az = SplitAxis(d, z);
    const auto hx = HashEnds(du, ax.cell, 0, hn::Set(du, seed));
    const auto hy = HashEnds(du, ay.cell, 1, hn::Zero(du));
    const auto hz = HashEnds(du, az.cell, 2, hn::Zero(du));
    const V one = hn::Set(d, 1.0f);
    const V px[2] = {ax.at, ax.at - one}, py[2] = {ay.at, ay.at - one}, pz[2] = {az.at, az.at - one};
    const auto corner = [&](int i, int j, int k) {
      const auto hash = MixHigh(du, hx.of[i] + (hy.of[j] + hz.of[k]));
      if constexpr (kGradient) return EdgeSample(d, hash, px[i], py[j], pz[k]);
      Sample<V> out;
      out.value = DotEdge(d, hash, px[i], py[j], pz[k]);
      return out;
    };
    return Interpolate<kGradient, true>(FadeAt(d, fade, ax.at), FadeAt(d, fade, ay.at), FadeAt(d, fade, az.at), corner);
  }
};

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROCEDURAL_PERLIN_INL_H_
