// SPDX-License-Identifier: MIT
// The levels of detail of a block of lookups, found before any of them is filtered: the two chains of dependent
// operations then overlap with those of other lookups (25 to 30 % of trilinear on AVX-512).

#if defined(SHD_TEXTURE_LOD_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_LOD_BLOCK_INL_H_
#undef SHD_TEXTURE_LOD_BLOCK_INL_H_
#else
#define SHD_TEXTURE_LOD_BLOCK_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/batch-inl.h"
#include "texture/block.h"
#include "texture/lod-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Writes the clamped level of detail of each lookup to the first column.
struct LevelOfDetail {
  const Texture& texture;
  const Sampler& sampler;
  LodRange range;
  bool lod_given;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
    const auto lambda = lod_given ? p.lod : LambdaOf(d, p.derivatives, width, height);
    hn::StoreU(ClampLod(d, lambda, sampler.lod_bias, range), d, out.channel[0] + i);
  }
};

/// filter(block, out) for every block of a batch, with the clamped levels of detail in the block's lod column.
template <class Filter>
HWY_INLINE size_t ForEachLodBlock(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out,
                                  const Filter& filter) {
  const LevelOfDetail level_of_detail = {texture, sampler, lod_range(texture, sampler), in.lod != nullptr};
  alignas(64) float lod[kBlock];
  size_t nonfinite = 0;
  for (size_t first = 0; first < in.count; first += kBlock) {
    const size_t count = in.count - first < kBlock ? in.count - first : kBlock;
    const Lookups given = part_of(in, first, count);
    nonfinite += ForEachVector(texture, level_of_detail, given, {{lod}, {}, {}});
    filter(Lookups{count, given.u, given.v, nullptr, nullptr, nullptr, nullptr, lod, given.layer, given.random},
           part_of(out, first));
  }
  return nonfinite;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_LOD_BLOCK_INL_H_
