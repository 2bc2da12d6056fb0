// SPDX-License-Identifier: MIT
// Elements of a stream, as filters emit them to sinks.

#if defined(SHD_TEXTURE_EMITTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_EMITTER_INL_H_
#undef SHD_TEXTURE_EMITTER_INL_H_
#else
#define SHD_TEXTURE_EMITTER_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/domain/wrap-inl.h"
#include "texture/store/level-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A share in a running average that depends on the point, with its derivatives in u and v, or in w alone.
template <class D>
struct Share {
  hn::Vec<D> value, rate_u, rate_v;
  uint32_t rates = kRated;  // kDeep: rate_u is the derivative in w
};

/// A share in a running average that depends on w, with its derivative in w.
template <class D>
struct DeepShare {
  hn::Vec<D> value, rate;
};

/// A texel of an image: its column and its row, and the first unit of the level of the image (Level::offset).
template <class D>
struct TexelPlace {
  Ints<D> x, y, first;
};

/// Shares of the last three of four texels in their running average, and their derivatives.
template <class D>
struct RowShares {
  hn::Vec<D> share[3], rate[3];
};

/// Four texels of a row of a level around a point, in the order of columns 1, 2, 0, 3.
template <class D>
struct Row : RowShares<D> {
  Ints<D> column[4], y;
  MaskOf<D> in[4];
  bool neighbours;  // columns are adjacent
};

/// Base of sinks, to which filters emit elements. A Sink has these members:
///
///   add(d)         returns the position of a new element in elements()
///   commit(d, op)  completes the new element
///   finish()       marks the latest element as the last one of its vector of lookups
///   sampler()      the sampler
///   bordered()     texels may be the border colour
///   places()       null, or the places of texels, if a store places the stream later
///   kTakesLines    takes whole lines of probes with equal weights
///   has_rates()    shares need their derivatives
///   rates_in_w()   these are the derivatives in w
///
/// Sinks of Run() also have begin() and flush() for each block of lookups, and kBuffered.
///
/// A share is a vector, a Share or a DeepShare. Elements that start an average have no share.
template <class Sink>
class Emitter {
 public:
  Emitter() = default;
  static constexpr bool kTakesLines = false;
  static constexpr StreamPlaces* places() { return nullptr; }
  static constexpr bool rates_in_w() { return false; }
  Emitter(const Emitter&) = delete;
  Emitter& operator=(const Emitter&) = delete;

