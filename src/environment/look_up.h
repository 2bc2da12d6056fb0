// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "environment/environment.h"

namespace shd::environment {

/// Packed columns of `count` directions of any length; one that is 0 or not finite counts as +Z.
struct LookUps {
  size_t count;
  const float* direction[3];
  const float* width;  // roughness of GGX lobes or exponent of Phong lobes; null = 0 and the radiance itself
};

/// Irradiance of surfaces whose normals are the directions.
void look_up_irradiance(const core::SimdTarget& simd, const Environment& environment, const LookUps& in,
                        float* const out[3]);

/// Mean radiance over lobes around the directions. Roughness is clamped to 0..1 and exponents to 0..1e6; NaN counts as
/// the widest lobe.
void look_up_radiance(const core::SimdTarget& simd, const Environment& environment, const LookUps& in,
                      float* const out[3]);
void look_up_ggx(const core::SimdTarget& simd, const Environment& environment, const LookUps& in, float* const out[3]);
void look_up_phong(const core::SimdTarget& simd, const Environment& environment, const LookUps& in,
                   float* const out[3]);

/// The radiance times `intensity` along lines of sight, blurred by a GGX lobe if `roughness` is above 0. in.width is
/// the precision of the map that a pixel resolves.
void look_up_view(const core::SimdTarget& simd, const Environment& environment, const LookUps& in, float roughness,
                  float intensity, float* const out[3]);

}  // namespace shd::environment
