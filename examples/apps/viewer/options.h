// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <stdexcept>
#include <string>

#include "state.h"

namespace viewer {

/// A command line that cannot be used: the text names the option, its value and the valid ones.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The command line, checked.
struct Options {
  bool help = false;
  State state;  // its width and height follow from the window
  int width = 1280, height = 800;
  float scale = 0.0f;      // scale of texts; 0 = by the resolution of the screen
  std::string font;        // "" = a font of the system
  std::string screenshot;  // the window as PNG; then the program ends
  std::string picture;     // the viewport as PNG, without a window; then the program ends
  int frames = 3;          // number of drawn windows before the screenshot
  std::optional<Pixel> magnify;
  bool pixel_tab = false;  // the tab of the panel
  uint32_t threads = 0;
};

/// Throws UsageError.
Options parse_options(int argc, const char* const* argv);

const char* help_text();

}  // namespace viewer
