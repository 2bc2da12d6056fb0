// SPDX-License-Identifier: MIT
#pragma once

#include "io/io.h"

namespace shd::io {

/// Decodes in a child process, which is killed at the deadline; its death is SHD_ERROR_CORRUPT. What it answers
/// is checked like any input. worker_path null = the one that belongs to this library.
Bitmap load_isolated(const char* worker_path, const unsigned char* bytes, size_t size, const LoadOptions& options,
                     const Memory& memory, const Deadline& deadline);

}  // namespace shd::io
