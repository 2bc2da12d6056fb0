// SPDX-License-Identifier: MIT
#include "io/maketx/part.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "command/failure.h"
#include "data/checksum.h"
#include "io/file/printable.h"
#include "texture/table/mip_stream.h"

namespace {

using shd::data::checksum;
using shd::io::FileDescriptor;

constexpr uint64_t kMagic = 0x3278746d2d646873;  // "shd-mtx2"
constexpr size_t kKeySize = 1024;
constexpr size_t kMaxLevels = 32;

/// The head of the file `state`; the numbers of the pyramid follow.
struct Head {
  uint64_t magic, checksum;
  uint64_t count, rows;       // numbers of the pyramid; rows of the base
  uint64_t sums[kMaxLevels];  // checksums of the rows of level 1, 2 and so on
  char key[kKeySize];
};

/// Checksum of a state and of the fields of its head behind the checksum.
uint64_t checksum_of(const Head& head, const std::vector<double>& state) {
  constexpr size_t kFrom = offsetof(Head, count);
  const uint64_t sum = checksum(reinterpret_cast<const char*>(&head) + kFrom, sizeof head - kFrom);
  return checksum(state.data(), state.size() * sizeof(double), sum);
}

/// Continues the checksum of a level by rows. It depends on the rows alone, not on how many come together.
uint64_t add_rows(uint64_t sum, const uint8_t* rows, uint32_t count, size_t row) {
  for (uint32_t i = 0; i < count; ++i) sum = checksum(rows + i * row, row, sum);
  return sum;
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

/// Reads a state. Returns false if there is none, or if it is damaged.
bool read_head(int fd, Head* out, std::vector<double>* state) {
  struct stat status;
  if (fd < 0 || ::fstat(fd, &status) != 0 || !transfer(fd, out, sizeof *out, 0, false)) return false;
  const uint64_t numbers = (static_cast<uint64_t>(status.st_size) - sizeof *out) / sizeof(double);
  if (out->magic != kMagic || out->key[kKeySize - 1] || out->count != numbers) return false;
  state->resize(out->count);
  return transfer(fd, state->data(), out->count * sizeof(double), sizeof *out, false) &&
         out->checksum == checksum_of(*out, *state);
}

/// Whether the first `rows` rows of a level have a checksum.
bool has_sum(int fd, uint32_t rows, size_t row, uint64_t wanted) {
  constexpr size_t kChunk = size_t{1} << 20;
  const auto most = static_cast<uint32_t>(std::max<size_t>(kChunk / row, 1));
  std::vector<uint8_t> chunk(std::min(most, rows) * row);
  uint64_t sum = 0;
  for (uint32_t y = 0; y < rows; y += most) {
    const uint32_t count = std::min(most, rows - y);
    if (!transfer(fd, chunk.data(), count * row, static_cast<off_t>(uint64_t{y} * row), false)) return false;
    sum = add_rows(sum, chunk.data(), count, row);
  }
  return sum == wanted;
}

std::string level_name(size_t level) {
  return "level-" + std::to_string(level);
}

}  // namespace

Part::Part(const std::string& output, const std::string& key, bool force, std::vector<size_t> row_sizes,
           uint32_t height)
    : path_(output + ".part"),
      key_(key.substr(0, kKeySize - 1)),
      row_sizes_(std::move(row_sizes)),
      height_(height),
      sums_(kMaxLevels) {
  open_folder();
  lock_ = open_inside("lock", O_RDWR | O_CREAT);
  if (::flock(lock_.fd, LOCK_EX | LOCK_NB) != 0) {
    throw Failure(kExitOutput, "\"" + shd::io::printable(path_) + "\" belongs to a run that is not over");
  }
  Head head;
  std::vector<double> state;
  const FileDescriptor old = open_inside("state", O_RDONLY);
  if (read_head(old.fd, &head, &state) && key_ != head.key) {
    if (!force) {
      throw Failure(kExitOutput, "\"" + shd::io::printable(path_) +
                                     "\" is of a run with another input or other options: --force begins anew");
    }
    clear();
  }
  for (size_t level = 1; level <= row_sizes_.size(); ++level) {
    levels_.push_back(open_inside(level_name(level), O_RDWR | O_CREAT));
  }
}

/// In a folder that all may write to, another user can make OUTPUT.part first: as a link, or as a folder with links.
void Part::open_folder() {
  if (::mkdir(path_.c_str(), 0700) != 0 && errno != EEXIST) refuse("cannot make", errno);
  folder_ = FileDescriptor(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct stat status;
  if (folder_.fd < 0 || ::fstat(folder_.fd, &status) != 0) refuse("cannot use as a folder", errno);
  const char* const why = status.st_uid != ::geteuid()             ? "\" belongs to another user"
                          : (status.st_mode & (S_IWGRP | S_IWOTH)) ? "\" is a folder that other users may write to"
                                                                   : nullptr;
  if (why) throw Failure(kExitOutput, "\"" + shd::io::printable(path_) + why + ": remove it");
}

void Part::refuse(const std::string& action, int error) const {
  throw Failure(kExitOutput, action + " \"" + shd::io::printable(path_) + "\": " + std::strerror(error));
}

/// Opens a file of the folder. Returns none if it is absent and `flags` does not make it.
FileDescriptor Part::open_inside(const std::string& name, int flags, unsigned mode) const {
  FileDescriptor file(::openat(folder_.fd, name.c_str(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, mode));
  if (file.fd < 0 && errno == ENOENT && !(flags & O_CREAT)) return file;
  struct stat status;
  if (file.fd < 0 || ::fstat(file.fd, &status) != 0) refuse("cannot open " + name + " in", errno);
  if (!S_ISREG(status.st_mode) || status.st_nlink != 1) {
    throw Failure(kExitOutput, "\"" + shd::io::printable(path_ + "/" + name) + "\" is no regular file with one name");
  }
  return file;
}

/// Makes a file anew.
FileDescriptor Part::create(const char* name, unsigned mode) const {
  (void)!::unlinkat(folder_.fd, name, 0);
  return open_inside(name, O_RDWR | O_CREAT | O_EXCL, mode);
}

uint32_t Part::completed(size_t level, uint32_t rows) const {
  return shd::texture::completed_rows(height_, static_cast<uint32_t>(level), rows);
}

uint32_t Part::restore(std::vector<double>* state, std::string* damaged) {
  Head head;
  std::vector<double> numbers;
  const FileDescriptor file = open_inside("state", O_RDONLY);
  if (file.fd < 0) return 0;
  *damaged = "state";
  if (!read_head(file.fd, &head, &numbers) || numbers.size() != state->size() || head.rows > height_) return 0;
  const auto rows = static_cast<uint32_t>(head.rows);
  for (size_t level = 1; level <= levels_.size(); ++level) {
    *damaged = level_name(level);
    if (!has_sum(levels_[level - 1].fd, completed(level, rows), row_sizes_[level - 1], head.sums[level - 1])) return 0;
  }
  damaged->clear();
  std::copy(std::begin(head.sums), std::end(head.sums), sums_.begin());
  *state = std::move(numbers);
  return rows;
}

void Part::write(uint32_t level, uint32_t y, uint32_t count, const uint8_t* rows) {
  const size_t row = row_sizes_[level - 1];
  const auto at = static_cast<off_t>(uint64_t{y} * row);
  if (!transfer(levels_[level - 1].fd, const_cast<uint8_t*>(rows), count * row, at, true))
    refuse("cannot write to", errno);
  sums_[level - 1] = add_rows(sums_[level - 1], rows, count, row);
}

void Part::read(uint32_t level, uint32_t y, uint32_t count, uint8_t* rows) {
  const size_t row = row_sizes_[level - 1];
  if (!transfer(levels_[level - 1].fd, rows, count * row, static_cast<off_t>(uint64_t{y} * row), false)) {
    refuse("cannot read from", errno);
  }
  read_sum_ = add_rows(y == 0 ? 0 : read_sum_, rows, count, row);
  if (y + count == completed(level, height_) && read_sum_ != sums_[level - 1]) {
    refuse(level_name(level) + " is damaged in", EIO);
  }
}

void Part::save(uint32_t rows, const std::vector<double>& state) {
  // The state is valid only with the rows of levels that it accounts for.
  for (const FileDescriptor& level : levels_) {
    if (::fdatasync(level.fd) != 0) refuse("cannot flush", errno);
  }
  Head head = {};
  head.magic = kMagic;
  head.count = state.size();
  head.rows = rows;
  std::copy(sums_.begin(), sums_.end(), head.sums);
  std::memcpy(head.key, key_.data(), key_.size());
  head.checksum = checksum_of(head, state);
  const FileDescriptor file = create("state.new", 0600);
  if (!transfer(file.fd, &head, sizeof head, 0, true) ||
      !transfer(file.fd, const_cast<double*>(state.data()), state.size() * sizeof(double), sizeof head, true) ||
      ::fdatasync(file.fd) != 0 || ::renameat(folder_.fd, "state.new", folder_.fd, "state") != 0) {
    refuse("cannot write to", errno);
  }
}

FileDescriptor Part::create_file() const {
  return create("file", 0666);  // it becomes the output
}

void Part::abandon(bool keep) const {
  (void)!::unlinkat(folder_.fd, "file", 0);
  if (!keep) remove();
}

void Part::remove() const {
  clear();
  (void)!::unlinkat(folder_.fd, "lock", 0);
  (void)!::rmdir(path_.c_str());
}

void Part::clear() const {
  for (const char* const name : {"state", "state.new", "file"}) (void)!::unlinkat(folder_.fd, name, 0);
  for (size_t level = 1; level <= kMaxLevels; ++level) (void)!::unlinkat(folder_.fd, level_name(level).c_str(), 0);
}

void Part::publish(const std::string& output) {
  if (::renameat(folder_.fd, "file", AT_FDCWD, output.c_str()) != 0) {
    throw Failure(kExitOutput, "\"" + shd::io::printable(output) + "\": cannot rename to it: " + std::strerror(errno));
  }
  const size_t slash = output.rfind('/');
  const std::string parent = slash == std::string::npos ? "." : slash == 0 ? "/" : output.substr(0, slash);
  const FileDescriptor folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.fd >= 0) (void)!::fsync(folder.fd);
  remove();
}
