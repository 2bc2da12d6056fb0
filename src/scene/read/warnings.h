// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <set>
#include <string>

#include "core/failure.h"
#include "scene/model.h"

namespace shd::scene {

/// Warnings of a reader, each one given once, up to a number that a hostile file may reach.
class Warnings {
 public:
  explicit Warnings(Model& model) : model_(model) {}
  void add(const std::string& text) {
    if (said_.size() > kMost || !said_.insert(text).second) return;
    model_.warnings.push_back(said_.size() <= kMost ? text : "further warnings are left out");
  }

 private:
  static constexpr size_t kMost = 1000;
  Model& model_;
  std::set<std::string> said_;
};

/// Refuses a model of which nothing can be drawn. The message ends with the last warning about a mesh or a node.
[[noreturn]] inline void refuse_empty(const Model& model) {
  const auto is_cause = [](const std::string& warning) {
    return warning.rfind("mesh ", 0) == 0 || warning.rfind("node ", 0) == 0;
  };
  const auto last = std::find_if(model.warnings.rbegin(), model.warnings.rend(), is_cause);
  if (last == model.warnings.rend()) core::refuse(SHD_ERROR_UNSUPPORTED, "no triangles in it");
  core::refuse(SHD_ERROR_UNSUPPORTED, "no triangles in it: %s", last->c_str());
}

}  // namespace shd::scene
