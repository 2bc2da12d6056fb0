// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_nearest.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class F, bool kBorder>
struct Nearest {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    StoreNearest<F, kBorder>(d, texture, sampler, SameLevel(d, texture, p.first_texel, 0), p.u, p.v, out, i);
  }
};

struct NearestKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    return ForEachPoint<Nearest, F>(texture, sampler, in, out);
  }
};

FilterKernels NearestKernels() {
  return KernelsOf<NearestKernel, false>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(NearestKernels);
}  // namespace

FilterKernels nearest_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(NearestKernels, simd)();
}

}  // namespace shd::texture
#endif
