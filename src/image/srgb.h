// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace shd::image {

/// Linear value of every 8-bit sRGB code: IEC 61966-2-1 at c / 255, correctly rounded.
extern const float kSrgb8ToLinear[256];

/// [k] = smallest float that encodes to at least k, for k = 0..255; the last entry is above all floats. An entry is the
/// inverse of the encoding curve at code k - 1/2, solved exactly and rounded up. No float lies exactly on such a tie.
extern const float kLinearToSrgb8Threshold[257];

/// Code at the start of every 1/32 octave of [2^-13, 1). The code of a value is at most three higher.
constexpr uint32_t kSrgb8StartFirst = 3648;  // bits of 2^-13 >> 18
extern const uint8_t kLinearToSrgb8Start[416];

inline float srgb8_to_linear(uint8_t code) {
  return kSrgb8ToLinear[code];
}

/// 8-bit sRGB code of a linear value, correctly rounded. Values below 0 and NaN give 0, values above 1 give 255.
inline uint8_t linear_to_srgb8(float linear) {
  linear = linear >= 0x1p-13f ? linear : 0x1p-13f;   // code 0
  linear = linear < 1.0f ? linear : 0x1.fffffep-1f;  // code 255
  uint32_t bits;
  std::memcpy(&bits, &linear, sizeof bits);
  const uint32_t start = kLinearToSrgb8Start[(bits >> 18) - kSrgb8StartFirst];
  const float* threshold = kLinearToSrgb8Threshold + start;
  return static_cast<uint8_t>(start + (linear >= threshold[1]) + (linear >= threshold[2]) + (linear >= threshold[3]));
}

// The curve between the 8-bit codes, for 16-bit files. These two functions use libm, which determines their last bits.

/// Linear value of an sRGB number in [0, 1] (IEC 61966-2-1).
inline double srgb_to_linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// sRGB number of a linear value in [0, 1] (IEC 61966-2-1).
inline double linear_to_srgb(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace shd::image
