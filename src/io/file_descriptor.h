// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <utility>

namespace shd::io {

/// A file descriptor it closes; negative = none.
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

/// Fails with "<action> "<path>": <reason>"; a missing file is SHD_ERROR_NOT_FOUND, a path the system cannot
/// have SHD_ERROR_INVALID_ARGUMENT, everything else SHD_ERROR_IO.
[[noreturn]] void refuse_errno(const char* action, const char* path, int error);

}  // namespace shd::io
