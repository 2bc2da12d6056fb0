// SPDX-License-Identifier: MIT
// Summation runs along the rows and then down the columns. Doubles are summed with compensation (Neumaier,
// "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen", 1974), which leaves one rounding per entry
// and pass.
#include "texture/table/summed_area.h"

#include <atomic>
#include <cmath>
#include <cstring>

#include "core/executor.h"
#include "texture/format/texel_codec.h"
#include "texture/store/storage.h"

namespace shd::texture {
namespace {

constexpr size_t kBlock = 256;  // columns of entries that one task sums

/// An exact running sum.
struct IntegerSum {
  uint32_t sum = 0;
  void add(uint32_t value) { sum += value; }
  uint32_t value() const { return sum; }
};

/// A compensated running sum.
struct RealSum {
  double sum = 0, lost = 0;
  void add(double value) {
    const double next = sum + value;
    lost += std::fabs(sum) >= std::fabs(value) ? (sum - next) + value : (value - next) + sum;
    sum = next;
  }
  double value() const { return sum + lost; }
};

template <class Entry>
struct SumOf;
template <>
struct SumOf<uint32_t> {
  using Type = IntegerSum;
};
template <>
struct SumOf<double> {
  using Type = RealSum;
};

double finite_or(double value, double other) {
  return std::isfinite(value) ? value : other;
}

/// Entries of values that are relative to `origin` and 0 where they are not finite.
struct Values {
  const double* origin;

  template <class Entry>
  Entry operator()(size_t c, double value) const {
    return static_cast<Entry>(finite_or(value, origin[c]) - origin[c]);
  }
};

/// Counts of values that are not finite.
struct NonfiniteCounts {
  template <class Entry>
  Entry operator()(size_t, double value) const {
    return !std::isfinite(value);
  }
};

/// Builder of the table of one layer.
template <class Entry>
class Table {
 public:
  using Sum = typename SumOf<Entry>::Type;

  Table(const Texture& texture, uint32_t layer, Entry* first)
      : texture_(texture),
        codec_(codec_of(texture.component, texture.channels)),
        layer_(layer),
        pitch_((size_t{texture.width} + 1) * texture.channels),
        first_(first + layer * sum_count(texture)) {}

  /// Builds the table of the entries that `entry` makes of stored numbers.
  template <class EntryOf>
  void build(const core::Context& context, const EntryOf& entry) const {
    std::memset(first_, 0, pitch_ * sizeof(Entry));
    core::parallel_for(context, texture_.height, [&](uint32_t y, uint32_t) {
      with_channels(codec_.channels, [&](auto channels) { sum_row<channels>(y, entry); });
    });
    const auto blocks = static_cast<uint32_t>((pitch_ + kBlock - 1) / kBlock);
    core::parallel_for(context, blocks, [&](uint32_t block, uint32_t) { sum_columns(block * kBlock); });
  }

 private:
  template <size_t kChannels, class EntryOf>
  void sum_row(uint32_t y, const EntryOf& entry) const {
    const uint8_t* row = row_of(texture_, layer_, 0, y);
    Entry* to = first_ + (size_t{y} + 1) * pitch_;
    Sum sum[kChannels];
    for (size_t c = 0; c < kChannels; ++c) *to++ = 0;
    for_runs(codec_, row, texture_.width, [&](const double* value, size_t count) {
      for (size_t i = 0; i < count; ++i, value += kChannels) {
        for (size_t c = 0; c < kChannels; ++c) {
          sum[c].add(entry.template operator()<Entry>(c, value[c]));
          *to++ = sum[c].value();
        }
      }
    });
  }

  void sum_columns(size_t begin) const {
    const size_t count = pitch_ - begin < kBlock ? pitch_ - begin : kBlock;
    Sum sum[kBlock];
    for (uint32_t y = 1; y <= texture_.height; ++y) {
      Entry* row = first_ + y * pitch_ + begin;
      for (size_t i = 0; i < count; ++i) {
        sum[i].add(row[i]);
        row[i] = sum[i].value();
      }
    }
  }

