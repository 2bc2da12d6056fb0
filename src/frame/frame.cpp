// SPDX-License-Identifier: MIT
#include "frame/frame.h"

#include <atomic>
#include <mutex>
#include <optional>

#include "core/executor.h"
#include "core/read_desc.h"
#include "film/expanded_color.h"
#include "film/sample_store.h"
#include "frame/passes.h"
#include "frame/scene.h"
#include "frame/stopwatch.h"
#include "frame/tile_renderer.h"
#include "frame/worker.h"

namespace shd::frame {
namespace {

/// Reports finished tiles to the host, never concurrently, and stores the result that ends the frame.
class Progress {
 public:
  Progress(const shd_progress& callback, uint64_t total) : callback_(callback), total_(total) {}

  /// Throws Failure once the host has given another result than SHD_OK.
  void step() {
    if (!callback_.report) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    if (result_ == SHD_OK) {
      const double fraction = static_cast<double>(done_) / static_cast<double>(total_);
      result_ = callback_.report(static_cast<float>(fraction), callback_.user_data);
    }
    if (result_ == SHD_OK) return;
    const bool is_known = core::enum_bits(result_) <= SHD_ERROR_INTERNAL;
    core::refuse(is_known ? result_ : SHD_ERROR_CALLBACK, "render.progress.report returned %s",
                 shd_result_name(result_));
  }

 private:
  const shd_progress& callback_;
  const uint64_t total_;
  std::mutex mutex_;
  uint64_t done_ = 0;
  shd_result result_ = SHD_OK;
};

}  // namespace

void render(const core::Context& context, const Frame& frame, shd_render_stats* stats) {
  shade::LightTable lights = shade::make_light_table(context.allocator, frame.lights, frame.light_count, frame.shadows);
  lights.environment = frame.environment;
  const film::Framebuffer& framebuffer = *frame.framebuffer;
  const uint32_t tiles = raster::tile_count(framebuffer.width) * raster::tile_count(framebuffer.height);
  const Background background = make_background(frame);
  Passes passes(context.allocator, frame);
  std::optional<film::ExpandedColor> expanded;
  if (passes.count() > 1) expanded.emplace(context, frame.framebuffer);
  film::SampleStore samples(context.allocator, framebuffer, passes.count() > 1 && framebuffer.samples > 1 ? tiles : 0);
  Progress progress(frame.progress, tiles * passes.count());
  for (uint64_t i = 0; i < passes.count(); ++i) {
    const Frame& pass = passes.next();
    Scene scene(context.allocator, pass);
    prepare(context, pass, &scene, stats);
    Stopwatch watch;
    Workers workers(context, pass);
    const bool presents = pass.present.tile && i + 1 == passes.count();
    const TileRenderer renderer = {context,
                                   pass,
                                   scene,
                                   lights,
                                   background,
                                   samples.is_empty() ? nullptr : &samples,
                                   presents ? &pass.present : nullptr};
    core::parallel_for(context, tiles, [&](uint32_t index, uint32_t worker) {
      renderer.render(index, &workers.get(worker));
      progress.step();
    });
    stats->tile_seconds += watch.lap();
    workers.count(stats);
  }
}

}  // namespace shd::frame
