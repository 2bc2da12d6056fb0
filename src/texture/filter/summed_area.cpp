// SPDX-License-Identifier: MIT
// The lanes of a vector are the channels of one lookup, so that the entries of a texel are one load. The cells at its
// ends divide a box into three columns of three patches. The sum of a patch is a difference of table entries, which is
// exact for integer entries. It is weighted by the part of its cells that the box covers.
#include "texture/table/summed_area.h"

#include <limits>

#include "texture/filter/prefetch.h"
#include "texture/format/formats.h"
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/summed_area.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/double-inl.h"
#include "texture/domain/shapes-inl.h"
#include "texture/filter/box-inl.h"
#include "texture/filter/filters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Integer table entries. Differences are computed on integers and must not be negative; real() converts them.
template <class Real>
struct WholeEntries {
  using Entry = uint32_t;
  using Tag = hn::Rebind<uint32_t, Real>;

  static HWY_INLINE hn::Vec<Real> real(hn::Vec<Tag> v) {
    const Real d;
    const hn::Rebind<uint64_t, Real> bits;
    const auto magic = hn::Set(d, 0x1p52);  // the lowest bit of its mantissa has the value 1
    return hn::BitCast(d, hn::PromoteTo(bits, v) | hn::BitCast(bits, magic)) - magic;
  }
};
/// Table entries that are doubles.
template <class Real>
struct RealEntries {
  using Entry = double;
  using Tag = Real;

  static HWY_INLINE hn::Vec<Real> real(hn::Vec<Real> v) { return v; }
};

/// The box of one lane along one axis.
struct BoxSpan {
  int32_t inner[2], outer[2];
  double weight[2], sign[2], turns;

  BoxSpan(const BoxSpans& spans, size_t lane) {
    for (size_t end = 0; end < 2; ++end) {
      inner[end] = spans.inner[end][lane];
      outer[end] = spans.outer[end][lane];
      weight[end] = static_cast<double>(spans.weight[end][lane]);
      sign[end] = static_cast<double>(spans.sign[end][lane]);
    }
    turns = static_cast<double>(spans.turns[lane]);
  }
};

/// Sums of channels over boxes of one layer's table.
template <template <class> class Entries, size_t kChannels>
struct BoxSums {
  using Real = hn::CappedTag<double, kChannels>;
  using Stored = Entries<Real>;
  using Tag = typename Stored::Tag;
  using V = hn::Vec<Real>;
  using Raw = hn::Vec<Tag>;
  using Entry = typename Stored::Entry;

  const Entry* table;  // entry (0, 0) of the first channel of the vector
  size_t pitch;
  uint32_t width, height;

  /// Differences along one row: over the cell at the first end, the cells between, and the cell at the last end.
  template <class T>
  struct Row {
    T first, middle, last;
  };

  HWY_INLINE const Entry* row(int32_t y) const { return table + static_cast<size_t>(y) * pitch; }
  static HWY_INLINE Raw at(const Entry* row, int32_t x) {
    return hn::LoadU(Tag(), row + static_cast<size_t>(x) * kChannels);
  }
  static HWY_INLINE V real(Raw raw) { return Stored::real(raw); }
  static HWY_INLINE V weighted(V first, V middle, V last, const BoxSpan& span) {
    const Real d;
    const V ends = first * hn::Set(d, span.weight[0]) + last * hn::Set(d, span.weight[1]);
    return middle + ends;
  }

  static HWY_INLINE Row<Raw> rising_row(const Entry* row, const BoxSpan& u) {
    const Raw outer0 = at(row, u.outer[0]), inner0 = at(row, u.inner[0]);
    const Raw inner1 = at(row, u.inner[1]), outer1 = at(row, u.outer[1]);
    return {inner0 - outer0, inner1 - inner0, outer1 - inner1};
  }
  static HWY_INLINE V rising_column(Raw outer0, Raw inner0, Raw inner1, Raw outer1, const BoxSpan& v) {
    return weighted(real(inner0 - outer0), real(inner1 - inner0), real(outer1 - inner1), v);
  }
  /// Returns the sum over a box inside the texture, whose table entries rise from end to end.
  HWY_INLINE V rising(const BoxSpan& u, const BoxSpan& v) const {
    const Row<Raw> outer0 = rising_row(row(v.outer[0]), u), inner0 = rising_row(row(v.inner[0]), u);
    const Row<Raw> inner1 = rising_row(row(v.inner[1]), u), outer1 = rising_row(row(v.outer[1]), u);
    const V first = rising_column(outer0.first, inner0.first, inner1.first, outer1.first, v);
    const V middle = rising_column(outer0.middle, inner0.middle, inner1.middle, outer1.middle, v);
    const V last = rising_column(outer0.last, inner0.last, inner1.last, outer1.last, v);
    return weighted(first, middle, last, u);
  }

