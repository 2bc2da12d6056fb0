// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "film/tile_color.h"
#include "frame/tile_renderer.h"
#include "frame/worker.h"
#include "raster/coverage.h"

namespace shd::frame {

/// Consecutive triangles of a tile's bin that belong to one draw.
struct Run {
  uint32_t draw;
  const geometry::ScreenTriangle* triangles;
  const uint32_t* entries;
  size_t count;
};

/// Whether the visibility buffer can resolve a material: it is opaque and drops no fragments.
inline bool is_plain(const material::Material& material) {
  return material.blend == SHD_BLEND_OPAQUE && !material::drops_fragments(material);
}

inline uint32_t first_sample(uint32_t mask) {
  return static_cast<uint32_t>(__builtin_ctz(mask));
}

/// State of one tile while it is drawn: its area and contents.
class TileState {
 public:
  TileState(const TileRenderer& renderer, uint32_t index, Worker* worker);

  const Draw& draw_of(const Run& run) const { return renderer.frame.draws[run.draw]; }
  const Draw& draw_of(const geometry::ScreenTriangle& triangle) const { return renderer.frame.draws[triangle.draw]; }
  /// Whether a draw is shaded at each sample.
  bool shades_samples(const Draw& draw) const { return pattern.count > 1 && draw.sample_shading; }
  const core::SimdTarget& simd() const { return renderer.context.simd; }

  shade::DrawShading shading_of(uint32_t draw) const;

  /// Pixels of the picture that may change.
  geometry::PixelBox box() const;
  raster::CoverArea cover_area(const geometry::PixelBox& box) const { return {pattern, left, top, box}; }
  /// Position of a pixel of the tile in the picture.
  int32_t left_of(uint32_t pixel) const { return left + static_cast<int32_t>(pixel % raster::kTile); }
  int32_t top_of(uint32_t pixel) const { return top + static_cast<int32_t>(pixel / raster::kTile); }
  uint32_t all_samples() const { return (1u << pattern.count) - 1; }
  float* depth_of(uint32_t sample, uint32_t pixel) const {
    return worker.tile.depth.data() + size_t{pixel} * pattern.count + sample;
  }

  /// Whether the colour of the tile is read by nothing but the framebuffer: one pass of opaque draws makes it.
  bool is_drawn_once() const;
  /// Whether no triangle and no volume touches the tile.
  bool is_bare() const;
  /// Fills a part of the tile's colour with the background.
  void fill(const film::TileArea& part);
  /// Clears colour unless it is already cleared.
  void clear_color();
  /// As clear_color(), but may clear only these pixels: all samples of the others will be written.
  void clear_bare(const core::Buffer<raster::PixelRun>& bare);

  /// Calls body(run) for the triangles of the tile, in order.
  template <class Body>
  void for_each_run(const Body& body) const {
    const raster::Bins& bins = renderer.scene.bins;
    for (uint32_t g = 0; g < bins.group_count; ++g) {
      const raster::BinSegment segment = raster::segment(bins, index, g);
      const geometry::ScreenTriangle* triangles = renderer.scene.groups[g].data();
      for (size_t begin = 0; begin < segment.count;) {
        const uint32_t draw = triangles[segment.entries[begin]].draw;
        size_t end = begin + 1;
        while (end < segment.count && triangles[segment.entries[end]].draw == draw) ++end;
        body(Run{draw, triangles, segment.entries + begin, end - begin});
        begin = end;
      }
    }
  }

  /// Calls body(pixel, mask) for the pixels of the worker's mask.
  template <class Body>
  void for_each_masked(const Body& body) const {
    const raster::CoverMask& mask = worker.mask;
    for (int32_t y = mask.box.min_y; y <= mask.box.max_y; ++y) {
      for (int32_t x = mask.box.min_x; x <= mask.box.max_x; ++x) {
        const auto pixel = static_cast<uint32_t>(y * raster::kTile + x);
        if (mask.bits[pixel]) body(pixel, mask.bits[pixel]);
      }
    }
  }
  /// Counts the samples of the mask.
  uint64_t count_masked() const;
  /// Adds the covered samples that did not pass to the worker's statistics, if frame.counts_hidden. Overwrites the
  /// mask.
  void count_hidden(const raster::CoverArea& area, const geometry::ScreenTriangle& triangle, uint64_t passed) const;

  const TileRenderer& renderer;
  film::Framebuffer& framebuffer;
  const raster::SamplePattern& pattern;
  const uint32_t index;
  const film::TileArea area;  // position and size in the framebuffer
  const int32_t left, top;    // position in the picture
  Worker& worker;
  const film::TilePlanes color_planes;
  film::TileColor color;
  bool color_is_unclear = false;  // clearing the tile's colour is still pending
  bool color_is_stored = false;   // the framebuffer has all pixels, and the tile's colour is not set
};

}  // namespace shd::frame
