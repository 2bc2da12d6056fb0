// SPDX-License-Identifier: MIT
#include "polygon/cage_points.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/executor.h"
#include "data/column.h"
#include "polygon/cage_weights.h"

namespace shd::polygon {
namespace {

/// Points farther from the centre than this times the longest side are moved to there.
constexpr double kFarthestInSides = 0x1p8;
/// Points of convex polyhedra that are closer to a plane count as points of the surface.
constexpr double kOnSurface = 0x1p-40;

/// Working memory of a task.
struct PointTask {
  const core::SimdTarget& simd;
  const Polyhedron& body;
  core::Array<double> scratch, weights;  // weights: [vertex][kBlock]
  CagePoints points, pending;            // the next points; points that floats are not precise enough for
  size_t index[kBlock], pending_index[kBlock];
  size_t outside = 0, nonfinite = 0;

  PointTask(const core::Context& context, const Polyhedron& polyhedron)
      : simd(context.simd),
        body(polyhedron),
        scratch(context.allocator, scratch_size(polyhedron.cage, polyhedron.kind)),
        weights(context.allocator, polyhedron.cage.vertex_count * kBlock),
        points(),
        pending() {}
};

/// Number of a point whose weights are not wanted.
constexpr size_t kNoPoint = SIZE_MAX;

/// Puts a point into a block. Returns whether it is finite.
bool put_point(const Cage& cage, const shd_polyhedron_points& points, size_t index, size_t lane, CagePoints* out) {
  double p[3], square = 0.0;
  bool is_finite = true;
  for (size_t c = 0; c < 3; ++c) {
    const float value = data::load(points.position[c], index);
    is_finite = is_finite && std::isfinite(value);
    p[c] = ((std::isfinite(value) ? double{value} : 0.0) - cage.center[c]) * cage.scale;
    square += p[c] * p[c];
  }
  const double limit = kFarthestInSides * cage.longest, distance = std::sqrt(square);
  const double scale = distance > limit ? limit / distance : 1.0;
  out->x[lane] = scale * p[0];
  out->y[lane] = scale * p[1];
  out->z[lane] = scale * p[2];
  return is_finite;
}

/// Fills the block of a task with points from `first` on. Lanes after the last point are copies of it.
void put_points(const shd_polyhedron_points& points, size_t first, size_t end, PointTask* task) {
  task->points.count = std::min(kBlock, end - first);
  for (size_t lane = 0; lane < kBlock; ++lane) {
    const bool is_wanted = lane < task->points.count;
    const size_t index = is_wanted ? first + lane : end - 1;
    const bool is_finite = put_point(task->body.cage, points, index, lane, &task->points);
    task->nonfinite += is_wanted && !is_finite;
    task->index[lane] = is_wanted ? index : kNoPoint;
  }
}

/// Moves a point outside to the nearest point of the surface.
void move_to_surface(const Cage& cage, size_t lane, CagePoints* points) {
  const double from[3] = {points->x[lane], points->y[lane], points->z[lane]};
  const SurfacePoint nearest = nearest_on_cage(cage, from);
  double to[3] = {};
  for (size_t i = 0; i < 3; ++i) {
    const double* vertex = cage.doubles.position.data() + 3 * size_t{cage.triangle[nearest.triangle].vertex[i]};
    for (size_t c = 0; c < 3; ++c) to[c] += nearest.weight[i] * vertex[c];
  }
  points->x[lane] = to[0], points->y[lane] = to[1], points->z[lane] = to[2];
}

/// Sets Wachspress coordinates of the block of a task.
void find_wachspress(PointTask* task) {
  const Cage& cage = task->body.cage;
  wachspress_weights(cage, task->simd, task->scratch.data(), &task->points, task->weights.data());
  bool has_moved = false;
  for (size_t lane = 0; lane < task->points.count; ++lane) {
    if (!(task->points.depth[lane] < -kOnSurface)) continue;
    ++task->outside;
    move_to_surface(cage, lane, &task->points);
    has_moved = true;
  }
  if (has_moved) wachspress_weights(cage, task->simd, task->scratch.data(), &task->points, task->weights.data());
}

/// Gives a lane the weights of a point of the surface.
void put_on_surface(const SurfacePoint& on, size_t lane, PointTask* task) {
  const Cage& cage = task->body.cage;
  task->pending.inverse[lane] = 1.0;
  for (size_t v = 0; v < cage.vertex_count; ++v) task->weights[v * kBlock + lane] = 0.0;
  for (size_t i = 0; i < 3; ++i) task->weights[cage.triangle[on.triangle].vertex[i] * kBlock + lane] = on.weight[i];
}

/// Sets mean value coordinates of the points that wait, in doubles. Where rounding leaves no finite weights, they are
/// those of the nearest point of the surface.
void find_pending(PointTask* task) {
  const Cage& cage = task->body.cage;
  CagePoints& points = task->pending;
  mean_value_weights(cage, task->simd, task->scratch.data(), &points, task->weights.data());
  for (size_t lane = 0; lane < points.count; ++lane) {
    const double point[3] = {points.x[lane], points.y[lane], points.z[lane]};
    if (points.triangle[lane] >= 0.0) {
      const auto triangle = static_cast<uint32_t>(points.triangle[lane]);
      put_on_surface(nearest_on_triangle(cage, triangle, point), lane, task);
    } else if (std::isfinite(points.depth[lane]) && std::isfinite(points.inverse[lane])) {
      task->outside += points.depth[lane] < 0.0;
    } else {
      put_on_surface(nearest_on_cage(cage, point), lane, task);
    }
  }
}

/// Computes the points that wait, and hands them out.
template <class Emit>
void flush_pending(PointTask* task, const Emit& emit) {
  if (task->pending.count == 0) return;
  find_pending(task);
  emit(task->pending_index, task->pending, task->weights.data());
  task->pending.count = 0;
}

/// Computes mean value coordinates of the block of a task, in floats; other points wait.
template <class Emit>
void run_mean_value(PointTask* task, const Emit& emit) {
  const CagePoints& points = task->points;
  fast_mean_value_weights(task->body.cage, task->simd, task->scratch.data(), &task->points, task->weights.data());
  size_t doubtful[kBlock];
  for (size_t lane = 0; lane < points.count; ++lane) {
    doubtful[lane] = points.depth[lane] < 0.0 ? task->index[lane] : kNoPoint;
    if (doubtful[lane] != kNoPoint) task->index[lane] = kNoPoint;
  }
  emit(task->index, points, task->weights.data());
  for (size_t lane = 0; lane < points.count; ++lane) {
    if (doubtful[lane] == kNoPoint) continue;
    CagePoints& to = task->pending;
    to.x[to.count] = points.x[lane], to.y[to.count] = points.y[lane], to.z[to.count] = points.z[lane];
    task->pending_index[to.count++] = doubtful[lane];
    if (to.count == kBlock) flush_pending(task, emit);
  }
}

/// Calls emit(index, points, weights) until all points had their turn, in blocks, on the executor of a context: point
/// index[lane] has the weights of a lane, unless it is kNoPoint.
template <class Emit>
PointCounts run_points(const core::Context& context, const Polyhedron& body, const shd_polyhedron_points& points,
                       const Emit& emit) {
  constexpr size_t kMostTasks = size_t{1} << 20, kTaskPairs = size_t{1} << 22;  // pairs of a point and a triangle
  const size_t least = std::max(kTaskPairs / body.cage.triangle_count, points.count / kMostTasks + 1);
  const size_t size = (least + kBlock - 1) / kBlock * kBlock;
  const auto tasks = static_cast<uint32_t>(points.count / size + (points.count % size != 0));
  std::atomic<size_t> outside{0}, nonfinite{0};
  core::parallel_for(context, tasks, [&](uint32_t number, uint32_t) {
    PointTask task(context, body);
    const size_t end = std::min(points.count, (number + size_t{1}) * size);
    for (size_t first = number * size; first < end; first += kBlock) {
      put_points(points, first, end, &task);
      if (body.kind == SHD_BARYCENTRIC_WACHSPRESS) {
        find_wachspress(&task);
        emit(task.index, task.points, task.weights.data());
      } else {
        run_mean_value(&task, emit);
      }
    }
    flush_pending(&task, emit);
    outside.fetch_add(task.outside, std::memory_order_relaxed);
    nonfinite.fetch_add(task.nonfinite, std::memory_order_relaxed);
  });
  return {outside.load(std::memory_order_relaxed), nonfinite.load(std::memory_order_relaxed)};
}

float to_float(double value) {
  constexpr double kLargest = double{std::numeric_limits<float>::max()};
  return static_cast<float>(std::min(std::max(value, -kLargest), kLargest));
}

/// Stores the results of the lanes of a block that are wanted.
void store_block(const size_t* index, const CagePoints& points, const double* from, const shd_f32_out& to) {
  for (size_t lane = 0; lane < points.count; ++lane) {
    if (index[lane] != kNoPoint) data::store(to, index[lane], to_float(from[lane] * points.inverse[lane]));
  }
}

}  // namespace

PointCounts evaluate_points(const core::Context& context, const Polyhedron& polyhedron,
                            const shd_polyhedron_points& points, const shd_f32_out* weight) {
  const auto emit = [&](const size_t* index, const CagePoints& block, const double* weights) {
    for (size_t v = 0; v < polyhedron.cage.vertex_count; ++v) {
      if (weight[v].data) store_block(index, block, weights + v * kBlock, weight[v]);
    }
  };
  return run_points(context, polyhedron, points, emit);
}

PointCounts interpolate_points(const core::Context& context, const Polyhedron& polyhedron,
                               const shd_polyhedron_points& points, const double* vertex_values, size_t value_count,
                               const shd_f32_out* value) {
  const auto emit = [&](const size_t* index, const CagePoints& block, const double* weights) {
    alignas(64) double sums[SHD_MAX_POLYHEDRON_VALUES * kBlock];
    blend_values(polyhedron.cage, context.simd, weights, vertex_values, value_count, sums);
    for (size_t k = 0; k < value_count; ++k) store_block(index, block, sums + k * kBlock, value[k]);
  };
  return run_points(context, polyhedron, points, emit);
}

}  // namespace shd::polygon
