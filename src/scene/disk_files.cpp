// SPDX-License-Identifier: MIT
#include "scene/disk_files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/printable.h"
#include "core/regular_file.h"
#include "scene/text.h"

namespace shd::scene {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

/// The entry of `folder` with the given name, ignoring case; the first one in alphabetical order if there are several.
fs::path entry_of(const fs::path& folder, const std::string& name) {
  std::error_code error;
  fs::path found;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    const fs::path& entry = i->path();
    if (lower(entry.filename().string()) == lower(name) && (found.empty() || entry < found)) found = entry;
  }
  return found;
}

/// The path `relative` under `folder`, ignoring the case of each part; empty if there is no such file.
fs::path walk(const fs::path& folder, const fs::path& relative) {
  std::error_code error;
  fs::path place = folder;
  for (const fs::path& part : relative) {
    if (part.empty() || part == ".") continue;
    const fs::path exact = place / part;
    if (fs::exists(exact, error)) {
      place = exact;
    } else if (place = entry_of(place, part.string()); place.empty()) {
      return {};
    }
  }
  return fs::is_regular_file(place, error) ? place : fs::path();
}

}  // namespace

std::string find_file(const std::string& folder, const std::string& name) {
  std::error_code error;
  std::string forward = name;
  std::replace(forward.begin(), forward.end(), '\\', '/');
  const fs::path base = folder.empty() ? fs::path(".") : fs::path(folder), wanted(forward);
  if (wanted.is_absolute() && fs::is_regular_file(wanted, error)) return wanted.string();
  for (const fs::path& candidate : {walk(base, wanted.relative_path()), walk(base, wanted.filename())}) {
    if (!candidate.empty()) return candidate.string();
  }
  return {};
}

DiskFiles::DiskFiles(const std::string& path, const Limits& limits, const Deadline& deadline)
    : limits_(limits), deadline_(deadline), left_(limits.file_bytes) {
  const size_t slash = path.find_last_of('/');
  if (slash != std::string::npos) folder_ = path.substr(0, slash + 1);
  name_ = path.substr(folder_.size());
  const core::RegularFile opened = core::open_regular(path.c_str());
  const std::string text = text_of(path);
  if (opened.other_kind) core::refuse(SHD_ERROR_IO, "\"%s\" is not a regular file", text.c_str());
  if (opened.error) {
    const bool missing = opened.error == ENOENT || opened.error == ENOTDIR;
    core::refuse(missing ? SHD_ERROR_NOT_FOUND : SHD_ERROR_IO, "cannot open \"%s\": %s", text.c_str(),
                 std::strerror(opened.error));
  }
  if (opened.size == 0) core::refuse(SHD_ERROR_CORRUPT, "\"%s\" is empty", text.c_str());
  if (opened.size > limits.file_bytes) {
    core::refuse(SHD_ERROR_LIMIT, "\"%s\" has %llu bytes, above scene.max_file_bytes %llu", text.c_str(),
                 static_cast<unsigned long long>(opened.size), static_cast<unsigned long long>(limits.file_bytes));
  }
  const Bytes* bytes = load(path, opened);
  if (!bytes) core::refuse(SHD_ERROR_IO, "cannot read \"%s\"", text.c_str());
  model_ = *bytes;
}

const Bytes* DiskFiles::find(const std::string& name) {
  deadline_.check();
  const std::string path = find_file(folder_, name);
  if (path.empty()) return nullptr;
  const auto known = loaded_.find(path);
  if (known != loaded_.end()) return &known->second->bytes;
  return load(path, core::open_regular(path.c_str()));
}

const Bytes* DiskFiles::load(const std::string& path, const core::RegularFile& opened) {
  if (opened.file.fd < 0) return nullptr;
  if (opened.size > left_) {
    core::refuse(SHD_ERROR_LIMIT, "with \"%s\" its files have more bytes than scene.max_file_bytes %llu",
                 text_of(path).c_str(), static_cast<unsigned long long>(limits_.file_bytes));
  }
  auto loaded = std::make_unique<Loaded>();
  loaded->memory.resize(static_cast<size_t>(opened.size));
  int error = 0;
  const size_t size = loaded->memory.size();
  if (core::read_at(opened.file.fd, 0, size, loaded->memory.data(), &error) < size) return nullptr;
  left_ -= opened.size;
  loaded->bytes = {loaded->memory.data(), size};
  return &loaded_.emplace(path, std::move(loaded)).first->second->bytes;
}

}  // namespace shd::scene
