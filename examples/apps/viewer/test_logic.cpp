// SPDX-License-Identifier: MIT
/// Tests of the viewer's logic: camera, command line, wipe, magnifier, textures that wrap, explained lookups.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include "command/failure.h"
#include "folder.h"
#include "layout.h"
#include "options.h"
#include "stage.h"
#include "worker.h"

namespace {

using namespace viewer;

int failures = 0;

void check(bool is_good, const char* what) {
  if (is_good) return;
  std::printf("FAILED: %s\n", what);
  ++failures;
}

bool is_near(float a, float b, float tolerance) {
  return std::abs(a - b) <= tolerance;
}

void test_orbit() {
  Orbit orbit;
  const Axes axes = axes_of(orbit);
  const float dot = axes.right[0] * axes.up[0] + axes.right[1] * axes.up[1] + axes.right[2] * axes.up[2];
  check(is_near(dot, 0.0f, 1e-6f), "axes are orthogonal");
  turn(orbit, 0.0f, 10000.0f);
  check(orbit.elevation == 89.0f, "elevation stops below the pole");
  const float before = distance_of(orbit, 1.0f);
  zoom(orbit, 1.0f, 1.0f);
  check(orbit.distance < before, "the wheel comes nearer");
  zoom(orbit, -1000.0f, 1.0f);
  check(orbit.distance == 60.0f, "distance has a limit");
  check(fit_distance(32.0f, 0.5f) > fit_distance(32.0f, 1.0f), "a narrow picture needs more distance");
}

/// A pan by 30 pixels moves the image of the target by 30 pixels.
void test_pan() {
  Orbit orbit;
  orbit.distance = 4.0f;
  const Bounds bounds;
  const float width = 400.0f, height = 200.0f;
  pan(orbit, 30.0f, -20.0f, width, height);
  const shd_camera camera = camera_of(orbit, bounds, width / height);
  const shd_view view = shd::view_from_camera(&camera);
  const float origin[3] = {0, 0, 0};
  float in_view[3], clip[3];
  shd::matrix_transform_point(view.world_to_view, origin, in_view);
  shd::matrix_transform_point(view.view_to_clip, in_view, clip);
  check(is_near(0.5f * width * clip[0], 30.0f, 0.5f), "pan to the right");
  check(is_near(-0.5f * height * clip[1], -20.0f, 0.5f), "pan up");
}

void expect_usage(std::vector<const char*> arguments, const char* part) {
  arguments.insert(arguments.begin(), "shd-viewer");
  try {
    Options options;
    read_options(static_cast<int>(arguments.size()), arguments.data(), options);
    check(false, part);
  } catch (const Failure& error) {
    if (!std::strstr(error.what(), part)) std::printf("%s\n", error.what());
    check(std::strstr(error.what(), part) != nullptr, part);
  }
}

void test_options() {
  const char* const line[] = {"shd-viewer", "--filter", "nearest", "--b", "--filter", "ewa", "--wipe", "0.25"};
  Options options;
  check(read_options(8, line, options), "no page");
  check(options.state.side[0].sampling.filter == SHD_FILTER_NEAREST, "side A");
  check(options.state.side[1].sampling.filter == SHD_FILTER_EWA, "side B");
  check(options.state.wipe && options.state.divider == 0.25f, "wipe");
  expect_usage({"--filter", "fancy"}, "--filter: \"fancy\" is not one of nearest, bilinear");
  expect_usage({"--roughness", "nan"}, "--roughness: \"nan\" is not a number 0..1");
  expect_usage({"--size", "1280"}, "--size: \"1280\" is not WIDTHxHEIGHT, each 64..8192");
  expect_usage({"--click", "3,-1"}, "--click: \"3,-1\"");
  expect_usage({"--view", "sRGB"}, "--view");
  expect_usage({"--orbit", "0,95"}, "--orbit");
  expect_usage({"--fliter", "ewa"}, "--fliter is not an option: did you mean --filter?");
  expect_usage({"--wipe"}, "--wipe needs a value: a number 0..1");
}

void test_places() {
  State state;
  state.width = 100;
  check(divider_column(state) == 100 && side_at(state, 99) == 0, "no wipe");
  state.wipe = true, state.divider = 0.25f;
  check(divider_column(state) == 25 && side_at(state, 24) == 0 && side_at(state, 25) == 1, "wipe");
  const Layout layout = layout_of(1280, 800, 1.0f);
  check(layout.viewport.width + layout.panel.width == 1280 && layout.viewport.height + layout.status.height == 800,
        "the parts fill the window");
  const Layout tiny = layout_of(1, 1, 2.0f);
  check(tiny.viewport.width == 1 && tiny.viewport.height == 1, "a tiny window has a viewport");
  const Pixel corner = first_magnified({0, 0}, 100, 100), end = first_magnified({99, 99}, 100, 100);
  check(corner == Pixel{0, 0} && end == Pixel{100 - kMagnifiedColumns, 100 - kMagnifiedRows}, "magnifier at edges");
  State other = state;
  other.divider = 0.5f, other.pick = Pixel{1, 2};
  check(same_pixels(state, other), "divider and pick change no rendered pixel");
  other.side[1].samples = 16;
  check(!same_pixels(state, other), "side B counts with a wipe");
}

void test_dropped_files() {
  State state;
  open_file(state, "/a/sky.HDR");
  open_file(state, "/a.b/wood.png");
  check(state.lighting.environment == "/a/sky.HDR" && state.content.texture == "/a.b/wood.png", "images");
  check(state.content.model == "teapot", "the model stays");
  open_file(state, "/a.b/model");
  check(state.content.model == "/a.b/model" && state.content.texture == "default", "model");
}

void test_folders() {
  namespace fs = std::filesystem;
  const fs::path top = fs::temp_directory_path() / ("viewer_folder_" + std::to_string(::getpid()));
  fs::create_directories(top / "b");
  fs::create_directories(top / "a");
  fs::create_directories(top / ".hidden");
  for (const char* const name : {"z.PNG", "m.glb", "sky.hdr", "notes.txt", ".secret.png", "noend"}) {
    std::ofstream(top / name) << "x";
  }
  const Folder folder = list_folder(top.string());
  check(folder.path == top.string(), "path of a folder");
  check(folder.folders == std::vector<std::string>{"a", "b"}, "folders, sorted, none hidden");
  check(folder.files == std::vector<std::string>{"m.glb", "sky.hdr", "z.PNG"}, "files that can be shown");
  check(list_folder((top / "absent").string()).files.empty(), "an absent folder is empty");
  check(list_folder("").path == fs::current_path().string(), "no path is the current folder");
  check(parent_of((top / "a").string()) == top.string() && parent_of(top.string() + "/a/") == top.string(), "parent");
  check(parent_of("/") == "/", "the top has no parent");
  fs::remove_all(top);
}

void test_sides() {
  Side side;
  check(other_side(side).sampling.filter == SHD_FILTER_TRILINEAR, "B of anisotropic is trilinear");
  side.sampling.filter = SHD_FILTER_TRILINEAR, side.samples = 1;
  check(other_side(side).sampling.filter == SHD_FILTER_ANISOTROPIC, "B of trilinear is anisotropic");
  check(other_side(side).samples == 1, "B has the other settings of A");
}

void test_unwrapped() {
  check(unwrapped(7, 8, SHD_WRAP_REPEAT, 0.2f) == -1, "repeat, left neighbour");
  check(unwrapped(0, 8, SHD_WRAP_REPEAT, 7.9f) == 8, "repeat, right neighbour");
  check(unwrapped(0, 8, SHD_WRAP_MIRROR, -0.4f) == -1, "mirror, left neighbour");
  check(unwrapped(7, 8, SHD_WRAP_MIRROR, 8.4f) == 8, "mirror, right neighbour");
  check(unwrapped(0, 8, SHD_WRAP_CLAMP, -3.0f) == 0, "clamp");
  const float t[6] = {2, 0, 1, 0, 3, -1};
  Lookup lookup;
  lookup.u = 0.5f, lookup.v = 0.25f, lookup.dudx = 0.1f, lookup.dvdy = 0.2f;
  const Lookup out = transformed(lookup, t);
  check(out.u == 2.0f && out.v == -0.25f && out.dudx == 0.2f && is_near(out.dvdy, 0.6f, 1e-7f), "uv transform");
}

void test_wraps(shd_context* context) {
  std::vector<uint8_t> texels(8 * 8, 9);
  shd::texture_desc desc;
  desc.format = SHD_FORMAT_R8;
  desc.width = desc.height = 8;
  desc.texels = texels.data();
  const shd::texture texture = shd::texture_create(context, &desc);
  for (const shd_wrap wrap : {SHD_WRAP_REPEAT, SHD_WRAP_CLAMP, SHD_WRAP_MIRROR, SHD_WRAP_BORDER}) {
    shd::sampler_desc nearest;
    nearest.filter = SHD_FILTER_NEAREST;
    nearest.wrap_u = wrap;
    const shd::sampler sampler = shd::sampler_create(context, &nearest);
    const Wraps found = wraps_of(texture, sampler);
    check(found.u == wrap && found.v == SHD_WRAP_REPEAT, "wrap of a sampler");
  }
}

State small_state() {
  State state;
  state.width = 160, state.height = 120;
  state.content.occlusion = false;
  state.side[0].samples = state.side[1].samples = 1;
  return state;
}

/// The drawn texels have the codes of the taps, which hold linear values.
bool has_colors_of_taps(const Explanation& e, const LevelView& view) {
  for (const Tap& tap : e.taps) {
    const int column = tap.x - view.x, row = tap.y - view.y;
    if (tap.tap.level_u != view.level_u || tap.tap.level_v != view.level_v) continue;
    if (column < 0 || row < 0 || column >= view.columns || row >= view.rows) continue;
    for (int c = 0; c < 3; ++c) {
      const float linear = tap.tap.value[c];
      const float code = linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
      const int drawn = view.pixels[4 * (size_t(row) * size_t(view.columns) + size_t(column)) + size_t(c)];
      if (std::abs(255.0f * code - float(drawn)) > 1.0f) return false;
    }
  }
  return true;
}

/// The explained value of many pixels is that of the sampler, for each filter with an explanation.
void test_explanations(Stage& stage) {
  int taps = 0;
  for (const Choice& choice : kFilters) {
    State state = small_state();
    state.side[0].sampling.filter = static_cast<shd_filter>(choice.value);
    Picture previous;
    for (const Pixel pixel : {Pixel{80, 70}, Pixel{20, 110}, Pixel{140, 30}, Pixel{81, 20}, Pixel{150, 14}}) {
      state.pick = pixel;
      const Picture picture = stage.show(state, shd_progress{}, &previous);
      previous = picture;
      const Explanation& e = picture.explanation;
      check(picture.error.empty() && e.asked && !e.surface.empty(), choice.word);
      const bool has_taps = choice.value != SHD_FILTER_SUMMED_AREA && choice.value != SHD_FILTER_EXACT;
      check(has_taps ? !e.taps.empty() : !e.note.empty(), choice.word);
      if (!has_taps) continue;
      check(e.replay_is_exact && e.explained == e.sampled && weighted_error(e) < 1e-5f, choice.word);
      float share = 0.0f;
      for (const LevelView& view : e.levels) share += view.share;
      check(is_near(share, 1.0f, 1e-4f), "shares of levels");
      for (const LevelView& view : e.levels) check(has_colors_of_taps(e, view), choice.word);
      taps += static_cast<int>(e.taps.size());
    }
  }
  check(taps > 200, "taps were explained");
}

void test_pictures(Stage& stage) {
  State state = small_state();
  state.side[0].sampling.filter = SHD_FILTER_NEAREST;
  const Picture a = stage.show(state, shd_progress{}, nullptr);
  state.side[0].sampling.filter = SHD_FILTER_EWA;
  const Picture b = stage.show(state, shd_progress{}, nullptr);
  state.side[0].sampling.filter = SHD_FILTER_NEAREST;
  state.side[1] = state.side[0];
  state.side[1].sampling.filter = SHD_FILTER_EWA;
  state.wipe = true;
  const Picture both = stage.show(state, shd_progress{}, nullptr);
  check(a.side[0]->display != b.side[0]->display, "filters differ");
  check(compose(both, state.width) == a.side[0]->display && compose(both, 0) == b.side[0]->display, "sides of a wipe");
  const std::vector<uint8_t> half = compose(both, 80);
  bool is_split = true;
  for (size_t i = 0; i < half.size(); ++i) {
    is_split = is_split && half[i] == (i / 4 % state.width < 80 ? a : b).side[0]->display[i];
  }
  check(is_split, "the divider splits");
  for (const Choice& choice : kShows) {
    state.side[0].show = state.side[1].show = static_cast<Show>(choice.value);
    const Picture shown = stage.show(state, shd_progress{}, nullptr);
    check(shown.error.empty() && (choice.value == 0 || shown.side[0]->display != a.side[0]->display), choice.word);
  }
  for (const Choice& choice : kModels) {
    state = small_state();
    state.side[0].surface.model = static_cast<shd_model>(choice.value);
    check(stage.show(state, shd_progress{}, nullptr).error.empty(), choice.word);
  }
}

void test_failures(Stage& stage) {
  State state = small_state();
  const Picture good = stage.show(state, shd_progress{}, nullptr);
  for (const char* path : {"/nonexistent.obj", "/dev/null", "."}) {
    state.content.model = path;
    const Picture bad = stage.show(state, shd_progress{}, &good);
    check(!bad.error.empty() && !bad.side[0], path);
  }
  state = small_state();
  state.lighting.environment = "/nonexistent.hdr";
  check(stage.show(state, shd_progress{}, nullptr).error.find("nonexistent.hdr") != std::string::npos, "environment");
  state = small_state();
  state.content.texture = "/nonexistent.png";
  check(!stage.show(state, shd_progress{}, nullptr).error.empty(), "texture");
  const Picture again = stage.show(small_state(), shd_progress{}, nullptr);
  check(again.error.empty() && again.side[0]->display == good.side[0]->display, "the same picture after failures");
  const shd_progress stop = {[](float, void*) -> shd_result { return SHD_ERROR_CANCELLED; }, nullptr};
  state = small_state();
  state.orbit.azimuth = 90.0f;
  check(stage.show(state, stop, nullptr).cancelled, "a progress callback cancels");
}

/// The worker gives the picture of the last state that it was asked for.
void test_worker(Stage& stage) {
  Worker worker(1, [] {});
  State state = small_state();
  for (int i = 0; i < 20; ++i) {
    state.orbit.azimuth = 4.0f * static_cast<float>(i);
    worker.ask(state);
  }
  const std::shared_ptr<const Picture> last = worker.wait();
  check(last && last->state.orbit == state.orbit, "last state");
  check(last && last->side[0]->display == stage.show(state, shd_progress{}, nullptr).side[0]->display,
        "one worker and many give the same bits");
}

/// Tiles of a frame have the codes of the finished picture, within 1, and cover all of it.
void test_tiles(Stage& stage) {
  const State state = small_state();
  Tiles tiles;
  const Picture picture = stage.show(state, shd_progress{}, nullptr, &tiles);
  TileImage image;
  uint64_t version = 0;
  check(tiles.take(version, image) && !tiles.take(version, image), "tiles are taken once");
  bool is_same = image.pixels.size() == picture.side[0]->display.size();
  for (size_t i = 0; is_same && i < image.pixels.size(); ++i) {
    is_same = std::abs(int(image.pixels[i]) - int(picture.side[0]->display[i])) <= (i % 4 == 3 ? 0 : 2);
  }
  check(is_same, "tiles are the picture");
  tiles.end();
  check(tiles.take(version, image) && image.width == 0, "no tiles after the frame");
}

}  // namespace

int main() {
  test_orbit();
  test_pan();
  test_options();
  test_places();
  test_dropped_files();
  test_folders();
  test_sides();
  test_unwrapped();
  try {
    const shd::context context = shd::context_create(nullptr);
    test_wraps(context);
    Stage stage(0);
    test_explanations(stage);
    test_pictures(stage);
    test_failures(stage);
    test_tiles(stage);
    test_worker(stage);
  } catch (const std::exception& error) {
    check(false, error.what());
  }
  if (failures == 0) std::puts("all good");
  return failures == 0 ? 0 : 1;
}
