// SPDX-License-Identifier: MIT
// Values of a triangle's planes at vectors of pixels.

#if defined(SHD_RASTER_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_PLANES_INL_H_
#undef SHD_RASTER_PLANES_INL_H_
#else
#define SHD_RASTER_PLANES_INL_H_
#endif

#include <hwy/highway.h>

#include "raster/attribute-inl.h"
#include "raster/planes.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Pixels relative to the middle of the cell.
template <class V>
struct PixelsAt {
  V x, y;
};

/// A value that is equal in all lanes, in memory: an operand of an instruction, where a float takes one to spread it.
struct Wide {
  alignas(64) float lane[16];
};

/// The vector of a value.
template <class D>
HWY_INLINE hn::Vec<D> Spread(D d, float value) {
  return hn::Set(d, value);
}
template <class D>
HWY_INLINE hn::Vec<D> Spread(D d, const Wide& value) {
  static_assert(hn::MaxLanes(d) <= 16);
  return hn::Load(d, value.lane);
}

template <class D, class T, class V = hn::Vec<D>>
HWY_INLINE V ValueOf(D d, const PlaneOf<T>& plane, const PixelsAt<V>& at) {
  return (Spread(d, plane.at_middle) + Spread(d, plane.dy) * at.y) + Spread(d, plane.dx) * at.x;
}

/// Inverse of the plane `inverse_w`.
template <class D, class T, class V = hn::Vec<D>>
HWY_INLINE V FactorOf(D d, const PlaneOf<T>& inverse_w, const PixelsAt<V>& at) {
  return hn::Set(d, 1.0f) / hn::Max(ValueOf(d, inverse_w, at), hn::Set(d, kLeastInverseW));
}

/// A value that is linear on the triangle, and its derivatives per pixel.
template <class V>
struct Attribute {
  V value, dx, dy;
};

/// Sets the derivatives of a value by the quotient rule: those of its plane, less its part of those of inverse_w.
template <class D, class T, class V = hn::Vec<D>>
HWY_INLINE Attribute<V> WithSteps(D d, const PlaneOf<T>& plane, const PlaneOf<T>& inverse_w, V factor, V value) {
  return {value, (Spread(d, plane.dx) - value * Spread(d, inverse_w.dx)) * factor,
          (Spread(d, plane.dy) - value * Spread(d, inverse_w.dy)) * factor};
}

/// A texture coordinate, within those of the corners up to a rounding, and its derivatives.
template <class D, class T, class V = hn::Vec<D>>
HWY_INLINE Attribute<V> CoordinateAt(D d, const CoordinatePlaneOf<T>& plane, const PlaneOf<T>& inverse_w, V factor,
                                     const PixelsAt<V>& at) {
  const V raw = ValueOf(d, plane.offset, at) * factor;
  const V offset = hn::Min(hn::Max(raw, Spread(d, plane.low)), Spread(d, plane.high));
  Attribute<V> result = WithSteps(d, plane.offset, inverse_w, factor, offset);
  result.value = Spread(d, plane.base) + offset;
  return result;
}

/// Barycentric coordinates: >= 0, sum 1.
template <class V>
struct Barycentric {
  V b0, b1, b2;
};

template <class D, class T, class V = hn::Vec<D>>
HWY_INLINE Barycentric<V> WeightsAt(D d, const TrianglePlanesOf<T>& planes, V factor, const PixelsAt<V>& at) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  Barycentric<V> b;
  b.b1 = hn::Min(hn::Max(ValueOf(d, planes.b1, at) * factor, zero), one);
  b.b2 = hn::Min(hn::Max(ValueOf(d, planes.b2, at) * factor, zero), one - b.b1);
  b.b0 = one - b.b1 - b.b2;
  return b;
}

/// An attribute of a triangle: its value at corner 0, and the differences of the others to it.
template <class T>
struct SidesOf {
  T origin, side1, side2;

  /// The value where no difference overflows.
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V At(D d, const Barycentric<V>& b) const {
    return PlainBlend(Spread(d, origin), Spread(d, side1), Spread(d, side2), b.b1, b.b2);
  }
};
using Sides = SidesOf<float>;

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_RASTER_PLANES_INL_H_
