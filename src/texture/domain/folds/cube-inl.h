// SPDX-License-Identifier: MIT
// The fold of CUBE: beyond an edge lies the adjacent face. The texel beyond a corner does not exist.

#if defined(SHD_TEXTURE_FOLDS_CUBE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FOLDS_CUBE_INL_H_
#undef SHD_TEXTURE_FOLDS_CUBE_INL_H_
#else
#define SHD_TEXTURE_FOLDS_CUBE_INL_H_
#endif

#include <hwy/highway.h>

#include "projection/cube-inl.h"
#include "texture/domain/folds/folded-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Vec3V;

/// Vector of a point (s, t) of the plane at `axis` of a face of the cube.
template <class D, class V>
HWY_INLINE Vec3V<V> CubeVector(D d, Ints<D> face, V s, V t, V axis) {
  const hn::RebindToSigned<D> di;
  const V sign = hn::BitCast(d, hn::ShiftLeft<31>(face)), up = hn::Neg(t), out = hn::Xor(axis, sign);
  const auto z = hn::RebindMask(d, hn::Gt(face, hn::Set(di, 3)));
  const auto y = hn::AndNot(z, hn::RebindMask(d, hn::Gt(face, hn::Set(di, 1))));
  return {hn::IfThenElse(z, hn::Xor(sign, s), hn::IfThenElse(y, s, out)), hn::IfThenElse(y, out, up),
          hn::IfThenElse(z, out, hn::IfThenElse(y, hn::Xor(sign, t), hn::Neg(hn::Xor(sign, s))))};
}

struct CubeFold : FoldBase<CubeFold> {
  static constexpr bool kLacksCorners = true;
  static constexpr bool kHasPlanes = true;

  /// The texel of the adjacent face. Texel centres are odd or even numbers -(n - 1)..n - 1 on a cube of half width n. A
  /// texel beyond an edge becomes the one of the adjacent face on its grid line, at most the last one of the line. A
  /// texel beyond a corner becomes the one beyond the left or the right edge, in the row beside the corner.
  template <class D>
  static HWY_INLINE FoldedTexel<D> texel(D d, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y, Ints<D> face) {
    using V = hn::Vec<D>;
    const V one = hn::Set(d, 1.0f), size = level.across.real, last = size - one, half = hn::Set(d, 0.5f);
    const V s = (x + x) - last, t = (y + y) - last;
    const auto out_s = hn::Gt(hn::Abs(s), size), out_t = hn::AndNot(out_s, hn::Gt(hn::Abs(t), size));
    const V bounded_s = hn::IfThenElse(out_s, hn::CopySign(size, s), s);
    const V inner_t = hn::Min(hn::Max(t, hn::Neg(last)), last);
    const V bounded_t = hn::IfThenElse(out_t, hn::CopySign(size, t), inner_t);
    const V beyond = hn::IfThenElse(out_s, hn::Abs(s), hn::Abs(t));
    const V depth = hn::Max(size + size - beyond, hn::Neg(last));  // the first texel is at `last`
    const V axis = hn::IfThenElse(hn::Or(out_s, out_t), depth, size);
    const projection::HWY_NAMESPACE::Cube<D> cube(d, CubeVector(d, face, bounded_s, bounded_t, axis));
    return {(cube.s + last) * half, (cube.t + last) * half, cube.face};
  }

  /// (u, v) lies on the plane of the face.
  template <class D>
  static HWY_INLINE FoldedPoint<D> point(D d, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
    using V = hn::Vec<D>;
    const V one = hn::Set(d, 1.0f);
    const V limit = hn::Set(d, 0x1p30f);
    const V s = hn::Min(hn::Max((u + u) - one, hn::Neg(limit)), limit);
    const V t = hn::Min(hn::Max((v + v) - one, hn::Neg(limit)), limit);
    const V scale = one / hn::Max(hn::Max(hn::Abs(s), hn::Abs(t)), one);
    const projection::HWY_NAMESPACE::Cube<D> cube(d, CubeVector(d, face, s * scale, t * scale, scale));
    return {cube.u, cube.v, cube.face};
  }

  template <class D>
  static HWY_INLINE PointRates<D> rates(D d, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    const V s = (u + u) - one, t = (v + v) - one;
    const V limit = hn::Set(d, 0x1p30f);
    const V in_s = hn::Min(hn::Max(s, hn::Neg(limit)), limit), in_t = hn::Min(hn::Max(t, hn::Neg(limit)), limit);
    const V scale = one / hn::Max(hn::Max(hn::Abs(in_s), hn::Abs(in_t)), one);
    const projection::HWY_NAMESPACE::Cube<D> cube(d, CubeVector(d, face, in_s * scale, in_t * scale, scale));
    const auto right = cube.step(d, CubeVector(d, face, two * scale, zero, zero));
    const auto down = cube.step(d, CubeVector(d, face, zero, two * scale, zero));
    return {right.du, down.du, right.dv, down.dv};
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FOLDS_CUBE_INL_H_
