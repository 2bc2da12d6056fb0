// SPDX-License-Identifier: MIT
#include "film/tile_renderer.h"

#include "film/blended_pass.h"
#include "film/opaque_pass.h"
#include "film/tile_state.h"
#include "film/unordered_pass.h"

namespace shd::film {
namespace {

/// Depth and colours of a tile as they are before its first draw; false if there is none.
bool begin(TileState* tile) {
  const Frame& frame = tile->renderer.frame;
  Worker& worker = tile->worker;
  const geometry::PixelBox whole =
      geometry::pixel_rectangle(tile->left, tile->top, tile->area.width, tile->area.height);
  const geometry::PixelBox box = geometry::intersection(whole, frame.scissor);
  if (!frame.keep && !geometry::is_empty(box)) {
    const TileArea cleared = {tile->area.left + static_cast<uint32_t>(box.min_x - tile->left),
                              tile->area.top + static_cast<uint32_t>(box.min_y - tile->top),
                              static_cast<uint32_t>(box.max_x - box.min_x + 1),
                              static_cast<uint32_t>(box.max_y - box.min_y + 1)};
    clear_area(cleared, frame.clear_color, frame.clear_depth, &tile->framebuffer);
  }
  if (tile->is_bare()) return false;
  const bool is_clear = !frame.keep && box.max_x - box.min_x == whole.max_x - whole.min_x &&
                        box.max_y - box.min_y == whole.max_y - whole.min_y;
  if (is_clear) {
    fill_depth(frame.clear_depth, &worker.tile);
  } else {
    load_depth(tile->area, tile->framebuffer, &worker.tile);
  }
  clear_slots(&worker.tile);
  worker.slots.clear();
  tile->color.load();
  return true;
}

/// Draws whose blend has an order.
struct Unfinished {
  bool weighted, sorted;
};
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
      blend_run(tile, run);
    }
  });
  shade_visible(tile);
  return unfinished;
}

}  // namespace

void TileRenderer::render(uint32_t index, Worker* worker) const {
  TileState tile(*this, index, worker);
  if (!begin(&tile)) return;
  const Unfinished unfinished = draw_in_order(&tile);
  if (unfinished.weighted) draw_weighted(&tile);
  if (unfinished.sorted) draw_sorted(&tile);
  tile.color.resolve();
  store_depth(tile.area, worker->tile, &tile.framebuffer);
}

}  // namespace shd::film
