// SPDX-License-Identifier: MIT
// Shapes of lookups in 3D textures. The footprint is the ellipse that a unit circle of pixels covers in base texels, in
// the plane of the two derivatives; its axes are the singular values of the 3 x 2 matrix of derivatives
// (footprint-inl.h).

#if defined(SHD_TEXTURE_PLACES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PLACES_INL_H_
#undef SHD_TEXTURE_PLACES_INL_H_
#else
#define SHD_TEXTURE_PLACES_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/domain/block.h"
#include "texture/domain/footprint-inl.h"
#include "texture/domain/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Ellipsoids of lookups in 3D textures, in texels of their level. A slice at the distance z from the centre cuts the
/// ellipse of EllipseBlock, moved by (slide_x, slide_y) z, with the bound 1 - z^2 / depth2 in place of 1.
struct EllipsoidBlock : EllipseBlock {
  alignas(64) float w[kBlock];
  alignas(64) float slide_x[kBlock], slide_y[kBlock], depth2[kBlock];
};

/// One vector of lookups with three coordinates. NaN and infinite coordinates, NaN derivatives and NaN levels of detail
/// are replaced by 0.
template <class D>
struct Places {
  hn::Vec<D> u, v, w;
  hn::Vec<D> dudx, dvdx, dwdx, dudy, dvdy, dwdy;  // 0 if the lookups have no derivatives
  hn::Vec<D> lod;                                 // 0 if the lookups have no level of detail
  MaskOf<D> finite;                               // lanes whose inputs were all finite
};

template <class D>
SHD_KERNEL_PART Places<D> LoadPlaces(D d, const Lookups& in, size_t i) {
  const auto derivative = [&](const float* column) { return LoadOrZero(d, in.lod ? nullptr : column, i); };
  Places<D> p;
  p.u = hn::LoadU(d, in.u + i);
  p.v = hn::LoadU(d, in.v + i);
  p.w = hn::LoadU(d, in.w + i);
  p.lod = LoadOrZero(d, in.lod, i);
  p.dudx = derivative(in.dudx);
  p.dvdx = derivative(in.dvdx);
  p.dwdx = derivative(in.dwdx);
  p.dudy = derivative(in.dudy);
  p.dvdy = derivative(in.dvdy);
  p.dwdy = derivative(in.dwdy);
  // x - x is 0 for finite x and NaN for others.
  const auto point = (p.u - p.u) + (p.v - p.v) + (p.w - p.w);
  const auto along_x = (p.dudx - p.dudx) + (p.dvdx - p.dvdx) + (p.dwdx - p.dwdx);
  const auto along_y = (p.dudy - p.dudy) + (p.dvdy - p.dvdy) + (p.dwdy - p.dwdy);
  p.finite = hn::Eq((point + (p.lod - p.lod)) + (along_x + along_y), hn::Zero(d));
  if (HWY_UNLIKELY(!hn::AllTrue(d, p.finite))) {
    p.u = FiniteOrZero(d, p.u);
    p.v = FiniteOrZero(d, p.v);
    p.w = FiniteOrZero(d, p.w);
    p.lod = ZeroIfNaN(p.lod);
    for (hn::Vec<D>* value : {&p.dudx, &p.dvdx, &p.dwdx, &p.dudy, &p.dvdy, &p.dwdy}) *value = ZeroIfNaN(*value);
  }
  return p;
}

/// Multiplies the derivatives by the sampler's widths and by the sizes of the base. A width of 0 removes an infinite
/// derivative.
template <class D>
HWY_INLINE void ScalePlaces(D d, const Texture& texture, const Sampler& sampler, Places<D>* p) {
  const auto scale = [&](hn::Vec<D>* value, float width, uint32_t size) {
    if (HWY_UNLIKELY(width != 1.0f)) *value = ZeroIfNaN(*value * hn::Set(d, width));
    *value = *value * hn::Set(d, static_cast<float>(size));
  };
  scale(&p->dudx, sampler.width_x, texture.width);
  scale(&p->dvdx, sampler.width_x, texture.height);
  scale(&p->dwdx, sampler.width_x, texture.depth);
  scale(&p->dudy, sampler.width_y, texture.width);
  scale(&p->dvdy, sampler.width_y, texture.height);
  scale(&p->dwdy, sampler.width_y, texture.depth);
}

/// Fills the columns of a block of places and calls body(d, places, to) for each vector, which writes its shape. The
/// derivatives of `places` are in base texels, with the sampler's width. Returns the number of lookups that were not
/// finite.
template <class Body>
HWY_INLINE size_t FillPlaces(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* out,
                             float* out_w, const Body& body) {
  size_t nonfinite = 0;
  out->count = in.count;
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
    auto places = LoadPlaces(d, from, i);
    if (HWY_UNLIKELY(!hn::AllTrue(d, places.finite))) {
      nonfinite += hn::CountTrue(d, hn::AndNot(places.finite, hn::FirstN(d, in.count - to)));
    }
    hn::Store(ReduceCoordinate(d, sampler.wrap_u, places.u), d, out->u + to);
    hn::Store(ReduceCoordinate(d, sampler.wrap_v, places.v), d, out->v + to);
    hn::Store(ReduceCoordinate(d, sampler.wrap_w, places.w), d, out_w + to);
    ScalePlaces(d, texture, sampler, &places);
    body(d, places, to);
  });
  return nonfinite;
}

/// Squares of the derivatives in base texels, and their product.
template <class D>
struct Squares {
  hn::Vec<D> x, y, xy;
};
template <class D>
HWY_INLINE Squares<D> SquaresOf(const Places<D>& p) {
  return {(p.dudx * p.dudx + p.dvdx * p.dvdx) + p.dwdx * p.dwdx, (p.dudy * p.dudy + p.dvdy * p.dvdy) + p.dwdy * p.dwdy,
          (p.dudx * p.dudy + p.dvdx * p.dvdy) + p.dwdx * p.dwdy};
}

