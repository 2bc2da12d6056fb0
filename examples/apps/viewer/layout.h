// SPDX-License-Identifier: MIT
/// Places of the parts of the window, in pixels. No window is needed.
#pragma once
#include <algorithm>

namespace viewer {

struct Rect {
  int x = 0, y = 0, width = 0, height = 0;
  bool contains(int px, int py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

struct Layout {
  Rect viewport, panel, status;
};

/// The panel is at the right and the status line below the viewport. `scale` is the scale of texts.
inline Layout layout_of(int width, int height, float scale) {
  const int panel = std::min(static_cast<int>(372.0f * scale), std::max(width / 2, 1));
  const int line = std::min(static_cast<int>(30.0f * scale), std::max(height / 4, 1));
  Layout layout;
  layout.viewport = {0, 0, std::max(width - panel, 1), std::max(height - line, 1)};
  layout.panel = {layout.viewport.width, 0, panel, height};
  layout.status = {0, layout.viewport.height, layout.viewport.width, line};
  return layout;
}

}  // namespace viewer
