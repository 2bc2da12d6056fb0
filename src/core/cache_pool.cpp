// SPDX-License-Identifier: MIT
#include "core/cache_pool.h"

namespace shd::core {

CachePool::CachePool(const Allocator& host, bool keeps, size_t size) : host_(host), keeps_(keeps), size_(size) {
  hook_.attach(free_lost, this);
}

/// In a child: the threads that took these slots do not exist, and may have written a part of the content.
void CachePool::free_lost(void* pool) noexcept {
  for (Slot& slot : static_cast<CachePool*>(pool)->slots_) {
    const uintptr_t user = slot.user.load(std::memory_order_relaxed);
    if (user == 0 || user == thread_number()) continue;
    slot.owner.store(0, std::memory_order_relaxed);
    free(slot);
  }
}

bool CachePool::claim(Slot& slot) noexcept {
  uintptr_t nobody = 0;
  return slot.user.load(std::memory_order_relaxed) == 0 &&
         slot.user.compare_exchange_strong(nobody, thread_number(), std::memory_order_acquire);
}

CachePool::Lease CachePool::lease(size_t i, uint64_t owner) noexcept {
  Slot& slot = slots_[i];
  const bool same = slot.owner.load(std::memory_order_relaxed) == owner;
  slot.owner.store(owner, std::memory_order_relaxed);
  return {slot.memory.load(std::memory_order_relaxed), same, i};
}

CachePool::Lease CachePool::take(uint64_t owner) noexcept {
  if (!keeps_) return {};
  for (size_t i = 0; i < kMost; ++i) {
    if (slots_[i].owner.load(std::memory_order_relaxed) != owner || !claim(slots_[i])) continue;
    if (slots_[i].memory.load(std::memory_order_relaxed)) return lease(i, owner);
    free(slots_[i]);  // trim() was faster
  }
  for (size_t i = 0; i < kMost; ++i) {
    Slot& slot = slots_[i];
    if (slot.memory.load(std::memory_order_relaxed) || !claim(slot)) continue;
    void* memory = slot.memory.load(std::memory_order_relaxed);
    if (!memory) {
      memory = host_.try_allocate(size_);
      slot.memory.store(memory, std::memory_order_relaxed);
      slot.owner.store(0, std::memory_order_relaxed);
    }
    if (memory) return lease(i, owner);
    free(slot);
    break;
  }
  const uint32_t first = turn_.fetch_add(1, std::memory_order_relaxed);
  for (size_t k = 0; k < kMost; ++k) {
    const size_t i = (first + k) % kMost;
    if (!slots_[i].memory.load(std::memory_order_relaxed) || !claim(slots_[i])) continue;
    if (slots_[i].memory.load(std::memory_order_relaxed)) return lease(i, owner);
    free(slots_[i]);
  }
  return {};
}

void CachePool::put(const Lease& lease) noexcept {
  free(slots_[lease.slot]);
}

void CachePool::trim() noexcept {
  for (Slot& slot : slots_) {
    if (!claim(slot)) continue;
    if (void* memory = slot.memory.exchange(nullptr, std::memory_order_relaxed)) host_.free(memory, size_);
    slot.owner.store(0, std::memory_order_relaxed);
    free(slot);
  }
}

}  // namespace shd::core
