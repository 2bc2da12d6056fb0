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
#include "raster/barycentric-inl.h"
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

/// Component c of rows of four, interpolated.
template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE V Attribute(D d, const float* values, int c, const Rows (&rows)[3], const Barycentric<V>& b) {
  return Blend(d, rows[0].Get(d, values, c), rows[1].Get(d, values, c), rows[2].Get(d, values, c), b.b1, b.b2);
}

/// Interpolates a texture coordinate and its derivatives.
template <class D, class V>
HWY_INLINE void Coordinate(D d, const CornerValues<V>& corner, const Barycentric<V>& b, size_t at, float* out,
                           float* out_dx, float* out_dy) {
  hn::StoreU(Blend(d, corner.a[0], corner.a[1], corner.a[2], b.b1, b.b2), d, out + at);
  const Steps<V> steps = StepsOf(d, corner, b);
  hn::StoreU(steps.dx, d, out_dx + at);
  hn::StoreU(steps.dy, d, out_dy + at);
}

/// Interpolates position, normal and wo of one vector of rows.
template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE void InterpolateSpace(D d, const geometry::Vertices& vertices, const Rows (&rows)[3],
                                 const Barycentric<V>& b, const float* eye, uint32_t wanted, size_t at, Fragments& f) {
  const float *world = vertices.world.data(), *normals = vertices.normal.data();
  if (wanted & kNormal) {
    const Vec3V<V> n = Normalize(d, Vec3V<V>{Attribute(d, normals, 0, rows, b), Attribute(d, normals, 1, rows, b),
                                             Attribute(d, normals, 2, rows, b)});
    Store3(d, n, f.nx, f.ny, f.nz, at);
  }
  if (!(wanted & (kPosition | kToEye))) return;
  const Vec3V<V> p = {Attribute(d, world, 0, rows, b), Attribute(d, world, 1, rows, b),
                      Attribute(d, world, 2, rows, b)};
  Store3(d, p, f.px, f.py, f.pz, at);
  if (!(wanted & kToEye)) return;
  const Vec3V<V> to_eye = {hn::Set(d, eye[0]) - p.x, hn::Set(d, eye[1]) - p.y, hn::Set(d, eye[2]) - p.z};
  const Vec3V<V> o = Normalize(d, to_eye);
  Store3(d, o, f.ox, f.oy, f.oz, at);
}

/// Derivatives of the position by pixel steps, of one vector of rows.
template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE void DifferentiatePosition(D d, const geometry::Vertices& vertices, const Rows (&rows)[3],
                                      const Barycentric<V>& b, size_t at, Fragments& f) {
  for (int c = 0; c < 3; ++c) {
    const float* const world = vertices.world.data();
    const V origin = rows[0].Get(d, world, c);
    const V side1 = rows[1].Get(d, world, c) - origin, side2 = rows[2].Get(d, world, c) - origin;
    hn::Store(FiniteOrZero(d, side1 * b.b1_dx + side2 * b.b2_dx), d, f.dpdx[c] + at);
    hn::Store(FiniteOrZero(d, side1 * b.b1_dy + side2 * b.b2_dy), d, f.dpdy[c] + at);
  }
}

/// Interpolates columns that only some materials read.
template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE void InterpolateExtras(D d, const geometry::Vertices& vertices, const Rows (&rows)[3],
                                  const Barycentric<V>& b, uint32_t wanted, size_t at, Fragments& f) {
  if (wanted & kPositionSteps) DifferentiatePosition(d, vertices, rows, b, at, f);
  if (wanted & kTexture1 && vertices.texture1.size()) {
    Coordinate(d, ValuesOf(d, geometry::u1_of(vertices), rows), b, at, f.u1, f.du1dx, f.du1dy);
    Coordinate(d, ValuesOf(d, geometry::v1_of(vertices), rows), b, at, f.v1, f.dv1dx, f.dv1dy);
  }
  if (wanted & kTangent && vertices.tangent.size()) {
    float* const out[4] = {f.tx, f.ty, f.tz, f.tw};
    for (int c = 0; c < 4; ++c) hn::Store(Attribute(d, vertices.tangent.data(), c, rows, b), d, out[c] + at);
  }
  for (int k = 0; wanted & kAttributes && k < SHD_MAX_ATTRIBUTES; ++k) {
    const core::Array<float>& four = vertices.attribute[k / 4];
    if (four.size()) hn::Store(Attribute(d, four.data(), k % 4, rows, b), d, f.attribute[k] + at);
  }
}

/// Interpolates one vector of rows from row `at` on.
template <class D, class Rows>
HWY_INLINE void InterpolateRows(D d, const geometry::Vertices& vertices, const Rows (&rows)[3], const float* eye,
                                uint32_t wanted, size_t at, Fragments& f) {
  const auto corners = CornersOf(d, vertices, rows);
  const auto b = WeightsAt(d, corners, hn::Load(d, f.x + at), hn::Load(d, f.y + at));
  if (wanted & kBarycentrics) {
    hn::Store(b.b0, d, f.bary[0] + at);
    hn::Store(b.b1, d, f.bary[1] + at);
    hn::Store(b.b2, d, f.bary[2] + at);
  }
  InterpolateSpace(d, vertices, rows, b, eye, wanted, at, f);
  if (wanted & kTexture) {
    Coordinate(d, ValuesOf(d, geometry::u_of(vertices), rows), b, at, f.u, f.dudx, f.dudy);
    Coordinate(d, ValuesOf(d, geometry::v_of(vertices), rows), b, at, f.v, f.dvdx, f.dvdy);
  }
  InterpolateExtras(d, vertices, rows, b, wanted, at, f);
}

void Interpolate(const geometry::Vertices& vertices, const float* eye, uint32_t wanted, Fragments& f) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const size_t lanes = hn::Lanes(d);
  for (size_t at = 0; at < f.count; at += lanes) {
    if (ShareTriangle(d, f, at)) {
      const OneRow rows[3] = {{f.vertex[0][at]}, {f.vertex[1][at]}, {f.vertex[2][at]}};
      InterpolateRows(d, vertices, rows, eye, wanted, at, f);
    } else {
      const auto first = [&](int k) {
        const hn::RebindToUnsigned<decltype(d)> du;
        return hn::BitCast(di, hn::ShiftLeft<2>(hn::Load(du, f.vertex[k] + at)));
      };
      const RowPerLane<decltype(d)> rows[3] = {{first(0)}, {first(1)}, {first(2)}};
      InterpolateRows(d, vertices, rows, eye, wanted, at, f);
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
