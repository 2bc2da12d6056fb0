// SPDX-License-Identifier: MIT
/// @file
/// How each texture format turns texels into linear doubles and averages back into texels, for the mip builder.
///
///   load   channels of one texel
///   add    puts `count` texels onto a sum
///   store  rounds an average once: unorm and binary16 to nearest even, binary32 to nearest, sRGB (through a float)
///          to the nearest code
///   scale  of a channel: times a stored number, the value it stands for
///   one    of a channel: the stored number that stands for 1
///   largest  of a channel: the largest finite stored number; the least is 0, or -largest if kFloat
///   kFloat whether numbers have a sign and may be infinite or NaN
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "image/format.h"
#include "image/half.h"
#include "image/srgb.h"
#include "texture/format/formats.h"

namespace shd::texture {

/// 1 / 255 and 1 / 65535 in two factors, of which the first times a whole code is exact.
struct CodeScale {
  float high, low;
};
constexpr CodeScale kScale8 = {0x1.01p-8f, 0x1.0101p-24f};
constexpr CodeScale kScale16 = {0x1p-16f, 0x1.0001p-32f};

/// Channels whose stored number c means c / kMaximum.
template <uint32_t kMaximum>
struct Codes {
  static constexpr bool kFloat = false;
  static constexpr CodeScale scale(size_t) { return kMaximum == 255 ? kScale8 : kScale16; }
  static constexpr double one(size_t) { return kMaximum; }
  static constexpr double largest(size_t) { return kMaximum; }
};

/// Channels whose stored number is the value.
struct Floats {
  static constexpr bool kFloat = true;
  static constexpr CodeScale scale(size_t) { return {1.0f, 0.0f}; }
  static constexpr double one(size_t) { return 1; }
};

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
struct Unorm8Codec : Codes<255> {
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
  static constexpr bool kFloat = false;
  static constexpr CodeScale scale(size_t c) { return c == 3 ? kScale8 : CodeScale{1.0f, 0.0f}; }
  static constexpr double one(size_t c) { return c == 3 ? 255 : 1; }
  static constexpr double largest(size_t c) { return one(c); }
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
struct Unorm16Codec : Codes<65535> {
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
struct Float16Codec : Floats {
  static constexpr size_t kChannels = kCount, kSize = 2 * kCount;
  static constexpr double largest(size_t) { return 65504; }
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
struct Float32Codec : Floats {
  static constexpr size_t kChannels = kCount, kSize = 4 * kCount;
  static constexpr double largest(size_t) { return static_cast<double>(std::numeric_limits<float>::max()); }
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
#define SHD_TEXTURE_CASE(name, Codec, kernels) \
  case image::Component::name: return visit_channels<Codec>(channels, body);
    SHD_TEXTURE_FORMATS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
  }
}

/// Calls body(Codec<channels>()) with a number of channels that textures store: 1, 2 or 4.
template <class Body>
void visit_stored(image::Component component, size_t channels, Body&& body) {
  visit_codec(component, channels, [&](auto codec) {
    if constexpr (decltype(codec)::kChannels != 3) body(codec);
  });
}

/// The stored number of a channel that stands for 1.
inline double one_of(image::Component component, size_t channel) {
  double one = 1;
  visit_codec(component, 4, [&](auto codec) { one = codec.one(channel); });
  return one;
}

/// Whether stored numbers may be infinite or NaN.
inline bool is_float(image::Component component) {
  bool floats = false;
  visit_codec(component, 4, [&](auto codec) { floats = codec.kFloat; });
  return floats;
}

}  // namespace shd::texture
