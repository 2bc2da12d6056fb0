// SPDX-License-Identifier: MIT
#include "frame/texture_batch.h"

#include <algorithm>

#include "geometry/vertex.h"
#include "shade/one_texture.h"

namespace shd::frame {
namespace {

/// Triangles with fewer pixels in a tile share a table with others: a batch has costs of its own.
constexpr size_t kFewPixels = 64;
/// Triangles with fewer pixels in a tile do without a table of its columns.
constexpr size_t kManyPixels = 256;

size_t length_of(const raster::PixelRun& run) {
  return size_t{run.end} - run.begin;
}

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
  direct_ = framebuffer.color_format == SHD_FORMAT_RGBA8 && framebuffer.samples == 1 && are_all_rgba8();
  return direct_;
}

bool TextureBatch::are_all_rgba8() {
  const Worker& worker = tile_.worker;
  for (size_t slot = 0; slot < worker.slots.size(); ++slot) {
    const uint32_t begin = worker.order.start[slot], end = worker.order.start[slot + 1],
                   draw = worker.slots[slot]->draw;
    size_t pixels = 0;
    for (uint32_t i = begin; i < end; ++i) pixels += length_of(worker.order.run[i]);
    if (pixels == 0) continue;
    if (pixels < kFewPixels || !takes(draw)) return false;
    if (!shade::writes_rgba8(*tile_.renderer.frame.draws[draw].material)) return false;
  }
  return true;
}

size_t TextureBatch::draw(const geometry::ScreenTriangle& triangle, raster::PixelRun* runs, size_t count) {
  if (!takes(triangle.draw)) return count;
  size_t pixels = 0, rest = 0;
  for (size_t i = 0; i < count; ++i) pixels += length_of(runs[i]);
  if (pixels < kFewPixels) return count;
  columns_.known = false;
  if (pixels >= kManyPixels) {
    raster::find_columns(tile_.simd(), *tile_.shading_of(triangle.draw).vertices, pixels_of(triangle), &columns_);
  }
  for (size_t i = 0; i < count; ++i) {
    if (runs[i].mask != tile_.all_samples()) {
      runs[rest++] = runs[i];
      continue;
    }
    for (raster::PixelRun run = runs[i]; run.begin < runs[i].end; run.begin = run.end) {
      if (rows_ == raster::kMaxTextureRows) flush(triangle);
      const size_t end = std::min<size_t>(runs[i].end, run.begin + (raster::kMaxTextureRows - rows_));
      run.end = static_cast<uint16_t>(end);
      run_[run_count_++] = run;
      rows_ += length_of(run);
    }
  }
  flush(triangle);
  return rest;
}

raster::TrianglePixels TextureBatch::pixels_of(const geometry::ScreenTriangle& triangle) const {
  const geometry::Vertices& vertices = *tile_.shading_of(triangle.draw).vertices;
  raster::TrianglePixels pixels = {
      {}, static_cast<float>(tile_.left), static_cast<float>(tile_.top), run_, run_count_};
  for (size_t k = 0; k < 3; ++k) pixels.row[k] = geometry::row_of(vertices, triangle.primitive, k);
  return pixels;
}

void TextureBatch::flush(const geometry::ScreenTriangle& triangle) {
  if (rows_ == 0) return;
  Worker& worker = tile_.worker;
  const shade::DrawShading shading = tile_.shading_of(triangle.draw);
  const raster::TrianglePixels pixels = pixels_of(triangle);
  shade::Radiance colors = worker.workspace.columns.radiance;
  const bool in_place = !direct_ && run_count_ == 1 && tile_.color.point_to(run_[0], &colors);
  shade::shade_one_texture(tile_.simd(), shading, pixels, columns_, rows_, &worker.workspace, colors.channel,
                           direct_ ? pixels_ : nullptr);
  if (!direct_) std::fill_n(colors.channel[3], rows_, 1.0f);
  size_t row = 0;
  for (size_t i = 0; i < run_count_ && !in_place; ++i) {
    if (direct_) {
      film::store_pixels(tile_.area, run_[i], pixels_ + row, &tile_.framebuffer);
    } else {
      tile_.color.write_run(run_[i].begin, run_[i].end, colors, row);
    }
    row += length_of(run_[i]);
  }
  worker.fragments += rows_;
  run_count_ = rows_ = 0;
}

}  // namespace shd::frame
