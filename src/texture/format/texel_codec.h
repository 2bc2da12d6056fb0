// SPDX-License-Identifier: MIT
/// @file
/// The codec of a format as a value. Code that is not hot reads and writes texels through it, and is then compiled once
/// for all formats.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "image/format.h"

namespace shd::texture {

/// The members of a Codec (codec.h) for 1 to 4 channels.
struct TexelCodec {
  size_t channels, size;  // size of a texel [bytes]
  bool is_float;
  double one[4], largest[4];
  void (*load_run)(const uint8_t* texels, size_t count, double* numbers);
  void (*store_run)(const double* numbers, size_t count, uint8_t* texels);

  /// Decode and encode `count` packed texels.
  void load(const uint8_t* texels, size_t count, double* numbers) const { load_run(texels, count, numbers); }
  void store(const double* numbers, size_t count, uint8_t* texels) const { store_run(numbers, count, texels); }

  /// Clamps a value to the numbers that a channel can store.
  double clamp(size_t channel, double value) const {
    if (std::isnan(value) || (is_float && std::isinf(value))) return is_float ? value : 0;
    const double maximum = largest[channel], minimum = is_float ? -maximum : 0;
    return value < minimum ? minimum : value > maximum ? maximum : value;
  }
};

/// Returns the codec of a component for a number of channels.
const TexelCodec& codec_of(image::Component component, size_t channels);

/// Returns the codec of a format whose channels are numbers: sRGB codes are not decoded.
const TexelCodec& codec_of_numbers(shd_format format);

/// Decodes `count` packed texels in runs of up to 64, which are even except the last one, and calls
/// body(numbers, texels of the run) for each run.
template <class Body>
void for_runs(const TexelCodec& codec, const uint8_t* texels, size_t count, const Body& body) {
  constexpr size_t kRun = 64;
  double numbers[kRun * 4];
  for (size_t first = 0; first < count; first += kRun) {
    const size_t run = count - first < kRun ? count - first : kRun;
    codec.load(texels + first * codec.size, run, numbers);
    body(static_cast<const double*>(numbers), run);
  }
}

/// Calls body(std::integral_constant<size_t, channels>()), for loops over texels of doubles.
template <class Body>
void with_channels(size_t channels, const Body& body) {
  switch (channels) {
    case 1: return body(std::integral_constant<size_t, 1>());
    case 2: return body(std::integral_constant<size_t, 2>());
    case 3: return body(std::integral_constant<size_t, 3>());
    default: return body(std::integral_constant<size_t, 4>());
  }
}

}  // namespace shd::texture
