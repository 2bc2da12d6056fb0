// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/host_files.h"

namespace shd::scene {

/// The files around a model on disk: regular files only. Names may have been written on another machine. Each is tried
/// unchanged, with the backslashes of Windows, ignoring case, and finally as a bare name. Files outside the folder of
/// the model, by `..`, an absolute path or a symbolic link, are found only if `any_folder`.
class DiskFiles : public HostFiles {
 public:
  /// `path` is that of the model. Throws Failure, with the reason, if it cannot be opened.
  DiskFiles(const std::string& path, bool any_folder, const Limits& limits, const Deadline& deadline);

  Opened model() override { return std::move(model_); }
  std::string name() const override { return name_; }
  bool locate(const std::string& folder, const std::string& name, Opened* out, std::string* why) override;

 private:
  bool is_inside(const std::string& path) const;

  const bool any_folder_;
  std::string folder_, name_;  // folder: "" or "a/b/"
  Opened model_;
};

}  // namespace shd::scene