  /// Returns the differences between the four entries of a wrapped box. `whole` is the entry of the whole texture.
  static HWY_INLINE Row<V> differences(V outer0, V inner0, V inner1, V outer1, V whole, const BoxSpan& s) {
    const Real d;
    const V sign0 = hn::Set(d, s.sign[0]), sign1 = hn::Set(d, s.sign[1]);
    const V turned = hn::Set(d, s.turns) * whole + sign1 * inner1;
    return {sign0 * (inner0 - outer0), turned - sign0 * inner0, sign1 * (outer1 - inner1)};
  }
  HWY_INLINE Row<V> wrapped_row(const Entry* row, const BoxSpan& u) const {
    const V outer0 = real(at(row, u.outer[0])), inner0 = real(at(row, u.inner[0]));
    const V inner1 = real(at(row, u.inner[1])), outer1 = real(at(row, u.outer[1]));
    return differences(outer0, inner0, inner1, outer1, real(at(row, static_cast<int32_t>(width))), u);
  }
  static HWY_INLINE V wrapped_column(V outer0, V inner0, V inner1, V outer1, V whole, const BoxSpan& v) {
    const Row<V> rows = differences(outer0, inner0, inner1, outer1, whole, v);
    return weighted(rows.first, rows.middle, rows.last, v);
  }
  /// Returns the sum over any box.
  HWY_NOINLINE V wrapped(const BoxSpan& u, const BoxSpan& v) const {
    const Row<V> outer0 = wrapped_row(row(v.outer[0]), u), inner0 = wrapped_row(row(v.inner[0]), u);
    const Row<V> inner1 = wrapped_row(row(v.inner[1]), u), outer1 = wrapped_row(row(v.outer[1]), u);
    const Row<V> whole = wrapped_row(row(static_cast<int32_t>(height)), u);
    const V first = wrapped_column(outer0.first, inner0.first, inner1.first, outer1.first, whole.first, v);
    const V middle = wrapped_column(outer0.middle, inner0.middle, inner1.middle, outer1.middle, whole.middle, v);
    const V last = wrapped_column(outer0.last, inner0.last, inner1.last, outer1.last, whole.last, v);
    return weighted(first, middle, last, u);
  }
};

/// Sums of each lane over its boxes.
template <size_t kChannels>
struct BoxTotals {
  double sum[kMaxLanes][kChannels] = {};
  double inside[kMaxLanes] = {}, area[kMaxLanes] = {};
  bool nonfinite[kMaxLanes][kChannels] = {};
};

/// Constants of each channel: the stored number of 1, and the border colour.
template <size_t kChannels>
struct BoxScale {
  double one[kChannels], border[kChannels];

  BoxScale(const Texture& texture, const Sampler& sampler) {
    for (size_t c = 0; c < kChannels; ++c) {
      one[c] = one_of(texture.component, c);
      border[c] = static_cast<double>(sampler.border[c]);
    }
  }
};

template <template <class> class Entries, size_t kChannels>
struct SummedArea {
  using Sums = BoxSums<Entries, kChannels>;
  using Counts = BoxSums<WholeEntries, kChannels>;
  using Real = typename Sums::Real;
  using Totals = BoxTotals<kChannels>;

  const Texture& texture;
  const Sampler& sampler;
  BoxScale<kChannels> scale;
  bool scattered;  // prefetch the table entries of a vector of boxes before they are summed

  template <class S>
  HWY_INLINE S sums_of(const typename S::Entry* tables, size_t layer, size_t channel) const {
    return {tables + layer * sum_count(texture) + channel, (size_t{texture.width} + 1) * kChannels, texture.width,
            texture.height};
  }

