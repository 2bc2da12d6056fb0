// SPDX-License-Identifier: MIT
// Vectors of doubles for WebAssembly, which Highway 1.0.3 does not have. Only the operations that the kernels use.
// Kernels with doubles include this file after highway.h; for other targets it adds nothing.

#if defined(SHD_SIMD_DOUBLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_DOUBLE_INL_H_
#undef SHD_SIMD_DOUBLE_INL_H_
#else
#define SHD_SIMD_DOUBLE_INL_H_
#endif

#include <hwy/highway.h>

#if HWY_TARGET == HWY_WASM && !HWY_HAVE_FLOAT64
HWY_BEFORE_NAMESPACE();
namespace hwy::HWY_NAMESPACE {

template <size_t N>
using DoubleV = Vec128<double, N>;
template <size_t N>
using DoubleM = Mask128<double, N>;

template <size_t N, HWY_IF_LE128(double, N)>
HWY_API DoubleV<N> Set(Simd<double, N, 0>, double value) {
  return {wasm_f64x2_splat(value)};
}
template <size_t N>
HWY_API DoubleV<N> operator+(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_add(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleV<N> operator-(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_sub(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleV<N> operator*(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_mul(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleV<N> operator/(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_div(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleV<N> Min(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_min(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleV<N> Max(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_max(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleV<N> Abs(DoubleV<N> a) {
  return {wasm_f64x2_abs(a.raw)};
}
template <size_t N>
HWY_API DoubleV<N> Sqrt(DoubleV<N> a) {
  return {wasm_f64x2_sqrt(a.raw)};
}
template <size_t N>
HWY_API DoubleM<N> operator==(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_eq(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleM<N> operator<(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_lt(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleM<N> operator<=(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_le(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleM<N> operator>(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_gt(a.raw, b.raw)};
}
template <size_t N>
HWY_API DoubleM<N> operator>=(DoubleV<N> a, DoubleV<N> b) {
  return {wasm_f64x2_ge(a.raw, b.raw)};
}
template <size_t N, HWY_IF_LE128(double, N)>
HWY_API DoubleV<N> PromoteTo(Simd<double, N, 0>, Vec128<float, N> v) {
  return {wasm_f64x2_promote_low_f32x4(v.raw)};
}
template <size_t N, HWY_IF_LE64(float, N)>
HWY_API Vec128<float, N> DemoteTo(Simd<float, N, 0>, DoubleV<N> v) {
  return {wasm_f32x4_demote_f64x2_zero(v.raw)};
}

}  // namespace hwy::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET == HWY_WASM

#endif  // SHD_SIMD_DOUBLE_INL_H_
