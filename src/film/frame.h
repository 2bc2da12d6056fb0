// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/render.h>

#include "core/context.h"
#include "film/framebuffer.h"
#include "geometry/assemble.h"
#include "geometry/mesh.h"
#include "geometry/pixel_box.h"
#include "geometry/vertex.h"
#include "light/light.h"
#include "light/shadow.h"
#include "material/material.h"
#include "raster/coverage.h"

namespace shd::film {

/// A checked shd_draw, or one instance of it.
struct Draw {
  uint32_t index;     // of the caller's draw
  uint32_t instance;  // of that
  const geometry::Mesh* mesh;
  const material::Material* material;  // null = depth alone
  shd_frequency frequency;
  shd_cull cull;
  raster::DepthState depth;
  bool depth_falls;  // with the distance
  bool sample_shading;
  const void* uniforms;  // of the programs of the material
  geometry::Outline outline;
  uint32_t begin, end;  // triangles of the mesh
  float object_to_world[16];
};

/// Where the framebuffer's first pixel lies in the picture.
struct Window {
  int32_t left, top;
};

/// A checked shd_render_desc.
struct Frame {
  Framebuffer* framebuffer;
  Window window;
  geometry::Viewport viewport;
  geometry::PixelBox scissor;  // of the picture
  shd_view view;
  bool keep;
  float clear_color[4];
  float clear_depth;
  const Draw* draws;
  size_t draw_count;
  const light::Light* const* lights;
  size_t light_count;
  const light::Shadow* const* shadows;  // [light_count], or null
  shd_progress progress;
  uint32_t pass_triangles;  // most that are assembled at a time
  uint32_t supersampling;   // 0 and 1 = off
  bool counts_hidden;       // samples that fail the depth test before shading
  shd_visibility visibility;
  bool counts_conflicts;  // of the order of painting
};

/// Renders a frame on the context's executor, in passes: vertices, assembly and binning in groups of triangles, then
/// tiles. What triangles a pass has leaves no trace in the framebuffer.
/// Throws Failure and std::bad_alloc; then the framebuffer may hold part of the frame.
void render(const core::Context& context, const Frame& frame, shd_render_stats* stats);

}  // namespace shd::film
