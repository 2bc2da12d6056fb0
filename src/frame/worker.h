// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/render.h>

#include "core/context.h"
#include "film/aovs.h"
#include "film/tile_color.h"
#include "film/unordered.h"
#include "frame/frame.h"
#include "geometry/assemble.h"
#include "raster/coverage.h"
#include "raster/fragments.h"
#include "raster/nearest.h"
#include "shade/run.h"
#include "volume/march.h"

namespace shd::frame {

/// The triangles that a batch of fragments belongs to.
struct BatchTriangles {
  size_t count = 0;
  const geometry::ScreenTriangle* triangle[raster::kBatch];
  uint16_t of[raster::kBatch];  // [fragment] index into `triangle`; unused for is_plain() materials
};

/// The rows of a batch as runs, in order: rows of a run are consecutive.
struct BatchRuns {
  size_t count = 0;
  raster::PixelRun run[raster::kBatch];
};

/// Memory in which one worker draws tiles, allocated with its first tile.
struct Worker {
  uint32_t index;
  raster::Tile tile;
  raster::TileOrder order;
  raster::CoverMask mask;                               // mask of the latest triangle
  core::Buffer<raster::PixelRun> covered;               // pixels of one blended triangle
  core::Buffer<const geometry::ScreenTriangle*> slots;  // [slot] triangle
  film::SplitSamples split;
  film::ColorBlock color;
  shade::Workspace workspace;
  BatchTriangles triangles;
  BatchRuns runs;
  film::Unordered unordered;
  film::AovScratch aovs;
  core::Array<volume::March> march;               // one if the frame has volumes
  core::Array<raster::NearestTriangles> nearest;  // one in bakes
  uint64_t fragments = 0, nonfinite_fragments = 0, hidden_samples = 0;
};

/// The workers by index. Owns them.
class Workers {
 public:
  Workers(const core::Context& context, const Frame& frame);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Throws std::bad_alloc.
  Worker& get(uint32_t index);
  void count(shd_render_stats* stats) const;

 private:
  const core::Context& context_;
  const film::Framebuffer& framebuffer_;
  const size_t light_count_;
  const bool has_volumes_, is_bake_;
  uint32_t varying_count_ = 0;  // maximum over all draws
  core::Array<Worker*> workers_;
};

}  // namespace shd::frame
