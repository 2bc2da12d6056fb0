// SPDX-License-Identifier: MIT
/// @file
/// Exact integer sums of texels of integer formats, for the first steps of the mip builder. After k steps that halve
/// both sizes, a sum contains 4^k texels.
///
///   Sum      integer type that can hold the sum of 4^kSumSteps texels
///   pair     computes `count` sums of 2 x 2 texels from two stored rows
///   halve    computes `count` sums of 2 x 2 sums from two rows of sums
///   store    rounds sums / 2^shift as Codec::store does
///   average  returns sum / 2^shift in the units of Codec::load
#pragma once

#include "texture/format/formats.h"

namespace shd::texture {

constexpr uint32_t kSumSteps = 4;

/// Formats without exact integer sums.
template <class Codec>
struct Sums {
  static constexpr bool kExact = false;
};

/// Rounds sum / 2^shift to the nearest integer, ties to even.
template <class Sum>
Sum round_shift(Sum sum, uint32_t shift) {
  const Sum odd = static_cast<Sum>(sum >> shift & 1);
  return static_cast<Sum>(static_cast<Sum>(sum + ((Sum{1} << (shift - 1)) - 1) + odd) >> shift);
}

template <class Sum, size_t kChannels>
void halve_sums(const Sum* __restrict top, const Sum* __restrict bottom, uint32_t count, Sum* __restrict to) {
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < kChannels; ++c) {
      const size_t left = 2 * i * kChannels + c, right = left + kChannels;
      to[i * kChannels + c] = static_cast<Sum>((top[left] + top[right]) + (bottom[left] + bottom[right]));
    }
  }
}

/// An unsigned integer that consists of kFields 16-bit fields.
template <size_t kFields>
struct Fields;
template <>
struct Fields<1> {
  using Type = uint16_t;
};
template <>
struct Fields<2> {
  using Type = uint32_t;
};
template <>
struct Fields<4> {
  using Type = uint64_t;
};

/// Sums of 8-bit unorm texels. 256 texels of 255 fit in 16 bits, so all channels of a texel are added as one integer
/// without carries between them.
template <size_t kChannels>
struct Sums<Unorm8Codec<kChannels>> {
  static constexpr bool kExact = true;
  using Sum = uint16_t;
  using Texel = typename Fields<kChannels>::Type;
  static constexpr size_t kRun = 64;

  static void pair(const uint8_t* __restrict top, const uint8_t* __restrict bottom, uint32_t count,
                   Sum* __restrict to) {
    Sum column[2 * kRun * kChannels];
    for (size_t done = 0; done < count; done += kRun) {
      const size_t run = count - done < kRun ? count - done : kRun;
      for (size_t i = 0; i < 2 * run * kChannels; ++i) column[i] = static_cast<Sum>(top[i] + bottom[i]);
      for (size_t i = 0; i < run; ++i) {
        Texel left, right;
        std::memcpy(&left, column + 2 * i * kChannels, sizeof left);
        std::memcpy(&right, column + (2 * i + 1) * kChannels, sizeof right);
        left = static_cast<Texel>(left + right);
        std::memcpy(to + i * kChannels, &left, sizeof left);
      }
      top += 2 * run * kChannels;
      bottom += 2 * run * kChannels;
      to += run * kChannels;
    }
  }
  static void halve(const Sum* top, const Sum* bottom, uint32_t count, Sum* to) {
    halve_sums<Sum, kChannels>(top, bottom, count, to);
  }
  static void store(const Sum* __restrict sums, uint32_t count, uint32_t shift, uint8_t* __restrict to) {
    const auto below = static_cast<Sum>((1u << (shift - 1)) - 1);
    for (size_t i = 0; i < count * kChannels; ++i) {
      const auto odd = static_cast<Sum>(static_cast<Sum>(sums[i] >> shift) & 1);
      to[i] = static_cast<uint8_t>(static_cast<Sum>(sums[i] + below + odd) >> shift);
    }
  }
  static double average(Sum sum, size_t, uint32_t shift) { return static_cast<double>(sum) / (1u << shift); }
};

