// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_mip.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/lod_block-inl.h"
#include "texture/record-inl.h"

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

template <class F, bool kBorder>
void MipBlock(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  using D = typename TagOf<F>::Type;
  if (sampler.filter == SHD_FILTER_NEAREST_MIP) {
    ForEachVector<D>(texture, NearestMip<F, kBorder>{texture, sampler}, in, out);
  } else {
    ForEachVector<D>(texture, BilinearMip<F, kBorder>{texture, sampler}, in, out);
  }
}

template <class F>
size_t MipOfFormat(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return ForEachLodBlock(texture, sampler, in, out, [&](const Lookups& block, const Texels& to) {
    if (has_border(sampler)) {
      MipBlock<F, true>(texture, sampler, block, to);
    } else {
      MipBlock<F, false>(texture, sampler, block, to);
    }
  });
}

struct MipOfTexture {
  const Texture& texture;
  const Sampler& sampler;
  const Lookups& in;
  const Texels& out;

  template <class F>
  size_t run() const {
    return MipOfFormat<F>(texture, sampler, in, out);
  }
};

size_t MipBatch(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return ForFormat(texture, MipOfTexture{texture, sampler, in, out});
}

#if HWY_TARGET == HWY_STATIC_TARGET
void RecordMip(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  MipOfFormat<Recorded>(texture, sampler, in, out);
}
#endif

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(MipBatch);
}  // namespace

size_t sample_mip(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                  const Texels& out) {
  return SHD_DISPATCH(MipBatch, simd)(texture, sampler, lookups, out);
}

void record_mip(const Texture& texture, const Sampler& sampler, const Lookups& lookups) {
  float unused[1];
  HWY_STATIC_DISPATCH(RecordMip)(texture, sampler, lookups, {{unused}});
}

}  // namespace shd::texture
#endif
