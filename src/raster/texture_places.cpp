// SPDX-License-Identifier: MIT
#include "raster/texture_places.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/texture_places.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/attribute-inl.h"
#include "raster/barycentric-inl.h"
#include "simd/finite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::IsFinite;

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

/// A part of a row of the tile: pixels begin..end - 1, which are rows `at`... of the table.
struct RowPart {
  float y;  // row of the tile
  uint32_t begin, end;
  size_t at;
};

/// Calls body(part) for the rows of all runs. Returns the number of rows of the table.
template <class Body>
HWY_INLINE size_t ForEachRow(const TrianglePixels& pixels, const Body& body) {
  size_t at = 0;
  for (size_t i = 0; i < pixels.run_count; ++i) {
    for (uint32_t begin = pixels.run[i].begin, end; begin < pixels.run[i].end; begin = end) {
      end = std::min<uint32_t>(pixels.run[i].end, next_row(begin));
      const uint32_t first = begin % kTile;
      body(RowPart{static_cast<float>(static_cast<int32_t>(begin / kTile)), first, first + (end - begin), at});
      at += end - begin;
    }
  }
  return at;
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
  return ForEachRow(pixels, [&](const RowPart& part) {
    const auto row = row_at(hn::Set(d, (pixels.top + 0.5f) + part.y));
    for (uint32_t k = part.begin; k < part.end; k += static_cast<uint32_t>(hn::Lanes(d))) {
      const auto x = hn::Set(di, static_cast<int32_t>(k)) + lane;
      fill(weights_at(row, left + hn::ConvertTo(d, x)), part.at + (k - part.begin));
    }
  });
}

void FindColumns(const geometry::Vertices& vertices, const TrianglePixels& pixels, TextureColumns* out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  const OneRow rows[3] = {{pixels.row[0]}, {pixels.row[1]}, {pixels.row[2]}};
  const auto corners = CornersOf(d, vertices, rows);
  const V left = hn::Set(d, pixels.left + 0.5f);
  for (size_t i = 0; i < TextureColumns::kColumns; i += hn::Lanes(d)) {
    const V px = left + hn::ConvertTo(d, hn::Iota(di, static_cast<int32_t>(i)));
    V x[3], e_dy[3];
    for (int k = 0; k < 3; ++k) {
      x[k] = corners.x[k] - px * corners.w[k];
      hn::Store(x[k], d, out->x[k] + i);
    }
    for (int k = 0; k < 3; ++k) e_dy[k] = WeightSlope(corners.w, x, k);
    hn::Store(e_dy[1], d, out->e1_dy + i);
    hn::Store(e_dy[2], d, out->e2_dy + i);
    hn::Store(e_dy[0] + e_dy[1] + e_dy[2], d, out->sum_dy + i);
  }
}

/// InterpolateTexture() from known columns. The loop over weights is short: its chains of operations overlap.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void FillFromColumns(D d, const Corners<V>& corners, const TextureCorners<V>& texture,
                                const TrianglePixels& pixels, const TextureColumns& columns, Fragments& f) {
  const V one = hn::Set(d, 1.0f);
  alignas(64) float inverses[TextureColumns::kColumns], weights[2][TextureColumns::kColumns];
  ForEachRow(pixels, [&](const RowPart& part) {
    const PixelRow<V> row = PixelRowAt(corners, hn::Set(d, (pixels.top + 0.5f) + part.y));
    const size_t count = part.end - part.begin;
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
      V x[3];
      for (int k = 0; k < 3; ++k) x[k] = hn::LoadU(d, columns.x[k] + part.begin + i);
      const V e0 = WeightAt(row.y, x, 0), e1 = WeightAt(row.y, x, 1), e2 = WeightAt(row.y, x, 2);
      const V inverse = one / (e0 + e1 + e2);
      hn::Store(inverse, d, inverses + i);
      hn::Store(e1 * inverse, d, weights[0] + i);
      hn::Store(e2 * inverse, d, weights[1] + i);
    }
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
      const V inverse = hn::Load(d, inverses + i), raw1 = hn::Load(d, weights[0] + i);
      const V raw2 = hn::Load(d, weights[1] + i), sum_dy = hn::LoadU(d, columns.sum_dy + part.begin + i);
      Barycentric<V> b;
      b.b1_dx = (row.e_dx[1] - raw1 * row.sum_dx) * inverse;
      b.b2_dx = (row.e_dx[2] - raw2 * row.sum_dx) * inverse;
      b.b1_dy = (hn::LoadU(d, columns.e1_dy + part.begin + i) - raw1 * sum_dy) * inverse;
      b.b2_dy = (hn::LoadU(d, columns.e2_dy + part.begin + i) - raw2 * sum_dy) * inverse;
      ClampToTriangle(d, raw1, raw2, b);
      const size_t at = part.at + i;
      hn::StoreU(PlainBlend(texture.u.a[0], texture.u.a[1], texture.u.a[2], b.b1, b.b2), d, f.u + at);
      hn::StoreU(PlainBlend(texture.v.a[0], texture.v.a[1], texture.v.a[2], b.b1, b.b2), d, f.v + at);
      FillSteps(d, PlainSteps(texture.u, b), PlainSteps(texture.v, b), at, f);
    }
  });
}

