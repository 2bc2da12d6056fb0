// SPDX-License-Identifier: MIT
// Results of folds, and the base class of folds.

#if defined(SHD_TEXTURE_FOLDS_FOLDED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FOLDS_FOLDED_INL_H_
#undef SHD_TEXTURE_FOLDS_FOLDED_INL_H_
#else
#define SHD_TEXTURE_FOLDS_FOLDED_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/store/level-inl.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A texel of an image, and the face of the image.
template <class D>
struct FoldedTexel {
  hn::Vec<D> x, y;
  Ints<D> face;
};

/// A point of an image, and the face of the image.
template <class D>
struct FoldedPoint {
  hn::Vec<D> u, v;
  Ints<D> face;
};

/// Derivatives of a pair of coordinates in u and v.
template <class D>
struct PointRates {
  hn::Vec<D> u_u, u_v, v_u, v_v;
};

/// Base of the folds: members that a fold does not replace. `F` is the class of the fold.
template <class F>
struct FoldBase {
  static constexpr bool kIsDisc = false;
  static constexpr bool kRepeatsAcross = false;
  static constexpr bool kTurnsAtPoles = false;
  static constexpr bool kLacksCorners = false;
  static constexpr bool kIsPeriodic = false;
  static constexpr bool kHasPlanes = false;

  template <class D>
  static HWY_INLINE FoldedTexel<D> far_texel(D d, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y, Ints<D> face) {
    return F::texel(d, level, x, y, face);
  }

  template <class D>
  static HWY_INLINE MaskOf<D> lacks_corner(D d, Ints<D>, MaskOf<D>, MaskOf<D>) {
    return hn::Eq(hn::Zero(d), hn::Set(d, F::kLacksCorners ? 0.0f : 1.0f));
  }
};

/// Cuts coordinates at a distance of one image.
template <class D, class V>
HWY_INLINE V WithinOneImage(D d, V u) {
  return hn::Min(hn::Max(u, hn::Set(d, -1.0f)), hn::Set(d, 2.0f));
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FOLDS_FOLDED_INL_H_
