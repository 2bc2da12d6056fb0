// SPDX-License-Identifier: MIT
// Lambert's cosine law.

#if defined(SHD_MATERIAL_LAMBERT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_LAMBERT_INL_H_
#undef SHD_MATERIAL_LAMBERT_INL_H_
#else
#define SHD_MATERIAL_LAMBERT_INL_H_
#endif

#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// max(0, n.l) for unit vectors.
template <class D, class V>
HWY_INLINE V Lambert(D d, V n_dot_l) {
  return hn::Max(n_dot_l, hn::Zero(d));
}

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_LAMBERT_INL_H_
