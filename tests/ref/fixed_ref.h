// SPDX-License-Identifier: MIT
// SHD_PRECISION_FAST in scalar integers: the oracle of the kernels with 16 bits, equal to the last bit.
// Places, levels of detail and lines of probes are floats and given; see FixedPoint.
#pragma once

#include "texture_ref.h"

namespace ref {

/// One lookup: its place, reduced by the period of repeat (1) or mirror (2), its level of detail, and its line of
/// probes: probe k lies at the place + (2 k + 1 - probes) (step_u, step_v), in coordinates.
struct FixedPoint {
  float u, v, lod, step_u, step_v;
  int probes;
};

constexpr int64_t kFixedOne = 32768;  // number of units of a fraction in 1

/// a + s (b - a) for s in units of 1 / kFixedOne, rounded to nearest, ties up.
inline int64_t fixed_mix(int64_t a, int64_t b, int64_t s) {
  const int64_t product = (b - a) * s + kFixedOne / 2;
  return a + (product - modulo(product, kFixedOne)) / kFixedOne;
}

/// A fraction in [0, 1] in units of 1 / kFixedOne. It stays below 1.
inline int64_t fixed_fraction(float s) {
  const auto nearest = static_cast<int64_t>(nearbyintf(s * 32768.0f));
  return nearest < kFixedOne ? nearest : kFixedOne - 1;
}

/// The texels on both sides of a place and the fraction of the second one.
struct FixedAxis {
  int64_t i0, i1, s;
};

/// The texels around a reduced coordinate.
inline FixedAxis fixed_axis(shd_wrap wrap, float reduced, int64_t size) {
  const auto n = static_cast<float>(size);
  float x = reduced * n;
  if (wrap == SHD_WRAP_MIRROR) x = x + x;
  x = x - 0.5f;
  if (wrap == SHD_WRAP_CLAMP) x = fminf(fmaxf(x, 0.0f), n - 1.0f);
  if (wrap == SHD_WRAP_MIRROR_ONCE) x = fminf(fmaxf(x, -n), n);
  const auto i = static_cast<int64_t>(floorf(x));
  return {wrap_index(wrap, i, size), wrap_index(wrap, i + 1, size), fixed_fraction(x - floorf(x))};
}

/// The texels around probe k on an axis that repeats. Places are integers in units of 1 / kFixedOne texel. They advance
/// by equal steps from every 16th probe.
inline FixedAxis probe_axis(float centre, float half_step, int probes, int k, int64_t size) {
  const int first = k / 16 * 16;
  const float begin = centre + static_cast<float>(2 * first + 1 - probes) * half_step;
  const float unit = static_cast<float>(size) * 32768.0f, step = half_step + half_step;
  const auto from = static_cast<int64_t>(nearbyintf((begin - floorf(begin)) * unit - 16384.0f));
  const auto advance = static_cast<int64_t>(nearbyintf((step - nearbyintf(step)) * unit));
  const int64_t place = modulo(from + (k - first) * advance, size * kFixedOne), i = place / kFixedOne;
  return {i, (i + 1) % size, place % kFixedOne};
}

/// Value of a quad in units of 1/128 of a code.
inline int64_t fixed_quad(const Image& image, int level, const FixedAxis& x, const FixedAxis& y, int c) {
  const Level& l = image.levels[level];
  const auto size = static_cast<int64_t>(shd_format_size(image.format));
  const auto texel = [&](int64_t i, int64_t j) { return int64_t{128} * l.texels[(j * l.width + i) * size + c]; };
  return fixed_mix(fixed_mix(texel(x.i0, y.i0), texel(x.i1, y.i0), x.s),
                   fixed_mix(texel(x.i0, y.i1), texel(x.i1, y.i1), x.s), y.s);
}

struct FixedLevels {
  int high, low;
  float fraction;
};
inline FixedLevels fixed_levels(const Image& image, const FixedPoint& p) {
  const int high = static_cast<int>(floorf(p.lod));
  return {high, high + 1 < image.level_count ? high + 1 : image.level_count - 1, p.lod - floorf(p.lod)};
}

/// Channel c of BILINEAR, BILINEAR_MIP (p.lod is a whole number) and TRILINEAR.
inline float fixed_value(const Image& image, const FixedPoint& p, int c) {
  if (c >= layout(image.format).channels) return static_cast<float>(missing(c));
  const shd_sampler_desc& s = *image.sampler;
  const auto quad = [&](int level) {
    const Level& l = image.levels[level];
    return fixed_quad(image, level, fixed_axis(s.wrap_u, p.u, l.width), fixed_axis(s.wrap_v, p.v, l.height), c);
  };
  const FixedLevels levels = fixed_levels(image, p);
  int64_t value = fixed_mix(quad(levels.high), quad(levels.low), fixed_fraction(levels.fraction));
  if (value % 128 >= 64) value |= 1;  // so that no value is between two codes
  const float code = static_cast<float>(value) / 128.0f;
  return code * 0x1.01p-8f + code * 0x1.0101p-24f;  // 1 / 255 in two parts, as SHD_PRECISION_FULL has it
}

/// Sum of the probes of a line on one level, in units of 1/16 of a code.
inline int64_t fixed_sum(const Image& image, const FixedPoint& p, int level, int c) {
  const shd_sampler_desc& s = *image.sampler;
  const Level& l = image.levels[level];
  const bool repeats = s.wrap_u == SHD_WRAP_REPEAT && s.wrap_v == SHD_WRAP_REPEAT;
  const auto axis = [&](shd_wrap wrap, float centre, float step, int k, int64_t size) {
    if (repeats) return probe_axis(centre, step, p.probes, k, size);
    const float distance = wrap == SHD_WRAP_MIRROR ? step * 0.5f : step;
    const float x = centre + static_cast<float>(2 * k + 1 - p.probes) * distance;
    return fixed_axis(wrap, wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR ? x - floorf(x) : x, size);
  };
  int64_t sum = 0;
  for (int k = 0; k < p.probes; ++k) {
    const FixedAxis x = axis(s.wrap_u, p.u, p.step_u, k, l.width), y = axis(s.wrap_v, p.v, p.step_v, k, l.height);
    sum += (fixed_quad(image, level, x, y, c) + 4) / 8;
  }
  return sum;
}

/// Quotient of a sum by the number of probes and the sum for value 1. The divisor is split so that sums of equal codes
/// give the correctly rounded value.
inline float fixed_quotient(float sum, float divisor) {
  const float reciprocal = 1.0f / divisor;
  int exponent;
  const float mantissa = frexpf(reciprocal, &exponent);
  const float high = ldexpf(floorf(mantissa * 1024.0f), exponent - 10), low = (1.0f - high * divisor) * reciprocal;
  return sum * high + sum * low;
}

/// Channel c of ANISOTROPIC.
inline float fixed_line_value(const Image& image, const FixedPoint& p, int c) {
  if (c >= layout(image.format).channels) return static_cast<float>(missing(c));
  const FixedLevels levels = fixed_levels(image, p);
  auto value = static_cast<float>(fixed_sum(image, p, levels.high, c));
  if (levels.fraction != 0.0f) {
    value = value + levels.fraction * (static_cast<float>(fixed_sum(image, p, levels.low, c)) - value);
  }
  return fixed_quotient(value, static_cast<float>(p.probes) * (16.0f * 255.0f));
}

}  // namespace ref
