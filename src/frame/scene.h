// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "frame/frame.h"
#include "geometry/vertex.h"
#include "raster/bin.h"

namespace shd::frame {

/// A pass after its geometry stages: the input of its tiles.
struct Scene {
  /// Creates an empty scene. Throws std::bad_alloc.
  Scene(const core::Allocator& allocator, const Frame& frame);

  core::Objects<geometry::Vertices> vertices;   // [draw]
  core::Array<geometry::Transform> transforms;  // [draw]
  core::Objects<raster::TriangleGroup> groups;  // in submission order, or in the order of painting
  raster::Bins bins;
};

/// window_box(): the pixels of the picture that the framebuffer holds. visible_box(): the subset that triangles may
/// change. Both may be empty.
geometry::PixelBox window_box(const Frame& frame);
geometry::PixelBox visible_box(const Frame& frame);

/// Transforms, assembles, orders and bins every draw of a frame on the executor. Throws Failure and std::bad_alloc.
void prepare(const core::Context& context, const Frame& frame, Scene* scene, shd_render_stats* stats);

}  // namespace shd::frame
