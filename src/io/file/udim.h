// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace shd::io {

/// The files of a grid. Column 0 is on the left, row 0 at the bottom.
struct FileGrid {
  uint32_t columns = 1, rows = 1;
  std::vector<std::string> paths;  // existing files
  std::vector<int32_t> file;       // [rows][columns] index into `paths`, -1 = absent
};

/// Finds the files that a path names: one, or the files of a UDIM set, whose path contains "<UDIM>" in the name of the
/// file. Throws Failure if there is none.
FileGrid find_files(const std::string& path);

}  // namespace shd::io
