// SPDX-License-Identifier: MIT
#include "raster/texture_places.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/texture_places.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/planes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Columns of texture coordinates and of their derivatives.
struct PlaceColumns {
  float *u, *v, *dudx, *dvdx, *dudy, *dvdy;
};

/// Fills `count` pixels of a row, to the right of `at`. The last vector may write past them.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void FillRow(D d, const TrianglePlanes& planes, PixelsAt<V> at, size_t count, const PlaceColumns& out) {
  const V step = hn::Set(d, static_cast<float>(hn::Lanes(d)));
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V factor = FactorOf(d, planes.inverse_w, at);
    const Attribute<V> u = CoordinateAt(d, planes.u, planes.inverse_w, factor, at),
                       v = CoordinateAt(d, planes.v, planes.inverse_w, factor, at);
    hn::StoreU(u.value, d, out.u + i);
    hn::StoreU(v.value, d, out.v + i);
    hn::StoreU(u.dx, d, out.dudx + i);
    hn::StoreU(v.dx, d, out.dvdx + i);
    hn::StoreU(u.dy, d, out.dudy + i);
    hn::StoreU(v.dy, d, out.dvdy + i);
    at.x = at.x + step;
  }
}

void InterpolateTexture(const TrianglePixels& pixels, Fragments& f) {
  const hn::ScalableTag<float> d;
  const TrianglePlanes planes = pixels.planes;  // a copy that the stores cannot change
  const auto lane = hn::ConvertTo(d, hn::Iota(hn::RebindToSigned<decltype(d)>(), 0));
  const float left = static_cast<float>(pixels.left) + 0.5f - planes.middle_x;
  const float top = static_cast<float>(pixels.top) + 0.5f - planes.middle_y;
  size_t row = 0;
  for (size_t i = 0; i < pixels.run_count; ++i) {
    for (uint32_t begin = pixels.run[i].begin, end; begin < pixels.run[i].end; begin = end) {
      end = std::min<uint32_t>(pixels.run[i].end, next_row(begin));
      const auto x = static_cast<int32_t>(begin % kTile), y = static_cast<int32_t>(begin / kTile);
      FillRow(d, planes, {hn::Set(d, left + static_cast<float>(x)) + lane, hn::Set(d, top + static_cast<float>(y))},
              end - begin, {f.u + row, f.v + row, f.dudx + row, f.dvdx + row, f.dudy + row, f.dvdy + row});
      row += end - begin;
    }
  }
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(InterpolateTexture);

void interpolate_texture(const core::SimdTarget& simd, const TrianglePixels& pixels, Fragments* out) {
  SHD_DISPATCH(InterpolateTexture, simd)(pixels, *out);
}

}  // namespace shd::raster
#endif  // HWY_ONCE
