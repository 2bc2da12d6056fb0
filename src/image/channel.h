// SPDX-License-Identifier: MIT
/// @file
/// One stored channel, scalar and in doubles: the definition of what pixels.h does with vectors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "image/format.h"
#include "image/half.h"
#include "image/srgb.h"

namespace shd::image {

/// Value of an unsigned integer code: code / maximum, correctly rounded.
template <class Value, class Code>
Value unorm_value(Code code) {
  return static_cast<Value>(code) / static_cast<Value>(std::numeric_limits<Code>::max());
}

/// The nearest code of a value clamped to 0..1 (NaN to 0); the larger one of two, exact for floats. A dither replaces
/// the threshold.
template <class Code>
Code unorm_code(double value, double threshold = 0.5) {
  const double clamped = value > 0 ? (value < 1 ? value : 1) : 0;
  return static_cast<Code>(clamped * std::numeric_limits<Code>::max() + threshold);
}

/// Component of channel c.
constexpr Component channel_component(const FormatInfo& format, size_t c) {
  return c == 3 && format.component == Component::kSrgb8 ? Component::kUnorm8 : format.component;
}

template <class T>
T load_as(const void* from) {
  T stored;
  std::memcpy(&stored, from, sizeof stored);
  return stored;
}

/// The number of a channel; an sRGB code is a number that stays encoded.
inline double load_number(Component component, const void* from) {
  switch (component) {
    case Component::kUnorm8:
    case Component::kSrgb8: return unorm_value<double>(load_as<uint8_t>(from));
    case Component::kUnorm16: return unorm_value<double>(load_as<uint16_t>(from));
    case Component::kFloat16: return static_cast<double>(half_to_float(load_as<uint16_t>(from)));
    default: return static_cast<double>(load_as<float>(from));
  }
}

/// The linear value of a channel.
inline double load_channel(Component component, const void* from) {
  if (component == Component::kSrgb8) return static_cast<double>(srgb8_to_linear(load_as<uint8_t>(from)));
  return load_number(component, from);
}

/// Stores a linear value: integers as unorm_code(), others rounded to float first.
inline void store_channel(Component component, double value, void* to) {
  const auto store = [&](auto stored) { std::memcpy(to, &stored, sizeof stored); };
  const auto number = static_cast<float>(value);
  switch (component) {
    case Component::kSrgb8: return store(linear_to_srgb8(number));
    case Component::kUnorm8: return store(unorm_code<uint8_t>(value));
    case Component::kUnorm16: return store(unorm_code<uint16_t>(value));
    case Component::kFloat16: return store(float_to_half(number));
    default: return store(number);
  }
}

}  // namespace shd::image
