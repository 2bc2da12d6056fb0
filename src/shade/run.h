// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/render.h>

#include "core/context.h"
#include "geometry/mesh.h"
#include "geometry/vertex.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// What the fragments of one draw are shaded with.
struct DrawShading {
  const geometry::Mesh* mesh;
  const geometry::Vertices* vertices;
  const material::Material* material;
  shd_frequency frequency;
  float orientation;  // of the draw's matrix
  uint32_t draw;      // index in the frame
  uint32_t instance;  // index in the draw
};

/// Scratch of one worker.
struct Workspace {
  raster::Fragments fragments;  // count, pixel, triangle, x, y and depth come filled in
  raster::Fragments rows;       // corners or centroids
  Columns columns;
};

/// Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, Workspace* out);

/// Most triangles that one batch may hold at Gouraud frequency: their corners must fit a table.
constexpr size_t kGouraudTriangles = raster::kBatch / 3;

/// Shades workspace->fragments (at most raster::kBatch rows, or kGouraudTriangles runs of one triangle)
/// into workspace->columns.radiance. Runs on the calling thread.
void shade_batch(const core::SimdTarget& simd, const DrawShading& shading, const LightTable& lights, const float eye[3],
                 Workspace* workspace);

}  // namespace shd::shade
