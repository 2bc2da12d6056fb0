// SPDX-License-Identifier: MIT
#include "projection/projection.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "projection/projection.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "projection/projection-inl.h"
#include "simd/round-inl.h"
#include "simd/tail-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::projection::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::IsFinite;
using simd::HWY_NAMESPACE::LoadFirst;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::StoreFirst;

using Tag = hn::CappedTag<float, 16>;
using Vector = Vec3V<hn::Vec<Tag>>;

/// Up to a whole vector.
template <class D>
HWY_INLINE hn::Vec<D> Load(D d, const hn::TFromD<D>* from, size_t count) {
  return HWY_LIKELY(count == hn::Lanes(d)) ? hn::LoadU(d, from) : LoadFirst(d, from, count);
}

/// Elements from i on, `count` of them; absent columns are 0.
HWY_INLINE hn::Vec<Tag> LoadColumn(const float* column, size_t i, size_t count) {
  const Tag d;
  return column ? Load(d, column + i, count) : hn::Zero(d);
}
HWY_INLINE Vector LoadVector(const float* const (&columns)[3], size_t i, size_t count) {
  return {LoadColumn(columns[0], i, count), LoadColumn(columns[1], i, count), LoadColumn(columns[2], i, count)};
}

template <class D, class V>
HWY_INLINE void StoreColumn(D d, V value, size_t i, size_t count, hn::TFromD<D>* column) {
  if (column) StoreFirst(d, value, count, column + i);
}

template <class Map>
size_t ProjectBatch(const Directions& in, const Points& out) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  const auto limit = hn::Set(d, 1e30f), zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  size_t nonfinite = 0;
  for (size_t i = 0; i < in.count; i += hn::Lanes(d)) {
    const size_t count = in.count - i < hn::Lanes(d) ? in.count - i : hn::Lanes(d);
    const BoundedDirection<Tag> direction(d, LoadVector(in.direction, i, count));
    nonfinite += hn::CountTrue(d, hn::AndNot(direction.valid, hn::FirstN(d, count)));
    const Map map(d, direction.n);
    StoreColumn(d, hn::Min(hn::Max(map.u, zero), one), i, count, out.u);
    StoreColumn(d, hn::Min(hn::Max(map.v, zero), one), i, count, out.v);
    StoreColumn(du, hn::BitCast(du, map.face), i, count, out.face);
    for (int axis = 0; axis < 2; ++axis) {
      if (!out.du[axis] && !out.dv[axis]) continue;
      const auto step_of = [&](const Vector& dn) { return map.step(d, dn); };
      const auto step = direction.derivatives(d, LoadVector(in.step[axis], i, count), step_of);
      StoreColumn(d, hn::Min(hn::Max(step.du, hn::Neg(limit)), limit), i, count, out.du[axis]);
      StoreColumn(d, hn::Min(hn::Max(step.dv, hn::Neg(limit)), limit), i, count, out.dv[axis]);
    }
  }
  return nonfinite;
}

template <class Map>
size_t UnprojectBatch(const ImagePoints& in, const PointDirections& out) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  size_t nonfinite = 0;
  for (size_t i = 0; i < in.count; i += hn::Lanes(d)) {
    const size_t count = in.count - i < hn::Lanes(d) ? in.count - i : hn::Lanes(d);
    auto u = Load(d, in.u + i, count), v = Load(d, in.v + i, count);
    const auto u_finite = IsFinite(d, u), v_finite = IsFinite(d, v);
    nonfinite += hn::CountTrue(d, hn::AndNot(hn::And(u_finite, v_finite), hn::FirstN(d, count)));
    u = hn::IfThenElseZero(u_finite, u);
    if (Map::kRepeats) u = hn::IfThenElse(hn::Gt(hn::Abs(u), one), u - RoundDown(u), u);
    u = hn::Min(hn::Max(u, Map::kRepeats ? hn::Neg(one) : zero), one);
    v = hn::Min(hn::Max(hn::IfThenElseZero(v_finite, v), zero), one);
    const auto last = hn::Set(du, Map::kFaces - 1);
    const auto face = in.face ? hn::Min(Load(du, in.face + i, count), last) : hn::Zero(du);
    auto solid_angle = zero;
    const auto n = Map::direction(d, u, v, hn::BitCast(hn::RebindToSigned<Tag>(), face), &solid_angle);
    StoreColumn(d, n.x, i, count, out.direction[0]);
    StoreColumn(d, n.y, i, count, out.direction[1]);
    StoreColumn(d, n.z, i, count, out.direction[2]);
    StoreColumn(d, solid_angle, i, count, out.solid_angle);
  }
  return nonfinite;
}

size_t ProjectAll(shd_projection projection, const Directions& in, const Points& out) {
  return WithMap<Tag>(projection, [&](auto type) { return ProjectBatch<typename decltype(type)::Map>(in, out); });
}

size_t UnprojectAll(shd_projection projection, const ImagePoints& in, const PointDirections& out) {
  return WithMap<Tag>(projection, [&](auto type) { return UnprojectBatch<typename decltype(type)::Map>(in, out); });
}

}  // namespace shd::projection::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::projection {
namespace {
HWY_EXPORT(ProjectAll);
HWY_EXPORT(UnprojectAll);
}  // namespace

size_t project(shd_projection projection, const core::SimdTarget& simd, const Directions& in, const Points& out) {
  return SHD_DISPATCH(ProjectAll, simd)(projection, in, out);
}

size_t unproject(shd_projection projection, const core::SimdTarget& simd, const ImagePoints& in,
                 const PointDirections& out) {
  return SHD_DISPATCH(UnprojectAll, simd)(projection, in, out);
}

}  // namespace shd::projection
#endif
