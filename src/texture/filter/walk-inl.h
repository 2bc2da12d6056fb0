// SPDX-License-Identifier: MIT
// Walks over consecutive texels along one axis. Only the first texel is wrapped by a division.

#if defined(SHD_TEXTURE_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_WALK_INL_H_
#undef SHD_TEXTURE_WALK_INL_H_
#else
#define SHD_TEXTURE_WALK_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/kernel_part.h"
#include "simd/round-inl.h"
#include "texture/domain/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// Distance from a level at which wraps without repetition read one texel only, longer than any walk [texels].
constexpr float kFarOutside = 512.0f;

/// A coordinate in texels whose centres are integers, and its derivative in the normalised coordinate.
template <class D>
struct TexelPoint {
  hn::Vec<D> x, rate;
};

/// Converts a reduced coordinate to texels. Wraps without repetition clamp it at kFarOutside.
template <class D>
HWY_INLINE TexelPoint<D> PointOf(D d, shd_wrap wrap, hn::Vec<D> reduced, hn::Vec<D> size) {
  using V = hn::Vec<D>;
  const V scaled = reduced * size;
  const V x = (wrap == SHD_WRAP_MIRROR ? scaled + scaled : scaled) - hn::Set(d, 0.5f);
  if (wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR) return {x, size};
  const V outside = size + hn::Set(d, kFarOutside);
  const V near = hn::Min(hn::Max(x, hn::Neg(outside)), outside);
  return {near, hn::IfThenElseZero(hn::Eq(near, x), size)};
}

/// A position on an axis that advances by one texel per step; |start| <= 2 (size + kFarOutside).
template <class D>
class Walk {
 public:
  static constexpr bool kFolds = false;

  HWY_INLINE Walk(D d, shd_wrap wrap, hn::Vec<D> start, const AxisSize<D>& size) : wrap_(wrap), size_(size.whole) {
    end_ = wrap == SHD_WRAP_MIRROR ? size_ + size_ : size_;
    real_end_ = wrap == SHD_WRAP_MIRROR ? size.real + size.real : size.real;
    at_ = wrapped(d, start);
  }
  HWY_INLINE void step(D) {
    const hn::RebindToSigned<D> di;
    at_ = at_ + hn::Set(di, 1);
    if (is_periodic()) at_ = hn::IfThenZeroElse(hn::Eq(at_, end_), at_);
  }
  /// Advances some lanes.
  HWY_INLINE void step_if(D d, MaskOf<D> lanes) {
    const Ints<D> before = at_;
    step(d);
    at_ = hn::IfThenElse(hn::RebindMask(hn::RebindToSigned<D>(), lanes), at_, before);
  }
  /// Restarts some lanes at `start`.
  HWY_INLINE void restart_if(D d, MaskOf<D> lanes, hn::Vec<D> start) {
    at_ = hn::IfThenElse(hn::RebindMask(hn::RebindToSigned<D>(), lanes), wrapped(d, start), at_);
  }
  /// Returns the index of the texel, 0..size - 1. Lanes of `in` are clear for the border colour (SHD_WRAP_BORDER only).
  HWY_INLINE Ints<D> index(D d, MaskOf<D>* in) const {
    const hn::RebindToSigned<D> di;
    *in = hn::Eq(hn::Zero(d), hn::Zero(d));
    switch (wrap_) {
      case SHD_WRAP_REPEAT: return at_;
      case SHD_WRAP_MIRROR: return Fold(di, at_, size_);
      case SHD_WRAP_MIRROR_ONCE: return FoldOnce(di, at_, size_);
      case SHD_WRAP_BORDER: return ClampBorder(d, at_, size_, in);
      default: return hn::Min(hn::Max(at_, hn::Zero(di)), size_ - hn::Set(di, 1));
    }
  }

 private:
  HWY_INLINE bool is_periodic() const { return wrap_ == SHD_WRAP_REPEAT || wrap_ == SHD_WRAP_MIRROR; }
  HWY_INLINE Ints<D> wrapped(D, hn::Vec<D> start) const {
    const hn::RebindToSigned<D> di;
    if (is_periodic()) start = start - RoundDown(start / real_end_) * real_end_;
    return hn::ConvertTo(di, start);
  }

  shd_wrap wrap_;
  hn::Vec<D> real_end_;
  Ints<D> size_, end_, at_;
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_WALK_INL_H_
