// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/context.h"
#include "geometry/assemble.h"

namespace shd::raster {

/// Triangles of a part of a frame; groups follow each other in submission order.
using TriangleGroup = core::Buffer<geometry::ScreenTriangle>;

/// For each tile, the triangles whose bounding box touches it, in submission order.
struct Bins {
  uint32_t tiles_x, tiles_y;
  uint32_t group_count;
  core::Array<size_t> start;      // [tile][group] first entry, and one more at the end
  core::Array<uint32_t> entries;  // index of the triangle in its group
};

/// Sorts every triangle into the tiles of a window of the picture, with the groups in parallel. Throws Failure and
/// std::bad_alloc.
/// @param visible  pixels of the window that triangles may change
void bin_triangles(const core::Context& context, const TriangleGroup* groups, uint32_t group_count,
                   const geometry::PixelBox& window, const geometry::PixelBox& visible,
                   const geometry::SampleExtent& samples, Bins* out);

/// Triangles of one tile in one group.
struct BinSegment {
  const uint32_t* entries;
  size_t count;
};
inline BinSegment segment(const Bins& bins, uint32_t tile, uint32_t group) {
  const size_t* start = &bins.start[size_t{tile} * bins.group_count + group];
  return {bins.entries.data() + start[0], start[1] - start[0]};
}

}  // namespace shd::raster
