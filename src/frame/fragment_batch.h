// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "frame/tile_state.h"
#include "raster/edge.h"

namespace shd::frame {

/// Where in its pixels a triangle is shaded.
struct Placing {
  bool at_samples;
  raster::EdgeLine line[3];   // with several samples
  raster::Edge at_centre[3];  // the same
};

/// Gathers the fragments of one draw into the worker's table and shades it when it is full: its owner's done(draw)
/// then sees the radiance.
class FragmentBatch {
 public:
  explicit FragmentBatch(const TileState& tile) : tile_(tile), worker_(tile.worker) {}

  /// Adds pixels of one triangle, one fragment for each or for each of its samples.
  template <class Done>
  void add(const geometry::ScreenTriangle& triangle, const raster::VisiblePixel* pixels, size_t count,
           const Done& done) {
    BatchTriangles& triangles = worker_.triangles;
    if (triangles.count == max_triangles(triangle)) flush(triangle.draw, done);
    triangles.triangle[triangles.count++] = &triangle;
    const Placing placing = placing_of(triangle);
    for (size_t i = 0; i < count && placing.at_samples; ++i) {
      for (uint32_t mask = pixels[i].mask; mask; mask &= mask - 1) {
        make_room(done);
        const raster::VisiblePixel sample = {pixels[i].position, static_cast<uint16_t>(mask & ~(mask - 1))};
        append(triangle, placing, &sample, 1);
      }
    }
    for (size_t i = 0; i < count && !placing.at_samples;) {
      const size_t more = std::min(count - i, make_room(done));
      append(triangle, placing, pixels + i, more);
      i += more;
    }
  }

  /// Shades what there is, and empties the table.
  template <class Done>
  void flush(uint32_t draw, const Done& done) {
    if (worker_.workspace.fragments.count) {
      shade(draw);
      done(tile_.renderer.frame.draws[draw]);
    }
    worker_.workspace.fragments.count = 0;
    worker_.triangles.count = 0;
  }

 private:
  /// Makes room for fragments of the latest triangle. Returns for how many.
  template <class Done>
  size_t make_room(const Done& done) {
    const raster::Fragments& f = worker_.workspace.fragments;
    BatchTriangles& triangles = worker_.triangles;
    if (f.count == raster::kBatch) {
      const geometry::ScreenTriangle* triangle = triangles.triangle[triangles.count - 1];
      flush(triangle->draw, done);
      triangles.triangle[triangles.count++] = triangle;
    }
    return raster::kBatch - f.count;
  }

  size_t max_triangles(const geometry::ScreenTriangle& triangle) const;
  Placing placing_of(const geometry::ScreenTriangle& triangle) const;
  bool covers_centre(const Placing& placing, uint32_t pixel) const;
  uint32_t covered_samples(const Placing& placing, size_t row) const;
  void place(const Placing& placing, size_t row) const;
  void append(const geometry::ScreenTriangle& triangle, const Placing& placing, const raster::VisiblePixel* pixels,
              size_t count);
  void set_depths(const geometry::ScreenTriangle& triangle, const Draw& draw, const Placing& placing, size_t begin,
                  size_t end);
  void shade(uint32_t draw);

  const TileState& tile_;
  Worker& worker_;
};

}  // namespace shd::frame
