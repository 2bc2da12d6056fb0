// SPDX-License-Identifier: MIT
#include "raster/interpolate.h"

#include <algorithm>
#include <iterator>

#include "data/data.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/interpolate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/attribute-inl.h"
#include "raster/lit_rows-inl.h"
#include "raster/planes-inl.h"
#include "raster/spans-inl.h"
#include "simd/finite-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::FiniteOrZero;
using simd::HWY_NAMESPACE::IsFinite;
using simd::HWY_NAMESPACE::Normalize;
using simd::HWY_NAMESPACE::Store3;
using simd::HWY_NAMESPACE::Vec3V;

/// Columns that only some materials read.
constexpr uint32_t kExtras = kTexture1 | kTangent | kAttributes | kPositionSteps;

/// A triangle whose rows are interpolated, and what is wanted of them.
struct TriangleRows {
  const geometry::Vertices& vertices;
  uint32_t vertex[3];  // rows of `vertices`
  const float* eye;
  uint32_t wanted;
  TrianglePlanes planes;
  Sides position[3], normal[3];

  Sides SidesOf(const float* rows, size_t c) const {
    const float origin = rows[4 * size_t{vertex[0]} + c];
    return {origin, rows[4 * size_t{vertex[1]} + c] - origin, rows[4 * size_t{vertex[2]} + c] - origin};
  }

  /// Component c of the corners' rows of four.
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE CornerValues<V> Corners(D d, const float* rows, size_t c) const {
    return {{hn::Set(d, rows[4 * size_t{vertex[0]} + c]), hn::Set(d, rows[4 * size_t{vertex[1]} + c]),
             hn::Set(d, rows[4 * size_t{vertex[2]} + c])}};
  }
};

/// Stores a texture coordinate and its derivatives.
template <class D, class V>
HWY_INLINE void Store(D d, const Attribute<V>& attribute, size_t at, float* value, float* dx, float* dy) {
  hn::StoreU(attribute.value, d, value + at);
  hn::StoreU(attribute.dx, d, dx + at);
  hn::StoreU(attribute.dy, d, dy + at);
}

/// Interpolates the position.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vec3V<V> PositionAt(D d, const TriangleRows& triangle, const Barycentric<V>& b) {
  const Sides(&sides)[3] = triangle.position;
  const Vec3V<V> p = {sides[0].At(d, b), sides[1].At(d, b), sides[2].At(d, b)};
  if (HWY_LIKELY(hn::AllTrue(d, IsFinite(d, hn::Abs(p.x) + hn::Abs(p.y) + hn::Abs(p.z))))) return p;
  const float* world = triangle.vertices.world.data();
  return {Blend(d, triangle.Corners(d, world, 0), b.b1, b.b2), Blend(d, triangle.Corners(d, world, 1), b.b1, b.b2),
          Blend(d, triangle.Corners(d, world, 2), b.b1, b.b2)};
}

/// Interpolates position, normal and wo of one vector of rows. Normals are units: their blends do not overflow.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void InterpolateSpace(D d, const TriangleRows& triangle, const Barycentric<V>& b, size_t at, Fragments& f) {
  if (triangle.wanted & kNormal) {
    const Vec3V<V> n = {triangle.normal[0].At(d, b), triangle.normal[1].At(d, b), triangle.normal[2].At(d, b)};
    Store3(d, Normalize(d, n), f.nx, f.ny, f.nz, at);
  }
  if (!(triangle.wanted & (kPosition | kToEye))) return;
  const Vec3V<V> p = PositionAt(d, triangle, b);
  Store3(d, p, f.px, f.py, f.pz, at);
  if (!(triangle.wanted & kToEye)) return;
  const float* eye = triangle.eye;
  const Vec3V<V> to_eye = {hn::Set(d, eye[0]) - p.x, hn::Set(d, eye[1]) - p.y, hn::Set(d, eye[2]) - p.z};
  Store3(d, Normalize(d, to_eye), f.ox, f.oy, f.oz, at);
}

/// Derivatives of the position by pixel steps, of one vector of rows.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void DifferentiatePosition(D d, const TriangleRows& triangle, V factor, const Barycentric<V>& b, size_t at,
                                      Fragments& f) {
  const TrianglePlanes& planes = triangle.planes;
  const Attribute<V> b1 = WithSteps(d, planes.b1, planes.inverse_w, factor, b.b1),
                     b2 = WithSteps(d, planes.b2, planes.inverse_w, factor, b.b2);
  for (size_t c = 0; c < 3; ++c) {
    const CornerValues<V> p = triangle.Corners(d, triangle.vertices.world.data(), c);
    const V side1 = p.a[1] - p.a[0], side2 = p.a[2] - p.a[0];
    hn::StoreU(FiniteOrZero(d, side1 * b1.dx + side2 * b2.dx), d, f.dpdx[c] + at);
    hn::StoreU(FiniteOrZero(d, side1 * b1.dy + side2 * b2.dy), d, f.dpdy[c] + at);
  }
}

