// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "shade/run.h"
#include "volume/gradient.h"
#include "volume/rays.h"
#include "volume/volume.h"

namespace shd::volume {

/// Rays in a batch, and the steps that each takes in one round.
constexpr size_t kRays = 128, kRoundSteps = 8, kRoundSamples = kRays * kRoundSteps;

/// The steps of one round, next to each other for each ray.
struct RoundSamples {
  alignas(64) float u[kRoundSamples], v[kRoundSamples], w[kRoundSamples];  // in the box
  alignas(64) float dt[kRoundSamples];
  alignas(64) float density[kRoundSamples];
  alignas(64) float opacity[kRoundSamples], color[3][kRoundSamples];
  uint32_t ray[kRoundSamples];
  uint32_t step[kRoundSamples];
};

/// Memory of one worker.
struct March {
  size_t count;  // rays in use
  Ray ray[kRays];
  float color[kRays][4];  // results: r, g, b and opacity, premultiplied
  uint32_t next[kRays];   // next step of the ray
  uint16_t active[kRays];
  RoundSamples samples;
  GradientScratch gradient;
};

/// Marches `march->count` rays. `shading` is null for a volume without a material. Throws Failure.
void march(const core::SimdTarget& simd, const Volume& volume, const PointShading* shading, March* march);

}  // namespace shd::volume
