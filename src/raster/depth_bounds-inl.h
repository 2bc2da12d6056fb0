// SPDX-License-Identifier: MIT
// Hierarchical depth: triangles that no block of a tile lets pass.
#if defined(SHD_RASTER_DEPTH_BOUNDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_DEPTH_BOUNDS_INL_H_
#undef SHD_RASTER_DEPTH_BOUNDS_INL_H_
#else
#define SHD_RASTER_DEPTH_BOUNDS_INL_H_
#endif

#include <algorithm>

#include <shd/render.h>

#include <hwy/highway.h>

#include "geometry/assemble.h"
#include "raster/tile.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Whether a comparison lets pass what is smaller, or larger, alone.
constexpr DepthTrend trend_of(shd_compare compare) {
  switch (compare) {
    case SHD_COMPARE_LESS:
    case SHD_COMPARE_LESS_EQUAL: return DepthTrend::kFalling;
    case SHD_COMPARE_GREATER:
    case SHD_COMPARE_GREATER_EQUAL: return DepthTrend::kRising;
    default: return DepthTrend::kUnknown;
  }
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

/// The bounds of a tile for one trend.
template <DepthTrend kTrend>
class Bounds {
 public:
  static constexpr bool kFalling = kTrend == DepthTrend::kFalling;

  HWY_INLINE explicit Bounds(Tile& tile) : tile_(tile), bounds_(tile.bounds) {
    if (bounds_.trend == kTrend) return;
    bounds_.trend = kTrend;
    for (float& bound : bounds_.bound) bound = kFalling ? 2.0f : -1.0f;  // beyond all depths
  }

  /// Whether some depth of a triangle may pass in one of the blocks.
  HWY_NOINLINE bool MayPass(const BlockBox& box, const geometry::ScreenTriangle& triangle) {
    const float nearest = kFalling ? std::min({triangle.z[0], triangle.z[1], triangle.z[2]})
                                   : std::max({triangle.z[0], triangle.z[1], triangle.z[2]});
    for (int32_t y = box.first_y; y <= box.last_y; ++y) {
      for (int32_t x = box.first_x; x <= box.last_x; ++x) {
        float& bound = bounds_.bound[y * kBlocksPerRow + x];
        if (!MayPassBound(nearest, bound)) continue;
        bound = FarthestOf(x, y);
        if (MayPassBound(nearest, bound)) return true;
      }
    }
    return false;
  }

 private:
  /// Equal depths may pass some comparisons.
  static HWY_INLINE bool MayPassBound(float z, float bound) { return kFalling ? z <= bound : z >= bound; }

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

  const Tile& tile_;
  DepthBounds& bounds_;
};

/// Without bounds.
template <>
class Bounds<DepthTrend::kUnknown> {
 public:
  HWY_INLINE explicit Bounds(Tile&) {}
  HWY_INLINE bool MayPass(const BlockBox&, const geometry::ScreenTriangle&) { return true; }
};

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
