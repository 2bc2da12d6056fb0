// SPDX-License-Identifier: MIT
// Texels beside the edges of an image of directions: where the directions continue.
//
//   LAT_LONG      u repeats; beyond a pole the rows go on along the opposite meridian
//   CUBE          the adjacent face; the texel beyond a corner does not exist
//   OCTAHEDRAL    an edge is folded in its middle: the row or column beside it, in reverse order
//   MIRROR_BALL,  beyond the rim, at a distance r > 1 from the centre, the image goes on at 2 - r on the other side
//   ANGULAR
//
// Texels are given by whole numbers x and y as floats, -1..size, and -2..size + 1 for FoldFar().

#if defined(SHD_TEXTURE_FOLD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FOLD_INL_H_
#undef SHD_TEXTURE_FOLD_INL_H_
#else
#define SHD_TEXTURE_FOLD_INL_H_
#endif

#include <hwy/highway.h>

#include "projection/cube-inl.h"
#include "simd/round-inl.h"
#include "texture/store/level-inl.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::Vec3V;

/// A texel of an image, and the face of the image.
template <class D>
struct FoldedTexel {
  hn::Vec<D> x, y;
  Ints<D> face;
};

template <class D, class V>
HWY_INLINE MaskOf<D> IsBeside(D d, V x, V size) {
  return hn::Or(hn::Lt(x, hn::Zero(d)), hn::Ge(x, size));
}

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

/// The texel of the adjacent face. Texel centres are odd or even numbers -(n - 1)..n - 1 on a cube of half width n. A
/// texel beyond an edge becomes the one of the adjacent face on its grid line, at most the last one of the line. A
/// texel beyond a corner becomes the one beyond the left or the right edge, in the row beside the corner.
template <class D>
HWY_INLINE FoldedTexel<D> FoldCube(D d, hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> size, Ints<D> face) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f), last = size - one, half = hn::Set(d, 0.5f);
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

template <class D>
HWY_INLINE FoldedTexel<D> FoldOctahedral(D d, hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> size, Ints<D> face) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d), last = size - hn::Set(d, 1.0f);
  const auto beside_x = IsBeside(d, x, size), beside_y = IsBeside(d, y, size);
  const auto mirrored = [&](V at) SHD_INLINE_LAMBDA {
    const V near = hn::Max(at, hn::Neg(at) - hn::Set(d, 1.0f));
    return hn::Max(hn::Min(near, last + size - near), zero);
  };
  const V in_x = hn::Min(mirrored(x), last), in_y = hn::Min(mirrored(y), last);
  return {hn::IfThenElse(beside_y, last - in_x, in_x), hn::IfThenElse(beside_x, last - in_y, in_y), face};
}

/// The nearest texel to the point at 2 - r, whose centre lies in the disc.
template <class D>
HWY_INLINE FoldedTexel<D> FoldDisc(D d, hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> size, Ints<D> face) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f), zero = hn::Zero(d), last = size - one;
  const V p = (x + x) - last, q = (y + y) - last;  // the radius of the disc is `size`
  const V squared = p * p + q * q;
  const auto outside = hn::Gt(squared, size * size);
  const V r = hn::Sqrt(squared);
  const V inner = hn::Max(hn::Min(two * size - r, size - hn::Set(d, 1.4142136f)), zero);
  const V scale = hn::IfThenElseZero(outside, inner / r);
  const V half = hn::Set(d, 0.5f);
  const V far_x = RoundDown((size - p * scale) * half), far_y = RoundDown((size - q * scale) * half);
  return {hn::IfThenElse(outside, hn::Min(hn::Max(far_x, zero), last), x),
          hn::IfThenElse(outside, hn::Min(hn::Max(far_y, zero), last), y), face};
}

