// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/render.h>

#include "core/context.h"
#include "geometry/vertex.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "raster/varyings.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// What the fragments of one draw are shaded with.
struct DrawShading {
  const geometry::Vertices* vertices;
  const material::Material* material;
  shd_frequency frequency;
  float orientation;  // of the draw's matrix
  uint32_t draw;      // index in the frame
  uint32_t instance;  // index in the draw
  uint32_t wanted;    // raster::Interpolated: columns of the fragments to be made whether shading needs them or not
  const void* uniforms;
};

/// Scratch of one worker.
struct Workspace {
  raster::Fragments fragments;  // count, pixel, triangle, x, y and depth come filled in
  raster::Fragments rows;       // corners or centroids
  raster::Varyings varyings;    // of the fragments at Phong frequency, else of the rows
  Columns columns;
  core::Array<uint32_t> reaching;   // [padded] lights of a batch, by index in their table
  core::Array<ActiveLight> active;  // [padded] the same
};

/// What workspaces need room for.
struct WorkspaceSize {
  uint32_t varying_count;
  uint32_t targets;  // bit t: there is target t; bit 0, colour, is set
  size_t light_count;
};

/// Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, const WorkspaceSize& size, Workspace* out);

/// Most triangles that one batch may hold at Gouraud frequency: their corners must fit a table.
constexpr size_t kGouraudTriangles = raster::kBatch / 3;

/// Shades workspace->fragments (at most raster::kBatch rows, or kGouraudTriangles runs of one triangle) into
/// workspace->columns.radiance. Runs on the calling thread. Throws Failure if a program threw.
void shade_batch(const core::SimdTarget& simd, const DrawShading& shading, const LightTable& lights,
                 const shd_view& view, Workspace* workspace);

}  // namespace shd::shade
