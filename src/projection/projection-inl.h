// SPDX-License-Identifier: MIT
// Maps between directions and points of images. D is a tag of floats, or of one double. A map M<D> has
//
//   M(d, n)                             the point of a bounded direction: u, v, and face (0 unless the map is the cube)
//   step(d, dn)                         the change of the point with a change of n: the exact Jacobian times dn
//   even_step(d, dn)                    step() with the length that footprints have: without the stretch of parallels
//   stretch(d)                          the change of u by step(), relative to even_step(): 1 or more
//   direction(d, u, v, face, &density)  the unit direction of a point, and the solid angle per area of (u, v) [sr]
//   kFaces                              the number of images
//   kRepeats                            u has a period of 1
//   kStretches                          stretch() is not always 1
//
// A new projection is a file with a map here, a row in WithMap(), and its fold (texture/domain/fold-inl.h).

#if defined(SHD_PROJECTION_PROJECTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROJECTION_PROJECTION_INL_H_
#undef SHD_PROJECTION_PROJECTION_INL_H_
#else
#define SHD_PROJECTION_PROJECTION_INL_H_
#endif

#include <hwy/highway.h>

#include <shd/projection.h>

#include "core/status.h"
#include "projection/cube-inl.h"
#include "projection/direction-inl.h"
#include "projection/disc-inl.h"
#include "projection/lat_long-inl.h"
#include "projection/octahedral-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::projection::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using MirrorBall = Disc<D, MirrorBallRadius>;
template <class D>
using Angular = Disc<D, AngularRadius>;

template <class M>
struct MapType {
  using Map = M;
};

/// Returns body(MapType) for the map of a projection, which is not NONE.
template <class D, class Body>
auto WithMap(shd_projection projection, const Body& body) {
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return body(MapType<LatLong<D>>());
    case SHD_PROJECTION_MIRROR_BALL: return body(MapType<MirrorBall<D>>());
    case SHD_PROJECTION_ANGULAR: return body(MapType<Angular<D>>());
    case SHD_PROJECTION_CUBE: return body(MapType<Cube<D>>());
    case SHD_PROJECTION_OCTAHEDRAL: return body(MapType<Octahedral<D>>());
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

}  // namespace shd::projection::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROJECTION_PROJECTION_INL_H_
