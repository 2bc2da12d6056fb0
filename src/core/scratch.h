// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>

#include "core/context.h"
#include "core/fork.h"

namespace shd::core {

/// Working memory of a call, and then of the next one. Freed blocks are kept and serve later allocations of about their
/// size, so that a loop of equal calls allocates nothing after its first turn. Sizes are rounded up by less than 1/8.
/// Functions without a note may be called from any thread.
class Scratch {
 public:
  /// @param keeps  false: every block is allocated by the host and returned to it when it is freed
  Scratch(const Allocator& host, bool keeps) : host_(host), keeps_(keeps) {}
  ~Scratch() { release(); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  /// Returns memory aligned to kAlignment, or null. `size` > 0.
  void* allocate(size_t size) noexcept;
  void free(void* memory, size_t size) noexcept;

  /// The largest number of bytes that the host had allocated at any time since begin().
  size_t peak() const { return peak_; }

  /// Begins and ends a call; one thread. A call frees its blocks before it ends. Memory goes back to the host if the
  /// host had none left, or if many calls in a row need less than a quarter of it.
  void begin();
  void end() noexcept;

 private:
  static constexpr size_t kClasses = 440;
  static constexpr size_t kChunk = size_t{256} << 10, kLargestSmall = size_t{16} << 10;
  static constexpr uint32_t kSmallCalls = 16;

  struct SizeClass {
    size_t index, size;
  };
  struct Block {
    Block* next;
  };

  static SizeClass class_of(size_t size);
  void* take(size_t size) noexcept;
  void* take_from_chunk(size_t size) noexcept;
  void* take_from_host(size_t size) noexcept;
  bool release_large() noexcept;
  void release() noexcept;

  const Allocator host_;
  const bool keeps_;
  std::mutex mutex_;            // serves one call, and a child does not go on with the calls of other threads
  Block* free_[kClasses] = {};  // [class]
  Block* chunks_ = nullptr;     // memory of small blocks
  uint8_t* next_ = nullptr;     // rest of the first chunk
  size_t rest_ = 0;
  size_t held_ = 0, peak_ = 0;       // bytes allocated by the host
  size_t used_ = 0, most_used_ = 0;  // bytes of blocks that are not free
  uint32_t small_calls_ = 0;         // calls in a row that needed little of the memory
  bool failed_ = false;              // the host had no memory

  friend class ScratchPool;
  Scratch* next_in_pool_ = nullptr;
};

/// The working memory that no call uses at present. Any thread.
class ScratchPool {
 public:
  /// Throws std::bad_alloc.
  /// @param keeps  as for Scratch
  explicit ScratchPool(bool keeps) : keeps_(keeps) { mutex_.attach(); }

  /// Returns memory that an earlier call put here, or new memory. Throws std::bad_alloc.
  Scratch* take(const Allocator& host);
  void put(const Allocator& host, Scratch* scratch) noexcept;

  /// Returns all memory to the host.
  void trim(const Allocator& host) noexcept;

 private:
  const bool keeps_;
  ForkMutex mutex_{ForkLevel::kScratch};
  Scratch* first_ = nullptr;
};

/// A copy of a context for one call. Its allocator is working memory: every block is freed before the scope ends.
class ScratchScope {
 public:
  /// Throws std::bad_alloc.
  explicit ScratchScope(const Context& host);
  ~ScratchScope();
  ScratchScope(const ScratchScope&) = delete;
  ScratchScope& operator=(const ScratchScope&) = delete;

  /// Bytes of working memory, including those that the context kept from earlier calls.
  size_t peak() const { return sizeof *scratch_ + scratch_->peak(); }

  Context context{};

 private:
  const Context& host_;
  Scratch* scratch_;
};

}  // namespace shd::core
