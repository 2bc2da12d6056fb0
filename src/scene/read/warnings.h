// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

#include "scene/model.h"

namespace shd::scene {

/// Warnings of a reader, each said once.
class Warnings {
 public:
  explicit Warnings(Model& model) : model_(model) {}
  void add(const std::string& text) {
    if (said_.insert(text).second) model_.warnings.push_back(text);
  }

 private:
  Model& model_;
  std::set<std::string> said_;
};

}  // namespace shd::scene
