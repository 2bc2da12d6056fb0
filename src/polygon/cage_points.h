// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/context.h"
#include "polygon/cage.h"

namespace shd::polygon {

/// A cage, and the kind of its coordinates.
struct Polyhedron {
  shd_barycentric kind;
  Cage cage;
};

/// Points of a call that lie outside, and points with a coordinate that is not finite.
struct PointCounts {
  size_t outside, nonfinite;
};

/// Writes the weights of points, on the executor of a context, in blocks of kBlock points. WACHSPRESS has the weights
/// of the nearest point of the surface for points outside. Coordinates that are not finite count as 0, and points far
/// away are moved nearer.
/// @param weight  [vertex_count] columns; columns without data are left out
PointCounts evaluate_points(const core::Context& context, const Polyhedron& polyhedron,
                            const shd_polyhedron_points& points, const shd_f32_out* weight);

/// Writes sums of values with the weights of evaluate_points().
/// @param vertex_values  [value_count][vertex_count]
/// @param value          [value_count] columns
PointCounts interpolate_points(const core::Context& context, const Polyhedron& polyhedron,
                               const shd_polyhedron_points& points, const double* vertex_values, size_t value_count,
                               const shd_f32_out* value);

}  // namespace shd::polygon
