// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <shd/bounds.h>

/// The choices of the command line.
struct Options {
  std::string texture, lookups, results;  // files; `results` empty = columns of `lookups`
  std::string report;                     // file of the verdicts; empty = none
  std::vector<std::string> levels;        // files of the mip levels 1, 2, ...
  std::vector<std::string> columns = {"u", "v", "dudx", "dvdx", "dudy", "dvdy", "r", "g", "b", "a"};
  bool srgb = false, cube = false, mipmap = true;
  shd_rules rules = SHD_RULES_VULKAN;
  shd_bounds_desc bounds = shd_bounds_desc_default();
  shd_sampler_desc sampler = shd_sampler_desc_default();
  bool diagnose = false;
  std::vector<std::string> assumed;  // names of hypotheses
  size_t list = 20;                  // most illegal lookups that are described
};

/// Reads the command line. Returns false after it has printed a page such as --help. Throws Failure.
bool read_options(int argc, const char* const* argv, Options& out);
