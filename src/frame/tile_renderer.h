// SPDX-License-Identifier: MIT
#pragma once

#include "film/sample_store.h"
#include "frame/background.h"
#include "frame/frame.h"
#include "frame/scene.h"
#include "frame/worker.h"
#include "shade/light_table.h"

namespace shd::frame {

/// Draws the tiles of one pass.
struct TileRenderer {
  const core::Context& context;
  const Frame& frame;
  const Scene& scene;
  const shade::LightTable& lights;
  const Background& background;
  film::SampleStore* samples;  // null with one pass or one sample per pixel
  const shd_present* present;  // null except in the last pass of a frame that is presented

  /// Draws one tile; draws take effect in order. Opaque draws are written to the visibility buffer, which is shaded
  /// before a draw that reads colours, and at the end. Draws that blend are shaded triangle by triangle.
  /// Order-independent blends come last. Throws Failure and std::bad_alloc.
  void render(uint32_t index, Worker* worker) const;
};

}  // namespace shd::frame
