// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "frame/tile_state.h"
#include "raster/edge.h"

namespace shd::frame {

/// Shading positions of a triangle in its pixels: each sample, or one point per pixel, which is the centre or the
/// centroid of the covered samples. The edges are those of raster::Edge, and set with several samples per pixel.
struct ShadingPoints {
  bool per_sample;
  int64_t a[3], b[3];  // steps of the edges
  int64_t at_centre[3], at_sample[3][raster::kMaxSamples];
};

/// The edges of a triangle at a pixel, without the value at a point of the pixel.
struct PixelEdges {
  PixelEdges(const ShadingPoints& points, uint32_t pixel) {
    const int64_t x = pixel % raster::kTile, y = pixel / raster::kTile;
    for (int k = 0; k < 3; ++k) step[k] = points.a[k] * x + points.b[k] * y;
  }
  bool covers(const int64_t (&at)[3]) const { return ((step[0] + at[0]) | (step[1] + at[1]) | (step[2] + at[2])) >= 0; }

  int64_t step[3];
};

/// Gathers the fragments of one draw in the worker's table. A full table is shaded; then done(draw) reads the radiance.
class FragmentBatch {
 public:
  explicit FragmentBatch(const TileState& tile);

  /// Adds runs of pixels of one triangle: one fragment per pixel, or one per sample.
  template <class Done>
  void add(const geometry::ScreenTriangle& triangle, const raster::PixelRun* runs, size_t count, const Done& done) {
    BatchTriangles& triangles = worker_.triangles;
    if (triangle.draw != draw_) begin(triangle.draw);
    if (triangles.count == max_triangles_) flush(triangle.draw, done);
    triangles.triangle[triangles.count++] = &triangle;
    const ShadingPoints points = shading_points(triangle);
    if (points.per_sample) {
      for (size_t i = 0; i < count; ++i) add_samples(triangle, points, runs[i], done);
    } else {
      add_pixels(triangle, points, runs, count, done);
    }
  }

  /// Shades the table if it holds fragments, and empties it.
  template <class Done>
  void flush(uint32_t draw, const Done& done) {
    if (worker_.workspace.fragments.count) {
      shade(draw);
      done(tile_.renderer.frame.draws[draw]);
    }
    worker_.workspace.fragments.count = 0;
    worker_.triangles.count = 0;
    worker_.runs.count = 0;
  }

 private:
  template <class Done>
  void add_samples(const geometry::ScreenTriangle& triangle, const ShadingPoints& points, const raster::PixelRun& run,
                   const Done& done) {
    for (uint16_t pixel = run.begin; pixel < run.end; ++pixel) {
      for (uint32_t mask = run.mask; mask; mask &= mask - 1) {
        const raster::PixelRun sample = {pixel, static_cast<uint16_t>(pixel + 1), mask & ~(mask - 1)};
        make_room(done);
        append(triangle, points, &sample, 1);
      }
    }
  }

  template <class Done>
  void add_pixels(const geometry::ScreenTriangle& triangle, const ShadingPoints& points, const raster::PixelRun* runs,
                  size_t count, const Done& done) {
    for (size_t i = 0, end; i < count; i = end) {
      size_t room = make_room(done);
      for (end = i; end < count && raster::length_of(runs[end]) <= room; ++end) room -= raster::length_of(runs[end]);
      append(triangle, points, runs + i, end - i);
      if (end < count && room > 0) add_split(triangle, points, runs[end++], done);
    }
  }

  template <class Done>
  void add_split(const geometry::ScreenTriangle& triangle, const ShadingPoints& points, raster::PixelRun run,
                 const Done& done) {
    for (size_t end = run.end; run.begin < end; run.begin = run.end) {
      run.end = static_cast<uint16_t>(std::min(end, run.begin + make_room(done)));
      append(triangle, points, &run, 1);
    }
  }

  /// Makes room for fragments of the latest triangle. Returns the number of free rows.
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

  void begin(uint32_t draw);
  ShadingPoints shading_points(const geometry::ScreenTriangle& triangle) const;
  uint32_t covered_samples(const ShadingPoints& points, size_t row) const;
  uint32_t samples_at(const ShadingPoints& points, const PixelEdges& edges) const;
  void move_to_centroid(const ShadingPoints& points, size_t row) const;
  void move_to_nearest(size_t begin, size_t end) const;
  void append(const geometry::ScreenTriangle& triangle, const ShadingPoints& points, const raster::PixelRun* runs,
              size_t count);
  void set_depths(const geometry::ScreenTriangle& triangle, const Draw& draw, const ShadingPoints& points, size_t begin,
                  size_t end);
  void shade(uint32_t draw);

  const TileState& tile_;
  Worker& worker_;
  // The draw whose triangles are added, and its properties.
  uint32_t draw_ = ~0u;
  size_t max_triangles_ = 0;
  bool per_sample_ = false, sets_depths_ = false, keeps_triangles_ = false;
};

}  // namespace shd::frame
