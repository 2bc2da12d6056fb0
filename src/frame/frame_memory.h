// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>

#include "core/context.h"

namespace shd::frame {

/// A copy of a context whose allocator counts its bytes.
class FrameMemory {
 public:
  explicit FrameMemory(const core::Context& host) : host_(host.allocator.callbacks) {
    context.tag = host.tag;
    context.allocator.callbacks = {allocate, free, this};
    context.executor = host.executor;
    context.log = host.log;
    context.simd = host.simd;
  }
  FrameMemory(const FrameMemory&) = delete;
  FrameMemory& operator=(const FrameMemory&) = delete;

  /// The largest number of bytes allocated at any time so far.
  size_t peak() const { return peak_; }

  core::Context context{};

 private:
  static void* allocate(void* user_data, size_t size, size_t alignment) {
    auto& self = *static_cast<FrameMemory*>(user_data);
    void* memory = self.host_.allocate(self.host_.user_data, size, alignment);
    if (!memory) return nullptr;
    const size_t used = self.used_.fetch_add(size, std::memory_order_relaxed) + size;
    for (size_t peak = self.peak_; used > peak && !self.peak_.compare_exchange_weak(peak, used);) {
    }
    return memory;
  }
  static void free(void* user_data, void* memory, size_t size, size_t alignment) {
    auto& self = *static_cast<FrameMemory*>(user_data);
    self.used_.fetch_sub(size, std::memory_order_relaxed);
    self.host_.free(self.host_.user_data, memory, size, alignment);
  }

  const shd_allocator host_;
  std::atomic<size_t> used_{0}, peak_{0};
};

}  // namespace shd::frame
