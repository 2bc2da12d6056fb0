// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace viewer {

/// A folder that the open dialog shows.
struct Folder {
  std::string path;                  // absolute
  std::vector<std::string> folders;  // names, sorted
  std::vector<std::string> files;    // names of files that the viewer may show, sorted
};

/// Lists a folder without hidden names. Names that cannot be read are left out. An empty path is the current folder.
Folder list_folder(const std::string& path);

/// Returns the folder above, or the path itself at the top.
std::string parent_of(const std::string& path);

}  // namespace viewer
