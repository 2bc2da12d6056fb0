// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/regular_file.h"
#include "scene/limits.h"
#include "scene/read/files.h"

namespace shd::scene {

/// The path of the file `name` of a model that may have been written on another machine. Tries the name unchanged,
/// relative to `folder`, with the backslashes of Windows, ignoring case, and finally the bare name in `folder`. Empty
/// if there is no such file.
std::string find_file(const std::string& folder, const std::string& name);

/// The files around a model on disk: regular files only, within a budget.
class DiskFiles : public Files {
 public:
  /// `path` is that of the model.
  DiskFiles(const std::string& path, const Limits& limits, const Deadline& deadline);

  /// The model itself. Throws Failure, with the reason, if it cannot be read.
  const Bytes& model() const { return model_; }
  const std::string& folder() const { return folder_; }  // "" or "a/b/"
  const std::string& name() const { return name_; }
  const Bytes* find(const std::string& name) override;

 private:
  struct Loaded {
    std::vector<unsigned char> memory;
    Bytes bytes;
  };
  const Bytes* load(const std::string& path, const core::RegularFile& opened);

  const Limits& limits_;
  const Deadline& deadline_;
  uint64_t left_;
  std::string folder_, name_;
  std::map<std::string, std::unique_ptr<Loaded>> loaded_;  // by path
  Bytes model_;
};

}  // namespace shd::scene