bool InterpolateTexture(const geometry::Vertices& vertices, const TrianglePixels& pixels, const TextureColumns& columns,
                        Fragments& f) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const OneRow rows[3] = {{pixels.row[0]}, {pixels.row[1]}, {pixels.row[2]}};
  const TextureCorners<V> texture = {ValuesOf(d, geometry::u_of(vertices), rows),
                                     ValuesOf(d, geometry::v_of(vertices), rows)};
  const auto corners = CornersOf(d, vertices, rows);
  if (HWY_LIKELY(columns.known)) {
    FillFromColumns(d, corners, texture, pixels, columns, f);
    return false;
  }
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
      [&](const PixelRow<V>& row, V x) { return PerspectiveWeights(d, corners, row, x); },
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
namespace {

HWY_EXPORT(FindColumns);
HWY_EXPORT(InterpolateTexture);

/// Returns a bound of the magnitudes of an attribute of a triangle and of its differences from corner 0; NaN if a value
/// is NaN.
double extent_of(const geometry::RowComponent& from, const uint32_t (&row)[3]) {
  double sum = 0;
  for (size_t k = 0; k < 3; ++k) sum += 2 * std::fabs(double{from.rows[4 * size_t{row[k]} + from.component]});
  return sum;
}

/// Whether all results at the pixels of the tile are finite: the sum of the weights is linear in the picture, so its
/// values at the corners of the tile bound it. The products of a sum are rounded to 2^-24 of their terms.
bool is_plain(const geometry::Vertices& vertices, const TrianglePixels& pixels) {
  double x[3], y[3], w[3];
  for (size_t k = 0; k < 3; ++k) {
    const float* corner = vertices.raster.data() + 4 * size_t{pixels.row[k]};
    x[k] = corner[0], y[k] = corner[1], w[k] = corner[3];
  }
  if (w[0] == w[1] && w[0] == w[2]) return false;
  const double right = pixels.left + double{kTile}, bottom = pixels.top + double{kTile};
  double width = 0, height = 0, depth = 0, least = HUGE_VAL, most = -HUGE_VAL;
  for (size_t k = 0; k < 3; ++k) {
    width = std::max(width, std::fabs(x[k]) + std::fabs(right * w[k]));
    height = std::max(height, std::fabs(y[k]) + std::fabs(bottom * w[k]));
    depth = std::max(depth, std::fabs(w[k]));
  }
  for (const double px : {double{pixels.left}, right}) {
    for (const double py : {double{pixels.top}, bottom}) {
      double sum = 0;
      for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        sum += (x[i] - px * w[i]) * (y[j] - py * w[j]) - (x[j] - px * w[j]) * (y[i] - py * w[i]);
      }
      least = std::min(least, sum);
      most = std::max(most, sum);
    }
  }
  const double nearest = std::min(std::fabs(least), std::fabs(most)), products = width * height;
  if (!(least * most > 0) || !(nearest > products * 0x1p-18 + 0x1p-80) || !(products < 0x1p100)) return false;
  // A weight is at most 2 products, and a derivative of it 2 depth times width or height.
  const double raw = 4 * products / nearest, slope = 2 * depth * std::max(width, height);
  const double step = (slope + raw * 3 * slope) * 2 / nearest;
  const double extent =
      extent_of(geometry::u_of(vertices), pixels.row) + extent_of(geometry::v_of(vertices), pixels.row);
  return step < 0x1p100 && extent < 0x1p100 && step * extent < 0x1p100;
}

}  // namespace

void find_columns(const core::SimdTarget& simd, const geometry::Vertices& vertices, const TrianglePixels& pixels,
                  TextureColumns* out) {
  out->known = is_plain(vertices, pixels);
  if (out->known) SHD_DISPATCH(FindColumns, simd)(vertices, pixels, out);
}

bool interpolate_texture(const core::SimdTarget& simd, const geometry::Vertices& vertices, const TrianglePixels& pixels,
                         const TextureColumns& columns, Fragments* out) {
  return SHD_DISPATCH(InterpolateTexture, simd)(vertices, pixels, columns, *out);
}

}  // namespace shd::raster
#endif  // HWY_ONCE
