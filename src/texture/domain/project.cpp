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

template <class D, class Map>
HWY_INLINE maps::StepV<hn::Vec<D>> StepOf(D d, const Map& map, const Direction& dn) {
  return map.step(d, dn);
}
template <class D>
HWY_INLINE maps::StepV<hn::Vec<D>> StepOf(D d, const maps::LatLong<D>& map, const Direction& dn) {
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
HWY_INLINE maps::StepV<hn::Vec<D>> WithInfinity(D d, const Direction& dn, const maps::StepV<hn::Vec<D>>& step) {
  const auto infinity = hn::Set(d, __builtin_inff());
  const auto is_infinite = [&](hn::Vec<D> x) { return hn::Eq(hn::Abs(x), infinity); };
  const auto any = hn::Or(hn::Or(is_infinite(dn.x), is_infinite(dn.y)), is_infinite(dn.z));
  return {hn::IfThenElse(any, infinity, step.du), hn::IfThenElse(any, infinity, step.dv)};
}

/// The directions of a vector of lookups.
HWY_INLINE Direction LoadDirection(BatchTag d, const Lookups& from, size_t i) {
  return {LoadOrZero(d, from.u, i), LoadOrZero(d, from.v, i), LoadOrZero(d, from.w, i)};
}

template <template <class> class Map>
size_t Project(const Lookups& in, ProjectedBlock* out) {
  size_t nonfinite = 0;
  const bool steps_given = !in.lod && (in.dudx || in.dvdx || in.dwdx || in.dudy || in.dvdy || in.dwdy);
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto load = [&](const float* column) SHD_INLINE_LAMBDA { return LoadOrZero(d, column, i); };
    const maps::BoundedDirection<BatchTag> direction(d, LoadDirection(d, from, i));
    auto finite = direction.valid;
    const Map<BatchTag> map(d, direction.n);
    hn::Store(map.u, d, out->u + to);
    hn::Store(map.v, d, out->v + to);
    hn::Store(hn::BitCast(du, map.face), du, out->face + to);
    hn::Store(StretchOf(d, map), d, out->stretch + to);
    if (steps_given) {
      const Direction steps[2] = {{load(from.dudx), load(from.dvdx), load(from.dwdx)},
                                  {load(from.dudy), load(from.dvdy), load(from.dwdy)}};
      finite = hn::And(finite, hn::And(IsFinite(d, steps[0]), IsFinite(d, steps[1])));
      const bool all_finite = hn::AllTrue(d, finite);
      for (int axis = 0; axis < 2; ++axis) {
        const auto step_of = [&](const Direction& dn) SHD_INLINE_LAMBDA { return StepOf(d, map, dn); };
        auto step = direction.derivatives(d, steps[axis], step_of);
        if (HWY_UNLIKELY(!all_finite)) step = WithInfinity(d, steps[axis], step);
        hn::Store(step.du, d, out->step[2 * axis] + to);
        hn::Store(step.dv, d, out->step[2 * axis + 1] + to);
      }
    } else if (from.lod) {
      finite = hn::And(finite, IsFinite(d, load(from.lod)));
    }
    if (HWY_UNLIKELY(!hn::AllTrue(d, finite))) {
      nonfinite += hn::CountTrue(d, hn::AndNot(finite, hn::FirstN(d, in.count - to)));
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

void ProjectRates(const Texture& texture, const Lookups& in, DirectionRates* out) {
  switch (texture.projection) {
    case SHD_PROJECTION_LAT_LONG: return FindRates<maps::LatLong>(in, out);
    case SHD_PROJECTION_MIRROR_BALL: return FindRates<maps::MirrorBall>(in, out);
    case SHD_PROJECTION_ANGULAR: return FindRates<maps::Angular>(in, out);
    case SHD_PROJECTION_OCTAHEDRAL: return FindRates<maps::Octahedral>(in, out);
    default: return FindRates<maps::Cube>(in, out);
  }
}

size_t ProjectLookups(const Texture& texture, const Lookups& in, ProjectedBlock* out) {
  out->points.count = in.count;
  switch (texture.projection) {
    case SHD_PROJECTION_LAT_LONG: return Project<maps::LatLong>(in, out);
    case SHD_PROJECTION_MIRROR_BALL: return Project<maps::MirrorBall>(in, out);
    case SHD_PROJECTION_ANGULAR: return Project<maps::Angular>(in, out);
    case SHD_PROJECTION_OCTAHEDRAL: return Project<maps::Octahedral>(in, out);
    default: break;
  }
  const size_t nonfinite = Project<maps::Cube>(in, out);
  out->points.layer = out->face;
  return nonfinite;
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
