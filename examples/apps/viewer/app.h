// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include <SDL.h>

#include "options.h"
#include "viewport.h"
#include "worker.h"

namespace viewer {

/// The window. It draws when something changed, and otherwise waits for events.
class App {
 public:
  /// Opens the window and starts the worker. Throws std::runtime_error with SDL's text.
  explicit App(const Options& options);
  ~App();

  /// Handles events until the window is closed.
  void run();

  /// Renders the state, draws the window and writes it to the file of the options. Returns the exit code.
  int screenshot();

 private:
  void open_window();
  void lay_out();
  void request();
  void take_picture();
  void draw();
  void handle(const SDL_Event& event);
  void handle_key(SDL_Keycode key);
  void leave_error();
  void obey_buttons();
  void show_panel();
  void save_picture();
  bool is_preview_enough() const;

  Options options_;
  State state_;
  Ui ui_;
  Layout layout_;
  SDL_Window* window_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
  SDL_Texture* font_texture_ = nullptr;
  std::unique_ptr<Viewport> viewport_;
  std::unique_ptr<Worker> worker_;
  std::shared_ptr<const Picture> latest_;
  std::optional<State> asked_;  // last state that the worker was asked for
  double full_seconds_ = 0.0;   // time of the last picture in full size
  bool is_open_ = true;
};

}  // namespace viewer
