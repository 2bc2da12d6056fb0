// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/file_descriptor.h"
#include "io/file/limits.h"
#include "io/file/memory.h"

namespace shd::io {

/// A file and the number of its bytes.
struct OpenFile {
  FileDescriptor file;
  size_t size = 0;
};

/// Opens a regular file. Throws Failure.
core::RegularFile open_file(const char* path);

/// Opens a regular file of 1..limits.file_bytes bytes. Throws Failure.
OpenFile open_file(const char* path, const Limits& limits);

/// Reads `size` bytes of a file from offset `at` on, or the next ones of a socket.
void read_bytes_at(int file, uint64_t at, size_t size, unsigned char* out);

/// Reads the first `size` bytes of a file, or the next ones of a socket.
Buffer read_bytes(int file, size_t size, const Memory& memory);

}  // namespace shd::io
