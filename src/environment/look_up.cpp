// SPDX-License-Identifier: MIT
#include "environment/look_up.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/look_up.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "environment/look_up-inl.h"
#include "simd/tail-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::environment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

namespace {

using Tag = hn::ScalableTag<float>;
using Vec = hn::Vec<Tag>;

/// A direction divided by its largest component, so that sums and squares neither overflow nor underflow; +Z for 0, NaN
/// and infinity.
HWY_INLINE Vec3V<Vec> Bounded(const Vec3V<Vec>& n) {
  const Tag d;
  const Vec one = hn::Set(d, 1.0f), largest = hn::Max(hn::Abs(n.x), hn::Max(hn::Abs(n.y), hn::Abs(n.z)));
  const auto usable = hn::And(hn::Gt(largest, hn::Zero(d)), simd::HWY_NAMESPACE::IsFinite(d, n));
  const Vec safe = hn::IfThenElse(usable, largest, one);
  return {hn::IfThenElseZero(usable, n.x / safe), hn::IfThenElseZero(usable, n.y / safe),
          hn::IfThenElse(usable, n.z / safe, one)};
}

/// Calls body(direction, i, count) for vectors of directions and stores its colours.
template <class Body>
HWY_INLINE void ForEach(const LookUps& in, float* const* out, const Body& body) {
  const Tag d;
  for (size_t i = 0; i < in.count; i += hn::Lanes(d)) {
    const size_t count = in.count - i < hn::Lanes(d) ? in.count - i : hn::Lanes(d);
    const auto load = [&](const float* column) HWY_ATTR {
      return HWY_LIKELY(count == hn::Lanes(d)) ? hn::LoadU(d, column + i)
                                               : simd::HWY_NAMESPACE::LoadFirst(d, column + i, count);
    };
    const Vec3V<Vec> n = {load(in.direction[0]), load(in.direction[1]), load(in.direction[2])};
    const ColorV<Vec> color = body(Bounded(n), in.width ? load(in.width) : hn::Zero(d));
    for (int c = 0; c < 3; ++c) {
      if (out[c]) simd::HWY_NAMESPACE::StoreFirst(d, color.channel[c], count, out[c] + i);
    }
  }
}

/// log2 of the precision of the narrowest map.
constexpr float kSharp = 64.0f;

}  // namespace

void IrradianceBatch(const Environment& environment, const LookUps& in, float* const* out) {
  ForEach(in, out, [&](const Vec3V<Vec>& n, Vec) HWY_ATTR {
    return Irradiance(Tag(), environment, simd::HWY_NAMESPACE::Normalize(Tag(), n));
  });
}

void RadianceBatch(const Environment& environment, const LookUps& in, float* const* out) {
  const Tag d;
  ForEach(in, out, [&](const Vec3V<Vec>& n, Vec) HWY_ATTR {
    return LookUpChain(d, environment.texels.data(), environment.radiance, SquarePoint(d, n), hn::Set(d, kSharp));
  });
}

void GgxBatch(const Environment& environment, const LookUps& in, float* const* out) {
  const Tag d;
  const Vec one = hn::Set(d, 1.0f);
  ForEach(in, out, [&](const Vec3V<Vec>& n, Vec roughness) HWY_ATTR {
    const Vec r = hn::IfThenElse(hn::Lt(roughness, one), hn::Max(roughness, hn::Set(d, 1e-4f)), one);
    const Vec alpha = r * r;
    const Vec t = PrecisionLog2(d, one / (alpha * alpha));
    return LookUpChain(d, environment.texels.data(), environment.ggx, SquarePoint(d, n), t);
  });
}

void PhongBatch(const Environment& environment, const LookUps& in, float* const* out) {
  const Tag d;
  const Vec zero = hn::Zero(d), one = hn::Set(d, 1.0f), largest = hn::Set(d, 1e6f);
  ForEach(in, out, [&](const Vec3V<Vec>& n, Vec exponent) HWY_ATTR {
    const Vec p = hn::IfThenElseZero(hn::Gt(exponent, zero), hn::Min(exponent, largest));
    return LookUpChain(d, environment.texels.data(), environment.phong, SquarePoint(d, n), PrecisionLog2(d, p + one));
  });
}

void ViewBatch(const Environment& environment, const LookUps& in, float roughness, float intensity, float* const* out) {
  const Tag d;
  const Chain& chain = roughness > 0.0f ? environment.ggx : environment.radiance;
  const float alpha = roughness * roughness, widest = 1.0f / std::max(alpha * alpha, 1e-12f);
  ForEach(in, out, [&](const Vec3V<Vec>& n, Vec precision) HWY_ATTR {
    const Vec t = PrecisionLog2(d, hn::Min(precision, hn::Set(d, widest)));
    ColorV<Vec> color = LookUpChain(d, environment.texels.data(), chain, SquarePoint(d, n), t);
    for (Vec& channel : color.channel) channel = channel * hn::Set(d, intensity);
    return color;
  });
}

}  // namespace shd::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::environment {

HWY_EXPORT(IrradianceBatch);
HWY_EXPORT(RadianceBatch);
HWY_EXPORT(GgxBatch);
HWY_EXPORT(PhongBatch);
HWY_EXPORT(ViewBatch);

void look_up_irradiance(const core::SimdTarget& simd, const Environment& environment, const LookUps& in,
                        float* const out[3]) {
  SHD_DISPATCH(IrradianceBatch, simd)(environment, in, out);
}

void look_up_radiance(const core::SimdTarget& simd, const Environment& environment, const LookUps& in,
                      float* const out[3]) {
  SHD_DISPATCH(RadianceBatch, simd)(environment, in, out);
}

void look_up_ggx(const core::SimdTarget& simd, const Environment& environment, const LookUps& in, float* const out[3]) {
  SHD_DISPATCH(GgxBatch, simd)(environment, in, out);
}

void look_up_phong(const core::SimdTarget& simd, const Environment& environment, const LookUps& in,
                   float* const out[3]) {
  SHD_DISPATCH(PhongBatch, simd)(environment, in, out);
}

void look_up_view(const core::SimdTarget& simd, const Environment& environment, const LookUps& in, float roughness,
                  float intensity, float* const out[3]) {
  SHD_DISPATCH(ViewBatch, simd)(environment, in, roughness, intensity, out);
}

}  // namespace shd::environment
#endif  // HWY_ONCE
