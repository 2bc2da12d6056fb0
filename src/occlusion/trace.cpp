// SPDX-License-Identifier: MIT
#include "occlusion/trace.h"

#include <algorithm>
#include <exception>

#include "core/executor.h"
#include "core/status.h"
#include "occlusion/ray_batch.h"

namespace shd::occlusion {
namespace {

/// Traces the rays of consecutive points.
class Tracing {
 public:
  Tracing(const core::Context& context, const Options& options, const Points& points)
      : context_(context), options_(options), points_(points), set_(make_ray_set(context.allocator, options.rays)) {}

  /// Points whose rays share a batch.
  size_t points_per_batch() const { return std::max<size_t>(kRayBatch / set_.count, 1); }

  void run(size_t begin, size_t end, RayBatch* batch) const {
    if (batch->block.size() == 0) allocate(context_.allocator, options_.radius, batch);
    size_t first = begin;
    batch->count = 0;
    for (size_t i = begin; i < end; ++i) {
      RayOrigin origin;
      points_.value[i] = 1.0f;
      if (!make_origin(points_, i, options_, &origin)) continue;
      if (set_.count > kRayBatch) {
        points_.value[i] = value_of(open_rays(origin, batch));
        continue;
      }
      points_.value[i] = kPending;
      append_rays(context_.simd, set_, origin, 0, set_.count, batch);
    }
    if (batch->count == 0) return;
    call(batch);
    for (size_t row = 0; first < end; ++first) {
      if (points_.value[first] != kPending) continue;
      points_.value[first] = value_of(count_open(*batch, row, set_.count));
      row += set_.count;
    }
  }

 private:
  static constexpr float kPending = -1.0f;

  float value_of(size_t open) const {
    return static_cast<float>(static_cast<double>(open) / static_cast<double>(set_.count));
  }
  static size_t count_open(const RayBatch& batch, size_t row, size_t count) {
    size_t open = 0;
    for (size_t i = row; i < row + count; ++i) open += batch.blocked[i] == 0;
    return open;
  }

  /// Open rays of a point whose rays take several batches.
  size_t open_rays(const RayOrigin& origin, RayBatch* batch) const {
    size_t open = 0;
    for (size_t begin = 0; begin < set_.count; begin += kRayBatch) {
      const size_t end = std::min<size_t>(set_.count, begin + kRayBatch);
      batch->count = 0;
      append_rays(context_.simd, set_, origin, begin, end, batch);
      call(batch);
      open += count_open(*batch, 0, end - begin);
    }
    batch->count = 0;
    return open;
  }

  void call(RayBatch* batch) const {
    std::fill_n(batch->blocked.data(), batch->count, 0u);
    const shd_rays rays = {sizeof rays, batch->count, batch->ox, batch->oy,    batch->oz,
                           batch->dx,   batch->dy,    batch->dz, batch->length};
    try {
      options_.tracer.trace(&rays, batch->blocked.data(), options_.tracer.user_data);
    } catch (const std::exception& error) {
      core::refuse(SHD_ERROR_CALLBACK, "occlusion.tracer threw: %s", error.what());
    } catch (...) {
      core::refuse(SHD_ERROR_CALLBACK, "occlusion.tracer threw");
    }
  }

  const core::Context& context_;
  const Options& options_;
  const Points& points_;
  const RaySet set_;
};

constexpr size_t kMaxTasks = size_t{1} << 20;

}  // namespace

void trace(const core::Context& context, const Options& options, const Points& points) {
  if (points.count == 0) return;
  const Tracing tracing(context, options, points);
  const size_t batch = tracing.points_per_batch();
  const size_t size = std::max(batch, (points.count / kMaxTasks / batch + 1) * batch);
  core::Objects<RayBatch> batches(context.allocator, context.executor.worker_count);
  const auto tasks = static_cast<uint32_t>((points.count + size - 1) / size);
  core::parallel_for(context, tasks, [&](uint32_t task, uint32_t worker) {
    const size_t end = std::min(points.count, (size_t{task} + 1) * size);
    for (size_t begin = task * size; begin < end; begin += batch) {
      tracing.run(begin, std::min(end, begin + batch), &batches[worker]);
    }
  });
}

}  // namespace shd::occlusion
