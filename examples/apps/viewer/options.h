// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "state.h"

namespace viewer {

/// The command line, checked.
struct Options {
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

/// Reads the command line. Returns false after it has printed a page such as --help. Throws Failure that names the
/// option, its value and the valid ones.
bool read_options(int argc, const char* const* argv, Options& out);

}  // namespace viewer
