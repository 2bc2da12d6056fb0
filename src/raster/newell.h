// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/context.h"
#include "geometry/pixel_box.h"
#include "raster/sort_triangle.h"

namespace shd::raster {

/// The triangles of a frame and their order of painting.
struct Painting {
  core::Buffer<SortTriangle> triangles;
  core::Buffer<uint32_t> order;  // indices into triangles, far to near
  uint64_t cuts = 0;
};

/// The visible pixels, and the bounds of the sample positions in a pixel.
struct PaintArea {
  geometry::PixelBox pixels;
  geometry::SampleExtent samples;
};

/// The order of M. E. Newell, R. G. Newell and Sancha, "A Solution to the Hidden Surface Problem" (1972). The triangles
/// must be sorted by their farthest vertex, far ones first. Before a triangle is painted, each triangle that may not
/// follow it is painted. If two triangles intersect, or triangles form a cycle, one of them is cut along the plane of
/// another. Fills `order`; appends pieces that have a sample to `triangles`.
///
/// Bounds: n + 1024 cuts and 1024 n + 2^22 comparisons for n triangles; beyond them the remaining triangles keep their
/// order. Within these bounds a cycle stays unresolved only if none of its members can be cut, because a piece would
/// have no area on the pixel grid. Throws std::bad_alloc.
void newell(const core::Context& context, const PaintArea& area, Painting* painting);

}  // namespace shd::raster
