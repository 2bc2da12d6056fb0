// SPDX-License-Identifier: MIT
// Mip levels as exact box averages of the base, for any size (Williams, "Pyramidal Parametrics", 1983).
//
// While both sizes halve evenly (or are 1), a level is the average of the unrounded level before it. A round reduces
// tiles of its first level by up to kTileSteps levels in a scratch of 8 KB, and keeps the unrounded averages of the
// last level for the next round. For integer formats, the first kSumSteps levels are sums of integers.
//
// From the first uneven step on, each level is summed from the base. The weight of a base texel is the integer area
// that it shares with the level texel: with w and w' the sizes of base and level, level texel i covers [i w, (i + 1) w)
// and base texel x covers [x w', (x + 1) w').
//
// The update of a rectangle of the base takes the same steps with the stored unrounded averages of the rest of the
// layer. A change of 64 x 64 texels costs a few tiles per round. Levels after an uneven step read all base texels under
// the changed level texels.
//
// Sums are doubles. They are exact for 8-bit texels and within 2^-50 of the sum of magnitudes for other formats. A
// constant base gives constant levels: c n is exact for n <= 2^28 and a c of 24 bits.
#include <cstring>

#include "texture/store/rows.h"
#include "texture/store/span.h"
#include "texture/table/halve.h"
#include "texture/table/mip_axis.h"
#include "texture/table/mip_sums.h"
#include "texture/table/tables.h"

namespace shd::texture {
namespace {

constexpr uint32_t kTileSteps = 5;
constexpr uint32_t kTile = 1u << kTileSteps;

/// Returns the texels of a level over a rectangle of the base.
Region level_region(const Texture& texture, const Region& region, uint32_t level) {
  return {level_range(region.x, texture.width, level_size(texture.width, level)),
          level_range(region.y, texture.height, level_size(texture.height, level))};
}

/// Averages squares of 2 x 2 texels of a whole plane in place.
void halve(size_t channels, double* plane, uint32_t width, uint32_t height) {
  const size_t pitch = width * channels, to_pitch = (width + 1) / 2 * channels;
  for (uint32_t y = 0; y < (height + 1) / 2; ++y) {
    halve_rows(channels, plane + 2 * y * pitch, height > 1 ? pitch : 0, width, plane + y * to_pitch);
  }
}

/// One round over levels that halve evenly, from level `from` to level from + steps.
struct Round {
  const TexelCodec& codec;
  Texture& texture;
  const double* source;  // unrounded level `from`; null for the stored base
  double* last;          // unrounded level from + steps, or null
  uint32_t from, steps;
  uint32_t layer;

  void run(const core::Context& context, const Region& region) const {
    const Region tiles = level_region(texture, region, from + steps);
    for_rows(context, tiles.y, [&](uint32_t row, uint32_t) {
      const uint32_t columns = level_size(texture.width, from + steps);
      for (uint32_t column = tiles.x.first; column < tiles.x.end; ++column) run_tile(column, row, columns);
    });
  }

  void run_tile(uint32_t column, uint32_t row, uint32_t columns) const {
    double scratch[4 * kTile * kTile / 4];
    const uint32_t level_width = level_size(texture.width, from), level_height = level_size(texture.height, from);
    uint32_t width = level_width < 1u << steps ? level_width : 1u << steps;
    uint32_t height = level_height < 1u << steps ? level_height : 1u << steps;
    halve_source(column * width, row * height, width, height, scratch);
    for (uint32_t step = 1; step <= steps; ++step) {
      if (step > 1) halve(codec.channels, scratch, width, height);
      width = width > 1 ? width / 2 : 1;
      height = height > 1 ? height / 2 : 1;
      store(from + step, column * width, row * height, width, height, scratch);
    }
    if (last) {
      std::memcpy(last + (size_t{row} * columns + column) * codec.channels, scratch, codec.channels * sizeof(double));
    }
  }

