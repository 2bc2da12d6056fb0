// SPDX-License-Identifier: MIT
// Rows of one triangle in a table of fragments.

#if defined(SHD_RASTER_SPANS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_SPANS_INL_H_
#undef SHD_RASTER_SPANS_INL_H_
#else
#define SHD_RASTER_SPANS_INL_H_
#endif

#include <algorithm>

#include <hwy/highway.h>

#include "raster/fragments.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns the first row after `begin` whose triangle is another one, or `end`, which is at most kBatch.
HWY_INLINE size_t EndOfTriangle(const uint32_t* triangle, size_t begin, size_t end) {
  const hn::ScalableTag<uint32_t> d;
  static_assert(hn::MaxLanes(d) <= kColumn - kBatch, "the last vector must lie in the column");
  const auto first = hn::Set(d, triangle[begin]);
  for (size_t i = begin + 1; i < end; i += hn::Lanes(d)) {
    const intptr_t other = hn::FindFirstTrue(d, hn::Ne(hn::LoadU(d, triangle + i), first));
    if (other >= 0) return std::min(end, i + static_cast<size_t>(other));
  }
  return end;
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_RASTER_SPANS_INL_H_
