// SPDX-License-Identifier: MIT
#pragma once

#include "io/io.h"

namespace shd::io {

/// Decodes in a child process, which is killed at the deadline. A process that dies is SHD_ERROR_CORRUPT. Its reply is
/// checked like any input. worker_path null = the worker that belongs to this library.
Bitmap load_isolated(const char* worker_path, const unsigned char* bytes, size_t size, const LoadOptions& options,
                     const Memory& memory, const Deadline& deadline);

}  // namespace shd::io
