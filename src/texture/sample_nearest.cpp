// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_nearest.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/batch-inl.h"
#include "texture/filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class F, bool kBorder>
struct Nearest {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const Level<D> level = SameLevel(d, texture, 0);
    MaskOf<D> in_x, in_y;
    const auto x = WrapNearest(d, sampler.wrap_u, ReduceCoordinate(d, sampler.wrap_u, p.u), level.across, &in_x);
    const auto y = WrapNearest(d, sampler.wrap_v, ReduceCoordinate(d, sampler.wrap_v, p.v), level.down, &in_y);
    const auto texel = F::fetch(d, texture.texels.data(), hn::Add(RowIndex(d, level, y), x));
    const auto in = hn::And(in_x, in_y);
    store<0>(d, texel, in, out, i);
    if constexpr (F::kChannels == 4) {
      store<1>(d, texel, in, out, i);
      store<2>(d, texel, in, out, i);
      store<3>(d, texel, in, out, i);
    }
  }

  template <size_t C, class D>
  HWY_INLINE void store(D d, const typename F::template Texel<D>& texel, MaskOf<D> in, const Texels& out,
                        size_t i) const {
    using B = Blend<F, kBorder>;
    if (!out.channel[C]) return;
    const auto value = B::template tap<C>(d, texel, in, sampler);
    hn::StoreU(B::template finish<C>(d, value), d, out.channel[C] + i);
  }
};

template <class F>
size_t NearestOfFormat(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  if (has_border(sampler)) return ForEachVector(Nearest<F, true>{texture, sampler}, in, out);
  return ForEachVector(Nearest<F, false>{texture, sampler}, in, out);
}

size_t NearestBatch(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  switch (texture.format) {
    case SHD_FORMAT_R8: return NearestOfFormat<R8>(texture, sampler, in, out);
    case SHD_FORMAT_RGBA8: return NearestOfFormat<Rgba8>(texture, sampler, in, out);
    case SHD_FORMAT_RGBA8_SRGB: return NearestOfFormat<Srgb8>(texture, sampler, in, out);
    case SHD_FORMAT_RGBA16F: return NearestOfFormat<Rgba16f>(texture, sampler, in, out);
    default: return NearestOfFormat<Rgba32f>(texture, sampler, in, out);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(NearestBatch);
}  // namespace

size_t sample_nearest(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                      const Lookups& lookups, const Texels& out) {
  return SHD_DISPATCH(NearestBatch, simd)(texture, sampler, lookups, out);
}

}  // namespace shd::texture
#endif
