// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::image {

/// Value of an IEEE 754 binary16, exact; a NaN keeps its payload in the upper bits and becomes quiet.
float half_to_float(uint16_t half);

/// Nearest binary16, ties to even; too large becomes infinity, NaN stays a quiet NaN of the same sign.
uint16_t float_to_half(float value);

}  // namespace shd::image
