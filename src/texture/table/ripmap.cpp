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

#include "texture/store/rows.h"
#include "texture/store/span.h"
#include "texture/table/halve.h"
#include "texture/table/tables.h"

namespace shd::texture {
namespace {

/// Adds weight * texel to `sum` for every channel of a stored row.
void add_whole_row(const TexelCodec& codec, const uint8_t* texels, size_t width, double weight, double* sum) {
  for_runs(codec, texels, width, [&](const double* numbers, size_t count) {
    const size_t size = count * codec.channels;
    for (size_t i = 0; i < size; ++i) sum[i] += weight * numbers[i];
    sum += size;
  });
}

/// Adds pairs of texels in place.
void add_pairs(size_t channels, double* row, uint32_t width) {
  with_channels(channels, [&](auto count) {
    const double* from = row;
    double* to = row;
    for (uint32_t x = 0; x < width / 2; ++x, from += 2 * count, to += count) {
      for (size_t c = 0; c < count; ++c) to[c] = from[c] + from[c + count];
    }
  });
}

/// Computes the weighted sum of the texels under texel `index` of a level row of `width` texels, from a row of `base`
/// texels.
void add_span(size_t channels, const double* row, uint32_t index, uint32_t base, uint32_t width, double* sum) {
  const AxisSpan span(index, base, width);
  for (size_t c = 0; c < channels; ++c) sum[c] = 0;
  for (uint32_t x = span.first; x <= span.last; ++x) {
    const double weight = span.weight(x);
    for (size_t c = 0; c < channels; ++c) sum[c] += weight * row[x * channels + c];
  }
}

/// Builds row y of the levels (0.., j) of one layer.
class Row {
 public:
  /// Builds the texels over the base columns `columns`. `scratch` holds two rows of the base.
  Row(const TexelCodec& codec, Texture& texture, uint32_t layer, AxisRange columns, uint32_t j, uint32_t y,
      double* scratch)
      : codec_(codec),
        texture_(texture),
        columns_(columns),
        layer_(layer),
        j_(j),
        y_(y),
        whole_(scratch),
        halved_(scratch + texture.width * codec.channels) {}

  void run() {
    const uint32_t width = texture_.width, height = level_size(texture_.height, j_);
    const AxisSpan down(y_, texture_.height, height);
    std::memset(whole_, 0, width * codec_.channels * sizeof(double));
    for (uint32_t y = down.first; y <= down.last; ++y) {
      add_whole_row(codec_, row_of(texture_, layer_, 0, y), width, down.weight(y), whole_);
    }
    if (!is_there(0)) store(0, whole_);
    std::memcpy(halved_, whole_, width * codec_.channels * sizeof(double));
    bool even = true;
    for (uint32_t i = 1; i < texture_.ripmap_columns; ++i) {
      even = even && level_size(width, i - 1) % 2 == 0;
      if (even) {
        add_pairs(codec_.channels, halved_, level_size(width, i - 1));
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
    const double area = static_cast<double>(texture_.height) * (1u << i);
    store_averages(codec_, sum + range.first * codec_.channels, area, range.size(), texel(i, range.first));
  }

  void store_spans(uint32_t i) {
    const uint32_t width = level_size(texture_.width, i);
    const AxisRange range = level_range(columns_, texture_.width, width);
    const double area = static_cast<double>(texture_.width) * texture_.height;
    for (uint32_t x = range.first; x < range.end; ++x) {
      double sum[4];
      add_span(codec_.channels, whole_, x, texture_.width, width, sum);
      store_averages(codec_, sum, area, 1, texel(i, x));
    }
  }

  uint8_t* texel(uint32_t i, uint32_t x) const { return ripmap_row(texture_, layer_, i, j_, y_) + x * codec_.size; }

  const TexelCodec& codec_;
  Texture& texture_;
  const AxisRange columns_;
  const uint32_t layer_, j_, y_;
  double *whole_, *halved_;
};

}  // namespace

size_t ripmap_scratch_size(const core::Context& context, const Texture& texture) {
  const size_t rows = core::checked_mul(size_t{2} * texture.width, texture.channels);
  return core::checked_mul(rows, context.executor.worker_count);
}

void build_ripmap_levels(const core::Context& context, Texture* texture, uint32_t layer, const Region& region,
                         double* scratch) {
  const TexelCodec& codec = codec_of(texture->component, texture->channels);
  const size_t rows = size_t{2} * texture->width * codec.channels;
  for (uint32_t j = 0; j < texture->ripmap_rows; ++j) {
    const AxisRange range = level_range(region.y, texture->height, level_size(texture->height, j));
    for_rows(context, range, [&](uint32_t y, uint32_t worker) {
      Row(codec, *texture, layer, region.x, j, y, scratch + worker * rows).run();
    });
  }
}

}  // namespace shd::texture
