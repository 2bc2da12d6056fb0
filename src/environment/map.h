// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/context.h"

namespace shd::environment {

/// A square map of all directions in the projection OCTAHEDRAL: [size + 2][size + 2] texels, row 0 on top. While maps
/// are made, texels are four floats (r, g, b, 0); then they are packed. The border of one texel repeats the texels that
/// lie next to the edge on the octahedron, so that bilinear lookups need no wrap.
struct Level {
  uint32_t size;   // texels a side without the border
  uint32_t first;  // texel at which the border begins
};

inline size_t texel_count(uint32_t size) {
  return size_t{size + 2} * (size + 2);
}

/// Index of a texel; x and y are -1..size.
inline size_t texel_index(const Level& level, int32_t x, int32_t y) {
  return level.first + static_cast<size_t>(y + 1) * (level.size + 2) + static_cast<size_t>(x + 1);
}

/// Points of maps and their directions. The weight of a point is proportional to the solid angle of a texel there.
struct MapPoints {
  static constexpr size_t kMost = 256;
  size_t count = 0;
  float u[kMost], v[kMost];
  alignas(64) float x[kMost], y[kMost], z[kMost], weight[kMost];

  /// Adds a point of a map, in texels from its corner: the centre of texel (i, j) is (i + 1/2, j + 1/2).
  void add(uint32_t size, float i, float j) {
    const float scale = 1.0f / static_cast<float>(size);
    u[count] = i * scale;
    v[count++] = j * scale;
  }
  /// Finds the directions and weights of all points.
  void find(const core::SimdTarget& simd);
};

/// A texel of a finished map: r and g in the first word, b and e in the second, 16 bits each. A channel is its number
/// times the float with the exponent bits e.
///
/// Maps are not textures: SHD_FORMAT_RGB9E5 errs by 2^-10 of the largest channel instead of 2^-16, and ends at 65408.
/// Trilinear lookups of octahedral textures of RGBA16F, whose texels are as large as these, take 1.04 to 1.6 times as
/// long as lookups of maps (AVX-512, AVX2 and SSE4; directions in order and at random).
struct PackedTexel {
  uint32_t word[2];
};

/// The nearest texel of a colour of finite numbers that are not negative. |error| <= 2^-16 of the largest channel.
PackedTexel pack(const float rgb[3]);

/// Fills the border of a map from its texels.
void fill_border(const Level& level, float* texels);

/// Makes a level of half the size: means weighted by solid angle. Throws Failure.
void halve(const core::Context& context, const Level& from, const Level& to, float* texels);

/// Maps from the widest lobe to the narrowest. Map k, for k up to `lobes` - 1, is a lobe of precision 2^k: 1 / alpha^2
/// of GGX lobes, p + 1 of Phong lobes. The other maps are levels of the radiance from coarse to fine, each of 4 times
/// the precision of its predecessor.
constexpr uint32_t kMaxMaps = 24;
struct Chain {
  uint32_t count;  // 0 = absent
  uint32_t lobes;
  float knee, offset;  // log2 t of a precision lies at map min(t, knee) + max(t - knee, 0) / 2 - offset
  Level level[kMaxMaps];
};

}  // namespace shd::environment
