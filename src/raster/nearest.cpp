// SPDX-License-Identifier: MIT
#include "raster/nearest.h"

#include <algorithm>
#include <cstdlib>

namespace shd::raster {
namespace {

constexpr int64_t kHalf = geometry::kSubpixels / 2;

/// A point in 1/256 pixel, and its squared distance from another point.
struct NearPoint {
  double x, y, distance;
};

/// One edge of a triangle in fixed point. The edge function a x + b y + c is >= 0 inside.
class TriangleEdge {
 public:
  TriangleEdge(const geometry::ScreenTriangle& t, int k)
      : ax_(t.x[k]), ay_(t.y[k]), bx_(t.x[(k + 1) % 3]), by_(t.y[(k + 1) % 3]) {
    a_ = ay_ - by_;
    b_ = bx_ - ax_;
    owns_boundary_ = a_ > 0 || (a_ == 0 && b_ > 0);  // left edge, or top edge
    // Both triangles at a shared edge measure from the same end, so that their distances have the same bits.
    if (bx_ < ax_ || (bx_ == ax_ && by_ < ay_)) {
      std::swap(ax_, bx_);
      std::swap(ay_, by_);
    }
    length_squared_ = static_cast<double>((bx_ - ax_) * (bx_ - ax_) + (by_ - ay_) * (by_ - ay_));
  }

  /// Edge function at a point.
  int64_t at(int64_t x, int64_t y) const { return a_ * (x - ax_) + b_ * (y - ay_); }
  /// Whether a point with this value is covered, by the fill rule.
  bool covers(int64_t value) const { return value > 0 || (value == 0 && owns_boundary_); }
  /// Whether the inside of a texel has points inside the edge; `value` is that of its centre.
  bool reaches(int64_t value) const { return value + kHalf * (std::abs(a_) + std::abs(b_)) > 0; }

  NearPoint nearest(int64_t x, int64_t y) const {
    const double dx = static_cast<double>(bx_ - ax_), dy = static_cast<double>(by_ - ay_);
    const double px = static_cast<double>(x - ax_), py = static_cast<double>(y - ay_);
    const double along = length_squared_ > 0.0 ? (px * dx + py * dy) / length_squared_ : 0.0;
    const double t = std::min(std::max(along, 0.0), 1.0);
    const double rx = t * dx - px, ry = t * dy - py;
    return {static_cast<double>(x) + rx, static_cast<double>(y) + ry, rx * rx + ry * ry};
  }

 private:
  int64_t ax_, ay_, bx_, by_;  // ends
  int64_t a_, b_;
  bool owns_boundary_;
  double length_squared_;
};

/// Offers a triangle that covers the centre of a texel.
void offer_centre(uint32_t slot, size_t at, int64_t x, int64_t y, NearestTriangles* out) {
  if (out->cover[at] == TexelCover::kCentre) {
    out->is_shared[at] = true;
    return;
  }
  out->slot[at] = slot;
  out->cover[at] = TexelCover::kCentre;
  out->distance[at] = 0.0;
  out->x[at] = static_cast<float>(x) / geometry::kSubpixels;
  out->y[at] = static_cast<float>(y) / geometry::kSubpixels;
}

/// Offers a triangle that only touches a texel.
void offer_touch(const NearPoint& point, uint32_t slot, size_t at, NearestTriangles* out) {
  if (out->cover[at] == TexelCover::kCentre) return;
  if (out->cover[at] == TexelCover::kTouched && out->distance[at] <= point.distance) return;
  out->slot[at] = slot;
  out->cover[at] = TexelCover::kTouched;
  out->distance[at] = point.distance;
  out->x[at] = static_cast<float>(point.x / geometry::kSubpixels);
  out->y[at] = static_cast<float>(point.y / geometry::kSubpixels);
}

}  // namespace

void clear(NearestTriangles* out) {
  std::fill_n(out->slot, kTilePixels, kNoSlot);
  std::fill_n(out->cover, kTilePixels, TexelCover::kEmpty);
  std::fill_n(out->is_shared, kTilePixels, false);
}

void add_triangle(const geometry::ScreenTriangle& triangle, uint32_t slot, int32_t left, int32_t top,
                  const geometry::PixelBox& box, NearestTriangles* out) {
  const geometry::PixelBox reach = geometry::intersection(geometry::pixel_box(triangle, kTouchExtent), box);
  if (geometry::is_empty(reach)) return;
  const TriangleEdge edges[3] = {TriangleEdge(triangle, 0), TriangleEdge(triangle, 1), TriangleEdge(triangle, 2)};
  for (int32_t row = reach.min_y; row <= reach.max_y; ++row) {
    for (int32_t column = reach.min_x; column <= reach.max_x; ++column) {
      const int64_t x = int64_t{column} * geometry::kSubpixels + kHalf;
      const int64_t y = int64_t{row} * geometry::kSubpixels + kHalf;
      bool covers = true, contains = true, touches = true;
      for (const TriangleEdge& edge : edges) {
        const int64_t value = edge.at(x, y);
        covers &= edge.covers(value);
        contains &= value >= 0;
        touches &= edge.reaches(value);
      }
      if (!touches) continue;
      const auto at = static_cast<size_t>(row - top) * kTile + static_cast<size_t>(column - left);
      if (covers) {
        offer_centre(slot, at, x, y, out);
        continue;
      }
      NearPoint best = {static_cast<double>(x), static_cast<double>(y), 0.0};
      if (!contains) {
        best = edges[0].nearest(x, y);
        for (int k = 1; k < 3; ++k) {
          const NearPoint other = edges[k].nearest(x, y);
          if (other.distance < best.distance) best = other;
        }
      }
      offer_touch(best, slot, at, out);
    }
  }
}

}  // namespace shd::raster
