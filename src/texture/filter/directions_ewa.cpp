// SPDX-License-Identifier: MIT
// EWA on textures of directions. Ellipses are those of the image, so that texels beside its edges are those that the
// directions continue on. The ellipses of LAT_LONG are found on the equator and stretched along their parallels, at
// most over the whole circle; stretched rows are read with gaps as wide as the stretch.
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/directions_ewa.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/filter/directions-inl.h"
#include "texture/filter/ewa-inl.h"
#include "texture/filter/pick_sink-inl.h"
#include "texture/filter/run_directions-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
namespace {

/// A position of an axis that the sink folds.
template <class D>
struct FreeAxis {
  static constexpr bool kFolds = true;
  hn::Vec<D> at;

  HWY_INLINE FreeAxis(D, shd_wrap, hn::Vec<D> start, const AxisSize<D>&) : at(start) {}
  HWY_INLINE void step(D, hn::Vec<D> stride) { at = at + stride; }
  HWY_INLINE void step(D d) { at = at + hn::Set(d, 1.0f); }
  HWY_INLINE void step_if(D d, MaskOf<D> lanes) { at = at + hn::IfThenElseZero(lanes, hn::Set(d, 1.0f)); }
  HWY_INLINE void restart_if(D, MaskOf<D> lanes, hn::Vec<D> start) { at = hn::IfThenElse(lanes, start, at); }
};

struct EwaDirections {
  struct Block : EllipseBlock {
    alignas(64) float stride[kBlock];
    bool has_strides = false;
  };

  const Texture& texture;
  const Sampler& sampler;

  EwaDirections(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static bool is_scattered(const Texture& texture, const EllipseBlock& block) {
    return texture::is_scattered(texture, block, block.level);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const Block& block, size_t i, Sink& sink) const {
    EllipseWalk<D, FreeAxis<D>> walk(d, texture, sampler, block, i);
    if (block.has_strides) walk.stride = hn::Load(d, block.stride + i);
    if (!hn::AllTrue(d, walk.ellipse.is_quad)) walk.emit(d, walk.are_unlike(d), sink);
    if (!hn::AllTrue(d, hn::Eq(walk.ellipse.bilinear, hn::Zero(d)))) walk.emit_quad(d, sink);
    sink.finish();
  }
};

/// Stretches ellipses along their parallels.
void StretchShapes(const ProjectedBlock& points, const Texture& texture, EwaDirections::Block* block) {
  const BatchTag d;
  const hn::RebindToSigned<BatchTag> di;
  const auto one = hn::Set(d, 1.0f);
  block->has_strides = true;
  for (size_t i = 0; i < block->count; i += hn::Lanes(d)) {
    const auto level = simd::HWY_NAMESPACE::ToInt(hn::Load(d, block->level + i));
    const auto scale = hn::BitCast(d, hn::ShiftLeft<23>(hn::Set(di, 127) - level));
    const auto half_circle = hn::Set(d, 0.5f) * ScaledSize(d, texture.width, scale).real;
    const auto stretch = hn::Load(d, points.stretch + i), width2 = hn::Load(d, block->width2 + i);
    const auto wide = hn::Min(stretch * stretch * width2, hn::Max(half_circle * half_circle, one));
    hn::Store(wide, d, block->width2 + i);
    hn::Store(hn::Load(d, block->shear + i) * stretch, d, block->shear + i);
    hn::Store(hn::Max(RoundDown(hn::Sqrt(wide / width2)), one), d, block->stride + i);
  }
}

}  // namespace

size_t RunEwaDirections(const FilterCall& call) {
  return RunDirections<EwaDirections>(call);
}
size_t RunPickedEwaDirections(const FilterCall& call) {
  return RunDirections<EwaDirections, PickSink>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
