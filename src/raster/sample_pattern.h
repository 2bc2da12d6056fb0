// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geometry/assemble.h"

namespace shd::raster {

/// Position of a sample in its pixel, in 1 / geometry::kSubpixels from the top left corner.
struct SamplePoint {
  int32_t x, y;
};

constexpr uint32_t kMaxSamples = 16;

/// Sum of the positions of some samples of a pixel.
struct PointSum {
  int32_t x, y, count;
};

/// A PointSum of up to eight samples, in less memory.
struct PartialSum {
  int16_t x, y, count;
};

/// The sample positions of a pixel, in the order of the standard: the table "Standard sample locations" of the Vulkan
/// 1.3 specification, section "Multisampling", which is D3D11_STANDARD_MULTISAMPLE_PATTERN.
struct SamplePattern {
  uint32_t count;
  SamplePoint point[kMaxSamples];
  geometry::SampleExtent extent;
  PartialSum sum[2][256];  // [0] for the lower eight bits of a mask, [1] for the upper

  // Lane i of a vector, with the samples of pixel 0, pixel 1 and so on of a row.
  int32_t x[kMaxSamples], y[kMaxSamples];             // position in its pixel
  int32_t column[kMaxSamples];                        // number of its pixel
  double pixel_x[kMaxSamples], pixel_y[kMaxSamples];  // x and y in pixels
};

inline PointSum sum_of_points(const SamplePattern& pattern, uint32_t mask) {
  const PartialSum &low = pattern.sum[0][mask & 255], &high = pattern.sum[1][mask >> 8];
  return {low.x + high.x, low.y + high.y, low.count + high.count};
}

/// @param count  1, 2, 4, 8 or 16
const SamplePattern& sample_pattern(uint32_t count);

}  // namespace shd::raster
