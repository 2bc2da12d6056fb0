// SPDX-License-Identifier: MIT
// display/<view>/<who>: a 1024 x 1024 framebuffer of four float planes, opaque, to RGBA8 for a display, one thread.
// <who> is a SIMD target with a baked view, shd's exact path, or OpenColorIO itself from packed floats. bake_ms is the
// time of the first call, on one pixel; max_difference is the largest difference from the exact path in codes.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include <shd/color.h>

#include "bench.h"
#include "peers/peers.h"

namespace shd::bench {
namespace {

constexpr uint32_t kEdge = 1024;
constexpr size_t kPixels = size_t{kEdge} * kEdge;

struct View {
  const char* name;
  const char* display;
  const char* view;
};
constexpr View kViews[] = {{"plain_srgb", "sRGB", "Plain"},
                           {"aces_srgb", "sRGB", "ACES 1.0 SDR-video"},
                           {"aces_rec709", "Rec.709", "ACES 1.0 SDR-video"}};

/// Smooth colours of 2^-8 to 2^2.
const std::vector<float>& picture() {
  static const std::vector<float> rgba = [] {
    std::vector<float> values(4 * kPixels, 1.0f);
    for (size_t i = 0; i < kPixels; ++i) {
      const auto x = static_cast<float>(i % kEdge), y = static_cast<float>(i / kEdge);
      for (size_t c = 0; c < 3; ++c) {
        const auto k = static_cast<float>(c);
        values[4 * i + c] = std::exp2(-3.0f + 5.0f * std::sin(0.004f * (k + 1.0f) * x + 0.003f * (3.0f - k) * y));
      }
    }
    return values;
  }();
  return rgba;
}

/// A framebuffer with the picture, and the colour of one precision.
class DisplayScene {
 public:
  DisplayScene(shd_simd simd, shd_display_precision precision) : context_(make_context(simd)), out_(4 * kPixels) {
    shd_color_desc desc = shd_color_desc_default();
    desc.config_text = shd_color_default_config();
    desc.display_precision = precision;
    check(shd_color_create(context_, &desc, &color_));
    shd_framebuffer_desc size = shd_framebuffer_desc_default();
    size.width = size.height = kEdge;
    check(shd_framebuffer_create(context_, &size, &framebuffer_));
    for (size_t c = 0; c < 4; ++c) {
      shd_plane_view view = shd_plane_view_default();
      check(shd_framebuffer_view_plane(framebuffer_, static_cast<shd_plane>(SHD_PLANE_R + c), &view));
      for (size_t i = 0; i < kPixels; ++i) {
        const auto row = reinterpret_cast<uintptr_t>(view.f32) + i / kEdge * view.row_stride;
        reinterpret_cast<float*>(row)[i % kEdge] = picture()[4 * i + c];
      }
    }
  }
  ~DisplayScene() {
    shd_framebuffer_release(framebuffer_);
    shd_color_release(color_);
    shd_context_release(context_);
  }
  DisplayScene(const DisplayScene&) = delete;
  DisplayScene& operator=(const DisplayScene&) = delete;

  /// Wall time of the first call [ms].
  double first_call(const View& view) {
    const auto start = std::chrono::steady_clock::now();
    shd_image in = image(SHD_FORMAT_RGBA32F, 1, const_cast<float*>(picture().data()));
    shd_image out = image(SHD_FORMAT_RGBA8, 1, out_.data());
    check(shd_color_apply_display_image(color_, &in, nullptr, view.display, view.view, &out));
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }

  const std::vector<uint8_t>& run(const View& view) {
    const shd_image out = image(SHD_FORMAT_RGBA8, kEdge, out_.data());
    check(shd_color_apply_display(color_, framebuffer_, view.display, view.view, &out));
    return out_;
  }

 private:
  static shd_image image(shd_format format, uint32_t edge, void* pixels) {
    shd_image described = shd_image_default();
    described.format = format;
    described.width = described.height = edge;
    described.pixels = pixels;
    return described;
  }

  shd_context* context_;
  shd_color* color_ = nullptr;
  shd_framebuffer* framebuffer_ = nullptr;
  std::vector<uint8_t> out_;
};

std::string row_name(const View& view, const std::string& who) {
  return std::string("display/") + view.name + "/" + who;
}

void add_ratio(benchmark::State& state, const View& view, const char* who, double rate) {
  const double other = recorded_rate(row_name(view, who));
  if (other > 0.0) state.counters[std::string("ratio_") + who] = rate / other;
}

void run_shd(benchmark::State& state, const View& view, shd_simd simd, shd_display_precision precision,
             const std::string& who) {
  DisplayScene scene(simd, precision);
  if (precision == SHD_DISPLAY_PRECISION_BAKED) {
    DisplayScene exact(SHD_SIMD_BEST, SHD_DISPLAY_PRECISION_EXACT);
    exact.first_call(view);
    state.counters["bake_ms"] = scene.first_call(view);
    const std::vector<uint8_t>&want = exact.run(view), &got = scene.run(view);
    int largest = 0;
    for (size_t i = 0; i < got.size(); ++i) largest = std::max(largest, std::abs(got[i] - want[i]));
    state.counters["max_difference"] = largest;
  }
  scene.run(view);
  const Stopwatch watch;
  for (auto _ : state) scene.run(view);
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * kPixels);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kPixels));
  record_rate(row_name(view, who), rate);
  if (precision == SHD_DISPLAY_PRECISION_BAKED) add_ratio(state, view, "exact", rate);
  add_ratio(state, view, "opencolorio", rate);
}

#ifdef SHD_BENCH_OCIO
void run_opencolorio(benchmark::State& state, const View& view) {
  const std::unique_ptr<Peer> pass = make_opencolorio(picture(), kEdge, view.display, view.view);
  pass->run();
  const Stopwatch watch;
  for (auto _ : state) pass->run();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * kPixels);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kPixels));
  record_rate(row_name(view, "opencolorio"), rate);
}
#endif

}  // namespace

void register_display() {
  for (const View& view : kViews) {
#ifdef SHD_BENCH_OCIO
    benchmark::RegisterBenchmark(row_name(view, "opencolorio").c_str(),
                                 [&view](benchmark::State& state) { run_opencolorio(state, view); });
#endif
    benchmark::RegisterBenchmark(row_name(view, "exact").c_str(), [&view](benchmark::State& state) {
      run_shd(state, view, SHD_SIMD_BEST, SHD_DISPLAY_PRECISION_EXACT, "exact");
    });
    for (const Target& target : targets()) {
      benchmark::RegisterBenchmark(row_name(view, target.name).c_str(), [&view, target](benchmark::State& state) {
        run_shd(state, view, target.simd, SHD_DISPLAY_PRECISION_BAKED, target.name);
      });
    }
  }
}

}  // namespace shd::bench
