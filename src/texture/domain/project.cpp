// SPDX-License-Identifier: MIT
#include "texture/domain/direction.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/domain/project.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "projection/projection-inl.h"
#include "texture/domain/project-inl.h"
#include "texture/domain/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace maps = projection::HWY_NAMESPACE;

using simd::HWY_NAMESPACE::IsFinite;

using Direction = simd::HWY_NAMESPACE::Vec3V<hn::Vec<BatchTag>>;

template <class D, class Map, class V>
HWY_INLINE maps::StepV<V> StepOf(D d, const Map& map, const simd::HWY_NAMESPACE::Vec3V<V>& dn) {
  return map.step(d, dn);
}
template <class D, class V>
HWY_INLINE maps::StepV<V> StepOf(D d, const maps::LatLong<D>& map, const simd::HWY_NAMESPACE::Vec3V<V>& dn) {
  return map.even_step(d, dn);
}

template <class D, class Map>
HWY_INLINE hn::Vec<D> StretchOf(D d, const Map&) {
  return hn::Set(d, 1.0f);
}
template <class D>
HWY_INLINE hn::Vec<D> StretchOf(D d, const maps::LatLong<D>& map) {
  return hn::Min(map.stretch(d), hn::Set(d, 65536.0f));
}

/// Derivatives of a point; infinite in lanes where the change of the direction has an infinite component.
template <class D>
HWY_INLINE maps::StepV<hn::Vec<D>> WithInfinity(D d, const simd::HWY_NAMESPACE::Vec3V<hn::Vec<D>>& dn,
                                                const maps::StepV<hn::Vec<D>>& step) {
  const auto infinity = hn::Set(d, __builtin_inff());
  const auto is_infinite = [&](hn::Vec<D> x) { return hn::Eq(hn::Abs(x), infinity); };
  const auto any = hn::Or(hn::Or(is_infinite(dn.x), is_infinite(dn.y)), is_infinite(dn.z));
  return {hn::IfThenElse(any, infinity, step.du), hn::IfThenElse(any, infinity, step.dv)};
}

/// The directions of a vector of lookups.
HWY_INLINE Direction LoadDirection(BatchTag d, const Lookups& from, size_t i) {
  return {LoadOrZero(d, from.u, i), LoadOrZero(d, from.v, i), LoadOrZero(d, from.w, i)};
}

/// Points of directions with their derivatives.
template <class D>
struct PointV {
  hn::Vec<D> u, v, stretch;
  Ints<D> face;
  hn::Mask<D> finite;
  maps::StepV<hn::Vec<D>> step[2];  // per pixel step in x and in y; set if derivatives are given
};

bool HasSteps(const Lookups& in) {
  return !in.lod && (in.dudx || in.dvdx || in.dwdx || in.dudy || in.dvdy || in.dwdy);
}

/// `load` returns the values of a column, which may be null.
template <template <class> class Map, class D, class Load>
HWY_INLINE PointV<D> PointOf(D d, const Lookups& in, bool steps_given, const Load& load) {
  using Change = simd::HWY_NAMESPACE::Vec3V<hn::Vec<D>>;
  const maps::BoundedDirection<D> direction(d, {load(in.u), load(in.v), load(in.w)});
  const Map<D> map(d, direction.n);
  PointV<D> out = {map.u, map.v, StretchOf(d, map), map.face, direction.valid, {}};
  if (steps_given) {
    const Change steps[2] = {{load(in.dudx), load(in.dvdx), load(in.dwdx)},
                             {load(in.dudy), load(in.dvdy), load(in.dwdy)}};
    out.finite = hn::And(out.finite, hn::And(IsFinite(d, steps[0]), IsFinite(d, steps[1])));
    const bool all_finite = hn::AllTrue(d, out.finite);
    for (int axis = 0; axis < 2; ++axis) {
      const auto step_of = [&](const Change& dn) SHD_INLINE_LAMBDA { return StepOf(d, map, dn); };
      out.step[axis] = direction.derivatives(d, steps[axis], step_of);
      if (HWY_UNLIKELY(!all_finite)) out.step[axis] = WithInfinity(d, steps[axis], out.step[axis]);
    }
  } else if (in.lod) {
    out.finite = hn::And(out.finite, IsFinite(d, load(in.lod)));
  }
  return out;
}

