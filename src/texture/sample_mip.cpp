// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_mip.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/kernel-inl.h"
#include "texture/lod_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The nearest level: ceil(lod + 1/2) - 1 (Vulkan 1.3 specification, "Image Level(s) Selection").
template <class D>
HWY_INLINE Level<D> NearestLevel(D d, const Texture& texture, const Points<D>& p) {
  const auto one = hn::Set(d, 1.0f);
  const auto level = hn::Sub(hn::Ceil(hn::Add(p.lod, hn::Set(d, 0.5f))), one);
  return LevelAt(d, texture, p.first_texel, hn::Max(level, hn::Zero(d)));
}

template <class F, bool kBorder>
struct NearestMip {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    StoreNearest<F, kBorder>(d, texture, sampler, NearestLevel(d, texture, p), p.u, p.v, out, i);
  }
};

template <class F, bool kBorder>
struct BilinearMip {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const auto u = ReduceCoordinate(d, sampler.wrap_u, p.u);
    const auto v = ReduceCoordinate(d, sampler.wrap_v, p.v);
    const Quad<F, D> quad = FetchQuad<F>(d, texture, sampler, NearestLevel(d, texture, p), u, v);
    StoreQuad<F, kBorder>(d, quad, sampler, out, i);
  }
};

struct MipKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    return ForEachLodBlock(texture, sampler, in, out, [&](const Lookups& block, const Texels& to) {
      if (sampler.filter == SHD_FILTER_NEAREST_MIP) {
        ForEachPoint<NearestMip, F>(texture, sampler, block, to);
      } else {
        ForEachPoint<BilinearMip, F>(texture, sampler, block, to);
      }
    });
  }
};

FilterKernels MipKernels() {
  return KernelsOf<MipKernel, true>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(MipKernels);
}  // namespace

FilterKernels mip_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(MipKernels, simd)();
}

}  // namespace shd::texture
#endif
