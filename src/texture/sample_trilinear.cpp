// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_trilinear.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/kernel-inl.h"
#include "texture/lod_block-inl.h"
#include "texture/prefetch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Bilinear on the levels floor(lod) and the next, blended by the fraction (Williams, "Pyramidal Parametrics", 1983).
/// The short cuts for lanes that share a level or blend nothing give the bits of the general path.
template <class F, bool kBorder>
struct Trilinear {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const hn::RebindToSigned<D> di;
    const auto u = ReduceCoordinate(d, sampler.wrap_u, p.u);
    const auto v = ReduceCoordinate(d, sampler.wrap_v, p.v);
    const auto floor = hn::Floor(p.lod);
    const auto fraction = hn::Sub(p.lod, floor);
    const float first = hn::GetLane(floor);
    const bool same = hn::AllTrue(d, hn::Eq(floor, hn::Set(d, first)));
    const auto level = hn::ConvertTo(di, floor);
    const Quad<F, D> high = FetchQuad<F>(d, texture, sampler,
                                         same ? SameLevel(d, texture, p.first_texel, static_cast<uint32_t>(first))
                                              : LevelPerLane(d, texture, p.first_texel, level),
                                         u, v);
    if (hn::AllTrue(d, hn::Eq(fraction, hn::Zero(d)))) return StoreQuad<F, kBorder>(d, high, sampler, out, i);

    const auto last = static_cast<int32_t>(texture.level_count - 1);
    const auto next = hn::Min(hn::Add(level, hn::Set(di, 1)), hn::Set(di, last));
    const Quad<F, D> low =
        FetchQuad<F>(d, texture, sampler,
                     same ? SameLevel(d, texture, p.first_texel, static_cast<uint32_t>(hn::GetLane(next)))
                          : LevelPerLane(d, texture, p.first_texel, next),
                     u, v);
    StoreChannels<F, kBorder>(d, Pair<D>{high, low, fraction, sampler}, out, i);
  }

  template <class D>
  struct Pair {
    const Quad<F, D>&high, &low;
    hn::Vec<D> fraction;
    const Sampler& sampler;

    template <size_t C>
    HWY_INLINE auto of() const {
      const auto first = BlendQuad<F, kBorder, C>(D(), high, sampler);
      const auto second = BlendQuad<F, kBorder, C>(D(), low, sampler);
      return Blend<F, kBorder>::blend(D(), first, second, fraction);
    }
  };
};

struct TrilinearKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    return ForEachLodBlock(texture, sampler, in, out, [&](const Lookups& block, const Texels& to) {
      WithPrefetch(texture, sampler, block, to, 2, block.lod, [&](const Lookups& part, const Texels& values) {
        ForEachPoint<Trilinear, F>(texture, sampler, part, values);
      });
    });
  }
};

FilterKernels TrilinearKernels() {
  return KernelsOf<TrilinearKernel, true>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(TrilinearKernels);
}  // namespace

FilterKernels trilinear_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(TrilinearKernels, simd)();
}

}  // namespace shd::texture
#endif
