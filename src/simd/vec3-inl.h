// SPDX-License-Identifier: MIT
// Vectors of three components, one per lane.

#if defined(SHD_SIMD_VEC3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_VEC3_INL_H_
#undef SHD_SIMD_VEC3_INL_H_
#else
#define SHD_SIMD_VEC3_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One 3-vector per lane.
template <class V>
struct Vec3V {
  V x, y, z;
};

/// Loads the vectors of row i and the following rows from one aligned column per component.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vec3V<V> Load3(D d, const float* x, const float* y, const float* z, size_t i) {
  return {hn::Load(d, x + i), hn::Load(d, y + i), hn::Load(d, z + i)};
}

template <class D, class V>
HWY_INLINE void Store3(D d, const Vec3V<V>& v, float* x, float* y, float* z, size_t i) {
  hn::StoreU(v.x, d, x + i);
  hn::StoreU(v.y, d, y + i);
  hn::StoreU(v.z, d, z + i);
}

/// Returns a vector that is the same in every lane.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vec3V<V> Set3(D d, const float* v) {
  return {hn::Set(d, v[0]), hn::Set(d, v[1]), hn::Set(d, v[2])};
}

template <class V>
HWY_INLINE V Dot(const Vec3V<V>& a, const Vec3V<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class V>
HWY_INLINE Vec3V<V> Sum(const Vec3V<V>& a, const Vec3V<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class V>
HWY_INLINE Vec3V<V> Difference(const Vec3V<V>& a, const Vec3V<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class V>
HWY_INLINE Vec3V<V> Scaled(const Vec3V<V>& a, V s) {
  return {a.x * s, a.y * s, a.z * s};
}

template <class V>
HWY_INLINE Vec3V<V> Cross(const Vec3V<V>& a, const Vec3V<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Returns a where the mask is set, otherwise b.
template <class M, class V>
HWY_INLINE Vec3V<V> Select(M mask, const Vec3V<V>& a, const Vec3V<V>& b) {
  return {hn::IfThenElse(mask, a.x, b.x), hn::IfThenElse(mask, a.y, b.y), hn::IfThenElse(mask, a.z, b.z)};
}

/// Returns a / |a|, or 0 where |a|^2 is 0, overflows or is NaN. Valid for lengths in about 1e-18..1e18.
template <class D, class V>
HWY_INLINE Vec3V<V> Normalize(D d, const Vec3V<V>& a) {
  const V squared = Dot(a, a);
  const auto usable = hn::And(hn::Gt(squared, hn::Zero(d)), hn::Lt(squared, hn::Inf(d)));
  const V inverse = hn::Set(d, 1.0f) / hn::Sqrt(hn::IfThenElse(usable, squared, hn::Set(d, 1.0f)));
  const V scale = hn::IfThenElseZero(usable, inverse);
  return {hn::IfThenElseZero(usable, a.x * scale), hn::IfThenElseZero(usable, a.y * scale),
          hn::IfThenElseZero(usable, a.z * scale)};
}

/// A unit vector perpendicular to n (Duff et al., "Building an Orthonormal Basis, Revisited", 2017).
template <class D, class V>
HWY_INLINE Vec3V<V> AnyTangent(D d, const Vec3V<V>& n) {
  const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  const V sign = hn::IfThenElse(hn::Lt(n.z, zero), hn::Set(d, -1.0f), one);
  const V a = hn::Set(d, -1.0f) / (sign + n.z);
  const V b = n.x * n.y * a;
  return {one + sign * (n.x * n.x) * a, sign * b, hn::Neg(sign * n.x)};
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_VEC3_INL_H_
