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

constexpr uint32_t kSrgb8FirstStep = 0x3900;  // bits of 2^-13 >> 16
constexpr uint32_t kSrgb8Steps = 13 * 128;

/// [(bits of a float >> 16) - kSrgb8FirstStep] for floats of [2^-13, 1). At most one threshold lies in a step. The
/// upper 15 bits are the code of the step's first float; the lower 17 bits are the number of its floats below the
/// threshold, 2^16 if there is none.
struct Srgb8Steps {
  uint32_t step[kSrgb8Steps];
};
extern const Srgb8Steps kLinearToSrgb8Steps;

inline float srgb8_to_linear(uint8_t code) {
  return kSrgb8ToLinear[code];
}

/// 8-bit sRGB code of a linear value, correctly rounded. Values below 0 and NaN give 0, values above 1 give 255.
inline uint8_t linear_to_srgb8(float linear) {
  linear = linear >= 0x1p-13f ? linear : 0x1p-13f;   // code 0
  linear = linear < 1.0f ? linear : 0x1.fffffep-1f;  // code 255
  uint32_t bits;
  std::memcpy(&bits, &linear, sizeof bits);
  const uint32_t step = kLinearToSrgb8Steps.step[(bits >> 16) - kSrgb8FirstStep];
  return static_cast<uint8_t>((step >> 17) + ((bits & 0xffffu) >= (step & 0x1ffffu)));
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
