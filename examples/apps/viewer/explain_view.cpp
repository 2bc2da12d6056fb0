// SPDX-License-Identifier: MIT
#include "explain_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace viewer {
namespace {

ImU32 color_of(const std::array<float, 4>& linear) {
  const auto code = [](float x) {
    x = std::clamp(x, 0.0f, 1.0f);
    return static_cast<int>(255.0f * (x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f) + 0.5f);
  };
  return IM_COL32(code(linear[0]), code(linear[1]), code(linear[2]), 255);
}

/// A row of three numbers with a swatch of their colour.
void show_color(const Ui& ui, const char* text, const std::array<float, 4>& color) {
  ImGui::TextUnformatted(text);
  const float height = ImGui::GetTextLineHeight(), right = ImGui::GetWindowContentRegionMax().x;
  ImGui::SameLine(right - 196.0f * ui.scale);
  ImGui::Text("%.5f %.5f %.5f", color[0], color[1], color[2]);
  ImGui::SameLine(right - height);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + height, at.y + height), color_of(color), 2.0f);
  ImGui::Dummy(ImVec2(height, height));
}

/// Position of texels of a view on the screen.
struct Frame {
  ImVec2 origin;
  float cell;
  const LevelView& view;
  ImVec2 at(float x, float y) const {
    return ImVec2(origin.x + cell * (x - float(view.x)), origin.y + cell * (y - float(view.y)));
  }
};

void draw_texels(ImDrawList& list, const Frame& frame) {
  const LevelView& view = frame.view;
  for (int row = 0; row < view.rows; ++row) {
    for (int column = 0; column < view.columns; ++column) {
      const uint8_t* p = &view.pixels[4 * (size_t(row) * view.columns + column)];
      const ImVec2 low = frame.at(float(view.x + column), float(view.y + row));
      const ImVec2 high = frame.at(float(view.x + column + 1), float(view.y + row + 1));
      const float gap = frame.cell >= 6.0f ? 1.0f : 0.0f;
      list.AddRectFilled(low, ImVec2(high.x - gap, high.y - gap), IM_COL32(p[0], p[1], p[2], 255));
    }
  }
}

void draw_footprint(ImDrawList& list, const Frame& frame, float scale) {
  const LevelView& view = frame.view;
  constexpr int kPoints = 64;
  ImVec2 points[kPoints];
  for (int i = 0; i < kPoints; ++i) {
    const float angle = 6.2831853f * float(i) / kPoints, c = std::cos(angle), s = std::sin(angle);
    points[i] = frame.at(view.center[0] + c * view.footprint[0][0] + s * view.footprint[1][0],
                         view.center[1] + c * view.footprint[0][1] + s * view.footprint[1][1]);
  }
  list.AddPolyline(points, kPoints, IM_COL32(0, 0, 0, 180), ImDrawFlags_Closed, 3.5f * scale);
  list.AddPolyline(points, kPoints, kAccent, ImDrawFlags_Closed, 1.6f * scale);
  const ImVec2 middle = frame.at(view.center[0], view.center[1]);
  const float arm = 5.0f * scale;
  for (int pass = 0; pass < 2; ++pass) {
    const ImU32 color = pass == 0 ? IM_COL32(0, 0, 0, 200) : kAccent;
    const float width = (pass == 0 ? 3.0f : 1.5f) * scale;
    list.AddLine(ImVec2(middle.x - arm, middle.y), ImVec2(middle.x + arm, middle.y), color, width);
    list.AddLine(ImVec2(middle.x, middle.y - arm), ImVec2(middle.x, middle.y + arm), color, width);
  }
}

/// Weights of the texels of a view, summed over the taps that read the same texel.
std::map<std::pair<int, int>, float> weights_of(const Explanation& e, const LevelView& view) {
  std::map<std::pair<int, int>, float> weights;
  for (const Tap& tap : e.taps) {
    if (tap.tap.level_u == view.level_u && tap.tap.level_v == view.level_v && !tap.tap.border) {
      weights[{tap.x, tap.y}] += tap.tap.weight;
    }
  }
  return weights;
}

/// A disc in each texel whose area is its weight, and the number where there is room.
void draw_weights(ImDrawList& list, const Ui& ui, const Explanation& e, const Frame& frame) {
  const auto weights = weights_of(e, frame.view);
  float most = 1e-9f;
  for (const auto& [texel, weight] : weights) most = std::max(most, std::abs(weight));
  for (const auto& [texel, weight] : weights) {
    const ImVec2 middle = frame.at(float(texel.first) + 0.5f, float(texel.second) + 0.5f);
    const float radius = std::max(0.42f * frame.cell * std::sqrt(std::abs(weight) / most), 1.0f);
    const ImU32 fill = weight < 0.0f ? IM_COL32(90, 150, 255, 190) : IM_COL32(255, 255, 255, 190);
    list.AddCircleFilled(middle, radius, fill);
    list.AddCircle(middle, radius, IM_COL32(0, 0, 0, 210), 0, 1.2f);
    if (frame.cell < 34.0f * ui.scale) continue;
    char text[16];
    std::snprintf(text, sizeof text, "%.3f", weight);
    ImGui::PushFont(ui.fonts.small);
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 at(std::round(middle.x - 0.5f * size.x), std::round(middle.y - 0.5f * size.y));
    list.AddRectFilled(ImVec2(at.x - 2, at.y), ImVec2(at.x + size.x + 2, at.y + size.y), IM_COL32(0, 0, 0, 170), 2.0f);
    list.AddText(at, kBright, text);
    ImGui::PopFont();
  }
}

