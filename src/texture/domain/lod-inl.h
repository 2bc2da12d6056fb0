// SPDX-License-Identifier: MIT
// Levels of detail from the axes of the ellipse of Heckbert, "Fundamentals of Texture Mapping and Image Warping"
// (1989): the singular values of the derivatives in base texels.

#if defined(SHD_TEXTURE_LOD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_LOD_INL_H_
#undef SHD_TEXTURE_LOD_INL_H_
#else
#define SHD_TEXTURE_LOD_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/kernel_part.h"
#include "simd/math-inl.h"
#include "texture/domain/lod.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Derivatives of one vector of lookups, without NaN.
template <class D>
struct Derivatives {
  hn::Vec<D> dudx, dvdx, dudy, dvdy;
};

/// Returns half the base-2 logarithm of a squared length, clamped to 2^-64..2^62: for values beyond, the level is
/// outside the texture for any bias, so underflow and overflow do no harm. |error| <= 2e-6 for results in 0..16
/// (measured 5.8e-7).
template <class D, class V>
HWY_INLINE V HalfLog2(D d, V square) {
  const V huge = hn::Set(d, 0x1p62f);
  // This comparison also catches sums that overflowed to infinity or NaN.
  const V bounded = hn::IfThenElse(hn::Lt(square, huge), hn::Max(square, hn::Set(d, 0x1p-64f)), huge);
  return hn::Set(d, 0.5f) * simd::HWY_NAMESPACE::NormalLog2(d, bounded);
}

/// Returns the square of the longer half axis: the larger eigenvalue of J^T J.
template <class D, class V = hn::Vec<D>>
SHD_KERNEL_PART V SquareOf(D d, const Derivatives<D>& j, float width, float height) {
  const V w = hn::Set(d, width), h = hn::Set(d, height), half = hn::Set(d, 0.5f);
  const V ux = j.dudx * w, vx = j.dvdx * h, uy = j.dudy * w, vy = j.dvdy * h;
  const V x = ux * ux + vx * vx;
  const V y = uy * uy + vy * vy;
  const V xy = ux * uy + vx * vy;
  const V mean = half * (x + y), skew = half * (x - y);
  return mean + hn::Sqrt(skew * skew + xy * xy);
}

/// Returns the mean square of both half axes. The sum of their squares is the sum of the squares of J.
template <class D, class V = hn::Vec<D>>
SHD_KERNEL_PART V MeanSquareOf(D d, const Derivatives<D>& j, float width, float height) {
  const V w = hn::Set(d, width), h = hn::Set(d, height);
  const V ux = j.dudx * w, vx = j.dvdx * h, uy = j.dudy * w, vy = j.dvdy * h;
  return hn::Set(d, 0.5f) * ((ux * ux + vx * vx) + (uy * uy + vy * vy));
}

/// Returns lambda + shift clamped to the range. lambda may be infinite but not NaN.
template <class D, class V>
HWY_INLINE V ClampLod(D d, V lambda, float shift, const LodRange& range) {
  const V biased = lambda + hn::Set(d, shift);
  return hn::Min(hn::Max(biased, hn::Set(d, range.low)), hn::Set(d, range.high));
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_LOD_INL_H_
