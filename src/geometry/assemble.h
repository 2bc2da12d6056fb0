// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include <shd/render.h>

#include "core/allocator.h"
#include "geometry/feature_edges.h"
#include "geometry/mesh.h"
#include "geometry/pixel_box.h"
#include "geometry/vertex.h"

namespace shd::geometry {

/// A triangle ready for coverage: on the pixel grid, inside the guard band, with non-zero area, and turned so that
/// (x1-x0)(y2-y0) - (x2-x0)(y1-y0) > 0 in raster space (y down). Halves of outlines reach up to 32 pixels beyond the
/// guard band. A clipped or outlined triangle becomes several ScreenTriangles with the same primitive. The layout is
/// rows, not columns: the tile that contains a triangle reads it once.
struct ScreenTriangle {
  int32_t x[3], y[3];  // fixed point
  float z[3];          // depth, 0..1
  uint32_t draw;       // index into the frame's draws
  uint32_t primitive;  // index of the triangle in its mesh
  uint32_t reserved;
};

/// Bounds of the sample positions in a pixel, in 1 / kSubpixels from its top left corner, ends included.
struct SampleExtent {
  int32_t min_x, max_x, min_y, max_y;
};

/// The part of its triangles that a draw shows: interior, edges or vertices.
struct Outline {
  shd_fill fill;
  int32_t reach;       // half the width of lines and points, fixed point, > 0
  uint32_t edges = 0;  // for SHD_FILL_LINES: shd_edge bits
  float crease_cosine = 0.0f;
};
inline int32_t outline_reach(float width) {
  return static_cast<int32_t>(width * (kSubpixels / 2) + 0.5f);
}

/// Parameters of assemble(), which culls, clips and counts triangles [begin, end) of a draw and appends those that can
/// be visible in a box of pixels. assemble() throws std::bad_alloc.
struct Assembly {
  const Vertices* vertices;
  uint32_t draw;
  shd_cull cull;
  PixelBox visible;
  SampleExtent samples;
  Outline outline = {SHD_FILL_SOLID, 0, 0, 0.0f};
  const Mesh* mesh = nullptr;  // for SHD_FILL_LINES: the owner of the edges
  EdgeQuery query = {};
};
void assemble(const Assembly& assembly, size_t begin, size_t end, core::Buffer<ScreenTriangle>* out,
              shd_render_stats* stats);

/// A box on the pixel grid, fixed point, ends included.
struct GridBox {
  int32_t min_x, min_y, max_x, max_y;
};

/// Pixels with samples that may lie inside a box.
inline PixelBox pixel_box(const GridBox& box, const SampleExtent& samples) {
  const int32_t up = kSubpixels - 1;
  return {(box.min_x - samples.max_x + up) >> kSubpixelBits, (box.min_y - samples.max_y + up) >> kSubpixelBits,
          (box.max_x - samples.min_x) >> kSubpixelBits, (box.max_y - samples.min_y) >> kSubpixelBits};
}

/// Pixels with samples that may lie inside the bounding box of a triangle.
inline PixelBox pixel_box(const ScreenTriangle& t, const SampleExtent& samples) {
  const GridBox bounds = {std::min({t.x[0], t.x[1], t.x[2]}), std::min({t.y[0], t.y[1], t.y[2]}),
                          std::max({t.x[0], t.x[1], t.x[2]}), std::max({t.y[0], t.y[1], t.y[2]})};
  return pixel_box(bounds, samples);
}

}  // namespace shd::geometry
