// SPDX-License-Identifier: MIT
#include "film/tile_writer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace shd::film {
namespace {

/// Position of pixel (0, y) of the tile in a plane.
size_t row_start(const TileArea& area, const Framebuffer& framebuffer, uint32_t y) {
  return (area.top + size_t{y}) * framebuffer.stride + area.left;
}

/// Of colours [samples][4].
void average(const float* from, uint32_t samples, float out[4]) {
  const float share = 1.0f / static_cast<float>(samples);
  float sum[4] = {};
  for (uint32_t s = 0; s < samples; ++s, from += 4) {
    for (size_t c = 0; c < 4; ++c) sum[c] += from[c];
  }
  for (size_t c = 0; c < 4; ++c) out[c] = sum[c] * share;
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

void clear_area(const TileArea& area, const float color[4], float depth, Framebuffer* framebuffer) {
  for (uint32_t y = 0; y < area.height; ++y) {
    const size_t start = row_start(area, *framebuffer, y);
    for (uint32_t p = 0; p < kPlaneCount; ++p) {
      if (!wants_plane(framebuffer->aovs, p)) continue;
      if (kPlanes[p].is_integer) {
        std::fill_n(&framebuffer->u32_plane[p][start], area.width, static_cast<uint32_t>(kPlanes[p].empty));
        continue;
      }
      const auto empty = static_cast<float>(kPlanes[p].empty);
      const float value = p < SHD_PLANE_DEPTH ? color[p] : p == SHD_PLANE_DEPTH ? depth : empty;
      std::fill_n(&framebuffer->plane[p][start], area.width, value);
    }
  }
}

void clear_slots(raster::Tile* tile) {
  std::fill(tile->slot.begin(), tile->slot.end(), raster::kNoSlot);
}

void load_depth(const TileArea& area, const Framebuffer& framebuffer, raster::Tile* tile) {
  clear_slots(tile);
  for (uint32_t y = 0; y < area.height; ++y) {
    const float* depth = &framebuffer.plane[SHD_PLANE_DEPTH][row_start(area, framebuffer, y)];
    float* to = tile->depth.data() + size_t{y} * raster::kTile * tile->samples;
    for (uint32_t x = 0; x < area.width; ++x, to += tile->samples) std::fill_n(to, tile->samples, depth[x]);
  }
}

void store_depth(const TileArea& area, const raster::Tile& tile, Framebuffer* framebuffer) {
  for (uint32_t y = 0; y < area.height; ++y) {
    float* depth = &framebuffer->plane[SHD_PLANE_DEPTH][row_start(area, *framebuffer, y)];
    const float* from = tile.depth.data() + size_t{y} * raster::kTile * tile.samples;
    for (uint32_t x = 0; x < area.width; ++x) depth[x] = from[x * tile.samples];
  }
}

void load_color(const TileArea& area, const Framebuffer& framebuffer, uint32_t samples, float* color) {
  for (uint32_t y = 0; y < area.height; ++y) {
    const size_t start = row_start(area, framebuffer, y);
    float* to = color + size_t{y} * raster::kTile * samples * 4;
    for (uint32_t x = 0; x < area.width; ++x) {
      float pixel[4];
      for (size_t c = 0; c < 4; ++c) pixel[c] = framebuffer.plane[c][start + x];
      for (uint32_t s = 0; s < samples; ++s, to += 4) std::memcpy(to, pixel, sizeof pixel);
    }
  }
}

void resolve_color(const TileArea& area, const float* color, uint32_t samples, Framebuffer* framebuffer) {
  for (uint32_t y = 0; y < area.height; ++y) {
    const size_t start = row_start(area, *framebuffer, y);
    const float* from = color + size_t{y} * raster::kTile * samples * 4;
    for (uint32_t x = 0; x < area.width; ++x, from += 4 * samples) {
      float mean[4];
      if (std::memcmp(from, from + 4, (samples - 1) * sizeof mean) == 0) {
        std::memcpy(mean, from, sizeof mean);
      } else {
        average(from, samples, mean);
      }
      for (size_t c = 0; c < 4; ++c) framebuffer->plane[c][start + x] = mean[c];
    }
  }
}

size_t write_fragments(const raster::Fragments& f, const shade::Radiance& radiance, const SampleColor* colors,
                       uint32_t samples) {
  size_t nonfinite = 0;
  for (size_t i = 0; i < f.count; ++i) {
    float color[4];
    bool finite = true;
    for (size_t c = 0; c < 4; ++c) {
      color[c] = radiance.channel[c][i];
      finite &= std::isfinite(color[c]);
    }
    nonfinite += !finite;
    const size_t at = colors[0].at(f.pixel[i]);
    if (samples == 1) {
      for (size_t c = 0; c < 4; ++c) colors[0].channel[c][at] = color[c];
      continue;
    }
    float* to = colors[0].channel[0] + at;
    for (uint32_t mask = f.mask[i]; mask; mask &= mask - 1) {
      std::memcpy(to + 4 * __builtin_ctz(mask), color, sizeof color);
    }
  }
  return nonfinite;
}

}  // namespace shd::film