/// Rows beyond a pole are the row beside it; the caller turns the column by half a circle. Columns repeat.
template <class D>
HWY_INLINE FoldedTexel<D> FoldLatLong(D d, hn::Vec<D> x, hn::Vec<D> y, const Level<D>& level, Ints<D> face) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d), width = level.across.real;
  const V last = level.down.real - hn::Set(d, 1.0f);
  const V left = x + hn::IfThenElseZero(hn::Lt(x, zero), width);
  const V column = left - hn::IfThenElseZero(hn::Ge(left, width), width);
  return {column, hn::Min(hn::Max(y, zero), last), face};
}

/// The texel that continues the image at (x, y).
template <class D>
HWY_INLINE FoldedTexel<D> Fold(D d, shd_projection projection, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y,
                               Ints<D> face) {
  const auto size = level.across.real;
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return FoldLatLong(d, x, y, level, face);
    case SHD_PROJECTION_CUBE: return FoldCube(d, x, y, size, face);
    case SHD_PROJECTION_OCTAHEDRAL: return FoldOctahedral(d, x, y, size, face);
    default: return FoldDisc(d, x, y, size, face);
  }
}

/// The texel of LAT_LONG that contains the direction of the centre of (x, y). Beyond a pole of an image of odd width
/// the centre lies between two texels; the result is the right one.
template <class D>
HWY_INLINE FoldedTexel<D> FoldFarLatLong(D d, hn::Vec<D> x, hn::Vec<D> y, const Level<D>& level, Ints<D> face) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f), width = level.across.real;
  const V rows = level.down.real + level.down.real;
  const V row = y - rows * RoundDown(y / rows);
  const auto beyond = hn::Ge(row, level.down.real);
  const V column = x + hn::IfThenElseZero(beyond, RoundDown(width * half + half));
  return {column - width * RoundDown(column / width), hn::IfThenElse(beyond, rows - one - row, row), face};
}

/// The texel that continues the grid of the image at (x, y), at most two texels beyond an edge.
template <class D>
HWY_INLINE FoldedTexel<D> FoldFar(D d, shd_projection projection, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y,
                                  Ints<D> face) {
  if (projection == SHD_PROJECTION_LAT_LONG) return FoldFarLatLong(d, x, y, level, face);
  return Fold(d, projection, level, x, y, face);
}

/// A point of an image, and the face of the image.
template <class D>
struct FoldedPoint {
  hn::Vec<D> u, v;
  Ints<D> face;
};

/// The point inside the image that has the direction of a point outside: probes of a footprint leave the image. For
/// CUBE, (u, v) lies on the plane of the face. Distances of more than one image are cut.
template <class D>
HWY_INLINE FoldedPoint<D> FoldPoint(D d, shd_projection projection, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d), half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
  if (projection == SHD_PROJECTION_CUBE) {
    const V limit = hn::Set(d, 0x1p30f);
    const V s = hn::Min(hn::Max((u + u) - one, hn::Neg(limit)), limit);
    const V t = hn::Min(hn::Max((v + v) - one, hn::Neg(limit)), limit);
    const V scale = one / hn::Max(hn::Max(hn::Abs(s), hn::Abs(t)), one);
    const projection::HWY_NAMESPACE::Cube<D> cube(d, CubeVector(d, face, s * scale, t * scale, scale));
    return {cube.u, cube.v, cube.face};
  }
  if (projection == SHD_PROJECTION_LAT_LONG) {
    const V period = v - two * RoundDown(v * half);  // 0..2
    const auto beyond = hn::Gt(period, one);
    const V around = u + hn::IfThenElseZero(beyond, half);
    return {around - RoundDown(around), hn::IfThenElse(beyond, two - period, period), face};
  }
  u = hn::Min(hn::Max(u, hn::Neg(one)), two);
  v = hn::Min(hn::Max(v, hn::Neg(one)), two);
  if (projection == SHD_PROJECTION_OCTAHEDRAL) {
    const auto beside_u = hn::Or(hn::Lt(u, zero), hn::Gt(u, one)), beside_v = hn::Or(hn::Lt(v, zero), hn::Gt(v, one));
    const V in_u = hn::IfThenElse(hn::Gt(u, one), two - u, hn::Abs(u));
    const V in_v = hn::IfThenElse(hn::Gt(v, one), two - v, hn::Abs(v));
    return {hn::IfThenElse(beside_v, one - in_u, in_u), hn::IfThenElse(beside_u, one - in_v, in_v), face};
  }
  const V p = (u + u) - one, q = (v + v) - one, squared = p * p + q * q;
  const auto outside = hn::Gt(squared, one);
  const V r = hn::Sqrt(squared);
  const V scale = hn::Min(r - two, zero) / hn::Max(r, one);
  return {hn::IfThenElse(outside, half + half * (p * scale), u), hn::IfThenElse(outside, half + half * (q * scale), v),
          face};
}

