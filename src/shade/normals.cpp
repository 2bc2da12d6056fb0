// SPDX-License-Identifier: MIT
#include "shade/normals.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/normals.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Cross;
using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Load3;
using simd::HWY_NAMESPACE::Normalize;
using simd::HWY_NAMESPACE::Scaled;
using simd::HWY_NAMESPACE::Select;
using simd::HWY_NAMESPACE::Store3;
using simd::HWY_NAMESPACE::Sum;
using simd::HWY_NAMESPACE::Vec3V;

/// Stores the unit vector of `wanted`, or `old` where this is 0 or not finite.
template <class D, class V>
HWY_INLINE void StoreNormal(D d, const Vec3V<V>& wanted, const Vec3V<V>& old, size_t i, raster::Fragments& points) {
  const Vec3V<V> n = Normalize(d, wanted);
  const auto usable = hn::Gt(Dot(n, n), hn::Zero(d));
  Store3(d, Select(usable, n, old), points.nx, points.ny, points.nz, i);
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

/// Transforms a vector m from the tangent space of point i to world space.
template <class D, class V>
HWY_INLINE Vec3V<V> FromTangentSpace(D d, const raster::Fragments& points, const Vec3V<V>& n, const Vec3V<V>& m,
                                     size_t i) {
  const Vec3V<V> given = Normalize(d, Load3(d, points.tx, points.ty, points.tz, i));
  const Vec3V<V> across = Cross(n, given);
  const auto usable = hn::Gt(Dot(across, across), hn::Set(d, 1e-8f));
  const Vec3V<V> t = Select(usable, given, AnyTangent(d, n));
  const V side = hn::IfThenElse(hn::Lt(hn::Load(d, points.tw + i), hn::Zero(d)), hn::Set(d, -1.0f), hn::Set(d, 1.0f));
  return Sum(Sum(Scaled(t, m.x), Scaled(Cross(n, t), side * m.y)), Scaled(n, m.z));
}

/// A normal in tangent space, and the variance of slopes removed by filtering its texel.
template <class V>
struct Mapped {
  Vec3V<V> m;
  V variance;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE Mapped<V> Decode(D d, const material::Material& material, const float* const* map, size_t i) {
  const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  const V factor = hn::Set(d, material.normal_factor), offset = hn::Set(d, material.normal_offset);
  const V scale_x = hn::Set(d, material.normal_scale[0]), scale_y = hn::Set(d, material.normal_scale[1]);
  const V squared_scale = scale_x * scale_x;
  const V a = hn::Load(d, map[0] + i), b = hn::Load(d, map[1] + i);
  if (material.normal_encoding == SHD_NORMAL_ENCODING_MOMENTS) {
    const V squares = hn::Load(d, map[2] + i) + hn::Load(d, map[3] + i);
    const V spread = squares - (a * a + b * b);
    const V half = hn::Set(d, 0.5f) * (squared_scale * spread);
    const V max = hn::Set(d, 1e30f);  // keeps products with exponents finite
    const V held = hn::IfThenElse(hn::Lt(half, max), half, max);
    return {{a * scale_x, b * scale_y, one}, hn::IfThenElseZero(hn::Gt(half, zero), held)};
  }
  const V x = factor * a + offset, y = factor * b + offset;
  if (material.normal_encoding == SHD_NORMAL_ENCODING_XY) {
    const V rest = one - (x * x + y * y);
    return {{x * scale_x, y * scale_y, hn::Sqrt(hn::IfThenElseZero(hn::Gt(rest, zero), rest))}, zero};
  }
  const Vec3V<V> m = {x * scale_x, y * scale_y, factor * hn::Load(d, map[2] + i) + offset};
  if (material.normal_encoding != SHD_NORMAL_ENCODING_TOKSVIG) return {m, zero};
  const V given = hn::Load(d, map[3] + i);
  const auto shorter = hn::Lt(given, one);
  const V length = hn::IfThenElse(hn::Gt(given, hn::Set(d, 0.01f)), given, hn::Set(d, 0.01f));
  const V variance = squared_scale * ((one - length) / length);
  return {m, hn::IfThenElseZero(shorter, variance)};
}

void MapNormals(const material::Material& material, const float* const* map, raster::Fragments& points,
                float* variance) {
  const hn::ScalableTag<float> d;
  for (size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const auto n = Load3(d, points.nx, points.ny, points.nz, i);
    const auto mapped = Decode(d, material, map, i);
    hn::Store(mapped.variance, d, variance + i);
    StoreNormal(d, FromTangentSpace(d, points, n, mapped.m, i), n, i, points);
  }
}

void TiltNormals(const float* const* tilt, raster::Fragments& points) {
  const hn::ScalableTag<float> d;
  for (size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const auto n = Load3(d, points.nx, points.ny, points.nz, i);
    const Vec3V<hn::Vec<decltype(d)>> m = {hn::Load(d, tilt[0] + i), hn::Load(d, tilt[1] + i), hn::Set(d, 1.0f)};
    StoreNormal(d, FromTangentSpace(d, points, n, m, i), n, i, points);
  }
}

void BumpNormals(const float* const* tilt, const float* const* tangent_frame, raster::Fragments& points) {
  const hn::ScalableTag<float> d;
  for (size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const auto n = Load3(d, points.nx, points.ny, points.nz, i);
    const auto dpdu = Load3(d, tangent_frame[0], tangent_frame[1], tangent_frame[2], i);
    const auto dpdv = Load3(d, tangent_frame[3], tangent_frame[4], tangent_frame[5], i);
    const auto r1 = Cross(dpdv, n), r2 = Cross(n, dpdu);
    const auto area = Dot(dpdu, r1);
    const auto flat = hn::Lt(hn::Abs(area), hn::Set(d, 1.17549435e-38f));
    const auto safe = hn::IfThenElse(flat, hn::Set(d, 1.0f), area);
    // The division comes first, because the lengths of the frame may be far from 1.
    const auto slope = Sum(Scaled(r1, hn::Load(d, tilt[0] + i) / safe), Scaled(r2, hn::Load(d, tilt[1] + i) / safe));
    const auto turned = Sum(n, Scaled(slope, hn::Set(d, -1.0f)));
    StoreNormal(d, Select(flat, n, turned), n, i, points);
  }
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {

HWY_EXPORT(MapNormals);
HWY_EXPORT(TiltNormals);
HWY_EXPORT(BumpNormals);

void map_normals(const core::SimdTarget& simd, const material::Material& material, const float* const map[4],
                 raster::Fragments* points, float* variance) {
  SHD_DISPATCH(MapNormals, simd)(material, map, *points, variance);
}

void tilt_normals(const core::SimdTarget& simd, const float* const tilt[2], raster::Fragments* points) {
  SHD_DISPATCH(TiltNormals, simd)(tilt, *points);
}

void bump_normals(const core::SimdTarget& simd, const float* const tilt[2], const float* const tangent_frame[6],
                  raster::Fragments* points) {
  SHD_DISPATCH(BumpNormals, simd)(tilt, tangent_frame, *points);
}

}  // namespace shd::shade
#endif  // HWY_ONCE
