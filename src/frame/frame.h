// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: frame, (draws and lights -> film), the driver of all earlier stages.
///
/// Input:      Frame: a framebuffer, a view, checked draws and lights; or ShadowFrame: draws and one light.
/// Output:     the planes of the framebuffer, or the depth map of a Shadow; shd_render_stats.
/// Units:      positions in pixels of the picture, y down; times in seconds; memory in bytes.
/// Invariants: triangles take effect in the order of the draws, except with another visibility method or an
///             order-independent blend. Tiles are drawn concurrently and share no written data. The bits of the result
///             do not depend on passes, tiles, batches or workers.
///
/// A frame is drawn in passes of bounded size. Each pass transforms vertices, assembles, sorts and bins triangles
/// (Scene), then draws its tiles concurrently (TileRenderer): opaque runs fill the visibility buffer and are shaded
/// once; runs that blend or drop fragments are shaded triangle by triangle; unordered blends follow.
///
/// | file             | contents                                                              |
/// |------------------|-----------------------------------------------------------------------|
/// | frame.h          | Frame and Draw: a checked shd_render_desc; render()                   |
/// | passes.h         | the draws of a frame in passes that fit in memory                     |
/// | scene.h          | a pass after its geometry stages: vertices, triangles and bins        |
/// | visibility.h     | the order of painting, for frames without a depth test                |
/// | tile_renderer.h  | rendering of one tile, from its first draw to its last                |
/// | tile_state.h     | state of a tile while it is drawn                                     |
/// | worker.h         | memory of one worker for drawing tiles                                |
/// | fragment_batch.h | fragments gathered into the table that is shaded                      |
/// | texture_batch.h  | fragments whose colour is one lookup, without that table              |
/// | background.h     | the environment behind a frame                                        |
/// | opaque_pass.h    | draws that the visibility buffer resolves                             |
/// | blended_pass.h   | draws that blend in order or drop fragments                           |
/// | unordered_pass.h | draws whose blend is order-independent                                |
/// | volume_pass.h    | volumes over the finished draws                                       |
/// | bake.h           | frames in the space of texture coordinates                            |
/// | bake_pass.h      | texels of a tile of such a frame                                      |
/// | supersample.h    | frames averaged from a picture n times as large                       |
/// | shadow_map.h     | depth maps of lights, drawn as frames                                 |
/// | present.h        | finished tiles for the host                                           |
/// | stopwatch.h      | time spent in each stage                                              |
/// | stats.h          | sum of shd_render_stats                                               |
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
#include "shade/light_table.h"
#include "volume/rays.h"
#include "volume/volume.h"

namespace shd::frame {

/// A checked shd_draw, or one instance of it.
struct Draw {
  uint32_t index;     // in the caller's draws
  uint32_t instance;  // index of the instance in the draw
  const geometry::Mesh* mesh;
  const material::Material* material;  // null = only depth is drawn
  shd_frequency frequency;
  shd_cull cull;
  raster::DepthState depth;
  bool depth_falls;  // depth decreases with the distance from the eye
  bool sample_shading;
  bool affine;           // SHD_DRAW_AFFINE
  const void* uniforms;  // input of the material's programs
  geometry::Outline outline;
  uint32_t begin, end;  // triangles of the mesh
  float object_to_world[16];
};

/// Position of the framebuffer's first pixel in the picture.
struct Window {
  int32_t left, top;
};

/// A checked shd_volume_draw.
struct VolumeDraw {
  const volume::Volume* volume;
  volume::WorldToBox world_to_box;
};

struct Bake;

/// A checked shd_render_desc.
struct Frame {
  film::Framebuffer* framebuffer;
  Window window;
  geometry::Viewport viewport;
  geometry::PixelBox scissor;  // pixels of the picture
  shd_view view;
  bool load;  // keeps the planes of the framebuffer; otherwise they are cleared
  float clear_color[4];
  float clear_depth;
  const Draw* draws;
  size_t draw_count;
  const light::Light* const* lights;
  size_t light_count;
  const light::Shadow* const* shadows;  // [light_count], or null
  shade::EnvironmentLight environment;
  shd_background background;
  float background_roughness;
  shd_progress progress;
  shd_present present;      // receives finished tiles; shadow maps have none
  uint32_t pass_triangles;  // upper bound of the triangles of a pass
  uint32_t supersampling;   // 0 and 1 = off
  bool counts_hidden;       // counts samples that fail the depth test before shading
  shd_visibility visibility;
  bool counts_conflicts;      // counts errors in the order of painting
  const VolumeDraw* volumes;  // blended over the finished draws, in order
  size_t volume_count;
  Bake* bake;  // null except in bakes: see bake.h
};

/// Renders a frame on the context's executor, pass by pass; frame.supersampling is ignored. Throws Failure and
/// std::bad_alloc; then the framebuffer may hold a part of the frame.
void render(const core::Context& context, const Frame& frame, shd_render_stats* stats);

}  // namespace shd::frame
