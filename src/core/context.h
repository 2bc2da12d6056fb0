// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

#include "core/allocator.h"
#include "core/failure.h"
#include "core/object.h"
#include "core/simd_target.h"

namespace shd::core {

class CachePool;
class ScratchPool;

/// The body of a shd_context: the host's callbacks and the handles made with them.
struct Context {
  uint32_t tag;  // kContextTag while alive
  std::atomic<uint32_t> references;
  Allocator allocator;
  shd_executor executor;    // parallel_for is never null
  void* built_in_executor;  // body of the built-in executor; null if the host provides the executor or none is needed
  shd_log log;
  SimdTarget simd;
  ObjectPool objects;
  ScratchPool* scratch;  // working memory between calls
  CachePool* caches;     // decoded blocks of compressed textures; null in the copy of a ScratchScope
};

constexpr uint32_t kContextTag = 0x43646873;  // "shdC"

/// Creates a context from a checked desc. Throws std::bad_alloc, or Failure for a SIMD target that cannot run.
Context* create_context(const shd_context_desc& desc);

void retain(Context& context) noexcept;
void release(Context& context) noexcept;

/// Formats one line for the host's log; does nothing without a log.
void log(const Context& context, shd_log_level level, const char* format, ...) noexcept SHD_PRINTF(3, 4);

}  // namespace shd::core
