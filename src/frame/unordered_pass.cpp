// SPDX-License-Identifier: MIT
#include "frame/unordered_pass.h"

#include "frame/blended_pass.h"

namespace shd::frame {
namespace {

/// Calls body(run) for the runs of one blend mode.
template <class Body>
void for_each_unordered(const TileState& tile, shd_blend blend, const Body& body) {
  tile.for_each_run([&](const Run& run) {
    const material::Material* material = tile.draw_of(run).material;
    if (material && material->blend == blend) body(run);
  });
}

/// Calls body(draw, sample, survivor) for every sample in a box that passes the tests of a draw of one blend mode.
template <class Body>
void for_each_sample(TileState* tile, shd_blend blend, const geometry::PixelBox& box, const Body& body) {
  for_each_unordered(*tile, blend, [&](const Run& run) {
    shade_run(tile, run, box, [&](const Draw& draw) {
      Survival survival(draw, tile);
      Survivor left;
      for (size_t i = 0; i < tile->worker.workspace.fragments.count; ++i) {
        if (!survival.survives(i, &left)) continue;
        for (uint32_t rest = left.mask; rest; rest &= rest - 1) body(draw, first_sample(rest), left);
      }
    });
  });
}

/// Counts the samples in a box that the sorted draws cover.
size_t count_sorted(TileState* tile, const geometry::PixelBox& box) {
  size_t count = 0;
  for_each_unordered(*tile, SHD_BLEND_SORTED, [&](const Run& run) {
    for (size_t i = 0; i < run.count; ++i) {
      raster::cover_mask(tile->simd(), tile->cover_area(box), tile->draw_of(run).depth, run.triangles[run.entries[i]],
                         tile->worker.tile, &tile->worker.mask);
      count += tile->count_masked();
    }
  });
  return count;
}

/// Draws a box. A box with more than film::kMaxNodes samples is halved first, down to one pixel.
void draw_sorted_box(TileState* tile, const geometry::PixelBox& box) {
  const int32_t width = box.max_x - box.min_x + 1, height = box.max_y - box.min_y + 1;
  if (width * height > 1 && count_sorted(tile, box) > film::kMaxNodes) {
    geometry::PixelBox first = box, second = box;
    if (height >= width) {
      first.max_y = box.min_y + height / 2 - 1;
      second.min_y = first.max_y + 1;
    } else {
      first.max_x = box.min_x + width / 2 - 1;
      second.min_x = first.max_x + 1;
    }
    draw_sorted_box(tile, first);
    return draw_sorted_box(tile, second);
  }
  core::Buffer<film::SortedNode>& nodes = tile->worker.unordered.nodes;
  nodes.clear();
  for_each_sample(tile, SHD_BLEND_SORTED, box, [&](const Draw& draw, uint32_t sample, const Survivor& left) {
    const auto position = static_cast<uint32_t>(sample * raster::kTilePixels + left.pixel);
    const float depth = left.depth[sample];
    nodes.push_back({position, draw.depth_falls ? -depth : depth, static_cast<uint32_t>(nodes.size()), left.color});
  });
  film::blend_sorted(&tile->worker.unordered, &tile->color);
}

}  // namespace

void draw_weighted(TileState* tile) {
  film::Unordered* unordered = &tile->worker.unordered;
  film::clear_weighted(tile->renderer.context.allocator, tile->pattern.count, unordered);
  for_each_sample(tile, SHD_BLEND_WEIGHTED, tile->box(), [&](const Draw&, uint32_t sample, const Survivor& left) {
    film::add_weighted(sample, left.pixel, left.depth[sample], left.color, unordered);
  });
  film::blend_weighted(tile->pattern.count, *unordered, &tile->color);
}

void draw_sorted(TileState* tile) {
  draw_sorted_box(tile, tile->box());
}

}  // namespace shd::frame
