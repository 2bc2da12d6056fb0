// SPDX-License-Identifier: MIT
// The ellipsoid of each lane on its level, as slices whose cross-sections are ellipses (ellipse-inl.h).

#if defined(SHD_TEXTURE_ELLIPSOID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_ELLIPSOID_INL_H_
#undef SHD_TEXTURE_ELLIPSOID_INL_H_
#else
#define SHD_TEXTURE_ELLIPSOID_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/ellipse-inl.h"
#include "texture/filter/slices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The third axis of one vector of an EllipsoidBlock.
template <class D>
struct EllipsoidDepth {
  using V = hn::Vec<D>;
  TexelPoint<D> z;  // centre [texels]
  V x, y;           // the other coordinates of the centre
  V slide_x, slide_y, per_depth2;
  V first, last;  // slices first..first + last; last = -1 in lanes that are linear only

  HWY_INLINE EllipsoidDepth(D d, const Sampler& sampler, const Slices<D>& slices, const Ellipse<D>& e,
                            const EllipsoidBlock& block, size_t i)
      : z(PointOf(d, sampler.wrap_w, hn::Load(d, block.w + i), slices.deep.real)),
        x(e.x.x),
        y(e.y.x),
        slide_x(hn::IfThenZeroElse(e.is_quad, hn::Load(d, block.slide_x + i))),
        slide_y(hn::IfThenZeroElse(e.is_quad, hn::Load(d, block.slide_y + i))) {
    const V one = hn::Set(d, 1.0f), depth2 = hn::IfThenElse(e.is_quad, one, hn::Load(d, block.depth2 + i));
    const V half_depth = hn::Sqrt(depth2);
    per_depth2 = one / depth2;
    first = RoundUp(z.x - half_depth);
    last = hn::IfThenElse(e.is_quad, hn::Neg(one), RoundDown(z.x + half_depth) - first);
  }

  /// Returns the largest number of a slice of any lane.
  HWY_INLINE float max_slice(D d) const { return hn::GetLane(hn::MaxOfLanes(d, last)); }
};

/// Slice k of an ellipsoid.
template <class D>
struct EllipsoidSection {
  using V = hn::Vec<D>;
  V dz, height;  // distance from the centre, and the part of r^2 that comes from it
  V x, y;        // centre of the ellipse [texels]
  MaskOf<D> empty;

  HWY_INLINE EllipsoidSection(D, const EllipsoidDepth<D>& depth, V k)
      : dz(depth.first + k - depth.z.x),
        height(dz * dz * depth.per_depth2),
        x(depth.x + depth.slide_x * dz),
        y(depth.y + depth.slide_y * dz),
        empty(hn::Lt(depth.last, k)) {}
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_ELLIPSOID_INL_H_