/// Texels, weights and footprint of a level in a square of the panel.
void show_level(const Ui& ui, const Explanation& e, const LevelView& view) {
  const float side = ImGui::GetContentRegionAvail().x, height = std::min(side, 300.0f * ui.scale);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, ImVec2(corner.x + side, corner.y + height), IM_COL32(16, 18, 22, 255), 3.0f);
  const float cell = std::min({side / float(view.columns), height / float(view.rows), 64.0f * ui.scale});
  const Frame frame = {ImVec2(corner.x + 0.5f * (side - cell * float(view.columns)),
                              corner.y + 0.5f * (height - cell * float(view.rows))),
                       cell, view};
  list.PushClipRect(corner, ImVec2(corner.x + side, corner.y + height), true);
  draw_texels(list, frame);
  draw_weights(list, ui, e, frame);
  draw_footprint(list, frame, ui.scale);
  list.PopClipRect();
  ImGui::Dummy(ImVec2(side, height));
}

void show_level_buttons(Ui& ui, const Explanation& e) {
  ui.level = std::min(ui.level, e.levels.size() - 1);
  for (size_t i = 0; i < e.levels.size(); ++i) {
    const LevelView& view = e.levels[i];
    char text[64];
    if (view.level_u == view.level_v) {
      std::snprintf(text, sizeof text, "Level %u: %.0f %%", view.level_u, 100.0f * view.share);
    } else {
      std::snprintf(text, sizeof text, "%u x %u: %.0f %%", view.level_u, view.level_v, 100.0f * view.share);
    }
    if (i % 3 != 0) ImGui::SameLine();
    if (i == ui.level) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.62f, 0.42f, 0.14f, 1.0f));
    const bool was_shown = i == ui.level;
    if (ImGui::Button(text)) ui.level = i;
    if (was_shown) ImGui::PopStyleColor();
  }
}

/// The taps as rows: level, texel, weight and colour.
void show_taps(const Ui& ui, const Explanation& e) {
  const ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("taps", 4, flags, ImVec2(0.0f, ImGui::GetContentRegionAvail().y))) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const char* name : {"level", "texel", "weight", "stored value"}) ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(e.taps.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const shd_tap& tap = e.taps[size_t(i)].tap;
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      if (tap.level_u == tap.level_v) ImGui::Text("%u", tap.level_u);
      if (tap.level_u != tap.level_v) ImGui::Text("%u x %u", tap.level_u, tap.level_v);
      ImGui::TableNextColumn();
      if (tap.border) ImGui::TextUnformatted("border");
      if (!tap.border) ImGui::Text("%u, %u", tap.x, tap.y);
      ImGui::TableNextColumn();
      ImGui::Text("%.5f", tap.weight);
      ImGui::TableNextColumn();
      const bool is_integer = std::max({tap.value[0], tap.value[1], tap.value[2]}) > 2.0f;  // codes of unorm channels
      ImGui::Text(is_integer ? "%.0f %.0f %.0f" : "%.4f %.4f %.4f", tap.value[0], tap.value[1], tap.value[2]);
    }
  }
  ImGui::EndTable();
  (void)ui;
}

void show_head(const Ui& ui, const Explanation& e) {
  ImGui::PushFont(ui.fonts.bold);
  ImGui::Text("Pixel %u, %u   %s%s", e.pixel.x, e.pixel.y, e.surface.c_str(), e.side == 1 ? "   side B" : "");
  ImGui::PopFont();
  show_color(ui, "Shaded, linear", e.color);
}

void show_sum(const Ui& ui, const Explanation& e) {
  show_color(ui, "Sum of weight x texel", e.weighted);
  show_color(ui, "shd_texture_sample", e.sampled);
  ImGui::TextDisabled("Difference %.1e; the blends repeat %s", weighted_error(e),
                      e.replay_is_exact ? "every bit" : "NOT every bit");
}

}  // namespace

void show_explanation(Ui& ui, const Explanation& e) {
  if (!e.asked) {
    ImGui::TextWrapped(
        "Click a pixel of the picture to see its footprint on the texture, and the texels that the "
        "filter reads there.");
    return;
  }
  show_head(ui, e);
  if (!e.surface.empty() && e.width > 0) {
    ImGui::TextDisabled("%u x %u texels, %s, level of detail %.2f", e.width, e.height, label_of(kFilters, e.filter),
                        e.lod);
  }
  if (!e.note.empty() || e.levels.empty()) {
    ImGui::Spacing();
    ImGui::TextWrapped("%s", e.note.empty() ? "The lookup reads no texels." : e.note.c_str());
    return;
  }
  ImGui::TextDisabled("u %.5f  v %.5f   %zu tap%s", e.lookup.u, e.lookup.v, e.taps.size(),
                      e.taps.size() == 1 ? "" : "s");
  show_level_buttons(ui, e);
  show_level(ui, e, e.levels[ui.level]);
  show_sum(ui, e);
  show_taps(ui, e);
}

}  // namespace viewer
