// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include <shd/shd.h>

#include "tool/check/options.h"
#include "tool/check/table.h"

/// A texture with the sampler and the lookups that are judged.
struct Case {
  const shd_texture* texture;
  const shd_sampler* sampler;
  shd_lookups lookups;
  const std::vector<float>* result[4];  // null = not given
};

/// Bounds of the results that are given.
struct Bounds {
  std::vector<float> low[4], high[4];
};

/// Connects columns with lookups and results. `layers` receives the column `layer` as whole numbers. Throws Failure.
Case make_case(const Options& options, const Table& table, std::vector<uint32_t>* layers);

Bounds find_bounds(const Case& judged, const shd_bounds_desc& desc);

/// Returns the channel of a row that is farthest outside of its bounds, or -1 if all are legal. NaN is farthest.
int worst_channel(const Case& judged, const Bounds& bounds, size_t row);

/// Prints an illegal row: the result, its bounds, the nearest legal value, and the texels of shd's own lookup.
void describe(const Case& judged, const Bounds& bounds, size_t row, int channel);
