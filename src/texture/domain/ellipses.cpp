// SPDX-License-Identifier: MIT
// The ellipse or ellipsoid of a lookup on its level (Heckbert, "Fundamentals of Texture Mapping and Image Warping",
// 1989, 3.5).
#include "texture/domain/block.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/domain/ellipses.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/domain/places-inl.h"
#include "texture/domain/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// Half axes of the ellipse divided by those of the footprint; a square pixel spans sqrt(1/3) of them. On a receding
/// floor 0.84 is nearest to the average over pixels: 0.15 dB better than 0.82 and 0.03 dB better than 0.85.
constexpr float kPixel = 0.84f;
/// Part of the reconstruction filter that the average over a base texel already contains: the variance of a square,
/// 1/12, divided by the variance of the weights within the unit circle, 0.136.
constexpr float kSquare = 0.6127f;

/// Squared half axes of the ellipse in texels of its level, a^2 >= b^2, and the level.
template <class D>
struct Axes2 {
  hn::Vec<D> aa, bb, level;
};

/// Finds the axes of the footprint whose longer half axis is 2^lambda base texels.
template <class D, class V>
HWY_INLINE Axes2<D> AxesOnLevel(D d, V lambda, V roundness, const Sampler& sampler, const LodRange& range) {
  using simd::HWY_NAMESPACE::Exp2;
  const hn::RebindToSigned<D> di;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V ratio = one / hn::Max(roundness, hn::Set(d, 1.0f / sampler.max_anisotropy));
  const V longer = lambda + hn::Set(d, sampler.lod_bias);
  const V shorter = lambda - simd::HWY_NAMESPACE::NormalLog2(d, ratio);
  const V lod = ClampLod(d, shorter, sampler.lod_bias, range);
  const V level = RoundDown(lod);
  // In texels of the level: 1 <= b < 2, b <= a <= ratio b.
  const V b = Exp2(d, lod - level);
  const V free = Exp2(d, hn::Min(hn::Max(longer - level, zero), hn::Set(d, 8.0f)));
  const V a = hn::Max(hn::Min(free, ratio * b), b);
  const V area = hn::Set(d, kPixel * kPixel);
  const auto base_area = PowerOfTwo(d, hn::ConvertTo(di, level * hn::Set(d, -2.0f)));
  const V texel = one - hn::Set(d, kSquare) * (one - base_area);
  return {area * (a * a) + texel, area * (b * b) + texel, level};
}

/// Returns the share of bilinear: it falls from 1 to 0 as the longer half axis grows from one texel of the finest level
/// to two.
template <class D, class V>
HWY_INLINE V BilinearShare(D d, V lambda, const Sampler& sampler, const LodRange& range) {
  const V two = hn::Set(d, 2.0f), longer = lambda + hn::Set(d, sampler.lod_bias);
  const V length = simd::HWY_NAMESPACE::Exp2(d, hn::Min(hn::Max(longer - hn::Set(d, range.low), hn::Zero(d)), two));
  return two - hn::Min(length, two);
}

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, EllipseBlock* out) {
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const LodRange range = lod_range(texture, sampler);
  const bool lod_given = in.lod != nullptr;
  return FillBlock(texture, sampler, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
    const auto f = lod_given ? RoundFootprint(d, p.lod) : FootprintOf(d, p.derivatives, width, height);
    const auto axes = AxesOnLevel(d, f.lambda, f.roundness, sampler, range);
    const auto height2 = axes.aa * (f.v * f.v) + axes.bb * (f.u * f.u);
    hn::Store((axes.aa - axes.bb) * (f.u * f.v) / height2, d, out->shear + to);
    hn::Store(height2, d, out->height2 + to);
    hn::Store(axes.aa * axes.bb / height2, d, out->width2 + to);
    hn::Store(axes.level, d, out->level + to);
    hn::Store(BilinearShare(d, f.lambda, sampler, range), d, out->bilinear + to);
  });
}

template <class D>
struct Direction {
  hn::Vec<D> u, v, w;
};
template <class D>
HWY_INLINE hn::Vec<D> Dot(const Direction<D>& a, const Direction<D>& b) {
  return (a.u * b.u + a.v * b.v) + a.w * b.w;
}
template <class D>
HWY_INLINE Direction<D> Select(MaskOf<D> lanes, const Direction<D>& yes, const Direction<D>& no) {
  return {hn::IfThenElse(lanes, yes.u, no.u), hn::IfThenElse(lanes, yes.v, no.v), hn::IfThenElse(lanes, yes.w, no.w)};
}
template <class D>
HWY_INLINE Direction<D> Scaled(const Direction<D>& a, hn::Vec<D> by) {
  return {a.u * by, a.v * by, a.w * by};
}

