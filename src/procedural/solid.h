// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/solid.h>

#include "core/simd_target.h"
#include "procedural/gradient_table.h"

namespace shd::procedural {

constexpr uint32_t kMaxOctaves = 32;

/// One octave of a sum.
struct Octave {
  float frequency;  // factor of places in cells
  float amplitude;  // the amplitudes of all octaves have the sum 1
  uint32_t seed;
};

/// A checked shd_solid_desc in the form that kernels read.
struct Solid {
  shd_solid kind;
  float size, inverse_size;  // edge of a cell
  Octave octave[kMaxOctaves];
  uint32_t octave_count;
  shd_solid_fade fade;
  bool is_turbulence;
  bool has_table;
  shd_solid_distance distance;
  float mean;        // mean value of one octave, which replaces octaves that are too fine
  float normalizer;  // factor of the noise
  float distortion;
  float low, color_scale;  // value of the first colour, and number of colour steps per unit of value
  uint32_t color_count;
  float color[4][SHD_MAX_SOLID_COLORS];
  GradientTable table;  // set if has_table
};

/// Fills `out` from a checked desc.
void build(const shd_solid_desc& desc, Solid* out) noexcept;

/// Places as packed columns; width may be null.
struct Places {
  size_t count;
  const float *x, *y, *z, *width;
};

/// Packed columns for values and gradients, which have all three components or none.
struct Values {
  float* value;
  float* gradient[3];
};

/// Evaluates a solid texture. Returns the number of places that are not finite.
size_t evaluate(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);

/// Finds the colours of values. Null columns are not wanted. No output may be `values`.
void find_colors(const Solid& solid, const core::SimdTarget& simd, const float* values, size_t count,
                 float* const out[4]);

/// Evaluates a solid texture to colours. Null columns are not wanted.
void evaluate_colors(const Solid& solid, const core::SimdTarget& simd, const Places& places, float* const out[4]);

/// The kernels, and those of the kinds; arguments as of evaluate().
size_t evaluate_stripes(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);
size_t evaluate_checker(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);
size_t evaluate_perlin(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);
size_t evaluate_perlin_table(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);
size_t evaluate_value(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);
size_t evaluate_simplex(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);
size_t evaluate_worley(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);
size_t evaluate_marble(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);
size_t evaluate_wood(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out);

}  // namespace shd::procedural
