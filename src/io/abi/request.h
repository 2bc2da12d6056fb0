// SPDX-License-Identifier: MIT
#pragma once

#include <shd/io.h>

#include "extension/error.h"
#include "io/bitmap/bitmap.h"
#include "io/container/texture_load.h"
#include "io/file/read_file.h"

/// Load descs, and the load of a file.
namespace shd::extension {

/// A load desc, read and checked.
struct LoadRequest {
  shd_load_desc desc = shd_load_desc_default();
  io::LoadOptions options;
};

/// Throws Failure (SHD_ERROR_UNSUPPORTED) if `value` has other bits than `known`.
void require_flags(const char* field, uint32_t value, uint32_t known);

/// Reads and checks a desc; null has the defaults. Throws Failure.
LoadRequest read_load_desc(const shd_load_desc* in);

/// Whether the load decodes in this process.
bool in_process(const LoadRequest& request);

/// A file to load: open, or in the caller's memory.
struct Input {
  const char* path = nullptr;  // null = in memory
  io::OpenFile file;
  const unsigned char* bytes = nullptr;
  size_t size = 0;
};

/// Opens a file. Throws Failure beyond the budgets.
Input open_input(const char* path, const LoadRequest& request);

/// Bytes in the caller's memory. Throws Failure beyond the budgets.
Input memory_input(const void* bytes, size_t size, const LoadRequest& request);

/// Throws a failure again, with the path of its input.
[[noreturn]] void refuse_path(const Input& input, const Failure& failure);

/// Runs `body` with failures that name the path of an input.
template <class Body>
auto with_path(const Input& input, Body&& body) -> decltype(body()) {
  if (!input.path) return body();
  try {
    return body();
  } catch (const Failure& failure) {
    refuse_path(input, failure);
  }
}

/// The kind of a file, by its first bytes.
io::Container container_of(const Input& input);

/// Loads a file, by the worker unless the request is for this process.
io::Bitmap load_input(shd_context* context, const Input& input, const LoadRequest& request);

}  // namespace shd::extension
