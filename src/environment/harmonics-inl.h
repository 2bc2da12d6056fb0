// SPDX-License-Identifier: MIT
// Real spherical harmonics of the orders 0 to 2.

#if defined(SHD_ENVIRONMENT_HARMONICS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_ENVIRONMENT_HARMONICS_INL_H_
#undef SHD_ENVIRONMENT_HARMONICS_INL_H_
#else
#define SHD_ENVIRONMENT_HARMONICS_INL_H_
#endif

#include <hwy/highway.h>

#include "environment/environment.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::environment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Vec3V;

/// The harmonics of a unit vector, without their normalisations.
template <class V>
struct HarmonicBasis {
  V value[kHarmonics];

  template <class D>
  HWY_INLINE HarmonicBasis(D d, const Vec3V<V>& n)
      : value{hn::Set(d, 1.0f),
              n.x,
              n.y,
              n.z,
              n.x * n.y,
              n.y * n.z,
              n.x * n.z,
              hn::Set(d, 3.0f) * (n.z * n.z) - hn::Set(d, 1.0f),
              n.x * n.x - n.y * n.y} {}
};

}  // namespace shd::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_ENVIRONMENT_HARMONICS_INL_H_
