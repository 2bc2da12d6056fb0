// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "core/fork.h"

namespace shd::core {

/// Size of a piece of a context's pool [bytes].
constexpr size_t kCacheSize = size_t{310} << 10;

/// Memory that a later call finds as an earlier call left it: copies of data of an object, called its owner. A call has
/// its memory for itself. There are at most kMost pieces of one size, so that the memory stays bounded for any number
/// of owners and threads. Any thread.
class CachePool {
 public:
  static constexpr size_t kMost = 32;

  /// A piece of memory for one call, or no memory: the pool keeps none, all pieces are in use, or the host has none.
  struct Lease {
    void* memory = nullptr;
    bool left_by_owner = false;  // false: the content is not defined
    size_t slot = 0;
  };

  /// Throws std::bad_alloc.
  /// @param host   outlives the pool
  /// @param keeps  false: take() gives no memory
  /// @param size   bytes of a piece
  CachePool(const Allocator& host, bool keeps, size_t size);

  /// Returns a number that no other owner has; it is not 0.
  uint64_t new_owner() noexcept { return last_owner_.fetch_add(1, std::memory_order_relaxed) + 1; }

  /// `owner` is not 0. Prefers the memory that a call for the same owner left.
  Lease take(uint64_t owner) noexcept;
  void put(const Lease& lease) noexcept;

  /// Returns the memory that is not in use to the host.
  void trim() noexcept;

 private:
  struct Slot {
    std::atomic<uint64_t> owner{0};      // owner of the content; changes while the slot is in use only
    std::atomic<uintptr_t> user{0};      // thread that took the slot, or 0
    std::atomic<void*> memory{nullptr};  // changes while the slot is in use only
  };

  /// Marks a slot as in use. Returns whether it was free.
  static bool claim(Slot& slot) noexcept;
  static void free(Slot& slot) noexcept { slot.user.store(0, std::memory_order_release); }
  static void free_lost(void* pool) noexcept;
  Lease lease(size_t i, uint64_t owner) noexcept;

  const Allocator host_;
  const bool keeps_;
  const size_t size_;
  std::atomic<uint64_t> last_owner_{0};
  std::atomic<uint32_t> turn_{0};
  Slot slots_[kMost];
  ForkHook hook_;
};

}  // namespace shd::core
