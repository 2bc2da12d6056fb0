// SPDX-License-Identifier: MIT
/// Weights of polygons and polyhedra.
#pragma once
#include <cmath>
#include <vector>

#include "host.h"

namespace shd::fuzz {

/// The weights of a point are finite, and their sum is 1.
inline void check_sum(const std::vector<Column<float>>& columns, size_t point) {
  double sum = 0.0, size = 0.0;
  for (const Column<float>& column : columns) {
    const double weight = static_cast<double>(column[point]);
    SHD_FUZZ_CHECK(std::isfinite(weight));
    sum += weight;
    size += std::fabs(weight);
  }
  SHD_FUZZ_CHECK(std::fabs(sum - 1.0) <= 1e-4 * std::fmax(size, 1.0));
}

}  // namespace shd::fuzz
