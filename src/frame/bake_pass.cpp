// SPDX-License-Identifier: MIT
#include "frame/bake_pass.h"

#include <algorithm>

#include "film/aovs.h"
#include "film/dilate.h"
#include "frame/bake.h"
#include "frame/fragment_batch.h"
#include "raster/tile_words.h"

namespace shd::frame {
namespace {

static_assert(static_cast<uint8_t>(raster::TexelCover::kCentre) == film::kTexelCentre &&
                  static_cast<uint8_t>(raster::TexelCover::kTouched) == film::kTexelTouched,
              "states of texels have one numbering");

/// Finds the triangle of each texel.
void find_triangles(TileState* tile) {
  Worker& worker = tile->worker;
  raster::NearestTriangles& nearest = worker.nearest[0];
  const geometry::PixelBox box = tile->box();
  raster::clear(&nearest);
  tile->for_each_run([&](const Run& run) {
    for (size_t i = 0; i < run.count; ++i) {
      const geometry::ScreenTriangle& triangle = run.triangles[run.entries[i]];
      raster::add_triangle(triangle, static_cast<uint32_t>(worker.slots.size()), tile->left, tile->top, box, &nearest);
      worker.slots.push_back(&triangle);
    }
  });
  std::copy_n(nearest.slot, raster::kTilePixels, worker.tile.slot.data());
}

/// Whether the alpha test and the program keep a row.
bool is_kept(const material::Material& material, const shade::Columns& columns, size_t row) {
  if (material.flags & SHD_MATERIAL_DISCARDS && columns.discard[row]) return false;
  return !(material.alpha_cutoff > 0.0f && columns.radiance.channel[3][row] < material.alpha_cutoff);
}

void write_texels(const Draw& draw, TileState* tile) {
  Worker& worker = tile->worker;
  const raster::Fragments& f = worker.workspace.fragments;
  const shade::Columns& columns = worker.workspace.columns;
  const raster::NearestTriangles& nearest = worker.nearest[0];
  worker.nonfinite_fragments += worker.workspace.nonfinite;
  worker.aovs.row_count = 0;
  for (size_t i = 0; i < f.count; ++i) {
    if (!is_kept(*draw.material, columns, i)) continue;
    const uint32_t pixel = f.pixel[i];
    const raster::PixelRun run = {static_cast<uint16_t>(pixel), static_cast<uint16_t>(pixel + 1), f.mask[i]};
    tile->color.write_runs(tile->simd(), &run, 1, columns.radiance, i);
    worker.aovs.row[worker.aovs.row_count++] = static_cast<uint16_t>(i);
    const size_t x = tile->area.left + pixel % raster::kTile, y = tile->area.top + size_t{pixel / raster::kTile};
    const uint8_t shared = nearest.is_shared[pixel] ? film::kTexelShared : 0;
    tile->renderer.frame.bake->texels[y * tile->framebuffer.width + x] =
        static_cast<uint8_t>(static_cast<uint8_t>(nearest.cover[pixel]) | shared);
  }
  if (!tile->framebuffer.aovs) return;
  film::write_aovs(tile->simd(), tile->area, {*draw.material, draw.object_to_world, draw.index}, f, columns.uv,
                   &worker.aovs, &tile->framebuffer);
}

}  // namespace

void bake_tile(TileState* tile) {
  Worker& worker = tile->worker;
  find_triangles(tile);
  raster::sort_pixels(tile->simd(), worker.tile, worker.slots.size(), &worker.order);
  tile->clear_color();
  FragmentBatch batch(*tile);
  const auto done = [&](const Draw& draw) { write_texels(draw, tile); };
  uint32_t draw = 0;
  for (size_t slot = 0; slot < worker.slots.size(); ++slot) {
    const raster::PixelRun* const runs = worker.order.run.data() + worker.order.start[slot];
    const size_t count = worker.order.start[slot + 1] - worker.order.start[slot];
    if (count == 0) continue;
    const geometry::ScreenTriangle& triangle = *worker.slots[slot];
    if (triangle.draw != draw) batch.flush(draw, done);
    draw = triangle.draw;
    batch.add(triangle, runs, count, done);
  }
  batch.flush(draw, done);
  worker.slots.clear();
  raster::clear_slots(tile->simd(), &worker.tile);
}

}  // namespace shd::frame
