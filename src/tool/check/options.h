// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include <shd/bounds.h>

#include "command/values.h"

/// Changes of bounds by options such as --weight-bits, in their order.
using BoundChanges = std::vector<std::function<void(shd_bounds_desc&)>>;

/// The choices of the command line.
struct Options {
  std::string texture, lookups, results;  // files; `results` empty = columns of `lookups`
  std::string report;                     // file of the verdicts; empty = none
  std::vector<std::string> levels;        // files of the mip levels 1, 2, ...
  std::vector<std::string> columns = {"u", "v", "dudx", "dvdx", "dudy", "dvdy", "r", "g", "b", "a"};
  bool srgb = false, cube = false, mipmap = true;
  shd_rules rules = SHD_RULES_VULKAN;
  BoundChanges bound_changes;
  shd_sampler_desc sampler = shd_sampler_desc_default();
  bool diagnose = false;
  std::vector<std::string> assumed;  // names of hypotheses
  size_t list = 20;                  // most illegal lookups that are described
};

/// The bounds of an API, with the numbers that options give in their place. Throws Failure.
shd_bounds_desc bounds_of(const Options& options, shd_rules rules);

/// Names of the filters that have bounds.
std::vector<command::Name<shd_filter>> filters_with_bounds();

/// Reads the command line. Returns false after it has printed a page such as --help. Throws Failure.
bool read_options(int argc, const char* const* argv, Options& out);
