// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "frame/frame.h"
#include "geometry/vertex.h"
#include "raster/bin.h"

namespace shd::frame {

/// A frame after its geometry stages: what tiles are drawn from.
struct Scene {
  /// Empty; throws std::bad_alloc.
  Scene(const core::Allocator& allocator, const Frame& frame);

  core::Objects<geometry::Vertices> vertices;   // [draw]
  core::Array<geometry::Transform> transforms;  // [draw]
  core::Objects<raster::TriangleGroup> groups;  // in submission order, or that of painting
  raster::Bins bins;
};

/// Pixels of the picture that the framebuffer holds, and those of them that triangles may change (none if it is empty).
geometry::PixelBox window_box(const Frame& frame);
geometry::PixelBox visible_box(const Frame& frame);

/// Transforms, assembles, orders and bins every draw of a frame on the executor. Throws.
void prepare(const core::Context& context, const Frame& frame, Scene* scene, shd_render_stats* stats);

}  // namespace shd::frame
