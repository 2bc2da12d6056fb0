// SPDX-License-Identifier: MIT
// Textures with summed-area tables, samplers of every wrap pair, and the form of both for the oracle.
#pragma once

#include "filter_cases.h"

#include "ref/summed_area_ref.h"

namespace fixture {

constexpr size_t kMaxTexels = size_t{1023} * 511;

inline Texture* build_summed(const shd::core::Context& made_by, shd_format format, uint32_t width, uint32_t height,
                             uint32_t layers, const void* texels) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.layer_count = layers;
  desc.texels = texels;
  desc.tables = SHD_TABLE_SUMMED_AREA;
  auto* texture = shd::core::create<Texture>(made_by.allocator);
  shd::texture::build(made_by, desc, texture);
  return texture;
}

inline Texture* random_summed(shd_format format, uint32_t width, uint32_t height, uint32_t layers) {
  const size_t count = size_t{width} * height * layers;
  auto* texels = static_cast<uint8_t*>(malloc(count * 16));
  random_texels(format, count, width * 31 + height, texels);
  Texture* texture = build_summed(*context(), format, width, height, layers, texels);
  free(texels);
  return texture;
}

/// Wrap pair 0..24 and both boxes.
inline shd_sampler_desc summed_desc(uint32_t pair, shd_box box) {
  shd_sampler_desc desc = wrap_desc(SHD_FILTER_SUMMED_AREA, pair);
  desc.box = box;
  return desc;
}

/// A layer of a texture in the form of the oracle, in static storage.
inline const double* oracle_values(const Texture& texture, uint32_t layer) {
  static double values[kMaxTexels * 4];
  const size_t size = shd::texture::texel_size(texture);
  const uint8_t* texels = shd::texture::row_of(texture, layer, 0, 0);
  for (size_t i = 0; i < size_t{texture.width} * texture.height; ++i) {
    for (int c = 0; c < 4; ++c)
      values[4 * i + static_cast<size_t>(c)] = ref::decode(texture.format, texels + i * size, c);
  }
  return values;
}

}  // namespace fixture
