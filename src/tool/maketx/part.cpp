// SPDX-License-Identifier: MIT
#include "tool/maketx/part.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "io/printable.h"
#include "texture/store/mip_stream.h"
#include "tool/failure.h"

namespace {

constexpr uint64_t kMagic = 0x3178746d2d646873;  // "shd-mtx1"
constexpr size_t kKeySize = 1024;

/// The head of the file `state`; the numbers of the pyramid follow.
struct Head {
  uint64_t magic, checksum, count;
  uint64_t rows;
  char key[kKeySize];
};

/// FNV-1a over the words of a state and of its head.
uint64_t checksum_of(const Head& head, const std::vector<double>& state) {
  uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](uint64_t word) { hash = (hash ^ word) * 0x100000001b3; };
  add(head.rows);
  add(head.count);
  for (const char c : head.key) add(static_cast<unsigned char>(c));
  for (const double number : state) {
    uint64_t word;
    std::memcpy(&word, &number, sizeof word);
    add(word);
  }
  return hash;
}

bool transfer(int fd, void* memory, size_t size, off_t at, bool writes) {
  auto* next = static_cast<uint8_t*>(memory);
  while (size > 0) {
    const ssize_t done = writes ? ::pwrite(fd, next, size, at) : ::pread(fd, next, size, at);
    if (done < 0 && errno == EINTR) continue;
    if (done == 0) errno = writes ? ENOSPC : EIO;
    if (done <= 0) return false;
    next += done;
    at += done;
    size -= static_cast<size_t>(done);
  }
  return true;
}

bool read_head(const std::string& path, Head* out, std::vector<double>* state) {
  const shd::io::FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status;
  if (file.fd < 0 || ::fstat(file.fd, &status) != 0 || !transfer(file.fd, out, sizeof *out, 0, false)) return false;
  const auto size = static_cast<uint64_t>(status.st_size);
  if (out->magic != kMagic || out->key[kKeySize - 1] || out->count != (size - sizeof *out) / sizeof(double))
    return false;
  state->resize(out->count);
  return transfer(file.fd, state->data(), out->count * sizeof(double), sizeof *out, false) &&
         out->checksum == checksum_of(*out, *state);
}

}  // namespace

Part::Part(const std::string& output, const std::string& key, bool force, std::vector<size_t> row_sizes)
    : folder_(output + ".part"), key_(key.substr(0, kKeySize - 1)), row_sizes_(std::move(row_sizes)) {
  if (::mkdir(folder_.c_str(), 0777) != 0 && errno != EEXIST) refuse("cannot make", errno);
  const std::string lock = folder_ + "/lock";
  lock_ = shd::io::FileDescriptor(::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (lock_.fd < 0) refuse("cannot lock", errno);
  if (::flock(lock_.fd, LOCK_EX | LOCK_NB) != 0) {
    throw Failure(kExitOutput, "\"" + shd::io::printable(folder_) + "\" belongs to a run that is not over");
  }
  Head head;
  std::vector<double> state;
  if (read_head(folder_ + "/state", &head, &state) && key_ != head.key) {
    if (!force) {
      throw Failure(kExitOutput, "\"" + shd::io::printable(folder_) +
                                     "\" is of a run with another input or other options: --force begins anew");
    }
    clear();
  }
  for (size_t level = 1; level <= row_sizes_.size(); ++level) {
    levels_.emplace_back(::open(level_path(level).c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (levels_.back().fd < 0) refuse("cannot make a file in", errno);
  }
}

void Part::refuse(const std::string& action, int error) const {
  throw Failure(kExitOutput, action + " \"" + shd::io::printable(folder_) + "\": " + std::strerror(error));
}

std::string Part::level_path(size_t level) const {
  return folder_ + "/level-" + std::to_string(level);
}

uint32_t Part::restore(std::vector<double>* state, uint32_t height) {
  Head head;
  std::vector<double> read;
  if (!read_head(folder_ + "/state", &head, &read) || read.size() != state->size() || head.rows > height) return 0;
  const auto rows = static_cast<uint32_t>(head.rows);
  for (size_t level = 1; level <= levels_.size(); ++level) {
    struct stat status;
    const uint32_t done = shd::texture::completed_rows(height, static_cast<uint32_t>(level), rows);
    if (::fstat(levels_[level - 1].fd, &status) != 0) refuse("cannot examine", errno);
    if (static_cast<uint64_t>(status.st_size) < uint64_t{done} * row_sizes_[level - 1]) return 0;
  }
  *state = std::move(read);
  return rows;
}

void Part::write(uint32_t level, uint32_t y, uint32_t count, const uint8_t* rows) {
  const size_t row = row_sizes_[level - 1];
  const auto at = static_cast<off_t>(uint64_t{y} * row);
  if (!transfer(levels_[level - 1].fd, const_cast<uint8_t*>(rows), count * row, at, true))
    refuse("cannot write to", errno);
}

void Part::read(uint32_t level, uint32_t y, uint32_t count, uint8_t* rows) const {
  const size_t row = row_sizes_[level - 1];
  if (!transfer(levels_[level - 1].fd, rows, count * row, static_cast<off_t>(uint64_t{y} * row), false)) {
    refuse("cannot read from", errno);
  }
}

void Part::save(uint32_t rows, const std::vector<double>& state) {
  // The state is valid only with the rows of levels that it accounts for.
  for (const shd::io::FileDescriptor& level : levels_) {
    if (::fdatasync(level.fd) != 0) refuse("cannot flush", errno);
  }
  Head head = {};
  head.magic = kMagic;
  head.count = state.size();
  head.rows = rows;
  std::memcpy(head.key, key_.data(), key_.size());
  head.checksum = checksum_of(head, state);
  const std::string name = folder_ + "/state", fresh = name + ".new";
  const shd::io::FileDescriptor file(
      ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (file.fd < 0 || !transfer(file.fd, &head, sizeof head, 0, true) ||
      !transfer(file.fd, const_cast<double*>(state.data()), state.size() * sizeof(double), sizeof head, true) ||
      ::fdatasync(file.fd) != 0 || ::rename(fresh.c_str(), name.c_str()) != 0) {
    refuse("cannot write to", errno);
  }
}

void Part::abandon(bool keep) const {
  (void)!::unlink(file().c_str());
  if (!keep) remove();
}

void Part::remove() const {
  clear();
  (void)!::unlink((folder_ + "/lock").c_str());
  (void)!::rmdir(folder_.c_str());
}

void Part::clear() const {
  for (const char* const name : {"/state", "/state.new", "/file"}) (void)!::unlink((folder_ + name).c_str());
  for (size_t level = 1; level <= 32; ++level) (void)!::unlink(level_path(level).c_str());
}

void Part::publish(const std::string& output) {
  if (::rename(file().c_str(), output.c_str()) != 0) {
    throw Failure(kExitOutput, "\"" + shd::io::printable(output) + "\": cannot rename to it: " + std::strerror(errno));
  }
  const size_t slash = output.rfind('/');
  const std::string parent = slash == std::string::npos ? "." : slash == 0 ? "/" : output.substr(0, slash);
  const shd::io::FileDescriptor folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.fd >= 0) (void)!::fsync(folder.fd);
  remove();
}
