// SPDX-License-Identifier: MIT
#include <shd/context.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "core/cache_pool.h"
#include "core/scratch.h"

namespace {

using namespace shd;
using namespace shd::abi;

shd_result check_context_desc(const shd_context_desc& desc) {
  SHD_TRY(check_flags("context.flags", desc.flags, SHD_CONTEXT_RETURN_MEMORY));
  SHD_TRY(check_count("context.worker_count", desc.worker_count, 0, 1024));
  SHD_TRY(check_enum("context.simd", desc.simd, SHD_SIMD_BEST, SHD_SIMD_WASM));
  if (!desc.allocator.allocate != !desc.allocator.free) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "context.allocator.%s: NULL, but the other callback is set",
                      desc.allocator.allocate ? "free" : "allocate");
  }
  if (desc.executor.parallel_for) {
    SHD_TRY(check_count("context.executor.worker_count", desc.executor.worker_count, 1, 1024));
  } else {
    SHD_TRY(check_zero("context.executor.worker_count without parallel_for", desc.executor.worker_count));
  }
  return SHD_OK;
}

}  // namespace

extern "C" {

shd_result shd_context_create(const shd_context_desc* desc, shd_context** out_context) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_context", out_context));
    *out_context = nullptr;
    shd_context_desc read = shd_context_desc_default();
    SHD_TRY(read_desc("context", desc, true, &read));
    SHD_TRY(check_context_desc(read));
    *out_context = reinterpret_cast<shd_context*>(core::create_context(read));
    return SHD_OK;
  });
}

void shd_context_retain(shd_context* context) {
  if (context && context_of(context).tag == core::kContextTag) core::retain(context_of(context));
}

void shd_context_release(shd_context* context) {
  if (context && context_of(context).tag == core::kContextTag) core::release(context_of(context));
}

void shd_context_trim(shd_context* context) {
  if (context && context_of(context).tag == core::kContextTag) {
    context_of(context).scratch->trim(context_of(context).allocator);
    context_of(context).caches->trim();
  }
}

const char* shd_context_get_simd_target(const shd_context* context) {
  return check_context(context) == SHD_OK ? context_of(context).simd.name : "";
}

size_t shd_context_get_worker_count(const shd_context* context) {
  return check_context(context) == SHD_OK ? context_of(context).executor.worker_count : 0;
}

}  // extern "C"
