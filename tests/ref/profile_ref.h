// SPDX-License-Identifier: MIT
// Levels of detail and probes of the sampler profiles in doubles, after the text of <shd/sampler.h> and its sources.
#pragma once

#include <math.h>

#include "ref/footprint_ref.h"

namespace ref {

/// Probes at (u, v) + p (du, dv), p = (2 k + 1 - count) / 2, of weight exp(-2 (p scale)^2).
struct Line {
  int count;
  double du, dv, scale, lambda;
};

inline double longer_lambda(const Jacobian& j, double w, double h) {
  return log2(fmax(hypot(j.ux * w, j.vx * h), hypot(j.uy * w, j.vy * h)));
}

/// Derivatives times width, in units of the texture; the oracle has no blur for Vulkan and Direct3D.
inline Jacobian widened(const Jacobian& j, const shd_sampler_desc& s) {
  const double wx = static_cast<double>(s.width_x), wy = static_cast<double>(s.width_y);
  if (s.profile == SHD_PROFILE_OIIO) return {j.ux * wx, j.vx * wy, j.uy * wx, j.vy * wy};
  return {j.ux * wx, j.vx * wx, j.uy * wy, j.vy * wy};
}

/// `slack` is added to a value before it is rounded up or down to a number of probes.
inline Line vulkan_line(const Jacobian& j, const shd_sampler_desc& s, double w, double h, double slack) {
  const double x = hypot(j.ux * w, j.vx * h), y = hypot(j.uy * w, j.vy * h),
               cap = static_cast<double>(s.max_anisotropy);
  const double longer = fmax(x, y), shorter = fmin(x, y);
  const double eta = longer == 0 ? 1 : shorter == 0 ? cap : fmin(longer / shorter, cap);
  const double count = fmax(ceil(eta + slack), 1);
  const bool along_x = x > y;
  return {static_cast<int>(count), (along_x ? j.ux : j.uy) / (count + 1), (along_x ? j.vx : j.vy) / (count + 1), 0,
          log2(longer / eta)};
}

/// The steps of the functional specification.
inline Line d3d11_line(const Jacobian& j, const shd_sampler_desc& s, double w, double h, double slack) {
  double xu = j.ux * w, xv = j.vx * h, yu = j.uy * w, yv = j.vy * h;
  const double cap = static_cast<double>(s.max_anisotropy);
  const double det = xu * yv - xv * yu, dot = xu * yu + xv * yv;
  if (det != 0 && dot != 0) {
    const double a = xv * xv + yv * yv, b = -2 * (xu * xv + yu * yv), c = xu * xu + yu * yu, f = det * det;
    const double p = a - c, q = a + c, t = sqrt(p * p + b * b), sign = b < 0 ? -1 : 1;
    xu = sqrt(f * (t + p) / (t * (q + t)));
    xv = sign * sqrt(f * (t - p) / (t * (q + t)));
    yu = -sign * sqrt(f * (t - p) / (t * (q - t)));
    yv = sqrt(f * (t + p) / (t * (q - t)));
  }
  const double x = hypot(xu, xv), y = hypot(yu, yv), major = fmax(x, y);
  if (major == 0) return {1, 0, 0, 0, -INFINITY};
  const double area = fabs(xu * yv - xv * yu);
  double ratio = area == 0 ? cap : fmin(major * major / area, cap);
  const double minor = major / ratio;
  if (minor < 1) ratio = fmax(1, ratio * minor);
  const double count = fmax(ceil(ratio + slack), 1);
  return {static_cast<int>(count), (x > y ? xu : yu) / w / (count + 1), (x > y ? xv : yv) / h / (count + 1), 0,
          log2(minor)};
}

/// Level m - 1 + blend of a filter with a width in units of the texture; log2 of its texels where level 0 suffices.
inline double oiio_lambda(const Image& image, double width, bool one_level) {
  for (int m = 0; m < image.level_count; ++m) {
    const double texels =
        width * static_cast<double>(image.levels[m].width < image.levels[m].height ? image.levels[m].width
                                                                                   : image.levels[m].height);
    if (texels > 1) continue;
    if (m == 0) return log2(texels);
    return one_level ? m : m - 1 + fmax(2 * texels - 1, 0);
  }
  return image.level_count - 1;
}

inline double oiio_width(const Jacobian& j, const shd_sampler_desc& s) {
  const double largest = fmax(fmax(fabs(j.ux), fabs(j.vx)), fmax(fabs(j.uy), fabs(j.vy)));
  return largest + static_cast<double>(s.blur_u > s.blur_v ? s.blur_u : s.blur_v);
}

inline Line oiio_line(const Image& image, Jacobian j, double slack) {
  const shd_sampler_desc& s = *image.sampler;
  const double cap = static_cast<double>(s.max_anisotropy), tiny = 1e-8;
  const double x = hypot(j.ux, j.vx), y = hypot(j.uy, j.vy);
  if (x < tiny && y < tiny) {
    j = {tiny, 0, 0, tiny};
  } else if (x < tiny) {
    j.ux = j.vy * tiny / y;
    j.vx = -j.uy * tiny / y;
  } else if (y < tiny) {
    j.uy = -j.vx * tiny / x;
    j.vy = j.ux * tiny / x;
  }
  const Ellipse e = ellipse(j);
  double major = fmin(e.a, 1000), minor = fmin(e.b, 1000), u = e.u, v = e.v;
  const double bu = static_cast<double>(s.blur_u), bv = static_cast<double>(s.blur_v);
  major += bu * fabs(u) + bv * fabs(v);
  minor += bu * fabs(v) + bv * fabs(u);
  if (minor > major) {
    const double other = minor;
    minor = major;
    major = other;
    const double turned = u;
    u = -v;
    v = turned;
  }
  double aspect = fmin(major / minor, cap);
  if (major > cap * minor) {
    major = (major + minor * cap) / 2;
    minor = major / cap;
  }
  const double w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  if (minor * fmin(w, h) <= 1 && minor * fmax(w, h) < 0.5) aspect = fmin(fmax(major * fmax(w, h) * 2, 1), cap);
  const double count = fmax(1, floor(2 * aspect - 1 + slack)), spread = major - minor;
  const double scale = spread > 0 ? major / (2 * spread) * 2 / count : 0;
  return {static_cast<int>(count), 2 * spread * u / count, 2 * spread * v / count, scale,
          oiio_lambda(image, minor, false)};
}

/// lambda of the filters without anisotropy.
inline double profile_lambda(const Image& image, const Jacobian& derivatives, bool one_level) {
  const shd_sampler_desc& s = *image.sampler;
  const Jacobian j = widened(derivatives, s);
  if (s.profile == SHD_PROFILE_OIIO) return oiio_lambda(image, oiio_width(j, s), one_level);
  const double w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  const bool parallel = j.ux * j.vy == j.uy * j.vx;
  if (s.profile == SHD_PROFILE_VULKAN || parallel) return longer_lambda(j, w, h);
  return log2(ellipse(Jacobian{j.ux * w, j.vx * h, j.uy * w, j.vy * h}).a);
}

inline Line profile_line(const Image& image, const Jacobian& derivatives, double slack) {
  const shd_sampler_desc& s = *image.sampler;
  const Jacobian j = widened(derivatives, s);
  const double w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  if (s.profile == SHD_PROFILE_OIIO) return oiio_line(image, j, slack);
  return s.profile == SHD_PROFILE_VULKAN ? vulkan_line(j, s, w, h, slack) : d3d11_line(j, s, w, h, slack);
}

/// The level of detail between levels, rounded as a profile with 8 fractional bits requires.
inline double profile_lod(const Image& image, double lambda) {
  const double lod = clamp_lod(image, lambda);
  return image.sampler->profile == SHD_PROFILE_OIIO ? lod : floor(lod * 256 + 0.5) / 256;
}

/// The level of NEAREST_MIP and BILINEAR_MIP.
inline int profile_level(const Image& image, double lambda) {
  const double lod = clamp_lod(image, lambda);
  if (image.sampler->profile == SHD_PROFILE_OIIO) return static_cast<int>(ceil(lod));
  if (image.sampler->profile == SHD_PROFILE_D3D11) return static_cast<int>(floor(profile_lod(image, lambda) + 0.5));
  return static_cast<int>(fmax(ceil(lod + 0.5) - 1, 0));
}

/// Trilinear lookup at a final level of detail.
inline double trilinear_at(const Image& image, double u, double v, double lod, int c) {
  const int high = static_cast<int>(floor(lod));
  const int low = high + 1 < image.level_count ? high + 1 : image.level_count - 1;
  return mix(bilinear(image, high, u, v, c), bilinear(image, low, u, v, c), lod - floor(lod));
}

inline double profile_anisotropic(const Image& image, const Line& line, double u, double v, int c) {
  const double lod = profile_lod(image, line.lambda);
  double sum = 0, total = 0;
  for (int k = 0; k < line.count; ++k) {
    const double p = (2.0 * k + 1 - line.count) / 2, x = p * line.scale, weight = exp(-2 * x * x);
    sum += weight * trilinear_at(image, whole_period(image.sampler->wrap_u, u) + p * line.du,
                                 whole_period(image.sampler->wrap_v, v) + p * line.dv, lod, c);
    total += weight;
  }
  return sum / total;
}

}  // namespace ref
