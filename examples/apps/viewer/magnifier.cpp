// SPDX-License-Identifier: MIT
#include "magnifier.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace viewer {
namespace {

void draw_codes(ImDrawList& list, const Ui& ui, const uint8_t* pixel, ImVec2 corner, float cell) {
  const float luminance = 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2];
  const ImU32 ink = luminance > 125.0f ? IM_COL32(0, 0, 0, 220) : IM_COL32(255, 255, 255, 220);
  ImGui::PushFont(ui.fonts.small);
  const float line = ImGui::GetFontSize() * 1.1f;
  for (int c = 0; c < 3; ++c) {
    char text[8];
    std::snprintf(text, sizeof text, "%d", pixel[c]);
    const float width = ImGui::CalcTextSize(text).x;
    const float top = corner.y + 0.5f * (cell - 3.0f * line) + float(c) * line;
    list.AddText(ImVec2(std::round(corner.x + 0.5f * (cell - width)), std::round(top)), ink, text);
  }
  ImGui::PopFont();
}

}  // namespace

void draw_magnifier(const Ui& ui, const Rect& viewport, const Picture& picture, uint32_t divider, Pixel middle) {
  if (!picture.side[0]) return;
  const Image& a = *picture.side[0];
  middle = {std::min(middle.x, a.width - 1), std::min(middle.y, a.height - 1)};
  const Pixel first = first_magnified(middle, a.width, a.height);
  const MagnifierLayout layout = magnifier_layout(viewport, ui.scale);
  const auto cell = float(layout.cell), margin = float(layout.margin), line = float(layout.line);
  const float width = cell * kMagnifiedColumns, height = cell * kMagnifiedRows;
  const ImVec2 corner(float(layout.x), float(layout.y));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(ImVec2(corner.x - margin, corner.y - margin),
                     ImVec2(corner.x + width + margin, corner.y + height + line + 0.5f * margin), kShade, 4.0f);
  const Image* middle_image = &a;
  for (int row = 0; row < kMagnifiedRows; ++row) {
    for (int column = 0; column < kMagnifiedColumns; ++column) {
      const uint32_t x = std::min(first.x + uint32_t(column), a.width - 1);
      const uint32_t y = std::min(first.y + uint32_t(row), a.height - 1);
      const Image& image = x >= divider && picture.side[1] ? *picture.side[1] : a;
      if (x == middle.x && y == middle.y) middle_image = &image;
      const uint8_t* p = &image.display[4 * (size_t{y} * image.width + x)];
      const ImVec2 low(corner.x + cell * float(column), corner.y + cell * float(row));
      list.AddRectFilled(low, ImVec2(low.x + cell - 1.0f, low.y + cell - 1.0f), IM_COL32(p[0], p[1], p[2], 255));
      draw_codes(list, ui, p, low, cell - 1.0f);
    }
  }
  const ImVec2 low(corner.x + cell * float(middle.x - first.x), corner.y + cell * float(middle.y - first.y));
  list.AddRect(ImVec2(low.x - 1.0f, low.y - 1.0f), ImVec2(low.x + cell, low.y + cell), kAccent, 0.0f, 0,
               2.0f * ui.scale);
  const float* linear = &middle_image->linear[4 * (size_t{middle.y} * a.width + middle.x)];
  char text[128];
  std::snprintf(text, sizeof text, "%u, %u    linear %.4f  %.4f  %.4f", middle.x, middle.y, linear[0], linear[1],
                linear[2]);
  list.AddText(ImVec2(corner.x, corner.y + height + 4.0f * ui.scale), kBright, text);
}

}  // namespace viewer
