// SPDX-License-Identifier: MIT
/// The texels that the lookup of one pixel reads, with their weights and levels, and the arithmetic that repeats it.
#pragma once
#include <array>
#include <string>
#include <vector>

#include <shd.hpp>

#include "state.h"

namespace viewer {

/// A texel of the lookup on the plane of its level, where copies of the texture lie side by side.
struct Tap {
  shd_tap tap = {};
  int x = 0, y = 0;  // before wrapping, near the point of the lookup
};

/// The texels of a level around the lookup.
struct LevelView {
  uint32_t level_u = 0, level_v = 0, width = 1, height = 1;
  int x = 0, y = 0;             // texel of the first pixel, before wrapping
  int columns = 0, rows = 0;    // shown texels
  std::vector<uint8_t> pixels;  // [rows][columns][4], sRGB
  float share = 0.0f;           // sum of the weights of its taps
  float footprint[2][2] = {};   // longer and shorter half axis [texels of the level]
  float center[2] = {};         // point of the lookup [texels of the level]
};

struct Lookup {
  float u = 0, v = 0, dudx = 0, dvdx = 0, dudy = 0, dvdy = 0;
};

struct Explanation {
  bool asked = false;  // a pixel is picked
  Pixel pixel;
  int side = 0;
  std::string surface;                              // name of the material; "" = no draw covers the pixel
  std::string note;                                 // why there are no taps
  Lookup lookup;                                    // lookup of the diffuse texture, after the transform of the slot
  uint32_t width = 0, height = 0, level_count = 0;  // size of the texture
  shd_filter filter = SHD_FILTER_NEAREST;           // after magnification
  float lod = 0.0f;
  std::vector<Tap> taps;
  std::vector<LevelView> levels;        // by falling share
  std::array<float, 4> explained = {};  // shd_explanation.result
  std::array<float, 4> sampled = {};    // shd_texture_sample()
  std::array<float, 4> weighted = {};   // sum of weight times texel
  bool replay_is_exact = false;         // the blends, repeated, give the bits of `sampled`
  std::array<float, 4> color = {};      // colour of the pixel in the framebuffer, linear
};

/// Texture coordinates through the transform of a slot.
Lookup transformed(const Lookup& lookup, const float* uv_transform);

/// The texel before wrapping that is nearest to `near` and wraps to `texel`.
int unwrapped(uint32_t texel, uint32_t size, shd_wrap wrap, float near);

/// Explains a lookup. Fills all fields from `width` on, except `color`. Throws shd::error.
void explain(shd_context* context, const shd_texture* texture, const shd_sampler* sampler, shd_wrap wrap_u,
             shd_wrap wrap_v, Explanation& explanation);

/// Largest difference between the weighted sum and the sampled value, over the channels.
float weighted_error(const Explanation& explanation);

}  // namespace viewer
