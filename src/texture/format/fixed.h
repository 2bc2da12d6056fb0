// SPDX-License-Identifier: MIT
/// @file
/// Quads in fixed point, for SHD_PRECISION_FAST. A weight is a whole number of units of 2^-13, and the four weights of a
/// quad have the sum kWeightOne:
///
///   w11 = (s t + 2^12) >> 13    w10 = s - w11    w01 = t - w11    w00 = 2^13 - s - t + w11
///
/// s and t are the fractions in the same units, rounded to nearest. The error of a quad is at most 2^-12 of the range of
/// its texels: 2^-14 for each fraction, and twice 2^-14 for w11. Sums of quads are integers, so they have one result in
/// any order. A lookup reads its rows one by one, each by one load of two texels, without gathers; it does not wait for
/// other lookups with more probes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/footprint/block.h"

namespace shd::texture {

struct TexelSource;
struct Texels;

constexpr int kWeightBits = 13;
constexpr int32_t kWeightOne = 1 << kWeightBits;

/// One quad of each lookup of a vector.
struct FixedQuad {
  alignas(64) int32_t upper[kMaxLanes], lower[kMaxLanes];  // left texels of both rows
  alignas(64) int32_t upper_weights[kMaxLanes], lower_weights[kMaxLanes];  // left | right << 16
  alignas(64) int32_t upper_right[kMaxLanes], lower_right[kMaxLanes];      // right texels, only if `split` has the bit
};

/// Quads of a vector of lookups, which go into one or two sums. All quads of a sum have the same share in it.
struct FixedQuads {
  static constexpr size_t kRows = 16;  // more probes are summed 16 by 16

  size_t rows = 0;        // rows in use: quads of one sum
  bool two_sums = false;  // quad[2 k + 1] goes into the second sum
  uint32_t split = 0;     // bits of quads whose right texels are not all next to the left ones, or have weight 0
  alignas(64) int32_t count[kMaxLanes];  // rows of each lookup, at most `rows`
  FixedQuad quad[2 * kRows];             // of sum 0 at 2 k, of sum 1 at 2 k + 1
};

/// Sums over the quads of each lookup.
struct FixedSums {
  alignas(64) int32_t sum[2][kMaxLanes][4];
  // Formats whose sums do not give equal texels back also keep the first texel and the bits that differ from it.
  alignas(64) uint32_t first[2][kMaxLanes], differing[2][kMaxLanes];
};

/// What a vector of lookups needs to make its results of its sums.
struct FixedAverage {
  alignas(64) float probes[kMaxLanes];    // quads in each sum
  alignas(64) float fraction[kMaxLanes];  // share of the second sum; unused without it
  bool two_sums;
};

/// Adds the quads of `lanes` lookups to their sums, which begin at 0 if `first`.
using SumFixed = void (*)(const TexelSource& source, const FixedQuads& quads, size_t lanes, bool first,
                          FixedSums* sums);

/// Writes the wanted columns of up to `count` lookups, at most one vector.
using StoreFixed = void (*)(const FixedSums& sums, const FixedAverage& average, size_t count, const Texels& out);

/// The fixed-point kernels of a format on one target; null if it has none.
struct FixedKernels {
  SumFixed sum;
  StoreFixed store;
};

}  // namespace shd::texture
