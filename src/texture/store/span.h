// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::texture {

/// Base texels under texel `index` of an axis of `level` texels, and their weights. The unit of the weights is a base
/// texel divided by `level`, so that all weights are integers with the sum `base`.
struct AxisSpan {
  uint32_t first, last;     // inclusive
  double head, full, tail;  // weight of the first texel, of an inner texel and of the last texel

  AxisSpan(uint32_t index, uint32_t base, uint32_t level) {
    const uint64_t begin = uint64_t{index} * base, end = begin + base;
    first = static_cast<uint32_t>(begin / level);
    last = static_cast<uint32_t>((end - 1) / level);
    full = level;
    head = static_cast<double>((uint64_t{first} + 1) * level - begin);
    tail = static_cast<double>(end - uint64_t{last} * level);
    if (first == last) head = static_cast<double>(base);
  }

  /// Returns the weight of base texel x, first <= x <= last.
  double weight(uint32_t x) const { return x == first ? head : x == last ? tail : full; }
};

/// Texels first..end - 1 of one axis.
struct AxisRange {
  uint32_t first, end;

  uint32_t size() const { return end - first; }
};

/// Returns the texels of an axis of `level` texels that overlap `range` of an axis of `base` texels.
inline AxisRange level_range(AxisRange range, uint32_t base, uint32_t level) {
  return {static_cast<uint32_t>(uint64_t{range.first} * level / base),
          static_cast<uint32_t>((uint64_t{range.end} * level + base - 1) / base)};
}

/// A rectangle of texels.
struct Region {
  AxisRange x, y;
};

/// A box of texels.
struct Box {
  AxisRange x, y, z;
};

}  // namespace shd::texture
