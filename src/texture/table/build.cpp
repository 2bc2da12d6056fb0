// SPDX-License-Identifier: MIT
#include "texture/table/tables.h"

#include "image/format.h"
#include "texture/store/stores.h"
#include "texture/table/decoded.h"
#include "texture/table/summed_area.h"

namespace shd::texture {
namespace {

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

/// Sets the sizes of the texture and the number of its levels.
void set_size(const shd_texture_desc& desc, Texture* texture) {
  texture->width = desc.width;
  texture->height = desc.height;
  texture->layers = desc.layer_count;
  texture->depth = desc.depth;
  texture->projection = desc.projection;
  texture->tables = desc.tables;
  texture->level_count = desc.level_count + 1;
  texture->levels_given = desc.level_count > 0;
  if (desc.level_count == 0 && desc.tables & SHD_TABLE_MIPMAP) {
    texture->level_count = full_level_count(desc.width, desc.height, desc.depth);
  }
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

void build(const core::Context& context, const shd_texture_desc& desc, Texture* out) {
  set_format(desc, out);
  set_size(desc, out);
  out->store = store_of(desc);
  functions_of(out->store).fill(context, desc, out);
  if (is_in_memory(*out)) {
    build_tables(context, out);
  } else if (!out->tiles) {  // tables of tiles load tiles, which need the handle of the texture
    build_decoded(context, out);
  }
}

}  // namespace shd::texture
