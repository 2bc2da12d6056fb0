// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

#include <shd/shd.h>

namespace shd::fuzz {

/// Stops the program so that a fuzzer keeps the input.
#define SHD_FUZZ_CHECK(condition)                                                                 \
  do {                                                                                            \
    if (!(condition)) {                                                                           \
      std::fprintf(stderr, "%s:%d: %s (%s)\n", __FILE__, __LINE__, #condition, shd_last_error()); \
      std::abort();                                                                               \
    }                                                                                             \
  } while (0)

/// Reads choices from the fuzzer's bytes; returns zeros when no bytes are left.
class Source {
 public:
  Source(const uint8_t* data, size_t size) : data_(data), size_(size) {}

  uint8_t byte() { return position_ < size_ ? data_[position_++] : 0; }

  uint32_t word() {
    uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | byte();
    return value;
  }

  /// In [0, bound).
  uint32_t below(uint32_t bound) { return (bound > 256 ? word() : byte()) % bound; }

  /// True with probability 1 / n; false when no bytes are left.
  bool one_in(uint32_t n) { return below(n) == n - 1; }

  /// In [-1, 1].
  float unit() { return static_cast<float>(static_cast<int>(below(65536)) - 32768) / 32768.0f; }

  /// Any float: usually near one, sometimes a value that breaks arithmetic.
  float hostile() {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    constexpr float kMax = std::numeric_limits<float>::max();
    constexpr float kValues[] = {0.0f,     -0.0f,     1.0f,        -1.0f,      0.5f,        1e-45f,      -1e-45f,
                                 1e-38f,   0x1p23f,   -0x1p23f,    0x1p31f,    -0x1p31f,    0x1p32f,     1e9f,
                                 1e30f,    -1e30f,    kMax,        -kMax,      kInf,        -kInf,       std::nanf(""),
                                 0x1p-24f, 0.999999f, 0.99999994f, 1.0000001f, -0.0000001f, 16777217.0f, 3e-20f};
    switch (below(4)) {
      case 0: return kValues[below(sizeof kValues / sizeof kValues[0])];
      case 1: {
        const uint32_t bits = word();
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
      case 2: return unit() * 64.0f;
      default: return unit();
    }
  }

  /// A finite float of hostile size.
  float hostile_finite() {
    const float value = hostile();
    return std::isfinite(value) ? value : 1.0f;
  }

 private:
  const uint8_t* data_;
  size_t size_;
  size_t position_ = 0;
};

/// Host memory that counts live allocations.
struct Memory {
  long live = 0;
};

/// A context on `simd` with one worker that takes its memory from `memory`.
inline shd_context* make_context(Memory& memory, shd_simd simd) {
  shd_context_desc desc = shd_context_desc_default();
  desc.simd = simd;
  desc.worker_count = 1;
  desc.allocator.user_data = &memory;
  desc.allocator.allocate = [](void* user_data, size_t size, size_t alignment) -> void* {
    void* result = nullptr;
    if (posix_memalign(&result, alignment, size)) return nullptr;
    ++static_cast<Memory*>(user_data)->live;
    return result;
  };
  desc.allocator.free = [](void* user_data, void* pointer, size_t, size_t) {
    --static_cast<Memory*>(user_data)->live;
    std::free(pointer);
  };
  shd_context* context = nullptr;
  SHD_FUZZ_CHECK(shd_context_create(&desc, &context) == SHD_OK);
  return context;
}

/// Equal bits. Any NaN equals any other NaN, because IEEE 754 does not define the payload.
inline bool same_values(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    if (std::memcmp(&a[i], &b[i], sizeof(float)) != 0 && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
  }
  return true;
}

}  // namespace shd::fuzz
