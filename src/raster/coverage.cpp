// SPDX-License-Identifier: MIT
#include "raster/coverage.h"

#include <cstdlib>

#include "raster/edge.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/coverage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Edges that fit int32 over the tile, one vector of pixels at a time.
void CoverNarrow(const Edge* edges, const DepthPlane& plane, const geometry::PixelBox& box, int32_t left, int32_t top,
                 uint32_t slot, Tile& tile) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const hn::RebindToUnsigned<decltype(d)> du;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  const auto iota = hn::Iota(di, 0);
  int32_t a[3], b[3], value[3];
  for (int k = 0; k < 3; ++k) {
    a[k] = static_cast<int32_t>(edges[k].a);
    b[k] = static_cast<int32_t>(edges[k].b);
    value[k] = static_cast<int32_t>(edges[k].value);
  }
  const auto step0 = hn::Mul(hn::Set(di, a[0]), iota);
  const auto step1 = hn::Mul(hn::Set(di, a[1]), iota);
  const auto step2 = hn::Mul(hn::Set(di, a[2]), iota);
  const auto low = hn::Set(d, plane.low), high = hn::Set(d, plane.high);
  const auto slope = hn::Set(d, plane.dx);
  const auto id = hn::Set(du, slot);
  const int32_t first_x = (box.min_x - left) / lanes * lanes;
  for (int32_t y = box.min_y - top; y <= box.max_y - top; ++y) {
    const float row_depth = plane.base + plane.dy * static_cast<float>(top + y - plane.y0);
    const auto row = hn::Set(d, row_depth);
    for (int32_t x = first_x; x <= box.max_x - left; x += lanes) {
      const auto e0 = hn::Add(hn::Set(di, value[0] + a[0] * x + b[0] * y), step0);
      const auto e1 = hn::Add(hn::Set(di, value[1] + a[1] * x + b[1] * y), step1);
      const auto e2 = hn::Add(hn::Set(di, value[2] + a[2] * x + b[2] * y), step2);
      const auto inside = hn::RebindMask(d, hn::Gt(hn::Or(hn::Or(e0, e1), e2), hn::Set(di, -1)));
      if (hn::AllFalse(d, inside)) continue;
      const auto column = hn::ConvertTo(d, hn::Add(iota, hn::Set(di, left + x - plane.x0)));
      const auto z = hn::Min(hn::Max(hn::Add(hn::Mul(slope, column), row), low), high);
      const size_t at = static_cast<size_t>(y * kTile + x);
      const auto stored = hn::Load(d, tile.depth + at);
      const auto pass = hn::And(inside, hn::Lt(z, stored));
      hn::Store(hn::IfThenElse(pass, z, stored), d, tile.depth + at);
      hn::Store(hn::IfThenElse(hn::RebindMask(du, pass), id, hn::Load(du, tile.slot + at)), du, tile.slot + at);
    }
  }
}

/// Edges too long for int32: the same arithmetic, one pixel at a time in int64.
void CoverWide(const Edge* edges, const DepthPlane& plane, const geometry::PixelBox& box, int32_t left, int32_t top,
               uint32_t slot, Tile& tile) {
  for (int32_t y = box.min_y - top; y <= box.max_y - top; ++y) {
    const float row_depth = plane.base + plane.dy * static_cast<float>(top + y - plane.y0);
    for (int32_t x = box.min_x - left; x <= box.max_x - left; ++x) {
      int64_t sides = 0;
      for (int k = 0; k < 3; ++k) sides |= edges[k].value + edges[k].a * x + edges[k].b * y;
      if (sides < 0) continue;
      float z = plane.dx * static_cast<float>(left + x - plane.x0) + row_depth;
      z = z < plane.low ? plane.low : z;
      z = z > plane.high ? plane.high : z;
      const size_t at = static_cast<size_t>(y * kTile + x);
      if (z < tile.depth[at]) {
        tile.depth[at] = z;
        tile.slot[at] = slot;
      }
    }
  }
}

void Cover(const geometry::ScreenTriangle* triangles, const uint32_t* entries, size_t count, uint32_t first_slot,
           int32_t left, int32_t top, Tile& tile) {
  const geometry::PixelBox tile_box = {left, top, left + kTile - 1, top + kTile - 1};
  for (size_t i = 0; i < count; ++i) {
    const geometry::ScreenTriangle& triangle = triangles[entries[i]];
    const geometry::PixelBox box = geometry::intersection(geometry::pixel_box(triangle), tile_box);
    Edge edges[3];
    bool outside = false, narrow = true;
    for (int k = 0; k < 3; ++k) {
      outside |= make_edge(triangle, k, left, top, &edges[k]) == EdgeSide::kOutside;
      narrow &= !outside && std::abs(edges[k].a) <= kNarrowStep && std::abs(edges[k].b) <= kNarrowStep;
    }
    if (outside) continue;
    const auto slot = first_slot + static_cast<uint32_t>(i);
    const DepthPlane plane = make_depth_plane(triangle);
    (narrow ? CoverNarrow : CoverWide)(edges, plane, box, left, top, slot, tile);
  }
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(Cover);

void cover(const core::SimdTarget& simd, const geometry::ScreenTriangle* triangles, const uint32_t* entries,
           size_t count, uint32_t first_slot, int32_t left, int32_t top, Tile* tile) {
  SHD_DISPATCH(Cover, simd)(triangles, entries, count, first_slot, left, top, *tile);
}

}  // namespace shd::raster
#endif  // HWY_ONCE
