// SPDX-License-Identifier: MIT
// Lobes averaged over normals whose slopes are Gaussian, by matrices in long double: the formulas of
// SHD_NORMAL_ENCODING_MOMENTS.
#pragma once

#include "ref/model_ref.h"

namespace shd::ref {

/// A symmetric 2 x 2 matrix.
struct Symmetric {
  long double xx, xy, yy;
};
inline long double determinant(Symmetric m) {
  return m.xx * m.yy - m.xy * m.xy;
}
inline Symmetric inverse(Symmetric m) {
  const long double d = determinant(m);
  return {m.yy / d, -m.xy / d, m.xx / d};
}
inline long double quadratic(Symmetric m, long double x, long double y) {
  return m.xx * x * x + 2 * m.xy * x * y + m.yy * y * y;
}

/// The normals of a filtered texel: unit mean normal, unit vectors t and s across it, covariance of slopes along t, s.
struct Normals {
  Vector n, t, s;
  Symmetric covariance;
};

/// a, b: world-space vectors with the covariance a a^T + b b^T.
inline Normals normals_of(Vector n, Vector a, Vector b) {
  const Vector any = fabsl(n.x) < 0.6L ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector t = unit(any - dot(any, n) * n), s = cross(n, t);
  const auto moment = [&](Vector i, Vector j) { return dot(a, i) * dot(a, j) + dot(b, i) * dot(b, j); };
  return {n, t, s, {moment(t, t), moment(t, s), moment(s, s)}};
}

/// The mean of max(0, n.l) over a Gaussian of slopes, with their mean length in place of each length.
inline long double mean_cosine(const Normals& g, Vector l) {
  const long double m = dot(g.n, l), pi = acosl(-1.0L);
  const long double d = sqrtl(quadratic(g.covariance, dot(l, g.t), dot(l, g.s)));
  const long double rectified =
      d > 0 ? m * erfcl(-m / d / sqrtl(2)) / 2 + d * expl(-m * m / (2 * d * d)) / sqrtl(2 * pi) : std::max(m, 0.0L);
  return rectified / sqrtl(1 + g.covariance.xx + g.covariance.yy);
}

/// The normal that reflects v to l, its squared distance from the mean in standard deviations, and the square root of
/// det(1 + k S G).
struct Reflection {
  Vector n;
  long double distance, widening;
};
inline Reflection reflection(const Normals& g, Vector v, Vector l, long double k) {
  const Vector h = unit(v + l);
  const long double up = std::max(dot(h, g.n), 1e-3L), hx = dot(h, g.t) / up, hy = dot(h, g.s) / up;
  if (k == 0) return {g.n, 0, 1};
  const Symmetric s = g.covariance, sum = inverse({s.xx + 1 / k, s.xy, s.yy + 1 / k});
  const long double wx = sum.xx * hx + sum.xy * hy, wy = sum.xy * hx + sum.yy * hy;
  const long double ux = s.xx * wx + s.xy * wy, uy = s.xy * wx + s.yy * wy, size = 1 + ux * ux + uy * uy;
  const Symmetric metric = {k * (1 + uy * uy) / size / size, -k * ux * uy / size / size,
                            k * (1 + ux * ux) / size / size};
  const long double trace = s.xx * metric.xx + 2 * s.xy * metric.xy + s.yy * metric.yy;
  return {unit(ux * g.t + uy * g.s + g.n), quadratic(s, wx, wy),
          sqrtl(1 + trace + determinant(s) * determinant(metric))};
}

/// Lobes of a model over E, averaged over normals; without the bounds of lobes_of(). Where the reflecting normal faces
/// the light by chance, or the mean normal is averted by 4 standard deviations, the lobe may be kept or dropped.
inline LobeTerms mean_lobes(const material::Material& m, long double p, long double alpha, const Normals& g, Vector v,
                            Vector l) {
  LobeTerms t = {};
  t.lobe[0] = mean_cosine(g, l);
  if (m.model == SHD_MODEL_LAMBERT || length(v + l) == 0) return t;
  const bool is_rough = m.model == SHD_MODEL_METALLIC_ROUGHNESS;
  const long double k = is_rough ? 2 / (alpha * alpha) : m.model == SHD_MODEL_PHONG ? 2 * p * length(v + l) : p;
  const Reflection r = reflection(g, v, l, k);
  const bool is_gated = !(m.flags & SHD_MATERIAL_SPECULAR_UNGATED);
  const long double m_dot_l = dot(g.n, l), r_dot_l = dot(r.n, l);
  const long double deviation = sqrtl(quadratic(g.covariance, dot(l, g.t), dot(l, g.s)));
  t.ambiguous = is_gated && (fabsl(r_dot_l) < 1e-5L || (r_dot_l > 0 && m_dot_l < -4 * deviation));
  if (is_rough) {
    const long double f = powl(1 - clamped(length(v + l) / 2, 0, 1), 5), c = dot(r.n, unit(v + l)), a2 = alpha * alpha;
    const LobeTerms own = metallic_lobes(r.n, v, l, alpha);
    const long double spread = (c > 0 ? c * c : 0) * a2 + 1 - c * c, wider = spread + a2 * r.distance / 2;
    const long double weight = spread * spread / (wider * wider * r.widening);
    t.lobe[0] *= 1 - f;
    for (int j = 1; j < 3; ++j) t.lobe[j] = own.lobe[j] * weight;
    return t;
  }
  if (is_gated && r_dot_l <= 0) return t;
  const long double shining = shine(m.model, r.n, v, l, p).value * expl(-r.distance / 2) / r.widening;
  const bool is_normalized = m.model == SHD_MODEL_BLINN_PHONG_NORMALIZED;
  t.lobe[1] = shining * (is_normalized ? normalization(p) * std::max(0.0L, dot(r.n, l)) : 1);
  return t;
}

}  // namespace shd::ref
