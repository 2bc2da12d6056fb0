// SPDX-License-Identifier: MIT
#include "core/cache_pool.h"

namespace shd::core {

bool CachePool::claim(Slot& slot) noexcept {
  return !slot.used.load(std::memory_order_relaxed) && !slot.used.exchange(true, std::memory_order_acquire);
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
    slots_[i].used.store(false, std::memory_order_release);  // trim() was faster
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
    slot.used.store(false, std::memory_order_release);
    break;
  }
  const uint32_t first = turn_.fetch_add(1, std::memory_order_relaxed);
  for (size_t k = 0; k < kMost; ++k) {
    const size_t i = (first + k) % kMost;
    if (!slots_[i].memory.load(std::memory_order_relaxed) || !claim(slots_[i])) continue;
    if (slots_[i].memory.load(std::memory_order_relaxed)) return lease(i, owner);
    slots_[i].used.store(false, std::memory_order_release);
  }
  return {};
}

void CachePool::put(const Lease& lease) noexcept {
  slots_[lease.slot].used.store(false, std::memory_order_release);
}

void CachePool::trim() noexcept {
  for (Slot& slot : slots_) {
    if (!claim(slot)) continue;
    if (void* memory = slot.memory.load(std::memory_order_relaxed)) host_.free(memory, size_);
    slot.memory.store(nullptr, std::memory_order_relaxed);
    slot.owner.store(0, std::memory_order_relaxed);
    slot.used.store(false, std::memory_order_release);
  }
}

}  // namespace shd::core
