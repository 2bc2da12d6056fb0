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

#include "image/format.h"
#include "image/half.h"
#include "image/srgb.h"

namespace shd::texture {

/// 1 / 255 and 1 / 65535 in two factors, of which the first times a whole code is exact.
struct CodeScale {
  float high, low;
};
constexpr CodeScale kScale8 = {0x1.01p-8f, 0x1.0101p-24f};
constexpr CodeScale kScale16 = {0x1p-16f, 0x1.0001p-32f};

/// Nearest code of a value in the range of codes, ties to even.
template <class T>
T round_to_code(double value) {
  constexpr double kMagic = 6755399441055744.0;  // 1.5 * 2^52: the sum has no fraction bits left
  const double shifted = value + kMagic;
  uint64_t bits;
  std::memcpy(&bits, &shifted, sizeof bits);
  return static_cast<T>(bits);
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

template <size_t kCount>
struct Unorm8Codec {
  static constexpr size_t kChannels = kCount, kSize = kCount;
  static void load(const uint8_t* texel, double* value) {
    for (size_t c = 0; c < kChannels; ++c) value[c] = texel[c];
  }
  static void add(const uint8_t* texel, size_t count, double* sum) {
    uint32_t total[kChannels] = {};  // at most 2^16 texels of 255
    for (size_t i = 0; i < count; ++i) {
      for (size_t c = 0; c < kChannels; ++c) total[c] += texel[kChannels * i + c];
    }
    for (size_t c = 0; c < kChannels; ++c) sum[c] += total[c];
  }
  static void store(const double* average, uint8_t* texel) {
    for (size_t c = 0; c < kChannels; ++c) texel[c] = round_to_code<uint8_t>(average[c]);
  }
};

/// For formats whose texels are turned into doubles one by one.
template <class Codec>
void add_each(const uint8_t* texel, size_t count, double* sum) {
  for (size_t i = 0; i < count; ++i, texel += Codec::kSize) {
    double value[Codec::kChannels];
    Codec::load(texel, value);
    for (size_t c = 0; c < Codec::kChannels; ++c) sum[c] += value[c];
  }
}

/// Channel 3 is alpha: a linear code.
template <size_t kCount>
struct Srgb8Codec {
  static constexpr size_t kChannels = kCount, kSize = kCount;
  static void load(const uint8_t* texel, double* value) {
    for (size_t c = 0; c < kChannels; ++c) {
      value[c] = c == 3 ? texel[c] : static_cast<double>(image::kSrgb8ToLinear[texel[c]]);
    }
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Srgb8Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    for (size_t c = 0; c < kChannels; ++c) {
      texel[c] = c == 3 ? round_to_code<uint8_t>(average[c]) : image::linear_to_srgb8(static_cast<float>(average[c]));
    }
  }
};

template <size_t kCount>
struct Unorm16Codec {
  static constexpr size_t kChannels = kCount, kSize = 2 * kCount;
  static void load(const uint8_t* texel, double* value) {
    uint16_t codes[kChannels];
    std::memcpy(codes, texel, sizeof codes);
    for (size_t c = 0; c < kChannels; ++c) value[c] = codes[c];
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Unorm16Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    uint16_t codes[kChannels];
    for (size_t c = 0; c < kChannels; ++c) codes[c] = round_to_code<uint16_t>(average[c]);
    std::memcpy(texel, codes, sizeof codes);
  }
};

template <size_t kCount>
struct Float16Codec {
  static constexpr size_t kChannels = kCount, kSize = 2 * kCount;
  static void load(const uint8_t* texel, double* value) {
    uint16_t halves[kChannels];
    std::memcpy(halves, texel, sizeof halves);
    for (size_t c = 0; c < kChannels; ++c) value[c] = static_cast<double>(image::half_to_float(halves[c]));
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Float16Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    uint16_t halves[kChannels];
    for (size_t c = 0; c < kChannels; ++c) halves[c] = image::float_to_half(round_to_odd(canonical(average[c])));
    std::memcpy(texel, halves, sizeof halves);
  }
};

template <size_t kCount>
struct Float32Codec {
  static constexpr size_t kChannels = kCount, kSize = 4 * kCount;
  static void load(const uint8_t* texel, double* value) {
    float floats[kChannels];
    std::memcpy(floats, texel, sizeof floats);
    for (size_t c = 0; c < kChannels; ++c) value[c] = static_cast<double>(floats[c]);
  }
  static void add(const uint8_t* texel, size_t count, double* sum) { add_each<Float32Codec>(texel, count, sum); }
  static void store(const double* average, uint8_t* texel) {
    float floats[kChannels];
    for (size_t c = 0; c < kChannels; ++c) floats[c] = static_cast<float>(canonical(average[c]));
    std::memcpy(texel, floats, sizeof floats);
  }
};

template <template <size_t> class Codec, class Body>
void visit_channels(size_t channels, Body&& body) {
  switch (channels) {
    case 1: return body(Codec<1>());
    case 2: return body(Codec<2>());
    case 3: return body(Codec<3>());
    default: return body(Codec<4>());
  }
}

/// Calls body(Codec<channels>()) with the code of a component.
template <class Body>
void visit_codec(image::Component component, size_t channels, Body&& body) {
  switch (component) {
    case image::Component::kUnorm8: return visit_channels<Unorm8Codec>(channels, body);
    case image::Component::kSrgb8: return visit_channels<Srgb8Codec>(channels, body);
    case image::Component::kUnorm16: return visit_channels<Unorm16Codec>(channels, body);
    case image::Component::kFloat16: return visit_channels<Float16Codec>(channels, body);
    default: return visit_channels<Float32Codec>(channels, body);
  }
}

}  // namespace shd::texture
