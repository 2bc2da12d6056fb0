// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "film/blend.h"
#include "film/framebuffer.h"
#include "film/tile_area.h"
#include "shade/columns.h"

namespace shd::film {

/// Memory of a tile's pixels whose samples have several colours; empty with one sample a pixel.
struct SplitSamples {
  core::Array<float> color;       // [kTilePixels][samples][4]: r, g, b, a
  core::Array<uint8_t> is_split;  // [kTilePixels]
};

/// Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, uint32_t samples, SplitSamples* out);

/// Colour of the samples of a tile while it is drawn. Where all samples of a pixel have one colour it is that of the
/// framebuffer; where they may differ they are split until the tile is resolved. Pixels are row-major in the tile,
/// samples are bits of a mask.
class TileColor {
 public:
  TileColor(const TileArea& area, Framebuffer* framebuffer, SplitSamples* split);

  /// Every pixel as the framebuffer has it.
  void load();
  void write(uint32_t pixel, uint32_t mask, const FragmentColor& color) {
    if (mask == all_) {
      const size_t at = position(pixel);
      for (size_t c = 0; c < 4; ++c) plane_[c][at] = color.channel[c];
      if (samples_ > 1) split_.is_split[pixel] = 0;
    } else {
      write_some(pixel, mask, color);
    }
  }
  /// write() to all samples of `count` neighbours in a row from `pixel` on: rows of `from` from `row` on.
  void write_row(uint32_t pixel, size_t count, const shade::Radiance& from, size_t row);
  void blend(shd_blend_mode mode, uint32_t pixel, uint32_t mask, const FragmentColor& color);
  /// One sample, to be changed.
  Below sample(uint32_t pixel, uint32_t sample);
  /// Plain averages to the framebuffer; samples that are all the same stay what they are, to the bit.
  void resolve();

 private:
  size_t position(uint32_t pixel) const { return corner_ + pixel / raster::kTile * stride_ + pixel % raster::kTile; }
  Below whole(uint32_t pixel) const;
  float* split(uint32_t pixel);
  void write_some(uint32_t pixel, uint32_t mask, const FragmentColor& color);

  const size_t corner_, stride_;
  const uint32_t samples_, all_;
  float* plane_[4];
  SplitSamples& split_;
};

}  // namespace shd::film
