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

/// Throws a Failure with the text `<action> "<path>": <reason>`. The code is SHD_ERROR_NOT_FOUND for a missing file,
/// SHD_ERROR_INVALID_ARGUMENT for a path that the system cannot represent, SHD_ERROR_OUT_OF_MEMORY for lack of memory,
/// otherwise SHD_ERROR_IO.
[[noreturn]] void refuse_errno(const char* action, const char* path, int error);

}  // namespace shd::io
