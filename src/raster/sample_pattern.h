// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geometry/assemble.h"

namespace shd::raster {

/// Place of a sample in its pixel, in 1 / geometry::kSubpixels from the top left corner.
struct SamplePoint {
  int32_t x, y;
};

constexpr uint32_t kMaxSamples = 16;

/// Sum of some of a pixel's samples.
struct PointSum {
  int32_t x, y, count;
};

/// The samples of a pixel; one lies in the middle, more at the standard positions of Direct3D and Vulkan (Vulkan 1.3
/// specification, "Multisampling").
struct SamplePattern {
  uint32_t count;
  SamplePoint point[kMaxSamples];
  geometry::SampleExtent extent;
  PointSum sum[2][256];  // of the points in the lower and in the upper eight bits of a mask

  // The samples of pixel 0, pixel 1 and so on of a row.
  int32_t x[kMaxSamples], y[kMaxSamples];             // their places in their pixels
  int32_t column[kMaxSamples];                        // their pixels
  double pixel_x[kMaxSamples], pixel_y[kMaxSamples];  // x and y in pixels
};

inline PointSum sum_of_points(const SamplePattern& pattern, uint32_t mask) {
  const PointSum &low = pattern.sum[0][mask & 255], &high = pattern.sum[1][mask >> 8];
  return {low.x + high.x, low.y + high.y, low.count + high.count};
}

/// The pattern of 1, 2, 4, 8 or 16 samples.
const SamplePattern& sample_pattern(uint32_t count);

}  // namespace shd::raster
