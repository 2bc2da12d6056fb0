// SPDX-License-Identifier: MIT
#include "dialogs.h"

#include <imgui.h>

namespace viewer {
namespace {

/// Begins a window in the middle of the screen, of a size in multiples of the text's. `is_open` becomes false by its
/// cross.
bool begin(const Ui& ui, const char* title, float width, float height, bool* is_open) {
  const ImGuiViewport& screen = *ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(screen.GetCenter(), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(width * ui.scale, height * ui.scale), ImGuiCond_Appearing);
  return ImGui::Begin(title, is_open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
}

void show_folder(Ui& ui, State& state) {
  std::string next;
  if (ImGui::Selectable("..")) next = parent_of(ui.folder.path);
  for (const std::string& name : ui.folder.folders) {
    if (ImGui::Selectable((name + "/").c_str())) next = ui.folder.path + "/" + name;
  }
  for (const std::string& name : ui.folder.files) {
    if (!ImGui::Selectable(name.c_str())) continue;
    open_file(state, ui.folder.path + "/" + name);
    ui.open = false;
  }
  if (!next.empty()) ui.folder = list_folder(next);
}

}  // namespace

void show_help(Ui& ui) {
  if (!ui.help) return;
  constexpr const char* kRows[][2] = {{"drag", "turns the camera"},
                                      {"right drag, Shift and drag", "moves the camera"},
                                      {"wheel", "comes nearer"},
                                      {"click", "explains the pixel"},
                                      {"drop of a file", "shows a model, a texture or an environment"},
                                      {"O", "opens a file"},
                                      {"W", "compares two settings, A and B"},
                                      {"M", "magnifier"},
                                      {"Tab", "the other tab"},
                                      {"S", "saves the picture as shd-viewer.png"},
                                      {"R", "the camera of the start"},
                                      {"F1", "these keys"},
                                      {"Escape", "stops a rendering, leaves a message or a window"}};
  if (begin(ui, "Mouse and keys", 470.0f, 400.0f, &ui.help) && ImGui::BeginTable("keys", 2)) {
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed);
    for (const auto& row : kRows) {
      ImGui::TableNextColumn();
      ImGui::PushFont(ui.fonts.bold);
      ImGui::TextUnformatted(row[0]);
      ImGui::PopFont();
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(row[1]);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

void show_open(Ui& ui, State& state) {
  if (!ui.open) return;
  if (ui.folder.path.empty()) ui.folder = list_folder("");
  if (begin(ui, "Open a model, a texture or an environment", 560.0f, 520.0f, &ui.open)) {
    ImGui::TextWrapped("%s", ui.folder.path.c_str());
    ImGui::BeginChild("files", ImVec2(0.0f, 0.0f), true);
    show_folder(ui, state);
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace viewer
