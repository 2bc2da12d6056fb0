// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Makes `path` a file of these bytes, whole or not at all: a temporary sibling, flushed, then renamed. Keeps
/// the permissions of a file it replaces and follows symbolic links.
void write_file(const char* path, const void* bytes, size_t size);

}  // namespace shd::io
