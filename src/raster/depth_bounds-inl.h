// SPDX-License-Identifier: MIT
// Hierarchical depth: finds triangles that fail the depth test in every block of a tile.
#if defined(SHD_RASTER_DEPTH_BOUNDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_DEPTH_BOUNDS_INL_H_
#undef SHD_RASTER_DEPTH_BOUNDS_INL_H_
#else
#define SHD_RASTER_DEPTH_BOUNDS_INL_H_
#endif

#include <algorithm>

#include <hwy/highway.h>

#include "geometry/assemble.h"
#include "raster/depth_test.h"
#include "raster/tile.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Direction in which a depth test that writes moves the stored depths.
constexpr DepthTrend trend_of(const DepthTest& test) {
  if (test.less == test.greater) return DepthTrend::kUnknown;
  return test.less ? DepthTrend::kFalling : DepthTrend::kRising;
}

/// The blocks of a tile that a box of its pixels touches.
struct BlockBox {
  HWY_INLINE explicit BlockBox(const geometry::PixelBox& box)
      : first_x(box.min_x >> kBlockBits),
        first_y(box.min_y >> kBlockBits),
        last_x(box.max_x >> kBlockBits),
        last_y(box.max_y >> kBlockBits) {}
  int32_t first_x, first_y, last_x, last_y;
};

/// The bounds of a tile while triangles of one depth test are drawn.
class Bounds {
 public:
  HWY_INLINE Bounds(DepthTrend trend, bool writes, Tile& tile) : trend_(trend), tile_(tile), bounds_(tile.bounds) {
    if (trend == DepthTrend::kUnknown) {
      if (writes) forget_bounds(&tile);
    } else if (bounds_.trend != trend) {
      bounds_.trend = trend;
      for (float& bound : bounds_.bound) bound = trend == DepthTrend::kFalling ? 2.0f : -1.0f;  // beyond all depths
    }
  }

  /// Whether some depth of a triangle may pass in one of the blocks.
  HWY_INLINE bool MayPass(const BlockBox& box, const geometry::ScreenTriangle& triangle) {
    if (trend_ == DepthTrend::kUnknown) return true;
    return trend_ == DepthTrend::kFalling ? MayPassIn<true>(box, triangle) : MayPassIn<false>(box, triangle);
  }

 private:
  template <bool kFalling>
  HWY_NOINLINE bool MayPassIn(const BlockBox& box, const geometry::ScreenTriangle& triangle) {
    const float nearest = kFalling ? std::min({triangle.z[0], triangle.z[1], triangle.z[2]})
                                   : std::max({triangle.z[0], triangle.z[1], triangle.z[2]});
    for (int32_t y = box.first_y; y <= box.last_y; ++y) {
      for (int32_t x = box.first_x; x <= box.last_x; ++x) {
        float& bound = bounds_.bound[y * kBlocksPerRow + x];
        if (!MayPassBound<kFalling>(nearest, bound)) continue;
        bound = FarthestOf<kFalling>(x, y);
        if (MayPassBound<kFalling>(nearest, bound)) return true;
      }
    }
    return false;
  }

  /// Includes equality, because equal depths pass some comparisons.
  template <bool kFalling>
  static HWY_INLINE bool MayPassBound(float z, float bound) {
    return kFalling ? z <= bound : z >= bound;
  }

  template <bool kFalling>
  HWY_INLINE float FarthestOf(int32_t x, int32_t y) const {
    const hn::CappedTag<float, kBlock> d;
    const size_t samples = tile_.samples;
    auto farthest = hn::Set(d, kFalling ? 0.0f : 1.0f);
    for (size_t row = 0; row < kBlock; ++row) {
      const size_t pixel = (static_cast<size_t>(y) * kBlock + row) * kTile + static_cast<size_t>(x) * kBlock;
      const float* depth = tile_.depth.data() + pixel * samples;
      for (size_t i = 0; i < kBlock * samples; i += hn::Lanes(d)) {
        farthest = kFalling ? hn::Max(farthest, hn::Load(d, depth + i)) : hn::Min(farthest, hn::Load(d, depth + i));
      }
    }
    return hn::GetLane(kFalling ? hn::MaxOfLanes(d, farthest) : hn::MinOfLanes(d, farthest));
  }

  const DepthTrend trend_;
  const Tile& tile_;
  DepthBounds& bounds_;
};

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
