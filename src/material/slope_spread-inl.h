// SPDX-License-Identifier: MIT
// Lobes averaged over the normals of a filtered normal map, whose slopes have a mean and a covariance (Olano and Baker,
// "LEAN Mapping", 2010).

#if defined(SHD_MATERIAL_SLOPE_SPREAD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_SLOPE_SPREAD_INL_H_
#undef SHD_MATERIAL_SLOPE_SPREAD_INL_H_
#else
#define SHD_MATERIAL_SLOPE_SPREAD_INL_H_
#endif

#include "simd/math-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Sum;
using simd::HWY_NAMESPACE::Vec3V;

constexpr float kHalfLog2E = 0.721347520f;  // log2(e) / 2

/// Normals n + p a + q b (normalised) for standard normal deviates p and q. The projections of a and b on the plane of
/// t and s, which are perpendicular to n and to each other, give the covariance S = a a^T + b b^T of slopes around n. A
/// sum of squares keeps det S = |a x b|^2 >= 0 without cancellation.
template <class V>
struct SlopeSpread {
  Vec3V<V> n, t, s;
  Vec3V<V> a, b;
  V ax, ay, bx, by;
  V longest;  // variance of slopes along a
  V trace, determinant;
  V mean_length;  // 1 / sqrt(1 + trace S): mean component along n of the unit normals
};

/// Turns a and b to the principal axes of a a^T + b b^T, the longer one first, by one Jacobi rotation.
template <class D, class V>
HWY_INLINE void TurnToAxes(D d, Vec3V<V>& a, Vec3V<V>& b) {
  using simd::HWY_NAMESPACE::Difference;
  using simd::HWY_NAMESPACE::Scaled;
  using simd::HWY_NAMESPACE::Select;
  const V half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  const V aa = Dot(a, a), bb = Dot(b, b);
  const auto shorter = hn::Lt(aa, bb);
  const Vec3V<V> u = Select(shorter, b, a), v = Select(shorter, a, b);
  const V difference = hn::Abs(aa - bb), product = Dot(u, v) + Dot(u, v);
  const V r = hn::Sqrt(difference * difference + product * product);
  const auto turns = hn::Gt(r, zero);
  const V safe = hn::IfThenElse(turns, r, one);
  const V cosine = hn::IfThenElse(turns, hn::Sqrt(half + half * (difference / safe)), one);
  const V sine = hn::IfThenElseZero(turns, half * (product / safe) / cosine);
  a = Sum(Scaled(u, cosine), Scaled(v, sine));
  b = Difference(Scaled(v, cosine), Scaled(u, sine));
}

/// a, b: world-space vectors, of squares up to 1e12.
template <class D, class V>
HWY_INLINE SlopeSpread<V> MakeSlopeSpread(D d, const Vec3V<V>& n, const Vec3V<V>& a, const Vec3V<V>& b) {
  const V one = hn::Set(d, 1.0f);
  SlopeSpread<V> spread;
  spread.n = n;
  spread.t = simd::HWY_NAMESPACE::AnyTangent(d, n);
  spread.s = simd::HWY_NAMESPACE::Cross(n, spread.t);
  spread.a = a, spread.b = b;
  spread.ax = Dot(spread.a, spread.t), spread.ay = Dot(spread.a, spread.s);
  spread.bx = Dot(spread.b, spread.t), spread.by = Dot(spread.b, spread.s);
  spread.longest = spread.ax * spread.ax + spread.ay * spread.ay;
  spread.trace = spread.longest + (spread.bx * spread.bx + spread.by * spread.by);
  const V area = spread.ax * spread.by - spread.ay * spread.bx;
  spread.determinant = area * area;
  spread.mean_length = one / hn::Sqrt(one + spread.trace);
  return spread;
}