  HWY_INLINE void add(const BoxSpans& us, const BoxSpans& vs, size_t lane, size_t layer, bool rising,
                      Totals* totals) const {
    const Real d;
    const BoxSpan u(us, lane), v(vs, lane);
    const auto* tables = reinterpret_cast<const typename Sums::Entry*>(texture.sums.data());
    for (size_t c = 0; c < kChannels; c += hn::Lanes(d)) {
      const Sums sums = sums_of<Sums>(tables, layer, c);
      const auto sum = HWY_LIKELY(rising) ? sums.rising(u, v) : sums.wrapped(u, v);
      double* total = totals->sum[lane] + c;
      hn::StoreU(hn::LoadU(d, total) + sum, d, total);
    }
    const double width = us.inside(lane), height = vs.inside(lane);
    totals->inside[lane] += width * height;
    totals->area[lane] +=
        (width + static_cast<double>(us.outside[lane])) * (height + static_cast<double>(vs.outside[lane]));
    if (HWY_UNLIKELY(texture.nonfinite_sums.size() > 0)) count(u, v, lane, layer, totals);
  }

  HWY_NOINLINE void prefetch(const BoxSpans& us, const BoxSpans& vs, size_t lane, size_t layer) const {
    const auto* tables = reinterpret_cast<const typename Sums::Entry*>(texture.sums.data());
    const Sums sums = sums_of<Sums>(tables, layer, 0);
    for (size_t end = 0; end < 2; ++end) {
      for (const int32_t y : {vs.inner[end][lane], vs.outer[end][lane]}) {
        const auto* row = sums.row(y);
        __builtin_prefetch(row + static_cast<size_t>(us.inner[0][lane]) * kChannels);
        __builtin_prefetch(row + static_cast<size_t>(us.inner[1][lane]) * kChannels);
      }
    }
  }

  HWY_NOINLINE void count(const BoxSpan& u, const BoxSpan& v, size_t lane, size_t layer, Totals* totals) const {
    const Real d;
    double counts[kChannels];
    for (size_t c = 0; c < kChannels; c += hn::Lanes(d)) {
      hn::StoreU(sums_of<Counts>(texture.nonfinite_sums.data(), layer, c).wrapped(u, v), d, counts + c);
    }
    for (size_t c = 0; c < kChannels; ++c) totals->nonfinite[lane][c] |= counts[c] != 0.0;
  }

  HWY_INLINE void finish(const Totals& totals, size_t lane, size_t layer, const Texels& out, size_t i) const {
    const Real d;
    const hn::Rebind<float, Real> df;
    const double inside = totals.inside[lane], area = totals.area[lane];
    const auto max_float = hn::Set(d, 0x1.fffffep127);
    float value[kChannels];
    for (size_t c = 0; c < kChannels; c += hn::Lanes(d)) {
      const auto whole = hn::Set(d, inside) * hn::LoadU(d, scale.one + c);
      auto mean = hn::LoadU(d, totals.sum[lane] + c) / whole;
      mean = mean + hn::LoadU(d, texture.sum_origins.data() + layer * kChannels + c);
      if (HWY_UNLIKELY(area > inside)) {
        const auto border = hn::LoadU(d, scale.border + c);
        if (!(inside > 0)) mean = border;
        mean = mean + (border - mean) * hn::Set(d, (area - inside) / area);
      }
      mean = hn::Min(hn::Max(mean, hn::Neg(max_float)), max_float);
      hn::StoreU(hn::DemoteTo(df, mean), df, value + c);
    }
    for (size_t c = 0; c < kChannels; ++c) {
      if (out.channel[c])
        out.channel[c][i] = totals.nonfinite[lane][c] ? std::numeric_limits<float>::quiet_NaN() : value[c];
    }
  }

  /// Converts a reduced coordinate to texels.
  template <class D>
  static HWY_INLINE hn::Vec<D> TexelCoordinate(D d, shd_wrap wrap, const float* reduced, hn::Vec<D> size) {
    const auto x = hn::Load(d, reduced) * size;
    return wrap == SHD_WRAP_MIRROR ? x + x : x;
  }

