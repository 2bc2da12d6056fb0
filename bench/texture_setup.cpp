// SPDX-License-Identifier: MIT
#include "texture_setup.h"

#include <cmath>
#include <cstring>

#include "block_encoder.h"

namespace shd::bench {
namespace {

/// The nearest binary16 of a value in [0, 1] that is 0 or at least 2^-14.
uint16_t to_half(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return value == 0.0f ? 0 : static_cast<uint16_t>((bits - (112u << 23) + 0x1000u) >> 13);
}

/// All levels of a square texture of compressed blocks.
class BlockLevels {
 public:
  BlockLevels(const Format& format, uint32_t edge, std::vector<uint8_t> texels) {
    for (uint32_t side = edge; side > 0; side /= 2) {
      if (format.random_blocks) {
        add_random(format.format, side);
      } else {
        blocks_.push_back(format.format == SHD_FORMAT_BC7 ? encode_bc7(texels, side) : encode_bc1(texels, side));
        texels = halved(texels, side);
      }
      shd_image image = shd_image_default();
      image.format = format.format;
      image.width = image.height = side;
      image.pixels = blocks_.back().data();
      images_.push_back(image);
    }
  }
  /// Sets the texels and levels of a desc, which must not outlive this object.
  void set(shd_texture_desc* desc) const {
    desc->texels = images_[0].pixels;
    desc->level_images = images_.data() + 1;
    desc->level_count = static_cast<uint32_t>(images_.size()) - 1;
  }

 private:
  void add_random(shd_format format, uint32_t side) {
    const size_t across = (side + 3) / 4;
    blocks_.emplace_back(across * across * shd_format_block_size(format));
    for (uint8_t& byte : blocks_.back()) byte = static_cast<uint8_t>((state_ = state_ * 1664525u + 1013904223u) >> 24);
  }

  uint32_t state_ = 1;
  std::vector<std::vector<uint8_t>> blocks_;
  std::vector<shd_image> images_;
};

}  // namespace

std::vector<uint8_t> convert(const std::vector<uint8_t>& rgba, const Format& format) {
  if (format.format == SHD_FORMAT_RGBA8 || format.format == SHD_FORMAT_RGBA8_SRGB) return rgba;
  const size_t size = shd_format_size(format.format) / static_cast<size_t>(format.channels);
  const size_t step = 4 / static_cast<size_t>(format.channels);
  std::vector<uint8_t> texels(rgba.size() / step * size);
  for (size_t i = 0; i < rgba.size() / step; ++i) {
    const float value = static_cast<float>(rgba[i * step]) / 255.0f;
    const uint16_t half = to_half(value);
    const void* source = size == 1   ? static_cast<const void*>(&rgba[i * step])
                         : size == 2 ? &half
                                     : static_cast<const void*>(&value);
    std::memcpy(&texels[i * size], source, size);
  }
  return texels;
}

Sampling::Sampling(shd_simd simd, const Filter& filter, const Format& format, uint32_t edge,
                   const std::vector<uint8_t>& texels, uint32_t workers)
    : context_(make_context(simd, workers)) {
  shd_sampler_desc sampler = shd_sampler_desc_default();
  sampler.filter = filter.filter;
  sampler.stochastic_filter = filter.stochastic_filter;
  sampler.box = filter.box;
  sampler.profile = filter.profile;
  sampler.precision = filter.precision;
  sampler.probe_slack = filter.probe_slack;
  sampler.level_blend = filter.level_blend;
  sampler.stochastic = filter.stochastic;
  sampler.lod_bias = filter.bias;
  sampler.width_x = sampler.width_y = filter.width;
  sampler.max_anisotropy = filter.max_anisotropy;
  check(shd_sampler_create(context_, &sampler, &sampler_));
  const bool has_blocks = shd_format_block_size(format.format) != 0;
  const std::vector<uint8_t> converted = has_blocks ? std::vector<uint8_t>() : convert(texels, format);
  const BlockLevels blocks(format, has_blocks ? edge : 0, has_blocks ? texels : std::vector<uint8_t>());
  shd_texture_desc texture = shd_texture_desc_default();
  texture.format = format.format;
  texture.width = texture.height = edge;
  texture.texels = converted.data();
  texture.tables = filter.tables;
  if (has_blocks) blocks.set(&texture);
  check(shd_texture_create(context_, &texture, &texture_));
  if (format.in_tiles) move_into_tiles(texture);
}

void Sampling::move_into_tiles(const shd_texture_desc& of_memory) {
  shd_texture_desc desc = of_memory;
  for (uint32_t side = desc.width, level = 0; level == 0 || side > 1; ++level) {
    side = desc.width >> level;
    levels_.emplace_back(size_t{side} * side * shd_format_size(desc.format));
    shd_image image = shd_image_default();
    image.format = desc.format;
    image.width = image.height = side;
    image.pixels = levels_.back().data();
    check(shd_texture_read_level(texture_, 0, level, &image));
  }
  shd_texture_release(texture_);
  shd_tile_cache* cache = nullptr;
  check(shd_tile_cache_create(context_, nullptr, &cache));
  desc.texels = nullptr;
  desc.tiles.cache = cache;
  desc.tiles.user_data = &levels_;
  desc.tiles.load = [](const shd_tile* tiles, size_t count, void* user_data) {
    const auto& levels = *static_cast<const std::vector<std::vector<uint8_t>>*>(user_data);
    for (size_t i = 0; i < count; ++i) {
      const shd_tile& tile = tiles[i];
      const auto width = static_cast<size_t>(std::sqrt(static_cast<double>(levels[tile.level].size() / 4)));
      for (uint32_t y = 0; y < tile.area.height; ++y) {
        std::memcpy(static_cast<uint8_t*>(tile.texels) + y * tile.row_stride,
                    &levels[tile.level][4 * ((tile.area.y + y) * width + tile.area.x)], 4 * tile.area.width);
      }
    }
    return SHD_OK;
  };
  check(shd_texture_create(context_, &desc, &texture_));
  shd_tile_cache_release(cache);
}

Sampling::~Sampling() {
  shd_texture_release(texture_);
  shd_sampler_release(sampler_);
  shd_context_release(context_);
}

void Sampling::run(const shd_lookups& columns, shd_texels* out) const {
  check(shd_texture_sample(texture_, sampler_, &columns, out));
}

shd_lookups columns_of(const Lookups& q, const Filter& filter) {
  const size_t stride = filter.every * sizeof(float);
  shd_lookups columns = shd_lookups_default();
  columns.count = q.count() / filter.every;
  columns.u = {q.u.data(), stride};
  columns.v = {q.v.data(), stride};
  if (!filter.reads_derivatives) return columns;
  if (!q.lod.empty()) {
    columns.lod = {q.lod.data(), stride};
    return columns;
  }
  columns.dudx = {q.dudx.data(), stride};
  columns.dvdx = {q.dvdx.data(), stride};
  columns.dudy = {q.dudy.data(), stride};
  columns.dvdy = {q.dvdy.data(), stride};
  return columns;
}

std::vector<float> filtered_image(const Filter& filter, const Lookups& lookups, uint32_t edge,
                                  const std::vector<uint8_t>& texels) {
  const Sampling sampling(SHD_SIMD_BEST, filter, kRgba8, edge, texels);
  Filter all = filter;
  all.every = 1;
  std::vector<float> image(lookups.count() * 4);
  shd_texels out = {};
  for (int c = 0; c < 4; ++c) out.channel[c] = {&image[static_cast<size_t>(c)], 4 * sizeof(float)};
  sampling.run(columns_of(lookups, all), &out);
  return image;
}

}  // namespace shd::bench
