// SPDX-License-Identifier: MIT
#include "shade/parallax.h"

#include <algorithm>
#include <limits>

#include "data/data.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/parallax.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/vec3-inl.h"
#include "texture/lookup/sample.h"

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Cross;
using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Load3;
using simd::HWY_NAMESPACE::Scaled;
using simd::HWY_NAMESPACE::Sum;
using simd::HWY_NAMESPACE::Vec3V;

/// Change of u and v along each point's line of sight down to `depth`; 0 where the frame spans no area or the change is
/// 1e6 or more.
void FindShift(float depth, const float* const* tangent_frame, const raster::Fragments& f, float* du, float* dv) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const V limit = hn::Set(d, 1e6f), zero = hn::Zero(d);
  for (size_t i = 0; i < f.count; i += hn::Lanes(d)) {
    const Vec3V<V> n = Load3(d, f.nx, f.ny, f.nz, i), wo = Load3(d, f.ox, f.oy, f.oz, i);
    const V cosine = Dot(n, wo);
    const V steep = hn::Max(hn::Abs(cosine), hn::Set(d, 0.1f));
    // Direction away from the eye, along the surface.
    const Vec3V<V> along = Scaled(Sum(Scaled(n, cosine), Scaled(wo, hn::Set(d, -1.0f))), hn::Set(d, depth) / steep);
    const Vec3V<V> dpdu = Load3(d, tangent_frame[0], tangent_frame[1], tangent_frame[2], i),
                   dpdv = Load3(d, tangent_frame[3], tangent_frame[4], tangent_frame[5], i);
    const Vec3V<V> r1 = Cross(dpdv, n), r2 = Cross(n, dpdu);
    const V area = Dot(dpdu, r1);
    const auto flat = hn::Eq(area, zero);
    const V inverse = hn::Set(d, 1.0f) / hn::IfThenElse(flat, hn::Set(d, 1.0f), area);
    const V u = Dot(r1, along) * inverse, v = Dot(r2, along) * inverse;
    const auto usable = hn::AndNot(flat, hn::And(hn::Lt(hn::Abs(u), limit), hn::Lt(hn::Abs(v), limit)));
    hn::Store(hn::IfThenElseZero(usable, u), d, du + i);
    hn::Store(hn::IfThenElseZero(usable, v), d, dv + i);
  }
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {
namespace {

HWY_EXPORT(FindShift);

/// Sets u and v to the position `part`, 0..1, on each line.
void move(const MarchColumns& m, float part, size_t count, float* u, float* v) {
  for (size_t i = 0; i < count; ++i) {
    u[i] = m.u0[i] + part * m.du[i];
    v[i] = m.v0[i] + part * m.dv[i];
  }
}

/// Evaluates one step at position `part`. Returns whether every line has met the heights.
bool step(const MarchColumns& m, const float* height, float part, float width, size_t count) {
  float min_found = 1.0f;
  for (size_t i = 0; i < count; ++i) {
    const float above = (1.0f - part) - height[i];
    const bool hits = !(above > 0.0f) && m.found[i] < 0.0f;
    const float drop = m.above[i] - above;
    // above <= 0: interpolate back to the crossing of the line between the two steps. Infinite heights cannot be
    // interpolated.
    const float back = drop > 0.0f && drop < std::numeric_limits<float>::infinity() ? above / drop : 0.0f;
    const float crossing = part + width * std::max(back, -1.0f);
    m.found[i] = hits ? std::max(crossing, 0.0f) : m.found[i];
    m.above[i] = above;
    min_found = m.found[i] < min_found ? m.found[i] : min_found;
  }
  return min_found >= 0.0f;
}

}  // namespace

void shift_by_heights(const core::SimdTarget& simd, const SlotContext& context, raster::Fragments* fragments,
                      Columns* columns) {
  const material::Material& material = *context.shading.material;
  const material::Slot& slot = material.slot[SHD_SLOT_HEIGHT];
  raster::Fragments& f = *fragments;
  float *u = slot.uv_set ? f.u1 : f.u, *v = slot.uv_set ? f.v1 : f.v;
  const MarchColumns& m = columns->march;
  float* const height = columns->slot[SHD_SLOT_HEIGHT][0];
  SHD_DISPATCH(FindShift, simd)(material.parallax_depth, columns->tangent_frame, f, m.du, m.dv);
  std::copy_n(u, f.count, m.u0);
  std::copy_n(v, f.count, m.v0);
  std::fill_n(m.found, f.count, -1.0f);
  std::fill_n(m.above, f.count, 0.0f);
  const float width = 1.0f / static_cast<float>(material.parallax_steps - 1);
  for (uint32_t k = 0; k < material.parallax_steps; ++k) {
    const float part = std::min(static_cast<float>(k) * width, 1.0f);
    move(m, part, f.count, u, v);
    texture::Texels out = {};
    out.channel[slot.channel] = height;
    texture::sample(*slot.texture, *slot.sampler, simd, lookups_of(slot, context, columns), out);
    if (step(m, height, part, width, f.count)) break;
  }
  for (size_t i = 0; i < f.count; ++i) {
    const float part = m.found[i] < 0.0f ? 1.0f : m.found[i];
    u[i] = m.u0[i] + part * m.du[i];
    v[i] = m.v0[i] + part * m.dv[i];
  }
  // Points up to the next whole vector repeat the last one.
  std::fill(u + f.count, u + data::padded(f.count), u[f.count - 1]);
  std::fill(v + f.count, v + data::padded(f.count), v[f.count - 1]);
}

}  // namespace shd::shade
#endif  // HWY_ONCE
