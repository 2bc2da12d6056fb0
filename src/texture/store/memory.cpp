// SPDX-License-Identifier: MIT
// Textures in memory: levels are packed rows of texels, copied or borrowed.
#include <cstring>

#include "core/executor.h"
#include "texture/store/image_list.h"
#include "texture/store/stores.h"

namespace shd::texture {
namespace {

constexpr uint32_t kRowsPerTask = 64;

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

/// Sets the numbers of the texels. Returns the number of texels of all layers.
size_t lay_out_memory(const core::Context& context, Texture* texture) {
  size_t texels = lay_out({0, 0}, texture);
  if (texture->tables & SHD_TABLE_RIPMAP) texels = lay_out_ripmap(context, texture, texels);
  texture->layout.layer_units = static_cast<uint32_t>(texels);
  return texels * texture->layers;
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
    texture->borrowed_units = desc.width * desc.height * (desc.depth != 0 ? desc.depth : desc.layer_count);
    if (desc.flags & SHD_TEXTURE_BORROW_LEVELS) texture->borrowed_units = static_cast<uint32_t>(texels);
  }
  const size_t size = core::checked_mul(texels - texture->borrowed_units, texel_size(*texture));
  texture->texels = core::Array<uint8_t>(context.allocator, size + kPadding);
  std::memset(texture->texels.data() + size, 0, kPadding);
  const auto first = reinterpret_cast<uintptr_t>(texture->texels.data());
  texture->origin = reinterpret_cast<const uint8_t*>(first - texture->borrowed_units * texel_size(*texture));
}

void fill_memory(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  allocate(context, desc, lay_out_memory(context, texture), texture);
  if (!texture->borrowed) copy_base(context, desc, texture);
  if (!(desc.flags & SHD_TEXTURE_BORROW_LEVELS)) copy_levels(context, desc, texture);
}

const uint8_t* texel_in_memory(const Texture& texture, uint32_t unit, uint32_t, uint32_t, TexelMemory*) {
  return texel_at(texture, unit);
}

void read_rows(const core::Context&, const Texture& texture, uint32_t image, uint32_t level, const shd_image& out) {
  for (uint32_t y = 0; y < out.height; ++y) {
    std::memcpy(static_cast<uint8_t*>(out.pixels) + y * out.row_stride, row_of(texture, image, level, y),
                out.width * texel_size(texture));
  }
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

const StoreRow kMemoryStore = {fill_memory, texel_in_memory, read_rows, read_rows, nullptr,
                               nullptr,     nullptr,         nullptr,   nullptr};

}  // namespace shd::texture
