// SPDX-License-Identifier: MIT
#pragma once
#include <SDL.h>

#include "tiles.h"
#include "ui.h"

namespace viewer {

/// The picture in the window, its divider, marks and messages, and the tools of the mouse.
class Viewport {
 public:
  explicit Viewport(SDL_Renderer* renderer) : renderer_(renderer) {}
  ~Viewport();

  /// Copies the sides of a picture to textures, if it is another one than before. Keeps the old picture after errors.
  void set_picture(const std::shared_ptr<const Picture>& picture);

  /// Copies tiles of the frame that is being drawn, which cover the old picture.
  void set_tiles(const Tiles& tiles);

  /// Draws the pixels of both sides, unscaled if the picture has the size of the viewport.
  void draw_pixels(const Rect& place, const State& state) const;

  /// Adds divider, mark of the picked pixel, magnifier and messages to ImGui's background.
  void draw_marks(const Ui& ui, const Rect& place, const State& state) const;

  /// Turns, pans, zooms, moves the divider and picks pixels. `event` is one that ImGui does not use.
  void handle(const SDL_Event& event, const Rect& place, Ui& ui, State& state);

  /// A drag is under way, so a coarser picture is good enough.
  bool is_dragging() const { return drag_ != Drag::kNone && moved_ > 0; }

  const std::shared_ptr<const Picture>& shown() const { return shown_; }

 private:
  enum class Drag { kNone, kTurn, kPan, kDivider };

  void draw_side(SDL_Texture* texture, int side, const Rect& place, const State& state) const;
  void press(const SDL_MouseButtonEvent& event, const Rect& place, const State& state);
  void release(const SDL_MouseButtonEvent& event, const Rect& place, Ui& ui, State& state);
  void move(const SDL_MouseMotionEvent& event, const Rect& place, Ui& ui, State& state);

  SDL_Renderer* renderer_;
  SDL_Texture* textures_[2] = {};
  SDL_Texture* tile_texture_ = nullptr;
  TileImage tiles_;
  uint64_t tiles_version_ = 0;
  std::shared_ptr<const Picture> shown_;  // the last one without an error
  Drag drag_ = Drag::kNone;
  int moved_ = 0;  // pixels of the current drag
};

}  // namespace viewer
