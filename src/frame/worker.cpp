// SPDX-License-Identifier: MIT
#include "frame/worker.h"

#include <algorithm>

namespace shd::frame {

Workers::Workers(const core::Context& context, const Frame& frame)
    : context_(context),
      framebuffer_(*frame.framebuffer),
      light_count_(frame.light_count),
      has_volumes_(frame.volume_count > 0),
      is_bake_(frame.bake != nullptr),
      workers_(context.allocator, context.executor.worker_count) {
  for (Worker*& worker : workers_) worker = nullptr;
  for (size_t i = 0; i < frame.draw_count; ++i) {
    if (frame.draws[i].material) varying_count_ = std::max(varying_count_, frame.draws[i].material->varying_count);
  }
}

Workers::~Workers() {
  for (Worker* worker : workers_) core::destroy(context_.allocator, worker);
}

Worker& Workers::get(uint32_t index) {
  if (!workers_[index]) {
    const core::Allocator& allocator = context_.allocator;
    const uint32_t samples = framebuffer_.samples, targets = film::targets_of(framebuffer_);
    Worker* worker = core::create<Worker>(allocator);
    workers_[index] = worker;
    worker->index = index;
    raster::allocate(allocator, samples, &worker->tile);
    raster::allocate(allocator, samples, &worker->order);
    worker->covered.attach(allocator);
    worker->slots.attach(allocator);
    worker->unordered.nodes.attach(allocator);
    allocate(allocator, samples, targets, &worker->split);
    worker->color.allocate(allocator, framebuffer_);
    if (has_volumes_) worker->march = core::Array<volume::March>(allocator, 1);
    if (is_bake_) worker->nearest = core::Array<raster::NearestTriangles>(allocator, 1);
    shade::allocate(allocator, {varying_count_, targets, light_count_}, &worker->workspace);
  }
  return *workers_[index];
}

void Workers::count(shd_render_stats* stats) const {
  for (size_t i = 0; i < workers_.size(); ++i) {
    if (!workers_[i]) continue;
    stats->fragment_count += workers_[i]->fragments;
    stats->nonfinite_fragment_count += workers_[i]->nonfinite_fragments;
    stats->hidden_sample_count += workers_[i]->hidden_samples;
  }
}

}  // namespace shd::frame