/// The mean of max(0, n.l) over the normals: the mean m P(m / d) + d p(m / d) of a rectified Gaussian with mean m = n.l
/// and variance d^2 = l^T S l, times the mean length of (slope, 1) / |(slope, 1)|. P is the cumulative distribution of
/// the normal distribution, by Abramowitz and Stegun, "Handbook of Mathematical Functions" (1964), 26.2.17, with
/// |error| < 7.5e-8. The result is max(0, n.l) where S = 0.
template <class D, class V>
HWY_INLINE V FilteredCosine(D d, const SlopeSpread<V>& spread, const Vec3V<V>& l, V n_dot_l) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V x = Dot(l, spread.t), y = Dot(l, spread.s);
  const V along_a = x * spread.ax + y * spread.ay, along_b = x * spread.bx + y * spread.by;
  const V deviation = hn::Sqrt(along_a * along_a + along_b * along_b);
  const V z = hn::Abs(n_dot_l) / hn::Max(deviation, hn::Set(d, 1e-18f));
  const V held = hn::Min(z, hn::Set(d, 16.0f));
  const V density = hn::Set(d, 0.398942280f) * simd::HWY_NAMESPACE::Exp2(d, hn::Set(d, -kHalfLog2E) * (held * held));
  const V k = one / (one + hn::Set(d, 0.2316419f) * held);
  V tail = hn::Set(d, 1.330274429f);
  tail = tail * k + hn::Set(d, -1.821255978f);
  tail = tail * k + hn::Set(d, 1.781477937f);
  tail = tail * k + hn::Set(d, -0.356563782f);
  tail = (tail * k + hn::Set(d, 0.319381530f)) * k;
  // Both signs of n.l add the mean of the part beyond 0: d p - |n.l| (1 - P(|n.l| / d)).
  const V beyond = hn::Max(density * (deviation - hn::Abs(n_dot_l) * tail), zero);
  return (hn::Max(n_dot_l, zero) + beyond) * spread.mean_length;
}

/// The slopes A A^T w, A = (a b) and S = A A^T, at which the density of the slopes times a lobe is largest: a Gaussian
/// around h with covariance 1 / k, so that w = (1 / k + S)^-1 h.
template <class V>
struct SlopePeak {
  V along_a, along_b;  // A^T w
  V det;               // det(1 + k S)
};

/// @param sum     wo + l
/// @param length  |wo + l|, not 0
/// @param k       precision of the lobe, 0..2e6: 1 / variance of a slope
template <class D, class V>
HWY_INLINE SlopePeak<V> FindPeak(D d, const SlopeSpread<V>& s, const Vec3V<V>& sum, V length, V k) {
  const V one = hn::Set(d, 1.0f);
  const V inverse_up = one / hn::Max(Dot(sum, s.n), hn::Set(d, 1e-3f) * length);
  const V hx = Dot(sum, s.t) * inverse_up, hy = Dot(sum, s.s) * inverse_up;
  // w = k (h + k adj(S) h) / det(1 + k S), with adj(S) = a' a'^T + b' b'^T for a', b' turned by 90 degrees.
  const V turned_a = s.ax * hy - s.ay * hx, turned_b = s.bx * hy - s.by * hx;
  const V det = one + k * (s.trace + k * s.determinant);
  const V scale = k / det;
  const V wx = scale * (hx - k * (s.ay * turned_a + s.by * turned_b));
  const V wy = scale * (hy + k * (s.ax * turned_a + s.bx * turned_b));
  return {s.ax * wx + s.ay * wy, s.bx * wx + s.by * wy, det};
}

/// The normals near the half vector h, which reflect wo to l: their mean, and their contribution to a lobe.
template <class V>
struct Reflector {
  Vec3V<V> n;
  V gain;  // exp(-w^T S w / 2) / sqrt(det(1 + k S G))
};

