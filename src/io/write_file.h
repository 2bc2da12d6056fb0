// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Makes `path` a file of these bytes, whole or not at all: writes and flushes a temporary file beside it and renames
/// that. Keeps the permissions of a file that it replaces and follows symbolic links.
void write_file(const char* path, const void* bytes, size_t size);

}  // namespace shd::io
