// SPDX-License-Identifier: MIT
#pragma once

#include "frame/fragment_batch.h"
#include "frame/tile_state.h"
#include "raster/edge.h"

namespace shd::frame {

/// Shades a run of a material that blends or drops fragments and blends it over the colours, triangle by triangle.
void blend_run(TileState* tile, const Run& run);

/// What remains of a shaded fragment.
struct Survivor {
  uint32_t pixel, mask;
  float depth[raster::kMaxSamples];  // of the samples in the mask
  film::FragmentColor color;
};

/// Decides what remains of the fragments of a shaded batch.
class Survival {
 public:
  Survival(const Draw& draw, TileState* tile)
      : draw_(draw), tile_(*tile), test_(raster::depth_test(draw.depth.compare)) {}

  /// Whether a row keeps samples after alpha, discard and the depths of now. Rows must come in order, each once.
  bool survives(size_t row, Survivor* out);

 private:
  uint32_t kept_samples(size_t row, film::FragmentColor* color) const;

  const Draw& draw_;
  TileState& tile_;
  const raster::DepthTest test_;
  const geometry::ScreenTriangle* triangle_ = nullptr;  // of the latest row
  raster::DepthPlane plane_[raster::kMaxSamples];       // its depths, by sample
};

/// Finds the covered samples of one triangle whose depth may pass, in the worker's list.
void cover_triangle(TileState* tile, const Draw& draw, const geometry::PixelBox& box,
                    const geometry::ScreenTriangle& triangle);

/// Shades what a run covers in a box; done(draw) sees batches.
template <class Done>
void shade_run(TileState* tile, const Run& run, const geometry::PixelBox& box, const Done& done) {
  FragmentBatch batch(*tile);
  for (size_t i = 0; i < run.count; ++i) {
    const geometry::ScreenTriangle& triangle = run.triangles[run.entries[i]];
    cover_triangle(tile, tile->draw_of(run), box, triangle);
    const core::Buffer<raster::VisiblePixel>& covered = tile->worker.covered;
    if (covered.size()) batch.add(triangle, covered.data(), covered.size(), done);
  }
  batch.flush(run.draw, done);
}

}  // namespace shd::frame
