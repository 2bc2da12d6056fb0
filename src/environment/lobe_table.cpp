// SPDX-License-Identifier: MIT
#include "environment/lobe_table.h"

#include <cmath>
#include <mutex>

#include "data/trig.h"
#include "data/vec3.h"

namespace shd::environment {
namespace {

using data::Vec3d;

constexpr uint32_t kSamples = 256;

/// A point of the unit square, and of the unit circle at the angle 2 pi v. The points lie on a spiral.
struct SpiralPoint {
  double u;
  data::CirclePoint turn;
};
struct Spiral {
  SpiralPoint point[kSamples];
};
Spiral make_spiral() {
  Spiral spiral;
  for (uint32_t i = 0; i < kSamples; ++i) {
    const uint32_t turn = i * 0x9e3779b9u;  // 2^32 times the golden ratio's fraction
    spiral.point[i] = {(i + 0.5) / kSamples, data::circle_point(turn >> 2, 1u << 30)};
  }
  return spiral;
}

/// Direction at the polar angle of `cosine` from +Z.
Vec3d polar(double cosine, const data::CirclePoint& turn) {
  const double sine = std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine));
  return {sine * turn.cosine, sine * turn.sine, cosine};
}

/// u^(1 / 2^k).
double root(double u, uint32_t k) {
  for (; k > 0; --k) u = std::sqrt(u);
  return u;
}

double fifth_power(double x) {
  return x * x * x * x * x;
}

/// A microfacet normal visible from v (Heitz, "Sampling the GGX Distribution of Visible Normals", 2018).
Vec3d visible_normal(const Vec3d& v, double alpha, const SpiralPoint& at) {
  const Vec3d stretched = data::normalized(Vec3d{alpha * v.x, alpha * v.y, v.z});
  const Vec3d t1 = {0.0, 1.0, 0.0}, t2 = data::cross(stretched, t1);
  const double r = std::sqrt(at.u), a = r * at.turn.cosine, s = 0.5 * (1.0 + stretched.z);
  const double b = (1.0 - s) * std::sqrt(std::fmax(0.0, 1.0 - a * a)) + s * (r * at.turn.sine);
  const double c = std::sqrt(std::fmax(0.0, 1.0 - a * a - b * b));
  const Vec3d n = a * t1 + b * t2 + c * stretched;
  return data::normalized(Vec3d{alpha * n.x, alpha * n.y, std::fmax(0.0, n.z)});
}

/// The weight of a visible normal is the height-correlated shadowing over the masking.
void sum_ggx(const Spiral& spiral, uint32_t row, uint32_t column, const Vec3d& v, LobeTable* out) {
  const double alpha2 = std::ldexp(1.0, -static_cast<int>(row)), alpha = std::sqrt(alpha2);
  const auto shadowed = [&](double c) { return std::sqrt(alpha2 + (1.0 - alpha2) * c * c); };
  double f0 = 0.0, f90 = 0.0;
  for (const SpiralPoint& at : spiral.point) {
    const Vec3d h = visible_normal(v, alpha, at);
    const double v_dot_h = data::dot(v, h), n_dot_l = 2.0 * v_dot_h * h.z - v.z;
    if (n_dot_l <= 0.0) continue;
    const double g = n_dot_l * (v.z + shadowed(v.z)) / (n_dot_l * shadowed(v.z) + v.z * shadowed(n_dot_l));
    const double f = fifth_power(1.0 - v_dot_h);
    f0 += g * (1.0 - f);
    f90 += g * f;
  }
  out->sum[kSumGgxF0][row][column] = static_cast<float>(f0 / kSamples);
  out->sum[kSumGgxF90][row][column] = static_cast<float>(f90 / kSamples);
}

void sum_phong(const Spiral& spiral, uint32_t row, uint32_t column, const Vec3d& v, LobeTable* out) {
  const Vec3d r = {-v.x, 0.0, v.z}, t = {v.z, 0.0, v.x};
  double inside = 0.0, blinn = 0.0, blinn_cosine = 0.0;
  for (const SpiralPoint& at : spiral.point) {
    const Vec3d h = polar(root(at.u, row), at.turn);
    if (h.x * t.z + h.z * r.z > 0.0) inside += 1.0;  // n.l of the direction h around r
    const double v_dot_h = data::dot(v, h), n_dot_l = 2.0 * v_dot_h * h.z - v.z;
    if (v_dot_h <= 0.0 || n_dot_l <= 0.0) continue;
    blinn += v_dot_h;
    blinn_cosine += v_dot_h * n_dot_l;
  }
  out->sum[kSumPhong][row][column] = static_cast<float>(inside / kSamples);
  out->sum[kSumBlinnPhong][row][column] = static_cast<float>(blinn / kSamples);
  out->sum[kSumBlinnPhongCosine][row][column] = static_cast<float>(blinn_cosine / kSamples);
}

void sum_diffuse(const Spiral& spiral, uint32_t column, const Vec3d& v, LobeTable* out) {
  double sum = 0.0;
  for (const SpiralPoint& at : spiral.point) {
    const Vec3d l = polar(std::sqrt(at.u), at.turn);
    sum += 1.0 - fifth_power(1.0 - data::dot(v, data::normalized(v + l)));
  }
  out->diffuse[column] = static_cast<float>(sum / kSamples);
}

void compute(LobeTable* out) {
  const Spiral spiral = make_spiral();
  for (uint32_t column = 0; column < kLobeColumns; ++column) {
    const double root_of = static_cast<double>(column) / (kLobeColumns - 1);
    const double cosine = std::fmax(root_of * root_of, 1e-4);
    const Vec3d v = {std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine)), 0.0, cosine};
    sum_diffuse(spiral, column, v, out);
    for (uint32_t row = 0; row < kLobeRows; ++row) {
      sum_ggx(spiral, row, column, v, out);
      sum_phong(spiral, row, column, v, out);
    }
  }
}

}  // namespace

const LobeTable& lobe_table() {
  static LobeTable table;
  static std::once_flag once;
  std::call_once(once, [] { compute(&table); });
  return table;
}

}  // namespace shd::environment