/// Returns log2 of the longer half axis, or of the root mean square of both half axes.
template <class D, class V = hn::Vec<D>>
SHD_KERNEL_PART V LambdaOfPlaces(D d, const Places<D>& p, bool rms) {
  const V half = hn::Set(d, 0.5f);
  const Squares<D> s = SquaresOf(p);
  if (rms) return HalfLog2(d, half * (s.x + s.y));
  const V mean = half * (s.x + s.y), skew = half * (s.x - s.y);
  return HalfLog2(d, mean + hn::Sqrt(skew * skew + s.xy * s.xy));
}

/// Axes of a footprint, the third component of the unit vector of the longer axis, and the cross product of the
/// derivatives, scaled by a power of two. The product is 0 for parallel and for infinite derivatives.
template <class D>
struct PlaceAxes : FootprintAxes<D> {
  hn::Vec<D> w;
  hn::Vec<D> cross_u, cross_v, cross_w;
};

/// Finds the axes of the footprint of derivatives in base texels, as AxesOf() does.
template <class D>
SHD_KERNEL_PART PlaceAxes<D> AxesOfPlaces(D d, Places<D> p) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const V half = hn::Set(d, 0.5f), zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V largest =
      hn::Max(LargestMagnitude(p.dudx, p.dvdx, p.dudy, p.dvdy), hn::Max(hn::Abs(p.dwdx), hn::Abs(p.dwdy)));
  const auto infinite = hn::Eq(largest, hn::Inf(d));
  const auto exponent = ExponentOf(d, largest);
  const V down = hn::IfThenZeroElse(infinite, PowerOfTwo(d, hn::Neg(exponent)));
  for (V* value : {&p.dudx, &p.dvdx, &p.dwdx, &p.dudy, &p.dvdy, &p.dwdy}) {
    *value = hn::IfThenZeroElse(infinite, *value * down);
  }
  const Squares<D> s = SquaresOf(p);
  const V mean = half * (s.x + s.y), skew = half * (s.x - s.y);
  const V square = mean + hn::Sqrt(skew * skew + s.xy * s.xy);
  const auto round = hn::Lt(square, hn::Set(d, 0x1p-20f));  // derivatives 0 or infinite, or far below every level

  PlaceAxes<D> f;
  const auto near = hn::Min(hn::Max(exponent, hn::Set(di, -31)), hn::Set(di, 31));
  const V bounded = hn::Max(square * PowerOfTwo(d, near + near), hn::Set(d, 0x1p-64f));
  f.square = hn::IfThenElse(infinite, one, bounded);
  f.levels = hn::IfThenElse(infinite, hn::Set(d, 126.0f), hn::ConvertTo(d, exponent - near));
  f.length = hn::Sqrt(square) * PowerOfTwo(d, hn::Min(exponent, hn::Set(di, 98)));
  f.length = hn::IfThenElse(infinite, hn::Set(d, 0x1p100f), f.length);
  // The area of the parallelogram of the derivatives is the product of the half axes.
  f.cross_u = p.dvdx * p.dwdy - p.dwdx * p.dvdy;
  f.cross_v = p.dwdx * p.dudy - p.dudx * p.dwdy;
  f.cross_w = p.dudx * p.dvdy - p.dvdx * p.dudy;
  const V area = hn::Sqrt((f.cross_u * f.cross_u + f.cross_v * f.cross_v) + f.cross_w * f.cross_w);
  f.roundness = hn::IfThenElse(round, one, hn::Min(area / square, one));

  // The eigenvector of J^T J for the larger eigenvalue combines the derivatives to the longer axis.
  const V a = hn::Sqrt(skew * skew + s.xy * s.xy) + hn::Abs(skew);
  const V norm = hn::Sqrt(a * a + s.xy * s.xy);
  const auto any = hn::Lt(norm, hn::Set(d, 0x1p-40f));
  const V long_part = hn::IfThenElse(any, one, a / norm);
  const V short_part = hn::IfThenElse(any, zero, s.xy / norm);
  const auto along_x = hn::Ge(skew, zero);
  const V x = hn::IfThenElse(along_x, long_part, short_part), y = hn::IfThenElse(along_x, short_part, long_part);
  const V u = x * p.dudx + y * p.dudy, v = x * p.dvdx + y * p.dvdy, w = x * p.dwdx + y * p.dwdy;
  const V length = hn::Max(hn::Sqrt((u * u + v * v) + w * w), hn::Set(d, 0x1p-40f));
  f.u = u / length;
  f.v = v / length;
  f.w = w / length;
  return f;
}

/// Returns the sphere of a given level of detail.
template <class D>
HWY_INLINE PlaceAxes<D> RoundPlaceAxes(D d, hn::Vec<D> lod) {
  PlaceAxes<D> f;
  static_cast<FootprintAxes<D>&>(f) = RoundAxes(d, lod);
  f.w = f.cross_u = f.cross_v = f.cross_w = hn::Zero(d);
  return f;
}

/// Finds nothing but the places. This overload and the next two are in shapes.cpp.
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, PlaceBlock* out);

/// Finds the levels of detail of isotropic lookups (FindShapes() of a LodBlock).
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, PlaceLodBlock* out,
                  const LodRange* query = nullptr);

/// Finds probes along the longer axis (FindShapes() of a ProbeBlock).
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, PlaceProbeBlock* out,
                  const LodRange* query = nullptr);

/// Finds ellipsoids; in ellipses.cpp.
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, EllipsoidBlock* out);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PLACES_INL_H_
