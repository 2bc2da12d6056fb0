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
#include "simd/finite-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::FiniteOrZero;
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

template <class V>
struct Barycentric {
  V b1, b2;                      // weights of vertices 1 and 2
  V b1_dx, b1_dy, b2_dx, b2_dy;  // derivatives per pixel
  V b0;
};

/// Homogeneous raster positions of the corners of triangles.
template <class V>
struct Corners {
  V x[3], y[3], w[3];
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

/// Terms of the barycentric coordinates that all pixels of a row share. With the vertices translated so that the pixel
/// is the origin, the weights e[k] of the vertices are their cross products.
template <class V>
struct PixelRow {
  V y[3];             // translated vertices
  V e_dx[3], sum_dx;  // derivatives of the weights, and of their sum
};

template <class V>
HWY_INLINE PixelRow<V> PixelRowAt(const Corners<V>& corners, V py) {
  PixelRow<V> row;
  const V(&w)[3] = corners.w;
  for (int k = 0; k < 3; ++k) row.y[k] = corners.y[k] - py * w[k];
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    row.e_dx[k] = w[j] * row.y[i] - w[i] * row.y[j];
  }
  row.sum_dx = row.e_dx[0] + row.e_dx[1] + row.e_dx[2];
  return row;
}

/// Barycentric coordinates of raster position px in a row of pixels, and their derivatives.
template <class D, class V>
HWY_INLINE Barycentric<V> Weights(D d, const Corners<V>& corners, const PixelRow<V>& row, V px) {
  V x[3], e[3], e_dy[3];
  const V(&w)[3] = corners.w, (&y)[3] = row.y, (&e_dx)[3] = row.e_dx;
  for (int k = 0; k < 3; ++k) x[k] = corners.x[k] - px * w[k];
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    e[k] = x[i] * y[j] - x[j] * y[i];
    e_dy[k] = x[j] * w[i] - x[i] * w[j];
  }
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), sum_dx = row.sum_dx;
  const V sum = e[0] + e[1] + e[2];
  const V sum_dy = e_dy[0] + e_dy[1] + e_dy[2];
  const V size = hn::Abs(e[0]) + hn::Abs(e[1]) + hn::Abs(e[2]);
  // A smaller sum has no finite inverse; NaN fails both comparisons.
  const auto usable = hn::And(hn::Lt(size, hn::Set(d, __builtin_inff())), hn::Ge(hn::Abs(sum), hn::Set(d, 0x1p-126f)));
  const V inverse = one / hn::IfThenElse(usable, sum, one);

  const V third = hn::Set(d, 1.0f / 3.0f);
  const V raw1 = hn::IfThenElse(usable, e[1] * inverse, third);
  const V raw2 = hn::IfThenElse(usable, e[2] * inverse, third);
  Barycentric<V> result;
  result.b1_dx = hn::IfThenElseZero(usable, (e_dx[1] - raw1 * sum_dx) * inverse);
  result.b1_dy = hn::IfThenElseZero(usable, (e_dy[1] - raw1 * sum_dy) * inverse);
  result.b2_dx = hn::IfThenElseZero(usable, (e_dx[2] - raw2 * sum_dx) * inverse);
  result.b2_dy = hn::IfThenElseZero(usable, (e_dy[2] - raw2 * sum_dy) * inverse);
  result.b1 = hn::Min(hn::Max(raw1, zero), one);
  result.b2 = hn::Min(hn::Max(raw2, zero), one - result.b1);
  result.b0 = one - result.b1 - result.b2;
  return result;
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

/// Interpolates a texture coordinate and its derivatives.
template <class D, class V>
HWY_INLINE void Coordinate(D d, const CornerValues<V>& corner, const Barycentric<V>& b, size_t at, float* out,
                           float* out_dx, float* out_dy) {
  const V a1 = corner.a[1] - corner.a[0], a2 = corner.a[2] - corner.a[0];
  hn::StoreU(Blend(d, corner.a[0], corner.a[1], corner.a[2], b.b1, b.b2), d, out + at);
  hn::StoreU(FiniteOrZero(d, b.b1_dx * a1 + b.b2_dx * a2), d, out_dx + at);
  hn::StoreU(FiniteOrZero(d, b.b1_dy * a1 + b.b2_dy * a2), d, out_dy + at);
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
  const auto b = Weights(d, corners, PixelRowAt(corners, hn::Load(d, f.y + at)), hn::Load(d, f.x + at));
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

void InterpolateTexture(const geometry::Vertices& vertices, const TrianglePixels& pixels, Fragments& f) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const OneRow rows[3] = {{pixels.row[0]}, {pixels.row[1]}, {pixels.row[2]}};
  const auto corners = CornersOf(d, vertices, rows);
  const auto u = ValuesOf(d, geometry::u_of(vertices), rows), v = ValuesOf(d, geometry::v_of(vertices), rows);
  const auto lane = hn::Iota(di, 0);
  const auto left = hn::Set(d, pixels.left + 0.5f);
  size_t at = 0;
  for (size_t i = 0; i < pixels.run_count; ++i) {
    // Each row of pixels shares its terms.
    for (uint32_t begin = pixels.run[i].begin, end; begin < pixels.run[i].end; begin = end) {
      end = std::min<uint32_t>(pixels.run[i].end, begin - begin % kTile + kTile);
      const float y = static_cast<float>(static_cast<int32_t>(begin / kTile));
      const auto row = PixelRowAt(corners, hn::Set(d, (pixels.top + 0.5f) + y));
      for (size_t k = 0; k < end - begin; k += hn::Lanes(d)) {
        const auto x = hn::Set(di, static_cast<int32_t>(begin % kTile + k)) + lane;
        const auto b = Weights(d, corners, row, left + hn::ConvertTo(d, x));
        Coordinate(d, u, b, at + k, f.u, f.dudx, f.dudy);
        Coordinate(d, v, b, at + k, f.v, f.dvdx, f.dvdy);
      }
      at += end - begin;
    }
  }
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

void interpolate_texture(const core::SimdTarget& simd, const geometry::Vertices& vertices, const TrianglePixels& pixels,
                         Fragments* out) {
  SHD_DISPATCH(InterpolateTexture, simd)(vertices, pixels, *out);
}

}  // namespace shd::raster
#endif  // HWY_ONCE
