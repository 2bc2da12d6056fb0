// SPDX-License-Identifier: MIT
// Texels beside the edges of an image of directions: where the directions continue. folds/ has one class for each
// projection. A fold F has the static members
//
//   texel(d, level, x, y, face)      the texel that continues the image at (x, y), -1..size
//   far_texel(d, level, x, y, face)  the texel that continues the grid of the image at (x, y), -2..size + 1
//   point(d, u, v, face)             the point inside the image that has the direction of a point outside
//   rates(d, u, v, face)             the derivatives of point()
//   kIsDisc                          the directions fill a disc, and texels inside the image may be folded, too
//   kRepeatsAcross                   u has a period of 1
//   kTurnsAtPoles                    beyond the first and the last row lies this row at u + 1/2: texel() gives the row,
//                                    and the caller turns it
//   kLacksCorners                    the texels beyond some corners do not exist
//   lacks_corner(d, face, left, top) whether the texel beyond this corner of a face does not exist
//   kIsPeriodic                      far_texel() has a period of two images, across and down
//   kHasPlanes                       points outside lie on the plane of a face of the cube
//
// Numbers of texels are whole numbers as floats. A new projection is a file in folds/ and a row in WithFold().

#if defined(SHD_TEXTURE_FOLD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FOLD_INL_H_
#undef SHD_TEXTURE_FOLD_INL_H_
#else
#define SHD_TEXTURE_FOLD_INL_H_
#endif

#include <hwy/highway.h>

#include "core/status.h"
#include "simd/kernel_part.h"
#include "texture/domain/folds/cube-inl.h"
#include "texture/domain/folds/disc-inl.h"
#include "texture/domain/folds/folded-inl.h"
#include "texture/domain/folds/lat_long-inl.h"
#include "texture/domain/folds/octahedral-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns body(fold) for the fold of a projection, which is not NONE.
template <class Body>
HWY_INLINE auto WithFold(shd_projection projection, const Body& body) {
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return body(LatLongFold());
    case SHD_PROJECTION_CUBE: return body(CubeFold());
    case SHD_PROJECTION_OCTAHEDRAL: return body(OctahedralFold());
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR: return body(DiscFold());
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

/// The texel that continues the grid of the image at (x, y), at most two texels beyond an edge.
template <class D>
HWY_INLINE FoldedTexel<D> FoldFar(D d, shd_projection projection, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y,
                                  Ints<D> face) {
  return WithFold(projection,
                  [&](auto fold) SHD_INLINE_LAMBDA { return decltype(fold)::far_texel(d, level, x, y, face); });
}

/// The point inside the image that has the direction of a point outside: probes of a footprint leave the image.
/// Distances of more than one image are cut.
template <class D>
HWY_INLINE FoldedPoint<D> FoldPoint(D d, shd_projection projection, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
  return WithFold(projection, [&](auto fold) SHD_INLINE_LAMBDA { return decltype(fold)::point(d, u, v, face); });
}

/// Derivatives of FoldPoint() at a point outside the image.
template <class D>
HWY_INLINE PointRates<D> FoldRates(D d, shd_projection projection, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
  return WithFold(projection, [&](auto fold) SHD_INLINE_LAMBDA { return decltype(fold)::rates(d, u, v, face); });
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FOLD_INL_H_
