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

size_t NearestBatch(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return RunValues<NearestKernel>(texture, sampler, in, out);
}
#if HWY_TARGET == HWY_STATIC_TARGET
void RecordNearest(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  NearestKernel::run<Recorded>(texture, sampler, in, out);
}
#endif

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

void record_nearest(const Texture& texture, const Sampler& sampler, const Lookups& lookups) {
  float unused[1];
  HWY_STATIC_DISPATCH(RecordNearest)(texture, sampler, lookups, {{unused}, {}, {}});
}

}  // namespace shd::texture
#endif
