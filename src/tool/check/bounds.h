// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "tool/check/textures.h"

/// Smallest and largest legal values of each channel.
struct Bounds {
  std::array<std::vector<float>, 4> low, high;
};

/// The sampler of a case, with the probes and levels of its API. Throws Failure.
Sampler make_sampler(shd_context* context, const Case& judged);

/// Bounds of all rows of a case. Throws Failure.
Bounds find_bounds(Textures& textures, const Case& judged);

/// Distance of a result from its bounds, 0 = legal. Infinite for NaN, which only infinite bounds make legal.
float excess(const Case& judged, const Bounds& bounds, size_t place, size_t channel);

/// The channel of a row that is farthest outside, or -1 if all are legal.
int worst_channel(const Case& judged, const Bounds& bounds, size_t place);
