// SPDX-License-Identifier: MIT
#pragma once

#include "frame/fragment_batch.h"
#include "frame/tile_state.h"
#include "raster/edge.h"

namespace shd::frame {

/// Shades a run whose material blends or drops fragments, and blends it over the colours, triangle by triangle.
void blend_run(TileState* tile, const Run& run);

/// A shaded fragment that passes the tests, and the samples at which it passes.
struct Survivor {
  uint32_t pixel, mask;
  float depth[raster::kMaxSamples];  // valid for the samples in the mask
  film::FragmentColor color;
};

/// The late tests of the fragments of a shaded batch: alpha, discard and depth.
class Survival {
 public:
  Survival(const Draw& draw, TileState* tile)
      : draw_(draw), tile_(*tile), test_(raster::depth_test(draw.depth.compare)) {}

  /// Whether any samples of a row pass alpha, discard and depth test. Must be called once for each row, in order.
  bool survives(size_t row, Survivor* out);

 private:
  uint32_t kept_samples(size_t row, film::FragmentColor* color) const;

  const Draw& draw_;
  TileState& tile_;
  const raster::DepthTest test_;
  const geometry::ScreenTriangle* triangle_ = nullptr;  // triangle of the latest row
  raster::DepthPlane plane_[raster::kMaxSamples];       // its depth planes, by sample
};

/// Lists in worker.covered the pixels where the depth of one triangle may pass.
void cover_triangle(TileState* tile, const Draw& draw, const geometry::PixelBox& box,
                    const geometry::ScreenTriangle& triangle);

/// Shades the fragments of a run in a box and calls done(draw) after each shaded batch.
template <class Done>
void shade_run(TileState* tile, const Run& run, const geometry::PixelBox& box, const Done& done) {
  FragmentBatch batch(*tile);
  for (size_t i = 0; i < run.count; ++i) {
    const geometry::ScreenTriangle& triangle = run.triangles[run.entries[i]];
    cover_triangle(tile, tile->draw_of(run), box, triangle);
    const core::Buffer<raster::PixelRun>& covered = tile->worker.covered;
    if (covered.size()) batch.add(triangle, covered.data(), covered.size(), done);
  }
  batch.flush(run.draw, done);
}

}  // namespace shd::frame
