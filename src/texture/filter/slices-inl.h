// SPDX-License-Identifier: MIT
// Lookups in 3D textures: quads of the two slices around a point. A 3D texture has the levels of a 2D texture, each
// with its slices one after the other.

#if defined(SHD_TEXTURE_SLICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_SLICES_INL_H_
#undef SHD_TEXTURE_SLICES_INL_H_
#else
#define SHD_TEXTURE_SLICES_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/domain/places-inl.h"
#include "texture/filter/prefetch.h"
#include "texture/filter/runner-inl.h"
#include "texture/store/level-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::RoundUp;

/// One level of a 3D texture per lane.
template <class D>
struct Slices {
  Level<D> level;  // its offset is that of slice 0
  AxisSize<D> deep;
  Ints<D> units;  // units of a slice
};

/// Returns the number of units along an axis (units_along()).
template <class D>
HWY_INLINE Ints<D> UnitsAlong(D, Ints<D> texels, uint32_t shift) {
  const hn::RebindToSigned<D> di;
  return hn::ShiftRightSame(texels + hn::Set(di, (1 << shift) - 1), static_cast<int>(shift));
}

/// Returns the number of units of an image of the size of a level.
template <class D>
HWY_INLINE Ints<D> UnitsOf(D d, const Level<D>& level, UnitShape unit) {
  if (HWY_LIKELY((unit.shift_x | unit.shift_y) == 0)) return level.across.whole * level.down.whole;
  return UnitsAlong(d, level.across.whole, unit.shift_x) * UnitsAlong(d, level.down.whole, unit.shift_y);
}

/// Returns one level per lane. `level` contains integer-valued floats.
template <class D>
SHD_KERNEL_PART Slices<D> SlicesAt(D d, const Texture& texture, hn::Vec<D> level) {
  const hn::RebindToSigned<D> di;
  const auto scale = hn::BitCast(d, hn::ShiftLeft<23>(hn::Set(di, 127) - ToInt(level)));
  Slices<D> slices;
  slices.level = LevelAt(d, texture, hn::Zero(di), level);
  slices.deep = ScaledSize(d, texture.depth, scale);
  slices.units = UnitsOf(d, slices.level, texture.layout.unit);
  return slices;
}

/// Returns a slice as a level.
template <class D>
HWY_INLINE Level<D> SliceOf(D, const Slices<D>& slices, Ints<D> z) {
  Level<D> slice = slices.level;
  slice.offset = slice.offset + z * slices.units;
  return slice;
}

/// Returns the taps of rows of a slice, which are the border where the slice is.
template <class D>
HWY_INLINE LinearTaps<D> RowsOf(D, const LinearTaps<D>& y, MaskOf<D> slice_in) {
  LinearTaps<D> rows = y;
  rows.in0 = hn::And(y.in0, slice_in);
  rows.in1 = hn::And(y.in1, slice_in);
  return rows;
}

/// The 2 x 2 x 2 texels of a level around reduced coordinates.
template <class D>
struct Cube {
  const Slices<D>& slices;
  LinearTaps<D> x, y, z;

  SHD_KERNEL_PART Cube(D d, const Sampler& sampler, const Slices<D>& of_slices, hn::Vec<D> u, hn::Vec<D> v,
                       hn::Vec<D> w)
      : slices(of_slices),
        x(WrapLinear(d, sampler.wrap_u, u, slices.level.across)),
        y(WrapLinear(d, sampler.wrap_v, v, slices.level.down)),
        z(WrapLinear(d, sampler.wrap_w, w, slices.deep)) {
    if (HWY_LIKELY(sampler.weights != Weights::kHermite)) return;
    for (LinearTaps<D>* taps : {&x, &y, &z}) SmoothWeights(d, taps);
  }

  /// Emits the quads of the first and of the second slice.
  template <class Sink, class... AnyShare>
  HWY_INLINE void emit_first(D d, uint32_t op, Sink& sink, const AnyShare&... share) const {
    sink.quad(d, op, SliceOf(d, slices, z.i0), x, RowsOf(d, y, z.in0), share...);
  }
  template <class Sink, class AnyShare>
  HWY_INLINE void emit_second(D d, uint32_t op, Sink& sink, const AnyShare& share) const {
    sink.quad(d, op, SliceOf(d, slices, z.i1), x, RowsOf(d, y, z.in1), share);
  }
};

/// Emits the linear interpolation at a place as the start of an average.
template <class D, class Sink>
HWY_INLINE void EmitLinear(D d, const Sampler& sampler, const Slices<D>& slices, hn::Vec<D> u, hn::Vec<D> v,
                           hn::Vec<D> w, uint32_t second, Sink& sink) {
  const Cube<D> cube(d, sampler, slices, u, v, w);
  cube.emit_first(d, kStart | second, sink);
  cube.emit_second(d, kBlend | second, sink, DeepShare<D>{cube.z.s, cube.z.rate});
}

