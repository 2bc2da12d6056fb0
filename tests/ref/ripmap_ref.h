// SPDX-License-Identifier: MIT
// Ripmap lookup in doubles: the oracle of sample_ripmap.
#pragma once

#include "ref/texture_ref.h"

namespace ref {

constexpr int kRipmapLevels = 17;

/// Levels (i, j) of a ripmap as stored, at [j][i].
struct Ripmap {
  Level levels[kRipmapLevels][kRipmapLevels];
  int columns, rows;
};

/// log2 of the extent along one axis of the ellipse that a circle of one pixel covers, in texels; NaN counts as 0.
inline double axis_lambda(double along_x, double along_y, double size) {
  return log2(hypot(isnan(along_x) ? 0 : along_x, isnan(along_y) ? 0 : along_y) * size);
}

inline double axis_lod(const shd_sampler_desc& s, double lambda, int count) {
  const double low = static_cast<double>(s.lod_min), high = fmax(low, static_cast<double>(s.lod_max));
  const double clamped = fmax(low, fmin(lambda + static_cast<double>(s.lod_bias), high));
  return fmin(fmax(clamped, 0), count - 1);
}

inline double ripmap_bilinear(shd_format format, const Ripmap& ripmap, const shd_sampler_desc& sampler, int i, int j,
                              double u, double v, int c) {
  const Image image = {format, &ripmap.levels[j][i], 1, &sampler};
  return bilinear(image, 0, u, v, c);
}

/// @param lambda_u,lambda_v  before bias and clamps
inline double ripmap(shd_format format, const Ripmap& ripmap, const shd_sampler_desc& sampler, double u, double v,
                     double lambda_u, double lambda_v, int c) {
  const double lod_u = axis_lod(sampler, lambda_u, ripmap.columns), lod_v = axis_lod(sampler, lambda_v, ripmap.rows);
  const int i = static_cast<int>(floor(lod_u)), j = static_cast<int>(floor(lod_v));
  const int next_i = i + 1 < ripmap.columns ? i + 1 : i, next_j = j + 1 < ripmap.rows ? j + 1 : j;
  const auto at = [&](int column, int row) { return ripmap_bilinear(format, ripmap, sampler, column, row, u, v, c); };
  const double s = lod_u - i, t = lod_v - j;
  return mix(mix(at(i, j), at(next_i, j), s), mix(at(i, next_j), at(next_i, next_j), s), t);
}

}  // namespace ref
