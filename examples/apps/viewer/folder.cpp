// SPDX-License-Identifier: MIT
#include "folder.h"

#include <algorithm>
#include <filesystem>

#include "state.h"

namespace viewer {

namespace fs = std::filesystem;

namespace {

/// Without a slash at the end.
fs::path normal_path(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  return normal.has_filename() || !normal.has_relative_path() ? normal : normal.parent_path();
}

}  // namespace

Folder list_folder(const std::string& path) {
  std::error_code ignored;
  const fs::path absolute = normal_path(fs::absolute(path.empty() ? "." : path, ignored));
  Folder folder;
  folder.path = absolute.string();
  for (auto entry = fs::directory_iterator(absolute, ignored); entry != fs::directory_iterator();
       entry.increment(ignored)) {
    if (ignored) break;
    const std::string name = entry->path().filename().string();
    if (name.empty() || name[0] == '.') continue;
    std::error_code unreadable;
    if (entry->is_directory(unreadable)) {
      folder.folders.push_back(name);
    } else if (entry->is_regular_file(unreadable) && kind_of_file(name) != FileKind::kOther) {
      folder.files.push_back(name);
    }
  }
  std::sort(folder.folders.begin(), folder.folders.end());
  std::sort(folder.files.begin(), folder.files.end());
  return folder;
}

std::string parent_of(const std::string& path) {
  const fs::path folder = normal_path(path);
  return folder.has_relative_path() ? folder.parent_path().string() : folder.string();
}

}  // namespace viewer
