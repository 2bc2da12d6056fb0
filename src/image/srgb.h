// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

namespace shd::image {

/// Linear value of every 8-bit sRGB code: IEC 61966-2-1 at c / 255, correctly rounded.
extern const float kSrgb8ToLinear[256];

/// Smallest float that encodes to at least k, for k = 0..255, and an end that no float reaches: the encoding
/// curve at code k - 1/2, solved exactly and rounded up. The curve never meets such a tie at a float.
extern const float kLinearToSrgb8Threshold[257];

/// Code at the start of every 1/32 octave of [2^-13, 1); thresholds above it are at most three steps away.
constexpr uint32_t kSrgb8StartFirst = 3648;  // bits of 2^-13 >> 18
extern const uint8_t kLinearToSrgb8Start[416];

inline float srgb8_to_linear(uint8_t code) {
  return kSrgb8ToLinear[code];
}

/// 8-bit sRGB code of a linear value, correctly rounded; below 0 and NaN give 0, above 1 gives 255.
inline uint8_t linear_to_srgb8(float linear) {
  if (!(linear >= 0x1p-13f)) return 0;
  if (linear >= 1.0f) return 255;
  uint32_t bits;
  std::memcpy(&bits, &linear, sizeof bits);
  uint32_t code = kLinearToSrgb8Start[(bits >> 18) - kSrgb8StartFirst];
  while (linear >= kLinearToSrgb8Threshold[code + 1]) ++code;
  return static_cast<uint8_t>(code);
}

}  // namespace shd::image
