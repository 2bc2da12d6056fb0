// SPDX-License-Identifier: MIT
// Filters that go by the shape of a footprint: a block of shapes first, then what is filtered with them.

#if defined(SHD_TEXTURE_SHAPE_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_SHAPE_BLOCK_INL_H_
#undef SHD_TEXTURE_SHAPE_BLOCK_INL_H_
#else
#define SHD_TEXTURE_SHAPE_BLOCK_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/batch-inl.h"
#include "texture/block.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// filter(sampler, block, out) for every block of a batch, with the four columns that shape_of writes for it in place
/// of derivatives; its sampler has no width or blur, as the shapes have them.
template <class ShapeOf, class Filter>
HWY_INLINE size_t ForEachShapeBlock(const Texture& texture, const Sampler& sampler, const ShapeOf& shape_of,
                                    const Lookups& in, const Texels& out, const Filter& filter) {
  const Sampler plain = unwidened(sampler);
  alignas(64) float columns[4][kBlock];
  size_t nonfinite = 0;
  for (size_t first = 0; first < in.count; first += kBlock) {
    const size_t count = in.count - first < kBlock ? in.count - first : kBlock;
    const Lookups given = part_of(in, first, count);
    nonfinite += ForEachVector(texture, shape_of, given, {{columns[0], columns[1], columns[2], columns[3]}, {}, {}});
    filter(plain,
           Lookups{count, given.u, given.v, columns[0], columns[1], columns[2], columns[3], nullptr, given.layer,
                   given.random},
           part_of(out, first));
  }
  return nonfinite;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_SHAPE_BLOCK_INL_H_
