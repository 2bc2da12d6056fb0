// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/image.h>
#include <shd/projection.h>

#include "core/context.h"
#include "environment/environment.h"
#include "texture/convert/floats.h"

namespace shd::environment {

/// Largest radiance; larger values and infinity are replaced by it.
constexpr float kMaxRadiance = 1e12f;

/// An image of all directions with its texels as floats.
///
/// The light of a texel is spread evenly over its solid angle: texels are divided into parts, so that the lights of all
/// parts are close enough together for the lobes. MIRROR_BALL and ANGULAR: a texel with its centre outside the disc has
/// the radiance of a bilinear lookup, which continues the image across the rim.
struct Source {
  texture::DirectionFloats image;  // [face][height][width]: r, g, b, 1
  uint32_t across, down;           // parts of a texel
  uint64_t replaced;               // channels that were negative, NaN or too large
  double scale;                    // factor of solid angles, which makes their sum 4 pi; about 1
  double moments[3][kHarmonics];   // [channel] integrals of the radiance times the harmonics over all directions

  uint32_t faces() const;
  uint64_t texels() const { return uint64_t{image.width} * image.height * faces(); }
  /// Row y of all faces, as width texels of four floats.
  const float* row(uint32_t y) const { return image.texels.data() + 4 * size_t{y} * image.width; }
};

/// Size of an octahedral map whose texels are at least as large as those of the image, so that lobes are wider than the
/// distances of its lights: a power of two of 64..512.
uint32_t cell_size(const Source& source);

/// Directions and solid angles of a row of parts of texels, as columns of `width` elements.
struct RowDirections {
  size_t width;
  core::Array<float> block;
  float *x, *y, *z, *solid_angle;

  RowDirections(const core::Allocator& allocator, const Source& source);
};

/// Fills the directions of row y of the parts of all faces; solid angles are without source.scale.
void find_directions(const core::SimdTarget& simd, const Source& source, uint32_t y, RowDirections* out);

/// Decodes a checked image and integrates it. Channels that are negative or NaN become 0, channels above kMaxRadiance
/// become kMaxRadiance; one channel means grey. Rows are summed in order, so that the bits do not depend on workers.
/// Throws Failure and std::bad_alloc.
void read_source(const core::Context& context, shd_projection projection, const shd_image& image, Source* out);

}  // namespace shd::environment
