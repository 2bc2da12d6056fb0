// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "texture/format/texel_codec.h"

namespace shd::texture {

/// Turns a decoded texel of three or four channels into its vector. If `lengths` is set, the fourth
/// channel is the length of the vector.
inline void decode_normal(const TexelCodec& codec, bool lengths, double* texel) {
  double length = 1;
  if (codec.channels == 4 && lengths) length = texel[3] / codec.one[3];
  for (size_t c = 0; c < 3; ++c) {
    if (!codec.is_float) texel[c] = 2 * texel[c] / codec.one[c] - 1;
    texel[c] *= length;
  }
}

/// Turns the mean of vectors into the numbers of a texel: its direction, and its length in the fourth channel.
inline void encode_normal(const TexelCodec& codec, double* texel) {
  double length = std::sqrt(texel[0] * texel[0] + texel[1] * texel[1] + texel[2] * texel[2]);
  const double unit[] = {0, 0, 1};
  for (size_t c = 0; c < 3; ++c) {
    texel[c] = length > 0 ? texel[c] / length : unit[c];
    if (!codec.is_float) texel[c] = (texel[c] + 1) / 2 * codec.one[c];
  }
  if (length > 1) length = 1;
  if (codec.channels == 4) texel[3] = length * codec.one[3];
}

}  // namespace shd::texture
