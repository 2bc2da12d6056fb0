// SPDX-License-Identifier: MIT
#include "texture/lookup/coarser.h"

namespace shd::texture {

Sampler sampler_from_level(const Sampler& sampler, uint32_t level) {
  Sampler coarser = sampler;
  coarser.lod_min = std::max(sampler.lod_min, static_cast<float>(level));
  coarser.lod_max = std::max(sampler.lod_max, coarser.lod_min);
  switch (sampler.filter == SHD_FILTER_STOCHASTIC ? sampler.stochastic_filter : sampler.filter) {
    case SHD_FILTER_NEAREST: return with_filter(coarser, SHD_FILTER_NEAREST_MIP);
    case SHD_FILTER_BILINEAR:
    case SHD_FILTER_BICUBIC:
    case SHD_FILTER_HERMITE: return with_filter(coarser, SHD_FILTER_BILINEAR_MIP);
    default: return coarser;
  }
}

size_t rows_of_level(const uint8_t* needed, size_t count, uint32_t level, uint16_t* rows) {
  size_t found = 0;
  for (size_t i = 0; i < count; ++i) {
    if (needed[i] == level) rows[found++] = static_cast<uint16_t>(i);
  }
  return found;
}

void finish_coarser(const Texture& texture, const uint8_t* needed, size_t count, const Texels& out) {
  for (size_t i = 0; i < count; ++i) {
    if (out.coarser) out.coarser[i] = needed[i];
    if (needed[i] < texture.level_count) continue;
    for (size_t c = 0; c < kOutputColumns; ++c) {
      if (out.column(c)) out.column(c)[i] = 0.0f;
    }
  }
}

}  // namespace shd::texture
