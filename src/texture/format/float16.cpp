// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/float16.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/consume-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// binary32 of the binary16 in the lower half of every lane, exact.
template <class D, class VI>
HWY_INLINE hn::Vec<D> HalfToFloat(D d, VI half) {
  const hn::RebindToSigned<D> di;
  const auto magnitude = half & hn::Set(di, 0x7fff);
  const auto sign = hn::ShiftLeft<16>(half & hn::Set(di, 0x8000));
  const auto shifted = hn::ShiftLeft<13>(magnitude);
  const auto normal = shifted + hn::Set(di, 112 << 23);
  const auto special = shifted | hn::Set(di, 0x7f800000);
  const auto subnormal = hn::BitCast(di, hn::ConvertTo(d, magnitude) * hn::Set(d, 0x1p-24f));
  const auto finite = hn::IfThenElse(hn::Lt(magnitude, hn::Set(di, 0x400)), subnormal, normal);
  const auto bits = hn::IfThenElse(hn::Gt(magnitude, hn::Set(di, 0x7bff)), special, finite);
  return hn::BitCast(d, bits | sign);
}

struct Float16 : TwoWords {
  static constexpr bool kFloat = true;

  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> decode(D d, const Texel<D>& texel) {
    return HalfToFloat(d, half<C, D>(texel));
  }
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D, hn::Vec<D> value) {
    return value;
  }
};

}  // namespace

FormatKernels Float16Kernels() {
  return KernelsOf<Float16>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
