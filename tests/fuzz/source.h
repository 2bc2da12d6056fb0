// SPDX-License-Identifier: MIT
/// @file
/// Choices from the fuzzer's bytes. A choice takes a fixed number of bytes, and a Source can record where each choice
/// lies and what it means: mutator.h changes inputs choice by choice.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace shd::fuzz {

/// Meaning of the bytes of a choice.
enum class Kind : uint8_t {
  kNumber,  // one of `bound` numbers
  kWord,    // 32 bits
  kReal,    // one byte for the kind of float, two bytes for its value
};

/// One choice in the input.
struct Field {
  size_t offset;
  uint32_t bound;
  uint8_t size;
  Kind kind;
};

/// Floats that break arithmetic.
constexpr float kSpecialFloats[] = {
    0.0f,      -0.0f,       1.0f,        -1.0f,        0.5f,        1e-45f,
    -1e-45f,   1e-38f,      0x1p23f,     -0x1p23f,     0x1p31f,     -0x1p31f,
    0x1p32f,   1e9f,        1e18f,       1e30f,        -1e30f,      std::numeric_limits<float>::max(),
    0x1p-24f,  0.999999f,   0.99999994f, 1.0000001f,   -0.0000001f, -std::numeric_limits<float>::max(),
    3e-20f,    16777217.0f, 0x1p-149f,   -0.99999994f, 0.75f,       std::numeric_limits<float>::infinity(),
    0x1p-126f, 1.5f,        2.0f,        0.25f,        1e6f,        -std::numeric_limits<float>::infinity(),
    64.0f,     1e12f,       -0.5f,       0.125f,       1e-3f,       std::numeric_limits<float>::quiet_NaN()};
constexpr uint32_t kSpecialFloatCount = sizeof kSpecialFloats / sizeof kSpecialFloats[0];

/// Reads choices from the fuzzer's bytes; returns zeros when no bytes are left.
class Source {
 public:
  Source(const uint8_t* data, size_t size) : data_(data), size_(size) {}

  /// Adds every further choice to `fields`.
  void record(std::vector<Field>* fields) { fields_ = fields; }

  /// Bytes that all choices so far take, also beyond the end of the input.
  size_t position() const { return position_; }

  uint8_t byte() { return static_cast<uint8_t>(number(1, 256)); }

  uint32_t word() {
    note(4, 0, Kind::kWord);
    return take(4);
  }

  /// In [0, bound), of one byte if they are enough.
  uint32_t below(uint32_t bound) { return number(bound <= 256 ? 1 : bound <= 65536 ? 2 : 4, bound) % bound; }

  /// In [low, high].
  uint32_t between(uint32_t low, uint32_t high) { return low + below(high - low + 1); }

  /// True with probability 1 / n; false when no bytes are left.
  bool one_in(uint32_t n) { return below(n) == n - 1; }

  /// A constant of an enumeration that has `count` of them from 0 on; one in 64 is none of them.
  template <class Enum>
  Enum constant(uint32_t count) {
    const uint32_t value = number(1, count);
    return static_cast<Enum>(value >= 252 ? count + value - 252 : value % count);
  }

  /// Flags: a set of the `all` bits; one in 64 has others.
  uint32_t flags(uint32_t all) {
    const uint32_t value = number(2, 65536);
    return value >= 64512 ? value : value & all;
  }

  /// In [-1, 1], one in 32 a special or random float.
  float real() { return real_of(8); }

  /// One half special or random floats, else in [-64, 64] or [-1, 1].
  float hostile() { return real_of(128); }

  /// A finite float of hostile size.
  float hostile_finite() {
    const float value = hostile();
    return std::isfinite(value) ? value : 1.0f;
  }

  /// In [low, high], one in 32 a special or random float.
  float real(float low, float high) {
    const float value = real();
    return std::fabs(value) <= 1.0f ? low + (high - low) * (0.5f + 0.5f * value) : value;
  }

 private:
  /// `hostility` of 256 floats are special or random. The encoding starts with the hostile ones.
  float real_of(uint32_t hostility) {
    note(3, hostility, Kind::kReal);
    const uint32_t kind = take(1);
    const uint32_t value = take(2);
    if (kind >= hostility) {
      const float unit = static_cast<float>(static_cast<int>(value) - 32768) / 32768.0f;
      return hostility > 64 && kind % 4 == 0 ? 64.0f * unit : unit;
    }
    if (kind % 4 != 0) return kSpecialFloats[value % kSpecialFloatCount];
    const uint32_t bits = value << 16 | value;
    float result;
    std::memcpy(&result, &bits, sizeof result);
    return result;
  }

  uint32_t number(uint8_t size, uint32_t bound) {
    note(size, bound, Kind::kNumber);
    return take(size);
  }

  void note(uint8_t size, uint32_t bound, Kind kind) {
    if (fields_) fields_->push_back({position_, bound, size, kind});
  }

  /// A little-endian number.
  uint32_t take(int size) {
    uint32_t value = 0;
    for (int i = 0; i < size; ++i, ++position_) {
      if (position_ < size_) value |= uint32_t{data_[position_]} << 8 * i;
    }
    return value;
  }

  const uint8_t* data_;
  size_t size_;
  size_t position_ = 0;
  std::vector<Field>* fields_ = nullptr;
};

}  // namespace shd::fuzz
