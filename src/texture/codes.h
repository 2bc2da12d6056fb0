// SPDX-License-Identifier: MIT
/// @file
/// How each texture format turns texels into linear doubles and averages back into texels, for the mip builder.
///
///   load   channels of one texel
///   add    puts `count` texels onto a sum
///   store  rounds an average once: unorm and binary16 to nearest even, binary32 to nearest, sRGB (through a float)
///          to the nearest code
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "image/half.h"
#include "image/srgb.h"

namespace shd::texture {

/// Nearest of the 256 codes of a value in 0..255, ties to even.
inline uint8_t round_to_code(double value) {
  constexpr double kMagic = 6755399441055744.0;  // 1.5 * 2^52: the sum has no fraction bits left
  const double shifted = value + kMagic;
  uint64_t bits;
  std::memcpy(&bits, &shifted, sizeof bits);
  return static_cast<uint8_t>(bits);
}

/// float whose last bit is set when the conversion is inexact, so that rounding it again rounds only once.
inline float round_to_odd(double value) {
  auto rounded = static_cast<float>(value);
  const auto back = static_cast<double>(rounded);
  if (back == value || !std::isfinite(rounded) || !std::isfinite(value)) return rounded;
  uint32_t bits;
  std::memcpy(&bits, &rounded, sizeof bits);
  if (std::fabs(back) > std::fabs(value)) --bits;
  bits |= 1;
  std::memcpy(&rounded, &bits, sizeof bits);
  return rounded;
}

/// One NaN for all, so that levels hold the same bits everywhere.
inline double canonical(double value) {
  return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value;
}

struct CodeR8 {
  static constexpr size_t kChannels = 1, kSize = 1;
  static void load(const uint8_t* texel, double* value) { value[0] = texel[0]; }
  static void add(const uint8_t* texel, size_t count, double* sum) {
    uint64_t total = 0;
    for (size_t i = 0; i < count; ++i) total += texel[i];
    sum[0] += static_cast<double>(total);
  }
  static void store(const double* average, uint8_t* texel) { texel[0] = round_to_code(average[0]); }
};

struct CodeRgba8 {
  static constexpr size_t kChannels = 4, kSize = 4;
  static void load(const uint8_t* texel, double* value) {
    for (size_t c = 0; c < 4; ++c) value[c] = texel[c];
  }
  static void add(const uint8_t* texel, size_t count, double* sum) {
    uint32_t total[4] = {};  // at most 2^16 texels of 255
    for (size_t i = 0; i < count; ++i) {
      for (size_t c = 0; c < 4; ++c) total[c] += texel[4 * i + c];
    }
    for (size_t c = 0; c < 4; ++c) sum[c] += total[c];
  }
  static void store(const double* average, uint8_t* texel) {
    for (size_t c = 0; c < 4; ++c) texel[c] = round_to_code(average[c]);
  }
};

/// For formats whose texels are turned into doubles one by one.
template <class Code>
void add_each(const uint8_t* texel, size_t count, double* sum) {
  for (size_t i = 0; i < count; ++i, texel += Code::kSize) {
    double value[Code::kChannels];
    Code::load(texel, value);
    for (size_t c = 0; c < Code::kChannels; ++c) sum[c] += value[c];
  }
}

struct CodeSrgb8 {
  static constexpr size_t kChannels = 4, kSize = 4;
  static void load(const uint8_t* texel, double* value) {
    for (size_t c = 0; c < 3; ++c) value[c] = static_cast<double>(image::kSrgb8ToLinear[texel[c]]);
    value[3] = texel[3];
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<CodeSrgb8>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    for (size_t c = 0; c < 3; ++c) texel[c] = image::linear_to_srgb8(static_cast<float>(average[c]));
    texel[3] = round_to_code(average[3]);
  }
};

struct CodeRgba16f {
  static constexpr size_t kChannels = 4, kSize = 8;
  static void load(const uint8_t* texel, double* value) {
    uint16_t halves[4];
    std::memcpy(halves, texel, sizeof halves);
    for (size_t c = 0; c < 4; ++c) value[c] = static_cast<double>(image::half_to_float(halves[c]));
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<CodeRgba16f>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    uint16_t halves[4];
    for (size_t c = 0; c < 4; ++c) halves[c] = image::float_to_half(round_to_odd(canonical(average[c])));
    std::memcpy(texel, halves, sizeof halves);
  }
};

struct CodeRgba32f {
  static constexpr size_t kChannels = 4, kSize = 16;
  static void load(const uint8_t* texel, double* value) {
    float floats[4];
    std::memcpy(floats, texel, sizeof floats);
    for (size_t c = 0; c < 4; ++c) value[c] = static_cast<double>(floats[c]);
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<CodeRgba32f>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    float floats[4];
    for (size_t c = 0; c < 4; ++c) floats[c] = static_cast<float>(canonical(average[c]));
    std::memcpy(texel, floats, sizeof floats);
  }
};

}  // namespace shd::texture
