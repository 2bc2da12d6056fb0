// SPDX-License-Identifier: MIT
#include "frame/tile_renderer.h"

#include "film/stream_rows.h"
#include "frame/bake_pass.h"
#include "frame/blended_pass.h"
#include "frame/opaque_pass.h"
#include "frame/present.h"
#include "frame/tile_state.h"
#include "frame/unordered_pass.h"
#include "frame/volume_pass.h"
#include "raster/tile_words.h"

namespace shd::frame {
namespace {

/// The part of a tile inside the scissor; may be empty.
film::TileArea cleared_area(const TileState& tile) {
  const geometry::PixelBox whole = geometry::pixel_rectangle(tile.left, tile.top, tile.area.width, tile.area.height);
  const geometry::PixelBox box = geometry::intersection(whole, tile.renderer.frame.scissor);
  if (geometry::is_empty(box)) return {0, 0, 0, 0};
  return {tile.area.left + static_cast<uint32_t>(box.min_x - tile.left),
          tile.area.top + static_cast<uint32_t>(box.min_y - tile.top), static_cast<uint32_t>(box.max_x - box.min_x + 1),
          static_cast<uint32_t>(box.max_y - box.min_y + 1)};
}

/// Initialises depth and colours of a tile before its first draw. Returns false if no draw touches it.
bool begin(TileState* tile) {
  const Frame& frame = tile->renderer.frame;
  Worker& worker = tile->worker;
  const film::TileArea cleared = frame.load ? film::TileArea{0, 0, 0, 0} : cleared_area(*tile);
  const bool is_whole = cleared.width == tile->area.width && cleared.height == tile->area.height;
  const bool is_bare = tile->is_bare();
  film::clear_aovs(cleared, &tile->framebuffer);
  tile->color_is_unclear = is_whole && !is_bare;
  const bool needs_color = !is_bare || tile->renderer.present;
  if (!is_whole && needs_color) film::load_color(tile->area, tile->framebuffer, tile->color_planes);
  if (!tile->color_is_unclear) tile->fill(cleared);
  if (!is_whole || is_bare) film::clear_depth(cleared, frame.clear_depth, &tile->framebuffer);
  if (is_bare) {
    film::store_color(tile->simd(), tile->area, cleared, tile->color_planes, &tile->framebuffer);
    return false;
  }
  raster::forget_bounds(&worker.tile);
  worker.slots.clear();
  const film::SampleStore* samples = tile->renderer.samples;
  if (samples && samples->load(tile->index, &worker.tile, &worker.split)) return true;
  if (is_whole) {
    raster::fill_depth(tile->simd(), frame.clear_depth, &worker.tile);
  } else {
    film::load_depth(tile->area, tile->framebuffer, &worker.tile);
  }
  tile->color.load();
  return true;
}

/// The kinds of order-independent blends in a tile.
struct Unfinished {
  bool weighted, sorted;
};

/// Draws everything that takes effect in order. Returns the blends that remain to be drawn.
Unfinished draw_in_order(TileState* tile) {
  Unfinished unfinished = {false, false};
  tile->for_each_run([&](const Run& run) {
    const material::Material* material = tile->draw_of(run).material;
    if (material && material::is_unordered(*material)) {
      (material->blend == SHD_BLEND_WEIGHTED ? unfinished.weighted : unfinished.sorted) = true;
    } else if (!material || is_plain(*material)) {
      cover_run(tile, run);
    } else {
      shade_visible(tile);
      tile->clear_color();
      blend_run(tile, run);
    }
  });
  shade_visible(tile);
  return unfinished;
}

/// Draws a tile that begin() has initialised.
void draw(TileState* tile) {
  Unfinished unfinished = {false, false};
  if (tile->renderer.frame.bake) {
    bake_tile(tile);
  } else {
    unfinished = draw_in_order(tile);
  }
  tile->clear_color();
  if (unfinished.weighted) draw_weighted(tile);
  if (unfinished.sorted) draw_sorted(tile);
  if (tile->renderer.frame.volume_count > 0) draw_volumes(tile);
  tile->color.resolve();
  if (!tile->color_is_stored) {
    film::store_color(tile->simd(), tile->area, tile->area, tile->color_planes, &tile->framebuffer);
  }
  film::store_depth(tile->simd(), tile->area, tile->worker.tile, &tile->framebuffer);
  film::SampleStore* samples = tile->renderer.samples;
  if (samples) samples->save(tile->index, tile->worker.tile, tile->worker.split);
}

}  // namespace

void TileRenderer::render(uint32_t index, Worker* worker) const {
  TileState tile(*this, index, worker);
  if (begin(&tile)) draw(&tile);
  film::finish_streams();
  if (present) present_tile(*present, tile.area, tile.color_planes, worker->index);
}

}  // namespace shd::frame