/// The integral over normals of a Gaussian of slopes with covariance S, times a lobe around h, which is a Gaussian with
/// covariance 1 / (k G) near the normal u. Laplace's method takes both at the slopes u = S w, w = (1 / k + S)^-1 h,
/// where their product is largest if G = 1. G = ((1 + |u|^2) 1 - u u^T) / (1 + |u|^2)^2 is the metric of angles in
/// slopes (LEAN mapping, section 3, has G = 1 and the lobe at the mean normal; so both agree for gentle slopes).
/// @param sum     wo + l
/// @param length  |wo + l|, not 0
/// @param k       precision of the lobe, 0..2e6: 1 / variance of a slope
template <class D, class V>
HWY_INLINE Reflector<V> FindReflector(D d, const SlopeSpread<V>& s, const Vec3V<V>& sum, V length, V k) {
  const V one = hn::Set(d, 1.0f);
  const SlopePeak<V> peak = FindPeak(d, s, sum, length, k);
  const V along_a = peak.along_a, along_b = peak.along_b;
  const V ux = s.ax * along_a + s.bx * along_b, uy = s.ay * along_a + s.by * along_b;
  const V squared = one + (ux * ux + uy * uy);
  const V inverse = one / squared;
  const V across_a = s.ax * uy - s.ay * ux, across_b = s.bx * uy - s.by * ux;
  const V tilted = (s.trace + (across_a * across_a + across_b * across_b)) * (inverse * inverse);
  const V full = one + k * (tilted + k * s.determinant * (inverse * inverse * inverse));
  const V shorten = hn::Sqrt(inverse);
  using simd::HWY_NAMESPACE::Scaled;
  const Vec3V<V> n = Sum(s.n, Sum(Scaled(s.t, ux), Scaled(s.s, uy)));
  const V distance = along_a * along_a + along_b * along_b;
  return {Scaled(n, shorten), simd::HWY_NAMESPACE::Exp2(d, hn::Set(d, -kHalfLog2E) * distance) / hn::Sqrt(full)};
}

/// Nodes and weights of Gauss-Hermite quadrature with four nodes, +-x, for the mean over a standard normal deviate.
/// kNodeScale is the weight times exp(x^2 / 2).
constexpr int kNodes = 4;
constexpr float kNode[kNodes] = {-2.33441422f, -0.741963784f, 0.741963784f, 2.33441422f};
constexpr float kNodeScale[kNodes] = {0.699722488f, 0.598020921f, 0.598020921f, 0.699722488f};

/// Quadrature, with nodes along a, of the integral over p, q of a standard normal density times a lobe of the normal
/// n + p a + q b (normalised): adaptive Gauss-Hermite quadrature (Naylor and Smith, "Applications of a Method for the
/// Efficient Computation of Posterior Distributions", 1982). The density times a Gaussian lobe is a Gaussian around
/// (p, q).
template <class V>
struct NormalRule {
  V p, q;   // its mean
  V step;   // deviation of p for fixed q
  V scale;  // square root of the determinant of its covariance
};

/// @param sum     wo + l
/// @param length  |wo + l|, not 0
/// @param k       precision of the Gaussian lobe around wo + l, 0..2e6: 1 / variance of a slope; nodes lie further
///                apart where it is lower
template <class D, class V>
HWY_INLINE NormalRule<V> MakeNormalRule(D d, const SlopeSpread<V>& s, const Vec3V<V>& sum, V length, V k) {
  const V one = hn::Set(d, 1.0f);
  const SlopePeak<V> peak = FindPeak(d, s, sum, length, k);
  const V step = one / hn::Sqrt(one + k * s.longest);
  return {peak.along_a, peak.along_b, step, one / hn::Sqrt(peak.det)};
}

/// A normal and its weight in the mean over normals. The weights add up to about 1 where k is 0.
template <class V>
struct NormalNode {
  Vec3V<V> n;
  V weight;
};

/// Node i of the rule: exactly the mean normal where a = b = 0.
template <class D, class V>
HWY_INLINE NormalNode<V> NodeAt(D d, const SlopeSpread<V>& s, const NormalRule<V>& rule, int i) {
  using simd::HWY_NAMESPACE::Scaled;
  const V one = hn::Set(d, 1.0f);
  const V p = rule.p + hn::Set(d, kNode[i]) * rule.step, q = rule.q;
  const Vec3V<V> e = Sum(Scaled(s.a, p), Scaled(s.b, q));
  const V along = Dot(e, s.n);
  const V squared = one + (along + along + Dot(e, e));
  const V shorten = one / hn::Sqrt(hn::Max(squared, hn::Set(d, 1e-12f)));
  const V density = simd::HWY_NAMESPACE::Exp2(d, hn::Set(d, -kHalfLog2E) * (p * p + q * q));
  return {Scaled(Sum(s.n, e), shorten), hn::Set(d, kNodeScale[i]) * density * rule.scale};
}

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_SLOPE_SPREAD_INL_H_
