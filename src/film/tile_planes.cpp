// SPDX-License-Identifier: MIT
#include "film/tile_planes.h"

#include <algorithm>
#include <cstring>

#include "film/stream_rows.h"
#include "image/pixels.h"

namespace shd::film {
namespace {

/// The planes from pixel (x, y) of the tile on.
TilePlanes offset(const TilePlanes& planes, size_t x, size_t y) {
  TilePlanes moved = planes;
  for (float*& plane : moved.plane) plane += y * planes.stride + x;
  return moved;
}

/// Fills pixels of a row, most of them in blocks.
void fill_row(float* to, size_t count, float value) {
  constexpr size_t kBlock = 16;
  for (; count >= kBlock; count -= kBlock, to += kBlock) {
    for (size_t i = 0; i < kBlock; ++i) to[i] = value;
  }
  std::fill_n(to, count, value);
}

/// Encodes a row of pixels of a tile into the framebuffer.
void encode_row(const core::SimdTarget& simd, const float* const row[4], size_t count, const Framebuffer& framebuffer,
                uint8_t* to) {
  if (!framebuffer.is_large) return image::encode_pixels(simd, framebuffer.color_format, row, count, to);
  alignas(64) uint8_t bytes[raster::kTile * 8];  // RGBA16F has the longest pixels
  image::encode_pixels(simd, framebuffer.color_format, row, count, bytes);
  const size_t words = count * shd_format_size(framebuffer.color_format) / sizeof(uint32_t);
  stream_rows(simd, {reinterpret_cast<const uint32_t*>(bytes), 0}, words, 1, {reinterpret_cast<uint32_t*>(to), 0});
}

/// Writes the colour of a part of a tile to the planes of a large framebuffer.
void store_planes(const core::SimdTarget& simd, const TileArea& area, const TileArea& part, const TilePlanes& planes,
                  Framebuffer* framebuffer) {
  const TilePlanes from = offset(planes, part.left - area.left, part.top - area.top);
  const size_t first = size_t{part.top} * framebuffer->stride + part.left;
  for (uint32_t c = 0; c < 4; ++c) {
    float* const to = framebuffer->plane[c].data() + first;
    stream_rows(simd, {reinterpret_cast<const uint32_t*>(from.plane[c]), from.stride}, part.width, part.height,
                {reinterpret_cast<uint32_t*>(to), framebuffer->stride});
  }
}

/// Calls body(first, count, to) for each row of a run: `count` pixels from number `first` of the run on lie at `to`.
template <class Body>
void for_each_row(const TileArea& area, const raster::PixelRun& run, Framebuffer* framebuffer, const Body& body) {
  for (uint32_t begin = run.begin, end; begin < run.end; begin = end) {
    end = std::min<uint32_t>(run.end, raster::next_row(begin));
    const uint32_t x = area.left + begin % raster::kTile, y = area.top + begin / raster::kTile;
    body(begin - run.begin, end - begin, pixel_at(framebuffer, x, y));
  }
}

}  // namespace

TilePlanes planes_of(const TileArea& area, uint32_t first, Framebuffer* framebuffer) {
  const size_t corner = size_t{area.top} * framebuffer->stride + area.left;
  TilePlanes planes;
  for (uint32_t c = 0; c < 4; ++c) planes.plane[c] = framebuffer->plane[first + c].data() + corner;
  planes.stride = framebuffer->stride;
  return planes;
}

void ColorBlock::allocate(const core::Allocator& allocator, const Framebuffer& framebuffer) {
  if (has_color_block(framebuffer)) planes_ = core::Array<float>(allocator, 4 * raster::kTilePixels);
}

TilePlanes ColorBlock::planes(const TileArea& area, Framebuffer* framebuffer) {
  if (!has_color_block(*framebuffer)) return planes_of(area, SHD_PLANE_R, framebuffer);
  float* const first = planes_.data();
  return {{first, first + raster::kTilePixels, first + 2 * raster::kTilePixels, first + 3 * raster::kTilePixels},
          raster::kTile};
}

void fill_color(const TileArea& area, const TileArea& part, const float color[4], const TilePlanes& planes) {
  for (uint32_t y = 0; y < part.height; ++y) {
    const TilePlanes row = offset(planes, part.left - area.left, part.top - area.top + y);
    for (uint32_t c = 0; c < 4; ++c) fill_row(row.plane[c], part.width, color[c]);
  }
}

void fill_color(const TileArea& area, const raster::PixelRun& run, const float color[4], const TilePlanes& planes) {
  for (uint32_t begin = run.begin, end; begin < run.end; begin = end) {
    end = std::min<uint32_t>(run.end, raster::next_row(begin));
    const uint32_t x = begin % raster::kTile, y = begin / raster::kTile;
    if (y >= area.height) return;
    if (x >= area.width) continue;
    const TilePlanes row = offset(planes, x, y);
    const uint32_t width = std::min(end - begin, area.width - x);
    for (uint32_t c = 0; c < 4; ++c) fill_row(row.plane[c], width, color[c]);
  }
}

void load_color(const TileArea& area, const Framebuffer& framebuffer, const TilePlanes& planes) {
  if (!has_color_block(framebuffer)) return;
  for (uint32_t y = 0; y < area.height; ++y) {
    const TilePlanes row = offset(planes, 0, y);
    if (has_color_planes(framebuffer)) {
      const size_t first = (size_t{area.top} + y) * framebuffer.stride + area.left;
      for (uint32_t c = 0; c < 4; ++c) std::copy_n(framebuffer.plane[c].data() + first, area.width, row.plane[c]);
      continue;
    }
    image::decode_pixels(framebuffer.color_format, pixel_at(framebuffer, area.left, area.top + y), area.width,
                         row.plane);
  }
}

void store_color(const core::SimdTarget& simd, const TileArea& area, const TileArea& part, const TilePlanes& planes,
                 Framebuffer* framebuffer) {
  if (!has_color_block(*framebuffer)) return;
  if (has_color_planes(*framebuffer)) return store_planes(simd, area, part, planes, framebuffer);
  for (uint32_t y = 0; y < part.height; ++y) {
    const TilePlanes row = offset(planes, part.left - area.left, part.top - area.top + y);
    encode_row(simd, row.plane, part.width, *framebuffer, pixel_at(framebuffer, part.left, part.top + y));
  }
}

void store_pixels(const core::SimdTarget& simd, const TileArea& area, const raster::PixelRun& run,
                  const uint32_t* pixels, Framebuffer* framebuffer) {
  const bool is_rows = area.width == raster::kTile && run.begin % raster::kTile == 0 && run.end % raster::kTile == 0;
  if (framebuffer->is_large && is_rows) {
    uint8_t* const to = pixel_at(framebuffer, area.left, area.top + run.begin / raster::kTile);
    return stream_rows(simd, {pixels, raster::kTile}, raster::kTile, raster::length_of(run) / raster::kTile,
                       {reinterpret_cast<uint32_t*>(to), framebuffer->stride});
  }
  for_each_row(area, run, framebuffer, [&](size_t first, size_t count, uint8_t* to) {
    if (!framebuffer->is_large) {
      std::memcpy(to, pixels + first, count * sizeof *pixels);
    } else {
      stream_rows(simd, {pixels + first, 0}, count, 1, {reinterpret_cast<uint32_t*>(to), 0});
    }
  });
}

void store_pixels(const core::SimdTarget& simd, const TileArea& area, const raster::PixelRun& run,
                  const float* const plane[4], Framebuffer* framebuffer) {
  for_each_row(area, run, framebuffer, [&](size_t first, size_t count, uint8_t* to) {
    const float* const row[4] = {plane[0] + first, plane[1] + first, plane[2] + first, plane[3] + first};
    encode_row(simd, row, count, *framebuffer, to);
  });
}

}  // namespace shd::film
