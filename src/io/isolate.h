// SPDX-License-Identifier: MIT
#pragma once

#include "io/io.h"

namespace shd::io {

/// Decodes in a child process, which is killed at the deadline. If the process dies, the result is SHD_ERROR_CORRUPT.
/// Its reply is checked like any input. A null worker_path selects the worker that belongs to this library.
Bitmap load_isolated(const char* worker_path, const unsigned char* bytes, size_t size, const LoadOptions& options,
                     const Memory& memory, const Deadline& deadline);

}  // namespace shd::io
