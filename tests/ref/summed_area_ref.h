// SPDX-License-Identifier: MIT
// Averages over boxes of wrapped texels in doubles, texel by texel: the oracle of summed-area lookups.
#pragma once

#include <vector>

#include "ref/footprint_ref.h"

namespace ref {

/// Level 0 as linear values, and the sampler for the area outside.
struct SummedTexels {
  const double* values;  // [height][width][4]
  int64_t width, height;
  int channels;  // other channels have no border either
  const shd_sampler_desc* sampler;
};

/// A box in texels.
struct Box {
  double x, y, width, height;
};

/// Length of first..last inside every texel of one axis, and inside the border at [n].
inline void axis_lengths(shd_wrap wrap, double first, double last, int64_t n, double* lengths) {
  for (int64_t i = 0; i <= n; ++i) lengths[i] = 0;
  for (auto cell = static_cast<int64_t>(floor(first)); static_cast<double>(cell) < last; ++cell) {
    const double begin = fmax(first, static_cast<double>(cell)), end = fmin(last, static_cast<double>(cell + 1));
    const int64_t i = wrap_index(wrap, cell, n);
    if (end > begin) lengths[i < 0 ? n : i] += end - begin;
  }
}

/// A coordinate in texels, small enough for exact indices, around which a box of `side` texels has the same texels.
inline double near_coordinate(shd_wrap wrap, double u, double side, int64_t n) {
  const double size = static_cast<double>(n), reach = side + 2 * size + 2;
  return fmin(fmax(whole_period(wrap, isfinite(u) ? u : 0) * size, -reach), reach);
}

/// Sum over boxes of texels times area, and the area.
struct BoxSum {
  double sum[4], area;
};

/// @param lengths_u,lengths_v  room for width + 1 and height + 1 numbers
inline void add_box(const SummedTexels& t, const Box& box, double* lengths_u, double* lengths_v, BoxSum* out) {
  const shd_sampler_desc& s = *t.sampler;
  axis_lengths(s.wrap_u, box.x - box.width / 2, box.x + box.width / 2, t.width, lengths_u);
  axis_lengths(s.wrap_v, box.y - box.height / 2, box.y + box.height / 2, t.height, lengths_v);
  for (int64_t y = 0; y <= t.height; ++y) {
    if (lengths_v[y] == 0) continue;
    for (int64_t x = 0; x <= t.width; ++x) {
      const double area = lengths_u[x] * lengths_v[y];
      if (area == 0) continue;
      const bool border = x == t.width || y == t.height;
      out->area += area;
      for (int c = 0; c < 4; ++c) {
        const double outside = c < t.channels ? static_cast<double>(s.border[c]) : missing(c);
        out->sum[c] += area * (border ? outside : t.values[(y * t.width + x) * 4 + c]);
      }
    }
  }
}

/// Sides of a footprint's parallelogram in texels, after width, blur and bias.
inline Jacobian box_sides(const Jacobian& given, const shd_sampler_desc& s, double w, double h) {
  const auto entry = [](double value) { return isnan(value) ? 0 : value; };
  const Jacobian j = {entry(given.ux), entry(given.vx), entry(given.uy), entry(given.vy)};
  const double scale = exp2(static_cast<double>(s.lod_bias));
  Jacobian out;
  if (s.blur_u == 0 && s.blur_v == 0) {
    const double wx = static_cast<double>(s.width_x), wy = static_cast<double>(s.width_y);
    out = {j.ux * wx * w, j.vx * wx * h, j.uy * wy * w, j.vy * wy * h};
  } else {
    const Covariance c = covariance(j, s, w, h);
    const double length = sqrt(c.uu), slope = c.uu > 0 ? c.uv / c.uu : 0;
    out = {length, slope * length, 0, sqrt(fmax(c.vv - slope * c.uv, 0))};
  }
  return {out.ux * scale, out.vx * scale, out.uy * scale, out.vy * scale};
}

/// The side of a box, clamped to the sampler's range.
inline double limited_side(const shd_sampler_desc& s, double side) {
  const double low = static_cast<double>(s.lod_min), high = fmax(low, static_cast<double>(s.lod_max));
  return fmin(fmax(side, exp2(fmin(low, 22))), exp2(fmin(high, 22)));
}

/// Box k of `count` along the first side, relative to the point.
inline Box box_part(const Jacobian& j, const shd_sampler_desc& s, int k, int count) {
  const double t = (2.0 * k + 1 - count) / (2.0 * count);
  return {t * j.ux, t * j.vx, limited_side(s, fabs(j.ux) / count + fabs(j.uy)),
          limited_side(s, fabs(j.vx) / count + fabs(j.vy))};
}

/// Number of parts, before rounding, into which the first and longer side is divided.
inline double box_ratio(const Jacobian& j) {
  return hypot(j.ux, j.vx) / fmax(hypot(j.uy, j.vy), 1);
}

/// The average over the boxes of a footprint, and the tolerance for the positions of the edges.
struct BoxesAverage {
  double value[4], edges;
};

/// The average over `count` boxes along the first side of a footprint.
inline BoxesAverage boxes_average(const SummedTexels& t, double u, double v, const Jacobian& j, int count) {
  std::vector<double> lengths_u(static_cast<size_t>(t.width) + 1), lengths_v(static_cast<size_t>(t.height) + 1);
  BoxSum sum = {};
  BoxesAverage out = {};
  for (int k = 0; k < count; ++k) {
    Box box = box_part(j, *t.sampler, k, count);
    const double w = static_cast<double>(t.width), h = static_cast<double>(t.height);
    out.edges = (w + fabs(j.ux)) / box.width + (h + fabs(j.vx)) / box.height;
    box.x += near_coordinate(t.sampler->wrap_u, u, box.width + fabs(j.ux), t.width);
    box.y += near_coordinate(t.sampler->wrap_v, v, box.height + fabs(j.vx), t.height);
    add_box(t, box, lengths_u.data(), lengths_v.data(), &sum);
  }
  for (int c = 0; c < 4; ++c) out.value[c] = sum.sum[c] / sum.area;
  return out;
}

}  // namespace ref
