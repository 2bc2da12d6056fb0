// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "io/file_descriptor.h"

namespace shd::io {

/// An anonymous file with a path, for decoders that need a path.
class MemoryFile {
 public:
  /// Creates the file if `wanted`; copies the bytes.
  MemoryFile(bool wanted, const unsigned char* bytes, size_t size);
  const std::string& path() const { return path_; }

 private:
  FileDescriptor file_;
  std::string path_;
};

}  // namespace shd::io
