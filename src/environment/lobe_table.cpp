// SPDX-License-Identifier: MIT
#include "environment/lobe_table.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/lobe_table.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/simd_target.h"
#include "data/trig.h"
#include "simd/angle-inl.h"
#include "simd/math-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::environment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Normalize;
using simd::HWY_NAMESPACE::Scaled;
using simd::HWY_NAMESPACE::Sum;
using simd::HWY_NAMESPACE::UnitPow;
using simd::HWY_NAMESPACE::Vec3V;

// One lane is one column, so that the bits do not depend on the number of lanes.
using Tag = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Tag>;
static_assert(kLobeColumns % 16 == 0);

constexpr uint32_t kSamples = 256;  // points of a disc
constexpr uint32_t kSteps = 32;     // steps of an integral over one variable
constexpr uint32_t kGgxSteps = 20, kGgxArc = 6;
constexpr float kGgxCircle[kGgxArc] = {0.965925826f,  0.707106781f,  0.258819045f,
                                       -0.258819045f, -0.707106781f, -0.965925826f};

/// Points of the unit disc on a spiral, evenly spread.
struct Disc {
  float x[kSamples], y[kSamples];
};
Disc make_disc() {
  Disc disc;
  for (uint32_t i = 0; i < kSamples; ++i) {
    const uint32_t turn = i * 0x9e3779b9u;  // 2^32 times the golden ratio's fraction
    const data::CirclePoint at = data::circle_point(turn >> 2, 1u << 30);
    const double r = std::sqrt((i + 0.5) / kSamples);
    disc.x[i] = static_cast<float>(r * at.cosine);
    disc.y[i] = static_cast<float>(r * at.sine);
  }
  return disc;
}

Vec FifthPower(Vec x) {
  return x * x * (x * x) * x;
}

/// Square root of x, at least 0.
Vec RootOf(Vec x) {
  return hn::Sqrt(hn::Max(x, hn::Zero(Tag())));
}

/// Unit vectors to the eye, in the plane of x and z, for vectors of columns.
struct Eye {
  Vec n_dot_v, sine;
  explicit Eye(Vec cosine) : n_dot_v(cosine), sine(RootOf(hn::Set(Tag(), 1.0f) - cosine * cosine)) {}
};

void SumDiffuse(const Disc& disc, const Eye& v, float* to) {
  const Tag d;
  const Vec zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  Vec sum = zero;
  for (uint32_t i = 0; i < kSamples; ++i) {
    const Vec x = hn::Set(d, disc.x[i]), y = hn::Set(d, disc.y[i]);
    const Vec3V<Vec> l = {x, y, RootOf(one - x * x - y * y)}, to_eye = {v.sine, zero, v.n_dot_v};
    sum = sum + (one - FifthPower(one - Dot(to_eye, Normalize(d, Sum(to_eye, l)))));
  }
  hn::StoreU(sum * hn::Set(d, 1.0f / kSamples), d, to);
}

/// Place and weight of step i of `count` of the midpoint rule in x for an integral over u = x^3 (10 - 15 x + 6 x^2) in
/// 0..1. It takes the roots that an integrand has at both ends.
struct Step {
  float place, weight;
};
Step step(uint32_t i, uint32_t count) {
  const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(count), rest = x * (1.0f - x);
  return {x * x * x * (10.0f - 15.0f * x + 6.0f * x * x), 30.0f * rest * rest / static_cast<float>(count)};
}

/// Integral of f over u from `from` to `to`.
template <class F>
Vec Integral(Vec from, Vec to, const F& f) {
  const Tag d;
  Vec sum = hn::Zero(d);
  for (uint32_t i = 0; i < kSteps; ++i) {
    const Step at = step(i, kSteps);
    sum = sum + hn::Set(d, at.weight) * f(from + hn::Set(d, at.place) * (to - from));
  }
  return (to - from) * sum;
}

/// The angle whose cosine is clamped to -1..1, and its sine.
struct Angle {
  Vec cosine, sine, angle;
  explicit Angle(Vec c) {
    const Tag d;
    const Vec one = hn::Set(d, 1.0f);
    cosine = hn::Min(hn::Max(c, hn::Neg(one)), one);
    sine = RootOf(one - cosine * cosine);
    angle = simd::HWY_NAMESPACE::Atan2(d, sine, cosine);
  }
};

/// The angle phi around n, up to which half vectors at the angle of c and s from n have n.l > 0.
Angle LitArc(const Eye& v, Vec c, Vec s) {
  const Tag d;
  const Vec c2 = c * c, twice = c + c;
  return Angle(((hn::Set(d, 1.0f) - c2) - c2) * v.n_dot_v / hn::Max(twice * s * v.sine, hn::Set(d, 1e-20f)));
}

/// Sums over half vectors around n: those with n.l > 0 are all up to half of the angle between v and the surface,
/// farther away an arc. With tan(angle) = alpha tan(psi), sin^2(psi) is uniform in 0..1 under the weight D n.h.
class GgxSum {
 public:
  GgxSum(float alpha_squared, const Eye& v)
      : v_(v), a2_(hn::Set(Tag(), alpha_squared)), masked_(Shadowed(v.n_dot_v)), f0_(hn::Zero(Tag())), f90_(f0_) {}

