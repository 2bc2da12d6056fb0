// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "tool/draws.h"

/// The draws that the samples of each pixel show.
struct Samples {
  struct Other {
    uint32_t pixel, draw, count;
  };
  uint32_t per_pixel = 1;
  std::vector<uint32_t> draw;   // [height][width] draw of the first sample, 0xffffffff = nothing
  std::vector<uint32_t> count;  // [height][width] samples that show it
  std::vector<Other> others;    // by pixel, then by draw
};

/// Draws the scene without light, once for each sample of a pixel: each of the n x n parts of a pixel has the samples
/// of shd_sample_position().
Samples draw_samples(shd_context* context, const Options& options, const shd_view& view, const Draws& draws);
