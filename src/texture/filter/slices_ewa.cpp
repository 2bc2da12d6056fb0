// SPDX-License-Identifier: MIT
// EWA in 3D textures: the average of the texels inside an ellipsoid (domain/ellipses.cpp), slice by slice. Each slice
// is an ellipse of ewa-inl.h whose weights begin at the part of r^2 that comes from the distance of the slice.
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/slices_ewa.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/ellipsoid-inl.h"
#include "texture/filter/ewa-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/slices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// The slice of an ellipsoid that a walk visits.
template <class D>
struct WalkedSlice {
  static constexpr bool kSolid = true;

  hn::Vec<D> height, along_z;  // part of r^2 that comes from the distance dz of the slice; dz / depth2
  hn::Vec<D> slide_x, slide_y, rate;
  MaskOf<D> in;  // false = border colour

  /// Returns minus half the derivative of r^2 in w. The centre of the slice moves by -slide per texel of w.
  HWY_INLINE hn::Vec<D> along(hn::Vec<D> along_x, hn::Vec<D> along_y) const {
    return (along_z - (slide_x * along_x + slide_y * along_y)) * rate;
  }
};

/// Shares of the quads of linear in the average of an ellipsoid. After both quads linear has the share b, and their
/// shares are in the ratio 1 - s to s. With b = 1 the average starts with the first quad.
template <class D>
struct LinearShares {
  DeepShare<D> first, second;

  HWY_INLINE LinearShares(D d, const LinearTaps<D>& z, hn::Vec<D> b) {
    using V = hn::Vec<D>;
    const V one = hn::Set(d, 1.0f), rest = one - b * z.s;
    const auto alone = hn::Eq(b, one);
    first.value = hn::IfThenElse(alone, hn::Set(d, kWhole), b * (one - z.s) / rest);
    first.rate = hn::IfThenZeroElse(alone, b * (b - one) / (rest * rest) * z.rate);
    second.value = b * z.s;
    second.rate = b * z.rate;
  }
};

/// Emits linear with its share in the average of an ellipsoid. Inline, the filter
/// would have its variables in memory.
template <class D, class Sink>
HWY_NOINLINE void EmitLinearShare(D d, const Sampler& sampler, const Slices<D>& slices, hn::Vec<D> u, hn::Vec<D> v,
                                  hn::Vec<D> w, hn::Vec<D> share, uint32_t how, Sink& sink) {
  const Cube<D> cube(d, sampler, slices, u, v, w);
  const LinearShares<D> shares(d, cube.z, share);
  cube.emit_first(d, how, sink, shares.first);
  cube.emit_second(d, kBlend, sink, shares.second);
}

struct EwaInSlices : OnSlices<EllipsoidBlock> {
  using OnSlices::OnSlices;

  static bool is_scattered(const Texture& texture, const EllipsoidBlock& block) {
    return is_scattered_in_slices(texture, block, block.w, block.level);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const EllipsoidBlock& block, size_t i, Sink& sink) const {
    EllipseWalk<D, Walk<D>, WalkedSlice<D>> walk(d, texture, sampler, block, i);
    const Slices<D> slices = SlicesAt(d, texture, hn::Load(d, block.level + i));
    if (!hn::AllTrue(d, walk.ellipse.is_quad)) emit_slices(d, slices, block, i, walk, sink);
    const auto share = hn::Load(d, block.bilinear + i);
    if (!hn::AllTrue(d, hn::Eq(share, hn::Zero(d)))) {
      const auto& at = walk.ellipse;
      EmitLinearShare(d, sampler, slices, at.u, at.v, hn::Load(d, block.w + i), share, walk.how(true), sink);
    }
    sink.finish();
  }

 private:
  template <class D, class AnyWalk, class Sink>
  HWY_INLINE void emit_slices(D d, const Slices<D>& slices, const EllipsoidBlock& block, size_t i, AnyWalk& walk,
                              Sink& sink) const {
    Ellipse<D>& ellipse = walk.ellipse;
    const EllipsoidDepth<D> depth(d, sampler, slices, ellipse, block, i);
    auto& slice = walk.slice;
    slice.slide_x = depth.slide_x;
    slice.slide_y = depth.slide_y;
    slice.rate = depth.z.rate;
    const bool unlike = walk.are_unlike(d);
    const float max_slice = depth.max_slice(d);
    Walk<D> deep(d, sampler.wrap_w, depth.first, slices.deep);
    for (float k = 0.0f; k <= max_slice; k += 1.0f) {
      const EllipsoidSection<D> section(d, depth, hn::Set(d, k));
      slice.height = section.height;
      slice.along_z = section.dz * depth.per_depth2;
      ellipse.x.x = section.x;
      ellipse.y.x = section.y;
      ellipse.level = SliceOf(d, slices, deep.index(d, &slice.in));
      const auto rest = hn::Max(hn::Set(d, 1.0f) - section.height, hn::Zero(d));
      walk.set_rows(d, hn::Sqrt(rest * ellipse.height2), section.empty);
      walk.emit(d, unlike, sink);
      deep.step(d);
    }
  }
};

}  // namespace

size_t RunEwaInSlices(const FilterCall& call) {
  return Run<EwaInSlices>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