/// Interpolates columns that only some materials read.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void InterpolateExtras(D d, const TriangleRows& triangle, V factor, const Barycentric<V>& b,
                                  const PixelsAt<V>& pixels, size_t at, Fragments& f) {
  const uint32_t wanted = triangle.wanted;
  const geometry::Vertices& vertices = triangle.vertices;
  const TrianglePlanes& planes = triangle.planes;
  if (wanted & kPositionSteps) DifferentiatePosition(d, triangle, factor, b, at, f);
  if (wanted & kTexture1 && vertices.texture1.size()) {
    Store(d, CoordinateAt(d, planes.u1, planes.inverse_w, factor, pixels), at, f.u1, f.du1dx, f.du1dy);
    Store(d, CoordinateAt(d, planes.v1, planes.inverse_w, factor, pixels), at, f.v1, f.dv1dx, f.dv1dy);
  }
  if (wanted & kTangent && vertices.tangent.size()) {
    float* const out[4] = {f.tx, f.ty, f.tz, f.tw};
    for (size_t c = 0; c < 4; ++c) {
      hn::StoreU(Blend(d, triangle.Corners(d, vertices.tangent.data(), c), b.b1, b.b2), d, out[c] + at);
    }
  }
  for (size_t k = 0; wanted & kAttributes && k < SHD_MAX_ATTRIBUTES; ++k) {
    const core::Array<float>& four = vertices.attribute[k / 4];
    if (four.size() == 0) continue;
    hn::StoreU(Blend(d, triangle.Corners(d, four.data(), k % 4), b.b1, b.b2), d, f.attribute[k] + at);
  }
}

/// Interpolates rows begin..end - 1, which belong to one triangle. The last vector may write past them.
void InterpolateTriangle(const TriangleRows& rows, size_t begin, size_t end, Fragments& f) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const TriangleRows triangle = rows;  // a copy that the stores cannot change
  const TrianglePlanes& planes = triangle.planes;
  const uint32_t wanted = triangle.wanted;
  for (size_t at = begin; at < end; at += hn::Lanes(d)) {
    const PixelsAt<V> pixels = {hn::LoadU(d, f.x + at) - hn::Set(d, planes.middle_x),
                                hn::LoadU(d, f.y + at) - hn::Set(d, planes.middle_y)};
    const V factor = FactorOf(d, planes.inverse_w, pixels);
    if (wanted & kTexture) {
      Store(d, CoordinateAt(d, planes.u, planes.inverse_w, factor, pixels), at, f.u, f.dudx, f.dudy);
      Store(d, CoordinateAt(d, planes.v, planes.inverse_w, factor, pixels), at, f.v, f.dvdx, f.dvdy);
    }
    if (!(wanted & ~uint32_t{kTexture})) continue;
    const Barycentric<V> b = WeightsAt(d, planes, factor, pixels);
    if (wanted & kBarycentrics) {
      hn::StoreU(b.b0, d, f.bary[0] + at);
      hn::StoreU(b.b1, d, f.bary[1] + at);
      hn::StoreU(b.b2, d, f.bary[2] + at);
    }
    InterpolateSpace(d, triangle, b, at, f);
    if (wanted & kExtras) InterpolateExtras(d, triangle, factor, b, pixels, at, f);
  }
}

/// Returns the first row after `begin` with another triangle or in another cell, or `end`.
HWY_INLINE size_t EndOfSpan(const Fragments& f, size_t begin, size_t end) {
  end = EndOfTriangle(f.triangle, begin, end);
  const bool is_cell = (f.left | f.top) % kTile == 0;
  if (HWY_LIKELY(is_cell)) return end;
  const Cell cell = cell_of(f.left, f.top, f.pixel[begin]);
  size_t i = begin + 1;
  while (i < end && cell_of(f.left, f.top, f.pixel[i]) == cell) ++i;
  return i;
}

void Interpolate(const geometry::Vertices& vertices, const float* eye, uint32_t wanted, Fragments& f) {
  const hn::ScalableTag<float> d;
  const size_t count = (f.count + hn::Lanes(d) - 1) / hn::Lanes(d) * hn::Lanes(d);
  for (size_t begin = 0, end; begin < count; begin = end) {
    end = EndOfSpan(f, begin, count);
    TriangleRows triangle = {vertices, {}, eye, wanted, {}, {}, {}};
    for (size_t k = 0; k < 3; ++k) triangle.vertex[k] = geometry::row_of(vertices, f.triangle[begin], k);
    find_planes(vertices, triangle.vertex, cell_of(f.left, f.top, f.pixel[begin]), wanted, &triangle.planes);
    for (size_t c = 0; c < 3; ++c) {
      triangle.position[c] = triangle.SidesOf(vertices.world.data(), c);
      triangle.normal[c] = triangle.SidesOf(vertices.normal.data(), c);
    }
    if (wanted == kLitColumns && end - begin >= kLongSpan * hn::Lanes(d) && are_bounded(triangle.position)) {
      InterpolateLit({triangle.planes, triangle.position, triangle.normal, eye}, begin, end, f.x);
    } else {
      InterpolateTriangle(triangle, begin, end, f);
    }
  }
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(Interpolate);

void interpolate(const core::SimdTarget& simd, const geometry::Vertices& vertices, const float eye[3], uint32_t wanted,
                 Fragments* fragments) {
  SHD_DISPATCH(Interpolate, simd)(vertices, eye, wanted, *fragments);
  const auto clear = [&](float* const* begin, float* const* end) {
    for (; begin != end; ++begin) std::fill_n(*begin, data::padded(fragments->count), 0.0f);
  };
  Fragments& f = *fragments;
  float* const texture1[] = {f.u1, f.v1, f.du1dx, f.dv1dx, f.du1dy, f.dv1dy};
  float* const tangent[] = {f.tx, f.ty, f.tz, f.tw};
  if (wanted & kTexture1 && vertices.texture1.size() == 0) clear(std::begin(texture1), std::end(texture1));
  if (wanted & kTangent && vertices.tangent.size() == 0) clear(std::begin(tangent), std::end(tangent));
}

}  // namespace shd::raster
#endif  // HWY_ONCE
