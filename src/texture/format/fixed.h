// SPDX-License-Identifier: MIT
/// @file
/// Quads in fixed point, for SHD_PRECISION_FAST. A weight is an integer in units of 2^-14. The four weights of a quad
/// have the sum kWeightOne:
///
///   w11 = (s t + 2^14) >> 15            w10 = s - w11
///   w01 = ((2^14 - s) t + 2^14) >> 15   w00 = 2^14 - s - w01
///
/// The fractions s, in units of 2^-14, and t, in units of 2^-15, are rounded to nearest. The error of a quad is at most
/// 2^-13 of the range of its texels: 2^-15 for s, 2^-16 for t, and 2^-15 for each of w01 and w11. Integers have one sum
/// in any order, so targets may load texels in different ways.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/stream.h"

namespace shd::texture {

constexpr int kWeightBits = 14;
constexpr int32_t kWeightOne = 1 << kWeightBits;

/// Columns of a quad, one element for each lookup of the vector. A quad of a target with L lanes has 6 L elements.
enum FixedColumn : size_t {
  kUpper = 0,         // left texel of the upper row
  kLower = 1,         // left texel of the lower row
  kUpperWeights = 2,  // left | right << 16
  kLowerWeights = 3,
  kUpperRight = 4,  // right texels, for quads that are `split`
  kLowerRight = 5,
  kFixedColumns = 6
};

/// Quads of one vector of lookups, and what becomes of them. They go into one or two sums. All quads of a sum have the
/// same share in it.
struct FixedVector {
  const int32_t* quads;  // quads to be added: quad k of sum 0 is number 2 k, of sum 1 number 2 k + 1
  size_t rows;           // quads to be added to each sum
  size_t at;             // first lookup
  uint64_t split;        // bits of the quads whose right texels are not all next to the left ones, or have weight 0
  bool two_sums;
  bool one_quad;                              // each sum is one quad: `probes` is not set, and would be 1
  bool first;                                 // the sums begin with these quads
  alignas(64) int32_t count[kMaxLanes];       // rows of each lookup, at most `rows`
  alignas(64) float probes[kMaxLanes];        // quads of each lookup in each sum, those of earlier rows included
  alignas(64) float fraction[kMaxLanes];      // share of the second sum, if there are two
  alignas(64) int32_t sum[2][4 * kMaxLanes];  // in the order of fixed_sums-inl.h
};

}  // namespace shd::texture
