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
#include "shade/run.h"

namespace shd::frame {

/// The triangles behind a batch of fragments.
struct BatchTriangles {
  size_t count = 0;
  const geometry::ScreenTriangle* triangle[raster::kBatch];
  uint16_t of[raster::kBatch];  // index of a fragment's triangle; unused for is_plain() materials
};

/// The memory in which one worker draws tiles, allocated with its first tile.
struct Worker {
  raster::Tile tile;
  raster::TileOrder order;
  raster::CoverMask mask;                               // of the latest triangle
  core::Buffer<raster::VisiblePixel> covered;           // of one triangle that is blended
  core::Buffer<const geometry::ScreenTriangle*> slots;  // triangles behind the tile's slots
  film::SplitSamples split;
  shade::Workspace workspace;
  BatchTriangles triangles;
  film::Unordered unordered;
  film::AovScratch aovs;
  uint64_t fragments = 0, nonfinite_fragments = 0, hidden_samples = 0;
};

/// Workers by index; owns them.
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
  const uint32_t samples_, targets_;
  const size_t light_count_;
  uint32_t varying_count_ = 0;  // largest of all draws
  core::Array<Worker*> workers_;
};

}  // namespace shd::frame
