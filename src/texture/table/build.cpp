// SPDX-License-Identifier: MIT
#include "texture/table/tables.h"

#include <cstring>

#include "core/executor.h"
#include "image/format.h"
#include "texture/store/bc/levels.h"
#include "texture/store/image_list.h"
#include "texture/store/tiles/tile.h"
#include "texture/table/decoded.h"
#include "texture/table/summed_area.h"

namespace shd::texture {
namespace {

constexpr uint32_t kRowsPerTask = 64;

/// Returns the storage format of texels of a format. Three channels are stored as four.
shd_format stored_format(shd_format format) {
  switch (format) {
    case SHD_FORMAT_RGB8: return SHD_FORMAT_RGBA8;
    case SHD_FORMAT_RGB8_SRGB: return SHD_FORMAT_RGBA8_SRGB;
    case SHD_FORMAT_RGB16: return SHD_FORMAT_RGBA16;
    case SHD_FORMAT_RGB16F: return SHD_FORMAT_RGBA16F;
    case SHD_FORMAT_RGB32F: return SHD_FORMAT_RGBA32F;
    default: return format;
  }
}

void set_format(const shd_texture_desc& desc, Texture* texture) {
  const image::BlockInfo blocks = image::block_info(desc.format);
  const image::FormatInfo given = image::format_info(desc.format);
  const size_t channels = blocks.block_size ? blocks.channels : given.channels;
  texture->format = stored_format(desc.format);
  texture->component = blocks.block_size ? blocks.component : given.component;
  texture->given_format = desc.format;
  texture->premultiplied = (desc.flags & SHD_TEXTURE_PREMULTIPLIED) != 0;
  texture->channels = static_cast<uint32_t>(blocks.block_size ? blocks.stored : channels == 3 ? 4 : channels);
  for (uint32_t c = 0; c < 4; ++c) {
    uint32_t source = c;
    if (desc.swizzle[c] != SHD_CHANNEL_DEFAULT) source = static_cast<uint32_t>(desc.swizzle[c]) - SHD_CHANNEL_R;
    texture->channel_source[c] = source < channels ? source : kFill;
    texture->fill[c] = desc.fill[c];
  }
}

/// Sets the offsets of the ripmap levels, which follow the first `texels` texels. Returns the new number of texels.
size_t lay_out_ripmap(const core::Context& context, Texture* texture, size_t texels) {
  texture->ripmap_columns = full_level_count(texture->width, 1);
  texture->ripmap_rows = full_level_count(texture->height, 1);
  texture->ripmap_offset = core::Array<uint32_t>(context.allocator, size_t{texture->ripmap_rows} * kMaxLevels);
  texture->ripmap_offset.fill_zero();
  for (uint32_t j = 0; j < texture->ripmap_rows; ++j) {
    for (uint32_t i = 0; i < texture->ripmap_columns; ++i) {
      uint32_t* offset = &texture->ripmap_offset[j * kMaxLevels + i];
      if (is_mip_level(*texture, i, j)) {
        *offset = texture->layout.offset[i > j ? i : j];
      } else {
        *offset = static_cast<uint32_t>(texels);
        texels += size_t{level_size(texture->width, i)} * level_size(texture->height, j);
      }
    }
  }
  return texels;
}

/// Sets the sizes of the texture and the number of its levels.
void set_size(const shd_texture_desc& desc, Texture* texture) {
  texture->width = desc.width;
  texture->height = desc.height;
  texture->layers = desc.layers;
  texture->depth = desc.depth;
  texture->projection = desc.projection;
  texture->tables = desc.tables;
  texture->level_count = desc.level_count + 1;
  texture->levels_given = desc.level_count > 0;
  if (desc.level_count == 0 && desc.tables & SHD_TABLE_MIPMAP) {
    texture->level_count = full_level_count(desc.width, desc.height, desc.depth);
  }
}

/// Sets the numbers of the texels in memory. Returns the number of texels of all layers.
size_t lay_out_memory(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  size_t texels = lay_out({0, 0}, texture);
  if (desc.tables & SHD_TABLE_RIPMAP) texels = lay_out_ripmap(context, texture, texels);
  texture->layout.layer_units = static_cast<uint32_t>(texels);
  return texels * desc.layers;
}

/// Copies a row of three channels into a row of four. The fourth channel is 0.
void expand_row(const uint8_t* from, size_t channel_size, uint32_t width, uint8_t* to) {
  for (uint32_t x = 0; x < width; ++x, from += 3 * channel_size, to += 4 * channel_size) {
    std::memcpy(to, from, 3 * channel_size);
    std::memset(to + 3 * channel_size, 0, channel_size);
  }
}

void copy_base(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  const image::FormatInfo format = image::format_info(desc.format);
  const size_t stride = desc.row_stride ? desc.row_stride : desc.width * format.pixel_size;
  const size_t layer_stride = desc.layer_stride ? desc.layer_stride : desc.height * stride;
  const auto* source = static_cast<const uint8_t*>(desc.texels);
  const uint32_t tasks_per_layer = (desc.height + kRowsPerTask - 1) / kRowsPerTask;
  core::parallel_for(context, tasks_per_layer * image_count(*texture), [&](uint32_t task, uint32_t) {
    const uint32_t layer = task / tasks_per_layer;
    const uint32_t first = task % tasks_per_layer * kRowsPerTask;
    const uint32_t end = first + kRowsPerTask < desc.height ? first + kRowsPerTask : desc.height;
    copy_rows({source + layer * layer_stride, stride, format}, layer, 0, whole(*texture), {first, end}, texture);
  });
}

/// Copies the levels that the caller gave.
void copy_levels(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  const image::FormatInfo format = image::format_info(desc.format);
  for_given_levels(context, desc, [&](const shd_image& image, uint32_t number, uint32_t level) {
    const GivenTexels given = {static_cast<const uint8_t*>(image.pixels), image.row_stride, format};
    const Region region = {{0, image.width}, {0, image.height}};
    copy_rows(given, number, level, region, region.y, texture);
  });
}

/// Allocates memory for `texels` texels minus the borrowed ones.
void allocate(const core::Context& context, const shd_texture_desc& desc, size_t texels, Texture* texture) {
  if (desc.flags & SHD_TEXTURE_BORROW) {
    texture->borrowed = static_cast<const uint8_t*>(desc.texels);
    // Several layers have no other levels.
    texture->borrowed_units = desc.width * desc.height * (desc.depth != 0 ? desc.depth : desc.layers);
    if (desc.flags & SHD_TEXTURE_BORROW_LEVELS) texture->borrowed_units = static_cast<uint32_t>(texels);
  }
  const size_t size = core::checked_mul(texels - texture->borrowed_units, texel_size(*texture));
  texture->texels = core::Array<uint8_t>(context.allocator, size + kPadding);
  std::memset(texture->texels.data() + size, 0, kPadding);
  const auto first = reinterpret_cast<uintptr_t>(texture->texels.data());
  texture->origin = reinterpret_cast<const uint8_t*>(first - texture->borrowed_units * texel_size(*texture));
}

void build_tables(const core::Context& context, Texture* texture) {
  if (has_built_levels(*texture)) {
    core::Array<double> sums(context.allocator, mip_sums_size(*texture));
    if (texture->depth != 0) return build_slice_levels(context, texture, whole_box(*texture), sums.data());
    for (uint32_t layer = 0; layer < texture->layers; ++layer) {
      build_mip_levels(context, texture, layer, whole(*texture), sums.data());
    }
  }
  if (texture->tables & SHD_TABLE_RIPMAP) {
    core::Array<double> scratch(context.allocator, ripmap_scratch_size(context, *texture));
    for (uint32_t layer = 0; layer < texture->layers; ++layer) {
      build_ripmap_levels(context, texture, layer, whole(*texture), scratch.data());
    }
  }
  if (texture->tables & SHD_TABLE_SUMMED_AREA) build_summed_area(context, texture);
}

}  // namespace

void copy_rows(const GivenTexels& given, uint32_t layer, uint32_t level, const Region& region, AxisRange rows,
               Texture* texture) {
  const size_t first = region.x.first * texel_size(*texture);
  for (uint32_t y = rows.first; y < rows.end; ++y) {
    const uint8_t* from = given.texels + size_t{y - region.y.first} * given.stride;
    uint8_t* to = row_of(*texture, layer, level, y) + first;
    if (image::has_three_numbers(given.format)) {
      expand_row(from, given.format.channel_size, region.x.size(), to);
    } else {
      std::memcpy(to, from, region.x.size() * given.format.pixel_size);
    }
  }
}

void build(const core::Context& context, const shd_texture_desc& desc, Texture* out) {
  Texture texture = {};
  set_format(desc, &texture);
  set_size(desc, &texture);
  if (desc.tiles.cache) {
    *out = static_cast<Texture&&>(texture);
    return build_tiles(context, desc, out);
  }
  if (image::block_info(desc.format).block_size) {
    copy_blocks(context, desc, &texture);
    build_decoded(context, &texture);
    *out = static_cast<Texture&&>(texture);
    return;
  }
  const size_t texels = lay_out_memory(context, desc, &texture);
  allocate(context, desc, texels, &texture);
  if (!texture.borrowed) copy_base(context, desc, &texture);
  if (!(desc.flags & SHD_TEXTURE_BORROW_LEVELS)) copy_levels(context, desc, &texture);
  build_tables(context, &texture);
  *out = static_cast<Texture&&>(texture);
}

}  // namespace shd::texture
