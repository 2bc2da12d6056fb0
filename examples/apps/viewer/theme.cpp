// SPDX-License-Identifier: MIT
#include "theme.h"

#include <cmath>
#include <fstream>

namespace viewer {
namespace {

struct Family {
  const char *regular, *bold;
};

constexpr Family kFamilies[] = {
    {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf", "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf"},
    {"/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
     "/usr/share/fonts/truetype/open-sans/OpenSans-Bold.ttf"},
    {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
    {"/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf"},
    {"/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
     "/usr/share/fonts/truetype/liberation/LiberationSans-Bold.ttf"},
    {"/System/Library/Fonts/Supplemental/Arial.ttf", "/System/Library/Fonts/Supplemental/Arial Bold.ttf"}};

bool is_readable(const std::string& path) {
  return !path.empty() && std::ifstream(path, std::ios::binary).good();
}

Fonts load_fonts(float scale, const std::string& font) {
  Family family = {font.c_str(), font.c_str()};
  for (const Family& usual : kFamilies) {
    if (!is_readable(family.regular)) family = usual;
  }
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  Fonts fonts;
  if (!is_readable(family.regular)) {
    ImFontConfig config;
    config.SizePixels = std::round(13.0f * scale * 1.15f);
    fonts.text = fonts.bold = fonts.small = atlas.AddFontDefault(&config);
    return fonts;
  }
  const char* const bold = is_readable(family.bold) ? family.bold : family.regular;
  fonts.text = atlas.AddFontFromFileTTF(family.regular, std::round(15.0f * scale));
  fonts.bold = atlas.AddFontFromFileTTF(bold, std::round(15.0f * scale));
  fonts.small = atlas.AddFontFromFileTTF(family.regular, std::round(11.0f * scale));
  return fonts;
}

void set_colors(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  const auto set = [&style](ImGuiCol which, float r, float g, float b, float a = 1.0f) {
    style.Colors[which] = ImVec4(r, g, b, a);
  };
  set(ImGuiCol_Text, 0.90f, 0.91f, 0.93f);
  set(ImGuiCol_TextDisabled, 0.56f, 0.60f, 0.66f);
  set(ImGuiCol_WindowBg, 0.115f, 0.125f, 0.145f);
  set(ImGuiCol_PopupBg, 0.135f, 0.145f, 0.170f);
  set(ImGuiCol_Border, 0.24f, 0.26f, 0.30f);
  set(ImGuiCol_FrameBg, 0.185f, 0.20f, 0.23f);
  set(ImGuiCol_FrameBgHovered, 0.24f, 0.26f, 0.30f);
  set(ImGuiCol_FrameBgActive, 0.28f, 0.30f, 0.35f);
  set(ImGuiCol_Header, 0.165f, 0.18f, 0.21f);
  set(ImGuiCol_HeaderHovered, 0.23f, 0.25f, 0.29f);
  set(ImGuiCol_HeaderActive, 0.27f, 0.29f, 0.34f);
  set(ImGuiCol_Button, 0.22f, 0.24f, 0.28f);
  set(ImGuiCol_ButtonHovered, 0.29f, 0.32f, 0.37f);
  set(ImGuiCol_ButtonActive, 0.36f, 0.39f, 0.45f);
  set(ImGuiCol_SliderGrab, 0.85f, 0.60f, 0.24f);
  set(ImGuiCol_SliderGrabActive, 1.0f, 0.69f, 0.23f);
  set(ImGuiCol_CheckMark, 1.0f, 0.69f, 0.23f);
  set(ImGuiCol_Tab, 0.115f, 0.125f, 0.145f);
  set(ImGuiCol_TabHovered, 0.29f, 0.32f, 0.37f);
  set(ImGuiCol_TabActive, 0.22f, 0.24f, 0.28f);
  set(ImGuiCol_PlotHistogram, 1.0f, 0.69f, 0.23f);
}

}  // namespace

Fonts set_theme(float scale, const std::string& font) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_colors(style);
  style.WindowRounding = 0.0f;
  style.WindowBorderSize = 0.0f;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = style.TabRounding = 3.0f;
  style.WindowPadding = ImVec2(14.0f, 10.0f);
  style.FramePadding = ImVec2(8.0f, 3.0f);
  style.ItemSpacing = ImVec2(8.0f, 4.0f);
  style.ItemInnerSpacing = ImVec2(8.0f, 4.0f);
  style.ScrollbarSize = 12.0f;
  style.AntiAliasedLinesUseTex = false;  // needs bilinear lookups, which SDL's software renderer does not have
  style.ScaleAllSizes(scale);
  return load_fonts(scale, font);
}

}  // namespace viewer
