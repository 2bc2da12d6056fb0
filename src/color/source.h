// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <shd/color.h>

namespace shd::color {

/// A config before it is parsed.
struct Source {
  std::string name;       // used in messages
  std::string text;       // YAML
  std::string directory;  // base of relative file names in the text; empty = none
};

/// Finds and reads the config that a desc selects. Throws Failure.
Source read_source(const shd_color_desc& desc);

}  // namespace shd::color
