// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "tool/draws.h"
#include "tool/picture.h"

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

/// The view that shows a window of a picture alone, as the whole picture.
shd_view window_view(const Options& options, const shd_view& view, double left, double top, double width,
                     double height);

/// Places of the samples in a pixel, in pixels from its upper left corner: each of the n x n parts of a pixel has the
/// samples of shd_sample_position().
std::vector<PicturePoint> sample_places(const Options& options);

/// Draws the scene without light, once for each sample of a pixel, with planes that have the values of this sample.
/// @param visit  gets the number of the sample and the framebuffer, of one sample a pixel
void visit_samples(shd_context* context, const Options& options, const shd_view& view, const Draws& draws,
                   shd_aov_flags aovs, const std::function<void(size_t, const shd_framebuffer*)>& visit);

Samples draw_samples(shd_context* context, const Options& options, const shd_view& view, const Draws& draws);