/// Base of filters of 3D textures.
template <class AnyBlock>
struct OnSlices {
  using Block = AnyBlock;

  const Texture& texture;
  const Sampler& sampler;

  OnSlices(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static bool is_scattered(const Texture& texture, const PlaceBlock& block) {
    return is_scattered_in_slices(texture, block, block.w, nullptr);
  }
  template <class LevelBlock>
  static bool is_scattered(const Texture& texture, const LevelBlock& block) {
    return is_scattered_in_slices(texture, block, block.w, block.lod);
  }
};

/// Base of filters of the base level.
template <class AnyBlock>
struct OnBaseSlices : OnSlices<AnyBlock> {
  Slices<BatchTag> base;

  OnBaseSlices(const Texture& of_texture, const Sampler& of_sampler)
      : OnSlices<AnyBlock>(of_texture, of_sampler), base(SlicesAt(BatchTag(), of_texture, hn::Zero(BatchTag()))) {}
};

/// Emits the texel that contains the point, as the start of an average.
template <class D, class Block, class Sink>
HWY_INLINE void EmitNearestTexel(D d, const Sampler& sampler, const Slices<D>& slices, const Block& block, size_t i,
                                 uint32_t second, Sink& sink) {
  MaskOf<D> in_x, in_y, in_z;
  const auto x = WrapNearest(d, sampler.wrap_u, hn::Load(d, block.u + i), slices.level.across, &in_x);
  const auto y = WrapNearest(d, sampler.wrap_v, hn::Load(d, block.v + i), slices.level.down, &in_y);
  const auto z = WrapNearest(d, sampler.wrap_w, hn::Load(d, block.w + i), slices.deep, &in_z);
  sink.texel(d, kStart | kNewLine | second, SliceOf(d, slices, z), x, y, hn::And(hn::And(in_x, in_y), in_z));
}

struct NearestInSlices : OnBaseSlices<PlaceBlock> {
  using OnBaseSlices::OnBaseSlices;

  /// Never prefetches, as Nearest.
  static bool is_scattered(const Texture&, const PlaceBlock&) { return false; }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PlaceBlock& block, size_t i, Sink& sink) const {
    EmitNearestTexel(d, sampler, base, block, i, 0, sink);
    sink.finish();
  }
};

struct NearestMipInSlices : OnSlices<PlaceLodBlock> {
  using OnSlices::OnSlices;

  static bool is_scattered(const Texture&, const PlaceLodBlock&) { return false; }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PlaceLodBlock& block, size_t i, Sink& sink) const {
    EmitNearestTexel(d, sampler, SlicesAt(d, texture, NearestLevel(d, hn::Load(d, block.lod + i))), block, i, 0, sink);
    sink.finish();
  }
};

struct LinearInSlices : OnBaseSlices<PlaceBlock> {
  using OnBaseSlices::OnBaseSlices;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PlaceBlock& block, size_t i, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i), w = hn::Load(d, block.w + i);
    EmitLinear(d, sampler, base, u, v, w, 0, sink);
    sink.finish();
  }
};

/// Numbers of the two levels around the level of detail of each lane (LevelPair). Slices are made where they are used:
/// gcc 12 copies structs of vectors by words, and loads of the vectors then wait for the stores of their parts. That
/// takes 1.16 of the time on AVX2.
template <class D>
struct LevelNumbers {
  hn::Vec<D> high, low, fraction;
  bool blended;

  HWY_INLINE LevelNumbers(D d, const Texture& texture, hn::Vec<D> lod)
      : high(RoundDown(lod)),
        low(hn::Min(high + hn::Set(d, 1.0f), hn::Set(d, static_cast<float>(texture.level_count - 1)))),
        fraction(lod - high),
        blended(!hn::AllTrue(d, hn::Eq(fraction, hn::Zero(d)))) {}
};

/// Linear on three axes, on the nearest level or between two levels. A loop over the levels has one copy of the code.
struct LinearMipInSlices : OnSlices<PlaceLodBlock> {
  using OnSlices::OnSlices;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PlaceLodBlock& block, size_t i, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i), w = hn::Load(d, block.w + i);
    const auto lod = hn::Load(d, block.lod + i);
    const LevelNumbers<D> levels(d, texture, lod);
    const bool nearest = sampler.filter == SHD_FILTER_BILINEAR_MIP, two = levels.blended && !nearest;
    auto level = nearest ? NearestLevel(d, lod) : levels.high;
    for (uint32_t second = 0;; second = kSecond) {
      EmitLinear(d, sampler, SlicesAt(d, texture, level), u, v, w, second, sink);
      if (!two || second) break;
      level = levels.low;
    }
    if (two) sink.merge(d, levels.fraction);
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_SLICES_INL_H_
