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

/// The entry of `folder` with the given name, ignoring case; the first one in alphabetical order if there are several.
fs::path entry_of(const fs::path& folder, const std::string& name) {
  std::error_code error;
  fs::path found;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    const fs::path& entry = i->path();
    if (lower_case(entry.filename().string()) == lower_case(name) && (found.empty() || entry < found)) found = entry;
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

/// Whether a relative path stays below the folder it is relative to, as far as its text shows.
bool stays_below(const fs::path& relative) {
  const fs::path normal = relative.lexically_normal();
  return normal.is_relative() && (normal.empty() || *normal.begin() != "..");
}

}  // namespace

DiskFiles::DiskFiles(const std::string& path, bool any_folder, const Limits& limits, const Deadline& deadline)
    : HostFiles(limits, deadline), any_folder_(any_folder) {
  const size_t slash = path.find_last_of('/');
  if (slash != std::string::npos) folder_ = path.substr(0, slash + 1);
  name_ = path.substr(folder_.size());
  core::RegularFile opened = core::open_regular(path.c_str());
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
  charge(path, opened.size);
  model_.file = std::move(opened.file);
  model_.path = path;
  model_.size = opened.size;
}

bool DiskFiles::is_inside(const std::string& path) const {
  std::error_code error;
  const std::string root = fs::canonical(folder_.empty() ? "." : folder_, error).string();
  if (error) return false;
  const std::string place = fs::canonical(path, error).string();
  if (error) return false;
  return root == "/" || place.compare(0, root.size() + 1, root + "/") == 0;
}

bool DiskFiles::locate(const std::string& folder, const std::string& name, Opened* out, std::string* why) {
  std::error_code error;
  std::string forward = name;
  std::replace(forward.begin(), forward.end(), '\\', '/');
  const fs::path root(folder_.empty() ? "." : folder_), wanted(forward);
  const fs::path base = folder.empty() ? root : root / folder;
  bool outside = false;
  const auto take = [&](const fs::path& candidate) {
    if (candidate.empty()) return false;
    if (!any_folder_ && !is_inside(candidate.string())) {
      outside = true;
      return false;
    }
    core::RegularFile opened = core::open_regular(candidate.c_str());
    if (opened.file.fd < 0) return false;
    out->file = std::move(opened.file);
    out->path = candidate.lexically_normal().string();
    out->size = opened.size;
    return true;
  };
  if (wanted.is_absolute()) {
    outside = !any_folder_;
    if (any_folder_ && fs::is_regular_file(wanted, error) && take(wanted)) return true;
  }
  if (any_folder_ || stays_below(fs::path(folder) / wanted.relative_path())) {
    if (take(walk(base, wanted.relative_path()))) return true;
  } else {
    outside = true;
  }
  if (take(walk(base, wanted.filename()))) return true;
  *why = outside ? "it is outside the folder of the model, which takes SHD_SCENE_ANY_FOLDER" : "";
  return false;
}

}  // namespace shd::scene