/// Unit vectors along and across the longer axis of a footprint, and normal to its plane. Footprints without a plane or
/// without an axis have any of their perpendicular vectors.
template <class D>
struct Frame {
  Direction<D> along, across, normal;

  HWY_INLINE Frame(D d, const PlaceAxes<D>& f) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const Direction<D> axis = {f.u, f.v, f.w};
    along = Select<D>(hn::Gt(Dot(axis, axis), hn::Set(d, 0.5f)), axis, {one, zero, zero});
    // The product of almost parallel derivatives is rounding errors in any direction.
    const Direction<D> cross = {f.cross_u, f.cross_v, f.cross_w};
    const V part = Dot(cross, along);
    const Direction<D> rest = {cross.u - part * along.u, cross.v - part * along.v, cross.w - part * along.w};
    const Direction<D> beside_u = {zero, along.w, hn::Neg(along.v)}, beside_v = {hn::Neg(along.w), zero, along.u};
    const auto any = Select<D>(hn::Lt(hn::Abs(along.u), hn::Set(d, 0.6f)), beside_u, beside_v);
    const V least = hn::Max(hn::Set(d, 0.25f) * Dot(cross, cross), hn::Set(d, 0x1p-80f));
    const Direction<D> given = Select<D>(hn::Gt(Dot(rest, rest), least), rest, any);
    normal = Scaled(given, one / hn::Sqrt(Dot(given, given)));
    across = {normal.v * along.w - normal.w * along.v, normal.w * along.u - normal.u * along.w,
              normal.u * along.v - normal.v * along.u};
  }
};

/// Returns the square of the half axis normal to the plane of a footprint: 1, the reconstruction filter of the base. An
/// ellipsoid then contains the ball of one texel, and this ball contains at least one texel. Footprints that are more
/// than kFlattest times longer than wide have no clear plane; their half axis grows to the one across.
constexpr float kFlattest = 64.0f;
template <class D, class V>
HWY_INLINE V NormalAxis2(D d, V bb, const PlaceAxes<D>& f) {
  const V one = hn::Set(d, 1.0f), flat = f.roundness * hn::Set(d, kFlattest);
  const V largest = hn::Max(hn::Max(hn::Abs(f.cross_u), hn::Abs(f.cross_v)), hn::Abs(f.cross_w));
  const V share = hn::IfThenElseZero(hn::Gt(largest, hn::Zero(d)), hn::Min(flat * flat, one));
  return one + (one - share) * (bb - one);
}

/// The quadratic form of the ellipsoid is Q = sum of l e e^T over its axes e with squares l of the half axes. Its
/// Cholesky form has the entries of Q and of its cofactors, sums of l1 l2 e3 e3^T, and their ratios.
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, EllipsoidBlock* out) {
  const LodRange range = lod_range(texture, sampler);
  const bool lod_given = in.lod != nullptr;
  return FillPlaces(texture, sampler, in, out, out->w, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
    using V = hn::Vec<decltype(d)>;
    const auto f = lod_given ? RoundPlaceAxes(d, p.lod) : AxesOfPlaces(d, p);
    const V lambda = lod_given ? f.levels : LambdaOfAxes(d, f.square, f.levels);
    const auto axes = AxesOnLevel(d, lambda, f.roundness, sampler, range);
    const V aa = axes.aa, bb = axes.bb, cc = NormalAxis2(d, bb, f);
    const Frame<decltype(d)> e(d, f);
    const auto sum = [&](V a, V x, V b, V y, V c, V z) { return (a * x + b * y) + c * z; };
    const V depth2 = sum(aa, e.along.w * e.along.w, bb, e.across.w * e.across.w, cc, e.normal.w * e.normal.w);
    const V xz = sum(aa, e.along.u * e.along.w, bb, e.across.u * e.across.w, cc, e.normal.u * e.normal.w);
    const V yz = sum(aa, e.along.v * e.along.w, bb, e.across.v * e.across.w, cc, e.normal.v * e.normal.w);
    const V bc = bb * cc, ac = aa * cc, ab = aa * bb;
    const V minor = sum(bc, e.along.u * e.along.u, ac, e.across.u * e.across.u, ab, e.normal.u * e.normal.u);
    const V tilt = sum(bc, e.along.u * e.along.v, ac, e.across.u * e.across.v, ab, e.normal.u * e.normal.v);
    hn::Store(depth2, d, out->depth2 + to);
    hn::Store(xz / depth2, d, out->slide_x + to);
    hn::Store(yz / depth2, d, out->slide_y + to);
    hn::Store(minor / depth2, d, out->height2 + to);
    hn::Store(hn::Neg(tilt / minor), d, out->shear + to);
    hn::Store(ab * cc / minor, d, out->width2 + to);
    hn::Store(axes.level, d, out->level + to);
    hn::Store(BilinearShare(d, lambda, sampler, range), d, out->bilinear + to);
  });
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
