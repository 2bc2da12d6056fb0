// SPDX-License-Identifier: MIT
#include "core/scratch.h"

#include <algorithm>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>
#else
#define ASAN_POISON_MEMORY_REGION(memory, size) ((void)(memory), (void)(size))
#define ASAN_UNPOISON_MEMORY_REGION(memory, size) ((void)(memory), (void)(size))
#endif

namespace shd::core {

/// Multiples of 64 up to 512, then eight sizes for each power of two.
Scratch::SizeClass Scratch::class_of(size_t size) {
  constexpr size_t kStep = 6;
  if (size <= size_t{8} << kStep) {
    const size_t steps = (size + (size_t{1} << kStep) - 1) >> kStep;
    return {steps - 1, steps << kStep};
  }
  const size_t shift = static_cast<size_t>(63 - __builtin_clzll(size - 1)) - 3;
  const size_t steps = ((size - 1) >> shift) + 1;  // 9..16
  return {8 * (shift - kStep + 1) + steps - 9, steps << shift};
}

void* Scratch::take_from_host(size_t size) noexcept {
  void* memory = host_.try_allocate(size);
  if (!memory && release_large()) memory = host_.try_allocate(size);
  if (!memory) {
    failed_ = true;
    return nullptr;
  }
  held_ += size;
  peak_ = std::max(peak_, held_);
  return memory;
}

void* Scratch::take_from_chunk(size_t size) noexcept {
  if (size > rest_) {
    void* chunk = take_from_host(kChunk);
    if (!chunk) return nullptr;
    chunks_ = new (chunk) Block{chunks_};
    next_ = static_cast<uint8_t*>(chunk) + kAlignment;
    rest_ = kChunk - kAlignment;
  }
  void* memory = next_;
  next_ += size;
  rest_ -= size;
  return memory;
}

void* Scratch::take(size_t size) noexcept {
  if (!keeps_) return take_from_host(size);
  const SizeClass found = class_of(size);
  Block*& first = free_[found.index];
  if (!first) return found.size <= kLargestSmall ? take_from_chunk(found.size) : take_from_host(found.size);
  Block* block = first;
  ASAN_UNPOISON_MEMORY_REGION(block, found.size);
  first = block->next;
  return block;
}

void* Scratch::allocate(size_t size) noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  void* memory = take(size);
  if (memory) used_ += size;
  most_used_ = std::max(most_used_, used_);
  return memory;
}

void Scratch::free(void* memory, size_t size) noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  used_ -= size;
  if (!keeps_) {
    host_.free(memory, size);
    held_ -= size;
    return;
  }
  const SizeClass found = class_of(size);
  Block* block = new (memory) Block{free_[found.index]};
  free_[found.index] = block;
  ASAN_POISON_MEMORY_REGION(block + 1, found.size - sizeof *block);
}

void Scratch::begin() {
  peak_ = held_;
  most_used_ = 0;
}

void Scratch::end() noexcept {
  small_calls_ = most_used_ < held_ / 4 ? small_calls_ + 1 : 0;
  if (failed_ || small_calls_ >= kSmallCalls) release();
}

/// Returns the free blocks that are not part of a chunk to the host. Returns whether there were any.
bool Scratch::release_large() noexcept {
  const size_t before = held_;
  for (size_t i = class_of(kLargestSmall).index + 1; i < kClasses; ++i) {
    const size_t size = (i % 8 + 9) << (i / 8 + 5);
    while (Block* block = free_[i]) {
      ASAN_UNPOISON_MEMORY_REGION(block, size);
      free_[i] = block->next;
      host_.free(block, size);
      held_ -= size;
    }
  }
  return held_ < before;
}

void Scratch::release() noexcept {
  release_large();
  std::fill_n(free_, kClasses, nullptr);
  while (Block* chunk = chunks_) {
    ASAN_UNPOISON_MEMORY_REGION(chunk, kChunk);
    chunks_ = chunk->next;
    host_.free(chunk, kChunk);
    held_ -= kChunk;
  }
  rest_ = 0;
  small_calls_ = 0;
  failed_ = false;
}

Scratch* ScratchPool::take(const Allocator& host) {
  {
    const std::lock_guard<ForkMutex> lock(mutex_);
    if (Scratch* scratch = first_) {
      first_ = scratch->next_in_pool_;
      return scratch;
    }
  }
  return create<Scratch>(host, host, keeps_);
}

void ScratchPool::put(const Allocator& host, Scratch* scratch) noexcept {
  if (!keeps_) return destroy(host, scratch);
  const std::lock_guard<ForkMutex> lock(mutex_);
  scratch->next_in_pool_ = first_;
  first_ = scratch;
}

void ScratchPool::trim(const Allocator& host) noexcept {
  Scratch* scratch = nullptr;
  {
    const std::lock_guard<ForkMutex> lock(mutex_);
    std::swap(scratch, first_);
  }
  while (scratch) destroy(host, std::exchange(scratch, scratch->next_in_pool_));
}

ScratchScope::ScratchScope(const Context& host) : host_(host), scratch_(host.scratch->take(host.allocator)) {
  scratch_->begin();
  context.tag = host.tag;
  context.allocator.callbacks = {
      [](size_t size, size_t, void* scratch) { return static_cast<Scratch*>(scratch)->allocate(size); },
      [](void* memory, size_t size, size_t, void* scratch) { static_cast<Scratch*>(scratch)->free(memory, size); },
      scratch_};
  context.executor = host.executor;
  context.log = host.log;
  context.simd = host.simd;
}

ScratchScope::~ScratchScope() {
  scratch_->end();
  host_.scratch->put(host_.allocator, scratch_);
}

}  // namespace shd::core
