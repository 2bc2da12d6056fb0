// SPDX-License-Identifier: MIT
// SHD_PRECISION_FAST in scalar integers: the oracle of the fixed-point kernels, equal to the last bit.
// Places, levels of detail and probes are floats and given; see FixedPoint.
#pragma once

#include "texture_ref.h"

namespace ref {

/// One lookup: its place, reduced by the period of repeat (1) or mirror (2), its level of detail, and its line of
/// probes: probe k lies at the place + (2 k + 1 - probes) (step_u, step_v), in coordinates. One probe has no steps.
struct FixedPoint {
  float u, v, lod, step_u, step_v;
  int probes;
};

constexpr int64_t kFixedOne = 16384;

/// The texels on both sides of a reduced coordinate and the weight of the second one in units of 1 / one.
struct FixedAxis {
  int64_t i0, i1, s;
};
inline FixedAxis fixed_axis(shd_wrap wrap, float reduced, int64_t size, int64_t one) {
  const float half = 0.5f * static_cast<float>(one), extent = static_cast<float>(size * one);
  float x = reduced * extent;
  if (wrap == SHD_WRAP_MIRROR) {
    x = x + x;
    x = fminf(x, extent + extent - x);
  }
  if (wrap == SHD_WRAP_MIRROR_ONCE) x = fabsf(x);
  if (wrap != SHD_WRAP_REPEAT) x = fminf(fmaxf(x, half), extent - half);
  const auto place = static_cast<int64_t>(nearbyintf(x - half));
  const int64_t s = modulo(place, one), i = (place - s) / one;
  const shd_wrap rest = wrap == SHD_WRAP_REPEAT ? SHD_WRAP_REPEAT : SHD_WRAP_CLAMP;
  return {wrap_index(rest, i, size), wrap_index(rest, i + 1, size), s};
}

/// Adds the weighted codes of the four texels around a place.
inline void add_quad(const Image& image, int level, float u, float v, int c, int64_t* sum) {
  const Level& l = image.levels[level];
  const FixedAxis x = fixed_axis(image.sampler->wrap_u, u, l.width, kFixedOne);
  const FixedAxis y = fixed_axis(image.sampler->wrap_v, v, l.height, 2 * kFixedOne);
  const int64_t w11 = (x.s * y.s + kFixedOne) / (2 * kFixedOne);
  const int64_t w01 = ((kFixedOne - x.s) * y.s + kFixedOne) / (2 * kFixedOne);
  const int64_t w10 = x.s - w11, w00 = kFixedOne - x.s - w01;
  const auto size = static_cast<int64_t>(shd_format_size(image.format));
  const auto texel = [&](int64_t i, int64_t j) { return l.texels + (j * l.width + i) * size; };
  *sum +=
      w00 * texel(x.i0, y.i0)[c] + w10 * texel(x.i1, y.i0)[c] + w01 * texel(x.i0, y.i1)[c] + w11 * texel(x.i1, y.i1)[c];
}

/// Sum over the probes of one level.
inline int64_t fixed_sum(const Image& image, const FixedPoint& p, int level, int c) {
  const shd_sampler_desc& s = *image.sampler;
  const auto probe = [&](shd_wrap wrap, float centre, float step, int k) {
    if (p.probes == 1) return centre;
    const float distance = wrap == SHD_WRAP_MIRROR ? step * 0.5f : step;
    const float x = centre + static_cast<float>(2 * k + 1 - p.probes) * distance;
    return wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR ? x - floorf(x) : x;
  };
  int64_t sum = 0;
  for (int k = 0; k < p.probes; ++k) {
    add_quad(image, level, probe(s.wrap_u, p.u, p.step_u, k), probe(s.wrap_v, p.v, p.step_v, k), c, &sum);
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

/// Value of channel c of a lookup. `blended`: the level of detail lies between two levels that are blended.
inline float fixed_value(const Image& image, const FixedPoint& p, bool blended, int c) {
  if (c >= layout(image.format).channels) return static_cast<float>(missing(c));
  const int high = static_cast<int>(floorf(p.lod));
  const int low = high + 1 < image.level_count ? high + 1 : image.level_count - 1;
  const float fraction = blended ? p.lod - floorf(p.lod) : 0.0f;
  auto value = static_cast<float>(fixed_sum(image, p, high, c));
  if (fraction != 0.0f) value = value + fraction * (static_cast<float>(fixed_sum(image, p, low, c)) - value);
  return fixed_quotient(value, static_cast<float>(p.probes) * (255.0f * 16384.0f));
}

}  // namespace ref
