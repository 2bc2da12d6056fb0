// SPDX-License-Identifier: MIT
// Ripmap levels as exact box averages of the base. Each axis is halved on its own (Williams, "Pyramidal Parametrics",
// 1983; Akenine-Moeller, Haines and Hoffman, "Real-Time Rendering", 2008, 6.2.2).
//
// For each row of the levels (., j), the base rows under it are summed into one row that is as wide as the base. From
// this row the rows of all levels (i, j) are computed: by sums of pairs while the width halves evenly, and by weighted
// sums of the whole row afterwards. Sums are doubles of texels times integer weights. They are exact for 8-bit and
// 16-bit texels and within 2^-50 of the sum of magnitudes for other formats. A constant base gives constant levels: c n
// is exact for n <= 2^26 and a c of 24 bits.
#include <cstring>

#include "texture/format/formats.h"
#include "texture/store/rows.h"
#include "texture/store/span.h"
#include "texture/table/tables.h"

namespace shd::texture {
namespace {

/// Adds weight * texel to `sum` for every channel of a stored row.
template <class Codec>
void add_row(const uint8_t* texels, uint32_t width, double weight, double* sum) {
  for (uint32_t x = 0; x < width; ++x, texels += Codec::kSize, sum += Codec::kChannels) {
    double value[Codec::kChannels];
    Codec::load(texels, value);
    for (size_t c = 0; c < Codec::kChannels; ++c) sum[c] += weight * value[c];
  }
}

/// Adds pairs of texels in place.
template <size_t kChannels>
void add_pairs(double* row, uint32_t width) {
  double* to = row;
  for (uint32_t x = 0; x < width / 2; ++x, row += 2 * kChannels, to += kChannels) {
    for (size_t c = 0; c < kChannels; ++c) to[c] = row[c] + row[c + kChannels];
  }
}

/// Computes the weighted sum of the texels under texel `index` of a level row of `width` texels, from a row of `base`
/// texels.
template <size_t kChannels>
void add_span(const double* row, uint32_t index, uint32_t base, uint32_t width, double* sum) {
  const AxisSpan span(index, base, width);
  for (size_t c = 0; c < kChannels; ++c) sum[c] = 0;
  for (uint32_t x = span.first; x <= span.last; ++x) {
    const double weight = span.weight(x);
    for (size_t c = 0; c < kChannels; ++c) sum[c] += weight * row[size_t{x} * kChannels + c];
  }
}

/// Builds row y of the levels (0.., j) of one layer.
template <class Codec>
class Row {
 public:
  static constexpr size_t kChannels = Codec::kChannels;

  /// Builds the texels over the base columns `columns`. `scratch` holds two rows of the base.
  Row(Texture& texture, uint32_t layer, AxisRange columns, uint32_t j, uint32_t y, double* scratch)
      : texture_(texture),
        columns_(columns),
        layer_(layer),
        j_(j),
        y_(y),
        whole_(scratch),
        halved_(scratch + size_t{texture.width} * kChannels) {}

  void run() {
    const uint32_t width = texture_.width, height = level_size(texture_.height, j_);
    const AxisSpan down(y_, texture_.height, height);
    std::memset(whole_, 0, width * kChannels * sizeof(double));
    for (uint32_t y = down.first; y <= down.last; ++y) {
      add_row<Codec>(row_of(texture_, layer_, 0, y), width, down.weight(y), whole_);
    }
    if (!is_there(0)) store(0, whole_);
    std::memcpy(halved_, whole_, width * kChannels * sizeof(double));
    bool even = true;
    for (uint32_t i = 1; i < texture_.ripmap_columns; ++i) {
      even = even && level_size(width, i - 1) % 2 == 0;
      if (even) {
        add_pairs<kChannels>(halved_, level_size(width, i - 1));
        if (!is_there(i)) store(i, halved_);
      } else if (!is_there(i)) {
        store_spans(i);
      }
    }
  }

 private:
  bool is_there(uint32_t i) const { return is_mip_level(texture_, i, j_); }

  /// Stores averages from sums of 2^i columns.
  void store(uint32_t i, const double* sum) {
    const AxisRange range = level_range(columns_, texture_.width, level_size(texture_.width, i));
    uint8_t* texel = ripmap_row(texture_, layer_, i, j_, y_) + size_t{range.first} * Codec::kSize;
    const double area = static_cast<double>(texture_.height) * (1u << i);
    sum += size_t{range.first} * kChannels;
    for (uint32_t x = range.first; x < range.end; ++x, texel += Codec::kSize, sum += kChannels) {
      store_texel(sum, area, texel);
    }
  }

  void store_spans(uint32_t i) {
    const uint32_t width = level_size(texture_.width, i);
    const AxisRange range = level_range(columns_, texture_.width, width);
    uint8_t* texel = ripmap_row(texture_, layer_, i, j_, y_) + size_t{range.first} * Codec::kSize;
    const double area = static_cast<double>(texture_.width) * texture_.height;
    for (uint32_t x = range.first; x < range.end; ++x, texel += Codec::kSize) {
      double sum[kChannels];
      add_span<kChannels>(whole_, x, texture_.width, width, sum);
      store_texel(sum, area, texel);
    }
  }

  static void store_texel(const double* sum, double area, uint8_t* texel) {
    double average[kChannels];
    for (size_t c = 0; c < kChannels; ++c) average[c] = sum[c] / area;
    Codec::store(average, texel);
  }

  Texture& texture_;
  const AxisRange columns_;
  const uint32_t layer_, j_, y_;
  double *whole_, *halved_;
};

template <class Codec>
void build_ripmap_layer(const core::Context& context, Texture& texture, uint32_t layer, const Region& region,
                        double* scratch) {
  const size_t rows = size_t{2} * texture.width * Codec::kChannels;
  for (uint32_t j = 0; j < texture.ripmap_rows; ++j) {
    const AxisRange range = level_range(region.y, texture.height, level_size(texture.height, j));
    for_rows(context, range, [&](uint32_t y, uint32_t worker) {
      Row<Codec>(texture, layer, region.x, j, y, scratch + worker * rows).run();
    });
  }
}

}  // namespace

size_t ripmap_scratch_size(const core::Context& context, const Texture& texture) {
  const size_t rows = core::checked_mul(size_t{2} * texture.width, texture.channels);
  return core::checked_mul(rows, context.executor.worker_count);
}

void build_ripmap_levels(const core::Context& context, Texture* texture, uint32_t layer, const Region& region,
                         double* scratch) {
  visit_stored(texture->component, texture->channels,
               [&](auto codec) { build_ripmap_layer<decltype(codec)>(context, *texture, layer, region, scratch); });
}

}  // namespace shd::texture
