// SPDX-License-Identifier: MIT
// The footprint: the ellipse that a unit circle of pixels covers in base texels. Its axes are the singular values of
// the derivatives (Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989, 3.5.9; Golub and Van Loan,
// "Matrix Computations", 1996, 8.6). Derivatives are scaled by a power of two, so that no square leaves the range of
// floats.

#if defined(SHD_TEXTURE_FOOTPRINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FOOTPRINT_INL_H_
#undef SHD_TEXTURE_FOOTPRINT_INL_H_
#else
#define SHD_TEXTURE_FOOTPRINT_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/kernel_part.h"
#include "simd/math-inl.h"
#include "texture/domain/lod-inl.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns 2^exponent, for exponents in -126..127.
template <class D>
HWY_INLINE hn::Vec<D> PowerOfTwo(D d, hn::Vec<hn::RebindToSigned<D>> exponent) {
  const hn::RebindToSigned<D> di;
  return hn::BitCast(d, hn::ShiftLeft<23>(exponent + hn::Set(di, 127)));
}

/// Returns floor(log2 |x|) clamped to -126..126, for x that is not NaN.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> ExponentOf(D, hn::Vec<D> x) {
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, hn::Abs(x));
  const auto exponent = hn::ShiftRight<23>(bits) - hn::Set(di, 127);
  return hn::Min(hn::Max(exponent, hn::Set(di, -126)), hn::Set(di, 126));
}

/// Returns the largest magnitude of four vectors without NaN.
template <class V>
HWY_INLINE V LargestMagnitude(V a, V b, V c, V e) {
  return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Max(hn::Abs(c), hn::Abs(e)));
}

/// Returns whether width or blur of the sampler change the derivatives.
inline bool widens(const Sampler& s) {
  return s.width_x != 1.0f || s.width_y != 1.0f || s.blur_u != 0.0f || s.blur_v != 0.0f;
}

/// Applies width and blur to derivatives J: J' J'^T = J diag(width^2) J^T + diag(blur^2), the covariance of the sum of
/// Gaussians. With blur, J' is lower triangular: the rows of [J diag(width) | diag(blur)] are orthogonalised (Gram and
/// Schmidt). A width of 0 removes an infinite derivative; other infinities stay.
template <class D>
HWY_NOINLINE void Widen(D d, const Sampler& sampler, Derivatives<D>* j) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d), wx = hn::Set(d, sampler.width_x), wy = hn::Set(d, sampler.width_y);
  const auto widened = [&](V value, V width) {
    const V product = value * width;
    return hn::IfThenElseZero(hn::Eq(product, product), product);
  };
  j->dudx = widened(j->dudx, wx);
  j->dvdx = widened(j->dvdx, wx);
  j->dudy = widened(j->dudy, wy);
  j->dvdy = widened(j->dvdy, wy);
  if (sampler.blur_u == 0.0f && sampler.blur_v == 0.0f) return;

  const V blur_u = hn::Set(d, sampler.blur_u), blur_v = hn::Set(d, sampler.blur_v);
  const V largest = hn::Max(LargestMagnitude(j->dudx, j->dvdx, j->dudy, j->dvdy), hn::Max(blur_u, blur_v));
  const auto finite = hn::Lt(largest, hn::Inf(d));
  const auto exponent = ExponentOf(d, largest);
  const V down = PowerOfTwo(d, hn::Neg(exponent)), up = PowerOfTwo(d, exponent);
  const V ux = j->dudx * down, uy = j->dudy * down, ub = blur_u * down;
  const V vx = j->dvdx * down, vy = j->dvdy * down, vb = blur_v * down;
  const V uu = ux * ux + uy * uy + ub * ub;
  const V length = hn::Sqrt(uu);
  const V scale = hn::IfThenElseZero(hn::Gt(uu, zero), (ux * vx + uy * vy) / uu);
  const V rx = vx - scale * ux, ry = vy - scale * uy, rb = scale * ub;
  const V rest = rx * rx + ry * ry + (rb * rb + vb * vb);
  j->dudx = hn::IfThenElse(finite, length * up, j->dudx);
  j->dudy = hn::IfThenElse(finite, zero, j->dudy);
  j->dvdx = hn::IfThenElse(finite, scale * length * up, j->dvdx);
  j->dvdy = hn::IfThenElse(finite, hn::Sqrt(rest) * up, j->dvdy);
}

/// Footprints of one vector of lookups; every field is finite.
template <class D>
struct Footprint {
  hn::Vec<D> lambda;     // log2 of the longer half axis in base texels, -32..126; in -15..31 HalfLog2() of SquareOf()
  hn::Vec<D> length;     // longer half axis [base texels], at most 2^100
  hn::Vec<D> roundness;  // shorter axis divided by longer axis, [0, 1]; 1 if both are 0 or infinite
  hn::Vec<D> u, v;       // unit vector of the longer axis, in base texels
};