  const Texture& texture_;
  const TexelCodec& codec_;
  const uint32_t layer_;
  const size_t pitch_;
  Entry* const first_;
};

void build_layer(const core::Context& context, Texture& texture, uint32_t layer) {
  const TexelCodec& codec = codec_of(texture.component, texture.channels);
  double origin[4];  // subtracted from every texel; 0 for integer sums
  codec.load(row_of(texture, layer, 0, 0), 1, origin);
  for (size_t c = 0; c < codec.channels; ++c) {
    origin[c] = has_integer_sums(texture) ? 0 : finite_or(origin[c], 0);
    texture.sum_origins[layer * codec.channels + c] = origin[c] / codec.one[c];
  }
  if (has_integer_sums(texture)) {
    Table<uint32_t>(texture, layer, reinterpret_cast<uint32_t*>(texture.sums.data())).build(context, Values{origin});
  } else {
    Table<double>(texture, layer, reinterpret_cast<double*>(texture.sums.data())).build(context, Values{origin});
  }
}

bool has_nonfinite(const core::Context& context, const Texture& texture, uint32_t layer) {
  const TexelCodec& codec = codec_of(texture.component, texture.channels);
  if (!codec.is_float) return false;
  std::atomic<bool> found{false};
  core::parallel_for(context, texture.height, [&](uint32_t y, uint32_t) {
    bool in_row = false;
    for_runs(codec, row_of(texture, layer, 0, y), texture.width, [&](const double* value, size_t count) {
      for (size_t i = 0; i < count * codec.channels; ++i) in_row = in_row || !std::isfinite(value[i]);
    });
    if (in_row) found.store(true, std::memory_order_relaxed);
  });
  return found.load(std::memory_order_relaxed);
}

void build_nonfinite(const core::Context& context, Texture& texture, uint32_t layer) {
  Table<uint32_t>(texture, layer, texture.nonfinite_sums.data()).build(context, NonfiniteCounts());
}

}  // namespace

void build_summed_area(const core::Context& context, Texture* texture) {
  const size_t entries = core::checked_mul(sum_count(*texture), texture->layers);
  const size_t size = has_integer_sums(*texture) ? sizeof(uint32_t) : sizeof(double);
  texture->sums = core::Array<uint8_t>(context.allocator, core::checked_mul(entries, size));
  texture->sum_origins = core::Array<double>(context.allocator, size_t{texture->layers} * texture->channels);
  bool nonfinite = false;
  for (uint32_t layer = 0; layer < texture->layers; ++layer) {
    build_layer(context, *texture, layer);
    nonfinite = nonfinite || has_nonfinite(context, *texture, layer);
  }
  if (!nonfinite) return;
  texture->nonfinite_sums = core::Array<uint32_t>(context.allocator, sum_count(*texture) * texture->layers);
  for (uint32_t layer = 0; layer < texture->layers; ++layer) build_nonfinite(context, *texture, layer);
}

size_t spare_sums_size(const Texture& texture) {
  const bool is_float = codec_of(texture.component, texture.channels).is_float;
  return is_float && texture.nonfinite_sums.size() == 0 ? sum_count(texture) * texture.layers : 0;
}

void update_summed_area(const core::Context& context, uint32_t layer, core::Array<uint32_t>* spare, Texture* texture) {
  build_layer(context, *texture, layer);
  if (texture->nonfinite_sums.size() == 0) {
    if (!has_nonfinite(context, *texture, layer)) return;
    texture->nonfinite_sums = static_cast<core::Array<uint32_t>&&>(*spare);
    std::memset(texture->nonfinite_sums.data(), 0, texture->nonfinite_sums.size() * sizeof(uint32_t));
  }
  build_nonfinite(context, *texture, layer);
}

}  // namespace shd::texture
