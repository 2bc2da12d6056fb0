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

/// The samples of a pixel; one lies in the middle, more at the standard positions of Direct3D and Vulkan (Vulkan 1.3
/// specification, "Multisampling").
struct SamplePattern {
  uint32_t count;
  SamplePoint point[kMaxSamples];
  geometry::SampleExtent extent;
};

/// Of 1, 2, 4, 8 or 16 samples.
const SamplePattern& sample_pattern(uint32_t count);

}  // namespace shd::raster
