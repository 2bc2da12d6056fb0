// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <imgui.h>

namespace viewer {

/// Fonts of the window. They live as long as the ImGui context.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* bold = nullptr;
  ImFont* small = nullptr;
};

/// Colours of marks on pictures.
constexpr ImU32 kAccent = IM_COL32(255, 176, 59, 255), kShade = IM_COL32(12, 14, 18, 200);
constexpr ImU32 kBright = IM_COL32(240, 242, 246, 255), kDim = IM_COL32(150, 157, 170, 255);

/// Sets colours and sizes, and loads `font` or the first usual sans-serif font of the system. The built-in bitmap font
/// of ImGui, enlarged, is used if there is none.
Fonts set_theme(float scale, const std::string& font);

}  // namespace viewer
