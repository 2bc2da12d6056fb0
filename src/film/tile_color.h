// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "film/blend.h"
#include "film/framebuffer.h"
#include "film/tile_area.h"
#include "film/tile_planes.h"
#include "raster/fragments.h"
#include "shade/columns.h"

namespace shd::film {

/// Storage of the pixels of a tile whose samples have several colours; empty with one sample per pixel.
struct SplitSamples {
  core::Array<float> color;       // [kTilePixels][samples][targets][4]: r, g, b, a
  core::Array<uint8_t> is_split;  // [kTilePixels]
};

/// @param targets  bit t is set if target t exists
/// Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, uint32_t samples, uint32_t targets, SplitSamples* out);

/// Colour and targets of the samples of a tile while it is drawn. A pixel whose samples are all equal is stored in
/// planes. A pixel whose samples may differ is split until the tile is resolved. Pixels are numbered row-major in the
/// tile, samples are bits of a mask.
class TileColor {
 public:
  TileColor(const TileArea& area, const TilePlanes& color, Framebuffer* framebuffer, SplitSamples* split);

  /// Marks every pixel as stored in planes.
  void load();
  /// States that pixels which are split from now on have one colour so far, so that it need not be read; null = they
  /// may differ. Only for tiles whose only target is colour; others ignore it.
  void assume(const float* color) { assumed_ = target_count_ == 1 ? color : nullptr; }
  /// Points r, g, b and a to a run of pixels, all of whose samples are then written there, if colour is the only target
  /// and the pixels of the tile are consecutive. Returns whether they are.
  bool point_to(const raster::PixelRun& run, shade::Radiance* out);
  /// Writes rows of `from`, from `row` on, to all samples of the pixels of some runs.
  void write_runs(const core::SimdTarget& simd, const raster::PixelRun* runs, size_t count, const shade::Radiance& from,
                  size_t row);
  /// Writes colour and targets of a row of `from` to the samples in a mask that lacks some.
  void write_some(uint32_t pixel, uint32_t mask, const shade::Radiance& from, size_t row);
  /// Blends a colour, and the targets of a row of `from`, over the samples in a mask.
  void blend(shd_blend mode, uint32_t pixel, uint32_t mask, const FragmentColor& color, const shade::Radiance& from,
             size_t row);
  /// Blends a premultiplied colour over the samples in a mask. Other targets keep their values.
  void over(uint32_t pixel, uint32_t mask, const FragmentColor& color);
  /// The colour of one sample, as the destination of a blend.
  Destination sample(uint32_t pixel, uint32_t sample);
  /// Writes the plain average of each split pixel to the planes; if all samples are equal, it keeps their bits.
  void resolve();

 private:
  size_t position(uint32_t pixel, uint32_t t) const {
    return pixel / raster::kTile * planes_[t].stride + pixel % raster::kTile;
  }
  Destination whole(uint32_t pixel, uint32_t t) const;
  float* split(uint32_t pixel);
  /// Marks pixels as stored in planes.
  void mark_whole(uint32_t begin, uint32_t end);

  const uint32_t samples_, all_;
  const float* assumed_ = nullptr;  // colour of the pixels that are not split, or null
  uint32_t target_count_ = 0;
  uint32_t target_[shade::kMaxTargets];    // indices of the existing targets
  TilePlanes planes_[shade::kMaxTargets];  // [target_count_] planes of these targets
  SplitSamples& split_;
};

}  // namespace shd::film
