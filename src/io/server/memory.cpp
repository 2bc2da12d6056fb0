// SPDX-License-Identifier: MIT
#include "io/server/memory.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace shd::io {

namespace {

constexpr size_t kPage = 4096;  // smallest page of any system
constexpr size_t kHugePage = size_t{1} << 21;
constexpr size_t kPiece = size_t{1} << 17;  // size of the pieces that prepare_heap() takes
constexpr int kMostPieces = 512;

/// New memory of the process, with huge pages like those of the default allocator of a context. Its end is one of a
/// huge page, so that the last bytes have a huge page, too.
void* map_pages(size_t size) {
  if (size > PTRDIFF_MAX - 2 * kHugePage) return nullptr;
  size = (size + kHugePage - 1) / kHugePage * kHugePage;
  void* const mapped =
      ::mmap(nullptr, size + kHugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (mapped == MAP_FAILED) return nullptr;
  const size_t offset = (kHugePage - reinterpret_cast<uintptr_t>(mapped) % kHugePage) % kHugePage;
  void* const memory = static_cast<unsigned char*>(mapped) + offset;
#ifdef MADV_HUGEPAGE
  (void)::madvise(memory, size, MADV_HUGEPAGE);
#endif
  return memory;
}

void* plain_allocate(void*, size_t size) {
  if (size >= kHugePage) return map_pages(size);
  void* memory = nullptr;
  if (::posix_memalign(&memory, 64, size) != 0) return nullptr;
  return std::memset(memory, 0, size);
}

void plain_free(void*, void* memory, size_t size) {
  if (size < kHugePage) std::free(memory);  // larger blocks live as long as the process, which ends soon
}

}  // namespace

const Memory kWorkerMemory = {nullptr, plain_allocate, plain_free, true};

void prepare_heap(size_t size) {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
  size = std::min(size, size_t{1} << 30);
  const uintptr_t end = reinterpret_cast<uintptr_t>(::sbrk(0)), start = (end + kHugePage - 1) / kHugePage * kHugePage;
  if (::sbrk(static_cast<intptr_t>(start - end)) == reinterpret_cast<void*>(-1)) return;  // malloc() leaves this gap
  (void)::mallopt(M_MMAP_MAX, 0);
  (void)::mallopt(M_TRIM_THRESHOLD, -1);
  (void)::mallopt(M_TOP_PAD, static_cast<int>(size));
  // Pieces of the old heap, which has small pages, are taken and never used. The last one is at the start of the new
  // heap. Its header and the next one make small pages there before madvise() can be called, so all of that huge page
  // is taken, too.
  void* volatile piece = nullptr;  // a compiler may leave out unused memory
  for (int i = 0; i < kMostPieces && reinterpret_cast<uintptr_t>(piece) < start; ++i) piece = std::malloc(kPiece);
  const auto last = reinterpret_cast<uintptr_t>(::sbrk(0));
  (void)::mallopt(M_TOP_PAD, static_cast<int>(kHugePage));
  if (last > start) (void)::madvise(reinterpret_cast<void*>(start), last - start, MADV_HUGEPAGE);
  piece = std::malloc(kHugePage - kPiece);
#else
  (void)size;
#endif
}

// The bytes that the pipe refers to end at next_. They reach back at most capacity_ bytes and the unused end of the
// last lap, which is less than largest_. The ring has room for them and for another largest_ bytes.
unsigned char* LentRing::room(size_t size) {
  size = (size + kPage - 1) / kPage * kPage;
  if (size > largest_) {  // an older, smaller ring stays mapped
    size_ = capacity_ + 2 * size;
    base_ = static_cast<unsigned char*>(map_pages(size_));
    if (!base_) throw std::bad_alloc();
    largest_ = size;
    next_ = 0;
  }
  if (size > size_ - next_) next_ = 0;
  unsigned char* const room = base_ + next_;
  next_ += size;
  return room;
}

}  // namespace shd::io
