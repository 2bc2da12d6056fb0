// SPDX-License-Identifier: MIT
// Lookups that lie all over a large texture wait for memory, one vector after the other. The cache lines of a few
// vectors are asked for at once before they are filtered; where neighbours lie near each other that would only cost.

#if defined(SHD_TEXTURE_PREFETCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PREFETCH_INL_H_
#undef SHD_TEXTURE_PREFETCH_INL_H_
#else
#define SHD_TEXTURE_PREFETCH_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/batch-inl.h"
#include "texture/block.h"
#include "texture/filter-inl.h"
#include "texture/scatter.h"
#include "texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Asks for the rows of the quads on `levels` levels from floor(lod).
struct PrefetchQuads {
  const Texture& texture;
  const Sampler& sampler;
  uint32_t levels;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels&, size_t) const {
    const auto u = ReduceCoordinate(d, sampler.wrap_u, p.u), v = ReduceCoordinate(d, sampler.wrap_v, p.v);
    const auto last = hn::Set(d, static_cast<float>(texture.level_count - 1));
    auto level = hn::Floor(p.lod);
    for (uint32_t k = 0; k < levels; ++k) {
      quad(d, LevelAt(d, texture, p.first_texel, level), u, v);
      level = hn::Min(hn::Add(level, hn::Set(d, 1.0f)), last);
    }
  }

  template <class D, class V>
  HWY_INLINE void quad(D d, const Level<D>& level, V u, V v) const {
    const LinearTaps<D> x = WrapLinear(d, sampler.wrap_u, u, level.across);
    const LinearTaps<D> y = WrapLinear(d, sampler.wrap_v, v, level.down);
    row(d, hn::Add(RowIndex(d, level, y.i0), x.i0));
    row(d, hn::Add(RowIndex(d, level, y.i1), x.i0));
  }

  template <class D>
  HWY_INLINE void row(D, Ints<D> texel) const {
    const hn::RebindToSigned<D> di;
    alignas(64) int32_t index[kMaxLanes];
    hn::Store(texel, di, index);
    const size_t size = texel_size(texture);
    const uint8_t *own = texture.origin, *borrowed = texture.borrowed;
    for (size_t k = 0; k < hn::Lanes(di); ++k) {
      const auto i = static_cast<uint32_t>(index[k]);
      __builtin_prefetch((i < texture.borrowed_texels ? borrowed : own) + i * size);
    }
  }
};

/// filter(part, out) for a block, in parts whose lines are asked for if its lookups are scattered; `levels` of the
/// pyramid are read.
template <class Filter>
HWY_INLINE void WithPrefetch(const Texture& texture, const Sampler& sampler, const Lookups& block, const Texels& out,
                             uint32_t levels, const float* lod, const Filter& filter) {
  constexpr size_t kPart = 64;  // 16 KiB of lines at two levels
  if (!is_scattered(texture, block, lod)) return filter(block, out);
  for (size_t first = 0; first < block.count; first += kPart) {
    const Lookups part = part_of(block, first, block.count - first < kPart ? block.count - first : kPart);
    const Lookups points = {part.count,          part.u,     part.v, nullptr, nullptr, nullptr, nullptr,
                            part_of(lod, first), part.layer, nullptr};
    ForEachVector(texture, PrefetchQuads{texture, sampler, levels}, points, {});
    filter(part, part_of(out, first));
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PREFETCH_INL_H_
