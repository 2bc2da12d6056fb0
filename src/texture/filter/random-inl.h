// SPDX-License-Identifier: MIT
// Random numbers without state: hashes of the inputs of a lane, so that a lookup depends on its own inputs only. Hashes
// of several words are nested (Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020, section 4.2).

#if defined(SHD_TEXTURE_RANDOM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_RANDOM_INL_H_
#undef SHD_TEXTURE_RANDOM_INL_H_
#else
#define SHD_TEXTURE_RANDOM_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/hash-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::kWeylStep;
using simd::HWY_NAMESPACE::MixBits;

template <class D>
using Bits = hn::Vec<hn::RebindToUnsigned<D>>;

/// Combines the bits of a point into one word.
template <class D, class V>
HWY_INLINE Bits<D> BitsOfPoint(D, V u, V v) {
  const hn::RebindToUnsigned<D> du;
  return hn::BitCast(du, u) + MixBits(du, hn::BitCast(du, v) + hn::Set(du, kWeylStep));
}

template <class D, class V>
HWY_INLINE Bits<D> BitsOfPlace(D d, V u, V v, V w) {
  const hn::RebindToUnsigned<D> du;
  return hn::BitCast(du, u) + MixBits(du, BitsOfPoint(d, v, w) + hn::Set(du, kWeylStep));
}

/// A sequence of random numbers for each lane.
template <class D>
class Rng {
 public:
  Rng() = default;
  Rng(D, Bits<D> random, uint32_t seed) {
    const hn::RebindToUnsigned<D> du;
    state_ = MixBits(du, random + MixBits(du, hn::Set(du, seed + kWeylStep)));
  }
  /// Returns the next number of some lanes. The others get any number, and their sequences stay.
  HWY_INLINE hn::Vec<D> next_if(D d, hn::Mask<D> lanes) {
    const auto before = state_;
    const auto number = next(d);
    state_ = hn::IfThenElse(hn::RebindMask(hn::RebindToUnsigned<D>(), lanes), state_, before);
    return number;
  }
  /// Returns the next number, a multiple of 2^-24, uniform in [0, 1).
  HWY_INLINE hn::Vec<D> next(D d) {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    state_ = state_ + hn::Set(du, kWeylStep);
    const auto bits = hn::BitCast(di, hn::ShiftRight<8>(MixBits(du, state_)));
    return hn::ConvertTo(d, bits) * hn::Set(d, 0x1p-24f);
  }

 private:
  Bits<D> state_;
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RANDOM_INL_H_
