// SPDX-License-Identifier: MIT
#include <shd/polyhedron.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <limits>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "data/column.h"
#include "polygon/cage.h"
#include "polygon/cage_weights.h"

namespace {

using namespace shd;
using namespace shd::abi;
using polygon::CageFlaw;
using polygon::CagePoints;
using polygon::kBlock;

constexpr core::ObjectType kPolyhedronType = core::ObjectType::kPolyhedron;
/// Points farther from the centre than this times the longest side are moved to there.
constexpr double kFarthest = 0x1p8;
/// Points of convex polyhedra that are closer to a plane count as points of the surface.
constexpr double kOnSurface = 0x1p-40;

/// The body of a handle.
struct Polyhedron {
  shd_barycentric kind;
  polygon::Cage cage;
};

shd_result refuse_flaw(const CageFlaw& flaw, uint32_t kind) {
  const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
  const uint32_t a = flaw.a, b = flaw.b, c = flaw.c;
  switch (flaw.kind) {
    case CageFlaw::kNone: return SHD_OK;
    case CageFlaw::kIndex: return core::fail(bad, "polyhedron.indices[%u]: %u is not in 0..%u", a, b, c);
    case CageFlaw::kTwice: return core::fail(bad, "polyhedron.indices: triangle %u has vertex %u twice", a, b);
    case CageFlaw::kThin: return core::fail(bad, "polyhedron.indices: triangle %u has no area", a);
    case CageFlaw::kOpen:
      return core::fail(bad, "polyhedron.indices: the edge of vertices %u and %u is in %u triangles, not in 2", a, b,
                        c);
    case CageFlaw::kTurned:
      return core::fail(bad, "polyhedron.indices: both triangles of vertices %u and %u run in one direction", a, b);
    case CageFlaw::kUnused: return core::fail(bad, "polyhedron.position: vertex %u is in no triangle", a);
    case CageFlaw::kFlat: return core::fail(bad, "polyhedron.position: the triangles enclose no volume");
    case CageFlaw::kReflex:
      return core::fail(
          bad, "polyhedron.position: vertex %u is outside the plane of triangle %u, but kind %u is convex", a, b, kind);
    case CageFlaw::kCurved:
      return core::fail(bad, "polyhedron.position: vertex %u lies beside the plane of the face of triangle %u", b, a);
    case CageFlaw::kNoCorner:
      return core::fail(bad, "polyhedron.position: no corner at vertex %u, but kind %u needs one", a, kind);
  }
  return SHD_OK;
}

/// Checks a column of `count` finite floats.
shd_result check_floats(const char* name, const shd_f32_in& column, size_t count) {
  SHD_TRY(check_column(name, column, count));
  SHD_TRY(check_not_null(name, column.data));
  for (size_t i = 0; i < count; ++i) {
    const float value = data::load(column, i);
    if (!std::isfinite(value)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: element %zu, %g, is not finite", name, i, double{value});
    }
  }
  return SHD_OK;
}

shd_result check_polyhedron_desc(const shd_polyhedron_desc& desc) {
  SHD_TRY(check_enum("polyhedron.kind", desc.kind, 0, SHD_BARYCENTRIC_MEAN_VALUE));
  SHD_TRY(check_count("polyhedron.vertex_count", desc.vertex_count, 4, SHD_MAX_POLYHEDRON_VERTICES));
  SHD_TRY(check_count("polyhedron.index_count", desc.index_count, 12, 3 * SHD_MAX_POLYHEDRON_TRIANGLES));
  if (desc.index_count % 3 != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "polyhedron.index_count: %zu is not a multiple of 3",
                      desc.index_count);
  }
  constexpr const char* kNames[3] = {"polyhedron.position[0]", "polyhedron.position[1]", "polyhedron.position[2]"};
  for (size_t c = 0; c < 3; ++c) SHD_TRY(check_floats(kNames[c], desc.position[c], desc.vertex_count));
  SHD_TRY(check_column("polyhedron.indices", desc.indices, desc.index_count));
  return check_not_null("polyhedron.indices", desc.indices.data);
}

shd_result fill(const core::Context& context, const shd_polyhedron_desc& desc, Polyhedron* out) {
  out->kind = desc.kind;
  const uint32_t kind = enum_bits(desc.kind);
  SHD_TRY(refuse_flaw(polygon::make_cage(context.allocator, desc, &out->cage), kind));
  if (kind != SHD_BARYCENTRIC_WACHSPRESS) return SHD_OK;
  return refuse_flaw(polygon::make_faces(context.allocator, &out->cage), kind);
}

struct PointCounts {
  std::atomic<size_t> outside{0}, nonfinite{0};
};

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
        scratch(context.allocator, polygon::scratch_size(polyhedron.cage, polyhedron.kind)),
        weights(context.allocator, polyhedron.cage.vertex_count * kBlock),
        points(),
        pending() {}
};

