// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_bilinear.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/kernel-inl.h"
#include "texture/prefetch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class F, bool kBorder>
struct Bilinear {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const auto u = ReduceCoordinate(d, sampler.wrap_u, p.u);
    const auto v = ReduceCoordinate(d, sampler.wrap_v, p.v);
    const Quad<F, D> quad = FetchQuad<F>(d, texture, sampler, SameLevel(d, texture, p.first_texel, 0), u, v);
    StoreQuad<F, kBorder>(d, quad, sampler, out, i);
  }
};

struct BilinearKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    size_t nonfinite = 0;
    for (size_t first = 0; first < in.count; first += kBlock) {
      const Lookups block = part_of(in, first, in.count - first < kBlock ? in.count - first : kBlock);
      WithPrefetch(texture, sampler, block, part_of(out, first), 1, nullptr,
                   [&](const Lookups& part, const Texels& values) {
                     nonfinite += ForEachPoint<Bilinear, F>(texture, sampler, part, values);
                   });
    }
    return nonfinite;
  }
};

FilterKernels BilinearKernels() {
  return KernelsOf<BilinearKernel, true>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(BilinearKernels);
}  // namespace

FilterKernels bilinear_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(BilinearKernels, simd)();
}

}  // namespace shd::texture
#endif
