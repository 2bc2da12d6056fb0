// SPDX-License-Identifier: MIT
// The ellipse of each lane on its level, and the weights of texels inside it (Heckbert, "Fundamentals of Texture
// Mapping and Image Warping", 1989, 3.5).

#if defined(SHD_TEXTURE_ELLIPSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_ELLIPSE_INL_H_
#undef SHD_TEXTURE_ELLIPSE_INL_H_
#else
#define SHD_TEXTURE_ELLIPSE_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/domain/shapes-inl.h"
#include "texture/filter/walk-inl.h"
#include "texture/store/level-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns exp(-2 x) - exp(-2) for x in [0, 1], |error| <= 3e-7. The approximation (1 - x) (c0 + c1 x + ... + c6 x^6)
/// interpolates at Chebyshev points.
template <class D, class V>
HWY_INLINE V WeightAt(D d, V x) {
  V q = hn::Set(d, 0.00853181087f);
  q = q * x + hn::Set(d, -0.0550815788f);
  q = q * x + hn::Set(d, 0.189496407f);
  q = q * x + hn::Set(d, -0.465842145f);
  q = q * x + hn::Set(d, 0.864209385f);
  q = q * x + hn::Set(d, -1.1353075f);
  q = q * x + hn::Set(d, 0.864664438f);
  return (hn::Set(d, 1.0f) - x) * q;
}

/// One vector of an EllipseBlock. Lanes that are bilinear only have a circle of one texel, whose texels must not count.
template <class D>
struct Ellipse {
  using V = hn::Vec<D>;
  Level<D> level;
  V u, v;              // reduced coordinates of the centre
  TexelPoint<D> x, y;  // centre [texels]
  V shear, height2, width2;
  V bilinear;         // share of bilinear, 0..1
  MaskOf<D> is_quad;  // lanes that are bilinear only

  HWY_INLINE Ellipse(D d, const Texture& texture, const Sampler& sampler, const EllipseBlock& block, size_t i)
      : level(LevelAt(d, texture, FirstTexel(d, texture, block, i), hn::Load(d, block.level + i))),
        u(hn::Load(d, block.u + i)),
        v(hn::Load(d, block.v + i)),
        x(PointOf(d, sampler.wrap_u, u, level.across.real)),
        y(PointOf(d, sampler.wrap_v, v, level.down.real)),
        bilinear(hn::Load(d, block.bilinear + i)) {
    const V one = hn::Set(d, 1.0f);
    is_quad = hn::Eq(bilinear, one);
    shear = hn::IfThenZeroElse(is_quad, hn::Load(d, block.shear + i));
    height2 = hn::IfThenElse(is_quad, one, hn::Load(d, block.height2 + i));
    width2 = hn::IfThenElse(is_quad, one, hn::Load(d, block.width2 + i));
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_ELLIPSE_INL_H_
