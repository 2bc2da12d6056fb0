// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <shd/color.h>

namespace shd::color {

/// A config before it is parsed.
struct Source {
  std::string name;       // for messages
  std::string text;       // YAML
  std::string directory;  // where relative file names in it start; empty = nowhere
};

/// Finds and reads the config a desc asks for. Throws Failure.
Source read_source(const shd_color_desc& desc);

}  // namespace shd::color
