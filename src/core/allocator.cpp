// SPDX-License-Identifier: MIT
#include "core/allocator.h"

#include <cstdlib>

namespace shd::core {
namespace {

void* default_allocate(void*, size_t size, size_t alignment) {
  void* memory = nullptr;
  return posix_memalign(&memory, alignment, size) == 0 ? memory : nullptr;
}

void default_free(void*, void* memory, size_t, size_t) {
  std::free(memory);
}

}  // namespace

void* Allocator::allocate(size_t size) const {
  if (size == 0) return nullptr;
  if (size > PTRDIFF_MAX) throw std::bad_alloc();
  void* memory = callbacks.allocate(callbacks.user_data, size, kAlignment);
  if (!memory) throw std::bad_alloc();
  return memory;
}

void Allocator::free(void* memory, size_t size) const noexcept {
  if (memory) callbacks.free(callbacks.user_data, memory, size, kAlignment);
}

shd_allocator default_allocator() noexcept {
  return {default_allocate, default_free, nullptr};
}

}  // namespace shd::core
