// SPDX-License-Identifier: MIT
// Points projected onto a shadow map, and the loop of all filters over a batch of points.

#if defined(SHD_LIGHT_SHADOW_RECEIVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_LIGHT_SHADOW_RECEIVER_INL_H_
#undef SHD_LIGHT_SHADOW_RECEIVER_INL_H_
#else
#define SHD_LIGHT_SHADOW_RECEIVER_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

#include "light/shadow.h"
#include "simd/finite-inl.h"
#include "simd/gather-inl.h"
#include "simd/hash-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::FiniteOrZero;
using simd::HWY_NAMESPACE::GatherPairs;
using simd::HWY_NAMESPACE::IsFinite;
using simd::HWY_NAMESPACE::kWeylStep;
using simd::HWY_NAMESPACE::MixBits;
using simd::HWY_NAMESPACE::Set3;
using simd::HWY_NAMESPACE::Vec3V;

constexpr size_t kMaxReceiverLanes = 16;
template <class D>
using ShadowInts = hn::Vec<hn::RebindToSigned<D>>;
template <class D>
using ShadowBits = hn::Vec<hn::RebindToUnsigned<D>>;

/// Points projected onto a map. The plane of the surface has the depth z + dx i + dy j at i texels to the right of the
/// point and j texels below it.
template <class D>
struct Receiver {
  hn::Vec<D> x, y;       // texel coordinates, 0..size; 0 where not inside
  hn::Vec<D> z;          // depth, biased; finite where inside
  hn::Vec<D> bias;       // by which z is nearer to the light than the point
  hn::Vec<D> texel;      // world length of a texel's side at z, > 0
  hn::Vec<D> dx, dy;     // slope of the surface per texel; 0 without normals
  hn::Mask<D> inside;    // all other lanes are lit
  ShadowInts<D> face;    // number of the face
  ShadowBits<D> random;  // a hash of the position
};

/// A vector in the axes of a face.
template <class V>
struct FaceVector {
  V right, down, forward;
};

template <class D, class V>
HWY_INLINE FaceVector<V> ToFace(D d, const ShadowAxes& axes, const Vec3V<V>& a) {
  return {Dot(a, Set3(d, axes.right)), Dot(a, Set3(d, axes.down)), Dot(a, Set3(d, axes.forward))};
}

/// The face of a cube that a vector points at; if two components are equally long, the later axis.
template <class D>
struct CubeFace {
  hn::Mask<D> is_x, is_z, negative;  // axis y if neither is_x nor is_z

  template <class V>
  HWY_INLINE CubeFace(D d, const Vec3V<V>& q) {
    const V ax = hn::Abs(q.x), ay = hn::Abs(q.y), az = hn::Abs(q.z);
    is_z = hn::And(hn::Ge(az, ax), hn::Ge(az, ay));
    is_x = hn::AndNot(is_z, hn::Gt(ax, ay));
    negative = hn::Lt(hn::IfThenElse(is_x, q.x, hn::IfThenElse(is_z, q.z, q.y)), hn::Zero(d));
  }
  template <class V>
  HWY_INLINE FaceVector<V> vector(const Vec3V<V>& a) const {
    const V major = hn::IfThenElse(is_x, a.x, hn::IfThenElse(is_z, a.z, a.y));
    const V next = hn::IfThenElse(is_x, a.y, hn::IfThenElse(is_z, a.x, a.z));
    const V last = hn::IfThenElse(is_x, a.z, hn::IfThenElse(is_z, a.y, a.x));
    return {hn::IfThenElse(negative, last, next), hn::IfThenElse(negative, next, last),
            hn::IfThenElse(negative, hn::Neg(major), major)};
  }
  HWY_INLINE ShadowInts<D> number(D d) const {
    const hn::RebindToSigned<D> di;
    const auto axis = hn::IfThenElse(is_x, hn::Zero(d), hn::IfThenElse(is_z, hn::Set(d, 4.0f), hn::Set(d, 2.0f)));
    return hn::ConvertTo(di, axis + hn::IfThenElseZero(negative, hn::Set(d, 1.0f)));
  }
};

template <class D, class V>
HWY_INLINE V Clamp(D d, V value, float low, float high) {
  return hn::Min(hn::Max(value, hn::Set(d, low)), hn::Set(d, high));
}

