// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/context.h"
#include "geometry/pixel_box.h"
#include "raster/sort_triangle.h"

namespace shd::raster {

/// Triangles of a frame and the order in which they are painted.
struct Painting {
  core::Buffer<SortTriangle> triangles;
  core::Buffer<uint32_t> order;  // indices into triangles, far to near
  uint64_t cuts = 0;
};

/// Pixels that count, and where in them their samples lie.
struct PaintArea {
  geometry::PixelBox pixels;
  geometry::SampleExtent samples;
};

/// Puts triangles right that come sorted by their farthest vertex, far ones first (M. E. Newell, R. G. Newell and
/// Sancha, "A Solution to the Hidden Surface Problem", 1972): before a triangle is painted, each one that may not
/// follow it goes first; two that pass through each other, and those that go round in a circle, are cut along the plane
/// of another. Fills `order`; adds pieces to `triangles`, but for those without a sample.
///
/// Bounds: n + 1024 cuts of n triangles, and 1024 n + 2^22 comparisons; what is left then stays in the order that it
/// has. Up to there, what may remain wrong is a circle none of whose members can be cut: pieces would have no area on
/// the pixel grid. Throws.
void newell(const core::Context& context, const PaintArea& area, Painting* painting);

}  // namespace shd::raster
