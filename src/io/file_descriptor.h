// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <utility>

namespace shd::io {

/// An owned file descriptor; negative = none.
struct FileDescriptor {
  explicit FileDescriptor(int descriptor = -1) : fd(descriptor) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd(std::exchange(other.fd, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd, other.fd);
    return *this;
  }
  ~FileDescriptor() { reset(); }
  void reset() {
    if (fd >= 0) ::close(fd);
    fd = -1;
  }
  int fd;
};

/// Throws a Failure with the text `<action> "<path>": <reason>`. A missing file is SHD_ERROR_NOT_FOUND, a path that the
/// system cannot have SHD_ERROR_INVALID_ARGUMENT, lack of memory SHD_ERROR_OUT_OF_MEMORY, the rest SHD_ERROR_IO.
[[noreturn]] void refuse_errno(const char* action, const char* path, int error);

}  // namespace shd::io
