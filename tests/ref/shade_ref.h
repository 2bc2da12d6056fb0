// SPDX-License-Identifier: MIT
// Lambert and Blinn-Phong under point and directional lights, by direct formulas in long double.
#pragma once

#include <cmath>
#include <cstddef>

#include "light/light.h"
#include "material/material.h"

namespace shd::ref {

struct Vector {
  long double x, y, z;
};
inline Vector vector(const float* v) {
  return {v[0], v[1], v[2]};
}
inline Vector operator+(Vector a, Vector b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(Vector a, Vector b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(long double s, Vector a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline long double dot(Vector a, Vector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline long double length(Vector a) {
  return sqrtl(dot(a, a));
}
/// a / |a|, or 0 for the zero vector.
inline Vector unit(Vector a) {
  const long double size = length(a);
  return size > 0 ? 1 / size * a : a;
}

/// One light at a point: L = k_d (I / r^2) max(0, n.l) + k_s (I / r^2) max(0, n.h)^p, h = (v + l) / |v + l|.
struct Term {
  long double diffuse, specular;  // factors of I k_d and I k_s
  long double falloff;            // 1 / r^2, at most 1e8; 1 for a directional light
  long double n_dot_l;
  long double half;  // |v + l|
};
inline Term light_term(const light::Light& light, Vector p, Vector n, Vector v, float exponent, bool gated) {
  Term t = {0, 0, 1, 0, 0};
  Vector l = vector(light.to_light);
  if (light.kind == SHD_LIGHT_KIND_POINT) {
    const Vector way = vector(light.position) - p;
    const long double squared = dot(way, way);
    if (!(squared > 0)) return {0, 0, 0, 0, 0};
    l = unit(way);
    t.falloff = 1 / (squared < 1e-8L ? 1e-8L : squared);
  }
  t.n_dot_l = dot(n, l);
  t.half = length(v + l);
  t.diffuse = t.falloff * (t.n_dot_l > 0 ? t.n_dot_l : 0);
  if (t.half == 0 || (gated && !(t.n_dot_l > 0))) return t;
  const long double cosine = dot(n, v + l) / t.half;
  const long double clamped = cosine < 0 ? 0 : cosine > 1 ? 1 : cosine;
  t.specular = t.falloff * (exponent == 0 ? 1 : powl(clamped, static_cast<long double>(exponent)));
  return t;
}

}  // namespace shd::ref
