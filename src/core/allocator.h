// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

#include <shd/context.h>

namespace shd::core {

/// Alignment of every block: a cache line, and a whole AVX-512 vector.
constexpr size_t kAlignment = 64;

/// a * b. Throws std::bad_alloc if the product overflows.
inline size_t checked_mul(size_t a, size_t b) {
  size_t product;
  if (__builtin_mul_overflow(a, b, &product)) throw std::bad_alloc();
  return product;
}

/// The host's allocator. Copyable. The context that owns it outlives every block.
struct Allocator {
  shd_allocator callbacks;

  /// Returns memory aligned to kAlignment, or null for size 0. Throws std::bad_alloc.
  void* allocate(size_t size) const;
  /// Returns the same memory, or null if the host has none.
  void* try_allocate(size_t size) const noexcept;
  void free(void* memory, size_t size) const noexcept;
};

/// Aligned memory of the C library; large blocks use huge pages.
shd_allocator default_allocator() noexcept;

/// Creates a T in memory of the allocator.
template <class T, class... Arguments>
T* create(const Allocator& allocator, Arguments&&... arguments) {
  void* memory = allocator.allocate(sizeof(T));
  try {
    return new (memory) T(std::forward<Arguments>(arguments)...);
  } catch (...) {
    allocator.free(memory, sizeof(T));
    throw;
  }
}

template <class T>
void destroy(const Allocator& allocator, T* object) noexcept {
  if (!object) return;
  object->~T();
  allocator.free(object, sizeof(T));
}

/// Owns a fixed number of uninitialised T, aligned to kAlignment. T is trivially copyable.
template <class T>
class Array {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Array() = default;
  Array(const Allocator& allocator, size_t size)
      : allocator_(&allocator), size_(size), data_(static_cast<T*>(allocator.allocate(checked_mul(size, sizeof(T))))) {}
  Array(Array&& other) noexcept { swap(other); }
  Array& operator=(Array&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Array() {
    if (data_) allocator_->free(data_, size_ * sizeof(T));
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  size_t size() const { return size_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  T& operator[](size_t i) { return data_[i]; }
  const T& operator[](size_t i) const { return data_[i]; }
  void fill_zero() {
    if (size_) std::memset(static_cast<void*>(data_), 0, size_ * sizeof(T));
  }

 private:
  void swap(Array& other) noexcept {
    std::swap(allocator_, other.allocator_);
    std::swap(size_, other.size_);
    std::swap(data_, other.data_);
  }

  const Allocator* allocator_ = nullptr;
  size_t size_ = 0;
  T* data_ = nullptr;
};

/// Owns a fixed number of default-constructed T, which may own memory themselves.
template <class T>
class Objects {
 public:
  Objects(const Allocator& allocator, size_t size)
      : allocator_(&allocator),
        data_(static_cast<T*>(allocator.allocate(checked_mul(size, sizeof(T))))),
        bytes_(size * sizeof(T)) {
    try {
      for (; size_ < size; ++size_) new (data_ + size_) T();
    } catch (...) {
      clear();
      throw;
    }
  }
  Objects(const Objects&) = delete;
  Objects& operator=(const Objects&) = delete;
  ~Objects() { clear(); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  size_t size() const { return size_; }
  T& operator[](size_t i) { return data_[i]; }
  const T& operator[](size_t i) const { return data_[i]; }

 private:
  void clear() noexcept {
    while (size_ > 0) data_[--size_].~T();
    allocator_->free(data_, bytes_);
  }

  const Allocator* allocator_;
  T* data_;
  size_t bytes_;
  size_t size_ = 0;
};

/// An Array that grows at its end.
template <class T>
class Buffer {
 public:
  Buffer() = default;
  explicit Buffer(const Allocator& allocator) : allocator_(&allocator) {}

  /// Sets the allocator of a default-constructed buffer.
  void attach(const Allocator& allocator) { allocator_ = &allocator; }

  T* data() { return storage_.data(); }
  const T* data() const { return storage_.data(); }
  size_t size() const { return size_; }
  T& operator[](size_t i) { return storage_[i]; }
  const T& operator[](size_t i) const { return storage_[i]; }
  void clear() { size_ = 0; }

  void reserve(size_t capacity) {
    if (capacity <= storage_.size()) return;
    Array<T> larger(*allocator_, capacity);
    if (size_) std::memcpy(static_cast<void*>(larger.data()), storage_.data(), size_ * sizeof(T));
    storage_ = std::move(larger);
  }
  void push_back(const T& value) {
    if (size_ == storage_.size()) reserve(size_ ? checked_mul(size_, 2) : 64);
    storage_[size_++] = value;
  }
  /// Sets the size; new elements are uninitialised.
  void resize(size_t size) {
    reserve(size);
    size_ = size;
  }

 private:
  const Allocator* allocator_ = nullptr;
  Array<T> storage_;
  size_t size_ = 0;
};

}  // namespace shd::core
