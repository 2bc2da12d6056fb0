// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/mip.h>

#include "core/allocator.h"

namespace shd::texture {

/// Which source texels each texel of a level reads along one axis.
struct AxisWeights {
  core::Array<size_t> first;    // [size + 1]: taps of level texel i are first[i]..first[i + 1] - 1
  core::Array<uint32_t> texel;  // source texel of a tap, wrapped
  core::Array<double> weight;   // not 0
  double total;                 // what the weights of a level texel sum to
};

/// Weights of a level of `size` texels from a source of `source_size` >= size. Those of the box are the integers
/// of the shared areas, so that sums of integers stay exact.
AxisWeights make_axis_weights(const core::Allocator& allocator, shd_mip_kernel kernel, shd_wrap wrap,
                              uint32_t source_size, uint32_t size);

}  // namespace shd::texture
