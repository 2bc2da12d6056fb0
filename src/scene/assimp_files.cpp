// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <vector>

#include <assimp/IOStream.hpp>

#include "scene/assimp_parts.h"

namespace shd::scene {
namespace {

/// A file in memory, read only.
class MemoryStream : public Assimp::IOStream {
 public:
  MemoryStream(std::vector<unsigned char>&& bytes, const Deadline& deadline)
      : bytes_(std::move(bytes)), deadline_(deadline) {}

  size_t Read(void* buffer, size_t size, size_t count) override {
    if (size == 0 || count == 0) return 0;
    const size_t whole = std::min((bytes_.size() - place_) / size, count);
    check_progress(whole);
    if (whole) std::memcpy(buffer, bytes_.data() + place_, whole * size);
    place_ += whole * size;
    return whole;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? place_ : bytes_.size();
    const size_t place = from + offset;  // offsets may be negative; the sum wraps to the correct position
    if (place > bytes_.size()) return aiReturn_FAILURE;
    place_ = place;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return place_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  /// Stops readers that would loop forever at the end of a damaged file, and readers beyond the deadline: assimp turns
  /// an exception into a failed import.
  void check_progress(size_t read) {
    constexpr int kMaxEmptyReads = 1000;
    empty_reads_ = read ? 0 : empty_reads_ + 1;
    if (empty_reads_ > kMaxEmptyReads) core::refuse(SHD_ERROR_CORRUPT, "the file ends too early");
    deadline_.check();
  }

  std::vector<unsigned char> bytes_;
  const Deadline& deadline_;
  size_t place_ = 0;
  int empty_reads_ = 0;
};

/// Opens a regular file and returns it with its size, or an empty result.
struct RegularFile {
  explicit RegularFile(const char* path) : fd(::open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {
    struct stat status;
    if (fd >= 0 && ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode)) {
      size = static_cast<uint64_t>(status.st_size);
      is_good = true;
    }
  }
  ~RegularFile() {
    if (fd >= 0) ::close(fd);
  }
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  int fd;
  uint64_t size = 0;
  bool is_good = false;
};

bool read_all(int fd, std::vector<unsigned char>& bytes) {
  constexpr size_t kChunk = size_t{1} << 26;
  for (size_t done = 0; done < bytes.size();) {
    const ssize_t got = ::read(fd, bytes.data() + done, std::min(bytes.size() - done, kChunk));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    done += static_cast<size_t>(got);
  }
  return true;
}

class BudgetedFiles : public Assimp::IOSystem {
 public:
  BudgetedFiles(FileBudget& budget, const Deadline& deadline) : budget_(budget), deadline_(deadline) {}

  bool Exists(const char* path) const override { return RegularFile(path).is_good; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (std::strchr(mode, 'w') || std::strchr(mode, 'a') || std::strchr(mode, '+')) return nullptr;
    const RegularFile file(path);
    if (!file.is_good) return nullptr;
    const bool known = counted_.count(path) != 0;  // readers open a file several times
    if (!known && file.size > budget_.left) {
      if (budget_.exceeded.empty()) budget_.exceeded = path;
      return nullptr;
    }
    std::vector<unsigned char> bytes(static_cast<size_t>(file.size));
    if (!read_all(file.fd, bytes)) return nullptr;
    if (!known) budget_.left -= file.size;
    counted_.insert(path);
    return new MemoryStream(std::move(bytes), deadline_);
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  FileBudget& budget_;
  const Deadline& deadline_;
  std::set<std::string> counted_;
};

}  // namespace

std::unique_ptr<Assimp::IOSystem> make_file_system(FileBudget& budget, const Deadline& deadline) {
  return std::make_unique<BudgetedFiles>(budget, deadline);
}

}  // namespace shd::scene
