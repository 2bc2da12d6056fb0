// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>
#include <utility>

#include <shd/extension.h>

namespace shd::color {

/// A block of the context's memory. The context outlives it.
class Array {
 public:
  /// Throws std::bad_alloc.
  Array(shd_context* context, size_t bytes)
      : context_(context), memory_(shd_context_allocate(context, bytes, kAlignment)), bytes_(bytes) {
    if (!memory_) throw std::bad_alloc();
  }
  ~Array() { shd_context_free(context_, memory_, bytes_, kAlignment); }
  Array(Array&& other) noexcept
      : context_(other.context_), memory_(std::exchange(other.memory_, nullptr)), bytes_(other.bytes_) {}
  Array& operator=(Array&&) = delete;
  Array(const Array&) = delete;
  Array& operator=(const Array&) = delete;

  template <class T>
  T* as() const {
    return static_cast<T*>(memory_);
  }
  size_t bytes() const { return bytes_; }

 private:
  static constexpr size_t kAlignment = 64;

  shd_context* context_;
  void* memory_;
  size_t bytes_;
};

}  // namespace shd::color
