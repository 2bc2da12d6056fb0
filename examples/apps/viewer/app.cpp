// SPDX-License-Identifier: MIT
#include "app.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include "dialogs.h"
#include "explain_view.h"
#include "gui_render.h"
#include "panels.h"
#include "screenshot.h"

namespace viewer {
namespace {

constexpr double kSmooth = 0.12;     // frames that take longer are drawn coarsely during a drag [s]
constexpr int kDrawsAfterEvent = 3;  // ImGui settles its layout within this number of frames

void require(bool is_good, const char* what) {
  if (!is_good) throw std::runtime_error(std::string(what) + ": " + SDL_GetError());
}

/// Scale of texts by the resolution of the screen, in steps of 1/4.
float screen_scale(SDL_Window* window) {
  float dpi = 96.0f;
  if (SDL_GetDisplayDPI(SDL_GetWindowDisplayIndex(window), nullptr, &dpi, nullptr) != 0) return 1.0f;
  return std::clamp(std::round(4.0f * dpi / 96.0f) / 4.0f, 1.0f, 3.0f);
}

/// Wakes the loop from another thread.
void wake() {
  SDL_Event event = {};
  event.type = SDL_USEREVENT;
  SDL_PushEvent(&event);
}

bool is_same_request(const State& a, const State& b) {
  return same_pixels(a, b) && a.pick == b.pick && (!a.pick || side_at(a, a.pick->x) == side_at(b, b.pick->x));
}

}  // namespace

App::App(const Options& options) : options_(options), state_(options.state) {
  try {
    open_window();
  } catch (...) {
    SDL_Quit();
    throw;
  }
  ui_.pixel_tab = options_.pixel_tab;
  ui_.b_is_own = state_.wipe;
  ui_.magnified = options_.magnify;
  ui_.magnifier = options_.magnify.has_value();
  viewport_ = std::make_unique<Viewport>(renderer_);
  worker_ = std::make_unique<Worker>(options_.threads, wake);
  ui_.displays = worker_->displays();
  lay_out();
}

App::~App() {
  worker_.reset();
  viewport_.reset();
  if (font_texture_) SDL_DestroyTexture(font_texture_);
  ImGui_ImplSDL2_Shutdown();
  ImGui::DestroyContext();
  SDL_DestroyRenderer(renderer_);
  SDL_DestroyWindow(window_);
  SDL_Quit();
}

void App::open_window() {
  SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");  // for previews
  require(SDL_Init(SDL_INIT_VIDEO) == 0, "SDL_Init");
  window_ = SDL_CreateWindow("shd-viewer", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, options_.width,
                             options_.height, SDL_WINDOW_RESIZABLE);
  require(window_, "SDL_CreateWindow");
  // Screenshots have the same pixels on every machine with SDL's own renderer.
  const bool is_software = !options_.screenshot.empty();
  if (!is_software) renderer_ = SDL_CreateRenderer(window_, -1, SDL_RENDERER_ACCELERATED | SDL_RENDERER_PRESENTVSYNC);
  if (!renderer_) renderer_ = SDL_CreateRenderer(window_, -1, SDL_RENDERER_SOFTWARE);
  require(renderer_, "SDL_CreateRenderer");
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ui_.scale = options_.scale > 0.0f ? options_.scale : screen_scale(window_);
  ui_.fonts = set_theme(ui_.scale, options_.font);
  require(ImGui_ImplSDL2_InitForSDLRenderer(window_), "ImGui");
  font_texture_ = make_font_texture(renderer_);
  require(font_texture_, "SDL_CreateTexture");
}

void App::lay_out() {
  int width = 0, height = 0;
  SDL_GetWindowSize(window_, &width, &height);
  layout_ = layout_of(width, height, ui_.scale);
  state_.width = static_cast<uint32_t>(layout_.viewport.width);
  state_.height = static_cast<uint32_t>(layout_.viewport.height);
}

bool App::is_preview_enough() const {
  const bool is_active = viewport_->is_dragging() || (ImGui::IsAnyItemActive() && ImGui::IsMouseDown(0));
  return is_active && full_seconds_ > kSmooth;
}

/// Asks the worker for the picture of the state, in a lower resolution while a heavy frame is dragged.
void App::request() {
  State wanted = state_;
  // A frame that is not finished yet may be heavy, too: its time follows from its progress.
  if (asked_ && asked_->width == state_.width && worker_->is_busy() && worker_->seconds() > 2.0 * kSmooth) {
    full_seconds_ = std::max(full_seconds_, worker_->seconds() / std::max(worker_->progress(), 0.001f));
  }
  const bool is_preview = is_preview_enough();
  if (is_preview) {
    const auto factor = static_cast<uint32_t>(std::ceil(std::sqrt(full_seconds_ / kSmooth)));
    wanted.width = std::max(state_.width / std::min(factor, 16u), 1u);
    wanted.height = std::max(state_.height / std::min(factor, 16u), 1u);
    wanted.pick.reset();
    for (Side& side : wanted.side) side.samples = 1;
  }
  if (asked_ && is_same_request(*asked_, wanted)) return;
  asked_ = wanted;
  worker_->ask(wanted, is_preview);
}

void App::take_picture() {
  const std::shared_ptr<const Picture> picture = worker_->latest();
  if (!picture || picture == latest_) return;
  latest_ = picture;
  if (picture->cancelled) {
    if (!worker_->is_busy()) ui_.notice = "cancelled";  // otherwise a newer state took its place
  } else {
    ui_.message = picture->error;
    ui_.notice.clear();
  }
  viewport_->set_picture(picture);
  if (!picture->side[0] || picture->state.width != state_.width) return;
  full_seconds_ = picture->side[0]->seconds + (picture->side[1] ? picture->side[1]->seconds : 0.0);
}

void App::show_panel() {
  ImGui::SetNextWindowPos(ImVec2(float(layout_.panel.x), float(layout_.panel.y)));
  ImGui::SetNextWindowSize(ImVec2(float(layout_.panel.width), float(layout_.panel.height)));
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  const Picture* const picture = viewport_->shown().get();
  const bool select = ui_.select_tab;
  ui_.select_tab = false;
  if (ImGui::BeginTabBar("tabs")) {
    const auto flags_of = [&](bool is_wanted) { return select && is_wanted ? ImGuiTabItemFlags_SetSelected : 0; };
    if (ImGui::BeginTabItem("Settings", nullptr, flags_of(!ui_.pixel_tab))) {
      const float buttons = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
      ImGui::BeginChild("settings", ImVec2(0.0f, -buttons));
      show_settings(ui_, picture, state_);
      ImGui::EndChild();
      ImGui::Separator();
      show_buttons(ui_);
      ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Pixel", nullptr, flags_of(ui_.pixel_tab))) {
      ImGui::BeginChild("pixel");
      show_explanation(ui_, state_.pick && picture ? picture->explanation : Explanation());
      ImGui::EndChild();
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();
}

void App::draw() {
  ImGui_ImplSDL2_NewFrame();
  ImGui::NewFrame();
  show_panel();
  show_help(ui_);
  show_open(ui_, state_);
  const bool is_slow = worker_->is_busy() && worker_->seconds() > 0.3;
  show_status(ui_, layout_.status, viewport_->shown().get(), is_slow ? worker_->progress() : -1.0f);
  obey_buttons();
  viewport_->draw_marks(ui_, layout_.viewport, state_);
  ImGui::Render();
  SDL_SetRenderDrawColor(renderer_, 24, 26, 30, 255);
  SDL_RenderClear(renderer_);
  viewport_->draw_pixels(layout_.viewport, state_);
  draw_gui(renderer_, *ImGui::GetDrawData());
}

void App::obey_buttons() {
  if (ui_.save) save_picture();
  if (ui_.reset) state_.orbit = options_.state.orbit;
  if (ui_.cancel) worker_->cancel();
  if (ui_.reset) state_.pick.reset();
  ui_.save = ui_.reset = ui_.cancel = false;
  if (!ui_.magnifier) ui_.magnified.reset();
}

void App::save_picture() {
  const std::shared_ptr<const Picture>& shown = viewport_->shown();
  if (!shown) return;
  const std::string error = save_viewport(*shown, divider_column(state_), "shd-viewer.png");
  ui_.notice = error.empty() ? "saved shd-viewer.png" : error;
}

void App::handle_key(SDL_Keycode key) {
  if (key == SDLK_w) set_wipe(ui_, state_, !state_.wipe);
  if (key == SDLK_m) ui_.magnifier = !ui_.magnifier;
  if (key == SDLK_s) ui_.save = true;
  if (key == SDLK_r) ui_.reset = true;
  if (key == SDLK_o) ui_.open = !ui_.open;
  if (key == SDLK_F1) ui_.help = !ui_.help;
  if (key == SDLK_TAB) ui_.pixel_tab = !ui_.pixel_tab, ui_.select_tab = true;
  if (key != SDLK_ESCAPE) return;
  ui_.help = ui_.open = false;
  if (worker_->is_busy()) worker_->cancel();
  if (!ui_.message.empty()) leave_error();
  state_.pick.reset();
}

/// Returns to the files of the shown picture.
void App::leave_error() {
  const Picture* const shown = viewport_->shown().get();
  state_.content = shown ? shown->state.content : Content();
  state_.lighting.environment = shown ? shown->state.lighting.environment : Lighting().environment;
  state_.display = shown ? shown->state.display : Display();
  ui_.message.clear();
}

void App::handle(const SDL_Event& event) {
  ImGui_ImplSDL2_ProcessEvent(&event);
  const ImGuiIO& io = ImGui::GetIO();
  if (event.type == SDL_QUIT) is_open_ = false;
  if (event.type == SDL_WINDOWEVENT) lay_out();
  if (event.type == SDL_DROPFILE) {
    open_file(state_, event.drop.file);
    SDL_free(event.drop.file);
  }
  if (event.type == SDL_KEYDOWN && !io.WantTextInput) handle_key(event.key.keysym.sym);
  const bool is_release = event.type == SDL_MOUSEBUTTONUP;  // ends a drag wherever the pointer is
  if (is_release || !io.WantCaptureMouse || viewport_->is_dragging()) {
    viewport_->handle(event, layout_.viewport, ui_, state_);
  }
}

void App::run() {
  int draws = kDrawsAfterEvent;
  while (is_open_) {
    SDL_Event event;
    if (draws == 0 && SDL_WaitEventTimeout(&event, 1000)) {
      handle(event);
      draws = kDrawsAfterEvent;
    }
    while (SDL_PollEvent(&event)) {
      handle(event);
      draws = kDrawsAfterEvent;
    }
    if (draws == 0) continue;
    --draws;
    take_picture();
    viewport_->set_tiles(worker_->tiles());
    draw();
    request();
    SDL_RenderPresent(renderer_);
  }
}

int App::screenshot() {
  request();
  worker_->wait();
  take_picture();
  SDL_Event event;
  for (int i = 0; i < options_.frames; ++i) {
    while (SDL_PollEvent(&event)) ImGui_ImplSDL2_ProcessEvent(&event);
    draw();
  }
  const std::string error = save_window(renderer_, options_.screenshot);
  if (!error.empty()) throw std::runtime_error(error);
  std::fputs(report_of(*latest_, layout_, divider_column(state_)).c_str(), stdout);
  if (latest_->error.empty()) return 0;
  std::fprintf(stderr, "shd-viewer: %s\n", latest_->error.c_str());
  return 1;
}

}  // namespace viewer
