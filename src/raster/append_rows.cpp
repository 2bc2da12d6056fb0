// SPDX-License-Identifier: MIT
#include "raster/append_rows.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/append_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void AppendRows(const PixelRun* runs, size_t count, uint32_t triangle, Fragments& f) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const hn::RebindToSigned<decltype(d)> di;
  static_assert(hn::MaxLanes(d) <= kColumn - kBatch, "the last vector must lie in the columns");
  uint32_t *const pixel = f.pixel, *const mask = f.mask, *const index = f.triangle;
  float *const x = f.x, *const y = f.y;
  const float left = static_cast<float>(f.left) + 0.5f, top = static_cast<float>(f.top) + 0.5f;
  size_t at = f.count;
  const auto lefts = hn::Set(d, left);
  const auto triangles = hn::Set(du, triangle), lanes = hn::Set(du, static_cast<uint32_t>(hn::Lanes(d)));
  const auto iota = hn::Iota(du, 0), in_row = hn::Set(du, static_cast<uint32_t>(kTile - 1));
  for (size_t r = 0; r < count; ++r) {
    const PixelRun run = runs[r];
    const auto masks = hn::Set(du, run.mask);
    for (uint32_t first = run.begin, end; first < run.end; first = end) {
      end = std::min<uint32_t>(run.end, next_row(first));
      const auto tops = hn::Set(d, top + static_cast<float>(static_cast<int32_t>(first / kTile)));
      auto pixels = hn::Set(du, first) + iota;
      const size_t end_row = at + (end - first);
      for (; at < end_row; at += hn::Lanes(d)) {
        hn::StoreU(pixels, du, pixel + at);
        hn::StoreU(masks, du, mask + at);
        hn::StoreU(triangles, du, index + at);
        hn::StoreU(lefts + hn::ConvertTo(d, hn::BitCast(di, hn::And(pixels, in_row))), d, x + at);
        hn::StoreU(tops, d, y + at);
        pixels = pixels + lanes;
      }
      at = end_row;
    }
  }
  f.count = at;
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(AppendRows);

void append_rows(const core::SimdTarget& simd, const PixelRun* runs, size_t count, uint32_t triangle, Fragments* f) {
  SHD_DISPATCH(AppendRows, simd)(runs, count, triangle, *f);
}

}  // namespace shd::raster
#endif  // HWY_ONCE