/// Number of a point whose weights are not wanted.
constexpr size_t kNoPoint = SIZE_MAX;

/// Puts a point into a block. Returns whether it is finite.
bool put_point(const polygon::Cage& cage, const shd_polyhedron_points& points, size_t index, size_t lane,
               CagePoints* out) {
  double p[3], square = 0.0;
  bool is_finite = true;
  for (size_t c = 0; c < 3; ++c) {
    const float value = data::load(points.position[c], index);
    is_finite = is_finite && std::isfinite(value);
    p[c] = ((std::isfinite(value) ? double{value} : 0.0) - cage.center[c]) * cage.scale;
    square += p[c] * p[c];
  }
  const double limit = kFarthest * cage.longest, distance = std::sqrt(square);
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
void move_to_surface(const polygon::Cage& cage, size_t lane, CagePoints* points) {
  const double from[3] = {points->x[lane], points->y[lane], points->z[lane]};
  const polygon::SurfacePoint nearest = nearest_on_cage(cage, from);
  double to[3] = {};
  for (size_t i = 0; i < 3; ++i) {
    const double* vertex = cage.doubles.position.data() + 3 * size_t{cage.triangle[nearest.triangle].vertex[i]};
    for (size_t c = 0; c < 3; ++c) to[c] += nearest.weight[i] * vertex[c];
  }
  points->x[lane] = to[0], points->y[lane] = to[1], points->z[lane] = to[2];
}

/// Sets Wachspress coordinates of the block of a task.
void find_wachspress(PointTask* task) {
  const polygon::Cage& cage = task->body.cage;
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
void put_on_surface(const polygon::SurfacePoint& on, size_t lane, PointTask* task) {
  const polygon::Cage& cage = task->body.cage;
  task->pending.inverse[lane] = 1.0;
  for (size_t v = 0; v < cage.vertex_count; ++v) task->weights[v * kBlock + lane] = 0.0;
  for (size_t i = 0; i < 3; ++i) task->weights[cage.triangle[on.triangle].vertex[i] * kBlock + lane] = on.weight[i];
}

/// Sets mean value coordinates of the points that wait, in doubles. Where rounding leaves no finite weights, they are
/// those of the nearest point of the surface.
void find_pending(PointTask* task) {
  const polygon::Cage& cage = task->body.cage;
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
void run_points(const core::Context& context, const Polyhedron& body, const shd_polyhedron_points& points,
                PointCounts* counts, const Emit& emit) {
  constexpr size_t kMostTasks = size_t{1} << 20, kTaskPairs = size_t{1} << 22;  // pairs of a point and a triangle
  const size_t least = std::max(kTaskPairs / body.cage.triangle_count, points.count / kMostTasks + 1);
  const size_t size = (least + kBlock - 1) / kBlock * kBlock;
  const auto tasks = static_cast<uint32_t>(points.count / size + (points.count % size != 0));
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
    counts->outside.fetch_add(task.outside, std::memory_order_relaxed);
    counts->nonfinite.fetch_add(task.nonfinite, std::memory_order_relaxed);
  });
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

/// Checks the columns of points and results.
shd_result check_points(const shd_polyhedron_points& points, const OutColumn* out, size_t out_count) {
  InColumn in[3];
  set_vector("points.position", points.position, Need::kRequired, in);
  SHD_TRY(check_columns(in, 3, points.count));
  SHD_TRY(check_columns(out, out_count, points.count));
  return check_overlap(in, 3, out, out_count, points.count);
}

shd_result check_weights(const core::Context& context, const shd_polyhedron_points& points,
                         const shd_polyhedron_weights& weights, uint32_t vertex_count) {
  SHD_TRY(check_count("weights.weight_count", weights.weight_count, vertex_count, vertex_count));
  SHD_TRY(check_not_null("weights.weight", weights.weight));
  core::Array<OutColumn> columns(context.allocator, vertex_count);
  bool wanted = points.count == 0;
  for (uint32_t i = 0; i < vertex_count; ++i) {
    columns[i] = out_column("weights.weight", weights.weight[i], Need::kOptional, static_cast<int>(i));
    wanted = wanted || weights.weight[i].data;
  }
  if (!wanted) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "weights.weight: NULL for all");
  return check_points(points, columns.data(), vertex_count);
}

/// Checks the columns of values, and copies the values of the vertices: [value_count][vertex_count].
shd_result read_values(const core::Context& context, const shd_polyhedron_points& points,
                       const shd_polyhedron_values& values, uint32_t vertex_count, core::Array<double>* out) {
  SHD_TRY(check_count("values.value_count", values.value_count, 1, SHD_MAX_POLYHEDRON_VALUES));
  SHD_TRY(check_not_null("values.vertex_value", values.vertex_value));
  SHD_TRY(check_not_null("values.value", values.value));
  OutColumn columns[SHD_MAX_POLYHEDRON_VALUES];
  *out = core::Array<double>(context.allocator, values.value_count * vertex_count);
  for (size_t k = 0; k < values.value_count; ++k) {
    char name[48];
    std::snprintf(name, sizeof name, "values.vertex_value[%zu]", k);
    SHD_TRY(check_floats(name, values.vertex_value[k], vertex_count));
    for (size_t v = 0; v < vertex_count; ++v) {
      (*out)[k * vertex_count + v] = double{data::load(values.vertex_value[k], v)};
    }
    columns[k] = out_column("values.value", values.value[k], Need::kRequired, static_cast<int>(k));
  }
  return check_points(points, columns, values.value_count);
}

}  // namespace

