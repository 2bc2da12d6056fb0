// SPDX-License-Identifier: MIT
// load/<object>/<content>/<where>/edge:2048: loading a PNG of 2048 x 2048 pixels in this process or by the worker,
// which runs already. Time is wall time; median_ms is its median. Loads by the worker alternate with loads in this
// process; ratio is the median time of the former by that of the latter.
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <shd/io.h>

#include "bench.h"

namespace shd::bench {
namespace {

constexpr int kEdge = 2048;

struct Content {
  const char* name;
  int channels;
  bool noisy;
};
constexpr Content kContents[] = {{"smooth_rgb", 3, false}, {"noisy_rgba", 4, true}};

/// A gradient, which is decoded fast, or noise.
class PngFile {
 public:
  explicit PngFile(const Content& content)
      : path_("/tmp/shd-bench-" + std::to_string(::getpid()) + "-" + content.name + ".png") {
    const OIIO::ImageSpec spec(kEdge, kEdge, content.channels, OIIO::TypeDesc::UINT8);
    std::vector<uint8_t> pixels(size_t{kEdge} * kEdge * static_cast<size_t>(content.channels));
    uint32_t random = 1;
    for (size_t i = 0; i < pixels.size(); ++i) {
      const size_t c = i % static_cast<size_t>(content.channels), at = i / static_cast<size_t>(content.channels);
      const size_t x = at % kEdge, y = at / kEdge;
      random = random * 1664525u + 1013904223u;
      pixels[i] = static_cast<uint8_t>(content.noisy ? random >> 24 : (c == 0 ? x : c == 1 ? y : (x + y) / 2) / 8);
    }
    const auto out = OIIO::ImageOutput::create(path_);
    written_ = out && out->open(path_, spec) && out->write_image(OIIO::TypeDesc::UINT8, pixels.data()) && out->close();
  }
  ~PngFile() { std::remove(path_.c_str()); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;
  bool written() const { return written_; }
  const char* path() const { return path_.c_str(); }

 private:
  std::string path_;
  bool written_;
};

/// Wall time of one load [s].
double load(shd_context* context, const char* path, bool texture, shd_load_flags flags) {
  shd_load_desc desc = shd_load_desc_default();
  desc.flags = flags;
  shd_bitmap* bitmap = nullptr;
  shd_texture* made = nullptr;
  const auto start = std::chrono::steady_clock::now();
  check(texture ? shd_texture_load(context, path, &desc, &made) : shd_bitmap_load(context, path, &desc, &bitmap));
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  shd_texture_release(made);
  shd_bitmap_release(bitmap);
  return time.count();
}

double median(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void run(benchmark::State& state, const Content& content, bool texture, bool isolated) {
  const PngFile file(content);
  if (!file.written()) {
    state.SkipWithError("OpenImageIO cannot write PNG files");
    return;
  }
  shd_context* context = make_context(SHD_SIMD_BEST);
  for (const shd_load_flags flags : {SHD_LOAD_IN_PROCESS, SHD_LOAD_NONE}) load(context, file.path(), texture, flags);
  std::vector<double> here, there;
  for (auto _ : state) {
    here.push_back(load(context, file.path(), texture, SHD_LOAD_IN_PROCESS));
    if (isolated) there.push_back(load(context, file.path(), texture, SHD_LOAD_NONE));
    state.SetIterationTime(isolated ? there.back() : here.back());
  }
  state.SetItemsProcessed(state.iterations() * kEdge * kEdge);
  if (isolated) state.counters["ratio"] = median(there) / median(here);
  state.counters["median_ms"] = 1e3 * median(isolated ? there : here);
  shd_context_release(context);
}

}  // namespace

void register_load() {
  for (const bool texture : {false, true}) {
    for (const Content& content : kContents) {
      for (const bool isolated : {false, true}) {
        const std::string name = std::string("load/") + (texture ? "texture/" : "bitmap/") + content.name +
                                 (isolated ? "/isolated" : "/in_process") + "/edge:" + std::to_string(kEdge);
        benchmark::RegisterBenchmark(name.c_str(),
                                     [=](benchmark::State& state) { run(state, content, texture, isolated); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime();
      }
    }
  }
}

}  // namespace shd::bench
