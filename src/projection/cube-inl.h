// SPDX-License-Identifier: MIT
// SHD_PROJECTION_CUBE: six faces, +X, -X, +Y, -Y, +Z, -Z.

#if defined(SHD_PROJECTION_CUBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROJECTION_CUBE_INL_H_
#undef SHD_PROJECTION_CUBE_INL_H_
#else
#define SHD_PROJECTION_CUBE_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "projection/direction-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::projection::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Cube {
  using V = hn::Vec<D>;
  using VI = hn::Vec<hn::RebindToSigned<D>>;
  static constexpr uint32_t kFaces = 6;
  static constexpr bool kRepeats = false, kStretches = false;

  V u, v;
  VI face;
  hn::Mask<D> on_z, on_y;  // axis of the face; X where neither is set
  V sign;                  // bit of the sign of the component along the axis
  V s, t;                  // 2u - 1 and 2v - 1

  HWY_INLINE Cube(D d, const Vec3V<V>& n) {
    const hn::RebindToSigned<D> di;
    const V x = hn::Abs(n.x), y = hn::Abs(n.y), z = hn::Abs(n.z), half = hn::Set(d, 0.5f);
    on_z = hn::And(hn::Ge(z, x), hn::Ge(z, y));
    on_y = hn::AndNot(on_z, hn::Ge(y, x));
    const V axis = hn::IfThenElse(on_z, n.z, hn::IfThenElse(on_y, n.y, n.x));
    sign = hn::And(axis, hn::Set(d, -0.0f));
    // The component along the axis has the magnitude 1.
    s = across(n);
    t = down(n);
    u = half * s + half;
    v = half * t + half;
    const VI pair = hn::BitCast(di, hn::IfThenElse(on_z, hn::BitCast(d, hn::Set(di, 4)),
                                                   hn::IfThenElseZero(on_y, hn::BitCast(d, hn::Set(di, 2)))));
    face = pair - hn::ShiftRight<8 * sizeof(hn::TFromD<D>) - 1>(hn::BitCast(di, sign));
  }

  /// Change of (u, v) with a change of n, on the plane of the face.
  HWY_INLINE StepV<V> step(D d, const Vec3V<V>& dn) const {
    const V half = hn::Set(d, 0.5f);
    const V outwards = hn::Xor(sign, hn::IfThenElse(on_z, dn.z, hn::IfThenElse(on_y, dn.y, dn.x)));
    return {half * (across(dn) - s * outwards), half * (down(dn) - t * outwards)};
  }

  HWY_INLINE StepV<V> even_step(D d, const Vec3V<V>& dn) const { return step(d, dn); }
  HWY_INLINE V stretch(D d) const { return hn::Set(d, 1.0f); }

  /// Unit direction of a point with u and v in [0, 1], and the solid angle per area of (u, v).
  static HWY_INLINE Vec3V<V> direction(D d, V u, V v, VI face, V* solid_angle) {
    const hn::RebindToSigned<D> di;
    const V one = hn::Set(d, 1.0f), s = (u + u) - one, t = (v + v) - one;
    const V inverse = one / hn::Sqrt((s * s + t * t) + one);
    *solid_angle = hn::Set(d, 4.0f) * (inverse * inverse * inverse);
    const V sign = hn::BitCast(d, hn::ShiftLeft<31>(face));
    const auto z = hn::RebindMask(d, hn::Gt(face, hn::Set(di, 3)));
    const auto y = hn::AndNot(z, hn::RebindMask(d, hn::Gt(face, hn::Set(di, 1))));
    const V axis = hn::Xor(sign, one), up = hn::Neg(t);
    return {inverse * hn::IfThenElse(z, hn::Xor(sign, s), hn::IfThenElse(y, s, axis)),
            inverse * hn::IfThenElse(y, axis, up),
            inverse * hn::IfThenElse(z, axis, hn::IfThenElse(y, hn::Xor(sign, t), hn::Neg(hn::Xor(sign, s))))};
  }

 private:
  /// Component to the right on the face: -z of +X, z of -X, x of +-Y and +Z, -x of -Z.
  HWY_INLINE V across(const Vec3V<V>& n) const {
    return hn::IfThenElse(on_z, hn::Xor(sign, n.x), hn::IfThenElse(on_y, n.x, hn::Neg(hn::Xor(sign, n.z))));
  }
  /// Component downwards on the face: z of +Y, -z of -Y, otherwise -y.
  HWY_INLINE V down(const Vec3V<V>& n) const { return hn::IfThenElse(on_y, hn::Xor(sign, n.z), hn::Neg(n.y)); }
};

}  // namespace shd::projection::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROJECTION_CUBE_INL_H_
