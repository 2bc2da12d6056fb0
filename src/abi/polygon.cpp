// SPDX-License-Identifier: MIT
#include <shd/polygon.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "data/column.h"
#include "polygon/coordinates.h"
#include "polygon/harmonic.h"
#include "polygon/sparse_solver.h"

namespace {

using namespace shd;
using namespace shd::abi;
using polygon::Polygon;
using polygon::PolygonFlaw;

constexpr uint64_t kMaxValues = 1u << 24;  // nodes of the harmonic solution times vertices
constexpr size_t kTaskPoints = 16384;
constexpr size_t kMaxTasks = size_t{1} << 20;

shd_result refuse_flaw(const PolygonFlaw& flaw, uint32_t kind) {
  const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
  switch (flaw.kind) {
    case PolygonFlaw::kNone: return SHD_OK;
    case PolygonFlaw::kPointEdge:
      return core::fail(bad, "polygon.vertex: %u and %u are the same point", flaw.a, flaw.b);
    case PolygonFlaw::kFold: return core::fail(bad, "polygon.vertex: the polygon turns back on itself at %u", flaw.a);
    case PolygonFlaw::kCrossing:
      return core::fail(bad, "polygon.vertex: the edges from %u and from %u meet", flaw.a, flaw.b);
    case PolygonFlaw::kStraight:
      return core::fail(bad, "polygon.vertex: no turn at %u, but kind %u needs a convex polygon", flaw.a, kind);
    case PolygonFlaw::kReflex:
      return core::fail(bad, "polygon.vertex: reflex at %u, but kind %u needs a convex polygon", flaw.a, kind);
  }
  return SHD_OK;
}

shd_result read_vertices(const shd_polygon_desc& desc, Polygon* out) {
  constexpr const char* kNames[2] = {"polygon.vertex[0]", "polygon.vertex[1]"};
  out->count = desc.vertex_count;
  for (int c = 0; c < 2; ++c) {
    SHD_TRY(check_column(kNames[c], desc.vertex[c], desc.vertex_count));
    SHD_TRY(check_not_null(kNames[c], desc.vertex[c].data));
    for (uint32_t i = 0; i < desc.vertex_count; ++i) {
      const float value = data::load(desc.vertex[c], i);
      SHD_TRY(check_finite(kNames[c], &value, 1));
      (c == 0 ? out->x : out->y)[i] = double{value};
    }
  }
  return SHD_OK;
}

shd_result read_polygon(const shd_polygon_desc* in, shd_polygon_desc* desc, Polygon* out) {
  SHD_TRY(read_desc("polygon", in, false, desc));
  SHD_TRY(check_enum("polygon.kind", desc->kind, 0, SHD_BARYCENTRIC_HARMONIC));
  SHD_TRY(check_count("polygon.vertex_count", desc->vertex_count, 3, polygon::kMaxPolygon));
  SHD_TRY(check_count("polygon.segments", desc->segments, 1, 256));
  SHD_TRY(read_vertices(*desc, out));
  const uint32_t kind = enum_bits(desc->kind);
  SHD_TRY(refuse_flaw(polygon::find_flaw(*out), kind));
  const bool is_convex_kind = kind == SHD_BARYCENTRIC_WACHSPRESS || kind == SHD_BARYCENTRIC_DISCRETE_HARMONIC;
  if (is_convex_kind) return refuse_flaw(polygon::find_concavity(*out), kind);
  if (kind != SHD_BARYCENTRIC_HARMONIC) return SHD_OK;
  if (!polygon::has_sparse_solver()) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "polygon.kind: %u is HARMONIC, but the library was built without Eigen",
                      kind);
  }
  const uint64_t values = uint64_t{polygon::harmonic_node_count(desc->vertex_count, desc->segments)} * out->count;
  if (values <= kMaxValues) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "polygon.segments: %u with %zu vertices gives %llu values, above %llu",
                    desc->segments, desc->vertex_count, static_cast<unsigned long long>(values),
                    static_cast<unsigned long long>(kMaxValues));
}

/// The columns of a call.
struct Columns {
  InColumn in[2];
  OutColumn out[polygon::kMaxPolygon];
};

