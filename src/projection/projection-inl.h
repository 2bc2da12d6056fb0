// SPDX-License-Identifier: MIT
// Maps between directions and points of images. D is a tag of floats, or of one double. A map M<D> has
//
//   M(d, n)                             the point of a bounded direction: u, v, and face (0 unless the map is the cube)
//   step(d, dn)                         the change of the point with a change of n: the exact Jacobian times dn
//   direction(d, u, v, face, &density)  the unit direction of a point, and the solid angle per area of (u, v) [sr]

#if defined(SHD_PROJECTION_PROJECTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROJECTION_PROJECTION_INL_H_
#undef SHD_PROJECTION_PROJECTION_INL_H_
#else
#define SHD_PROJECTION_PROJECTION_INL_H_
#endif

#include <hwy/highway.h>

#include <shd/projection.h>

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

}  // namespace shd::projection::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROJECTION_PROJECTION_INL_H_
