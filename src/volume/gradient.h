// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "shade/light_table.h"
#include "shade/run.h"
#include "volume/rays.h"

namespace shd::volume {

struct Volume;

/// Lights and scratch memory for shading the points of a volume.
struct PointShading {
  const shade::LightTable& lights;
  const WorldToBox& box;
  shade::Workspace* workspace;
};

/// Points of rays, as columns.
struct Points {
  size_t count;
  const float *u, *v, *w;  // in the box
  const float* opacity;    // points of opacity 0 are left out
  const uint32_t *ray, *step;
  const Ray* rays;
  float* color[3];  // diffuse colour; becomes radiance
};

/// Points that are shaded together.
constexpr size_t kShadedPoints = 256;

struct GradientScratch {
  uint32_t point[kShadedPoints];
  alignas(64) float place[3][6 * kShadedPoints];
  alignas(64) float density[6 * kShadedPoints];
};

/// Shades points with the material of a volume.
void shade(const core::SimdTarget& simd, const Volume& volume, const PointShading& shading, const Points& points,
           GradientScratch* scratch);

}  // namespace shd::volume
