// SPDX-License-Identifier: MIT
#include "texture/footprint/block.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/footprint/points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/footprint/points-inl.h"
#include "texture/footprint/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

size_t FindPoints(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* out) {
  size_t nonfinite = 0;
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) {
    auto u = hn::LoadU(d, from.u + i), v = hn::LoadU(d, from.v + i);
    const auto j = LoadDerivatives(d, from, i);
    const auto along_x = ZeroIfFinite(j.dudx) + ZeroIfFinite(j.dvdx);
    const auto along_y = ZeroIfFinite(j.dudy) + ZeroIfFinite(j.dvdy);
    const auto point = ZeroIfFinite(u) + ZeroIfFinite(v) + ZeroIfFinite(LoadOrZero(d, from.lod, i));
    const auto finite = hn::Eq(point + (along_x + along_y), hn::Zero(d));
    if (HWY_UNLIKELY(!hn::AllTrue(d, finite))) {
      nonfinite += hn::CountTrue(d, hn::AndNot(finite, hn::FirstN(d, in.count - to)));
      u = FiniteOrZero(d, u);
      v = FiniteOrZero(d, v);
    }
    hn::Store(ReduceCoordinate(d, sampler.wrap_u, u), d, out->u + to);
    hn::Store(ReduceCoordinate(d, sampler.wrap_v, v), d, out->v + to);
    if (texture.layers == 1) return;
    hn::Store(LoadFirstTexel(d, texture, from, i), hn::RebindToSigned<decltype(d)>(), out->first_texel + to);
  });
  out->count = in.count;
  out->finite = nonfinite == 0;
  return nonfinite;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
