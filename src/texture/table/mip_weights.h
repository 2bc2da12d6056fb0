// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/mip.h>

#include "core/allocator.h"

namespace shd::texture {

/// Returns the texel that index i reads on an axis of n texels, or -1 if it reads no texel.
int64_t wrapped(shd_wrap wrap, int64_t i, int64_t n);

/// Source texels and weights of each level texel along one axis.
struct AxisWeights {
  core::Array<size_t> first;    // [size + 1] taps of level texel i are first[i]..first[i + 1] - 1
  core::Array<uint32_t> texel;  // source texel of each tap, wrapped
  core::Array<double> weight;   // weight of each tap, not 0
  double total;                 // sum of the weights of a level texel
};

/// Computes the weights of a level of `size` texels from a source of `source_size` >= size texels. Weights of the box
/// are the integer shared areas, so that sums of integers stay exact.
AxisWeights make_axis_weights(const core::Allocator& allocator, shd_mip_kernel kernel, shd_wrap wrap,
                              uint32_t source_size, uint32_t size);

}  // namespace shd::texture
