// SPDX-License-Identifier: MIT
// The elliptical weighted average in doubles, over the bounding box of the ellipse.
#pragma once

#include <math.h>

#include "ref/footprint_ref.h"

namespace ref {

/// Level of detail of the shorter axis, biased and clamped.
inline double ewa_lod(const Image& image, const Ellipse& e) {
  return clamp_lod(image, log2(e.a / aspect(e, static_cast<double>(image.sampler->max_anisotropy))));
}

/// The ellipse in texels of a level: squares of its half axes.
struct Ellipse2 {
  double aa, bb;
};
inline Ellipse2 ewa_axes(const Image& image, const Ellipse& e, int level) {
  const double ratio = aspect(e, static_cast<double>(image.sampler->max_anisotropy));
  const double b = exp2(ewa_lod(image, e) - level);
  const double a = fmax(fmin(e.a * exp2(static_cast<double>(image.sampler->lod_bias) - level), ratio * b), b);
  const double texel = 1 - 0.6127 * (1 - exp2(-2.0 * level));
  return {0.84 * 0.84 * a * a + texel, 0.84 * 0.84 * b * b + texel};
}

/// A coordinate in texels whose centres are whole numbers. Without a periodic wrap it is at most 512 texels outside,
/// because an ellipse is at most 256 texels long.
inline double ewa_centre(shd_wrap wrap, double u, double du, double size) {
  const bool periodic = wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR;
  if (periodic || !isfinite(u)) return (reduce(wrap, u) + du) * size - 0.5;
  return fmin(fmax((u + du) * size - 0.5, -size - 512), size + 512);
}

/// The weight of bilinear: 1 where the longer axis is at most a texel, 0 from two texels on.
inline double ewa_bilinear_share(const Image& image, const Ellipse& e) {
  const double low = fmin(static_cast<double>(image.sampler->lod_min), image.level_count - 1);
  return 2 - fmin(fmax(e.a * exp2(static_cast<double>(image.sampler->lod_bias) - low), 1), 2);
}

/// The average of texels inside an ellipse around (x0, y0) in texels of a level. `texel_at`: (x, y, channel).
template <class TexelAt>
void ellipse_average(const Ellipse2& axes, const Ellipse& e, double x0, double y0, const TexelAt& texel_at,
                     double (&out)[4]) {
  const double wide = sqrt(axes.aa * e.u * e.u + axes.bb * e.v * e.v);
  const double high = sqrt(axes.aa * e.v * e.v + axes.bb * e.u * e.u);
  double sum[4] = {0, 0, 0, 0}, total = 0;
  for (auto y = static_cast<int64_t>(ceil(y0 - high)); static_cast<double>(y) <= y0 + high; ++y) {
    for (auto x = static_cast<int64_t>(ceil(x0 - wide)); static_cast<double>(x) <= x0 + wide; ++x) {
      const double dx = static_cast<double>(x) - x0, dy = static_cast<double>(y) - y0;
      const double along = dx * e.u + dy * e.v, across = dy * e.u - dx * e.v;
      const double square = along * along / axes.aa + across * across / axes.bb;
      if (square >= 1) continue;
      const double weight = exp(-2 * square) - exp(-2.0);
      for (int c = 0; c < 4; ++c) sum[c] += weight * texel_at(x, y, c);
      total += weight;
    }
  }
  for (int c = 0; c < 4; ++c) out[c] = sum[c] / total;
}

/// All channels on one level, at a point moved by (du, dv).
inline void ewa(const Image& image, const Ellipse& e, int level, double u, double v, double du, double dv,
                double out[4]) {
  const Level& l = image.levels[level];
  const double share = ewa_bilinear_share(image, e);
  const double x0 = ewa_centre(image.sampler->wrap_u, u, du, static_cast<double>(l.width));
  const double y0 = ewa_centre(image.sampler->wrap_v, v, dv, static_cast<double>(l.height));
  const auto texel_at = [&](int64_t x, int64_t y, int c) { return texel(image, level, x, y, c); };
  double average[4] = {0, 0, 0, 0};
  if (share < 1) ellipse_average(ewa_axes(image, e, level), e, x0, y0, texel_at, average);
  for (int c = 0; c < 4; ++c) {
    const double point = share > 0 ? bilinear(image, level, reduce(image.sampler->wrap_u, u) + du,
                                              reduce(image.sampler->wrap_v, v) + dv, c)
                                   : 0;
    out[c] = mix(average[c], point, share);
  }
}

}  // namespace ref
