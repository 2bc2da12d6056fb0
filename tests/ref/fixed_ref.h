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

constexpr int64_t kFixedOne = 8192;

/// The texels on both sides of a reduced coordinate and the weight of the second one.
struct FixedAxis {
  int64_t i0, i1, s;
};
inline FixedAxis fixed_axis(shd_wrap wrap, float reduced, int64_t size) {
  const float extent = static_cast<float>(size) * 8192.0f;
  float x = reduced * extent;
  if (wrap == SHD_WRAP_MIRROR) {
    x = x + x;
    x = fminf(x, extent + extent - x);
  }
  if (wrap == SHD_WRAP_MIRROR_ONCE) x = fabsf(x);
  if (wrap != SHD_WRAP_REPEAT) x = fminf(fmaxf(x, 4096.0f), extent - 4096.0f);
  const auto place = static_cast<int64_t>(x + 0.5f) - 4096;
  const int64_t s = modulo(place, kFixedOne), i = (place - s) / kFixedOne;
  const shd_wrap rest = wrap == SHD_WRAP_REPEAT ? SHD_WRAP_REPEAT : SHD_WRAP_CLAMP;
  return {wrap_index(rest, i, size), wrap_index(rest, i + 1, size), s};
}

/// Integer value of a channel of a texel.
inline int64_t fixed_value(shd_format format, const uint8_t* texel, int c) {
  if (layout(format).component == Layout::kUnorm8) return texel[c];
  return c == 3 ? texel[c] * 128 : llround(srgb_to_linear(texel[c] / 255.0) * 32767);
}

/// Sum of the quads of one level, and the codes that went into it.
struct FixedSum {
  int64_t sum = 0;
  int code = -1;  // code of the first texel
  bool equal = true;

  void see(int of_texel) {
    if (code < 0) code = of_texel;
    equal = equal && code == of_texel;
  }
};

inline void add_quad(const Image& image, int level, float u, float v, int c, FixedSum* sum) {
  const Level& l = image.levels[level];
  const FixedAxis x = fixed_axis(image.sampler->wrap_u, u, l.width), y = fixed_axis(image.sampler->wrap_v, v, l.height);
  const int64_t w11 = (x.s * y.s + kFixedOne / 2) / kFixedOne;
  const int64_t w10 = x.s - w11, w01 = y.s - w11, w00 = kFixedOne - x.s - y.s + w11;
  const auto size = static_cast<int64_t>(shd_format_size(image.format));
  const auto texel = [&](int64_t i, int64_t j) { return l.texels + (j * l.width + i) * size; };
  const uint8_t *t00 = texel(x.i0, y.i0), *t10 = texel(x.i1, y.i0), *t01 = texel(x.i0, y.i1), *t11 = texel(x.i1, y.i1);
  const auto value = [&](const uint8_t* t) { return fixed_value(image.format, t, c); };
  const int64_t quad = w00 * value(t00) + w10 * value(t10) + w01 * value(t01) + w11 * value(t11);
  const bool srgb = layout(image.format).component == Layout::kSrgb8;
  sum->sum += srgb ? (quad + 32) >> 6 : quad;
  sum->see(t00[c]);
  sum->see(t01[c]);
  if (w10 != 0 || w11 != 0) {
    sum->see(t10[c]);
    sum->see(t11[c]);
  }
}

/// Sum over the probes of one level.
inline FixedSum fixed_sum(const Image& image, const FixedPoint& p, int level, int c) {
  const shd_sampler_desc& s = *image.sampler;
  const auto probe = [&](shd_wrap wrap, float centre, float step, int k) {
    if (p.probes == 1) return centre;
    const float distance = wrap == SHD_WRAP_MIRROR ? step * 0.5f : step;
    const float x = centre + static_cast<float>(2 * k + 1 - p.probes) * distance;
    return wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR ? x - floorf(x) : x;
  };
  FixedSum sum;
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
  const FixedSum a = fixed_sum(image, p, high, c);
  auto value = static_cast<float>(a.sum);
  bool equal = a.equal;
  if (fraction != 0.0f) {
    const FixedSum b = fixed_sum(image, p, low, c);
    value = value + fraction * (static_cast<float>(b.sum) - value);
    equal = equal && b.equal && a.code == b.code;
  }
  const auto probes = static_cast<float>(p.probes);
  if (layout(image.format).component == Layout::kUnorm8) return fixed_quotient(value, probes * (255.0f * 8192.0f));
  if (c == 3) return fixed_quotient(value, probes * (255.0f * 128.0f * 128.0f));
  if (equal) return static_cast<float>(srgb_to_linear(a.code / 255.0));
  return value * (1.0f / (probes * (32767.0f * 128.0f)));
}

}  // namespace ref
