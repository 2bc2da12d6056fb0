// SPDX-License-Identifier: MIT
// Sums of octaves, and their band limit.

#if defined(SHD_PROCEDURAL_OCTAVES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROCEDURAL_OCTAVES_INL_H_
#undef SHD_PROCEDURAL_OCTAVES_INL_H_
#else
#define SHD_PROCEDURAL_OCTAVES_INL_H_
#endif

#include <hwy/highway.h>

#include "procedural/batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The share of a wave that is kept, for `waves` per pixel: 1 up to 1/2, 0 from 1 on.
template <class D, class V>
HWY_INLINE V BandLimit(D d, V waves) {
  const V one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
  return hn::Max(hn::Min(two - (waves + waves), one), hn::Zero(d));
}

/// Limits derivatives to -1e30..1e30, so that their products with other factors are no NaN.
template <class D, class V>
HWY_INLINE Sample<V> LimitSlopes(D d, Sample<V> sample) {
  const V limit = hn::Set(d, 1e30f);
  const auto clamp = [&](V x) { return hn::Max(hn::Min(x, limit), hn::Neg(limit)); };
  return {sample.value, clamp(sample.dx), clamp(sample.dy), clamp(sample.dz)};
}

/// Sum of octaves of a noise at a place in cells: sum of a_i (m + b_i (n_i - m)) with the amplitudes a_i, the mean m
/// and the band limits b_i. noise.At<kGradient>(d, x, y, z, seed) is one octave; `is_turbulence` sums its absolute
/// values. The derivatives are those by the place in cells.
template <bool kGradient, class D, class Noise, class V>
HWY_INLINE Sample<V> SumOctaves(D d, const Noise& noise, const Solid& solid, bool is_turbulence, const Place<V>& p) {
  const V zero = hn::Zero(d), mean = hn::Set(d, solid.mean), normalizer = hn::Set(d, solid.normalizer);
  Sample<V> sum = {zero, zero, zero, zero};
  for (uint32_t i = 0; i < solid.octave_count; ++i) {
    const Octave& octave = solid.octave[i];
    const V frequency = hn::Set(d, octave.frequency), amplitude = hn::Set(d, octave.amplitude);
    const V kept = BandLimit(d, p.width * frequency);
    if (HWY_UNLIKELY(hn::AllTrue(d, hn::Eq(kept, zero)))) {
      sum.value = sum.value + amplitude * mean;
      continue;
    }
    Sample<V> n = noise.template At<kGradient>(d, p.x * frequency, p.y * frequency, p.z * frequency, octave.seed);
    n.value = n.value * normalizer;
    V slope = kept * (amplitude * normalizer) * frequency;
    if (is_turbulence) {
      slope = hn::CopySign(hn::IfThenElseZero(hn::Ne(n.value, zero), slope), n.value);
      n.value = hn::Abs(n.value);
    }
    sum.value = sum.value + amplitude * (mean + kept * (n.value - mean));
    if constexpr (kGradient) {
      sum.dx = sum.dx + slope * n.dx;
      sum.dy = sum.dy + slope * n.dy;
      sum.dz = sum.dz + slope * n.dz;
    }
  }
  return kGradient ? LimitSlopes(d, sum) : sum;
}

/// A place in cells. It may be infinite; lattices clamp coordinates.
template <class D, class V>
HWY_INLINE Place<V> InCells(D d, const Solid& solid, const Place<V>& p) {
  const V inverse = hn::Set(d, solid.inverse_size);
  return {p.x * inverse, p.y * inverse, p.z * inverse, p.width * inverse};
}

/// Changes derivatives by the place in cells to derivatives by the place.
template <bool kGradient, class D, class V>
HWY_INLINE Sample<V> PerUnit(D d, const Solid& solid, const Sample<V>& sample) {
  if constexpr (!kGradient) return sample;
  const V inverse = hn::Set(d, solid.inverse_size);
  return LimitSlopes(d, Sample<V>{sample.value, sample.dx * inverse, sample.dy * inverse, sample.dz * inverse});
}

/// A pattern that is a sum of octaves.
template <class Noise>
struct SumPattern {
  const Solid& solid;
  Noise noise;
  float low;  // the lowest value; the highest is 1

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, const Place<V>& place) const {
    auto sum = SumOctaves<kGradient>(d, noise, solid, solid.is_turbulence, InCells(d, solid, place));
    sum.value = hn::Max(hn::Min(sum.value, hn::Set(d, 1.0f)), hn::Set(d, low));
    return PerUnit<kGradient>(d, solid, sum);
  }
};

template <class Noise>
HWY_INLINE size_t EvaluateSum(const Solid& solid, const Noise& noise, const Places& places, const Values& out) {
  const bool is_positive = solid.is_turbulence || solid.kind == SHD_SOLID_WORLEY;
  return Evaluate(SumPattern<Noise>{solid, noise, is_positive ? 0.0f : -1.0f}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROCEDURAL_OCTAVES_INL_H_
