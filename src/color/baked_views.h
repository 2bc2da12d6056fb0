// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "color/config.h"
#include "color/program.h"
#include "core/fork.h"

namespace shd::color {

/// A display transform of a config by its names.
struct ViewKey {
  std::string from, display, view;
  bool operator<(const ViewKey& other) const;
};

/// Programs baked so far. The context and the config outlive them.
class BakedViews {
 public:
  BakedViews(shd_context* context, const Config& config) : context_(context), config_(config) { mutex_.attach(); }

  /// The program of a view, baked by the first call; first calls of several threads may all bake it. Null if no program
  /// of it is near enough to `exact`: a first call writes this in the context's log. Throws Failure and std::bad_alloc.
  const Program* find(const ViewKey& key, const Transform& exact) const;

 private:
  /// Returns false if the view was not baked yet.
  bool find_baked(const ViewKey& key, const Program** out) const;
  std::unique_ptr<Program> bake_within_bound(const ViewKey& key, const Transform& exact, std::string* warning) const;

  shd_context* context_;
  const Config& config_;
  mutable core::ForkMutex mutex_{core::ForkLevel::kBakedViews};  // guards programs_
  mutable std::map<ViewKey, std::unique_ptr<Program>> programs_;
};

}  // namespace shd::color