/// Derivatives of a pair of coordinates in u and v.
template <class D>
struct PointRates {
  hn::Vec<D> u_u, u_v, v_u, v_v;
};

/// Derivatives of FoldPoint() at a point outside the image.
template <class D>
HWY_INLINE PointRates<D> FoldRates(D d, shd_projection projection, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
  const V s = (u + u) - one, t = (v + v) - one;
  if (projection == SHD_PROJECTION_CUBE) {
    const V limit = hn::Set(d, 0x1p30f);
    const V in_s = hn::Min(hn::Max(s, hn::Neg(limit)), limit), in_t = hn::Min(hn::Max(t, hn::Neg(limit)), limit);
    const V scale = one / hn::Max(hn::Max(hn::Abs(in_s), hn::Abs(in_t)), one);
    const projection::HWY_NAMESPACE::Cube<D> cube(d, CubeVector(d, face, in_s * scale, in_t * scale, scale));
    const auto right = cube.step(d, CubeVector(d, face, two * scale, zero, zero));
    const auto down = cube.step(d, CubeVector(d, face, zero, two * scale, zero));
    return {right.du, down.du, right.dv, down.dv};
  }
  if (projection == SHD_PROJECTION_LAT_LONG) {
    const auto beyond = hn::Gt(v - two * RoundDown(v * hn::Set(d, 0.5f)), one);
    return {one, zero, zero, hn::IfThenElse(beyond, hn::Neg(one), one)};
  }
  if (projection == SHD_PROJECTION_OCTAHEDRAL) {
    const auto beside_u = hn::Gt(hn::Abs(s), one), beside_v = hn::Gt(hn::Abs(t), one);
    const auto slope = [&](V x) SHD_INLINE_LAMBDA {
      return hn::IfThenElseZero(hn::Le(hn::Abs(x), hn::Set(d, 3.0f)), one);  // FoldPoint() cuts longer distances
    };
    // Each coordinate is mirrored at its own edges, and by the edges of the other one.
    const auto mirrored = hn::Xor(beside_u, beside_v);
    return {hn::IfThenElse(mirrored, hn::Neg(slope(s)), slope(s)), zero, zero,
            hn::IfThenElse(mirrored, hn::Neg(slope(t)), slope(t))};
  }
  // (p, q) becomes (1 - 2 / r) (p, q).
  const auto cut = [&](V x) SHD_INLINE_LAMBDA { return hn::Min(hn::Max(x, hn::Set(d, -3.0f)), hn::Set(d, 3.0f)); };
  const V p = cut(s), q = cut(t), squared = p * p + q * q, r = hn::Sqrt(squared);
  const auto outside = hn::Gt(squared, one), beyond = hn::Gt(r, two);
  const V scale = hn::Min(r - two, zero) / hn::Max(r, one);
  const V turn = hn::IfThenZeroElse(beyond, two / hn::Max(squared * r, one));
  const V u_u = hn::IfThenElse(outside, scale + turn * p * p, one),
          v_v = hn::IfThenElse(outside, scale + turn * q * q, one);
  const V cross = hn::IfThenElseZero(outside, turn * p * q);
  const auto free_p = hn::Eq(p, s), free_q = hn::Eq(q, t);
  return {hn::IfThenElseZero(free_p, u_u), hn::IfThenElseZero(free_q, cross), hn::IfThenElseZero(free_p, cross),
          hn::IfThenElseZero(free_q, v_v)};
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FOLD_INL_H_
