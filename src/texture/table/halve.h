// SPDX-License-Identifier: MIT
/// @file
/// Averages of neighbouring texels, and weighted sums of rows: the parts that the builders of mip levels of 2D and 3D
/// textures share (mip.cpp, mip_slices.cpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/store/span.h"

namespace shd::texture {

/// Averages pairs of columns (or a single column) of two rows. The rows are `down` doubles apart; 0 for a single row.
template <size_t kChannels>
void halve_rows(const double* row, size_t down, uint32_t width, double* to) {
  const size_t right = width > 1 ? kChannels : 0;
  for (uint32_t x = 0; x < (width + 1) / 2; ++x, row += 2 * right) {
    for (size_t c = 0; c < kChannels; ++c) {
      *to++ = 0.25 * ((row[c] + row[c + right]) + (row[c + down] + row[c + right + down]));
    }
  }
}

/// Averages blocks of 2 x 2 texels of two stored rows. Both rows are the same if the height is 1.
template <class Codec>
void halve_texels(const uint8_t* top, const uint8_t* bottom, uint32_t width, double* to) {
  const size_t right = width > 1 ? Codec::kSize : 0;
  for (uint32_t x = 0; x < (width + 1) / 2; ++x, top += 2 * right, bottom += 2 * right) {
    double a[Codec::kChannels], b[Codec::kChannels], c[Codec::kChannels], d[Codec::kChannels];
    Codec::load(top, a);
    Codec::load(top + right, b);
    Codec::load(bottom, c);
    Codec::load(bottom + right, d);
    for (size_t i = 0; i < Codec::kChannels; ++i) *to++ = 0.25 * ((a[i] + b[i]) + (c[i] + d[i]));
  }
}

/// Adds the weighted sum of the texels of `span` in one stored row.
template <class Codec>
void add_row(const uint8_t* row, const AxisSpan& span, double weight, double* sum) {
  double value[Codec::kChannels], total[Codec::kChannels] = {};
  if (span.last > span.first + 1) {
    Codec::add(row + (size_t{span.first} + 1) * Codec::kSize, span.last - span.first - 1, total);
  }
  for (size_t c = 0; c < Codec::kChannels; ++c) total[c] *= span.full;
  Codec::load(row + size_t{span.first} * Codec::kSize, value);
  for (size_t c = 0; c < Codec::kChannels; ++c) total[c] += span.head * value[c];
  if (span.last > span.first) {
    Codec::load(row + size_t{span.last} * Codec::kSize, value);
    for (size_t c = 0; c < Codec::kChannels; ++c) total[c] += span.tail * value[c];
  }
  for (size_t c = 0; c < Codec::kChannels; ++c) sum[c] += weight * total[c];
}

}  // namespace shd::texture
