// SPDX-License-Identifier: MIT
// Cubic kernels of Mitchell and Netravali, "Reconstruction Filters in Computer Graphics" (1988), equation (8), as
// shares of a running average. The average starts with the second tap; then the third, first and fourth taps are
// blended in. The share of a tap is its weight divided by the sum of the weights so far. These sums are positive for
// every kernel here, and a weight of 0 leaves the average unchanged. Only ratios of weights matter, so the kernels are
// scaled to integer coefficients:
//
//   inner taps, at distance x < 1      p3 x^3 + p2 x^2 + p0
//   outer taps, at distance 2 - r      q3 r^3 + q2 r^2

#if defined(SHD_TEXTURE_CUBIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_CUBIC_INL_H_
#undef SHD_TEXTURE_CUBIC_INL_H_
#else
#define SHD_TEXTURE_CUBIC_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/domain/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct CubicKernel {
  float p3, p2, p0, q3, q2;
};
inline CubicKernel cubic_kernel(shd_cubic cubic) {
  switch (cubic) {
    case SHD_CUBIC_B_SPLINE: return {3, -6, 4, 1, 0};
    case SHD_CUBIC_MITCHELL: return {21, -36, 16, 7, -6};
    default: return {9, -15, 6, 3, -3};
  }
}

/// Shares of the third, first and fourth tap, and the derivatives of the shares in the coordinate.
template <class D>
struct CubicSteps {
  hn::Vec<D> step[3], rate[3];
};

/// Returns the shares at the fraction s between the second and the third tap. ds is the derivative of s in the
/// coordinate. Rates take six divisions; they are 0 unless has_rates is set.
template <class D, class V>
SHD_KERNEL_PART CubicSteps<D> StepsOf(D d, shd_cubic cubic, V s, V ds, bool has_rates) {
  const CubicKernel k = cubic_kernel(cubic);
  const auto set = [&](float value) { return hn::Set(d, value); };
  const auto inner = [&](V x) { return (set(k.p3) * x + set(k.p2)) * (x * x) + set(k.p0); };
  const auto outer = [&](V r) { return (set(k.q3) * r + set(k.q2)) * (r * r); };
  const V r = set(1.0f) - s;
  // In the order of the taps: second, third, first, fourth.
  const V weight[4] = {inner(s), inner(r), outer(r), outer(s)};
  CubicSteps<D> steps;
  V sum = weight[0];
  for (int i = 1; i < 4; ++i) {
    sum = sum + weight[i];
    steps.step[i - 1] = weight[i] / sum;
    steps.rate[i - 1] = hn::Zero(d);
  }
  if (!has_rates) return steps;
  const auto inner_slope = [&](V x) { return (set(3 * k.p3) * x + set(2 * k.p2)) * x; };
  const auto outer_slope = [&](V x) { return (set(3 * k.q3) * x + set(2 * k.q2)) * x; };
  const V slope[4] = {inner_slope(s), hn::Neg(inner_slope(r)), hn::Neg(outer_slope(r)), outer_slope(s)};
  V sum_slope = slope[0];
  sum = weight[0];
  for (int i = 1; i < 4; ++i) {
    sum = sum + weight[i];
    sum_slope = sum_slope + slope[i];
    steps.rate[i - 1] = (slope[i] - steps.step[i - 1] * sum_slope) / sum * ds;
  }
  return steps;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_CUBIC_INL_H_
