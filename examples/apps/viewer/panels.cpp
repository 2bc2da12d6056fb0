// SPDX-License-Identifier: MIT
#include "panels.h"

#include <algorithm>
#include <cstdio>

namespace viewer {
namespace {

template <class Enum, size_t N>
void combo(const char* text, const Choices<N>& choices, Enum& value) {
  label(text);
  ImGui::PushID(text);
  if (ImGui::BeginCombo("", label_of(choices, static_cast<int>(value)), ImGuiComboFlags_HeightLarge)) {
    for (const Choice& choice : choices) {
      const bool is_selected = choice.value == static_cast<int>(value);
      if (ImGui::Selectable(choice.label, is_selected)) value = static_cast<Enum>(choice.value);
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
}

void slider(const char* text, float& value, float low, float high, const char* format = "%.2f",
            ImGuiSliderFlags flags = 0) {
  label(text);
  ImGui::PushID(text);
  ImGui::SliderFloat("", &value, low, high, format, flags | ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopID();
}

bool section(const Ui& ui, const char* text) {
  ImGui::PushFont(ui.fonts.bold);
  const bool is_open = ImGui::CollapsingHeader(text, ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopFont();
  return is_open;
}

/// A name of the list, or the path of a file, which `path` takes.
void source(Ui& ui, const char* text, const char* const* names, int count, std::string& value) {
  label(text);
  ImGui::PushID(text);
  const std::string shown = value.find('/') == std::string::npos ? value : value.substr(value.rfind('/') + 1);
  if (ImGui::BeginCombo("", shown.c_str())) {
    for (int i = 0; i < count; ++i) {
      if (ImGui::Selectable(names[i], value == names[i])) value = names[i];
    }
    ImGui::TextDisabled("or drop a file on the window, or type its path:");
    ImGui::SetNextItemWidth(-1.0f);
    const bool is_entered = ImGui::InputText("##path", ui.path, sizeof ui.path, ImGuiInputTextFlags_EnterReturnsTrue);
    if (is_entered && ui.path[0]) {
      value = ui.path;
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
}

void show_filter(const Ui& ui, Sampling& sampling) {
  if (!section(ui, "Texture filter")) return;
  combo("Filter", kFilters, sampling.filter);
  const bool uses_ratio = sampling.filter == SHD_FILTER_ANISOTROPIC || sampling.filter == SHD_FILTER_EWA;
  ImGui::BeginDisabled(!uses_ratio);
  slider("Max anisotropy", sampling.max_anisotropy, 1.0f, 64.0f, "%.0f", ImGuiSliderFlags_Logarithmic);
  ImGui::EndDisabled();
  slider("LOD bias", sampling.lod_bias, -4.0f, 4.0f);
  combo("Profile", kProfiles, sampling.profile);
  label("Precision");
  int precision = sampling.precision;
  ImGui::RadioButton("full", &precision, SHD_PRECISION_FULL);
  ImGui::SameLine();
  ImGui::RadioButton("fast", &precision, SHD_PRECISION_FAST);
  sampling.precision = static_cast<shd_precision>(precision);
}

void show_surface(const Ui& ui, bool from_file, Surface& surface) {
  if (!section(ui, "Surface")) return;
  if (from_file) ImGui::Checkbox("Materials of the file", &surface.from_file);
  ImGui::BeginDisabled(from_file && surface.from_file);
  combo("Reflectance", kModels, surface.model);
  const bool is_physical = surface.model == SHD_MODEL_METALLIC_ROUGHNESS;
  const bool is_glass = surface.model == SHD_MODEL_GLASS;
  const bool has_lobe = surface.model != SHD_MODEL_LAMBERT && surface.model != SHD_MODEL_UNLIT;
  if (is_physical || is_glass) slider("Roughness", surface.roughness, 0.0f, 1.0f);
  if (is_physical) {
    slider("Metallic", surface.metallic, 0.0f, 1.0f);
    slider("Clear coat", surface.clearcoat, 0.0f, 1.0f);
  } else if (has_lobe && !is_glass) {
    slider("Specular", surface.specular, 0.0f, 1.0f);
    slider("Exponent", surface.exponent, 1.0f, 1000.0f, "%.0f", ImGuiSliderFlags_Logarithmic);
  }
  label("Base colour");
  ImGui::ColorEdit3("##color", surface.color.data(), ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs);
  ImGui::EndDisabled();
}

void show_light(Ui& ui, Lighting& lighting, Content& content) {
  if (!section(ui, "Light")) return;
  label("Direction");
  float direction[2] = {lighting.azimuth, lighting.elevation};
  if (ImGui::DragFloat2("##direction", direction, 0.5f, -360.0f, 360.0f, "%.0f\xc2\xb0")) {
    lighting.azimuth = direction[0], lighting.elevation = std::clamp(direction[1], -90.0f, 90.0f);
  }
  slider("Intensity", lighting.intensity, 0.0f, 10.0f, "%.2f", ImGuiSliderFlags_Logarithmic);
  slider("Ambient", lighting.ambient, 0.0f, 1.0f);
  constexpr const char* kEnvironments[] = {"studio", "none"};
  source(ui, "Environment", kEnvironments, 2, lighting.environment);
  ImGui::BeginDisabled(lighting.environment == "none");
  slider("Its intensity", lighting.environment_intensity, 0.0f, 4.0f);
  ImGui::EndDisabled();
  label("Darkening");
  ImGui::Checkbox("shadows", &lighting.shadows);
  ImGui::SameLine();
  ImGui::Checkbox("occlusion", &content.occlusion);
}

void show_display(const Ui& ui, State& state, Side& side) {
  if (!section(ui, "Display")) return;
  combo("Show", kShows, side.show);
  label("View");
  const Display& current = state.display;
  const std::string name = current.display.empty() ? "plain sRGB curve" : current.display + " / " + current.view;
  if (ImGui::BeginCombo("##view", name.c_str())) {
    if (ImGui::Selectable("plain sRGB curve", current.display.empty())) state.display = Display();
    for (const Display& display : ui.displays) {
      const std::string text = display.display + " / " + display.view;
      if (ImGui::Selectable(text.c_str(), display == current)) state.display = display;
    }
    if (ui.displays.empty()) ImGui::TextDisabled("built without libshd_color");
    ImGui::EndCombo();
  }
  label("Samples a pixel");
  int samples = static_cast<int>(side.samples);
  ImGui::RadioButton("1", &samples, 1);
  ImGui::SameLine();
  ImGui::RadioButton("4", &samples, 4);
  side.samples = static_cast<uint32_t>(samples);
}

void show_content(Ui& ui, const Picture* picture, Content& content) {
  if (!section(ui, "Model")) return;
  constexpr const char* kModelNames[] = {"teapot", "sphere", "box", "torus", "plane"};
  constexpr const char* kTextureNames[] = {"default", "porcelain", "tiles", "none"};
  source(ui, "Model", kModelNames, 5, content.model);
  source(ui, "Texture", kTextureNames, 4, content.texture);
  label("Floor");
  ImGui::Checkbox("##floor", &content.floor);
  if (!picture) return;
  for (const std::string& warning : picture->warnings) ImGui::TextWrapped("%s", warning.c_str());
}

/// Buttons A and B, and the switch of the wipe.
void show_sides(Ui& ui, State& state) {
  bool is_on = state.wipe;
  if (ImGui::Checkbox("Compare A | B", &is_on)) set_wipe(ui, state, is_on);
  if (!state.wipe) return;
  for (int i = 0; i < 2; ++i) {
    ImGui::SameLine(0.0f, i == 0 ? 18.0f * ui.scale : 4.0f * ui.scale);
    if (ui.side == i) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.62f, 0.42f, 0.14f, 1.0f));
    const bool was_shown = ui.side == i;
    if (ImGui::Button(i == 0 ? "edit A" : "edit B", ImVec2(72.0f * ui.scale, 0.0f))) ui.side = i;
    if (was_shown) ImGui::PopStyleColor();
  }
}

}  // namespace

void label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(0.36f * ImGui::GetWindowWidth());
  ImGui::SetNextItemWidth(-1.0f);
}

void set_wipe(Ui& ui, State& state, bool is_on) {
  if (is_on && !ui.b_is_own) state.side[1] = other_side(state.side[0]);
  ui.b_is_own = ui.b_is_own || is_on;
  ui.side = is_on ? 1 : 0;
  state.wipe = is_on;
}

void show_settings(Ui& ui, const Picture* picture, State& state) {
  show_sides(ui, state);
  Side& side = state.side[ui.side];
  show_filter(ui, side.sampling);
  show_surface(ui, picture && picture->from_file, side.surface);
  show_light(ui, state.lighting, state.content);
  show_display(ui, state, side);
  show_content(ui, picture, state.content);
}

void show_buttons(Ui& ui) {
  if (ImGui::Button("Save PNG")) ui.save = true;
  ImGui::SameLine();
  if (ImGui::Button("Reset camera")) ui.reset = true;
  ImGui::SameLine();
  ImGui::Checkbox("Magnifier", &ui.magnifier);
  ImGui::SameLine();
  if (ImGui::Button("Open")) ui.open = true;
  ImGui::SameLine();
  if (ImGui::Button("Keys")) ui.help = true;
}

std::string with_commas(uint64_t count) {
  std::string text = std::to_string(count);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) text.insert(static_cast<size_t>(at), ",");
  return text;
}

void show_status(Ui& ui, const Rect& place, const Picture* picture, float progress) {
  ImGui::SetNextWindowPos(ImVec2(float(place.x), float(place.y)));
  ImGui::SetNextWindowSize(ImVec2(float(place.width), float(place.height)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12.0f * ui.scale, 4.0f * ui.scale));
  ImGui::Begin("status", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::AlignTextToFramePadding();
  if (picture && picture->side[0]) {
    double seconds = 0.0;
    uint64_t fragments = 0;
    for (const auto& image : picture->side) {
      if (image) seconds += image->seconds, fragments += image->stats.fragment_count;
    }
    ImGui::Text("%.1f ms   %s fragments   %.1f M/s   %s triangles   %s, %u worker%s", 1e3 * seconds,
                with_commas(fragments).c_str(), 1e-6 * double(fragments) / std::max(seconds, 1e-9),
                with_commas(picture->triangles).c_str(), picture->simd.c_str(), picture->workers,
                picture->workers == 1 ? "" : "s");
  }
  const float width = 170.0f * ui.scale;
  if (progress >= 0.0f) {
    ImGui::SameLine(float(place.width) - width - 66.0f * ui.scale);
    ImGui::ProgressBar(progress, ImVec2(width - 20.0f * ui.scale, 0.0f));
    ImGui::SameLine();
    if (ImGui::SmallButton("Cancel")) ui.cancel = true;
  } else if (!ui.notice.empty()) {
    ImGui::SameLine(float(place.width) - ImGui::CalcTextSize(ui.notice.c_str()).x - 12.0f * ui.scale);
    ImGui::TextDisabled("%s", ui.notice.c_str());
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace viewer
