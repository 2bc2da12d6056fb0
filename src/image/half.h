// SPDX-License-Identifier: MIT
/// @file
/// IEEE 754 binary16. The functions are inline and select instead of branching, so that loops over texels vectorise.
#pragma once

#include <cstdint>
#include <cstring>

namespace shd::image {

/// Value of a binary16, exact; a NaN keeps its payload in the upper bits and becomes quiet.
inline float half_to_float(uint16_t half) {
  const uint32_t sign = static_cast<uint32_t>(half & 0x8000u) << 16;
  const uint32_t magnitude = half & 0x7fffu;
  // Zero and subnormals are exact multiples of 2^-24.
  const float small = static_cast<float>(static_cast<int32_t>(magnitude)) * 0x1p-24f;
  uint32_t bits;
  std::memcpy(&bits, &small, sizeof bits);
  bits = magnitude >= 0x0400u ? (magnitude << 13) + (112u << 23) : bits;
  bits = magnitude >= 0x7c00u ? magnitude << 13 | 0x7f800000u : bits;
  bits |= magnitude > 0x7c00u ? 0x00400000u : 0u;
  bits |= sign;
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Nearest binary16, ties to even. Too large values become infinity; NaN becomes a quiet NaN of equal sign.
inline uint16_t float_to_half(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const uint32_t sign = bits >> 16 & 0x8000u;
  const uint32_t magnitude = bits & 0x7fffffffu;
  // From 2^-14 on, the smallest normal number: the carry of the rounding may reach infinity.
  const uint32_t normal = (magnitude - (112u << 23) + 0xfffu + (magnitude >> 13 & 1u)) >> 13;
  // Below 2^-14: the last bits of the sum with 1/2 are the subnormal, rounded to nearest even.
  float small;
  std::memcpy(&small, &magnitude, sizeof small);
  small += 0.5f;
  uint32_t subnormal;
  std::memcpy(&subnormal, &small, sizeof subnormal);
  uint32_t half = magnitude >= 0x38800000u ? normal : subnormal - 0x3f000000u;
  half = magnitude >= 0x477ff000u ? 0x7c00u : half;  // 65520 is halfway to 2^16
  half = magnitude > 0x7f800000u ? 0x7e00u | (magnitude >> 13 & 0x1ffu) : half;
  return static_cast<uint16_t>(sign | half);
}

}  // namespace shd::image
