// SPDX-License-Identifier: MIT
// Cells of the integer lattice, their hashes, and weights of their corners.

#if defined(SHD_PROCEDURAL_LATTICE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROCEDURAL_LATTICE_INL_H_
#undef SHD_PROCEDURAL_LATTICE_INL_H_
#else
#define SHD_PROCEDURAL_LATTICE_INL_H_
#endif

#include <hwy/highway.h>

#include <shd/solid.h>

#include "procedural/batch-inl.h"
#include "simd/hash-inl.h"
#include "simd/integer-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// Coordinates are clamped to this distance from the origin, beyond which floats have no fraction.
constexpr float kFarthest = 0x1p23f;

/// Odd factors of the coordinates of lattice points in their hashes, from the square roots of 2, 3 and 5.
constexpr uint32_t kFactor[3] = {0x6a09e667u, 0xbb67ae85u, 0x3c6ef373u};

/// A coordinate as a cell and the place in it, in [0, 1]: a tiny negative coordinate has the fraction 1.
template <class D>
struct Axis {
  hn::Vec<hn::RebindToUnsigned<D>> cell;
  hn::Vec<D> at;
};

template <class D, class V>
HWY_INLINE V ClampCoordinate(D d, V p) {
  return hn::Min(hn::Max(p, hn::Set(d, -kFarthest)), hn::Set(d, kFarthest));
}

template <class D, class V>
HWY_INLINE Axis<D> SplitAxis(D d, V p) {
  const hn::RebindToUnsigned<D> du;
  const V clamped = ClampCoordinate(d, p);
  const V whole = RoundDown(clamped);
  return {hn::BitCast(du, simd::HWY_NAMESPACE::ToInt(whole)), clamped - whole};
}

/// The weight of the farther end of an axis, and its derivative.
template <class V>
struct Fade {
  V weight, slope;
};

template <class D, class V>
HWY_INLINE Fade<V> FadeAt(D d, shd_solid_fade fade, V t) {
  const V one = hn::Set(d, 1.0f);
  if (fade == SHD_SOLID_FADE_LINEAR) return {t, one};
  if (fade == SHD_SOLID_FADE_CUBIC) {
    const V three = hn::Set(d, 3.0f), six = hn::Set(d, 6.0f);
    return {t * t * (three - (t + t)), six * t * (one - t)};
  }
  const V six = hn::Set(d, 6.0f), ten = hn::Set(d, 10.0f), fifteen = hn::Set(d, 15.0f), thirty = hn::Set(d, 30.0f);
  const V square = t * t, rest = one - t;
  return {square * t * (t * (t * six - fifteen) + ten), thirty * square * (rest * rest)};
}

/// Hashes of the two ends of an axis, before they are mixed.
template <class VU>
struct Ends {
  VU of[2];
};

template <class DU, class VU>
HWY_INLINE Ends<VU> HashEnds(DU du, VU cell, int axis, VU start) {
  const VU factor = hn::Set(du, kFactor[axis]);
  const VU low = cell * factor + start;
  return {{low, low + factor}};
}

/// Mixes the sum of the terms of a lattice point: MixBits() without its last step, which changes the low half alone.
/// Only the high 16 bits are good.
template <class DU, class VU>
HWY_INLINE VU MixHigh(DU du, VU x) {
  x = x ^ hn::ShiftRight<16>(x);
  x = x * hn::Set(du, 0x7feb352du);
  x = x ^ hn::ShiftRight<15>(x);
  return x * hn::Set(du, 0x846ca68bu);
}

/// Chooses by the highest bits. The generic targets of Highway compare floats with 0, which fails for NaN and -0.
template <class D, class VU, class V>
HWY_INLINE V ChooseByHighest(D d, VU bits, V yes, V no) {
  const hn::RebindToSigned<D> di;
  return hn::BitCast(d, hn::IfNegativeThenElse(hn::BitCast(di, bits), hn::BitCast(di, yes), hn::BitCast(di, no)));
}

