// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
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

/// Unit direction of a point of a map, in texels from its corner: the centre of texel (i, j) is (i + 1/2, j + 1/2).
/// `norm` = |x| + |y| + |z|, 1..sqrt(3). A texel has the solid angle (2 / size)^2 norm^3.
struct MapDirection {
  float x, y, z, norm;
};
inline MapDirection map_direction(uint32_t size, float i, float j) {
  const float scale = 2.0f / static_cast<float>(size);
  const float p = i * scale - 1.0f, q = 1.0f - j * scale;
  const float z = 1.0f - std::fabs(p) - std::fabs(q), fold = z < 0.0f ? z : 0.0f;
  const float x = p - std::copysign(fold, p), y = q - std::copysign(fold, q);
  const float norm = 1.0f / std::sqrt(x * x + y * y + z * z);
  return {x * norm, y * norm, z * norm, norm};
}

/// A texel of a finished map: r and g in the first word, b and e in the second, 16 bits each. A channel is its number
/// times the float with the exponent bits e.
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
