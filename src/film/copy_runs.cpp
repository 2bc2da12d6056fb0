// SPDX-License-Identifier: MIT
#include "film/copy_runs.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "film/copy_runs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::film::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Four columns, or the same pixels of four planes.
template <class T>
struct Four {
  T *a, *b, *c, *d;

  HWY_INLINE Four From(size_t i) const { return {a + i, b + i, c + i, d + i}; }
};

template <class D>
HWY_INLINE void CopyVector(D d, const Four<const float>& from, size_t i, const Four<float>& to) {
  hn::StoreU(hn::LoadU(d, from.a + i), d, to.a + i);
  hn::StoreU(hn::LoadU(d, from.b + i), d, to.b + i);
  hn::StoreU(hn::LoadU(d, from.c + i), d, to.c + i);
  hn::StoreU(hn::LoadU(d, from.d + i), d, to.d + i);
}

/// Copies at least one vector of elements; the last vector may overlap the vector before it.
template <class D>
HWY_INLINE void CopyVectors(D d, const Four<const float>& from, size_t count, const Four<float>& to) {
  const size_t last = count - hn::Lanes(d);
  for (size_t i = 0; i < last; i += hn::Lanes(d)) CopyVector(d, from, i, to);
  CopyVector(d, from, last, to);
}

HWY_INLINE void Copy(const Four<const float>& from, size_t count, const Four<float>& to) {
  const hn::CappedTag<float, 8> eight;
  const hn::CappedTag<float, 4> four;
  if (count >= hn::Lanes(eight)) return CopyVectors(eight, from, count, to);
  if (count >= hn::Lanes(four)) return CopyVectors(four, from, count, to);
  for (size_t i = 0; i < count; ++i) CopyVector(hn::CappedTag<float, 1>(), from, i, to);
}

void CopyRuns(const raster::PixelRun* runs, size_t count, const float* const* column, const TilePlanes& planes) {
  Four<const float> from = {column[0], column[1], column[2], column[3]};
  const Four<float> to = {planes.plane[0], planes.plane[1], planes.plane[2], planes.plane[3]};
  const size_t stride = planes.stride;
  for (size_t r = 0; r < count; ++r) {
    const raster::PixelRun run = runs[r];
    for (uint32_t first = run.begin, end; first < run.end; first = end) {
      end = std::min<uint32_t>(run.end, raster::next_row(first));
      Copy(from, end - first, to.From(first / raster::kTile * stride + first % raster::kTile));
      from = from.From(end - first);
    }
  }
}

}  // namespace shd::film::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::film {

HWY_EXPORT(CopyRuns);

void copy_runs(const core::SimdTarget& simd, const raster::PixelRun* runs, size_t count, const float* const column[4],
               const TilePlanes& planes) {
  SHD_DISPATCH(CopyRuns, simd)(runs, count, column, planes);
}

}  // namespace shd::film
#endif  // HWY_ONCE
