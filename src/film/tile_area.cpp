// SPDX-License-Identifier: MIT
#include "film/tile_area.h"

#include <algorithm>
#include <cstring>

#include "film/stream_rows.h"

namespace shd::film {
namespace {

/// Position of pixel (0, y) of the tile in a plane.
size_t row_start(const TileArea& area, const Framebuffer& framebuffer, uint32_t y) {
  return (area.top + size_t{y}) * framebuffer.stride + area.left;
}

template <class T>
void fill(const TileArea& area, T value, const Framebuffer& framebuffer, core::Array<T>* plane) {
  for (uint32_t y = 0; y < area.height; ++y) {
    std::fill_n(plane->data() + row_start(area, framebuffer, y), area.width, value);
  }
}

}  // namespace

TileArea tile_area(const Framebuffer& framebuffer, uint32_t tile, uint32_t tiles_x) {
  TileArea area;
  area.left = tile % tiles_x * raster::kTile;
  area.top = tile / tiles_x * raster::kTile;
  area.width = std::min<uint32_t>(raster::kTile, framebuffer.width - area.left);
  area.height = std::min<uint32_t>(raster::kTile, framebuffer.height - area.top);
  return area;
}

void clear_depth(const TileArea& area, float depth, Framebuffer* framebuffer) {
  fill(area, depth, *framebuffer, &framebuffer->plane[SHD_PLANE_DEPTH]);
}

void clear_aovs(const TileArea& area, Framebuffer* framebuffer) {
  for (uint32_t p = SHD_PLANE_DEPTH + 1; p < kPlaneCount; ++p) {
    if (!has_plane(*framebuffer, p)) continue;
    if (kPlanes[p].is_integer) {
      fill(area, static_cast<uint32_t>(kPlanes[p].empty), *framebuffer, &framebuffer->u32_plane[p]);
    } else {
      fill(area, static_cast<float>(kPlanes[p].empty), *framebuffer, &framebuffer->plane[p]);
    }
  }
}

void load_depth(const TileArea& area, const Framebuffer& framebuffer, raster::Tile* tile) {
  for (uint32_t y = 0; y < area.height; ++y) {
    const float* depth = &framebuffer.plane[SHD_PLANE_DEPTH][row_start(area, framebuffer, y)];
    float* to = tile->depth.data() + size_t{y} * raster::kTile * tile->samples;
    for (uint32_t x = 0; x < area.width; ++x, to += tile->samples) std::fill_n(to, tile->samples, depth[x]);
  }
}

void store_depth(const core::SimdTarget& simd, const TileArea& area, const raster::Tile& tile,
                 Framebuffer* framebuffer) {
  if (framebuffer->is_large && tile.samples == 1) {
    float* const first = &framebuffer->plane[SHD_PLANE_DEPTH][row_start(area, *framebuffer, 0)];
    return stream_rows(simd, {reinterpret_cast<const uint32_t*>(tile.depth.data()), raster::kTile}, area.width,
                       area.height, {reinterpret_cast<uint32_t*>(first), framebuffer->stride});
  }
  for (uint32_t y = 0; y < area.height; ++y) {
    float* depth = &framebuffer->plane[SHD_PLANE_DEPTH][row_start(area, *framebuffer, y)];
    const float* from = tile.depth.data() + size_t{y} * raster::kTile * tile.samples;
    if (tile.samples == 1) {
      std::memcpy(depth, from, area.width * sizeof(float));
      continue;
    }
    for (uint32_t x = 0; x < area.width; ++x) depth[x] = from[x * tile.samples];
  }
}

}  // namespace shd::film