  /// Computes the first step of a tile whose first texel is (x, y).
  void halve_source(uint32_t x, uint32_t y, uint32_t width, uint32_t height, double* to) const {
    const uint32_t down = height > 1 ? 1 : 0;
    const size_t to_row = size_t{width > 1 ? width / 2 : 1} * codec.channels;
    for (uint32_t j = 0; j < (height + 1) / 2; ++j, to += to_row) {
      const uint32_t top = y + 2 * j;
      if (source) {
        const size_t pitch = size_t{level_size(texture.width, from)} * codec.channels;
        halve_rows(codec.channels, source + top * pitch + x * codec.channels, down * pitch, width, to);
      } else {
        halve_texels(codec, row_of(texture, layer, 0, top) + x * codec.size,
                     row_of(texture, layer, 0, top + down) + x * codec.size, width, to);
      }
    }
  }

  void store(uint32_t level, uint32_t x, uint32_t y, uint32_t width, uint32_t height, const double* average) const {
    for (uint32_t j = 0; j < height; ++j, average += width * codec.channels) {
      codec.store(average, width, row_of(texture, layer, level, y + j) + x * codec.size);
    }
  }
};

/// The first round of an integer format. Both sizes of the base are multiples of 2^steps.
template <class Codec>
struct FirstRound {
  using Sum = typename Sums<Codec>::Sum;
  static constexpr uint32_t kRows = 1u << kSumSteps;
  static constexpr uint32_t kColumns = 1024 / sizeof(Sum);

  Texture& texture;
  double* last;  // unrounded level `steps`, or null
  uint32_t steps;
  uint32_t layer;

  void run(const core::Context& context, const Region& region) const {
    const Sums<Codec> sums;
    const Region tiles = level_region(texture, region, steps);
    const uint32_t end = tiles.x.end << steps;
    for_rows(context, tiles.y, [&](uint32_t band, uint32_t) {
      for (uint32_t x = tiles.x.first << steps; x < end; x += kColumns) {
        run_tile(sums, x, end - x < kColumns ? end - x : kColumns, band << steps);
      }
    });
  }

  void run_tile(const Sums<Codec>& sums, uint32_t x, uint32_t width, uint32_t y) const {
    Sum odd[Codec::kChannels * kColumns * kRows / 4], even[Codec::kChannels * kColumns * kRows / 16];
    const Sum* from = even;
    Sum* to = odd;
    uint32_t rows = 1u << steps;
    for (uint32_t step = 1; step <= steps; ++step) {
      width /= 2;
      rows /= 2;
      x /= 2;
      y /= 2;
      const size_t pitch = size_t{width} * Codec::kChannels;
      for (uint32_t j = 0; j < rows; ++j) {
        if (step == 1) {
          sums.pair(row_of(texture, layer, 0, 2 * (y + j)) + size_t{x} * 2 * Codec::kSize,
                    row_of(texture, layer, 0, 2 * (y + j) + 1) + size_t{x} * 2 * Codec::kSize, width, to + j * pitch);
        } else {
          sums.halve(from + 4 * j * pitch, from + (4 * j + 2) * pitch, width, to + j * pitch);
        }
        sums.store(to + j * pitch, width, 2 * step, row_of(texture, layer, step, y + j) + size_t{x} * Codec::kSize);
      }
      from = to;
      to = to == odd ? even : odd;
    }
    if (last) keep(sums, from, x, y, width);
  }