  void Store(float* to_f0, float* to_f90) {
    const Tag d;
    const Vec half = hn::Set(d, 0.5f), alpha = hn::Sqrt(a2_);
    const Vec cosine = hn::Sqrt(half + half * v_.sine), sine = half * v_.n_dot_v / cosine;
    const Vec near = simd::HWY_NAMESPACE::Atan2(d, sine, alpha * cosine);
    const Vec far = simd::HWY_NAMESPACE::Atan2(d, cosine, alpha * sine);
    for (uint32_t i = 0; i < kGgxSteps; ++i) {
      const Step at = step(i, kGgxSteps);
      AddCircle(near * hn::Set(d, at.place), near * hn::Set(d, at.weight));
      AddArc(near + (far - near) * hn::Set(d, at.place), (far - near) * hn::Set(d, at.weight));
    }
    hn::StoreU(f0_, d, to_f0);
    hn::StoreU(f90_, d, to_f90);
  }

 private:
  /// The angle of psi, and the weight of psi for sums over phi / pi.
  struct Ring {
    Vec c, s, weight;
    Ring(Vec psi, Vec weight_of_psi, Vec a2) {
      const Tag d;
      const auto turn = simd::HWY_NAMESPACE::SineCosinePi(d, psi * hn::Set(d, simd::HWY_NAMESPACE::kInvPi));
      const Vec cosine = hn::Max(turn.cosine, hn::Set(d, 1e-10f)), c2 = cosine * cosine,
                s2 = turn.sine * turn.sine * a2;
      const Vec inverse = hn::Set(d, 1.0f) / hn::Sqrt(c2 + s2);
      c = cosine * inverse, s = hn::Sqrt(s2) * inverse;
      weight = weight_of_psi * (turn.sine + turn.sine) * cosine;
    }
  };

  void AddCircle(Vec psi, Vec weight) {
    const Tag d;
    const Ring ring(psi, weight, a2_);
    for (const float cosine : kGgxCircle) {
      Add(ring, hn::Set(d, cosine), ring.weight * hn::Set(d, 1.0f / kGgxArc));
    }
  }

  /// y = (3 x - x^3) / 2 takes the midpoint rule to the fourth order: the sum is 0 at the end of the arc.
  void AddArc(Vec psi, Vec weight) {
    const Tag d;
    const Ring ring(psi, weight, a2_);
    const Vec end = LitArc(v_, ring.c, ring.s).angle * hn::Set(d, simd::HWY_NAMESPACE::kInvPi);
    for (uint32_t k = 0; k < kGgxArc; ++k) {
      const float x = (static_cast<float>(k) + 0.5f) / kGgxArc;
      const Vec phi = end * hn::Set(d, 0.5f * x * (3.0f - x * x));
      Add(ring, simd::HWY_NAMESPACE::CosPi(d, phi), ring.weight * end * hn::Set(d, 1.5f * (1.0f - x * x) / kGgxArc));
    }
  }

  Vec Shadowed(Vec c) const { return hn::Sqrt(a2_ + (hn::Set(Tag(), 1.0f) - a2_) * (c * c)); }

  /// Adds D V n.l at one half vector, whose light has the solid angle 4 v.h.
  void Add(const Ring& at, Vec cosine_phi, Vec weight) {
    const Tag d;
    const Vec zero = hn::Zero(d), v_dot_h = at.c * v_.n_dot_v + at.s * v_.sine * cosine_phi, twice = v_dot_h + v_dot_h;
    const Vec n_dot_l = hn::Max(twice * at.c - v_.n_dot_v, zero);
    const Vec below = at.c * (n_dot_l * masked_ + v_.n_dot_v * Shadowed(n_dot_l));
    const Vec value = weight * twice * n_dot_l / below;
    const Vec f = value * FifthPower(hn::Max(hn::Set(d, 1.0f) - v_dot_h, zero));
    f0_ = f0_ + (value - f);
    f90_ = f90_ + f;
  }

  const Eye& v_;
  const Vec a2_, masked_;
  Vec f0_, f90_;
};

/// A lobe max(0, c)^p of directions with the cosine c to an axis, by u = c^(p + 1), which is uniform in 0..1.
struct PowerLobe {
  float precision;  // p + 1
  Vec Cumulative(Vec cosine) const { return UnitPow(Tag(), cosine, hn::Set(Tag(), precision)); }
  Vec Cosine(Vec u) const { return UnitPow(Tag(), u, hn::Set(Tag(), 1.0f / precision)); }
};