/// The receiver at q, relative to the origin of the map, on a surface with normal n, both in the axes of the face.
/// @param has_normal  lanes with a normal
template <class D, class V, class M>
HWY_INLINE Receiver<D> ReceiverOnFace(D d, const Shadow& shadow, const FaceVector<V>& q, const FaceVector<V>& n,
                                      M has_normal) {
  const ShadowPlacement& placement = shadow.map.placement;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), size = hn::Set(d, static_cast<float>(shadow.map.size));
  const V centre = size * hn::Set(d, 0.5f), scale = hn::Set(d, placement.scale);
  const bool is_perspective = placement.projection != ShadowProjection::kOrthographic;
  const auto in_front = is_perspective ? hn::Gt(q.forward, zero) : IsFinite(d, q.forward);
  const V w = is_perspective ? hn::IfThenElse(in_front, q.forward, one) : one;
  const V a = q.right / w, b = q.down / w;
  const V x = centre + scale * a, y = centre + scale * b;
  const auto in_x = hn::And(hn::Ge(x, zero), hn::Le(x, size)), in_y = hn::And(hn::Ge(y, zero), hn::Le(y, size));

  Receiver<D> at;
  at.inside = hn::And(hn::And(in_front, IsFinite(d, q.forward)), hn::And(in_x, in_y));
  at.x = hn::IfThenElseZero(at.inside, x);
  at.y = hn::IfThenElseZero(at.inside, y);
  at.texel = hn::IfThenElse(at.inside, w, one) / scale;
  V facing = n.forward;
  if (is_perspective) facing = facing + (n.right * a + n.down * b);
  const V steep = hn::CopySign(hn::Max(hn::Abs(hn::IfThenElseZero(has_normal, facing)), hn::Set(d, 1e-6f)), facing);
  const auto slope = [&](V component) {
    const V s = hn::Neg(hn::IfThenElseZero(has_normal, component)) / steep;
    return Clamp(d, FiniteOrZero(d, s), -kMaxSlope, kMaxSlope);
  };
  const V slope_x = slope(n.right), slope_y = slope(n.down);
  at.dx = at.texel * slope_x;
  at.dy = at.texel * slope_y;
  const ShadowOptions& options = shadow.options;
  const V unknown = hn::Set(d, unknown_steepness(options));
  const V slopes = hn::Abs(slope_x) + hn::Abs(slope_y);
  const V known = hn::Min(slopes, hn::Set(d, kMaxSteepness)) + hn::Set(d, kSteepnessSlack);
  const V steepness = hn::IfThenElse(has_normal, known, unknown);
  const V guard =
      hn::Set(d, options.bias + placement.guard) + hn::Set(d, placement.guard_square) * (q.forward * q.forward);
  at.bias = guard + hn::Set(d, options.bias_slope) * (steepness * at.texel);
  at.z = hn::IfThenElseZero(at.inside, q.forward - at.bias);
  return at;
}

/// The receiver at points with or without normals.
template <class D, class V>
HWY_INLINE Receiver<D> MakeReceiver(D d, const Shadow& shadow, const Vec3V<V>& position, const Vec3V<V>& normal,
                                    bool has_normals) {
  const hn::RebindToSigned<D> di;
  const ShadowPlacement& placement = shadow.map.placement;
  const V zero = hn::Zero(d);
  const auto usable = IsFinite(d, normal);
  const auto has_normal = has_normals ? usable : hn::Lt(zero, zero);
  const V offset = hn::Set(d, shadow.options.normal_offset);
  const auto from_origin = [&](V p, V n, float origin) {
    const V shift = hn::IfThenElseZero(has_normal, n * offset);
    return p - hn::Set(d, origin) + shift;
  };
  const Vec3V<V> q = {from_origin(position.x, normal.x, placement.origin[0]),
                      from_origin(position.y, normal.y, placement.origin[1]),
                      from_origin(position.z, normal.z, placement.origin[2])};
  if (placement.projection != ShadowProjection::kCube) {
    Receiver<D> at =
        ReceiverOnFace(d, shadow, ToFace(d, placement.axes, q), ToFace(d, placement.axes, normal), has_normal);
    at.face = hn::Zero(di);
    return at;
  }
  const CubeFace<D> face(d, q);
  Receiver<D> at = ReceiverOnFace(d, shadow, face.vector(q), face.vector(normal), has_normal);
  at.face = face.number(d);
  return at;
}

