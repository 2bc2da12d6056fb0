// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_bicubic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/cubic-inl.h"
#include "texture/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The sixteen texels around a point, rows one after the other.
template <class F, class D>
struct Patch {
  typename F::template Texel<D> texel[16];
  CubicTaps<D> x, y;
  CubicSteps<D> across, down;
};

template <class F, class D>
SHD_KERNEL_PART void FetchPatch(D d, const Texture& texture, const Level<D>& level, Patch<F, D>* patch) {
  for (int row = 0; row < 4; ++row) {
    const auto first = RowIndex(d, level, patch->y.index[row]);
    for (int column = 0; column < 4; ++column) {
      patch->texel[4 * row + column] = F::fetch(d, texture, hn::Add(first, patch->x.index[column]));
    }
  }
}

/// Value of channel C of one row, in the lerp domain.
template <class F, bool kBorder, size_t C, class D>
SHD_KERNEL_PART auto BlendPatchRow(D d, const Patch<F, D>& patch, const Sampler& sampler, int row) {
  using B = Blend<F, kBorder>;
  constexpr int kOrder[4] = {1, 2, 0, 3};
  const auto* texel = patch.texel + 4 * row;
  auto value = B::template tap<C>(d, texel[1], hn::And(patch.x.in[1], patch.y.in[row]), sampler);
  for (int k = 1; k < 4; ++k) {
    const int column = kOrder[k];
    const auto tap = B::template tap<C>(d, texel[column], hn::And(patch.x.in[column], patch.y.in[row]), sampler);
    value = B::blend_u(d, value, tap, patch.across.step[k - 1], patch.across.rate[k - 1]);
  }
  return value;
}

template <class F, bool kBorder, class D>
struct PatchValue {
  const Patch<F, D>& patch;
  const Sampler& sampler;

  template <size_t C>
  HWY_INLINE auto of() const {
    using B = Blend<F, kBorder>;
    constexpr int kOrder[4] = {1, 2, 0, 3};
    const D d;
    auto value = BlendPatchRow<F, kBorder, C>(d, patch, sampler, 1);
    for (int k = 1; k < 4; ++k) {
      const auto row = BlendPatchRow<F, kBorder, C>(d, patch, sampler, kOrder[k]);
      value = B::blend_v(d, value, row, patch.down.step[k - 1], patch.down.rate[k - 1]);
    }
    return value;
  }
};

template <class F, bool kBorder>
struct Bicubic {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const Level<D> level = SameLevel(d, texture, p.first_texel, 0);
    Patch<F, D> patch;
    patch.x = WrapCubic(d, sampler.wrap_u, ReduceCoordinate(d, sampler.wrap_u, p.u), level.across);
    patch.y = WrapCubic(d, sampler.wrap_v, ReduceCoordinate(d, sampler.wrap_v, p.v), level.down);
    patch.across = StepsOf(d, sampler.cubic, patch.x.s, patch.x.rate);
    patch.down = StepsOf(d, sampler.cubic, patch.y.s, patch.y.rate);
    FetchPatch<F>(d, texture, level, &patch);
    StoreChannels<F, kBorder>(d, PatchValue<F, kBorder, D>{patch, sampler}, out, i);
  }
};

struct BicubicKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    return ForEachPoint<Bicubic, F>(texture, sampler, in, out);
  }
};

FilterKernels BicubicKernels() {
  return KernelsOf<BicubicKernel, true>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(BicubicKernels);
}  // namespace

FilterKernels bicubic_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(BicubicKernels, simd)();
}

}  // namespace shd::texture
#endif
