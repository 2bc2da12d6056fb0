// SPDX-License-Identifier: MIT
// The ellipse of a lookup on its level, and the weights inside (Heckbert, "Fundamentals of Texture Mapping and Image
// Warping", 1989, 3.5): found for a block of lookups before any is filtered.

#if defined(SHD_TEXTURE_ELLIPSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_ELLIPSE_INL_H_
#undef SHD_TEXTURE_ELLIPSE_INL_H_
#else
#define SHD_TEXTURE_ELLIPSE_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/footprint-inl.h"
#include "texture/shape_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The ellipse's half axes in those of the footprint, of which a pixel's square spans sqrt(1/3): nearest to the average
/// over pixels on a receding floor, by 0.15 dB before 0.82 and 0.03 dB before 0.85.
constexpr float kPixel = 0.84f;
/// What the average over a texel of the base has of the reconstruction filter: the variance of a square, 1/12, over
/// that of the weights within the unit circle, 0.136.
constexpr float kSquare = 0.6127f;

/// Writes the ellipse of each lookup in texels of its level to four columns, as a stack of rows: with half axes a, b
/// along a unit vector (u, v) and across it, r^2 = y^2 / high + (x - shift y)^2 / wide. This is the form of Cholesky,
/// in which nothing cancels and which no rounding makes indefinite. Then the level plus half the share of bilinear.
struct EllipseOf {
  const Texture& texture;
  const Sampler& sampler;
  LodRange range;
  bool lod_given;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    using V = hn::Vec<D>;
    using simd::HWY_NAMESPACE::Exp2;
    const hn::RebindToSigned<D> di;
    const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
    const Footprint<D> f = lod_given ? RoundFootprint(d, p.lod) : FootprintOf(d, p.derivatives, width, height);
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    const V ratio = hn::Div(one, hn::Max(f.roundness, hn::Set(d, 1.0f / sampler.max_anisotropy)));
    const V longer = hn::Add(f.lambda, hn::Set(d, sampler.lod_bias));
    const V shorter = hn::Sub(f.lambda, simd::HWY_NAMESPACE::Log2(d, ratio));
    const V lod = ClampLod(d, shorter, sampler.lod_bias, range);
    const V level = hn::Floor(lod);
    // In texels of the level: 1 <= b < 2, b <= a <= ratio b.
    const V b = Exp2(d, hn::Sub(lod, level));
    const V free = Exp2(d, hn::Min(hn::Max(hn::Sub(longer, level), zero), hn::Set(d, 8.0f)));
    const V a = hn::Max(hn::Min(free, hn::Mul(ratio, b)), b);

    const V area = hn::Set(d, kPixel * kPixel);
    const auto base_area = PowerOfTwo(d, hn::ConvertTo(di, hn::Mul(level, hn::Set(d, -2.0f))));
    const V texel = hn::Sub(one, hn::Mul(hn::Set(d, kSquare), hn::Sub(one, base_area)));
    const V aa = hn::Add(hn::Mul(area, hn::Mul(a, a)), texel);
    const V bb = hn::Add(hn::Mul(area, hn::Mul(b, b)), texel);
    const V high = hn::Add(hn::Mul(aa, hn::Mul(f.v, f.v)), hn::Mul(bb, hn::Mul(f.u, f.u)));
    hn::StoreU(hn::Div(hn::Mul(hn::Sub(aa, bb), hn::Mul(f.u, f.v)), high), d, out.channel[0] + i);
    hn::StoreU(high, d, out.channel[1] + i);
    hn::StoreU(hn::Div(hn::Mul(aa, bb), high), d, out.channel[2] + i);
    const V length = Exp2(d, hn::Min(hn::Max(hn::Sub(longer, hn::Set(d, range.low)), zero), two));
    const V share = hn::Sub(two, hn::Min(length, two));
    hn::StoreU(hn::Add(level, hn::Mul(share, hn::Set(d, 0.5f))), d, out.channel[3] + i);
  }
};

/// (1 - x) (c0 + c1 x + ... + c6 x^6): exp(-2 x) - exp(-2) within 3e-7 for x in [0, 1], by interpolation at Chebyshev's
/// points.
template <class D, class V>
HWY_INLINE V WeightAt(D d, V x) {
  V q = hn::Set(d, 0.00853181087f);
  q = hn::Add(hn::Mul(q, x), hn::Set(d, -0.0550815788f));
  q = hn::Add(hn::Mul(q, x), hn::Set(d, 0.189496407f));
  q = hn::Add(hn::Mul(q, x), hn::Set(d, -0.465842145f));
  q = hn::Add(hn::Mul(q, x), hn::Set(d, 0.864209385f));
  q = hn::Add(hn::Mul(q, x), hn::Set(d, -1.1353075f));
  q = hn::Add(hn::Mul(q, x), hn::Set(d, 0.864664438f));
  return hn::Mul(hn::Sub(hn::Set(d, 1.0f), x), q);
}

/// The ellipse of each lane, from what EllipseOf wrote: it stands in the columns of derivatives.
template <class D>
struct EllipsePoint {
  using V = hn::Vec<D>;
  V u, v;  // reduced coordinates of the middle
  V shift, high, wide;
  V bilinear;  // its share
  V floor;
  Level<D> level;

  HWY_INLINE EllipsePoint(D d, const Texture& texture, const Sampler& sampler, const Points<D>& p)
      : u(ReduceCoordinate(d, sampler.wrap_u, p.u)),
        v(ReduceCoordinate(d, sampler.wrap_v, p.v)),
        shift(p.derivatives.dudx),
        high(p.derivatives.dvdx),
        wide(p.derivatives.dudy),
        floor(hn::Floor(p.derivatives.dvdy)),
        level(LevelAt(d, texture, p.first_texel, floor)) {
    const V half = hn::Sub(p.derivatives.dvdy, floor);
    bilinear = hn::Add(half, half);
  }
};

/// filter(sampler, block, out) for every block of a batch, whose points make an EllipsePoint.
template <class Filter>
HWY_INLINE size_t ForEachEllipseBlock(const Texture& texture, const Sampler& sampler, const Lookups& in,
                                      const Texels& out, const Filter& filter) {
  const EllipseOf shape_of = {texture, sampler, lod_range(texture, sampler), in.lod != nullptr};
  return ForEachShapeBlock(texture, sampler, shape_of, in, out, filter);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_ELLIPSE_INL_H_
