// SPDX-License-Identifier: MIT
#include "frame/frame.h"

#include <atomic>
#include <mutex>
#include <optional>

#include "core/executor.h"
#include "film/expanded_color.h"
#include "film/sample_store.h"
#include "frame/passes.h"
#include "frame/scene.h"
#include "frame/stopwatch.h"
#include "frame/tile_renderer.h"
#include "frame/worker.h"

namespace shd::frame {
namespace {

/// Reports finished tiles to the host, never concurrently, and stores a cancellation request.
class Progress {
 public:
  Progress(const shd_progress& callback, uint64_t total) : callback_(callback), total_(total) {}

  /// Throws Failure once the host has cancelled.
  void step() {
    if (!callback_.report) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    if (!cancelled_) {
      cancelled_ = callback_.report(callback_.user_data,
                                    static_cast<float>(static_cast<double>(done_) / static_cast<double>(total_))) != 0;
    }
    if (cancelled_) core::refuse(SHD_ERROR_CANCELLED, "render.progress: cancelled by the host");
  }

 private:
  const shd_progress& callback_;
  const uint64_t total_;
  std::mutex mutex_;
  uint64_t done_ = 0;
  bool cancelled_ = false;
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
