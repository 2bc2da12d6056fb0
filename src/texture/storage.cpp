// SPDX-License-Identifier: MIT
#include "texture/storage.h"

#include <cstring>

#include "core/executor.h"
#include "image/format.h"

namespace shd::texture {
namespace {

constexpr uint32_t kRowsPerTask = 64;

/// Sets width, height and the offset of every level; returns the number of texels.
size_t lay_out(uint32_t width, uint32_t height, uint32_t level_count, Texture* texture) {
  texture->width = width;
  texture->height = height;
  texture->level_count = level_count;
  size_t texels = 0;
  for (uint32_t level = 0; level < kMaxLevels; ++level) {
    texture->offset[level] = static_cast<uint32_t>(texels);
    if (level < level_count) texels += size_t{level_size(width, level)} * level_size(height, level);
  }
  return texels;
}

void copy_base(const core::Context& context, const shd_texture_desc& desc, size_t pixel_size, Texture* texture) {
  const size_t row_size = desc.width * pixel_size;
  const size_t stride = desc.row_stride ? desc.row_stride : row_size;
  const auto* source = static_cast<const uint8_t*>(desc.texels);
  const uint32_t tasks = (desc.height + kRowsPerTask - 1) / kRowsPerTask;
  core::parallel_for(context, tasks, [&](uint32_t task, uint32_t) {
    const uint32_t first = task * kRowsPerTask;
    const uint32_t end = first + kRowsPerTask < desc.height ? first + kRowsPerTask : desc.height;
    for (uint32_t y = first; y < end; ++y) {
      std::memcpy(row_of(*texture, pixel_size, 0, y), source + y * stride, row_size);
    }
  });
}

}  // namespace

uint32_t full_level_count(uint32_t width, uint32_t height) {
  uint32_t count = 1;
  for (uint32_t size = width > height ? width : height; size > 1; size >>= 1) ++count;
  return count;
}

void build(const core::Context& context, const shd_texture_desc& desc, Texture* out) {
  const size_t pixel_size = image::format_info(desc.format).pixel_size;
  const bool mipmap = (desc.tables & SHD_TABLE_MIPMAP) != 0;
  Texture texture;
  texture.format = desc.format;
  const size_t texels =
      lay_out(desc.width, desc.height, mipmap ? full_level_count(desc.width, desc.height) : 1, &texture);
  const size_t size = core::checked_mul(texels, pixel_size);
  texture.texels = core::Array<uint8_t>(context.allocator, size + kPadding);
  std::memset(texture.texels.data() + size, 0, kPadding);
  copy_base(context, desc, pixel_size, &texture);
  if (mipmap) build_mip_levels(context, &texture);
  *out = static_cast<Texture&&>(texture);
}

}  // namespace shd::texture
