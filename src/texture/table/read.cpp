// SPDX-License-Identifier: MIT
#include "texture/table/read.h"

#include <algorithm>
#include <limits>

#include "data/column.h"
#include "texture/format/texel_codec.h"
#include "texture/store/rows.h"
#include "texture/store/storage.h"
#include "texture/store/stores.h"
#include "texture/table/decoded.h"
#include "texture/table/summed_area.h"

namespace shd::texture {
namespace {

/// Returns the texture in memory that has the ripmap and the sums.
const Texture& table_of(const Texture& texture) {
  return texture.decoded ? texture.decoded->texture : texture;
}

/// Returns the sum of the sizes of levels first..last - 1 of an axis.
uint32_t sum_of_sizes(uint32_t base, uint32_t first, uint32_t last) {
  uint32_t sum = 0;
  for (uint32_t level = first; level < last; ++level) sum += level_size(base, level);
  return sum;
}

/// The columns of a call, and the codec of their texels.
struct Columns {
  const Texture& texture;
  const TexelCodec& codec;
  const shd_f32_out* out;  // [4]

  /// Writes element `at` of each column: value(stored channel) or of_fill(constant).
  template <class ValueOf, class FillOf>
  void store(size_t at, const ValueOf& value, const FillOf& of_fill) const {
    for (size_t c = 0; c < 4; ++c) {
      if (!out[c].data) continue;
      const uint32_t source = texture.channel_source[c];
      const double number = source == kFill ? of_fill(static_cast<double>(texture.fill[c])) : value(source);
      data::store(out[c], at, static_cast<float>(number));
    }
  }
};

/// Packed rows of a level.
struct LevelTexels {
  const uint8_t* first;
  core::Array<uint8_t> decoded;  // empty if the rows are the texture's
};

LevelTexels texels_of(const core::Context& context, const Texture& texture, const TableView& view) {
  if (view.table == SHD_TABLE_RIPMAP) return {ripmap_row(table_of(texture), view.image, view.i, view.j, 0), {}};
  const uint32_t last = level_size(texture.depth, view.i) - 1;
  const uint32_t image = texture.depth != 0 ? std::min(view.image, last) : view.image;
  if (is_in_memory(texture)) return {row_of(texture, image, view.i, 0), {}};
  shd_image level = shd_image_default();
  level.width = level_size(texture.width, view.i);
  level.height = level_size(texture.height, view.i);
  level.row_stride = level.width * texel_size(texture);
  core::Array<uint8_t> decoded(context.allocator, core::checked_mul(level.row_stride, level.height));
  level.pixels = decoded.data();
  functions_of(texture.store).decode_level(context, texture, image, view.i, level);
  return {decoded.data(), std::move(decoded)};
}

/// Reads a level to element `at` on, in rows of `pitch` elements.
void read_level(const core::Context& context, const Columns& columns, const TableView& view, size_t at, size_t pitch) {
  const Texture& texture = columns.texture;
  const uint32_t width = level_size(texture.width, view.i), height = level_size(texture.height, view.j);
  const LevelTexels texels = texels_of(context, texture, view);
  for_rows(context, {0, height}, [&](uint32_t y, uint32_t) {
    size_t to = at + y * pitch;
    for_runs(columns.codec, texels.first + size_t{y} * width * columns.codec.size, width,
             [&](const double* numbers, size_t count) {
               for (size_t i = 0; i < count; ++i, numbers += columns.codec.channels) {
                 columns.store(
                     to++, [&](uint32_t c) { return numbers[c] / columns.codec.one[c]; },
                     [](double fill) { return fill; });
               }
             });
  });
}

void read_picture(const core::Context& context, const Columns& columns, TableView view) {
  const TablePoint size = table_size(columns.texture, view), levels = table_levels(columns.texture, view.table);
  const auto zero = [](auto) { return 0.0; };
  for_rows(context, {0, size.y}, [&](uint32_t y, uint32_t) {
    for (uint32_t x = 0; x < size.x; ++x) columns.store(size_t{y} * size.x + x, zero, zero);
  });
  const bool is_mipmap = view.table == SHD_TABLE_MIPMAP;
  const uint32_t slice = view.image;
  for (view.j = 0; view.j < levels.y; ++view.j) {
    for (view.i = is_mipmap ? view.j : 0; view.i < (is_mipmap ? view.j + 1 : levels.x); ++view.i) {
      if (columns.texture.depth != 0) view.image = slice >> view.i;
      const TablePoint place = level_place(columns.texture, view);
      read_level(context, columns, view, size_t{place.y} * size.x + place.x, size.x);
    }
  }
}

/// Reads sums, or the means of a picture. A sum of the table is relative to the origin of the layer.
template <class Entry>
void read_sums(const core::Context& context, const Columns& columns, const TableView& view) {
  const Texture& table = table_of(columns.texture);
  const TablePoint size = table_size(columns.texture, view);
  const size_t channels = columns.codec.channels, pitch = (size_t{table.width} + 1) * channels;
  const size_t layer = view.image * sum_count(table);
  const Entry* const sums = reinterpret_cast<const Entry*>(table.sums.data()) + layer;
  const uint32_t* const bad = table.nonfinite_sums.size() ? table.nonfinite_sums.data() + layer : nullptr;
  const double* const origin = table.sum_origins.data() + view.image * channels;
  const uint32_t first = view.is_picture ? 1 : 0;
  for_rows(context, {0, size.y}, [&](uint32_t row, uint32_t) {
    const uint32_t y = row + first;
    for (uint32_t x = first; x < size.x + first; ++x) {
      const size_t entry = y * pitch + x * channels;
      const double texels = static_cast<double>(x) * y;
      const auto value = [&](uint32_t c) {
        const double sum = static_cast<double>(sums[entry + c]) / columns.codec.one[c];
        const double count = bad ? texels - bad[entry + c] : texels;
        if (!view.is_picture) return sum + origin[c] * count;
        return count > 0 ? origin[c] + sum / count : std::numeric_limits<double>::quiet_NaN();
      };
      columns.store(size_t{row} * size.x + x - first, value,
                    [&](double fill) { return view.is_picture ? fill : fill * texels; });
    }
  });
}

}  // namespace

TablePoint table_levels(const Texture& texture, shd_table table) {
  if (table == SHD_TABLE_SUMMED_AREA) return {1, 1};
  if (table == SHD_TABLE_MIPMAP) return {texture.level_count, texture.level_count};
  return {table_of(texture).ripmap_columns, table_of(texture).ripmap_rows};
}

TablePoint table_size(const Texture& texture, const TableView& view) {
  const uint32_t width = texture.width, height = texture.height;
  if (view.table == SHD_TABLE_SUMMED_AREA) {
    const uint32_t corner = view.is_picture ? 0 : 1;
    return {width + corner, height + corner};
  }
  if (!view.is_picture) return {level_size(width, view.i), level_size(height, view.j)};
  const TablePoint levels = table_levels(texture, view.table);
  if (view.table == SHD_TABLE_RIPMAP) return {sum_of_sizes(width, 0, levels.x), sum_of_sizes(height, 0, levels.y)};
  return {sum_of_sizes(width, 0, std::min(levels.x, 2u)), std::max(height, sum_of_sizes(height, 1, levels.y))};
}

TablePoint level_place(const Texture& texture, const TableView& view) {
  if (view.table == SHD_TABLE_SUMMED_AREA) return {0, 0};
  if (view.table == SHD_TABLE_RIPMAP) {
    return {sum_of_sizes(texture.width, 0, view.i), sum_of_sizes(texture.height, 0, view.j)};
  }
  return {view.i == 0 ? 0 : texture.width, sum_of_sizes(texture.height, 1, view.i)};
}

void read_table(const core::Context& context, const Texture& texture, const TableView& view, const shd_f32_out* out) {
  const Columns columns = {texture, codec_of(texture.component, texture.channels), out};
  if (view.table == SHD_TABLE_SUMMED_AREA) {
    if (has_integer_sums(table_of(texture))) return read_sums<uint32_t>(context, columns, view);
    return read_sums<double>(context, columns, view);
  }
  if (view.is_picture) return read_picture(context, columns, view);
  read_level(context, columns, view, 0, level_size(texture.width, view.i));
}

}  // namespace shd::texture
