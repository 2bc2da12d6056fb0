// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Writes these bytes to `path` atomically: writes and flushes a temporary file beside it, then renames it. Keeps the
/// permissions of a file that it replaces, and follows symbolic links.
void write_file(const char* path, const void* bytes, size_t size);

}  // namespace shd::io
