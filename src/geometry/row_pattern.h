// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace shd::geometry {

/// Subdivision of a triangle into rows, from an apex to the base, which is the side with the fewest parts. Row r joins
/// a place on the left side to a place on the right side and has its own number of parts. Row 0 is the apex, the last
/// row is the base. For sides with equal numbers of parts the result is the regular grid.
class RowPattern {
 public:
  /// @param segments  parts of the three sides; side k goes from corner k to the next
  explicit RowPattern(const uint32_t segments[3]) {
    base_side = segments[1] <= segments[2] ? 1 : 2;
    if (segments[0] < segments[base_side]) base_side = 0;
    base = segments[base_side];
    right = segments[(base_side + 1) % 3];
    left = segments[(base_side + 2) % 3];
    rows = left > right ? left : right;
  }

  uint32_t apex_corner() const { return (base_side + 2) % 3; }

  /// Places on the sides are counted from the apex. Both sides leave the apex with the first row, so that only the base
  /// lies along a side.
  uint32_t left_place(uint32_t row) const { return place(row, left); }
  uint32_t right_place(uint32_t row) const { return place(row, right); }

  uint32_t parts(uint32_t row) const {
    if (row == 0 || row == rows) return row ? base : 0;
    const uint32_t rounded = (2 * base * row + rows) / (2 * rows);
    return rounded > 1 ? rounded : 1;
  }

  /// Triangles between a row and the next one.
  uint32_t strip_triangles(uint32_t row) const {
    return parts(row) + parts(row + 1) - (left_place(row) == left_place(row + 1)) -
           (right_place(row) == right_place(row + 1));
  }

  size_t triangle_count() const {
    size_t sum = 0;
    for (uint32_t row = 0; row < rows; ++row) sum += strip_triangles(row);
    return sum;
  }
  /// Vertices inside the triangle, on no side.
  size_t inner_count() const {
    size_t sum = 0;
    for (uint32_t row = 1; row < rows; ++row) sum += parts(row) - 1;
    return sum;
  }

  uint32_t base_side, base, left, right, rows;

 private:
  uint32_t place(uint32_t row, uint32_t side) const { return (row * side + rows - 1) / rows; }
};

}  // namespace shd::geometry