/// The axes of a footprint. Its lambda, LambdaOfAxes(), takes a chain of operations as long as those of the axes.
template <class D>
struct FootprintAxes {
  hn::Vec<D> square, levels;           // lambda is half the logarithm of `square`, 2^-64..2^64, plus `levels`
  hn::Vec<D> length, roundness, u, v;  // as in Footprint
};

/// Finds the axes of the footprint of derivatives. |error| <= 1e-6 of the longer axis.
template <class D>
SHD_KERNEL_PART FootprintAxes<D> AxesOf(D d, const Derivatives<D>& j, float width, float height) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const V w = hn::Set(d, width), h = hn::Set(d, height), half = hn::Set(d, 0.5f), zero = hn::Zero(d);
  V ux = j.dudx * w, vx = j.dvdx * h, uy = j.dudy * w, vy = j.dvdy * h;
  const V largest = LargestMagnitude(ux, vx, uy, vy);
  const auto infinite = hn::Eq(largest, hn::Inf(d));
  const auto exponent = ExponentOf(d, largest);
  const V down = hn::IfThenZeroElse(infinite, PowerOfTwo(d, hn::Neg(exponent)));
  const auto scaled = [&](V x) { return hn::IfThenZeroElse(infinite, x * down); };
  ux = scaled(ux);
  vx = scaled(vx);
  uy = scaled(uy);
  vy = scaled(vy);
  const V x = ux * ux + vx * vx;
  const V y = uy * uy + vy * vy;
  const V xy = ux * uy + vx * vy;
  const V mean = half * (x + y), skew = half * (x - y);
  const V square = mean + hn::Sqrt(skew * skew + xy * xy);
  const V one = hn::Set(d, 1.0f);
  const auto round = hn::Lt(square, hn::Set(d, 0x1p-20f));  // derivatives 0 or infinite, or far below every level

  FootprintAxes<D> f;
  // The exponent is applied to the square of the axis within the range of floats; the rest adds whole levels.
  const auto near = hn::Min(hn::Max(exponent, hn::Set(di, -31)), hn::Set(di, 31));
  const V unscaled = square * PowerOfTwo(d, near + near);
  const V bounded = hn::Max(unscaled, hn::Set(d, 0x1p-64f));
  f.square = hn::IfThenElse(infinite, one, bounded);
  f.levels = hn::IfThenElse(infinite, hn::Set(d, 126.0f), hn::ConvertTo(d, exponent - near));
  const auto length_exponent = hn::Min(exponent, hn::Set(di, 98));
  f.length = hn::Sqrt(square) * PowerOfTwo(d, length_exponent);
  f.length = hn::IfThenElse(infinite, hn::Set(d, 0x1p100f), f.length);
  const V determinant = hn::Abs(ux * vy - uy * vx);
  f.roundness = hn::IfThenElse(round, one, hn::Min(determinant / square, one));

  // Eigenvector of J J^T for the larger eigenvalue, computed from the row without cancellation.
  const V p = half * (ux * ux + uy * uy - (vx * vx + vy * vy));
  const V q = ux * vx + uy * vy;
  const V a = hn::Sqrt(p * p + q * q) + hn::Abs(p);
  const V norm = hn::Sqrt(a * a + q * q);
  const auto any = hn::Lt(norm, hn::Set(d, 0x1p-40f));
  const V long_part = hn::IfThenElse(any, one, a / norm);
  const V short_part = hn::IfThenElse(any, zero, q / norm);
  const auto along_u = hn::Ge(p, zero);
  f.u = hn::IfThenElse(along_u, long_part, short_part);
  f.v = hn::IfThenElse(along_u, short_part, long_part);
  return f;
}

template <class D, class V>
HWY_INLINE V LambdaOfAxes(D d, V square, V levels) {
  const V lambda = hn::Set(d, 0.5f) * simd::HWY_NAMESPACE::NormalLog2(d, square) + levels;
  return hn::Max(lambda, hn::Set(d, -32.0f));
}

/// Finds the footprint of derivatives.
template <class D>
SHD_KERNEL_PART Footprint<D> FootprintOf(D d, const Derivatives<D>& j, float width, float height) {
  const FootprintAxes<D> f = AxesOf(d, j, width, height);
  return {LambdaOfAxes(d, f.square, f.levels), f.length, f.roundness, f.u, f.v};
}

/// Returns the circle of a given level of detail. Its lambda is `levels`.
template <class D>
HWY_INLINE FootprintAxes<D> RoundAxes(D d, hn::Vec<D> lod) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f);
  const V lambda = hn::Min(hn::Max(lod, hn::Set(d, -32.0f)), hn::Set(d, 126.0f));
  return {one, lambda, simd::HWY_NAMESPACE::Exp2(d, hn::Min(lambda, hn::Set(d, 100.0f))), one, one, hn::Zero(d)};
}
template <class D>
HWY_INLINE Footprint<D> RoundFootprint(D d, hn::Vec<D> lod) {
  const FootprintAxes<D> f = RoundAxes(d, lod);
  return {f.levels, f.length, f.roundness, f.u, f.v};
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FOOTPRINT_INL_H_
