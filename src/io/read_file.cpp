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

OpenFile open_file(const char* path, const Limits& limits) {
  FileDescriptor file(::open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
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
  return {std::move(file), static_cast<size_t>(size)};
}

void read_bytes_at(int file, uint64_t at, size_t size, unsigned char* out) {
  size_t done = 0;
  while (done < size) {
    constexpr size_t kChunk = size_t{1} << 26;
    const size_t wanted = std::min(size - done, kChunk);
    ssize_t got = ::pread(file, out + done, wanted, static_cast<off_t>(at + done));
    if (got < 0 && errno == ESPIPE) got = ::read(file, out + done, wanted);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_errno("cannot read", "the file", errno);
    if (got == 0) core::refuse(SHD_ERROR_IO, "the file became shorter while it was read");
    done += static_cast<size_t>(got);
  }
}

Buffer read_bytes(int file, size_t size, const Memory& memory) {
  Buffer bytes(memory, size);
  read_bytes_at(file, 0, size, bytes.data());
  return bytes;
}

}  // namespace shd::io
