// SPDX-License-Identifier: MIT
#include "io/file/udim.h"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/failure.h"
#include "io/file/file_descriptor.h"
#include "io/file/printable.h"

namespace shd::io {

namespace {

constexpr const char* kMark = "<UDIM>";
constexpr uint32_t kFirst = 1001, kLast = 9999, kColumns = 10;

struct Folder {
  DIR* handle;
  ~Folder() {
    if (handle) ::closedir(handle);
  }
};

/// Returns the number in the place of the mark, or 0.
uint32_t number_in(const std::string& name, const std::string& before, const std::string& after) {
  if (name.size() != before.size() + 4 + after.size() || name.compare(0, before.size(), before) != 0 ||
      name.compare(before.size() + 4, std::string::npos, after) != 0) {
    return 0;
  }
  uint32_t number = 0;
  for (size_t i = before.size(); i < before.size() + 4; ++i) {
    if (name[i] < '0' || name[i] > '9') return 0;
    number = 10 * number + static_cast<uint32_t>(name[i] - '0');
  }
  return number >= kFirst && number <= kLast ? number : 0;
}

std::vector<uint32_t> numbers_in(const std::string& folder, const std::string& before, const std::string& after) {
  const Folder opened{::opendir(folder.c_str())};
  if (!opened.handle) refuse_errno("cannot open", folder.c_str(), errno);
  std::vector<uint32_t> numbers;
  while (const dirent* entry = ::readdir(opened.handle)) {
    if (const uint32_t number = number_in(entry->d_name, before, after)) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace

FileGrid find_files(const std::string& path) {
  FileGrid grid;
  const size_t mark = path.find(kMark);
  if (mark == std::string::npos) {
    grid.paths = {path};
    grid.file = {0};
    return grid;
  }
  const size_t slash = path.rfind('/'), name = slash == std::string::npos ? 0 : slash + 1;
  if (mark < name || path.find(kMark, mark + 1) != std::string::npos) {
    core::refuse(SHD_ERROR_INVALID_ARGUMENT, "path: \"%s\" must have one <UDIM>, in the name of the file",
                 printable(path).c_str());
  }
  const std::string before = path.substr(name, mark - name), after = path.substr(mark + std::strlen(kMark));
  const std::string folder = name == 0 ? "." : name == 1 ? "/" : path.substr(0, slash);
  const std::vector<uint32_t> numbers = numbers_in(folder, before, after);
  if (numbers.empty()) {
    core::refuse(SHD_ERROR_NOT_FOUND, "no file is named \"%s\" with a number from %u to %u", printable(path).c_str(),
                 kFirst, kLast);
  }
  for (const uint32_t number : numbers) {
    grid.columns = std::max(grid.columns, (number - kFirst) % kColumns + 1);
    grid.rows = std::max(grid.rows, (number - kFirst) / kColumns + 1);
  }
  grid.file.assign(size_t{grid.columns} * grid.rows, -1);
  for (const uint32_t number : numbers) {
    const uint32_t column = (number - kFirst) % kColumns, row = (number - kFirst) / kColumns;
    grid.file[size_t{row} * grid.columns + column] = static_cast<int32_t>(grid.paths.size());
    grid.paths.push_back(path.substr(0, mark) + std::to_string(number) + after);
  }
  return grid;
}

}  // namespace shd::io
