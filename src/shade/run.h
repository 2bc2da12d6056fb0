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

/// Inputs of the shading of one draw.
struct DrawShading {
  const geometry::Vertices* vertices;
  const material::Material* material;
  shd_frequency frequency;
  float orientation;  // sign of the draw's matrix: -1 if it mirrors, otherwise 1
  uint32_t draw;      // index in the frame
  uint32_t instance;  // index in the draw
  uint32_t wanted;    // raster::Interpolated bits of columns that are filled even if shading does not read them
  const void* uniforms;
  const float* object_to_world;  // [16] of the draw
  bool keeps_sides = false;      // no triangle is seen from behind, so two-sided materials keep their normals
};

/// Scratch of one worker.
struct Workspace {
  raster::Fragments fragments;  // the caller fills count, pixel, triangle, x, y and depth
  raster::Fragments points;     // corners or centroids
  raster::Varyings varyings;    // at the fragments at Phong frequency, otherwise at the points
  Columns columns;
  size_t nonfinite = 0;             // fragments of the latest batch whose colour has a channel that is not finite
  core::Array<uint32_t> affecting;  // [padded] table indices of the lights that affect a batch
  core::Array<ActiveLight> active;  // [padded] these lights, with the factors of their cookies and shadows
};

/// Capacities of a workspace.
struct WorkspaceSize {
  uint32_t varying_count;
  uint32_t targets;  // bit t is set if target t exists; bit 0, colour, is set
  size_t light_count;
};

/// Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, const WorkspaceSize& size, Workspace* out);

/// Largest number of triangles in a batch at Gouraud frequency: one table must hold all their corners.
constexpr size_t kGouraudTriangles = raster::kBatch / 3;

/// Shades workspace->fragments (at most raster::kBatch, or kGouraudTriangles runs of one triangle) into
/// workspace->columns.radiance. Runs on the calling thread. Throws Failure if a program threw.
void shade_batch(const core::SimdTarget& simd, const DrawShading& shading, const LightTable& lights,
                 const shd_view& view, Workspace* workspace);

/// Shades workspace->points, whose position, normal and wo are set up to the next whole vector, by a model with lobes
/// and without slots. workspace->columns.slot of SHD_SLOT_DIFFUSE multiplies the diffuse colour. The result is in
/// workspace->columns.point_radiance.
void shade_points(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
                  Workspace* workspace);

}  // namespace shd::shade
