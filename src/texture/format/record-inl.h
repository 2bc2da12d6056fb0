// SPDX-License-Identifier: MIT
// The Format and the Blend that record one lookup. Their values are node numbers (record.h). All lanes are copies of
// the lookup; only the first lane is recorded.

#if defined(SHD_TEXTURE_RECORD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_RECORD_INL_H_
#undef SHD_TEXTURE_RECORD_INL_H_
#else
#define SHD_TEXTURE_RECORD_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/consume-inl.h"
#include "texture/format/record.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Recorded {
  template <class D>
  using Texel = Ints<D>;

  template <class D>
  static HWY_INLINE Texel<D> fetch(D, const TexelSource&, const int32_t* index) {
    return hn::Load(hn::RebindToSigned<D>(), index);
  }
  template <class D>
  static HWY_INLINE void fetch_quad(D, const TexelSource&, const int32_t* upper, const int32_t* lower,
                                    Texel<D> (&quad)[4]) {
    const hn::RebindToSigned<D> di;
    for (size_t k = 0; k < 4; ++k) {
      quad[k] = hn::Load(di, k < 2 ? upper : lower) + hn::Set(di, static_cast<int32_t>(k % 2));
    }
  }
  template <class D>
  static HWY_INLINE void fetch_row(D, const TexelSource&, const int32_t* index, Texel<D> (&row)[4]) {
    const hn::RebindToSigned<D> di;
    for (int k = 0; k < 4; ++k) row[k] = hn::Load(di, index) + hn::Set(di, k);
  }
};

struct RecordedBlend {
  struct Node {
    uint32_t id;
  };
  template <class D>
  using Value = Node;

  Recording* recording;

  explicit RecordedBlend(const Consumption& consumption) : recording(consumption.recording) {}

  template <size_t C, class D>
  HWY_INLINE Node tap(D, Ints<D> index, MaskOf<D>) const {
    return {recording->tap(static_cast<uint32_t>(hn::GetLane(index)))};
  }
  template <class D>
  HWY_INLINE Node blend(D, Node a, Node b, hn::Vec<D> s) const {
    return hn::GetLane(s) == kWhole ? b : Node{recording->blend(a.id, b.id, hn::GetLane(s))};
  }
  template <class D>
  HWY_INLINE Node blend_s(D d, Node a, Node b, hn::Vec<D> s, const float*) const {
    return blend(d, a, b, s);
  }
  template <class D>
  HWY_INLINE Node blend_t(D d, Node a, Node b, hn::Vec<D> t, const float*) const {
    return blend(d, a, b, t);
  }
  template <class D>
  HWY_INLINE Node blend_by(D d, Node a, Node b, hn::Vec<D> s, const float*, const float*) const {
    return blend(d, a, b, s);
  }
  template <class D>
  HWY_INLINE Node replace(D, MaskOf<D>, Node a, Node) const {
    return a;
  }
  static constexpr uint32_t kRates = kRated;
  static constexpr size_t kResults = 1, kFirstColumn = 0;

  /// Is never called, because a recording has no output columns.
  template <size_t C, class D>
  HWY_INLINE hn::Vec<D> finish(D d, Node, size_t) const {
    return hn::Zero(d);
  }
  static HWY_INLINE bool wanted(const Texels&, size_t channel) { return channel == 0; }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RECORD_INL_H_
