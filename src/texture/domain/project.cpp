// SPDX-License-Identifier: MIT
#include "texture/domain/direction.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/domain/project.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/double-inl.h"  // before the maps, which take doubles, too

#include "projection/projection-inl.h"
#include "texture/domain/fold-inl.h"
#include "texture/domain/project-inl.h"
#include "texture/domain/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace maps = projection::HWY_NAMESPACE;

template <class D>
using Direction = simd::HWY_NAMESPACE::Vec3V<hn::Vec<D>>;

/// Derivatives of a point; infinite in lanes where the change of the direction has an infinite component.
template <class D>
HWY_INLINE maps::StepV<hn::Vec<D>> WithInfinity(D d, const Direction<D>& dn, const maps::StepV<hn::Vec<D>>& step) {
  const auto infinity = hn::Inf(d);
  const auto is_infinite = [&](hn::Vec<D> x) { return hn::Eq(hn::Abs(x), infinity); };
  const auto any = hn::Or(hn::Or(is_infinite(dn.x), is_infinite(dn.y)), is_infinite(dn.z));
  return {hn::IfThenElse(any, infinity, step.du), hn::IfThenElse(any, infinity, step.dv)};
}

bool HasSteps(const Lookups& in) {
  return !in.lod && (in.dudx || in.dvdx || in.dwdx || in.dudy || in.dvdy || in.dwdy);
}

/// Projects a vector of directions to the points at `to`. `load` returns the values of a column, which may be null.
/// Returns the lanes whose inputs are finite.
template <class Map, class D, class Load, class Points>
HWY_INLINE hn::Mask<D> ProjectVector(D d, const Lookups& in, bool steps_given, const Load& load, size_t to,
                                     Points* out) {
  const hn::RebindToUnsigned<D> du;
  const maps::BoundedDirection<D> direction(d, {load(in.u), load(in.v), load(in.w)});
  auto finite = direction.valid;
  const Map map(d, direction.n);
  hn::Store(map.u, d, out->u + to);
  hn::Store(map.v, d, out->v + to);
  hn::Store(hn::BitCast(du, map.face), du, out->face + to);
  hn::Store(map.stretch(d), d, out->stretch + to);
  if (steps_given) {
    const Direction<D> steps[2] = {{load(in.dudx), load(in.dvdx), load(in.dwdx)},
                                   {load(in.dudy), load(in.dvdy), load(in.dwdy)}};
    finite = hn::And(finite,
                     hn::And(simd::HWY_NAMESPACE::IsFinite(d, steps[0]), simd::HWY_NAMESPACE::IsFinite(d, steps[1])));
    const bool all_finite = hn::AllTrue(d, finite);
    for (int axis = 0; axis < 2; ++axis) {
      const auto step_of = [&](const Direction<D>& dn) SHD_INLINE_LAMBDA { return map.even_step(d, dn); };
      auto step = direction.derivatives(d, steps[axis], step_of);
      if (HWY_UNLIKELY(!all_finite)) step = WithInfinity(d, steps[axis], step);
      hn::Store(step.du, d, out->step[2 * axis] + to);
      hn::Store(step.dv, d, out->step[2 * axis + 1] + to);
    }
  } else if (in.lod) {
    finite = hn::And(finite, simd::HWY_NAMESPACE::IsFinite(d, load(in.lod)));
  }
  return finite;
}

template <class Map>
size_t Project(const Lookups& in, ProjectedBlock* out) {
  size_t nonfinite = 0;
  const bool steps_given = HasSteps(in);
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
    const auto load = [&](const float* column) SHD_INLINE_LAMBDA { return LoadOrZero(d, column, i); };
    const auto finite = ProjectVector<Map>(BatchTag(), from, steps_given, load, to, out);
    if (HWY_UNLIKELY(!hn::AllTrue(d, finite))) {
      nonfinite += hn::CountTrue(d, hn::AndNot(finite, hn::FirstN(d, in.count - to)));
    }
  });
  Lookups& points = out->points;
  points = in;
  points.one_footprint = points.finite = false;
  points.u = out->u, points.v = out->v, points.w = points.dwdx = points.dwdy = nullptr;
  points.dudx = steps_given ? out->step[0] : nullptr, points.dvdx = steps_given ? out->step[1] : nullptr;
  points.dudy = steps_given ? out->step[2] : nullptr, points.dvdy = steps_given ? out->step[3] : nullptr;
  if (Map::kFaces > 1) points.layer = out->face;
  out->stretches = Map::kStretches;
  return nonfinite;
}

size_t ProjectLookups(const Texture& texture, const Lookups& in, ProjectedBlock* out) {
  return maps::WithMap<BatchTag>(texture.projection,
                                 [&](auto type) { return Project<typename decltype(type)::Map>(in, out); });
}

DirectionPoint ProjectPrecisely(const Texture& texture, const Lookups& in, size_t i) {
  using D = hn::CappedTag<double, 1>;
  const D d;
  const auto load = [&](const float* column) { return hn::Set(d, column ? static_cast<double>(column[i]) : 0.0); };
  DirectionPoint out = {};
  maps::WithMap<D>(texture.projection, [&](auto type) {
    out.finite = hn::AllTrue(d, ProjectVector<typename decltype(type)::Map>(d, in, HasSteps(in), load, 0, &out));
  });
  return out;
}

void ProjectRates(const Texture& texture, const Lookups& in, DirectionRates* out) {
  maps::WithMap<BatchTag>(texture.projection, [&](auto type) {
    ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) SHD_INLINE_LAMBDA {
      const auto load = [&](const float* column) SHD_INLINE_LAMBDA { return LoadOrZero(d, column, i); };
      const maps::BoundedDirection<BatchTag> direction(d, {load(from.u), load(from.v), load(from.w)});
      const typename decltype(type)::Map map(d, direction.n);
      const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), largest = hn::Set(d, 0x1.fffffep127f);
      const auto bounded = [&](auto x) SHD_INLINE_LAMBDA {
        return hn::IfThenElseZero(direction.valid, hn::Min(hn::Max(x, hn::Neg(largest)), largest));
      };
      for (int axis = 0; axis < 3; ++axis) {
        const Direction<BatchTag> unit = {axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero};
        const auto step_of = [&](const Direction<BatchTag>& dn) SHD_INLINE_LAMBDA { return map.step(d, dn); };
        const auto step = direction.derivatives(d, unit, step_of);
        hn::Store(bounded(step.du), d, out->u[axis] + to);
        hn::Store(bounded(step.dv), d, out->v[axis] + to);
      }
    });
  });
}

FoldTraits TraitsOf(shd_projection projection) {
  return WithFold(projection, [](auto fold) {
    using F = decltype(fold);
    return FoldTraits{F::kIsDisc, F::kRepeatsAcross, F::kTurnsAtPoles, F::kLacksCorners, F::kIsPeriodic, F::kHasPlanes};
  });
}

Sampler SamplerOfDirections(const Texture& texture, const Sampler& sampler) {
  Sampler inside = sampler;
  inside.wrap_u = TraitsOf(texture.projection).repeats_across ? SHD_WRAP_REPEAT : SHD_WRAP_CLAMP;
  inside.wrap_v = SHD_WRAP_CLAMP;
  if (sampler.weights == Weights::kRounded) inside.weights = Weights::kLinear;
  inside.precision = SHD_PRECISION_FULL;
  return inside;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