/// Gradient of a lattice point, one of twelve, as two signed components.
///
/// With the highest bits b3 b2 b1 b0 of the hash as a number, the choice is that of Perlin's reference implementation
/// of 2002: u = x if below 8, else y; v = y if below 4, x for 12 and 14, else z; b0 negates u, b1 negates v.
template <class D, class VU, class V>
HWY_INLINE V DotEdge(D d, VU hash, V x, V y, V z) {
  const auto sign = hn::Set(hn::RebindToUnsigned<D>(), 0x80000000u);
  const VU b2 = hn::ShiftLeft<1>(hash), b1 = hn::ShiftLeft<2>(hash), b0 = hn::ShiftLeft<3>(hash);
  const V u = ChooseByHighest(d, hash, y, x);
  const V above = ChooseByHighest(d, hn::AndNot(b0, hash), x, z);
  const V v = ChooseByHighest(d, b2, above, ChooseByHighest(d, hash, z, y));
  return hn::Xor(u, hn::BitCast(d, b0 & sign)) + hn::Xor(v, hn::BitCast(d, b1 & sign));
}

/// The components of the gradient, and its product with (x, y, z).
template <class D, class VU, class V>
HWY_INLINE Sample<V> EdgeSample(D d, VU hash, V x, V y, V z) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  return {DotEdge(d, hash, x, y, z), DotEdge(d, hash, one, zero, zero), DotEdge(d, hash, zero, one, zero),
          DotEdge(d, hash, zero, zero, one)};
}

template <class V>
HWY_INLINE V Lerp(V a, V b, V t) {
  return a + t * (b - a);
}

/// Interpolates linearly between two samples of the derivatives.
template <class V>
HWY_INLINE Sample<V> LerpSlopes(const Sample<V>& a, const Sample<V>& b, V t) {
  return {a.value, Lerp(a.dx, b.dx, t), Lerp(a.dy, b.dy, t), Lerp(a.dz, b.dz, t)};
}

/// Interpolates the eight corners corner(i, j, k) of a cell.
/// @param kSlopes  whether the corners are linear functions with derivatives, and not constants
template <bool kGradient, bool kSlopes, class V, class Corner>
HWY_INLINE Sample<V> Interpolate(const Fade<V>& x, const Fade<V>& y, const Fade<V>& z, const Corner& corner) {
  Sample<V> plane[2];        // at the ends of z; the derivatives are the interpolated ones of the corners
  V along_x[2], along_y[2];  // differences of the planes' values
  for (int k = 0; k < 2; ++k) {
    Sample<V> edge[2];
    V step[2];
    for (int j = 0; j < 2; ++j) {
      const Sample<V> a = corner(0, j, k), b = corner(1, j, k);
      if constexpr (kGradient && kSlopes) edge[j] = LerpSlopes(a, b, x.weight);
      step[j] = b.value - a.value;
      edge[j].value = a.value + x.weight * step[j];
    }
    if constexpr (kGradient && kSlopes) plane[k] = LerpSlopes(edge[0], edge[1], y.weight);
    along_y[k] = edge[1].value - edge[0].value;
    plane[k].value = edge[0].value + y.weight * along_y[k];
    if constexpr (kGradient) along_x[k] = Lerp(step[0], step[1], y.weight);
  }
  const V along_z = plane[1].value - plane[0].value;
  Sample<V> out;
  if constexpr (kGradient) {
    out = {plane[0].value, x.slope * Lerp(along_x[0], along_x[1], z.weight),
           y.slope * Lerp(along_y[0], along_y[1], z.weight), z.slope * along_z};
    if constexpr (kSlopes) {
      const Sample<V> mean = LerpSlopes(plane[0], plane[1], z.weight);
      out = {out.value, out.dx + mean.dx, out.dy + mean.dy, out.dz + mean.dz};
    }
  }
  out.value = plane[0].value + z.weight * along_z;
  return out;
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROCEDURAL_LATTICE_INL_H_
