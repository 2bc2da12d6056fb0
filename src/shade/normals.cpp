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
using simd::HWY_NAMESPACE::AnyTangent;
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

/// Tangent space of a point, in world space.
template <class V>
struct TangentSpace {
  Vec3V<V> t, bitangent;
};

template <class D, class V>
HWY_INLINE TangentSpace<V> TangentSpaceAt(D d, const raster::Fragments& points, const Vec3V<V>& n, size_t i) {
  const Vec3V<V> given = Normalize(d, Load3(d, points.tx, points.ty, points.tz, i));
  const Vec3V<V> across = Cross(n, given);
  const auto usable = hn::Gt(Dot(across, across), hn::Set(d, 1e-8f));
  const Vec3V<V> t = Select(usable, given, AnyTangent(d, n));
  const V side = hn::IfThenElse(hn::Lt(hn::Load(d, points.tw + i), hn::Zero(d)), hn::Set(d, -1.0f), hn::Set(d, 1.0f));
  return {t, Scaled(Cross(n, t), side)};
}

/// Transforms a vector m from the tangent space of point i to world space.
template <class D, class V>
HWY_INLINE Vec3V<V> FromTangentSpace(D d, const raster::Fragments& points, const Vec3V<V>& n, const Vec3V<V>& m,
                                     size_t i) {
  const TangentSpace<V> space = TangentSpaceAt(d, points, n, i);
  return Sum(Sum(Scaled(space.t, m.x), Scaled(space.bitangent, m.y)), Scaled(n, m.z));
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

/// Covariance of slopes as its Cholesky factor, (xx, 0) and (xy, yy).
template <class V>
struct SlopeFactor {
  V xx, xy, yy;
};

/// max(0, second - first), at most 1e9; 0 for NaN. Products with exponents and roughness stay finite.
template <class D, class V>
HWY_INLINE V Spread(D d, V second, V first) {
  const V max = hn::Set(d, 1e9f), spread = second - first;
  return hn::IfThenElseZero(hn::Gt(spread, hn::Zero(d)), hn::IfThenElse(hn::Lt(spread, max), spread, max));
}

/// Covariance of the scaled slopes x, y. `mixed` may be null: the covariance of x and y is 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE SlopeFactor<V> CovarianceAt(D d, const material::Material& material, const float* const* map,
                                       const float* mixed, V x, V y, size_t i) {
  const V zero = hn::Zero(d), scale_x = hn::Set(d, material.normal_scale[0]),
          scale_y = hn::Set(d, material.normal_scale[1]);
  const V xx = Spread(d, scale_x * scale_x * hn::Load(d, map[2] + i), x * x);
  const V yy = Spread(d, scale_y * scale_y * hn::Load(d, map[3] + i), y * y);
  SlopeFactor<V> factor = {hn::Sqrt(xx), zero, hn::Sqrt(yy)};
  if (!mixed) return factor;
  const V xy = scale_x * scale_y * hn::Load(d, mixed + i) - x * y;
  const auto usable = hn::And(hn::Gt(xx, zero), hn::Eq(xy, xy));
  const V across = xy / hn::IfThenElse(usable, factor.xx, hn::Set(d, 1.0f));
  // Rounding may make the covariance larger than the product of the deviations.
  factor.xy = hn::IfThenElseZero(usable, hn::Min(hn::Max(across, hn::Neg(factor.yy)), factor.yy));
  factor.yy = hn::Sqrt(hn::Max(yy - factor.xy * factor.xy, zero));
  return factor;
}

/// Stores v / length, or 0 where this is not finite.
template <class D, class V>
HWY_INLINE void StoreSpread(D d, const Vec3V<V>& v, V length, float* const* out, size_t i) {
  const Vec3V<V> turn = Scaled(v, hn::Set(d, 1.0f) / length);
  const auto usable = hn::Lt(Dot(turn, turn), hn::Set(d, 1e12f));
  const V zero = hn::Zero(d);
  Store3(d, Select(usable, turn, Vec3V<V>{zero, zero, zero}), out[0], out[1], out[2], i);
}

void MapMoments(const material::Material& material, const float* const* map, const float* mixed,
                raster::Fragments& points, float* const* spread) {
  const hn::ScalableTag<float> d;
  const auto scale_x = hn::Set(d, material.normal_scale[0]), scale_y = hn::Set(d, material.normal_scale[1]);
  for (size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const auto n = Load3(d, points.nx, points.ny, points.nz, i);
    const auto x = scale_x * hn::Load(d, map[0] + i), y = scale_y * hn::Load(d, map[1] + i);
    const auto space = TangentSpaceAt(d, points, n, i);
    const auto factor = CovarianceAt(d, material, map, mixed, x, y, i);
    const auto mapped = Sum(Sum(Scaled(space.t, x), Scaled(space.bitangent, y)), n);
    StoreNormal(d, mapped, n, i, points);
    // Slopes (x, y) + e have the normal mapped / |mapped| + e / |mapped|, normalised.
    const auto length = hn::Sqrt(Dot(mapped, mapped));
    const auto a = Sum(Scaled(space.t, factor.xx), Scaled(space.bitangent, factor.xy));
    StoreSpread(d, a, length, spread, i);
    StoreSpread(d, Scaled(space.bitangent, factor.yy), length, spread + 3, i);
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
HWY_EXPORT(MapMoments);
HWY_EXPORT(TiltNormals);
HWY_EXPORT(BumpNormals);

void map_normals(const core::SimdTarget& simd, const material::Material& material, const float* const map[4],
                 raster::Fragments* points, float* variance) {
  SHD_DISPATCH(MapNormals, simd)(material, map, *points, variance);
}

void map_moments(const core::SimdTarget& simd, const material::Material& material, const float* const map[4],
                 const float* mixed, raster::Fragments* points, float* const spread[6]) {
  SHD_DISPATCH(MapMoments, simd)(material, map, mixed, *points, spread);
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
