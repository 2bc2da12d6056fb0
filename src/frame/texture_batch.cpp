// SPDX-License-Identifier: MIT
#include "frame/texture_batch.h"

#include <algorithm>

#include "geometry/vertex.h"
#include "shade/one_texture.h"

namespace shd::frame {
namespace {

/// Triangles with fewer pixels in a tile share a table with others: a batch has costs of its own.
constexpr size_t kFewPixels = 64;

}  // namespace

bool TextureBatch::takes(uint32_t draw) {
  if (draw == draw_) return takes_;
  const Draw& d = tile_.renderer.frame.draws[draw];
  draw_ = draw;
  takes_ = !tile_.framebuffer.aovs && !tile_.shades_samples(d) && shade::is_one_texture(*d.material);
  return takes_;
}

bool TextureBatch::begin_direct() {
  const film::Framebuffer& framebuffer = tile_.framebuffer;
  direct_ = !film::has_color_planes(framebuffer) && framebuffer.samples == 1 && takes_all();
  return direct_;
}

bool TextureBatch::takes_all() {
  const Worker& worker = tile_.worker;
  for (size_t slot = 0; slot < worker.slots.size(); ++slot) {
    const uint32_t begin = worker.order.start[slot], end = worker.order.start[slot + 1],
                   draw = worker.slots[slot]->draw;
    size_t pixels = 0;
    for (uint32_t i = begin; i < end; ++i) pixels += raster::length_of(worker.order.run[i]);
    if (pixels == 0) continue;
    if (pixels < kFewPixels || !takes(draw)) return false;
  }
  return true;
}

size_t TextureBatch::draw(const geometry::ScreenTriangle& triangle, raster::PixelRun* runs, size_t count) {
  if (!takes(triangle.draw)) return count;
  size_t pixels = 0, rest = 0;
  for (size_t i = 0; i < count; ++i) pixels += raster::length_of(runs[i]);
  if (pixels < kFewPixels) return count;
  const raster::Cell first = raster::cell_of(tile_.left, tile_.top);
  const raster::Cell last = raster::cell_of(tile_.left, tile_.top, raster::kTilePixels - 1);
  for (raster::Cell cell = first; cell.top <= last.top; cell.top += raster::kTile) {
    for (cell.left = first.left; cell.left <= last.left; cell.left += raster::kTile) {
      draw_cell(triangle, cell, runs, count);
    }
  }
  for (size_t i = 0; i < count; ++i) {
    if (runs[i].mask != tile_.all_samples()) runs[rest++] = runs[i];
  }
  return rest;
}

void TextureBatch::draw_cell(const geometry::ScreenTriangle& triangle, const raster::Cell& cell,
                             const raster::PixelRun* runs, size_t count) {
  const geometry::Vertices& vertices = *tile_.shading_of(triangle.draw).vertices;
  uint32_t row[3];
  for (size_t k = 0; k < 3; ++k) row[k] = geometry::row_of(vertices, triangle.primitive, k);
  raster::find_planes(vertices, row, cell, raster::kTexture, &planes_);
  for (size_t i = 0; i < count; ++i) {
    if (runs[i].mask == tile_.all_samples()) add_in_cell(runs[i], cell);
  }
  flush();
}

void TextureBatch::add_in_cell(const raster::PixelRun& run, const raster::Cell& cell) {
  const int32_t left = cell.left - tile_.left, top = cell.top - tile_.top;
  if (left == 0 && top == 0) return add(run);
  for (uint32_t begin = run.begin, end; begin < run.end; begin = end) {
    end = std::min<uint32_t>(run.end, raster::next_row(begin));
    const uint32_t y = begin / raster::kTile, row = y * raster::kTile;
    const int32_t in_cell = static_cast<int32_t>(y) - top;
    if (in_cell < 0 || in_cell >= raster::kTile) continue;
    const auto low = std::max(static_cast<int32_t>(begin - row), left);
    const auto high = std::min(static_cast<int32_t>(end - row), left + raster::kTile);
    if (low >= high) continue;
    add({static_cast<uint16_t>(row + static_cast<uint32_t>(low)),
         static_cast<uint16_t>(row + static_cast<uint32_t>(high)), run.mask});
  }
}

void TextureBatch::add(const raster::PixelRun& pixels) {
  for (raster::PixelRun run = pixels; run.begin < pixels.end; run.begin = run.end) {
    if (rows_ == raster::kBatch) flush();
    const size_t end = std::min<size_t>(pixels.end, run.begin + (raster::kBatch - rows_));
    run.end = static_cast<uint16_t>(end);
    runs_.run[runs_.count++] = run;
    rows_ += raster::length_of(run);
  }
}

void TextureBatch::flush() {
  if (rows_ == 0) return;
  Worker& worker = tile_.worker;
  const shade::DrawShading shading = tile_.shading_of(draw_);
  const raster::TrianglePixels pixels = {planes_, tile_.left, tile_.top, runs_.run, runs_.count};
  shade::Radiance colors = worker.workspace.columns.radiance;
  const bool codes =
      direct_ && tile_.framebuffer.color_format == SHD_FORMAT_RGBA8 && shade::writes_rgba8(*shading.material);
  const bool in_place = !direct_ && runs_.count == 1 && tile_.color.point_to(runs_.run[0], &colors);
  shade::shade_one_texture(tile_.simd(), shading, pixels, rows_, &worker.workspace, colors.channel,
                           codes ? pixels_ : nullptr);
  if (!codes) std::fill_n(colors.channel[3], rows_, 1.0f);
  if (!direct_ && !in_place) tile_.color.write_runs(tile_.simd(), runs_.run, runs_.count, colors, 0);
  size_t row = 0;
  for (size_t i = 0; i < runs_.count && direct_; ++i) {
    if (codes) {
      film::store_pixels(tile_.simd(), tile_.area, runs_.run[i], pixels_ + row, &tile_.framebuffer);
    } else {
      const float* const plane[4] = {colors.channel[0] + row, colors.channel[1] + row, colors.channel[2] + row,
                                     colors.channel[3] + row};
      film::store_pixels(tile_.simd(), tile_.area, runs_.run[i], plane, &tile_.framebuffer);
    }
    row += raster::length_of(runs_.run[i]);
  }
  worker.fragments += rows_;
  runs_.count = rows_ = 0;
}

}  // namespace shd::frame
