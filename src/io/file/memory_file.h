// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "io/file/file_descriptor.h"

namespace shd::io {

/// An anonymous file with a path, for decoders that need a path.
class MemoryFile {
 public:
  /// Creates the file if `wanted`; copies the bytes.
  MemoryFile(bool wanted, const unsigned char* bytes, size_t size);
  const std::string& path() const { return path_; }
  /// A message of a decoder with "the file" in place of the path, which differs from load to load.
  std::string without_path(std::string message) const;

 private:
  FileDescriptor file_;
  std::string path_;
};

}  // namespace shd::io