  void keep(const Sums<Codec>& sums, const Sum* from, uint32_t x, uint32_t y, uint32_t width) const {
    double* to = last + (size_t{y} * level_size(texture.width, steps) + x) * Codec::kChannels;
    for (size_t i = 0; i < width; ++i) {
      for (size_t c = 0; c < Codec::kChannels; ++c, ++from) *to++ = sums.average(*from, c, 2 * steps);
    }
  }
};

/// Sums one level from the base.
void sum_level(const core::Context& context, const TexelCodec& codec, Texture& texture, uint32_t layer, uint32_t level,
               const Region& region) {
  const uint32_t width = level_size(texture.width, level), height = level_size(texture.height, level);
  const double area = static_cast<double>(texture.width) * texture.height;
  const Region texels = level_region(texture, region, level);
  for_rows(context, texels.y, [&](uint32_t y, uint32_t) {
    const AxisSpan down(y, texture.height, height);
    uint8_t* texel = row_of(texture, layer, level, y) + size_t{texels.x.first} * codec.size;
    for (uint32_t x = texels.x.first; x < texels.x.end; ++x, texel += codec.size) {
      const AxisSpan across(x, texture.width, width);
      double sum[4] = {};
      for (uint32_t row = down.first; row <= down.last; ++row) {
        add_row(codec, row_of(texture, layer, 0, row), across, down.weight(row), sum);
      }
      store_averages(codec, sum, area, 1, texel);
    }
  });
}

uint32_t even_steps(const Texture& texture) {
  return even_halvings(texture.width, texture.height, texture.level_count);
}

/// Returns the number of first levels, up to kSumSteps, that halve both sizes.
uint32_t square_steps(const Texture& texture) {
  uint32_t steps = 0;
  while (steps < kSumSteps && (texture.width | texture.height) % (2u << steps) == 0) ++steps;
  return steps;
}

/// Returns whether the first averages of a texture are exact sums of integers.
bool has_exact_sums(const Texture& texture) {
  bool exact = false;
  visit_stored(texture.component, texture.channels, [&](auto codec) { exact = Sums<decltype(codec)>::kExact; });
  return exact;
}

/// Returns the steps of the round that begins at level `from`, if `even` levels halve evenly.
uint32_t round_steps(const Texture& texture, uint32_t from, uint32_t even) {
  const uint32_t square = from == 0 && has_exact_sums(texture) ? square_steps(texture) : 0;
  if (square > 0) return square;
  return even - from < kTileSteps ? even - from : kTileSteps;
}

/// Returns the number of unrounded averages of one level.
size_t plane_size(const Texture& texture, uint32_t level) {
  return size_t{level_size(texture.width, level)} * level_size(texture.height, level) * texture.channels;
}

void build_first_round(const core::Context& context, Texture& texture, uint32_t layer, uint32_t steps,
                       const Region& region, double* last) {
  visit_stored(texture.component, texture.channels, [&](auto codec) {
    using Codec = decltype(codec);
    if constexpr (Sums<Codec>::kExact) FirstRound<Codec>{texture, last, steps, layer}.run(context, region);
  });
}

}  // namespace

size_t mip_sums_size(const Texture& texture) {
  if (texture.depth != 0) return slice_sums_size(texture);
  const uint32_t even = even_steps(texture);
  size_t size = 0;
  for (uint32_t level = 0; level < even;) {
    level += round_steps(texture, level, even);
    if (level < even) size += plane_size(texture, level);
  }
  return size;
}

void build_mip_levels(const core::Context& context, Texture* texture, uint32_t layer, const Region& region,
                      double* sums) {
  const TexelCodec& codec = codec_of(texture->component, texture->channels);
  const uint32_t even = even_steps(*texture);
  const double* source = nullptr;
  for (uint32_t from = 0, steps; from < even; from += steps) {
    steps = round_steps(*texture, from, even);
    double* last = from + steps < even ? sums : nullptr;
    if (from == 0 && has_exact_sums(*texture) && square_steps(*texture) > 0) {
      build_first_round(context, *texture, layer, steps, region, last);
    } else {
      Round{codec, *texture, source, last, from, steps, layer}.run(context, region);
    }
    source = last;
    if (last) sums += plane_size(*texture, from + steps);
  }
  for (uint32_t level = even + 1; level < texture->level_count; ++level) {
    sum_level(context, codec, *texture, layer, level, region);
  }
}

}  // namespace shd::texture
