// SPDX-License-Identifier: MIT
#include "viewport.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "magnifier.h"

namespace viewer {
namespace {

constexpr int kGrip = 7;        // pixels beside the divider that hold it
constexpr int kClickMoves = 4;  // pixels that a click may move

void draw_label(ImDrawList& list, const Ui& ui, ImVec2 at, const char* text, bool is_right) {
  ImGui::PushFont(ui.fonts.bold);
  const ImVec2 size = ImGui::CalcTextSize(text);
  ImGui::PopFont();
  const float pad = 7.0f * ui.scale;
  if (is_right) at.x -= size.x + 2.0f * pad;
  list.AddRectFilled(at, ImVec2(at.x + size.x + 2.0f * pad, at.y + size.y + pad), kShade, 3.0f);
  list.AddText(ui.fonts.bold, ui.fonts.bold->FontSize, ImVec2(at.x + pad, at.y + 0.5f * pad), kBright, text);
}

/// Name of a side: its filter, and other settings in which the sides differ.
std::string name_of(const Side (&sides)[2], int index) {
  const Side &side = sides[index], &other = sides[1 - index];
  std::string name = std::string(index == 0 ? "A   " : "B   ") + label_of(kFilters, side.sampling.filter);
  const auto add = [&name](bool differs, const std::string& text) { name += differs ? ", " + text : ""; };
  const Sampling &a = side.sampling, &b = other.sampling;
  char bias[32];
  std::snprintf(bias, sizeof bias, "bias %.2f", a.lod_bias);
  add(a.max_anisotropy != b.max_anisotropy, "max " + std::to_string(int(a.max_anisotropy)));
  add(a.lod_bias != b.lod_bias, bias);
  add(a.profile != b.profile, label_of(kProfiles, a.profile));
  add(a.precision != b.precision, label_of(kPrecisions, a.precision));
  add(side.surface.model != other.surface.model, label_of(kModels, side.surface.model));
  add(side.show != other.show, label_of(kShows, int(side.show)));
  add(side.samples != other.samples, side.samples == 1 ? "1 sample" : "4 samples");
  return name;
}

void draw_message(const Ui& ui, const Rect& place) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float width = std::min(0.7f * float(place.width), 620.0f * ui.scale), pad = 18.0f * ui.scale;
  const char* const title = "This could not be shown";
  const char* const hint = "Choose another file in the panel, or press Escape.";
  const ImVec2 size = ImGui::CalcTextSize(ui.message.c_str(), nullptr, false, width);
  const float line = 1.7f * ImGui::GetFontSize(), height = size.y + 2.0f * line;
  const ImVec2 at(std::round(float(place.x) + 0.5f * (float(place.width) - width)),
                  std::round(float(place.y) + 0.5f * (float(place.height) - height)));
  const ImVec2 low(at.x - pad, at.y - pad), high(at.x + width + pad, at.y + height + pad);
  list.AddRectFilled(low, high, IM_COL32(62, 38, 40, 245), 5.0f);
  list.AddRectFilled(low, ImVec2(low.x + 5.0f * ui.scale, high.y), IM_COL32(225, 84, 72, 255));
  list.AddText(ui.fonts.bold, ui.fonts.bold->FontSize, at, IM_COL32(255, 140, 125, 255), title);
  list.AddText(ui.fonts.text, ui.fonts.text->FontSize, ImVec2(at.x, at.y + line), kBright, ui.message.c_str(), nullptr,
               width);
  list.AddText(ui.fonts.text, ui.fonts.text->FontSize, ImVec2(at.x, at.y + line + size.y + 0.3f * line), kDim, hint);
}

}  // namespace

Viewport::~Viewport() {
  for (SDL_Texture* texture : textures_) {
    if (texture) SDL_DestroyTexture(texture);
  }
  if (tile_texture_) SDL_DestroyTexture(tile_texture_);
}

void Viewport::set_tiles(const Tiles& tiles) {
  const uint32_t width = tiles_.width, height = tiles_.height;
  if (!tiles.take(tiles_version_, tiles_)) return;
  if (tiles_.width != width || tiles_.height != height) {
    if (tile_texture_) SDL_DestroyTexture(tile_texture_);
    tile_texture_ = nullptr;
  }
  if (tiles_.width == 0) return;
  if (!tile_texture_) {
    tile_texture_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC,
                                      static_cast<int>(tiles_.width), static_cast<int>(tiles_.height));
    if (!tile_texture_) return;
    SDL_SetTextureBlendMode(tile_texture_, SDL_BLENDMODE_BLEND);
  }
  SDL_UpdateTexture(tile_texture_, nullptr, tiles_.pixels.data(), static_cast<int>(4 * tiles_.width));
}

void Viewport::set_picture(const std::shared_ptr<const Picture>& picture) {
  if (!picture || picture == shown_ || !picture->side[0]) return;
  for (int i = 0; i < 2; ++i) {
    const Image* image = picture->side[i].get();
    if (shown_ && shown_->side[i] == picture->side[i]) continue;
    if (textures_[i]) SDL_DestroyTexture(textures_[i]);
    textures_[i] = nullptr;
    if (!image) continue;
    textures_[i] = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC,
                                     static_cast<int>(image->width), static_cast<int>(image->height));
    if (!textures_[i]) continue;
    SDL_UpdateTexture(textures_[i], nullptr, image->display.data(), static_cast<int>(4 * image->width));
    SDL_SetTextureBlendMode(textures_[i], SDL_BLENDMODE_NONE);
  }
  shown_ = picture;
}

