// SPDX-License-Identifier: MIT
#include "scene/find_file.h"

#include <algorithm>
#include <filesystem>

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
  return name;
}

}  // namespace shd::scene