/// Directions l around r: all of them up to the angle between r and the surface, farther away an arc of the circle.
void SumPhong(PowerLobe lobe, const Eye& v, float* to) {
  const Tag d;
  const Vec one = hn::Set(d, 1.0f), zero = hn::Zero(d), least = hn::Set(d, 1e-20f);
  const Vec whole = lobe.Cumulative(v.sine);
  const Vec part = Integral(zero, whole, [&](Vec u) HWY_ATTR {
    const Vec c = lobe.Cosine(u), s = RootOf(one - c * c);
    return Angle(hn::Neg(c * v.n_dot_v) / hn::Max(s * v.sine, least)).angle;
  });
  hn::StoreU((one - whole) + part * hn::Set(d, simd::HWY_NAMESPACE::kInvPi), d, to);
}

/// Half vectors h around n, whose light has the solid angle 4 v.h. Up to half of the angle between v and the surface,
/// all azimuths of h have n.l > 0; farther away, those of an arc. The sums of v.h and of (v.h)^2 over arcs are known.
void SumBlinnPhong(PowerLobe lobe, const Eye& v, float* to, float* to_cosine) {
  const Tag d;
  const Vec one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
  const Vec q = hn::Set(d, lobe.precision), nv = v.n_dot_v, sv = v.sine;
  const Vec near = hn::Sqrt(half + half * sv), far = half * nv / near;  // cosines of both ends of the arcs
  const Vec from = lobe.Cumulative(far), whole = lobe.Cumulative(near);
  const auto power = [&](float m, Vec end) HWY_ATTR { return q / (q + hn::Set(d, m)) * (one - whole * end); };
  const Vec first = power(1.0f, near), third = power(3.0f, near * near * near);  // integrals of c and c^3
  const Vec nv2 = nv * nv, sv2 = sv * sv;
  const auto arc = [&](bool cosine) HWY_ATTR {
    return hn::Set(d, simd::HWY_NAMESPACE::kInvPi) * Integral(from, whole, [&](Vec u) HWY_ATTR {
             const Vec c = lobe.Cosine(u), s = RootOf(one - c * c), a = c * nv, b = s * sv;
             const Angle phi = LitArc(v, c, s);
             const Vec sum = a * phi.angle + b * phi.sine;
             if (!cosine) return sum;
             const Vec squares = a * (sum + b * phi.sine) + half * (b * b) * (phi.angle + phi.sine * phi.cosine);
             return (c + c) * squares - nv * sum;
           });
  };
  hn::StoreU(nv * first + arc(false), d, to);
  hn::StoreU((nv2 + nv2 - sv2) * third + (sv2 - nv2) * first + arc(true), d, to_cosine);
}

/// The inverse of PrecisionLog2().
double precision_at(double t) {
  const double whole = std::floor(t);
  return std::ldexp(1.0 + (t - whole), static_cast<int>(whole));
}

}  // namespace

void ComputeLobeTable(LobeTable* out) {
  const Tag d;
  const Vec one = hn::Set(d, 1.0f), last = hn::Set(d, kLobeColumns - 1.0f);
  const Disc disc = make_disc();
  for (uint32_t column = 0; column < kLobeColumns; column += static_cast<uint32_t>(hn::Lanes(d))) {
    const Vec x = hn::Iota(d, static_cast<float>(column)) / last, rest = one - x;
    const Vec root = hn::Set(d, kGgxLeastRoot) + hn::Set(d, 1.0f - kGgxLeastRoot) * x, r2 = root * root, r4 = r2 * r2;
    const Eye ggx(hn::Min(r4 * r4, one)), phong(one - rest * rest), blinn(x * x);
    SumDiffuse(disc, ggx, out->diffuse + column);
    for (uint32_t row = 0; row < kGgxRows; ++row) {
      const double precision = precision_at(static_cast<double>(row) / kGgxRowsPerOctave);
      GgxSum(static_cast<float>(1.0 / precision), ggx)
          .Store(out->ggx_f0.at[row] + column, out->ggx_f90.at[row] + column);
    }
    // The limit of narrow lobes. Half of a lobe is above a surface seen from its side.
    hn::StoreU(hn::IfThenElse(hn::Gt(phong.n_dot_v, hn::Zero(d)), one, hn::Set(d, 0.5f)), d, out->phong.at[0] + column);
    hn::StoreU(blinn.n_dot_v, d, out->blinn_phong.at[0] + column);
    hn::StoreU(blinn.n_dot_v * blinn.n_dot_v, d, out->blinn_phong_cosine.at[0] + column);
    for (uint32_t row = 1; row < kPhongRows; ++row) {
      const float width = (kPhongRows - 1.0f) / static_cast<float>(row);
      SumPhong({width * width}, phong, out->phong.at[row] + column);
      SumBlinnPhong({width * width}, blinn, out->blinn_phong.at[row] + column,
                    out->blinn_phong_cosine.at[row] + column);
    }
  }
}

}  // namespace shd::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::environment {

HWY_EXPORT(ComputeLobeTable);

const LobeTable& lobe_table() {
  static LobeTable table;
  static std::once_flag once;
  std::call_once(once, [] { SHD_DISPATCH(ComputeLobeTable, core::find_simd_target(SHD_SIMD_BEST))(&table); });
  return table;
}

}  // namespace shd::environment
#endif  // HWY_ONCE