/// A hash of the bits of a position in world space, which depends on nothing else: neither on tiles and batches nor on
/// the pixel grid. Hashes of words are nested (Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3),
/// 2020, 4.2).
template <class D, class V>
HWY_INLINE ShadowBits<D> HashPosition(D, const Vec3V<V>& p) {
  const hn::RebindToUnsigned<D> du;
  const auto z = MixBits(du, hn::BitCast(du, p.z) + hn::Set(du, kWeylStep));
  return MixBits(du, hn::BitCast(du, p.x) + MixBits(du, hn::BitCast(du, p.y) + z));
}

/// Calls filter(d, receiver) for every point, in vectors of D.
template <class D, class Filter>
HWY_INLINE void ForEachReceiver(const Shadow& shadow, const ShadowLookups& in, float* visibility,
                                const Filter& filter) {
  const D d;
  using V = hn::Vec<D>;
  const size_t lanes = hn::Lanes(d);
  const bool has_normals = in.normal[0] != nullptr;
  alignas(64) float tail[6][kMaxReceiverLanes];
  alignas(64) float tail_out[kMaxReceiverLanes];
  for (size_t i = 0; i < in.count; i += lanes) {
    const size_t left = in.count - i;
    const float* column[6];
    for (size_t c = 0; c < 6; ++c) {
      const float* from = c < 3 ? in.position[c] : in.normal[c - 3];
      column[c] = from ? from + i : nullptr;
      if (left >= lanes || !from) continue;
      std::memset(tail[c], 0, sizeof tail[c]);
      std::memcpy(tail[c], from + i, left * sizeof(float));
      column[c] = tail[c];
    }
    const Vec3V<V> p = {hn::LoadU(d, column[0]), hn::LoadU(d, column[1]), hn::LoadU(d, column[2])};
    Vec3V<V> n = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    if (has_normals) n = {hn::LoadU(d, column[3]), hn::LoadU(d, column[4]), hn::LoadU(d, column[5])};
    Receiver<D> at = MakeReceiver(d, shadow, p, n, has_normals);
    at.random = HashPosition(d, p);
    const V lit = hn::Set(d, 1.0f);
    const V value = hn::AllFalse(d, at.inside) ? lit : hn::IfThenElse(at.inside, filter(d, at), lit);
    if (left >= lanes) {
      hn::StoreU(value, d, visibility + i);
    } else {
      hn::Store(value, d, tail_out);
      std::memcpy(visibility + i, tail_out, left * sizeof(float));
    }
  }
}

using ReceiverTag = hn::CappedTag<float, kMaxReceiverLanes>;

/// Index of a texel in the face or its padding.
template <class D, class V>
HWY_INLINE ShadowInts<D> TexelIndex(D, const ShadowMap& map, ShadowInts<D> face, V column, V row) {
  const hn::RebindToSigned<D> di;
  const auto first = face * hn::Set(di, static_cast<int32_t>(map.face_stride)) +
                     hn::Set(di, static_cast<int32_t>(map.pad * (map.pitch + 1)));
  const auto start = hn::ConvertTo(di, row) * hn::Set(di, static_cast<int32_t>(map.pitch));
  return first + (start + hn::ConvertTo(di, column));
}

/// Depth of the plane of the surface at the centre of a texel.
template <class D, class V>
HWY_INLINE V PlaneDepth(D d, const Receiver<D>& at, V column, V row) {
  const V half = hn::Set(d, 0.5f);
  const V across = at.dx * (column + half - at.x);
  return at.z + (across + at.dy * (row + half - at.y));
}

template <class D>
HWY_INLINE hn::Vec<D> GatherDepths(D d, const ShadowMap& map, ShadowInts<D> index) {
  return hn::GatherIndex(d, map.depth.data(), index);
}

/// Chebyshev's inequality (Donnelly and Lauritzen, "Variance Shadow Maps", 2006): an upper bound of the fraction of
/// depths that are at least z, with light bleeding reduced (Lauritzen 2007, 8.4.2).
template <class D, class V>
HWY_INLINE V Chebyshev(D d, const ShadowOptions& options, V z, V mean, V variance) {
  const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  const V away = z - mean;
  const V square = away * away;
  const V spread = hn::Max(variance, hn::Set(d, options.min_variance));
  const V sum = spread + square;
  const auto beyond = hn::And(hn::Gt(away, zero), hn::Gt(sum, zero));
  const V bound = spread / hn::IfThenElse(beyond, sum, one);
  const V bleed = hn::Set(d, options.bleed);
  const V reduced = hn::Max(bound - bleed, zero) / (one - bleed);
  return hn::IfThenElse(beyond, hn::Min(reduced, one), one);
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_LIGHT_SHADOW_RECEIVER_INL_H_
