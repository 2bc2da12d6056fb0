// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::image {

/// Offset of an ordered dither, in (0, 1), added to code + fraction before truncation: at (x, y) the point of the R2
/// sequence, whose neighbours differ much and whose sums over any area are even (Roberts, "The Unreasonable
/// Effectiveness of Quasirandom Sequences", 2018). Needs no state and has the same bits on every machine.
inline double dither_threshold(uint32_t x, uint32_t y) {
  // 2^32 / p and 2^32 / p^2, of the plastic number p = 1.3247...: p^3 = p + 1.
  const uint32_t point = 0x80000000u + 3242174889u * x + 2447445414u * y;
  return (point + 0.5) * 0x1p-32;
}

}  // namespace shd::image
