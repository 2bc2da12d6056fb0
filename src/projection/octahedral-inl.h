// SPDX-License-Identifier: MIT
// SHD_PROJECTION_OCTAHEDRAL: an octahedron unfolded into a square (Cigolle et al., "A Survey of Efficient
// Representations for Independent Unit Vectors", 2014).

#if defined(SHD_PROJECTION_OCTAHEDRAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROJECTION_OCTAHEDRAL_INL_H_
#undef SHD_PROJECTION_OCTAHEDRAL_INL_H_
#else
#define SHD_PROJECTION_OCTAHEDRAL_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "projection/direction-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::projection::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Octahedral {
  using V = hn::Vec<D>;
  using VI = hn::Vec<hn::RebindToSigned<D>>;
  static constexpr uint32_t kFaces = 1;
  static constexpr bool kRepeats = false, kStretches = false;

  V a, b;  // on the square, -1..1: a points right and b up
  V u, v;
  VI face;
  V sign_x, sign_y, sign_z;  // sign bits; those of zeros are 0
  V p, q;                    // on the octahedron
  V inverse;                 // 1 / (|x| + |y| + |z|)
  hn::Mask<D> behind;

  HWY_INLINE Octahedral(D d, const Vec3V<V>& n)
      : Octahedral(d, n, hn::Set(d, 1.0f) / (hn::Abs(n.x) + hn::Abs(n.y) + hn::Abs(n.z))) {}
  HWY_INLINE Octahedral(D d, const Vec3V<V>& n, V inverse_sum) : inverse(inverse_sum) {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    behind = hn::Lt(n.z, zero);
    sign_x = sign_of(d, n.x), sign_y = sign_of(d, n.y), sign_z = sign_of(d, n.z);
    p = n.x * inverse, q = n.y * inverse;
    a = hn::IfThenElse(behind, hn::Xor(one - hn::Abs(q), sign_x), p);
    b = hn::IfThenElse(behind, hn::Xor(one - hn::Abs(p), sign_y), q);
    u = half + half * a;
    v = half - half * b;
    face = hn::Zero(hn::RebindToSigned<D>());
  }

  /// Change of (u, v) with a change of n.
  HWY_INLINE StepV<V> step(D d, const Vec3V<V>& dn) const {
    const V sum = (hn::Xor(dn.x, sign_x) + hn::Xor(dn.y, sign_y)) + hn::Xor(dn.z, sign_z);
    const V dp = (dn.x - p * sum) * inverse, dq = (dn.y - q * sum) * inverse;
    const V both = hn::Xor(sign_x, sign_y), half = hn::Set(d, 0.5f);
    const V da = hn::IfThenElse(behind, hn::Neg(hn::Xor(dq, both)), dp);
    const V db = hn::IfThenElse(behind, hn::Neg(hn::Xor(dp, both)), dq);
    return {half * da, hn::Neg(half * db)};
  }

  HWY_INLINE StepV<V> even_step(D d, const Vec3V<V>& dn) const { return step(d, dn); }
  HWY_INLINE V stretch(D d) const { return hn::Set(d, 1.0f); }

  /// Unit direction of a point with u and v in [0, 1], and the solid angle per area of (u, v).
  static HWY_INLINE Vec3V<V> direction(D d, V u, V v, VI, V* solid_angle) {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), a = (u + u) - one, b = one - (v + v);
    const V z = (one - hn::Abs(a)) - hn::Abs(b);
    const auto behind = hn::Lt(z, zero);
    const V x = hn::IfThenElse(behind, hn::Xor(one - hn::Abs(b), sign_of(d, a)), a);
    const V y = hn::IfThenElse(behind, hn::Xor(one - hn::Abs(a), sign_of(d, b)), b);
    const V scale = one / hn::Sqrt((x * x + y * y) + z * z);
    *solid_angle = hn::Set(d, 4.0f) * (scale * scale * scale);
    return {x * scale, y * scale, z * scale};
  }

 private:
  static HWY_INLINE V sign_of(D d, V x) { return hn::IfThenElseZero(hn::Lt(x, hn::Zero(d)), hn::Set(d, -0.0f)); }
};

}  // namespace shd::projection::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROJECTION_OCTAHEDRAL_INL_H_
