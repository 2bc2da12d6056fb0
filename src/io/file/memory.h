// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>
#include <utility>

namespace shd::io {

/// The source of buffers: the host's allocator, or malloc in the worker. Blocks are aligned to 64 bytes.
struct Memory {
  void* owner;
  void* (*allocate)(void* owner, size_t size);
  void (*free)(void* owner, void* memory, size_t size);
  bool zeroed = false;  // new blocks are zero
};

/// An owned block of bytes.
class Buffer {
 public:
  Buffer() = default;
  /// Allocates uninitialised bytes; size 0 allocates nothing. Throws std::bad_alloc.
  Buffer(const Memory& memory, size_t size) : memory_(memory), size_(size) {
    if (size == 0) return;
    data_ = static_cast<unsigned char*>(memory.allocate(memory.owner, size));
    if (!data_) throw std::bad_alloc();
  }
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Buffer() {
    if (data_) memory_.free(memory_.owner, data_, size_);
  }
  unsigned char* data() const { return data_; }
  size_t size() const { return size_; }

 private:
  void swap(Buffer& other) {
    std::swap(memory_, other.memory_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
  }
  Memory memory_ = {};
  unsigned char* data_ = nullptr;
  size_t size_ = 0;
};

}  // namespace shd::io
