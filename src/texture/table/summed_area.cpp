// SPDX-License-Identifier: MIT
// Summation runs along the rows and then down the columns. Doubles are summed with compensation (Neumaier,
// "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen", 1974), which leaves one rounding per entry
// and pass.
#include "texture/table/summed_area.h"

#include <atomic>
#include <cmath>
#include <cstring>

#include "core/executor.h"
#include "texture/format/formats.h"
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

/// Builder of the table of one layer.
template <class Entry, size_t kChannels>
class Table {
 public:
  using Sum = typename SumOf<Entry>::Type;

  Table(const Texture& texture, Entry* first)
      : width_(texture.width), height_(texture.height), pitch_((size_t{width_} + 1) * kChannels), first_(first) {}

  /// Builds the table of the values that load(x, y, values) returns.
  template <class Load>
  void build(const core::Context& context, const Load& load) const {
    std::memset(first_, 0, pitch_ * sizeof(Entry));
    core::parallel_for(context, height_, [&](uint32_t y, uint32_t) { sum_row(y, load); });
    const auto blocks = static_cast<uint32_t>((pitch_ + kBlock - 1) / kBlock);
    core::parallel_for(context, blocks, [&](uint32_t block, uint32_t) { sum_columns(block * kBlock); });
  }

 private:
  template <class Load>
  void sum_row(uint32_t y, const Load& load) const {
    Entry* to = first_ + (size_t{y} + 1) * pitch_;
    Sum sum[kChannels];
    for (size_t c = 0; c < kChannels; ++c) *to++ = 0;
    for (uint32_t x = 0; x < width_; ++x) {
      Entry value[kChannels];
      load(x, y, value);
      for (size_t c = 0; c < kChannels; ++c) {
        sum[c].add(value[c]);
        *to++ = sum[c].value();
      }
    }
  }

  void sum_columns(size_t begin) const {
    const size_t count = pitch_ - begin < kBlock ? pitch_ - begin : kBlock;
    Sum sum[kBlock];
    for (uint32_t y = 1; y <= height_; ++y) {
      Entry* row = first_ + y * pitch_ + begin;
      for (size_t i = 0; i < count; ++i) {
        sum[i].add(row[i]);
        row[i] = sum[i].value();
      }
    }
  }

  const uint32_t width_, height_;
  const size_t pitch_;
  Entry* const first_;
};

double finite_or(double value, double other) {
  return std::isfinite(value) ? value : other;
}

/// Loads the value that is subtracted from every texel of a layer. It is 0 for integer sums.
template <class Codec>
void load_origin(const Texture& texture, uint32_t layer, double* origin) {
  Codec::load(row_of(texture, layer, 0, 0), origin);
  for (size_t c = 0; c < Codec::kChannels; ++c) {
    origin[c] = has_integer_sums(texture) ? 0 : finite_or(origin[c], 0);
  }
}

template <class Codec, class Entry>
void build_sums(const core::Context& context, Texture& texture, uint32_t layer) {
  constexpr size_t kChannels = Codec::kChannels;
  double origin[kChannels];
  load_origin<Codec>(texture, layer, origin);
  for (size_t c = 0; c < kChannels; ++c) {
    texture.sum_origins[layer * kChannels + c] = origin[c] / Codec::one(c);
  }
  auto* first = reinterpret_cast<Entry*>(texture.sums.data()) + layer * sum_count(texture);
  Table<Entry, kChannels>(texture, first).build(context, [&](uint32_t x, uint32_t y, Entry* value) {
    double linear[kChannels];
    Codec::load(row_of(texture, layer, 0, y) + size_t{x} * Codec::kSize, linear);
    for (size_t c = 0; c < kChannels; ++c) value[c] = static_cast<Entry>(finite_or(linear[c], origin[c]) - origin[c]);
  });
}

