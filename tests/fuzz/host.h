// SPDX-License-Identifier: MIT
/// @file
/// The host of the library in a target: memory that counts and can run out, contexts, checks and canaries.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include <sanitizer/asan_interface.h>

#include <shd/shd.h>

#include "source.h"

namespace shd::fuzz {

/// Stops the program so that a fuzzer keeps the input.
#define SHD_FUZZ_CHECK(condition)                                                                 \
  do {                                                                                            \
    if (!(condition)) {                                                                           \
      std::fprintf(stderr, "%s:%d: %s (%s)\n", __FILE__, __LINE__, #condition, shd_last_error()); \
      std::abort();                                                                               \
    }                                                                                             \
  } while (0)

/// Freed blocks of 32 KiB and more, kept for the next allocation of the same size and alignment. The address sanitizer
/// maps and unmaps such blocks, which took a third of the time of a small frame. A kept block is poisoned, so a use
/// after its release is still found.
class LargeBlocks {
 public:
  static constexpr size_t kSmallest = 32u << 10, kMostBytes = 256u << 20;

  void* take(size_t size, size_t alignment) {
    std::vector<void*>& kept = blocks_[{size, alignment}];
    if (kept.empty()) return nullptr;
    void* const block = kept.back();
    kept.pop_back();
    bytes_ -= size;
    ASAN_UNPOISON_MEMORY_REGION(block, size);
    return block;
  }

  /// Returns false if the caller frees the block.
  bool keep(void* block, size_t size, size_t alignment) {
    if (size < kSmallest || bytes_ + size > kMostBytes) return false;
    ASAN_POISON_MEMORY_REGION(block, size);
    blocks_[{size, alignment}].push_back(block);
    bytes_ += size;
    return true;
  }

 private:
  std::map<std::pair<size_t, size_t>, std::vector<void*>> blocks_;
  size_t bytes_ = 0;
};

inline LargeBlocks& large_blocks() {
  static LargeBlocks* const blocks = new LargeBlocks;
  return *blocks;
}

/// Host memory that counts live allocations and refuses all after `budget` ones.
struct Memory {
  long live = 0;
  uint64_t budget = UINT64_MAX;
};

/// One input in 32 runs out of memory at one of its first allocations.
inline uint64_t choose_budget(Source& source) {
  const uint32_t budget = source.below(64);
  return source.one_in(32) ? 2 + budget : UINT64_MAX;  // two: the context and its executor
}

/// Whether to run an input again, on the baseline. A build with one SIMD target repeats one run in four.
inline bool check_twice(Source& source) {
#ifdef HWY_COMPILE_ONLY_SCALAR
  return source.one_in(4);
#else
  (void)source;
  return true;
#endif
}

/// A context on `simd` with one worker that takes its memory from `memory`.
class Host {
 public:
  Host(shd_simd simd, uint64_t budget) {
    memory.budget = budget;
    shd_context_desc desc = shd_context_desc_default();
    desc.simd = simd;
    desc.worker_count = 1;
    desc.allocator.user_data = &memory;
    desc.allocator.allocate = [](size_t size, size_t alignment, void* user_data) -> void* {
      Memory& self = *static_cast<Memory*>(user_data);
      if (self.budget == 0) return nullptr;
      void* result = size < LargeBlocks::kSmallest ? nullptr : large_blocks().take(size, alignment);
      if (!result && posix_memalign(&result, alignment, size)) return nullptr;
      --self.budget;
      ++self.live;
      return result;
    };
    desc.allocator.free = [](void* pointer, size_t size, size_t alignment, void* user_data) {
      --static_cast<Memory*>(user_data)->live;
      if (!large_blocks().keep(pointer, size, alignment)) std::free(pointer);
    };
    const shd_result result = shd_context_create(&desc, &context);
    SHD_FUZZ_CHECK(result == SHD_OK || memory.budget == 0);
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  ~Host() {
    shd_context_release(context);
    SHD_FUZZ_CHECK(memory.live == 0);
  }

  /// True for SHD_OK. A failure has a text, a plausible code, and is out of memory only where memory ran out.
  bool ok(shd_result result) const {
    if (result == SHD_OK) return true;
    SHD_FUZZ_CHECK(shd_last_error()[0] != '\0');
    SHD_FUZZ_CHECK(result == SHD_ERROR_INVALID_ARGUMENT || result == SHD_ERROR_UNSUPPORTED ||
                   (result == SHD_ERROR_OUT_OF_MEMORY && memory.budget == 0));
    return false;
  }

  Memory memory;
  shd_context* context = nullptr;
};

constexpr float kCanary = -12345.75f;
constexpr uint32_t kCanaryWord = 0xc0ffee11u;

/// An output column of `count` elements `step` elements apart. Elements in between and behind are canaries.
template <class T>
class Column {
 public:
  Column(size_t count, size_t step, T canary)
      : values_(count * step + 1, canary), count_(count), step_(step), canary_(canary) {}
  T* data() { return values_.data(); }
  size_t stride() const { return step_ * sizeof(T); }
  T operator[](size_t i) const { return values_[i * step_]; }
  size_t size() const { return count_; }

  /// Nothing but elements below `end` was written.
  void check_canaries(size_t end) const {
    for (size_t i = 0; i < values_.size(); ++i) {
      if (i % step_ != 0 || i / step_ >= end) SHD_FUZZ_CHECK(std::memcmp(&values_[i], &canary_, sizeof(T)) == 0);
    }
  }
  void check_canaries() const { check_canaries(count_); }

 private:
  std::vector<T> values_;
  size_t count_, step_;
  T canary_;
};

inline shd_f32_out to_column(Column<float>& column) {
  return shd_f32_out_column(column.data(), column.stride());
}
inline shd_u32_out to_column(Column<uint32_t>& column) {
  return shd_u32_out_column(column.data(), column.stride());
}

/// Equal bits. Any NaN equals any other NaN, because IEEE 754 does not define the payload.
inline bool same_value(float a, float b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

inline bool same_values(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    if (!same_value(a[i], b[i])) return false;
  }
  return true;
}

/// Runs the case of an input on the best SIMD target and on the baseline, and compares the outputs.
/// choose(source, case) makes the case, run(case, simd, output) calls the library, and check(best, baseline) compares.
template <class Case, class Output, class Choose, class Run, class Check>
void compare_targets(const uint8_t* data, size_t size, Choose choose, Run run, Check check) {
  Source source(data, size);
  Case c;
  choose(source, c);
  Output best{}, baseline{};
  run(c, SHD_SIMD_BEST, best);
  if (!check_twice(source)) return;
  run(c, SHD_SIMD_BASELINE, baseline);
  check(best, baseline);
}

}  // namespace shd::fuzz
