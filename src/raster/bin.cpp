// SPDX-License-Identifier: MIT
#include "raster/bin.h"

#include "core/executor.h"
#include "raster/tile.h"

namespace shd::raster {
namespace {

/// Calls visit(tile) for every tile that the bounding box of the triangle touches.
template <class Visit>
void for_tiles(const geometry::ScreenTriangle& triangle, const geometry::SampleExtent& samples,
               const geometry::PixelBox& window, const geometry::PixelBox& visible, uint32_t tiles_x, Visit visit) {
  const geometry::PixelBox box = geometry::intersection(geometry::pixel_box(triangle, samples), visible);
  for (int32_t y = (box.min_y - window.min_y) >> kTileBits; y <= (box.max_y - window.min_y) >> kTileBits; ++y) {
    for (int32_t x = (box.min_x - window.min_x) >> kTileBits; x <= (box.max_x - window.min_x) >> kTileBits; ++x) {
      visit(static_cast<size_t>(y) * tiles_x + static_cast<size_t>(x));
    }
  }
}

}  // namespace

void bin_triangles(const core::Context& context, const TriangleGroup* groups, uint32_t group_count,
                   const geometry::PixelBox& window, const geometry::PixelBox& visible,
                   const geometry::SampleExtent& samples, Bins* out) {
  out->tiles_x = tile_count(static_cast<uint32_t>(window.max_x - window.min_x + 1));
  out->tiles_y = tile_count(static_cast<uint32_t>(window.max_y - window.min_y + 1));
  out->group_count = group_count;
  const size_t tiles = size_t{out->tiles_x} * out->tiles_y;
  const size_t cells = core::checked_mul(tiles, group_count);
  out->start = core::Array<size_t>(context.allocator, cells + 1);
  out->start.fill_zero();
  size_t* start = out->start.data();

  core::parallel_for(context, group_count, [&](uint32_t g, uint32_t) {
    for (size_t i = 0; i < groups[g].size(); ++i) {
      for_tiles(groups[g][i], samples, window, visible, out->tiles_x,
                [&](size_t tile) { ++start[tile * group_count + g]; });
    }
  });

  size_t total = 0;
  for (size_t cell = 0; cell <= cells; ++cell) {
    const size_t count = start[cell];
    start[cell] = total;
    total += count;
  }
  out->entries = core::Array<uint32_t>(context.allocator, total);
  core::Array<size_t> cursor(context.allocator, cells);
  for (size_t cell = 0; cell < cells; ++cell) cursor[cell] = start[cell];

  core::parallel_for(context, group_count, [&](uint32_t g, uint32_t) {
    for (size_t i = 0; i < groups[g].size(); ++i) {
      for_tiles(groups[g][i], samples, window, visible, out->tiles_x,
                [&](size_t tile) { out->entries[cursor[tile * group_count + g]++] = static_cast<uint32_t>(i); });
    }
  });
}

}  // namespace shd::raster
