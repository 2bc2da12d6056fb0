// SPDX-License-Identifier: MIT
#include "io/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/failure.h"
#include "io/file_descriptor.h"
#include "io/printable.h"

namespace shd::io {

Buffer read_file(const char* path, const Limits& limits, const Memory& memory) {
  const FileDescriptor file(::open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.fd < 0) refuse_errno("cannot open", path, errno);
  struct stat status;
  if (::fstat(file.fd, &status) != 0) refuse_errno("cannot examine", path, errno);
  if (!S_ISREG(status.st_mode)) core::refuse(SHD_ERROR_IO, "\"%s\" is not a regular file", printable(path).c_str());
  const auto size = static_cast<uint64_t>(status.st_size);
  if (size == 0) core::refuse(SHD_ERROR_CORRUPT, "\"%s\" is empty", printable(path).c_str());
  if (size > limits.file_bytes) {
    core::refuse(SHD_ERROR_LIMIT, "\"%s\" has %llu bytes, above load.max_file_bytes %llu", printable(path).c_str(),
                 static_cast<unsigned long long>(size), static_cast<unsigned long long>(limits.file_bytes));
  }
  Buffer bytes(memory, static_cast<size_t>(size));
  size_t done = 0;
  while (done < bytes.size()) {
    constexpr size_t kChunk = size_t{1} << 26;
    const ssize_t got = ::read(file.fd, bytes.data() + done, std::min(bytes.size() - done, kChunk));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_errno("cannot read", path, errno);
    if (got == 0) core::refuse(SHD_ERROR_IO, "\"%s\" became shorter while it was read", printable(path).c_str());
    done += static_cast<size_t>(got);
  }
  return bytes;
}

}  // namespace shd::io