void Viewport::draw_side(SDL_Texture* texture, int side, const Rect& place, const State& state) const {
  int width = 0, height = 0;
  SDL_QueryTexture(texture, nullptr, nullptr, &width, &height);
  State scaled = state;
  scaled.width = static_cast<uint32_t>(width);
  const int image_split = side == 0 ? 0 : static_cast<int>(divider_column(scaled));
  const int split = side == 0 ? 0 : static_cast<int>(divider_column(state));
  const SDL_Rect from = {image_split, 0, width - image_split, height};
  const SDL_Rect to = {place.x + split, place.y, place.width - split, place.height};
  if (from.w > 0 && to.w > 0) SDL_RenderCopy(renderer_, texture, &from, &to);
}

void Viewport::draw_pixels(const Rect& place, const State& state) const {
  for (int i = 0; i < 2; ++i) {
    if (textures_[i]) draw_side(textures_[i], i, place, state);
    if (tile_texture_ && tiles_.side == i) draw_side(tile_texture_, i, place, state);
  }
}

void Viewport::draw_marks(const Ui& ui, const Rect& place, const State& state) const {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(ImVec2(float(place.x), float(place.y)),
                    ImVec2(float(place.x + place.width), float(place.y + place.height)));
  if (state.wipe && shown_ && shown_->side[1]) {
    const float x = float(place.x) + float(divider_column(state)), middle = float(place.y) + 0.5f * float(place.height);
    const float top = float(place.y), grip = 13.0f * ui.scale;
    list.AddRectFilled(ImVec2(x - 1.0f, top), ImVec2(x + 1.0f, top + float(place.height)), kAccent);
    list.AddCircleFilled(ImVec2(x, middle), grip, kAccent);
    for (const float side : {-1.0f, 1.0f}) {
      list.AddTriangleFilled(ImVec2(x + side * 0.68f * grip, middle),
                             ImVec2(x + side * 0.2f * grip, middle - 0.4f * grip),
                             ImVec2(x + side * 0.2f * grip, middle + 0.4f * grip), IM_COL32(30, 24, 14, 255));
    }
    const float gap = 12.0f * ui.scale;
    draw_label(list, ui, ImVec2(x - gap, top + gap), name_of(shown_->state.side, 0).c_str(), true);
    draw_label(list, ui, ImVec2(x + gap, top + gap), name_of(shown_->state.side, 1).c_str(), false);
  }
  if (state.pick && shown_) {
    const ImVec2 at(float(place.x) + float(state.pick->x) + 0.5f, float(place.y) + float(state.pick->y) + 0.5f);
    list.AddCircle(at, 8.0f * ui.scale, IM_COL32(0, 0, 0, 200), 24, 4.0f * ui.scale);
    list.AddCircle(at, 8.0f * ui.scale, kAccent, 24, 2.0f * ui.scale);
  }
  if (ui.magnified && ui.message.empty() && shown_ && shown_->side[0]->width == state.width) {
    draw_magnifier(ui, place, *shown_, divider_column(state), *ui.magnified);
  }
  if (!ui.message.empty()) draw_message(ui, place);
  list.PopClipRect();
}

void Viewport::press(const SDL_MouseButtonEvent& event, const Rect& place, const State& state) {
  if (drag_ != Drag::kNone || !place.contains(event.x, event.y)) return;
  const int divider = place.x + static_cast<int>(divider_column(state));
  moved_ = 0;
  if (event.button != SDL_BUTTON_LEFT || (SDL_GetModState() & KMOD_SHIFT)) {
    drag_ = Drag::kPan;
  } else if (state.wipe && std::abs(event.x - divider) <= kGrip) {
    drag_ = Drag::kDivider;
  } else {
    drag_ = Drag::kTurn;
  }
}

void Viewport::release(const SDL_MouseButtonEvent& event, const Rect& place, Ui& ui, State& state) {
  const bool is_click = drag_ == Drag::kTurn && moved_ < kClickMoves && place.contains(event.x, event.y);
  drag_ = Drag::kNone;
  moved_ = 0;
  if (!is_click) return;
  state.pick = Pixel{static_cast<uint32_t>(event.x - place.x), static_cast<uint32_t>(event.y - place.y)};
  ui.pixel_tab = ui.select_tab = true;
  ui.level = 0;
}

void Viewport::move(const SDL_MouseMotionEvent& event, const Rect& place, Ui& ui, State& state) {
  if (ui.magnifier && place.contains(event.x, event.y)) {
    ui.magnified = Pixel{static_cast<uint32_t>(event.x - place.x), static_cast<uint32_t>(event.y - place.y)};
  }
  if (drag_ == Drag::kNone) return;
  moved_ += std::abs(event.xrel) + std::abs(event.yrel);
  const float dx = float(event.xrel), dy = float(event.yrel);
  if (drag_ == Drag::kDivider) {
    state.divider = std::clamp(float(event.x - place.x) / float(place.width), 0.0f, 1.0f);
  } else if (moved_ >= kClickMoves) {
    state.pick.reset();  // the pixel shows another point now
    if (drag_ == Drag::kTurn) turn(state.orbit, dx, dy);
    if (drag_ == Drag::kPan) pan(state.orbit, dx, dy, float(place.width), float(place.height));
  }
}

void Viewport::handle(const SDL_Event& event, const Rect& place, Ui& ui, State& state) {
  if (event.type == SDL_MOUSEBUTTONDOWN) {
    press(event.button, place, state);
  } else if (event.type == SDL_MOUSEBUTTONUP) {
    release(event.button, place, ui, state);
  } else if (event.type == SDL_MOUSEMOTION) {
    move(event.motion, place, ui, state);
  } else if (event.type == SDL_MOUSEWHEEL) {
    state.pick.reset();
    zoom(state.orbit, float(event.wheel.y), float(place.width) / float(place.height));
  }
}

}  // namespace viewer
