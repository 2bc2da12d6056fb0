// SPDX-License-Identifier: MIT
#pragma once

#include <shd/io.h>

#include "abi/extension_desc.h"
#include "abi/extension_guard.h"
#include "io/failure.h"
#include "io/memory.h"

/// What the bodies of shd/io.h share.
namespace shd::extension {

/// guard() that also ends the exceptions of io/.
template <class Body>
shd_result io_guard(Body&& body) noexcept {
  return guard([&]() -> shd_result {
    try {
      return body();
    } catch (const io::Failure& failure) {
      return fail(failure.code, "%s", failure.what());
    }
  });
}

inline void require_context(shd_context* context) {
  if (shd_context_worker_count(context) == 0) throw Failure(SHD_ERROR_INVALID_ARGUMENT);  // which has set the text
}

inline void require_path(const char* path) {
  if (!path) refuse(SHD_ERROR_INVALID_ARGUMENT, "path: NULL");
  if (!*path) refuse(SHD_ERROR_INVALID_ARGUMENT, "path: empty");
}

/// The context's allocator.
inline io::Memory memory_of(shd_context* context) {
  constexpr size_t kAlignment = 64;
  return {
      context,
      [](void* owner, size_t size) { return shd_context_allocate(static_cast<shd_context*>(owner), size, kAlignment); },
      [](void* owner, void* memory, size_t size) {
        shd_context_free(static_cast<shd_context*>(owner), memory, size, kAlignment);
      }};
}

}  // namespace shd::extension
