// SPDX-License-Identifier: MIT
#pragma once

#include "film/sample_store.h"
#include "frame/frame.h"
#include "frame/scene.h"
#include "frame/worker.h"
#include "shade/light_table.h"

namespace shd::frame {

/// What the tiles of a frame are drawn from.
struct TileRenderer {
  const core::Context& context;
  const Frame& frame;
  const Scene& scene;
  const shade::LightTable& lights;
  film::SampleStore* samples;  // null in a frame of one pass, or of one sample a pixel

  /// Draws one tile: draws take effect in order. Opaque ones go to the visibility buffer, and what it shows is shaded
  /// before a draw that must see colours, and at the end; the others are shaded triangle by triangle and blended.
  /// Blends without an order follow. Throws Failure and std::bad_alloc.
  void render(uint32_t index, Worker* worker) const;
};

}  // namespace shd::frame
