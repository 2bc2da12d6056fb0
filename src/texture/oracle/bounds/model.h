// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/bounds.h>

#include "texture/oracle/bounds/range.h"
#include "texture/texture.h"

namespace shd::texture {

/// A checked shd_bounds_desc in doubles.
struct BoundsModel {
  uint32_t level_rules;
  double subtexel, level_step, weight;  // 2^-bits; `weight` 0 = exact
  double result_step;                   // half a unit of a rounded result, or 0
  double coordinate_error, derivative_error, level_error, relative_error;
  Range srgb[256];  // linear values of each code
};

/// Makes the model of a checked desc.
BoundsModel make_bounds_model(const shd_bounds_desc& desc);

/// Returns the desc of checked rules.
shd_bounds_desc preset_of(shd_rules rules);

}  // namespace shd::texture
