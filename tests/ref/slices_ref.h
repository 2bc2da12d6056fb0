// SPDX-License-Identifier: MIT
// Lookups in 3D textures in doubles: the oracle of their filters and levels.
#pragma once

#include <math.h>

#include "ref/texture_ref.h"

namespace ref {

/// Stored texels of one level of a 3D texture, rows and slices packed.
struct SolidLevel {
  const uint8_t* texels;
  int64_t width, height, depth;
};

struct Solid {
  shd_format format;
  const SolidLevel* levels;
  int level_count;
  const shd_sampler_desc* sampler;
};

struct Place {
  double u, v, w;
};

inline double texel(const Solid& solid, int level, int64_t i, int64_t j, int64_t k, int c) {
  const SolidLevel& l = solid.levels[level];
  const int64_t x = wrap_index(solid.sampler->wrap_u, i, l.width), y = wrap_index(solid.sampler->wrap_v, j, l.height);
  const int64_t z = wrap_index(solid.sampler->wrap_w, k, l.depth);
  if (c >= layout(solid.format).channels) return missing(c);
  if (x < 0 || y < 0 || z < 0) return static_cast<double>(solid.sampler->border[c]);
  const auto size = static_cast<int64_t>(shd_format_size(solid.format));
  return decode(solid.format, l.texels + ((z * l.height + y) * l.width + x) * size, c);
}

/// A place in texels of a level, moved by `shift` texels.
inline Place texels_of(const Solid& solid, int level, const Place& p, double shift) {
  const SolidLevel& l = solid.levels[level];
  const shd_sampler_desc& s = *solid.sampler;
  return {reduce(s.wrap_u, p.u) * static_cast<double>(l.width) + shift,
          reduce(s.wrap_v, p.v) * static_cast<double>(l.height) + shift,
          reduce(s.wrap_w, p.w) * static_cast<double>(l.depth) + shift};
}

/// The eight texels of a level around a place, with the weights weight(s) of the fractions.
template <class Weight>
double blend_eight(const Solid& solid, int level, const Place& p, const Weight& weight, int c) {
  const Place t = texels_of(solid, level, p, -0.5);
  const auto i = static_cast<int64_t>(floor(t.u)), j = static_cast<int64_t>(floor(t.v));
  const auto k = static_cast<int64_t>(floor(t.w));
  const auto slice = [&](int64_t z) {
    const auto row = [&](int64_t y) {
      return mix(texel(solid, level, i, y, z, c), texel(solid, level, i + 1, y, z, c), weight(t.u - floor(t.u)));
    };
    return mix(row(j), row(j + 1), weight(t.v - floor(t.v)));
  };
  return mix(slice(k), slice(k + 1), weight(t.w - floor(t.w)));
}

inline double linear(const Solid& solid, int level, const Place& p, int c) {
  return blend_eight(
      solid, level, p, [](double s) { return s; }, c);
}
inline double hermite(const Solid& solid, const Place& p, int c) {
  return blend_eight(solid, 0, p, hermite_weight, c);
}

/// The texel that contains a place moved by texels of the level.
inline double nearest_on(const Solid& solid, int level, const Place& p, const Place& moved, int c) {
  const Place t = texels_of(solid, level, p, 0);
  return texel(solid, level, static_cast<int64_t>(floor(t.u + moved.u)), static_cast<int64_t>(floor(t.v + moved.v)),
               static_cast<int64_t>(floor(t.w + moved.w)), c);
}

/// Level of detail after bias and clamps.
inline double clamp_lod(const Solid& solid, double lod) {
  return clamp_lod(Image{solid.format, nullptr, solid.level_count, solid.sampler}, lod);
}

inline double trilinear(const Solid& solid, const Place& p, double lod, int c) {
  const double d = clamp_lod(solid, lod);
  const int high = static_cast<int>(floor(d));
  const int low = high + 1 < solid.level_count ? high + 1 : solid.level_count - 1;
  return mix(linear(solid, high, p, c), linear(solid, low, p, c), d - floor(d));
}

/// The tensor product of the cubic kernel on three axes of level 0.
inline double tricubic(const Solid& solid, const Place& p, int c) {
  const Place t = texels_of(solid, 0, p, -0.5);
  const auto i = static_cast<int64_t>(floor(t.u)), j = static_cast<int64_t>(floor(t.v));
  const auto k = static_cast<int64_t>(floor(t.w));
  double sum = 0;
  for (int n = 0; n < 64; ++n) {
    const int64_t x = i + n % 4 - 1, y = j + n / 4 % 4 - 1, z = k + n / 16 - 1;
    const shd_cubic cubic = solid.sampler->cubic;
    const double weight = cubic_weight(cubic, t.u - static_cast<double>(x)) *
                          cubic_weight(cubic, t.v - static_cast<double>(y)) *
                          cubic_weight(cubic, t.w - static_cast<double>(z));
    if (weight != 0) sum += weight * texel(solid, 0, x, y, z, c);
  }
  return sum;
}

/// The ellipse of derivatives x and y in texels: half axes a >= b, the direction of the longer one, and the unit normal
/// of its plane, or 0.
struct Spread {
  double a, b;
  Place axis, normal;
};

inline Spread spread_of(const Place& x, const Place& y) {
  const double xx = x.u * x.u + x.v * x.v + x.w * x.w, yy = y.u * y.u + y.v * y.v + y.w * y.w;
  const double xy = x.u * y.u + x.v * y.v + x.w * y.w;
  const double angle = 0.5 * atan2(2 * xy, xx - yy);
  const Place axis = {cos(angle) * x.u + sin(angle) * y.u, cos(angle) * x.v + sin(angle) * y.v,
                      cos(angle) * x.w + sin(angle) * y.w};
  const double a = sqrt((xx + yy) / 2 + hypot((xx - yy) / 2, xy));
  const Place cross = {x.v * y.w - x.w * y.v, x.w * y.u - x.u * y.w, x.u * y.v - x.v * y.u};
  const double area = sqrt(cross.u * cross.u + cross.v * cross.v + cross.w * cross.w);
  if (!(a > 0)) return {0, 0, {0, 0, 0}, {0, 0, 0}};
  const double per_area = area > 0 ? 1 / area : 0;
  return {
      a, area / a, {axis.u / a, axis.v / a, axis.w / a}, {cross.u * per_area, cross.v * per_area, cross.w * per_area}};
}

/// The average of `count` trilinear lookups along the longer axis.
inline double anisotropic(const Solid& solid, const Spread& s, int count, const Place& p, int c) {
  const SolidLevel& base = solid.levels[0];
  const double limit = static_cast<double>(solid.sampler->max_anisotropy);
  const double ratio = s.a == 0 ? 1 : s.a > limit * s.b ? limit : s.a / s.b;
  double sum = 0, total = 0;
  for (int k = 0; k < count; ++k) {
    const double part = (2.0 * k + 1 - count) / (2.0 * count), t = part * s.a;
    const double weight = solid.sampler->probe_weights == SHD_PROBE_WEIGHTS_GAUSSIAN ? exp(-8 * part * part) : 1;
    const auto moved = [&](shd_wrap wrap, double at, double axis, int64_t size) {
      const bool periodic = wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR;
      return (periodic || !isfinite(at) ? reduce(wrap, at) : at) + t * axis / static_cast<double>(size);
    };
    const Place q = {moved(solid.sampler->wrap_u, p.u, s.axis.u, base.width),
                     moved(solid.sampler->wrap_v, p.v, s.axis.v, base.height),
                     moved(solid.sampler->wrap_w, p.w, s.axis.w, base.depth)};
    sum += weight * trilinear(solid, q, log2(s.a / ratio), c);
    total += weight;
  }
  return sum / total;
}

/// Average of the base level over the volume of texel (x, y, z) of a level.
inline double box(const Solid& solid, int level, int64_t x, int64_t y, int64_t z, int c) {
  const SolidLevel &base = solid.levels[0], &to = solid.levels[level];
  const auto size = static_cast<int64_t>(shd_format_size(solid.format));
  long double sum = 0;
  for (int64_t k = z * base.depth / to.depth; k < base.depth && k * to.depth < (z + 1) * base.depth; ++k) {
    for (int64_t j = y * base.height / to.height; j < base.height && j * to.height < (y + 1) * base.height; ++j) {
      for (int64_t i = x * base.width / to.width; i < base.width && i * to.width < (x + 1) * base.width; ++i) {
        const double weight = overlap(i, base.width, x, to.width) * overlap(j, base.height, y, to.height) *
                              overlap(k, base.depth, z, to.depth);
        const uint8_t* texel = base.texels + ((k * base.height + j) * base.width + i) * size;
        sum += static_cast<long double>(weight) * static_cast<long double>(decode(solid.format, texel, c));
      }
    }
  }
  return static_cast<double>(sum / (static_cast<long double>(base.width) * static_cast<long double>(base.height) *
                                    static_cast<long double>(base.depth)));
}

}  // namespace ref
