// SPDX-License-Identifier: MIT
#include "part_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace farm {

void fail_with_errno(const std::string& path, const char* action) {
  const int error = errno;
  const char* hint = error == ENOSPC || error == EDQUOT || error == EFBIG ? " (the disk or the quota is full)" : "";
  throw Failure(path + ": " + action + ": " + std::strerror(error) + hint);
}

File::File(const std::string& name, int flags) : path(name), fd(open(name.c_str(), flags | O_CLOEXEC, 0666)) {
  if (fd < 0) fail_with_errno(name, "cannot be opened");
}

File::File(File&& other) noexcept : path(std::move(other.path)), fd(std::exchange(other.fd, -1)) {}

File& File::operator=(File&& other) noexcept {
  std::swap(path, other.path);
  std::swap(fd, other.fd);
  return *this;
}

File::~File() {
  if (fd >= 0) close(fd);
}

void write_at(const File& file, uint64_t offset, const void* data, size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t done = pwrite(file.fd, bytes, size, static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) fail_with_errno(file.path, "cannot be written");
    bytes += done, offset += static_cast<uint64_t>(done), size -= static_cast<size_t>(done);
  }
}

size_t read_at(const File& file, uint64_t offset, void* data, size_t size) {
  size_t have = 0;
  while (have < size) {
    const ssize_t done =
        pread(file.fd, static_cast<char*>(data) + have, size - have, static_cast<off_t>(offset + have));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail_with_errno(file.path, "cannot be read");
    if (done == 0) break;
    have += static_cast<size_t>(done);
  }
  return have;
}

void append(const File& file, const std::string& text) {
  const off_t end = lseek(file.fd, 0, SEEK_END);
  if (end < 0) fail_with_errno(file.path, "has no end");
  write_at(file, static_cast<uint64_t>(end), text.data(), text.size());
}

void sync_data(const File& file) {
  if (fdatasync(file.fd) != 0) fail_with_errno(file.path, "cannot be flushed");
}

void reserve(const File& file, uint64_t size) {
#ifdef __linux__
  if (fallocate(file.fd, 0, 0, static_cast<off_t>(size)) == 0 || errno == EOPNOTSUPP || errno == ENOSYS) return;
  const std::string action = "cannot reserve " + std::to_string(size) + " bytes";
  fail_with_errno(file.path, action.c_str());
#else
  (void)file, (void)size;
#endif
}

void lock(const File& file) {
  if (flock(file.fd, LOCK_EX | LOCK_NB) == 0 || errno == EOPNOTSUPP || errno == ENOLCK) return;
  throw Failure(file.path + ": another job writes this picture");
}

void rename_file(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) fail_with_errno(from, "cannot be renamed");
}

void sync_folder(const std::string& path) {
  const size_t slash = path.rfind('/');
  const File folder(slash == std::string::npos ? "." : path.substr(0, slash + 1), O_RDONLY | O_DIRECTORY);
  if (fsync(folder.fd) != 0 && errno != EINVAL) fail_with_errno(folder.path, "cannot be flushed");
}

bool file_exists(const std::string& path) {
  struct stat info;
  return stat(path.c_str(), &info) == 0;
}

void remove_file(const std::string& path) {
  if (unlink(path.c_str()) != 0 && errno != ENOENT) fail_with_errno(path, "cannot be removed");
}

uint64_t size_of(const std::string& path) {
  struct stat info;
  return stat(path.c_str(), &info) == 0 ? static_cast<uint64_t>(info.st_size) : 0;
}

}  // namespace farm
