// SPDX-License-Identifier: MIT
#include "core/context.h"

#include <cstdarg>
#include <cstdio>

#include "core/cache_pool.h"
#include "core/executor.h"
#include "core/scratch.h"

namespace shd::core {

Context* create_context(const shd_context_desc& desc) {
  const SimdTarget simd = find_simd_target(desc.simd);
  const Allocator allocator{desc.allocator.allocate ? desc.allocator : default_allocator()};

  Context* context = create<Context>(allocator);
  context->scratch = nullptr;
  context->caches = nullptr;
  context->built_in_executor = nullptr;
  context->tag = kContextTag;
  context->references.store(1, std::memory_order_relaxed);
  context->allocator = allocator;
  context->log = desc.log;
  context->simd = simd;
  context->executor = desc.executor;
  try {
    const bool keeps = !(desc.flags & SHD_CONTEXT_RETURN_MEMORY);
    context->objects.attach();
    context->scratch = create<ScratchPool>(allocator, keeps);
    context->caches = create<CachePool>(allocator, allocator, keeps, kCacheSize);
    if (!desc.executor.parallel_for) {
      context->built_in_executor = create_executor(context->allocator, desc.worker_count, &context->executor);
    }
  } catch (...) {
    destroy(allocator, context->caches);
    destroy(allocator, context->scratch);
    destroy(allocator, context);
    throw;
  }
  return context;
}

void retain(Context& context) noexcept {
  context.references.fetch_add(1, std::memory_order_relaxed);
}

void release(Context& context) noexcept {
  if (context.references.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
  context.tag = 0;
  const Allocator allocator = context.allocator;
  if (context.built_in_executor) destroy_executor(context.allocator, context.built_in_executor);
  context.caches->trim();
  destroy(allocator, context.caches);
  context.scratch->trim(allocator);
  destroy(allocator, context.scratch);
  context.objects.free_all(allocator);
  destroy(allocator, &context);
}

void log(const Context& context, shd_log_level level, const char* format, ...) noexcept {
  if (!context.log.write) return;
  char line[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  context.log.write(level, line, context.log.user_data);
}

}  // namespace shd::core
