// SPDX-License-Identifier: MIT
// present/<what>/<target>: the quad of frame/quad/trilinear, one thread. <what> is the frame alone into four float
// planes, or the frame and its display as RGBA8 by one of two views: shd_color_render() of a framebuffer of RGBA8
// pixels, the same of float planes (`_planes`), or shd_render() and then shd_color_apply_display() (`_after`).
// over_frame is the time divided by that of the frame alone. Items are pixels.
#include <shd/color.h>

#include "frame_scene.h"

namespace shd::bench {
namespace {

enum class Way { kAlone, kTiles, kAfter };

struct Row {
  const char* name;
  const char* view;
  Way way;
  shd_format color;
};
constexpr const char *kPlain = "Plain", *kAces = "ACES 1.0 SDR-video";
constexpr Row kRows[] = {{"frame", nullptr, Way::kAlone, SHD_FORMAT_RGBA32F},
                         {"plain_srgb", kPlain, Way::kTiles, SHD_FORMAT_RGBA8},
                         {"plain_srgb_planes", kPlain, Way::kTiles, SHD_FORMAT_RGBA32F},
                         {"plain_srgb_after", kPlain, Way::kAfter, SHD_FORMAT_RGBA32F},
                         {"aces_srgb", kAces, Way::kTiles, SHD_FORMAT_RGBA8},
                         {"aces_srgb_planes", kAces, Way::kTiles, SHD_FORMAT_RGBA32F},
                         {"aces_srgb_after", kAces, Way::kAfter, SHD_FORMAT_RGBA32F}};

std::string row_name(const char* what, const Target& target) {
  return std::string("present/") + what + "/" + target.name;
}

/// The frame, and the image that shows it.
class Screen {
 public:
  Screen(const Row& row, const Target& target)
      : row_(row), scene_(quad_surface(2.0f), target.simd, SHD_FILTER_TRILINEAR, row.color), pixels_(4 * kLookupCount) {
    shd_color_desc desc = shd_color_desc_default();
    desc.config_text = shd_color_default_config();
    check(shd_color_create(scene_.context(), &desc, &color_));
    image_.format = SHD_FORMAT_RGBA8;
    image_.width = image_.height = kFrameEdge;
    image_.pixels = pixels_.data();
  }
  ~Screen() { shd_color_release(color_); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  void run() {
    if (row_.way == Way::kTiles) {
      return check(shd_color_render(color_, &scene_.desc(), "sRGB", row_.view, &image_));
    }
    scene_.render();
    if (row_.way == Way::kAlone) return;
    check(shd_color_apply_display(color_, scene_.desc().framebuffer, "sRGB", row_.view, &image_));
  }

 private:
  const Row& row_;
  FrameScene scene_;
  std::vector<uint8_t> pixels_;
  shd_color* color_ = nullptr;
  shd_image image_ = shd_image_default();
};

void run_row(benchmark::State& state, const Row& row, const Target& target) {
  Screen screen(row, target);
  screen.run();
  const Stopwatch watch;
  for (auto _ : state) screen.run();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kLookupCount));
  record_rate(row_name(row.name, target), rate);
  const double alone = recorded_rate(row_name("frame", target));
  if (row.way != Way::kAlone && alone > 0.0) state.counters["over_frame"] = alone / rate;
}

}  // namespace

void register_present() {
  for (const Target& target : targets()) {
    for (const Row& row : kRows) {
      benchmark::RegisterBenchmark(row_name(row.name, target).c_str(), [&row, target](benchmark::State& state) {
        run_row(state, row, target);
      })->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace shd::bench
