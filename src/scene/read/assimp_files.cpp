// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <optional>

#include <assimp/IOStream.hpp>

#include "scene/read/assimp_parts.h"

namespace shd::scene {
namespace {

/// A file in memory, read only.
class MemoryStream : public Assimp::IOStream {
 public:
  MemoryStream(Bytes bytes, const Deadline& deadline) : bytes_(bytes), deadline_(deadline) {}

  size_t Read(void* buffer, size_t size, size_t count) override {
    if (size == 0 || count == 0) return 0;
    const size_t whole = std::min((bytes_.size - place_) / size, count);
    check_progress(whole);
    if (whole) std::memcpy(buffer, bytes_.data + place_, whole * size);
    place_ += whole * size;
    return whole;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? place_ : bytes_.size;
    const size_t place = from + offset;  // offsets may be negative; the sum wraps to the correct position
    if (place > bytes_.size) return aiReturn_FAILURE;
    place_ = place;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return place_; }
  size_t FileSize() const override { return bytes_.size; }
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

  const Bytes bytes_;
  const Deadline& deadline_;
  size_t place_ = 0;
  int empty_reads_ = 0;
};

/// Skins are left out, so that no skeleton is read. assimp 5 prints a line to stdout for each skeleton of Ogre.
bool is_skeleton(const std::string& path) {
  const std::string end = ".skeleton.xml";
  return path.size() >= end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
}

class FileSystem : public Assimp::IOSystem {
 public:
  FileSystem(const Source& source, std::optional<core::Failure>& failure) : source_(source), failure_(failure) {}

  bool Exists(const char* path) const override { return find(path) != nullptr; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (std::strchr(mode, 'w') || std::strchr(mode, 'a') || std::strchr(mode, '+')) return nullptr;
    const Bytes* bytes = find(path);
    return bytes ? new MemoryStream(*bytes, source_.deadline) : nullptr;
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  const Bytes* find(const char* path) const {
    if (path == source_.name) return &source_.bytes;
    if (failure_ || is_skeleton(path)) return nullptr;
    try {
      return source_.files.find(path);
    } catch (const core::Failure& failure) {
      failure_ = failure;
      return nullptr;
    }
  }

  const Source& source_;
  std::optional<core::Failure>& failure_;
};

}  // namespace

std::unique_ptr<Assimp::IOSystem> make_file_system(const Source& source, std::optional<core::Failure>& failure) {
  return std::make_unique<FileSystem>(source, failure);
}

}  // namespace shd::scene
