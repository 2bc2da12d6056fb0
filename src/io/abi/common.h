// SPDX-License-Identifier: MIT
#pragma once

#include <shd/io.h>

#include "extension/desc.h"
#include "extension/guard.h"
#include "io/file/memory.h"

/// Functions shared by the bodies of shd/io.h.
namespace shd::extension {

/// Throws Failure for no path and an empty one.
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
