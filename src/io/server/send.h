// SPDX-License-Identifier: MIT
#pragma once

#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

/// Messages of a child of the worker.
namespace shd::io {

/// Writes to a pipe that blocks.
inline bool send_all(int pipe, const void* bytes, size_t size) {
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (size > 0) {
    const ssize_t put = ::write(pipe, next, size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    next += put;
    size -= static_cast<size_t>(put);
  }
  return true;
}

/// Sends memory that stays unchanged until it has been read: the pipe refers to it instead of copying it.
inline bool lend_all(int pipe, const void* bytes, size_t size) {
  auto* next = static_cast<unsigned char*>(const_cast<void*>(bytes));
  while (size > 0) {
    const iovec part = {next, size};
    const ssize_t put = ::vmsplice(pipe, &part, 1, 0);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return send_all(pipe, next, size);  // not every sandbox has vmsplice()
    next += put;
    size -= static_cast<size_t>(put);
  }
  return true;
}

/// Destructors are skipped, because the decoders' libraries take longer to unload than to decode.
inline void require_sent(bool sent) {
  if (!sent) _exit(3);
}

}  // namespace shd::io
