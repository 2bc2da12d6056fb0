// SPDX-License-Identifier: MIT
#pragma once

#include "shapes/sink.h"

namespace shd::shapes {

/// Coordinate at fraction i / n of a side of length `size` that is centred at 0. Mirrored i give mirrored bits.
inline double along(double size, uint32_t i, uint32_t n) {
  return size * ((2.0 * i - n) / (2.0 * n));
}

/// Writes the triangles of rows x columns quadrilaterals over (rows + 1) x (columns + 1) vertices from `first` on, row
/// by row. They are counter-clockwise if rows run down and columns to the right.
inline void add_grid(Sink& out, uint32_t first, uint32_t rows, uint32_t columns) {
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t column = 0; column < columns; ++column) {
      const uint32_t a = first + row * (columns + 1) + column, b = a + columns + 1;
      add_triangle(out, a, b, b + 1);
      add_triangle(out, a, b + 1, a + 1);
    }
  }
}

}  // namespace shd::shapes
