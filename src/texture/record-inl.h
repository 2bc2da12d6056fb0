// SPDX-License-Identifier: MIT
// The format class of a kernel that records itself: one lane, whose values are the numbers of nodes (record.h).

#if defined(SHD_TEXTURE_RECORD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_RECORD_INL_H_
#undef SHD_TEXTURE_RECORD_INL_H_
#else
#define SHD_TEXTURE_RECORD_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/record.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Recorded {
  static constexpr bool kWords = false;
  template <class D>
  using Texel = Ints<D>;

  template <class D>
  static HWY_INLINE Texel<D> fetch(D, const Texture&, Ints<D> index) {
    return index;
  }
};

template <bool kBorder>
struct Blend<Recorded, kBorder> {
  struct Node {
    uint32_t id;
  };
  template <class D>
  using Value = Node;

  template <size_t C, class D>
  static HWY_INLINE Node tap(D d, Ints<D> index, MaskOf<D> in, const Sampler&) {
    return {t_recording->tap(static_cast<uint32_t>(hn::GetLane(index)), kBorder && hn::AllFalse(d, in))};
  }
  template <class D>
  static HWY_INLINE Node blend(D, Node a, Node b, hn::Vec<D> s) {
    return {t_recording->blend(a.id, b.id, hn::GetLane(s))};
  }
  template <class D>
  static HWY_INLINE Node blend_u(D d, Node a, Node b, hn::Vec<D> s, hn::Vec<D>) {
    return blend(d, a, b, s);
  }
  template <class D>
  static HWY_INLINE Node blend_v(D d, Node a, Node b, hn::Vec<D> s, hn::Vec<D>) {
    return blend(d, a, b, s);
  }
  template <class D>
  static HWY_INLINE Node join(D d, MaskOf<D> first, Node a, Node b, hn::Vec<D> s, hn::Vec<D>, hn::Vec<D>) {
    return hn::AllTrue(d, first) ? b : blend(d, a, b, s);
  }
  template <size_t C, class D>
  static HWY_INLINE void store(D, Node value, const Texels&, size_t) {
    t_recording->root = value.id;
    t_recording->finished_taps = kBorder;
  }
  static HWY_INLINE bool wanted(const Texels& out, size_t channel) { return out.channel[channel] != nullptr; }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RECORD_INL_H_
