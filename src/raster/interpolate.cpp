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

/// Reads component c of rows of four; all lanes read the same row.
struct OneRow {
  size_t row;
  template <class D>
  HWY_INLINE hn::Vec<D> Get(D d, const float* rows, int c) const {
    return hn::Set(d, rows[4 * row + static_cast<size_t>(c)]);
  }
};

/// Reads component c of rows of four; each lane reads its own row.
template <class D>
struct RowPerLane {
  hn::Vec<hn::RebindToSigned<D>> first;  // index of component 0
  HWY_INLINE hn::Vec<D> Get(D d, const float* rows, int c) const {
    const hn::RebindToSigned<D> di;
    return hn::GatherIndex(d, rows, first + hn::Set(di, c));
  }
};

template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE Corners<V> CornersOf(D d, const geometry::Vertices& vertices, const Rows (&rows)[3]) {
  Corners<V> corners;
  for (int k = 0; k < 3; ++k) {
    const float* raster = vertices.raster.data();
    corners.x[k] = rows[k].Get(d, raster, 0);
    corners.y[k] = rows[k].Get(d, raster, 1);
    corners.w[k] = rows[k].Get(d, raster, 3);
  }
  return corners;
}

/// Component c of rows of four, interpolated.
template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE V Attribute(D d, const float* values, int c, const Rows (&rows)[3], const Barycentric<V>& b) {
  return Blend(d, rows[0].Get(d, values, c), rows[1].Get(d, values, c), rows[2].Get(d, values, c), b.b1, b.b2);
}

/// A texture coordinate at the corners of triangles.
template <class V>
struct CornerValues {
  V a[3];
};

template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE CornerValues<V> ValuesOf(D d, const geometry::RowComponent& from, const Rows (&rows)[3]) {
  const auto c = static_cast<int>(from.component);
  return {{rows[0].Get(d, from.rows, c), rows[1].Get(d, from.rows, c), rows[2].Get(d, from.rows, c)}};
}

/// Derivatives of a texture coordinate per pixel.
template <class V>
struct Steps {
  V dx, dy;
};
template <class D, class V>
HWY_INLINE Steps<V> StepsOf(D d, const CornerValues<V>& corner, const Barycentric<V>& b) {
  const V a1 = corner.a[1] - corner.a[0], a2 = corner.a[2] - corner.a[0];
  return {FiniteOrZero(d, b.b1_dx * a1 + b.b2_dx * a2), FiniteOrZero(d, b.b1_dy * a1 + b.b2_dy * a2)};
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

/// Texture coordinates of the corners of one triangle.
template <class V>
struct TextureCorners {
  CornerValues<V> u, v;
};

/// Interpolates both texture coordinates of a vector of pixels.
template <class D, class V>
HWY_INLINE void FillCoordinates(D d, const TextureCorners<V>& corner, const Barycentric<V>& b, size_t at,
                                Fragments& f) {
  const V(&a)[3] = corner.u.a, (&c)[3] = corner.v.a;
  V u = PlainBlend(a[0], a[1], a[2], b.b1, b.b2), v = PlainBlend(c[0], c[1], c[2], b.b1, b.b2);
  if (HWY_UNLIKELY(!hn::AllTrue(d, hn::And(IsFinite(d, u), IsFinite(d, v))))) {
    u = Blend(d, a[0], a[1], a[2], b.b1, b.b2);
    v = Blend(d, c[0], c[1], c[2], b.b1, b.b2);
  }
  hn::StoreU(u, d, f.u + at);
  hn::StoreU(v, d, f.v + at);
}

/// Stores the derivatives of both texture coordinates at a vector of pixels.
template <class D, class V>
HWY_INLINE void FillSteps(D d, const Steps<V>& u, const Steps<V>& v, size_t at, Fragments& f) {
  hn::StoreU(u.dx, d, f.dudx + at);
  hn::StoreU(v.dx, d, f.dvdx + at);
  hn::StoreU(u.dy, d, f.dudy + at);
  hn::StoreU(v.dy, d, f.dvdy + at);
}

/// Calls fill(b, at) for each vector of pixels of one triangle with their barycentric coordinates. `row_at(y)` returns
/// the terms that a row of pixels shares, `weights_at(row, x)` the coordinates of a vector of its pixels. Returns the
/// number of rows.
template <class D, class RowTerms, class PixelWeights, class Fill>
HWY_INLINE size_t ForEachPixelVector(D d, const TrianglePixels& pixels, const RowTerms& row_at,
                                     const PixelWeights& weights_at, const Fill& fill) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const auto lane = hn::Iota(di, 0);
  const V left = hn::Set(d, pixels.left + 0.5f);
  size_t at = 0;
  for (size_t i = 0; i < pixels.run_count; ++i) {
    for (uint32_t begin = pixels.run[i].begin, end; begin < pixels.run[i].end; begin = end) {
      end = std::min<uint32_t>(pixels.run[i].end, begin - begin % kTile + kTile);
      const float y = static_cast<float>(static_cast<int32_t>(begin / kTile));
      const auto row = row_at(hn::Set(d, (pixels.top + 0.5f) + y));
      for (size_t k = 0; k < end - begin; k += hn::Lanes(d)) {
        const auto x = hn::Set(di, static_cast<int32_t>(begin % kTile + k)) + lane;
        fill(weights_at(row, left + hn::ConvertTo(d, x)), at + k);
      }
      at += end - begin;
    }
  }
  return at;
}

bool InterpolateTexture(const geometry::Vertices& vertices, const TrianglePixels& pixels, Fragments& f) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const OneRow rows[3] = {{pixels.row[0]}, {pixels.row[1]}, {pixels.row[2]}};
  const TextureCorners<V> texture = {ValuesOf(d, geometry::u_of(vertices), rows),
                                     ValuesOf(d, geometry::v_of(vertices), rows)};
  const auto corners = CornersOf(d, vertices, rows);
  const auto affine = AffineTrianglesOf(d, corners);
  if (hn::AllTrue(d, affine.usable)) {
    const auto weights_at = [&](const AffineRow<V>& row, V x) { return AffineWeights(d, affine, row, x); };
    const size_t count = ForEachPixelVector(
        d, pixels, [&](V y) { return AffineRowAt(affine, y); }, weights_at,
        [&](const Barycentric<V>& b, size_t at) { FillCoordinates(d, texture, b, at, f); });
    const Barycentric<V> any = weights_at({hn::Zero(d), hn::Zero(d)}, hn::Zero(d));
    const Steps<V> u = StepsOf(d, texture.u, any), v = StepsOf(d, texture.v, any);
    for (size_t at = 0; at < count; at += hn::Lanes(d)) FillSteps(d, u, v, at, f);
    return true;
  }
  ForEachPixelVector(
      d, pixels, [&](V y) { return PixelRowAt(corners, y); },
      [&](const PixelRow<V>& row, V x) { return Weights(d, corners, row, x); },
      [&](const Barycentric<V>& b, size_t at) {
        FillCoordinates(d, texture, b, at, f);
        FillSteps(d, StepsOf(d, texture.u, b), StepsOf(d, texture.v, b), at, f);
      });
  return false;
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(Interpolate);
HWY_EXPORT(InterpolateTexture);

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

bool interpolate_texture(const core::SimdTarget& simd, const geometry::Vertices& vertices, const TrianglePixels& pixels,
                         Fragments* out) {
  return SHD_DISPATCH(InterpolateTexture, simd)(vertices, pixels, *out);
}

}  // namespace shd::raster
#endif  // HWY_ONCE
