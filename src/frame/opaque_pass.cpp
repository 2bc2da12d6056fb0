// SPDX-License-Identifier: MIT
#include "frame/opaque_pass.h"

#include "film/aovs.h"
#include "frame/fragment_batch.h"
#include "frame/texture_batch.h"
#include "raster/tile_words.h"

namespace shd::frame {
namespace {

/// Draws one triangle of a run into the visibility buffer; counts overdraw and hidden samples from its mask.
void cover_counted(TileState* tile, const Draw& draw, const Run& run, size_t i, uint32_t slot) {
  Worker& worker = tile->worker;
  const raster::CoverArea area = tile->cover_area(tile->box());
  const geometry::ScreenTriangle& triangle = run.triangles[run.entries[i]];
  raster::cover_mask(tile->simd(), area, draw.depth, triangle, worker.tile, &worker.mask);
  const uint64_t passed = tile->count_masked();
  if (draw.material && tile->framebuffer.aovs & SHD_AOV_OVERDRAW) {
    tile->for_each_masked([&](uint32_t pixel, uint32_t mask) {
      if (mask & 1) film::count_overdraw(tile->area, pixel, &tile->framebuffer);
    });
  }
  tile->count_hidden(area, triangle, passed);
  raster::cover(tile->simd(), area, draw.depth, run.triangles, run.entries + i, 1, slot, &worker.tile);
}

/// Writes the colours of a shaded batch to its samples.
void write_colors(const BatchRuns& runs, const shade::Radiance& radiance, TileState* tile) {
  const uint32_t all_samples = tile->all_samples();
  for (size_t i = 0, row = 0, end; i < runs.count; i = end) {
    size_t rows = 0;
    for (end = i; end < runs.count && runs.run[end].mask == all_samples; ++end)
      rows += raster::length_of(runs.run[end]);
    if (end > i) tile->color.write_runs(tile->simd(), runs.run + i, end - i, radiance, row);
    row += rows;
    for (; end < runs.count && runs.run[end].mask != all_samples; ++end) {
      const raster::PixelRun& run = runs.run[end];
      for (uint32_t p = run.begin; p < run.end; ++p) tile->color.write_some(p, run.mask, radiance, row++);
    }
  }
}

void write_batch(const Draw& draw, TileState* tile) {
  Worker& worker = tile->worker;
  const raster::Fragments& f = worker.workspace.fragments;
  worker.nonfinite_fragments += worker.workspace.nonfinite;
  write_colors(worker.runs, worker.workspace.columns.radiance, tile);
  if (!tile->framebuffer.aovs) return;
  film::find_rows(f, &worker.aovs);
  film::write_aovs(tile->simd(), tile->area, {*draw.material, draw.object_to_world, draw.index}, f,
                   worker.workspace.columns.uv, &worker.aovs, &tile->framebuffer);
}

}  // namespace

void cover_run(TileState* tile, const Run& run) {
  Worker& worker = tile->worker;
  const Draw& draw = tile->draw_of(run);
  auto first_slot = raster::kNoSlot;
  if (draw.material) {
    first_slot = static_cast<uint32_t>(worker.slots.size());
    for (size_t i = 0; i < run.count; ++i) worker.slots.push_back(run.triangles + run.entries[i]);
  }
  const bool counts_overdraw = draw.material && tile->framebuffer.aovs & SHD_AOV_OVERDRAW;
  if (!counts_overdraw && !tile->renderer.frame.counts_hidden) {
    raster::cover(tile->simd(), tile->cover_area(tile->box()), draw.depth, run.triangles, run.entries, run.count,
                  first_slot, &worker.tile);
    return;
  }
  for (size_t i = 0; i < run.count; ++i) {
    const uint32_t slot = draw.material ? first_slot + static_cast<uint32_t>(i) : raster::kNoSlot;
    cover_counted(tile, draw, run, i, slot);
  }
}

void shade_visible(TileState* tile) {
  Worker& worker = tile->worker;
  if (worker.slots.size() == 0) return;
  raster::sort_pixels(tile->simd(), worker.tile, worker.slots.size(), &worker.order);
  const size_t samples = size_t{tile->area.width} * tile->area.height * tile->pattern.count;
  const bool is_overwritten = worker.order.covered_samples == samples;
  const bool has_one_color = is_overwritten || (tile->color_is_unclear && !tile->renderer.background.map);
  FragmentBatch batch(*tile);
  TextureBatch textured(tile);
  tile->color_is_stored = is_overwritten && tile->is_drawn_once() && textured.begin_direct();
  if (is_overwritten) tile->color_is_unclear = false;
  tile->clear_bare(worker.order.bare);
  tile->color.assume(has_one_color ? tile->renderer.frame.clear_color : nullptr);
  const auto done = [&](const Draw& draw) { write_batch(draw, tile); };
  uint32_t draw = 0;
  for (size_t slot = 0; slot < worker.slots.size(); ++slot) {
    raster::PixelRun* const runs = worker.order.run.data() + worker.order.start[slot];
    size_t count = worker.order.start[slot + 1] - worker.order.start[slot];
    if (count == 0) continue;
    const geometry::ScreenTriangle& triangle = *worker.slots[slot];
    count = textured.draw(triangle, runs, count);
    if (count == 0) continue;
    if (triangle.draw != draw) batch.flush(draw, done);
    draw = triangle.draw;
    batch.add(triangle, runs, count, done);
  }
  batch.flush(draw, done);
  tile->color.assume(nullptr);
  worker.slots.clear();
  raster::clear_slots(tile->simd(), &worker.tile);
}

}  // namespace shd::frame
