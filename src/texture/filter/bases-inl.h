// SPDX-License-Identifier: MIT
// Bases of filters that read level 0, or the levels around a level of detail.

#if defined(SHD_TEXTURE_BASES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_BASES_INL_H_
#undef SHD_TEXTURE_BASES_INL_H_
#else
#define SHD_TEXTURE_BASES_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/domain/shapes-inl.h"
#include "texture/filter/prefetch.h"
#include "texture/filter/rows-inl.h"
#include "texture/store/level-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Base of filters on level 0.
struct OnBaseLevel {
  using Block = PointBlock;

  const Texture& texture;
  const Sampler& sampler;

  OnBaseLevel(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static bool is_scattered(const Texture& texture, const PointBlock& block) {
    return texture::is_scattered(texture, block, nullptr);
  }

  static RowBlock rows_of(const PointBlock& block) { return {block.u, block.v, nullptr, block.count}; }

  template <class D>
  HWY_INLINE Level<D> level(D d, const PointBlock& block, size_t i) const {
    return SameLevel(d, texture, FirstTexel(d, texture, block, i), 0);
  }
};

/// Base of filters with a level of detail.
struct OnMipLevels {
  using Block = LodBlock;

  const Texture& texture;
  const Sampler& sampler;

  OnMipLevels(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static bool is_scattered(const Texture& texture, const LodBlock& block) {
    return texture::is_scattered(texture, block, block.lod);
  }

  static RowBlock rows_of(const LodBlock& block) { return {block.u, block.v, block.lod, block.count}; }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_BASES_INL_H_
