// SPDX-License-Identifier: MIT
// Levels of a texture, and the addresses of texels in them.

#if defined(SHD_TEXTURE_LEVEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_LEVEL_INL_H_
#undef SHD_TEXTURE_LEVEL_INL_H_
#else
#define SHD_TEXTURE_LEVEL_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/integer-inl.h"
#include "simd/kernel_part.h"
#include "simd/round-inl.h"
#include "texture/lanes-inl.h"
#include "texture/store/storage.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::RoundUp;
using simd::HWY_NAMESPACE::ToInt;

/// Size of one axis of a level, as a float and as an integer.
template <class D>
struct AxisSize {
  hn::Vec<D> real;
  Ints<D> whole;
};

/// Size and first texel of one level per lane. All lanes may have the same level.
template <class D>
struct Level {
  AxisSize<D> across, down;
  Ints<D> offset;
};

template <class D>
SHD_KERNEL_PART Level<D> SameLevel(D d, const Texture& texture, Ints<D> first_texel, uint32_t level) {
  const hn::RebindToSigned<D> di;
  const auto width = static_cast<int32_t>(level_size(texture.width, level));
  const auto height = static_cast<int32_t>(level_size(texture.height, level));
  return {{hn::Set(d, static_cast<float>(width)), hn::Set(di, width)},
          {hn::Set(d, static_cast<float>(height)), hn::Set(di, height)},
          first_texel + hn::Set(di, static_cast<int32_t>(texture.layout.offset[level]))};
}

/// Returns max(1, floor(base * scale)), where scale is a power of two. This is exact, because sizes are below 2^24.
template <class D, class V>
HWY_INLINE AxisSize<D> ScaledSize(D d, uint32_t base, V scale) {
  const V size = hn::Max(RoundDown(hn::Set(d, static_cast<float>(base)) * scale), hn::Set(d, 1.0f));
  return {size, ToInt(size)};
}

template <class D>
SHD_KERNEL_PART Level<D> LevelPerLane(D d, const Texture& texture, Ints<D> first_texel, Ints<D> level) {
  const hn::RebindToSigned<D> di;
  const auto scale = hn::BitCast(d, hn::ShiftLeft<23>(hn::Set(di, 127) - level));
  return {ScaledSize(d, texture.width, scale), ScaledSize(d, texture.height, scale),
          first_texel + hn::GatherIndex(di, reinterpret_cast<const int32_t*>(texture.layout.offset), level)};
}

/// Returns one level per lane. `level` contains integer-valued floats. A faster path with the same bits is used if all
/// lanes have the same level.
template <class D>
HWY_INLINE Level<D> LevelAt(D d, const Texture& texture, Ints<D> first_texel, hn::Vec<D> level) {
  const float first = hn::GetLane(level);
  if (hn::AllTrue(d, hn::Eq(level, hn::Set(d, first)))) {
    return SameLevel(d, texture, first_texel, static_cast<uint32_t>(first));
  }
  return LevelPerLane(d, texture, first_texel, ToInt(level));
}

/// Returns the number of the nearest level: ceil(lod + 1/2) - 1 (Vulkan 1.3 specification, "Image Level(s) Selection").
template <class D>
HWY_INLINE hn::Vec<D> NearestLevel(D d, hn::Vec<D> lod) {
  return hn::Max(RoundUp(lod + hn::Set(d, 0.5f)) - hn::Set(d, 1.0f), hn::Zero(d));
}

/// The two levels around the level of detail of each lane.
template <class D>
struct LevelPair {
  Level<D> high, low;   // floor(lod), and the next coarser level
  hn::Vec<D> fraction;  // share of `low`, [0, 1)
  bool blended;         // some fraction is not 0; otherwise `low` is not set
};

template <class D>
SHD_KERNEL_PART LevelPair<D> LevelsOf(D d, const Texture& texture, Ints<D> first_texel, hn::Vec<D> lod) {
  const auto floor = RoundDown(lod);
  const auto last = hn::Set(d, static_cast<float>(texture.level_count - 1));
  LevelPair<D> pair;
  pair.fraction = lod - floor;
  pair.blended = !hn::AllTrue(d, hn::Eq(pair.fraction, hn::Zero(d)));
  pair.high = LevelAt(d, texture, first_texel, floor);
  if (pair.blended) pair.low = LevelAt(d, texture, first_texel, hn::Min(floor + hn::Set(d, 1.0f), last));
  return pair;
}

/// Returns the index of the first texel of row y in the texture. Levels are packed rows, so addresses need no other
/// computation.
template <class D>
HWY_INLINE Ints<D> RowIndex(D, const Level<D>& level, Ints<D> y) {
  return y * level.across.whole + level.offset;
}

/// Returns the index of a texel as streams store it: ~index where the border colour replaces the texel.
template <class D>
HWY_INLINE Ints<D> TexelOrBorder(D, Ints<D> index, MaskOf<D> in) {
  const hn::RebindToSigned<D> di;
  return hn::IfThenElse(hn::RebindMask(di, in), index, hn::Not(index));
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_LEVEL_INL_H_
