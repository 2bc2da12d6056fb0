// SPDX-License-Identifier: MIT
/// @file
/// What a format does outside of kernels: a Codec turns texels of kChannels channels and kSize bytes into linear doubles
/// and averages back into texels, for the tables that are built.
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

/// For formats whose texels are turned into doubles one by one.
template <class Codec>
void add_each(const uint8_t* texel, size_t count, double* sum) {
  for (size_t i = 0; i < count; ++i, texel += Codec::kSize) {
    double value[Codec::kChannels];
    Codec::load(texel, value);
    for (size_t c = 0; c < Codec::kChannels; ++c) sum[c] += value[c];
  }
}

}  // namespace shd::texture
