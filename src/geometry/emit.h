// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/assemble.h"

namespace shd::geometry {

/// Outcome of a triangle. Ordered: the outcome of a clipped triangle is the highest one of its pieces. kUnseen: the
/// triangle lies outside the visible pixels.
enum class TriangleOutcome { kUnseen, kCulled, kEmpty, kRasterised };

/// Twice the signed area of a triangle on the pixel grid; positive if it is clockwise on the screen.
inline int64_t twice_area(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  return (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) - (int64_t{c.x} - a.x) * (int64_t{b.y} - a.y);
}

/// Appends the triangle unless it is culled, covers no sample or lies outside the visible pixels.
inline TriangleOutcome emit(const Assembly& assembly, const ScreenVertex& a, const ScreenVertex& b,
                            const ScreenVertex& c, uint32_t primitive, core::Buffer<ScreenTriangle>* out) {
  const int64_t area = twice_area(a, b, c);
  // Counter-clockwise with y up is negative with y down.
  if (area == 0 || (assembly.cull == SHD_CULL_BACK && area > 0) || (assembly.cull == SHD_CULL_FRONT && area < 0)) {
    return TriangleOutcome::kCulled;
  }
  const ScreenVertex& second = area > 0 ? b : c;
  const ScreenVertex& third = area > 0 ? c : b;
  const ScreenTriangle triangle = {
      {a.x, second.x, third.x}, {a.y, second.y, third.y}, {a.z, second.z, third.z}, assembly.draw, primitive, 0};
  const PixelBox box = pixel_box(triangle, assembly.samples);
  if (is_empty(box)) return TriangleOutcome::kEmpty;
  if (is_empty(intersection(box, assembly.visible))) return TriangleOutcome::kUnseen;
  out->push_back(triangle);
  return TriangleOutcome::kRasterised;
}

inline void count(TriangleOutcome outcome, shd_render_stats* stats) {
  stats->outside_triangle_count += outcome == TriangleOutcome::kUnseen;
  stats->culled_triangle_count += outcome == TriangleOutcome::kCulled;
  stats->empty_triangle_count += outcome == TriangleOutcome::kEmpty;
  stats->rasterized_triangle_count += outcome == TriangleOutcome::kRasterised;
}

}  // namespace shd::geometry