template <class Codec>
bool has_nonfinite(const core::Context& context, const Texture& texture, uint32_t layer) {
  if (!Codec::kFloat) return false;
  std::atomic<bool> found{false};
  core::parallel_for(context, texture.height, [&](uint32_t y, uint32_t) {
    bool in_row = false;
    const uint8_t* row = row_of(texture, layer, 0, y);
    for (uint32_t x = 0; x < texture.width; ++x) {
      double value[Codec::kChannels];
      Codec::load(row + size_t{x} * Codec::kSize, value);
      for (const double channel : value) in_row = in_row || !std::isfinite(channel);
    }
    if (in_row) found.store(true, std::memory_order_relaxed);
  });
  return found.load(std::memory_order_relaxed);
}

template <class Codec>
void build_nonfinite(const core::Context& context, Texture& texture, uint32_t layer) {
  constexpr size_t kChannels = Codec::kChannels;
  uint32_t* first = texture.nonfinite_sums.data() + layer * sum_count(texture);
  Table<uint32_t, kChannels>(texture, first).build(context, [&](uint32_t x, uint32_t y, uint32_t* value) {
    double linear[kChannels];
    Codec::load(row_of(texture, layer, 0, y) + size_t{x} * Codec::kSize, linear);
    for (size_t c = 0; c < kChannels; ++c) value[c] = !std::isfinite(linear[c]);
  });
}

template <class Codec>
void build_layer(const core::Context& context, Texture& texture, uint32_t layer) {
  if (has_integer_sums(texture)) {
    build_sums<Codec, uint32_t>(context, texture, layer);
  } else {
    build_sums<Codec, double>(context, texture, layer);
  }
}

template <class Codec>
void build_layers(const core::Context& context, Texture& texture) {
  bool nonfinite = false;
  for (uint32_t layer = 0; layer < texture.layers; ++layer) {
    build_layer<Codec>(context, texture, layer);
    nonfinite = nonfinite || has_nonfinite<Codec>(context, texture, layer);
  }
  if (!nonfinite) return;
  texture.nonfinite_sums = core::Array<uint32_t>(context.allocator, sum_count(texture) * texture.layers);
  for (uint32_t layer = 0; layer < texture.layers; ++layer) build_nonfinite<Codec>(context, texture, layer);
}

template <class Codec>
void update_layer(const core::Context& context, uint32_t layer, core::Array<uint32_t>* spare, Texture& texture) {
  build_layer<Codec>(context, texture, layer);
  if (texture.nonfinite_sums.size() == 0) {
    if (!has_nonfinite<Codec>(context, texture, layer)) return;
    texture.nonfinite_sums = static_cast<core::Array<uint32_t>&&>(*spare);
    std::memset(texture.nonfinite_sums.data(), 0, texture.nonfinite_sums.size() * sizeof(uint32_t));
  }
  build_nonfinite<Codec>(context, texture, layer);
}

}  // namespace

void build_summed_area(const core::Context& context, Texture* texture) {
  const size_t entries = core::checked_mul(sum_count(*texture), texture->layers);
  const size_t size = has_integer_sums(*texture) ? sizeof(uint32_t) : sizeof(double);
  texture->sums = core::Array<uint8_t>(context.allocator, core::checked_mul(entries, size));
  texture->sum_origins = core::Array<double>(context.allocator, size_t{texture->layers} * texture->channels);
  visit_codec(texture->component, texture->channels,
              [&](auto codec) { build_layers<decltype(codec)>(context, *texture); });
}

size_t spare_sums_size(const Texture& texture) {
  return is_float(texture.component) && texture.nonfinite_sums.size() == 0 ? sum_count(texture) * texture.layers : 0;
}

void update_summed_area(const core::Context& context, uint32_t layer, core::Array<uint32_t>* spare, Texture* texture) {
  visit_codec(texture->component, texture->channels,
              [&](auto codec) { update_layer<decltype(codec)>(context, layer, spare, *texture); });
}

}  // namespace shd::texture
