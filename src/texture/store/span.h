// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::texture {

/// Base texels under texel `index` of an axis of `level` texels, with their weights, which add up to `base`; the inner
/// ones weigh `full`. In units where a base texel is `level` long.
struct AxisSpan {
  uint32_t first, last;  // inclusive
  double head, full, tail;

  AxisSpan(uint32_t index, uint32_t base, uint32_t level) {
    const uint64_t begin = uint64_t{index} * base, end = begin + base;
    first = static_cast<uint32_t>(begin / level);
    last = static_cast<uint32_t>((end - 1) / level);
    full = level;
    head = static_cast<double>((uint64_t{first} + 1) * level - begin);
    tail = static_cast<double>(end - uint64_t{last} * level);
    if (first == last) head = static_cast<double>(base);
  }

  /// Weight of base texel x, first <= x <= last.
  double weight(uint32_t x) const { return x == first ? head : x == last ? tail : full; }
};

/// Texels of one axis.
struct AxisRange {
  uint32_t first, end;

  uint32_t size() const { return end - first; }
};

/// Texels, of an axis of `level` of them, of which a part lies over `range` of an axis of `base`.
inline AxisRange level_range(AxisRange range, uint32_t base, uint32_t level) {
  return {static_cast<uint32_t>(uint64_t{range.first} * level / base),
          static_cast<uint32_t>((uint64_t{range.end} * level + base - 1) / base)};
}

/// A rectangle of texels.
struct Region {
  AxisRange x, y;
};

}  // namespace shd::texture