shd_result read_columns(const shd_polygon_points& points, const shd_polygon_weights& weights, uint32_t vertex_count,
                        Columns* out) {
  SHD_TRY(check_count("weights.weight_count", weights.weight_count, vertex_count, vertex_count));
  SHD_TRY(check_not_null("weights.weight", weights.weight));
  for (int c = 0; c < 2; ++c) out->in[c] = in_column("points.position", points.position[c], Need::kRequired, c);
  bool wanted = points.count == 0;
  for (uint32_t i = 0; i < vertex_count; ++i) {
    out->out[i] = out_column("weights.weight", weights.weight[i], Need::kOptional, static_cast<int>(i));
    wanted = wanted || weights.weight[i].data;
  }
  if (!wanted) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "weights.weight: NULL for all");
  SHD_TRY(check_columns(out->in, 2, points.count));
  SHD_TRY(check_columns(out->out, vertex_count, points.count));
  return check_overlap(out->in, 2, out->out, vertex_count, points.count);
}

/// A polygon with what its kind precomputes.
struct Coordinates {
  shd_barycentric kind;
  Polygon polygon;
  polygon::HarmonicField field;
};

/// Sets the weights of a point. Returns whether it lies outside.
bool find_weights(const Coordinates& c, double x, double y, double* weights) {
  const polygon::PolygonPlace place = find_place(c.polygon, x, y);
  const bool is_outside = place.kind == polygon::PolygonPlace::kOutside;
  const bool is_inside = place.kind == polygon::PolygonPlace::kInside;
  if (!is_inside && !(is_outside && c.kind == SHD_BARYCENTRIC_MEAN_VALUE)) {
    edge_weights(c.polygon, place, weights);
  } else if (c.kind == SHD_BARYCENTRIC_HARMONIC) {
    harmonic_weights(c.polygon, c.field, x, y, weights);
  } else if (!closed_form_weights(c.polygon, c.kind, x, y, weights)) {
    edge_weights(c.polygon, place, weights);
  }
  return is_outside;
}

struct Counts {
  std::atomic<size_t> outside{0}, nonfinite{0};
};

void evaluate(const Coordinates& coordinates, const shd_polygon_points& points, const shd_f32_out* out, size_t first,
              size_t end, Counts* counts) {
  double weights[polygon::kMaxPolygon];
  size_t outside = 0, nonfinite = 0;
  for (size_t i = first; i < end; ++i) {
    const float x = data::load(points.position[0], i), y = data::load(points.position[1], i);
    nonfinite += !std::isfinite(x) || !std::isfinite(y);
    const auto finite = [](float value) { return std::isfinite(value) ? double{value} : 0.0; };
    outside += find_weights(coordinates, finite(x), finite(y), weights);
    for (uint32_t v = 0; v < coordinates.polygon.count; ++v) {
      if (out[v].data) data::store(out[v], i, static_cast<float>(weights[v]));
    }
  }
  counts->outside.fetch_add(outside, std::memory_order_relaxed);
  counts->nonfinite.fetch_add(nonfinite, std::memory_order_relaxed);
}

/// Evaluates all points on the executor of a context.
void evaluate_all(const core::Context& context, const Coordinates& coordinates, const shd_polygon_points& points,
                  const shd_f32_out* out, Counts* counts) {
  const size_t size = std::max(kTaskPoints, points.count / kMaxTasks + 1);
  const auto tasks = static_cast<uint32_t>((points.count + size - 1) / size);
  core::parallel_for(context, tasks, [&](uint32_t task, uint32_t) {
    evaluate(coordinates, points, out, task * size, std::min(points.count, (task + 1) * size), counts);
  });
}

}  // namespace

extern "C" shd_result shd_polygon_evaluate(shd_context* context, const shd_polygon_desc* desc,
                                           const shd_polygon_points* points, shd_polygon_weights* out) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    const core::Context& owner = context_of(context);
    shd_polygon_desc read = shd_polygon_desc_default();
    Coordinates coordinates;
    SHD_TRY(read_polygon(desc, &read, &coordinates.polygon));
    coordinates.kind = read.kind;
    shd_polygon_points in = shd_polygon_points_default();
    SHD_TRY(read_desc("points", points, false, &in));
    shd_polygon_weights weights = shd_polygon_weights_default();
    SHD_TRY(read_desc("weights", out, false, &weights));
    Columns columns;
    SHD_TRY(read_columns(in, weights, read.vertex_count, &columns));
    if (read.kind == SHD_BARYCENTRIC_HARMONIC &&
        !solve_harmonic(owner.allocator, coordinates.polygon, read.segments, &coordinates.field)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "polygon.vertex: too thin to be triangulated");
    }
    Counts counts;
    evaluate_all(owner, coordinates, in, weights.weight, &counts);
    weights.outside_count = counts.outside.load(std::memory_order_relaxed);
    weights.nonfinite_count = counts.nonfinite.load(std::memory_order_relaxed);
    write_desc(weights, out);
    return SHD_OK;
  });
}
