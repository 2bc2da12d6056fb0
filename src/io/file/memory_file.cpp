// SPDX-License-Identifier: MIT
#include "io/file/memory_file.h"

#include <sys/mman.h>

#include <cerrno>

#include "core/failure.h"

namespace shd::io {

MemoryFile::MemoryFile(bool wanted, const unsigned char* bytes, size_t size) {
  if (!wanted) return;
#ifdef __linux__
  file_ = FileDescriptor(::memfd_create("shd", MFD_CLOEXEC));
  if (file_.fd < 0) refuse_errno("cannot create", "an anonymous file", errno);
  while (size > 0) {
    const ssize_t put = ::write(file_.fd, bytes, size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) refuse_errno("cannot write", "an anonymous file", put < 0 ? errno : ENOSPC);
    bytes += put;
    size -= static_cast<size_t>(put);
  }
  path_ = "/proc/self/fd/" + std::to_string(file_.fd);
#else
  (void)bytes;
  (void)size;
  core::refuse(SHD_ERROR_UNSUPPORTED, "SHD_FILE_FORMAT_ANY needs anonymous files, which this system lacks");
#endif
}

std::string MemoryFile::without_path(std::string message) const {
  for (size_t at = 0; !path_.empty() && (at = message.find(path_, at)) != std::string::npos;) {
    message.replace(at, path_.size(), "the file");
  }
  return message;
}

}  // namespace shd::io
