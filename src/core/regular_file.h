// SPDX-License-Identifier: MIT
/// @file
/// Opening of files to read them. Every file that shd reads is opened here, except those that the check `files` of
/// tests/support/check_style.py lists. This header needs no library.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace shd::core {

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

/// A regular file, open for reading, or the reason why there is none.
struct RegularFile {
  FileDescriptor file;
  uint64_t size = 0;        // [bytes], when it was opened
  bool other_kind = false;  // the path names a folder, FIFO, device or socket
  int error = 0;            // errno of the call that failed
};

/// Opens a regular file, and follows symbolic links. Does not open a device or a FIFO, which could block or have
/// effects. If another process changes the path between the checks, a device is opened without blocking, and closed.
inline RegularFile open_regular(const char* path) {
  RegularFile out;
  struct stat status;
  if (::stat(path, &status) != 0) {
    out.error = errno;
    return out;
  }
  out.other_kind = !S_ISREG(status.st_mode);
  if (out.other_kind) return out;
  do {
    out.file.fd = ::open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  } while (out.file.fd < 0 && errno == EINTR);
  if (out.file.fd < 0 || ::fstat(out.file.fd, &status) != 0) {
    out.error = errno;
    out.file.reset();
    return out;
  }
  out.other_kind = !S_ISREG(status.st_mode);
  if (out.other_kind) out.file.reset();
  out.size = static_cast<uint64_t>(status.st_size);
  return out;
}

/// Reads up to `size` bytes of a file from offset `at` on, or the next ones of a socket. Returns their number, which is
/// smaller at the end of the file and after an error; `error` is errno or 0.
inline size_t read_at(int file, uint64_t at, size_t size, void* out, int* error) {
  size_t done = 0;
  *error = 0;
  while (done < size) {
    constexpr size_t kChunk = size_t{1} << 26;
    const size_t wanted = std::min(size - done, kChunk);
    unsigned char* const next = static_cast<unsigned char*>(out) + done;
    ssize_t got = ::pread(file, next, wanted, static_cast<off_t>(at + done));
    if (got < 0 && errno == ESPIPE) got = ::read(file, next, wanted);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) *error = errno;
    if (got <= 0) break;
    done += static_cast<size_t>(got);
  }
  return done;
}

}  // namespace shd::core
