// SPDX-License-Identifier: MIT
#include <shd/polyhedron.h>

#include <cmath>
#include <cstdio>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "data/column.h"
#include "polygon/cage.h"
#include "polygon/cage_points.h"

namespace {

using namespace shd;
using namespace shd::abi;
using polygon::CageFlaw;
using polygon::Polyhedron;

constexpr core::ObjectType kPolyhedronType = core::ObjectType::kPolyhedron;
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

/// Reads the arguments of a call, runs run(context, polyhedron, points, results, &counts), and writes the counts.
template <class Results, class Run>
shd_result run_call(const char* name, const shd_polyhedron* polyhedron, const shd_polyhedron_points* points,
                    Results results, Results* out, const Run& run) {
  const Polyhedron* body;
  SHD_TRY(read_handle("polyhedron", polyhedron, kPolyhedronType, &body));
  shd_polyhedron_points in = shd_polyhedron_points_default();
  SHD_TRY(read_desc("points", points, false, &in));
  SHD_TRY(read_desc(name, out, false, &results));
  polygon::PointCounts counts;
  SHD_TRY(run(*object_of(polyhedron)->context, *body, in, results, &counts));
  results.outside_count = counts.outside;
  results.nonfinite_count = counts.nonfinite;
  write_desc(results, out);
  return SHD_OK;
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
    return create_handle<Polyhedron>(
        owner, kPolyhedronType, [&](Polyhedron* body) { return fill(owner, read, body); }, out_polyhedron);
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
  const auto run = [](const core::Context& owner, const Polyhedron& body, const shd_polyhedron_points& in,
                      const shd_polyhedron_weights& weights, polygon::PointCounts* counts) -> shd_result {
    SHD_TRY(check_weights(owner, in, weights, body.cage.vertex_count));
    *counts = polygon::evaluate_points(owner, body, in, weights.weight);
    return SHD_OK;
  };
  return guard([&] { return run_call("weights", polyhedron, points, shd_polyhedron_weights_default(), out, run); });
}

shd_result shd_polyhedron_interpolate(const shd_polyhedron* polyhedron, const shd_polyhedron_points* points,
                                      shd_polyhedron_values* out) {
  const auto run = [](const core::Context& owner, const Polyhedron& body, const shd_polyhedron_points& in,
                      const shd_polyhedron_values& values, polygon::PointCounts* counts) -> shd_result {
    core::Array<double> vertex_values;
    SHD_TRY(read_values(owner, in, values, body.cage.vertex_count, &vertex_values));
    *counts = polygon::interpolate_points(owner, body, in, vertex_values.data(), values.value_count, values.value);
    return SHD_OK;
  };
  return guard([&] { return run_call("values", polyhedron, points, shd_polyhedron_values_default(), out, run); });
}

}  // extern "C"
