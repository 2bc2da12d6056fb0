// SPDX-License-Identifier: MIT
// Every model with lobes under every kind of light, by direct formulas in long double, with bounds for the error of
// float.
#pragma once

#include <algorithm>

#include "ref/shade_ref.h"

namespace shd::ref {

inline long double clamped(long double x, long double low, long double high) {
  return x < low ? low : x > high ? high : x;
}

/// E / I of a light at a point, without its cookie.
struct Arriving {
  Vector l;  // 0 at the position of the light
  long double e;
  long double error;  // bound of the error of e in float
};

inline long double smooth(long double t) {
  const long double held = clamped(t, 0, 1);
  return held * held * (3 - 2 * held);
}

/// The range is taken from the desc, the direction from make_light, which rounds it.
inline Arriving arriving(const shd_light_desc& desc, const light::Light& light, Vector p) {
  const Vector axis = vector(light.to_light);
  if (desc.kind == SHD_LIGHT_KIND_DIRECTIONAL) return {axis, 1, 0};
  const Vector way = vector(desc.position) - p;
  const long double squared = dot(way, way);
  if (!(squared > 0)) return {{0, 0, 0}, 0, 0};
  const Vector l = unit(way);
  const long double full = 1 / std::max(squared, 1e-8L);
  long double part = 1, error = 1e-6L;
  if (desc.range > 0) {
    const long double ratio = squared / (static_cast<long double>(desc.range) * desc.range);
    part = std::max(0.0L, 1 - ratio * ratio);
    error *= ratio < 1.001L ? 1 : 0;
  }
  if (desc.kind == SHD_LIGHT_KIND_SPOT) {
    const long double outer = cosl(desc.outer_angle), inner = cosl(desc.inner_angle);
    const long double scale = 1 / std::max(inner - outer, 1e-9L), cosine = dot(axis, l), off = 3e-7L;
    const long double cone = smooth(scale * (cosine - outer));
    const long double above = smooth(scale * (cosine + off - outer)), below = smooth(scale * (cosine - off - outer));
    error = error * above + part * std::max(above - cone, cone - below);
    part *= cone;
  }
  return {l, full * part, full * error};
}

/// Lobes over E; error bounds the error in float; `ambiguous` means that a step may be rounded either way.
struct LobeTerms {
  long double lobe[3], error[3];
  bool ambiguous;
};

/// x^p with 0^0 = 1, and its bounds if x has an error of `off`.
struct Power {
  long double value, low, high;
};
inline Power power(long double x, long double p, long double off) {
  const auto at = [&](long double c) { return p == 0 ? 1 : powl(clamped(c, 0, 1), p); };
  return {at(x), at(x - off), at(x + off)};
}

/// max(0, n.h)^p or, for Phong, max(0, v.r)^p. h: unit half vector, or 0.
inline Power shine(material::ModelKey model, Vector n, Vector v, Vector l, long double p) {
  const Vector sum = v + l;
  const long double size = length(sum);
  if (model == SHD_MODEL_PHONG) return power(2 * dot(n, l) * dot(n, v) - dot(v, l), p, 6e-7L);
  if (size == 0) return {0, 0, 0};
  return power(dot(n, sum) / size, p, 2.5e-7L * (1 + 2 / size));
}

/// N of the normalised model.
inline long double normalization(long double p) {
  const long double pi = acosl(-1.0L);
  return (p + 2) * (p + 4) / (8 * pi * (exp2l(-p / 2) + p));
}

/// Diffuse, F0 and F90 lobe of glTF's metallic-roughness: n.l (1 - f), n.l D V (1 - f), n.l D V f.
inline LobeTerms metallic_lobes(Vector n, Vector v, Vector l, long double alpha) {
  const long double pi = acosl(-1.0L), a2 = alpha * alpha;
  const Vector sum = v + l, h = unit(sum);
  const long double nl = std::max(0.0L, dot(n, l)), nv = std::max(1e-4L, dot(n, v)), size = length(sum);
  const Vector across = cross(n, h);
  const long double nh = std::max(0.0L, dot(n, h)), spread = nh * nh * a2 + dot(across, across);
  const long double d = a2 / (pi * spread * spread);
  const auto shadowed = [&](long double c) { return sqrtl(a2 + (1 - a2) * c * c); };
  const long double visibility = 1 / (2 * (nl * shadowed(nv) + nv * shadowed(nl)));
  const long double f = powl(1 - clamped(size / 2, 0, 1), 5), lobe = size > 0 && nl > 0 ? nl * d * visibility : 0;
  const long double off =
      6e-6L + 1e-6L * (1 + 2 / std::max(size, 1e-9L)) / alpha + 4e-7L / std::max(nl, 1e-9L) + 4e-7L / nv;
  return {{nl * (1 - f), lobe * (1 - f), lobe * f},
          {2e-6L, lobe * ((1 - f) * off + 1e-6L), lobe * (f * off + 1e-6L)},
          fabsl(dot(n, l)) < 1e-6L || size < 1e-5L};
}

/// Lobes of a model; the lobe of Gooch is (1 + n.l) / 2.
inline LobeTerms lobes_of(const material::Material& m, long double p, long double alpha, Vector n, Vector v, Vector l) {
  const long double cosine = std::max(0.0L, dot(n, l));
  if (m.model == SHD_MODEL_GOOCH) return {{(1 + dot(n, l)) / 2, 0, 0}, {1e-6L, 0, 0}, false};
  if (m.model == SHD_MODEL_METALLIC_ROUGHNESS) return metallic_lobes(n, v, l, alpha);
  if (m.model == SHD_MODEL_LAMBERT) return {{cosine, 0, 0}, {2e-6L, 0, 0}, false};
  const Power s = shine(m.model, n, v, l, p);
  LobeTerms t = {{cosine, s.value, 0}, {2e-6L, 2e-6L + std::max(s.high - s.value, s.value - s.low), 0}, false};
  const bool gated = !(m.flags & SHD_MATERIAL_SPECULAR_UNGATED);
  if (m.model == SHD_MODEL_TOON) {
    const long double steps = m.toon_steps;
    t.lobe[0] = std::min(1.0L, ceill(cosine * steps) / steps);
    t.lobe[1] = s.value >= 0.5L ? 1 : 0;
    t.error[1] = 2e-6L;
    const auto level = [&](long double off) { return ceill(steps * std::max(0.0L, dot(n, l) + off)); };
    t.ambiguous = level(-4e-7L) != level(4e-7L) || (s.low - 2e-6L < 0.5L && s.high + 2e-6L >= 0.5L);
  }
  if (m.model == SHD_MODEL_BLINN_PHONG_NORMALIZED) {
    const long double scale = normalization(p);
    t.error[1] = scale * (cosine * t.error[1] + 2e-6L * s.value);
    t.lobe[1] *= scale * cosine;
  }
  if (gated && !(dot(n, l) > 0)) t.lobe[1] = 0;
  t.ambiguous |= (gated && fabsl(dot(n, l)) < 1e-6L) || (m.model != SHD_MODEL_PHONG && length(v + l) < 1e-6L);
  return t;
}

}  // namespace shd::ref