  /// Filters the vector of lookups at i and writes the results to elements i.. of the columns. Nothing is written past
  /// the count of the block.
  template <class D>
  HWY_INLINE void run(D d, const BoxBlock& block, size_t i, const Texels& out) const {
    using V = hn::Vec<D>;
    const V width = hn::Set(d, static_cast<float>(texture.width));
    const V height = hn::Set(d, static_cast<float>(texture.height));
    const V x = TexelCoordinate(d, sampler.wrap_u, block.u + i, width);
    const V y = TexelCoordinate(d, sampler.wrap_v, block.v + i, height);
    const V side_u = hn::Load(d, block.side_u + i), side_v = hn::Load(d, block.side_v + i);
    const V half_u = hn::Load(d, block.half_u + i), half_v = hn::Load(d, block.half_v + i);
    const V parts = hn::Load(d, block.parts + i);
    const size_t lanes = block.count - i < hn::Lanes(d) ? block.count - i : hn::Lanes(d);
    const auto layer_of = [&](size_t lane) -> size_t {
      return texture.layers == 1 ? 0 : static_cast<uint32_t>(block.first_texel[i + lane]) / texture.layout.layer_units;
    };

    Totals totals;
    BoxSpans us, vs;
    const float max_parts = hn::GetLane(hn::MaxOfLanes(d, parts));
    for (float part = 0; part < max_parts; part += 1) {
      const V t = (hn::Set(d, 2 * part + 1) - parts) / (parts + parts);
      const V u = x + t * side_u, v = y + t * side_v;
      const auto rising_u = WrapBox(d, sampler.wrap_u, u, half_u, width, &us);
      const auto rising_v = WrapBox(d, sampler.wrap_v, v, half_v, height, &vs);
      uint8_t rising[8] = {};
      hn::StoreMaskBits(d, hn::And(rising_u, rising_v), rising);
      for (size_t lane = 0; scattered && lane < lanes; ++lane) prefetch(us, vs, lane, layer_of(lane));
      for (size_t lane = 0; lane < lanes; ++lane) {
        if (part >= block.parts[i + lane]) continue;
        add(us, vs, lane, layer_of(lane), rising[lane / 8] >> lane % 8 & 1, &totals);
      }
    }
    for (size_t lane = 0; lane < lanes; ++lane) finish(totals, lane, layer_of(lane), out, i + lane);
  }
};

size_t FindBoxes(const Texture& texture, const Sampler& sampler, const Lookups& in, BoxBlock* out) {
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const float max_parts =
      sampler.box == SHD_BOX_ORIENTED ? static_cast<float>(static_cast<int>(sampler.max_anisotropy)) : 1.0f;
  const BoxRange range = box_range(sampler);
  const bool lod_given = in.lod != nullptr;
  return FillBlock(texture, sampler, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
    const auto boxes =
        lod_given ? SquareBoxes(d, p.lod, range) : BoxesOf(d, p.derivatives, width, height, max_parts, range);
    hn::Store(boxes.count, d, out->parts + to);
    hn::Store(boxes.side_u, d, out->side_u + to);
    hn::Store(boxes.side_v, d, out->side_v + to);
    hn::Store(boxes.half_u, d, out->half_u + to);
    hn::Store(boxes.half_v, d, out->half_v + to);
  });
}

template <template <class> class Entries, size_t kChannels>
size_t SummedAreaOf(const FilterCall& call) {
  const BatchTag d;
  SummedArea<Entries, kChannels> filter = {call.texture, call.sampler, BoxScale<kChannels>(call.texture, call.sampler),
                                           false};
  BoxBlock block;
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    const Lookups in = block_of(call.in, first);
    nonfinite += FindBoxes(call.texture, call.sampler, in, &block);
    filter.scattered = is_scattered(call.texture, block, nullptr);
    const Texels out = part_of(call.out, first);
    for (size_t i = 0; i < in.count; i += hn::Lanes(d)) filter.run(d, block, i, out);
  }
  return nonfinite;
}

template <template <class> class Entries>
size_t SummedAreaOf(const FilterCall& call) {
  switch (call.texture.channels) {
    case 1: return SummedAreaOf<Entries, 1>(call);
    case 2: return SummedAreaOf<Entries, 2>(call);
    default: return SummedAreaOf<Entries, 4>(call);
  }
}

}  // namespace

/// Runs SHD_FILTER_SUMMED_AREA. It reads a table in place of texels, so it writes values itself without a stream.
size_t RunSummedArea(const FilterCall& call) {
  return has_integer_sums(call.texture) ? SummedAreaOf<WholeEntries>(call) : SummedAreaOf<RealEntries>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
