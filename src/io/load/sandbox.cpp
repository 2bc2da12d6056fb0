// SPDX-License-Identifier: MIT
// Loads of WebAssembly, in place of isolate.cpp: what a decoder can reach is the memory of its instance.
#include "io/load/isolate.h"

namespace shd::io {

Bitmap load_isolated(const char*, const Source& source, const LoadOptions& options, const Memory& memory,
                     const Deadline& deadline) {
  return load_in_process(source, options, memory, deadline);
}

}  // namespace shd::io
