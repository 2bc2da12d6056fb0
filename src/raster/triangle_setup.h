// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geometry/assemble.h"
#include "raster/depth_test.h"
#include "raster/edge.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace shd::raster {

/// The tile that triangles are drawn into.
struct CoverArea {
  const SamplePattern& pattern;
  int32_t left, top;       // pixel position of the tile in the picture
  geometry::PixelBox box;  // pixels of the picture that may change, within the tile
};

/// Whether some columns of the tile must not change.
inline bool is_clipped(const CoverArea& area) {
  return area.box.max_x - area.box.min_x != kTile - 1;
}

/// Pixels of the tile that a triangle may touch.
inline geometry::PixelBox box_in_tile(const geometry::ScreenTriangle& triangle, const CoverArea& area) {
  const geometry::PixelBox box = geometry::intersection(geometry::pixel_box(triangle, area.pattern.extent), area.box);
  return {box.min_x - area.left, box.min_y - area.top, box.max_x - area.left, box.max_y - area.top};
}

/// A triangle over a tile.
struct TriangleSetup {
  const SamplePattern* pattern;
  EdgeLine line[3];  // 0 where all samples of the tile are inside
  DepthSlope slope;
  geometry::PixelBox box;  // pixels of the tile that the triangle may touch, not empty
  int32_t left, top;       // position of the tile in the picture
  bool is_narrow;          // whether the edge functions fit int32 all over the tile
};

/// Whether a triangle covers all samples of the tile.
inline bool covers_tile(const TriangleSetup& t) {
  const auto is_inside = [&](const EdgeLine& line) { return line.value == 0 && line.a == 0 && line.b == 0; };
  return t.box.max_x - t.box.min_x == kTile - 1 && t.box.max_y - t.box.min_y == kTile - 1 && is_inside(t.line[0]) &&
         is_inside(t.line[1]) && is_inside(t.line[2]);
}

/// Prepares a triangle for the pixels of its box_in_tile(), which is not empty. Returns false if it covers no sample
/// there. Not inline: compiled into the AVX2 kernels by GCC 12, a triangle of one pixel took 142 ns instead of 28 ns
/// (Ice Lake).
bool set_up(const geometry::ScreenTriangle& triangle, const CoverArea& area, const DepthState& state,
            const geometry::PixelBox& box, TriangleSetup* out);

}  // namespace shd::raster
