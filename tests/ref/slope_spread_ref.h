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

/// The normals n + p a + q b (normalised) of a filtered texel, for standard normal deviates p and q: a and b are the
/// principal axes of their second moments, the longer one first; t and s span the plane across n.
struct Normals {
  Vector n, t, s, a, b;
  Symmetric covariance;  // slopes along t, s
  bool is_round;         // a and b are nearly equal, and their directions ill-conditioned
};

inline Normals normals_of(Vector n, Vector a, Vector b) {
  const Vector any = fabsl(n.x) < 0.6L ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector t = unit(any - dot(any, n) * n), s = cross(n, t);
  const auto moment = [&](Vector i, Vector j) { return dot(a, i) * dot(a, j) + dot(b, i) * dot(b, j); };
  const long double across = 2 * dot(a, b), along = dot(a, a) - dot(b, b), angle = atan2l(across, along) / 2;
  const bool is_round = hypotl(across, along) < 0.05L * (dot(a, a) + dot(b, b));
  return {n,
          t,
          s,
          cosl(angle) * a + sinl(angle) * b,
          cosl(angle) * b - sinl(angle) * a,
          {moment(t, t), moment(t, s), moment(s, s)},
          is_round};
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

/// Normals and their weights, whose lobes add up to the mean lobe.
struct Nodes {
  Vector n[4];
  long double weight[4];
};

/// Gauss-Hermite quadrature along p, one node along q, moved to a Gaussian lobe around the half vector: the density of
/// (p, q) times the lobe is a Gaussian with the inverse covariance 1 + k A^T A, with A = (a b) in slopes around n.
inline Nodes nodes_of(const Normals& g, Vector v, Vector l, long double k) {
  const Vector h = unit(v + l);
  const long double up = std::max(dot(h, g.n), 1e-3L), hx = dot(h, g.t) / up, hy = dot(h, g.s) / up;
  const long double ax = dot(g.a, g.t), ay = dot(g.a, g.s), bx = dot(g.b, g.t), by = dot(g.b, g.s);
  const Symmetric m = {1 + k * (ax * ax + ay * ay), k * (ax * bx + ay * by), 1 + k * (bx * bx + by * by)};
  const Symmetric spread = inverse(m);
  const long double fp = k * (ax * hx + ay * hy), fq = k * (bx * hx + by * hy);
  const long double p0 = spread.xx * fp + spread.xy * fq, q = spread.xy * fp + spread.yy * fq;
  Nodes nodes;
  for (int i = 0; i < 4; ++i) {
    const bool is_far = i % 2 == 1;
    const long double x = sqrtl(3 + (is_far ? 1 : -1) * sqrtl(6)), w = (3 + (is_far ? -1 : 1) * sqrtl(6)) / 12;
    const long double p = p0 + (i < 2 ? x : -x) / sqrtl(m.xx);
    nodes.n[i] = unit(g.n + p * g.a + q * g.b);
    nodes.weight[i] = w * expl((x * x - p * p - q * q) / 2) / sqrtl(determinant(m));
  }
  return nodes;
}

/// Precision of the Gaussian that places the nodes.
inline long double precision_of(const material::Material& m, long double p, long double alpha, const Normals& g,
                                long double length) {
  if (m.model == SHD_MODEL_PHONG) return 2 * p * length;
  if (m.model != SHD_MODEL_METALLIC_ROUGHNESS) return p;
  const long double x = dot(g.a, g.t), y = dot(g.a, g.s), k = 2 / (alpha * alpha), ratio = k * (x * x + y * y) / 12;
  return k * (0.2L + ratio * ratio) / (1 + ratio * ratio);
}

/// Lobes of GGX, averaged by nodes.
inline LobeTerms mean_metallic_lobes(long double alpha, const Nodes& nodes, Vector v, Vector l) {
  LobeTerms t = {};
  for (int i = 0; i < 4; ++i) {
    const long double n_dot_l = dot(nodes.n[i], l);
    t.ambiguous |= fabsl(n_dot_l) < 1e-5L;
    if (n_dot_l <= 0) continue;
    const LobeTerms own = metallic_lobes(nodes.n[i], v, l, alpha);
    for (int j = 1; j < 3; ++j) t.lobe[j] += nodes.weight[i] * own.lobe[j];
  }
  return t;
}

/// Lobes of a model over E, averaged over normals; without the bounds of lobes_of(). Where a normal faces the light by
/// chance, or the mean normal is averted by 4 standard deviations, the lobe may be kept or dropped.
inline LobeTerms mean_lobes(const material::Material& m, long double p, long double alpha, const Normals& g, Vector v,
                            Vector l) {
  LobeTerms t = {};
  const long double k = precision_of(m, p, alpha, g, length(v + l)), cosine = mean_cosine(g, l);
  const long double deviation = sqrtl(quadratic(g.covariance, dot(l, g.t), dot(l, g.s)));
  const bool is_averted = dot(g.n, l) < -4 * deviation;
  t.lobe[0] = cosine;
  if (m.model == SHD_MODEL_LAMBERT || length(v + l) == 0) return t;
  if (m.model == SHD_MODEL_METALLIC_ROUGHNESS) {
    t = mean_metallic_lobes(alpha, nodes_of(g, v, l, k), v, l);
    t.lobe[0] = cosine * (1 - powl(1 - clamped(length(v + l) / 2, 0, 1), 5));
    t.ambiguous |= g.is_round || is_averted;
    return t;
  }
  const Reflection r = reflection(g, v, l, k);
  const bool is_gated = !(m.flags & SHD_MATERIAL_SPECULAR_UNGATED);
  const long double r_dot_l = dot(r.n, l);
  t.ambiguous = is_gated && (fabsl(r_dot_l) < 1e-5L || (r_dot_l > 0 && is_averted));
  if (is_gated && r_dot_l <= 0) return t;
  const long double shining = shine(m.model, r.n, v, l, p).value * expl(-r.distance / 2) / r.widening;
  const bool is_normalized = m.model == SHD_MODEL_BLINN_PHONG_NORMALIZED;
  t.lobe[1] = shining * (is_normalized ? normalization(p) * std::max(0.0L, r_dot_l) : 1);
  return t;
}

}  // namespace shd::ref
