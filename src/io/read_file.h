// SPDX-License-Identifier: MIT
#pragma once

#include "io/limits.h"
#include "io/memory.h"

namespace shd::io {

/// Reads a regular file of 1..limits.file_bytes bytes. Never blocks on a FIFO or a device.
Buffer read_file(const char* path, const Limits& limits, const Memory& memory);

}  // namespace shd::io
