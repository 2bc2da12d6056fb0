// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/image.h>
#include <shd/projection.h>

#include "core/context.h"

namespace shd::environment {

/// Largest radiance; larger values and infinity are replaced by it.
constexpr float kMaxRadiance = 1e12f;

/// Number of real spherical harmonics of the orders 0 to 2.
constexpr int kHarmonics = 9;

/// An image of all directions with its texels as floats.
struct Source {
  shd_projection projection;
  uint32_t width, height;         // of the image; CUBE has its faces on top of each other
  core::Array<float> texels;      // [height][width]: r, g, b, and 1 for texels that show a direction, otherwise 0
  uint64_t replaced;              // channels that were negative, NaN or too large
  double scale;                   // factor of solid angles, which makes their sum 4 pi
  double moments[3][kHarmonics];  // [channel] integrals of the radiance times 1, x, y, z, xy, yz, xz, 3 z^2 - 1, x^2 -
                                  // y^2 over all directions
};

/// Directions and solid angles of a row of texels, as columns of `width` elements.
struct RowDirections {
  core::Array<float> block;
  float *x, *y, *z, *solid_angle;

  RowDirections(const core::Allocator& allocator, uint32_t width);
};

/// Fills the directions of row y; solid angles are without source.scale.
void find_directions(const core::SimdTarget& simd, const Source& source, uint32_t y, RowDirections* out);

/// Decodes a checked image and integrates it. Channels that are negative or NaN become 0, channels above kMaxRadiance
/// become kMaxRadiance; one channel means grey. Rows are summed in order, so that the bits do not depend on workers.
/// Throws Failure and std::bad_alloc.
void read_source(const core::Context& context, shd_projection projection, const shd_image& image, Source* out);

}  // namespace shd::environment
