// SPDX-License-Identifier: MIT
// The ellipse of a lookup on its level (Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989, 3.5).
#include "texture/domain/block.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/domain/ellipses.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/round-inl.h"
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

template <class D>
HWY_INLINE Axes2<D> AxesOnLevel(D d, const Footprint<D>& f, const Sampler& sampler, const LodRange& range) {
  using V = hn::Vec<D>;
  using simd::HWY_NAMESPACE::Exp2;
  const hn::RebindToSigned<D> di;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V ratio = one / hn::Max(f.roundness, hn::Set(d, 1.0f / sampler.max_anisotropy));
  const V longer = f.lambda + hn::Set(d, sampler.lod_bias);
  const V shorter = f.lambda - simd::HWY_NAMESPACE::NormalLog2(d, ratio);
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

size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, EllipseBlock* out) {
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const LodRange range = lod_range(texture, sampler);
  const bool lod_given = in.lod != nullptr;
  return FillBlock(texture, sampler, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
    const auto f = lod_given ? RoundFootprint(d, p.lod) : FootprintOf(d, p.derivatives, width, height);
    const auto axes = AxesOnLevel(d, f, sampler, range);
    const auto height2 = axes.aa * (f.v * f.v) + axes.bb * (f.u * f.u);
    hn::Store((axes.aa - axes.bb) * (f.u * f.v) / height2, d, out->shear + to);
    hn::Store(height2, d, out->height2 + to);
    hn::Store(axes.aa * axes.bb / height2, d, out->width2 + to);
    hn::Store(axes.level, d, out->level + to);
    // Blend to bilinear as the longer half axis shrinks from two texels of the finest level to one.
    const auto two = hn::Set(d, 2.0f), longer = f.lambda + hn::Set(d, sampler.lod_bias);
    const auto length =
        simd::HWY_NAMESPACE::Exp2(d, hn::Min(hn::Max(longer - hn::Set(d, range.low), hn::Zero(d)), two));
    hn::Store(two - hn::Min(length, two), d, out->bilinear + to);
  });
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
