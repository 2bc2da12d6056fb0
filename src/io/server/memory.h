// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "io/file/memory.h"

namespace shd::io {

/// Memory of a child of the worker. New blocks are zero; large ones live as long as the process.
extern const Memory kWorkerMemory;

/// Prepares malloc of this child for about `size` bytes: one heap of huge pages. Faults of small pages took half of the
/// time of a large model on a virtual machine.
void prepare_heap(size_t size);

/// Memory for bytes that are lent to a pipe: the pipe refers to them until the other end has read them. A pipe of
/// `capacity` bytes has one place for each page of them. So it refers to at most the last `capacity` bytes of a ring of
/// whole pages. Older bytes can be overwritten: a picture goes through a few pages that stay in the processor's cache,
/// and no new page is cleared.
class LentRing {
 public:
  explicit LentRing(size_t capacity) : capacity_(capacity) {}
  /// Memory for the next `size` bytes of the pipe, aligned to pages. Throws std::bad_alloc.
  unsigned char* room(size_t size);

 private:
  size_t capacity_;
  size_t largest_ = 0;  // room so far
  size_t size_ = 0;
  size_t next_ = 0;
  unsigned char* base_ = nullptr;
};

}  // namespace shd::io
