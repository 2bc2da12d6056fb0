// SPDX-License-Identifier: MIT
/// @file
/// Scalar access to the texels of a format, for the builders of tables. A Codec decodes texels of kChannels channels
/// and kSize bytes to linear doubles, the stored numbers, and encodes averages of stored numbers as texels:
///
///   load     decodes the channels of one texel
///   add      adds `count` texels to a sum
///   store    rounds an average once: unorm and binary16 to nearest even, binary32 to nearest, sRGB (through a float)
///            to the nearest code, shared exponents to nearest, half up
///   scale    factor from the stored number of a channel to its value
///   one      stored number of a channel whose value is 1
///   largest  largest finite stored number of a channel; the smallest is 0, or -largest if kFloat
///   kFloat   stored numbers have a sign and may be infinite or NaN
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace shd::texture {

/// 1 / 255 or 1 / 65535 as the sum of two factors. The product of `high` and a whole code is exact.
struct CodeScale {
  float high, low;
};
constexpr CodeScale kScale8 = {0x1.01p-8f, 0x1.0101p-24f};
constexpr CodeScale kScale16 = {0x1p-16f, 0x1.0001p-32f};

/// Unorm channels: the stored number c has the value c / kMaximum.
template <uint32_t kMaximum>
struct Codes {
  static constexpr bool kFloat = false;
  static constexpr CodeScale scale(size_t) { return kMaximum == 255 ? kScale8 : kScale16; }
  static constexpr double one(size_t) { return kMaximum; }
  static constexpr double largest(size_t) { return kMaximum; }
};

/// Floating-point channels: the stored number is the value.
struct Floats {
  static constexpr bool kFloat = true;
  static constexpr CodeScale scale(size_t) { return {1.0f, 0.0f}; }
  static constexpr double one(size_t) { return 1; }
};

/// Returns the nearest code of a value in the range of codes, ties to even.
template <class T>
T round_to_code(double value) {
  constexpr double kMagic = 6755399441055744.0;  // 1.5 * 2^52: the sum has no fraction bits
  const double shifted = value + kMagic;
  uint64_t bits;
  std::memcpy(&bits, &shifted, sizeof bits);
  return static_cast<T>(bits);
}

/// Rounds a double to odd: an inexact result has its last bit set. Rounding the result again then has the effect of one
/// rounding.
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

/// Replaces every NaN by the same NaN, so that levels have the same bits on every machine.
inline double canonical(double value) {
  return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value;
}

/// Implements Codec::add for formats whose texels are decoded one by one.
template <class Codec>
void add_each(const uint8_t* texel, size_t count, double* sum) {
  for (size_t i = 0; i < count; ++i, texel += Codec::kSize) {
    double value[Codec::kChannels];
    Codec::load(texel, value);
    for (size_t c = 0; c < Codec::kChannels; ++c) sum[c] += value[c];
  }
}

/// Clamps a value to the numbers that a codec can store in a channel.
template <class Codec>
double clamp_stored(size_t channel, double value) {
  if (std::isnan(value) || (Codec::kFloat && std::isinf(value))) return Codec::kFloat ? value : 0;
  const double maximum = Codec::largest(channel), minimum = Codec::kFloat ? -maximum : 0;
  return value < minimum ? minimum : value > maximum ? maximum : value;
}

}  // namespace shd::texture
