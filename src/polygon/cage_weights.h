// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "polygon/cage.h"

namespace shd::polygon {

/// Points whose weights are computed together.
constexpr size_t kBlock = 16;
/// Doubles of the largest vector.
constexpr size_t kVectorDoubles = 8;

/// Points of a cage in its normalised coordinates, finite, and what their weights depend on.
struct CagePoints {
  size_t count;  // points that are wanted; the others are finite
  alignas(64) double x[kBlock], y[kBlock], z[kBlock];
  /// MEAN_VALUE, written: number of the triangle that the point lies on, whose barycentric coordinates are then the
  /// weights; otherwise -1.
  alignas(64) double triangle[kBlock];
  /// Written: 1 / the sum of the weights of the kernel. Products with it are the weights of the point.
  alignas(64) double inverse[kBlock];
  /// Written: MEAN_VALUE: the sum of the weights, which is positive inside; in floats negative for points without
  /// weights. WACHSPRESS: the least distance to the planes of the faces, which is negative outside.
  alignas(64) double depth[kBlock];
};

/// Doubles of working memory that the kernels need.
size_t scratch_size(const Cage& cage, shd_barycentric kind);

/// Sets the weights of the points of a block. The bits do not depend on the other points. |error| <= 1e-7 for points
/// within two sides of the bounding box.
/// @param scratch  [scratch_size()], aligned
/// @param weights  [vertex][kBlock], aligned
void mean_value_weights(const Cage& cage, const core::SimdTarget& simd, double* scratch, CagePoints* points,
                        double* weights);
/// Sets weights as mean_value_weights() does, by floats: only of points inside for which they are precise enough. All
/// kBlock points are finite. |error| <= 4e-6, and the error of the point that the weights reproduce is at most 2^-22.
void fast_mean_value_weights(const Cage& cage, const core::SimdTarget& simd, double* scratch, CagePoints* points,
                             double* weights);
/// Sets weights as mean_value_weights() does, for WACHSPRESS. Points outside have weights of clamped distances.
void wachspress_weights(const Cage& cage, const core::SimdTarget& simd, double* scratch, CagePoints* points,
                        double* weights);

/// Sums of weights[vertex] values[vertex], in an order that depends on the number of vertices alone.
/// @param values  [value_count][vertex_count]
/// @param out     [value_count][kBlock], aligned
void blend_values(const Cage& cage, const core::SimdTarget& simd, const double* weights, const double* values,
                  size_t value_count, double* out);

}  // namespace shd::polygon
