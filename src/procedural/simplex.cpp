// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/simplex.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/lattice-inl.h"
#include "procedural/octaves-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// One octave of simplex noise, before it is normalised: the space is skewed by (x + y + z) / 3, so that six tetrahedra
/// of equal shape fill a cell. Perlin, "Noise Hardware" (2001).
struct SimplexNoise {
  /// Adds the corner at the place (x, y, z) relative to it.
  template <bool kGradient, class D, class VU, class V>
  static HWY_INLINE void AddCorner(D d, VU hash, V x, V y, V z, Sample<V>* sum) {
    const V t = hn::Max(hn::Set(d, 0.5f) - (x * x + y * y + z * z), hn::Zero(d));
    const V square = t * t;
    const VU mixed = MixHigh(hn::RebindToUnsigned<D>(), hash);
    if constexpr (kGradient) {
      const Sample<V> edge = EdgeSample(d, mixed, x, y, z);
      const V fourth = square * square, pull = hn::Set(d, 8.0f) * (square * t) * edge.value;
      sum->value = sum->value + fourth * edge.value;
      sum->dx = sum->dx + (fourth * edge.dx - pull * x);
      sum->dy = sum->dy + (fourth * edge.dy - pull * y);
      sum->dz = sum->dz + (fourth * edge.dz - pull * z);
    } else {
      sum->value = sum->value + square * square * DotEdge(d, mixed, x, y, z);
    }
  }

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, V x, V y, V z, uint32_t seed) const {
    const hn::RebindToUnsigned<D> du;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), sixth = hn::Set(d, 1.0f / 6.0f);
    const V farthest = hn::Set(d, 0.5f * kFarthest);  // skewed coordinates are up to twice as large
    const auto clamp = [&](V p) { return hn::Max(hn::Min(p, farthest), hn::Neg(farthest)); };
    const V px = clamp(x), py = clamp(y), pz = clamp(z);
    const V skew = (px + py + pz) * hn::Set(d, 1.0f / 3.0f);
    const V i = RoundDown(px + skew), j = RoundDown(py + skew), k = RoundDown(pz + skew);
    const V unskew = (i + j + k) * sixth;
    const V x0 = (px - i) + unskew, y0 = (py - j) + unskew, z0 = (pz - k) + unskew;
    // The steps to the second and the third corner follow the order of the coordinates.
    const auto xy = hn::Ge(x0, y0), yz = hn::Ge(y0, z0), xz = hn::Ge(x0, z0);
    const hn::Mask<D> first[3] = {hn::And(xy, xz), hn::AndNot(xy, yz), hn::Not(hn::Or(xz, yz))};
    const hn::Mask<D> second[3] = {hn::Or(xy, xz), hn::Or(hn::Not(xy), yz), hn::Not(hn::And(xz, yz))};
    const auto cell = [&](V p) { return hn::BitCast(du, simd::HWY_NAMESPACE::ToInt(p)); };
    const auto hx = HashEnds(du, cell(i), 0, hn::Set(du, seed));
    const auto hy = HashEnds(du, cell(j), 1, hn::Zero(du));
    const auto hz = HashEnds(du, cell(k), 2, hn::Zero(du));
    Sample<V> sum = {zero, zero, zero, zero};
    AddCorner<kGradient>(d, hx.of[0] + (hy.of[0] + hz.of[0]), x0, y0, z0, &sum);
    V shift = sixth;
    for (const auto* step : {first, second}) {
      const auto choose = [&](int axis, const auto& ends) {
        return hn::IfThenElse(hn::RebindMask(du, step[axis]), ends.of[1], ends.of[0]);
      };
      const auto move = [&](int axis, V p) { return p - hn::IfThenElseZero(step[axis], one) + shift; };
      AddCorner<kGradient>(d, choose(0, hx) + (choose(1, hy) + choose(2, hz)), move(0, x0), move(1, y0), move(2, z0),
                           &sum);
      shift = shift + sixth;
    }
    const V half = hn::Set(d, 0.5f);
    AddCorner<kGradient>(d, hx.of[1] + (hy.of[1] + hz.of[1]), x0 - half, y0 - half, z0 - half, &sum);
    return sum;
  }
};

size_t Simplex(const Solid& solid, const Places& places, const Values& out) {
  return EvaluateSum(solid, SimplexNoise(), places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(Simplex);

size_t evaluate_simplex(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  return SHD_DISPATCH(Simplex, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
