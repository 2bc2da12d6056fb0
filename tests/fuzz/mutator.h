// SPDX-License-Identifier: MIT
/// @file
/// Mutations by the structure of an input. The target's own decoder runs on the input and records its choices;
/// the mutator then changes choices instead of blind bytes: enumerations and counts within and at the ends of their
/// range, floats towards special values, indices and vertices copied and swapped. One mutation in four is libFuzzer's
/// own, which also uses the values that the library compared.
///
/// Include this header in one file of a target. It defines libFuzzer's hooks.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "source.h"

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace shd::fuzz {

/// Makes every choice of an input without calling the library. Defined by each target.
void describe(Source& source);

/// Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators" (2014), as splitmix64.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint32_t below(uint32_t bound) { return static_cast<uint32_t>((next() >> 32) * bound >> 32); }
  uint32_t bits() { return static_cast<uint32_t>(next() >> 32); }

 private:
  uint64_t next() {
    uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  uint64_t state_;
};

/// The choices of one input, and changes of them.
class Mutator {
 public:
  Mutator(uint8_t* data, uint32_t seed) : data_(data), random_(seed) {}

  /// Makes room for every choice of the input; returns the new size.
  size_t describe_input(size_t size, size_t max_size) {
    Source source(data_, size);
    source.record(&fields_);
    describe(source);
    const size_t wanted = std::min(source.position(), max_size);
    for (size_t i = size; i < wanted; ++i) data_[i] = static_cast<uint8_t>(random_.bits());
    while (!fields_.empty() && fields_.back().offset + fields_.back().size > wanted) fields_.pop_back();
    return wanted;  // bytes behind the last choice have no effect
  }

  void mutate() {
    if (fields_.empty()) return;
    switch (random_.below(16)) {
      case 0: copy_run(); break;
      case 1: swap(); break;
      default: change(pick());
    }
  }

  /// A run of choices from another input of similar structure.
  void cross(const uint8_t* other, size_t other_size) {
    if (fields_.empty()) return;
    const Field& first = pick();
    const size_t begin = first.offset;
    const size_t end = std::min(other_size, begin + 1 + random_.below(64));
    for (const Field& field : fields_) {
      if (field.offset >= begin && field.offset + field.size <= end) {
        std::memcpy(data_ + field.offset, other + field.offset, field.size);
      }
    }
  }

 private:
  const Field& pick() { return fields_[random_.below(static_cast<uint32_t>(fields_.size()))]; }

  void write(const Field& field, uint32_t value) {
    for (int i = 0; i < field.size; ++i) data_[field.offset + i] = static_cast<uint8_t>(value >> 8 * i);
  }

  uint32_t read(const Field& field) const {
    uint32_t value = 0;
    for (int i = 0; i < field.size; ++i) value |= uint32_t{data_[field.offset + i]} << 8 * i;
    return value;
  }

  void change(const Field& field) {
    switch (field.kind) {
      case Kind::kNumber: write(field, change_number(read(field), field.bound)); break;
      case Kind::kWord: write(field, change_word(read(field))); break;
      case Kind::kReal: write(field, change_real(read(field), field.bound)); break;
    }
  }

  uint32_t change_number(uint32_t value, uint32_t bound) {
    switch (random_.below(8)) {
      case 0: return 0;
      case 1: return bound - 1;
      case 2: return value % bound + 1;
      case 3: return value % bound + bound - 1;
      case 4: return random_.bits();
      default: return random_.below(bound);
    }
  }

  uint32_t change_word(uint32_t value) {
    constexpr uint32_t kWords[] = {0, 1, 2, 0xff, 0xffff, 0x10000, 0x7fffffff, 0x80000000u, 0xfffffffeu, 0xffffffffu};
    switch (random_.below(4)) {
      case 0: return kWords[random_.below(sizeof kWords / sizeof kWords[0])];
      case 1: return value ^ 1u << random_.below(32);
      case 2: return value + random_.below(9) - 4;
      default: return random_.bits();
    }
  }

  /// The kind of a float is its lowest byte; kinds below `hostility` are special or random.
  uint32_t change_real(uint32_t encoded, uint32_t hostility) {
    const uint32_t value = encoded >> 8;
    const uint32_t tame = hostility + random_.below(256 - hostility);
    switch (random_.below(8)) {
      case 0: return 1 | random_.below(kSpecialFloatCount) << 8;
      case 1: return random_.bits();
      case 2: return (encoded & 0xff) | (value + random_.below(9) - 4) << 8;
      case 3: return (encoded & 0xff) | (0x10000 - value) << 8;
      case 4: return tame | (random_.below(9) * 8192) << 8;  // eighths: equal coordinates, right angles
      case 5: return copy_of(encoded);
      default: return tame | (random_.bits() & 0xffff) << 8;
    }
  }

  /// The float of another choice, so that coordinates coincide.
  uint32_t copy_of(uint32_t otherwise) {
    const Field& other = pick();
    return other.kind == Kind::kReal ? read(other) : otherwise;
  }

  /// Copies neighbouring choices, such as a vertex or a triangle, to another place of the same kinds.
  void copy_run() {
    size_t from = random_.below(static_cast<uint32_t>(fields_.size()));
    size_t to = random_.below(static_cast<uint32_t>(fields_.size()));
    for (uint32_t n = 1 + random_.below(12); n > 0 && std::max(from, to) < fields_.size(); --n, ++from, ++to) {
      if (fields_[from].kind != fields_[to].kind || fields_[from].size != fields_[to].size) break;
      write(fields_[to], read(fields_[from]));
    }
  }

  void swap() {
    const Field a = pick(), b = pick();
    if (a.kind != b.kind || a.size != b.size) return;
    const uint32_t value = read(a);
    write(a, read(b));
    write(b, value);
  }

  uint8_t* data_;
  Random random_;
  std::vector<Field> fields_;
};

}  // namespace shd::fuzz

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size, unsigned seed) {
  shd::fuzz::Random random(seed);
  if (random.below(4) == 0) return LLVMFuzzerMutate(data, size, max_size);
  shd::fuzz::Mutator mutator(data, random.bits());
  const size_t new_size = mutator.describe_input(size, max_size);
  if (new_size == 0) return LLVMFuzzerMutate(data, size, max_size);
  for (uint32_t n = 1 + random.below(4); n > 0; --n) mutator.mutate();
  return new_size;
}

extern "C" size_t LLVMFuzzerCustomCrossOver(const uint8_t* a, size_t a_size, const uint8_t* b, size_t b_size,
                                            uint8_t* out, size_t max_size, unsigned seed) {
  const size_t size = std::min(a_size, max_size);
  std::memcpy(out, a, size);
  shd::fuzz::Mutator mutator(out, seed);
  const size_t new_size = mutator.describe_input(size, max_size);
  mutator.cross(b, b_size);
  return new_size;
}
