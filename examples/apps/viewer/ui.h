// SPDX-License-Identifier: MIT
/// Tabs, tools and messages of the window, which change no pixel of the picture.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "folder.h"
#include "layout.h"
#include "picture.h"
#include "theme.h"

namespace viewer {

struct Ui {
  Fonts fonts;
  float scale = 1.0f;
  bool pixel_tab = false;           // shown tab of the panel
  bool select_tab = true;           // the tab follows `pixel_tab` in the next frame
  int side = 0;                     // side that the settings change
  bool b_is_own = false;            // side B was shown before, so it keeps its settings
  size_t level = 0;                 // shown element of Explanation::levels
  std::optional<Pixel> magnified;   // middle of the magnifier
  bool magnifier = false;           // follows the pointer
  bool help = false, open = false;  // shown windows
  Folder folder;                    // shown by the window `open`; empty before its first use
  std::string message;              // error of the last picture, shown over the viewport
  std::string notice;               // such as the name of a saved file, shown in the status line
  std::vector<Display> displays;
  char path[1024] = {};                              // typed in the panel
  bool save = false, reset = false, cancel = false;  // asked by a button; the application resets them
};

/// A row of the panel: the label at the left, the next item over the rest.
void label(const char* text);

/// Turns the wipe on or off. Side B begins as other_side() of side A.
void set_wipe(Ui& ui, State& state, bool is_on);

}  // namespace viewer