template <size_t kChannels>
struct Sums<Unorm16Codec<kChannels>> {
  static constexpr bool kExact = true;
  using Sum = uint32_t;

  static void pair(const uint8_t* top, const uint8_t* bottom, uint32_t count, Sum* to) {
    for (size_t i = 0; i < count; ++i, top += 4 * kChannels, bottom += 4 * kChannels, to += kChannels) {
      uint16_t a[2 * kChannels], b[2 * kChannels];
      std::memcpy(a, top, sizeof a);
      std::memcpy(b, bottom, sizeof b);
      for (size_t c = 0; c < kChannels; ++c) {
        to[c] = (Sum{a[c]} + Sum{a[c + kChannels]}) + (Sum{b[c]} + Sum{b[c + kChannels]});
      }
    }
  }
  static void halve(const Sum* top, const Sum* bottom, uint32_t count, Sum* to) {
    halve_sums<Sum, kChannels>(top, bottom, count, to);
  }
  static void store(const Sum* sums, uint32_t count, uint32_t shift, uint8_t* to) {
    for (size_t i = 0; i < count * kChannels; ++i) {
      const auto code = static_cast<uint16_t>(round_shift(sums[i], shift));
      std::memcpy(to + 2 * i, &code, sizeof code);
    }
  }
  static double average(Sum sum, size_t, uint32_t shift) { return static_cast<double>(sum) / (1u << shift); }
};

/// Sums of 8-bit sRGB texels. Linear values are multiples of 2^-35: the smallest, decoded from code 1, is above 2^-12
/// and has 24 bits.
template <size_t kChannels>
struct Sums<Srgb8Codec<kChannels>> {
  static constexpr bool kExact = true;
  using Sum = uint64_t;
  static constexpr float kUnit = 0x1p35f;

  uint64_t linear[256];

  Sums() {
    for (size_t code = 0; code < 256; ++code) {
      linear[code] =
          static_cast<uint64_t>(static_cast<double>(image::kSrgb8ToLinear[code]) * static_cast<double>(kUnit));
    }
  }
  void pair(const uint8_t* top, const uint8_t* bottom, uint32_t count, Sum* to) const {
    for (size_t i = 0; i < count; ++i, top += 2 * kChannels, bottom += 2 * kChannels, to += kChannels) {
      for (size_t c = 0; c < kChannels; ++c) {
        if (c == 3) {
          to[c] = uint64_t{top[c]} + top[c + kChannels] + bottom[c] + bottom[c + kChannels];
        } else {
          to[c] = (linear[top[c]] + linear[top[c + kChannels]]) + (linear[bottom[c]] + linear[bottom[c + kChannels]]);
        }
      }
    }
  }
  static void halve(const Sum* top, const Sum* bottom, uint32_t count, Sum* to) {
    halve_sums<Sum, kChannels>(top, bottom, count, to);
  }
  static void store(const Sum* sums, uint32_t count, uint32_t shift, uint8_t* to) {
    const float scale = 1 / (kUnit * static_cast<float>(1u << shift));
    for (size_t i = 0; i < count; ++i, sums += kChannels, to += kChannels) {
      for (size_t c = 0; c < kChannels; ++c) {
        to[c] = c == 3 ? static_cast<uint8_t>(round_shift(sums[c], shift))
                       : image::linear_to_srgb8(static_cast<float>(static_cast<int64_t>(sums[c])) * scale);
      }
    }
  }
  static double average(Sum sum, size_t channel, uint32_t shift) {
    const double scale = channel == 3 ? 1 : static_cast<double>(kUnit);
    return static_cast<double>(static_cast<int64_t>(sum)) / (scale * (1u << shift));
  }
};

}  // namespace shd::texture
