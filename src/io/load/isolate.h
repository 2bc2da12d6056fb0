// SPDX-License-Identifier: MIT
#pragma once

#include "io/bitmap/bitmap.h"

namespace shd::io {

/// Input of a load: the first `size` bytes of a file, or of memory.
struct Source {
  int file;                    // if bytes is null
  const unsigned char* bytes;  // or null
  size_t size;
};

/// Decodes in this process.
Bitmap load_in_process(const Source& source, const LoadOptions& options, const Memory& memory,
                       const Deadline& deadline);

/// Decodes in a child of the worker, which is killed at the deadline. If the child dies, the result is
/// SHD_ERROR_CORRUPT. Its reply is checked like any input. A null worker_path selects the worker that belongs to this
/// library.
/// WebAssembly (sandbox.cpp) has no processes, and its instance is the sandbox: it decodes as load_in_process().
Bitmap load_isolated(const char* worker_path, const Source& source, const LoadOptions& options, const Memory& memory,
                     const Deadline& deadline);

}  // namespace shd::io
