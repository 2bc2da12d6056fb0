// SPDX-License-Identifier: MIT
#include "io/file/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/failure.h"
#include "io/file/file_descriptor.h"
#include "io/file/printable.h"

namespace shd::io {

namespace {

/// A file that does not exist under its final name yet; removed by the destructor unless it was renamed.
struct Temporary {
  std::string name;
  FileDescriptor file;
  bool renamed = false;
  ~Temporary() {
    if (file.fd >= 0 && !renamed) ::unlink(name.c_str());
  }
};

std::string folder_beside(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

/// Resolves symbolic links; a path that does not exist is returned unchanged.
std::string resolve(const char* path) {
  struct stat status;
  if (::lstat(path, &status) != 0 || !S_ISLNK(status.st_mode)) return path;
  char* target = ::realpath(path, nullptr);
  if (!target) refuse_errno("cannot follow", path, errno);
  const std::string resolved(target);
  std::free(target);
  return resolved;
}

/// Creates a file beside `path`, with these permissions less those that the umask takes.
void open_temporary(const std::string& path, mode_t mode, Temporary* out) {
  const std::string folder = folder_beside(path);
  int error = EEXIST;
  // The process id and the address make the name unique among threads and processes; names of leftover files are
  // skipped.
  for (int attempt = 0; attempt < 100 && error == EEXIST; ++attempt) {
    char name[64];
    std::snprintf(name, sizeof name, "/.shd-%ld-%zx-%d", static_cast<long>(::getpid()), reinterpret_cast<size_t>(out),
                  attempt);
    out->name = folder + name;
    out->file = FileDescriptor(::open(out->name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOCTTY, mode));
    if (out->file.fd >= 0) return;
    error = errno;
  }
  refuse_errno("cannot create a file beside", path.c_str(), error);
}

void write_all(int fd, const void* bytes, size_t size, const std::string& path) {
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (size > 0) {
    constexpr size_t kChunk = size_t{1} << 26;
    const ssize_t put = ::write(fd, next, std::min(size, kChunk));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) refuse_errno("cannot write", path.c_str(), put < 0 ? errno : ENOSPC);
    next += put;
    size -= static_cast<size_t>(put);
  }
}

}  // namespace

void write_file(const char* path_in, const void* bytes, size_t size) {
  const std::string path = resolve(path_in);
  struct stat old;
  const bool replaces = ::stat(path.c_str(), &old) == 0;
  if (replaces && !S_ISREG(old.st_mode)) {
    core::refuse(SHD_ERROR_IO, "\"%s\" is not a regular file: not replaced", printable(path).c_str());
  }
  Temporary temporary;
  // A new file has its final permissions from the start. An old file may have narrower ones than the umask leaves, and
  // nobody may open its successor in between.
  open_temporary(path, replaces ? 0600 : 0666, &temporary);
  if (replaces && ::fchmod(temporary.file.fd, old.st_mode & 0777) != 0) {
    refuse_errno("cannot keep the permissions of", path.c_str(), errno);
  }
  write_all(temporary.file.fd, bytes, size, path);
  if (::fsync(temporary.file.fd) != 0) refuse_errno("cannot flush", path.c_str(), errno);
  if (::rename(temporary.name.c_str(), path.c_str()) != 0) refuse_errno("cannot rename to", path.c_str(), errno);
  temporary.renamed = true;
  // The name is durable once its folder is flushed. Some file systems refuse this, and the file is complete either way.
  const FileDescriptor folder(::open(folder_beside(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.fd >= 0) (void)!::fsync(folder.fd);
}

}  // namespace shd::io