template <template <class> class Map>
size_t Project(const Lookups& in, ProjectedBlock* out) {
  size_t nonfinite = 0;
  const bool steps_given = HasSteps(in);
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto load = [&](const float* column) SHD_INLINE_LAMBDA { return LoadOrZero(d, column, i); };
    const PointV<BatchTag> point = PointOf<Map>(BatchTag(), from, steps_given, load);
    hn::Store(point.u, d, out->u + to);
    hn::Store(point.v, d, out->v + to);
    hn::Store(hn::BitCast(du, point.face), du, out->face + to);
    hn::Store(point.stretch, d, out->stretch + to);
    for (int axis = 0; steps_given && axis < 2; ++axis) {
      hn::Store(point.step[axis].du, d, out->step[2 * axis] + to);
      hn::Store(point.step[axis].dv, d, out->step[2 * axis + 1] + to);
    }
    if (HWY_UNLIKELY(!hn::AllTrue(d, point.finite))) {
      nonfinite += hn::CountTrue(d, hn::AndNot(point.finite, hn::FirstN(d, in.count - to)));
    }
  });
  Lookups& points = out->points;
  points = in;
  points.one_footprint = false;
  points.u = out->u, points.v = out->v, points.w = points.dwdx = points.dwdy = nullptr;
  points.dudx = steps_given ? out->step[0] : nullptr, points.dvdx = steps_given ? out->step[1] : nullptr;
  points.dudy = steps_given ? out->step[2] : nullptr, points.dvdy = steps_given ? out->step[3] : nullptr;
  return nonfinite;
}

template <template <class> class Map>
void FindRates(const Lookups& in, DirectionRates* out) {
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
    const maps::BoundedDirection<BatchTag> direction(d, LoadDirection(d, from, i));
    const Map<BatchTag> map(d, direction.n);
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), largest = hn::Set(d, 0x1.fffffep127f);
    const auto bounded = [&](auto x) SHD_INLINE_LAMBDA {
      return hn::IfThenElseZero(direction.valid, hn::Min(hn::Max(x, hn::Neg(largest)), largest));
    };
    for (int axis = 0; axis < 3; ++axis) {
      const Direction unit = {axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero};
      const auto step =
          direction.derivatives(d, unit, [&](const Direction& dn) SHD_INLINE_LAMBDA { return map.step(d, dn); });
      hn::Store(bounded(step.du), d, out->u[axis] + to);
      hn::Store(bounded(step.dv), d, out->v[axis] + to);
    }
  });
}

template <template <class> class Map>
DirectionPoint FindPoint(const Lookups& in, size_t i) {
  const hn::CappedTag<double, 1> d;
  const bool steps_given = HasSteps(in);
  const auto load = [&](const float* column) { return hn::Set(d, column ? static_cast<double>(column[i]) : 0.0); };
  const auto point = PointOf<Map>(d, in, steps_given, load);
  DirectionPoint out = {hn::GetLane(point.u),
                        hn::GetLane(point.v),
                        {},
                        hn::GetLane(point.stretch),
                        static_cast<uint32_t>(hn::GetLane(point.face)),
                        hn::AllTrue(d, point.finite)};
  for (int axis = 0; steps_given && axis < 2; ++axis) {
    out.step[2 * axis] = hn::GetLane(point.step[axis].du);
    out.step[2 * axis + 1] = hn::GetLane(point.step[axis].dv);
  }
  return out;
}

/// Names a map for WithMap().
template <template <class> class M>
struct MapName {
  template <class D>
  using Map = M<D>;
};

/// Returns body(MapName) of the map of a projection.
template <class Body>
auto WithMap(shd_projection projection, const Body& body) {
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return body(MapName<maps::LatLong>());
    case SHD_PROJECTION_MIRROR_BALL: return body(MapName<maps::MirrorBall>());
    case SHD_PROJECTION_ANGULAR: return body(MapName<maps::Angular>());
    case SHD_PROJECTION_OCTAHEDRAL: return body(MapName<maps::Octahedral>());
    default: return body(MapName<maps::Cube>());
  }
}

void ProjectRates(const Texture& texture, const Lookups& in, DirectionRates* out) {
  WithMap(texture.projection, [&](auto name) { FindRates<decltype(name)::template Map>(in, out); });
}

size_t ProjectLookups(const Texture& texture, const Lookups& in, ProjectedBlock* out) {
  out->points.count = in.count;
  const size_t nonfinite =
      WithMap(texture.projection, [&](auto name) { return Project<decltype(name)::template Map>(in, out); });
  if (texture.projection == SHD_PROJECTION_CUBE) out->points.layer = out->face;
  return nonfinite;
}

DirectionPoint ProjectPrecisely(const Texture& texture, const Lookups& in, size_t i) {
  return WithMap(texture.projection, [&](auto name) { return FindPoint<decltype(name)::template Map>(in, i); });
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {

Sampler sampler_of_directions(const Texture& texture, const Sampler& sampler) {
  Sampler inside = sampler;
  inside.wrap_u = texture.projection == SHD_PROJECTION_LAT_LONG ? SHD_WRAP_REPEAT : SHD_WRAP_CLAMP;
  inside.wrap_v = SHD_WRAP_CLAMP;
  inside.rounded_weights = false;
  inside.precision = SHD_PRECISION_FULL;
  return inside;
}

}  // namespace shd::texture
#endif