  /// Emits the quad of a level around reduced coordinates.
  template <class D, class... AnyShare>
  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, const AnyShare&... share) {
    const Sampler& sampler = self().sampler();
    LinearTaps<D> x = WrapLinear(d, sampler.wrap_u, u, level.across);
    LinearTaps<D> y = WrapLinear(d, sampler.wrap_v, v, level.down);
    if (HWY_UNLIKELY(sampler.weights != Weights::kLinear)) ChangeWeights(d, sampler.weights, &x, &y);
    quad(d, op, level, x, y, share...);
  }

  /// Emits the quad of columns x and rows y of a level.
  template <class D, class... AnyShare>
  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, const LinearTaps<D>& x, const LinearTaps<D>& y,
                       const AnyShare&... share) {
    const hn::RebindToSigned<D> di;
    const size_t at = self().add(d);
    auto& to = self().elements();
    hn::Store(x.s, d, to.s + at);
    hn::Store(y.s, d, to.t + at);
    if (HWY_UNLIKELY(self().has_rates())) {
      hn::Store(x.rate, d, to.rate_s + at);
      hn::Store(y.rate, d, to.rate_t + at);
    }
    op |= kQuad | write_share(d, at, share...);
    if (HWY_UNLIKELY(self().places() != nullptr)) {
      write_row(d, 0, at, y.i0, y.in0);
      write_row(d, 1, at, y.i1, y.in1);
      write_image(d, 0, at, level.offset, level);
      const bool adjacent = !self().bordered() && hn::AllTrue(di, hn::Eq(x.i1, x.i0 + hn::Set(di, 1)));
      write_column(d, 0, at, x.i0, x.in0);
      if (HWY_LIKELY(adjacent)) return self().commit(d, op | kNeighbours);
      write_column(d, 1, at, x.i1, x.in1);
      write_column(d, 2, at, x.i0, x.in0);
      write_column(d, 3, at, x.i1, x.in1);
      return self().commit(d, op);
    }
    const auto top = RowIndex(d, level, y.i0), bottom = RowIndex(d, level, y.i1);
    if (HWY_UNLIKELY(self().bordered())) {
      write_texel(d, 0, at, top + x.i0, hn::And(x.in0, y.in0));
      write_texel(d, 1, at, top + x.i1, hn::And(x.in1, y.in0));
      write_texel(d, 2, at, bottom + x.i0, hn::And(x.in0, y.in1));
      write_texel(d, 3, at, bottom + x.i1, hn::And(x.in1, y.in1));
      return self().commit(d, op);
    }
    hn::Store(top + x.i0, di, to.index[0] + at);
    hn::Store(bottom + x.i0, di, to.index[2] + at);
    if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(x.i1, x.i0 + hn::Set(di, 1))))) return self().commit(d, op | kNeighbours);
    hn::Store(top + x.i1, di, to.index[1] + at);
    hn::Store(bottom + x.i1, di, to.index[3] + at);
    self().commit(d, op);
  }

  /// Emits the quad of four texels of images of one size, none of which is the border.
  template <class D, class... AnyShare>
  HWY_INLINE void quad_of(D d, uint32_t op, const Level<D>& level, const TexelPlace<D> (&texel)[4], hn::Vec<D> s,
                          hn::Vec<D> t, const AnyShare&... share) {
    const size_t at = self().add(d);
    auto& to = self().elements();
    hn::Store(s, d, to.s + at);
    hn::Store(t, d, to.t + at);
    op |= kQuad | write_share(d, at, share...);
    self().commit(d, op | write_apart(d, at, level, texel));
  }

  template <class D, class AnyShare>
  HWY_INLINE void row(D d, uint32_t op, const Level<D>& level, const Row<D>& row, const AnyShare& share) {
    const size_t at = self().add(d);
    op |= kRow | write_row_shares(d, at, row, share);
    const bool neighbours = row.neighbours && !self().bordered();
    if (HWY_UNLIKELY(self().places() != nullptr)) {
      for (size_t k = 0; k < 4; ++k) write_column(d, k, at, row.column[k], row.in[k]);
      write_row(d, 0, at, row.y, hn::Eq(row.share[0], row.share[0]));
      write_image(d, 0, at, level.offset, level);
      return self().commit(d, neighbours ? op | kNeighbours : op);
    }
    const auto first = RowIndex(d, level, row.y);
    if (HWY_LIKELY(neighbours)) {
      hn::Store(first + row.column[2], hn::RebindToSigned<D>(), self().elements().index[2] + at);
      return self().commit(d, op | kNeighbours);
    }
    for (size_t k = 0; k < 4; ++k) write_texel(d, k, at, first + row.column[k], row.in[k]);
    self().commit(d, op);
  }

  /// Emits the average of four texels of images of one size, as row() does, none of which is the border.
  template <class D, class AnyShare>
  HWY_INLINE void row_of(D d, uint32_t op, const Level<D>& level, const TexelPlace<D> (&texel)[4],
                         const RowShares<D>& shares, const AnyShare& share) {
    const size_t at = self().add(d);
    op |= kRow | write_row_shares(d, at, shares, share);
    self().commit(d, op | write_apart(d, at, level, texel));
  }

  /// Emits the texel of a level.
  template <class D, class... AnyShare>
  HWY_INLINE void texel(D d, uint32_t op, const Level<D>& level, Ints<D> x, Ints<D> y, MaskOf<D> in,
                        const AnyShare&... share) {
    texel(d, op, level, TexelPlace<D>{x, y, level.offset}, in, share...);
  }
  template <class D, class... AnyShare>
  HWY_INLINE void texel(D d, uint32_t op, const Level<D>& level, const TexelPlace<D>& texel, MaskOf<D> in,
                        const AnyShare&... share) {
    const size_t at = self().add(d);
    if (HWY_UNLIKELY(self().places() != nullptr)) {
      write_column(d, 0, at, texel.x, in);
      write_row(d, 0, at, texel.y, in);
      write_image(d, 0, at, texel.first, level);
    } else {
      write_texel(d, 0, at, IndexOf(d, level, texel), in);
    }
    self().commit(d, op | write_share(d, at, share...));
  }

  /// Emits the merge of the second average into the first.
  template <class D, class AnyShare>
  HWY_INLINE void merge(D d, const AnyShare& share) {
    const size_t at = self().add(d);
    self().commit(d, kMerge | write_share(d, at, share));
  }

 private:
  HWY_INLINE Sink& self() { return static_cast<Sink&>(*this); }

  template <class D>
  HWY_INLINE void write_texel(D d, size_t k, size_t at, Ints<D> index, MaskOf<D> in) {
    const Ints<D> texel = HWY_UNLIKELY(self().bordered()) ? TexelOrBorder(d, index, in) : index;
    hn::Store(texel, hn::RebindToSigned<D>(), self().elements().index[k] + at);
  }

  /// Write parts of the place of a texel. Texels that are not `in` are the border.
  template <class D>
  HWY_INLINE void write_column(D d, size_t k, size_t at, Ints<D> column, MaskOf<D> in) {
    hn::Store(place_or_border(d, column, in), hn::RebindToSigned<D>(), self().elements().index[k] + at);
  }
  template <class D>
  HWY_INLINE void write_row(D d, size_t k, size_t at, Ints<D> y, MaskOf<D> in) {
    hn::Store(place_or_border(d, y, in), hn::RebindToSigned<D>(), self().places()->y[k] + at);
  }
  template <class D>
  HWY_INLINE Ints<D> place_or_border(D, Ints<D> place, MaskOf<D> in) {
    const hn::RebindToSigned<D> di;
    return HWY_UNLIKELY(self().bordered()) ? hn::IfThenElse(hn::RebindMask(di, in), place, hn::Set(di, -1)) : place;
  }
  template <class D>
  HWY_INLINE void write_image(D, size_t k, size_t at, Ints<D> first, const Level<D>& level) {
    const hn::RebindToSigned<D> di;
    hn::Store(first, di, self().places()->first[k] + at);
    hn::Store(level.across.whole, di, self().places()->width + at);
  }

  /// Writes four texels with rows and images of their own. Returns flags of the element.
  template <class D>
  HWY_INLINE uint32_t write_apart(D d, size_t at, const Level<D>& level, const TexelPlace<D> (&texel)[4]) {
    const hn::RebindToSigned<D> di;
    const bool placed = self().places() != nullptr;
    for (size_t k = 0; k < 4; ++k) {
      hn::Store(placed ? texel[k].x : IndexOf(d, level, texel[k]), di, self().elements().index[k] + at);
      if (HWY_LIKELY(!placed)) continue;
      hn::Store(texel[k].y, di, self().places()->y[k] + at);
      write_image(d, k, at, texel[k].first, level);
    }
    return placed ? kApart : 0;
  }

  /// Returns the index of a texel in memory.
  template <class D>
  static HWY_INLINE Ints<D> IndexOf(D, const Level<D>& level, const TexelPlace<D>& texel) {
    return (texel.y * level.across.whole + texel.first) + texel.x;
  }

  /// Writes the shares within a row, and the share of the row. Returns flags of the element.
  template <class D, class AnyShare>
  HWY_INLINE uint32_t write_row_shares(D d, size_t at, const RowShares<D>& row, const AnyShare& share) {
    auto& to = self().elements();
    float* const shares[3] = {to.s, to.t, to.r};
    float* const rates[3] = {to.rate_s, to.rate_t, to.rate_r};
    for (size_t k = 0; k < 3; ++k) {
      hn::Store(row.share[k], d, shares[k] + at);
      if (HWY_UNLIKELY(self().has_rates())) hn::Store(row.rate[k], d, rates[k] + at);
    }
    return write_share(d, at, share);
  }

  /// Writes the share of an element. Returns its flags.
  template <class D>
  HWY_INLINE uint32_t write_share(D, size_t) {
    return 0;
  }
  template <class D>
  HWY_INLINE uint32_t write_share(D d, size_t at, hn::Vec<D> share) {
    hn::Store(share, d, self().elements().share + at);
    return 0;
  }
  template <class D>
  HWY_INLINE uint32_t write_share(D d, size_t at, const Share<D>& share) {
    auto& to = self().elements();
    hn::Store(share.value, d, to.share + at);
    if (HWY_LIKELY(!self().has_rates())) return 0;
    hn::Store(share.rate_u, d, to.share_rate_u + at);
    hn::Store(share.rate_v, d, to.share_rate_v + at);
    return share.rates;
  }
  template <class D>
  HWY_INLINE uint32_t write_share(D d, size_t at, const DeepShare<D>& share) {
    hn::Store(share.value, d, self().elements().share + at);
    if (HWY_LIKELY(!self().has_rates())) return 0;
    hn::Store(share.rate, d, self().elements().share_rate_u + at);
    return kDeep;
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_EMITTER_INL_H_