extern "C" {

shd_result shd_polyhedron_create(shd_context* context, const shd_polyhedron_desc* desc,
                                 shd_polyhedron** out_polyhedron) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_polyhedron", out_polyhedron));
    *out_polyhedron = nullptr;
    SHD_TRY(check_context(context));
    shd_polyhedron_desc read = shd_polyhedron_desc_default();
    SHD_TRY(read_desc("polyhedron", desc, false, &read));
    SHD_TRY(check_polyhedron_desc(read));
    core::Context& owner = context_of(context);
    auto* body = core::create<Polyhedron>(owner.allocator);
    shd_result result;
    try {
      result = fill(owner, read, body);
    } catch (...) {
      core::destroy(owner.allocator, body);
      throw;
    }
    if (result != SHD_OK) {
      core::destroy(owner.allocator, body);
      return result;
    }
    make_handle(owner, kPolyhedronType, body, out_polyhedron);
    return SHD_OK;
  });
}

void shd_polyhedron_retain(shd_polyhedron* polyhedron) {
  retain_handle(polyhedron, kPolyhedronType);
}

void shd_polyhedron_release(shd_polyhedron* polyhedron) {
  release_handle(polyhedron, kPolyhedronType);
}

shd_result shd_polyhedron_evaluate(const shd_polyhedron* polyhedron, const shd_polyhedron_points* points,
                                   shd_polyhedron_weights* out) {
  return guard([&]() -> shd_result {
    const Polyhedron* body;
    SHD_TRY(read_handle("polyhedron", polyhedron, kPolyhedronType, &body));
    const core::Context& owner = *object_of(polyhedron)->context;
    shd_polyhedron_points in = shd_polyhedron_points_default();
    SHD_TRY(read_desc("points", points, false, &in));
    shd_polyhedron_weights weights = shd_polyhedron_weights_default();
    SHD_TRY(read_desc("weights", out, false, &weights));
    SHD_TRY(check_weights(owner, in, weights, body->cage.vertex_count));
    PointCounts counts;
    run_points(owner, *body, in, &counts,
               [&](const size_t* index, const CagePoints& block, const double* block_weights) {
                 for (size_t v = 0; v < body->cage.vertex_count; ++v) {
                   if (weights.weight[v].data) store_block(index, block, block_weights + v * kBlock, weights.weight[v]);
                 }
               });
    weights.outside_count = counts.outside.load(std::memory_order_relaxed);
    weights.nonfinite_count = counts.nonfinite.load(std::memory_order_relaxed);
    write_desc(weights, out);
    return SHD_OK;
  });
}

shd_result shd_polyhedron_interpolate(const shd_polyhedron* polyhedron, const shd_polyhedron_points* points,
                                      shd_polyhedron_values* out) {
  return guard([&]() -> shd_result {
    const Polyhedron* body;
    SHD_TRY(read_handle("polyhedron", polyhedron, kPolyhedronType, &body));
    const core::Context& owner = *object_of(polyhedron)->context;
    shd_polyhedron_points in = shd_polyhedron_points_default();
    SHD_TRY(read_desc("points", points, false, &in));
    shd_polyhedron_values values = shd_polyhedron_values_default();
    SHD_TRY(read_desc("values", out, false, &values));
    core::Array<double> vertex_values;
    SHD_TRY(read_values(owner, in, values, body->cage.vertex_count, &vertex_values));
    PointCounts counts;
    run_points(owner, *body, in, &counts,
               [&](const size_t* index, const CagePoints& block, const double* block_weights) {
                 alignas(64) double sums[SHD_MAX_POLYHEDRON_VALUES * kBlock];
                 blend_values(body->cage, owner.simd, block_weights, vertex_values.data(), values.value_count, sums);
                 for (size_t k = 0; k < values.value_count; ++k)
                   store_block(index, block, sums + k * kBlock, values.value[k]);
               });
    values.outside_count = counts.outside.load(std::memory_order_relaxed);
    values.nonfinite_count = counts.nonfinite.load(std::memory_order_relaxed);
    write_desc(values, out);
    return SHD_OK;
  });
}

}  // extern "C"
