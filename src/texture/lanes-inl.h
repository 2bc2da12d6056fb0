// SPDX-License-Identifier: MIT
// The vectors of lookups of one target.

#if defined(SHD_TEXTURE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_LANES_INL_H_
#undef SHD_TEXTURE_LANES_INL_H_
#else
#define SHD_TEXTURE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One vector of lookups.
using BatchTag = hn::CappedTag<float, kMaxLanes>;

template <class D>
using Ints = hn::Vec<hn::RebindToSigned<D>>;
template <class D>
using MaskOf = decltype(hn::Eq(hn::Zero(D()), hn::Zero(D())));

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_LANES_INL_H_
