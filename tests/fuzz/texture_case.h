// SPDX-License-Identifier: MIT
/// @file
/// Small textures and samplers of all formats, tables and filters, valid and invalid.
#pragma once

#include <array>

#include "host.h"

namespace shd::fuzz {

constexpr uint32_t kFormats = 21;  // SHD_FORMAT_NONE included
constexpr uint32_t kFilters = 14;
constexpr uint32_t kAllTables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;

inline bool is_half(shd_format format) {
  return format == SHD_FORMAT_RGBA16F || (format >= SHD_FORMAT_R16F && format <= SHD_FORMAT_RGB16F);
}
inline bool is_float(shd_format format) {
  return format == SHD_FORMAT_RGBA32F || (format >= SHD_FORMAT_R32F && format <= SHD_FORMAT_RGB32F);
}

/// Values for texels: few, so that inputs stay short.
class Palette {
 public:
  explicit Palette(Source& source) {
    const bool hostile = source.one_in(4);
    for (size_t i = 0; i < kSize; ++i) {
      floats_[i] = hostile ? source.hostile() : source.real();
      words_[i] = static_cast<uint16_t>(source.below(65536));
    }
  }

  /// Fills packed pixels of a format. Returns whether all of them are finite.
  bool fill(shd_format format, std::vector<uint8_t>& bytes, uint32_t seed) const {
    bool finite = true;
    const size_t size = is_float(format) ? 4 : 2;
    for (size_t i = 0; i + size <= bytes.size(); i += size) {
      const size_t k = (static_cast<uint32_t>(i) * 2654435761u + seed) >> 7 & (kSize - 1);
      if (is_float(format)) {
        finite = finite && std::isfinite(floats_[k]);
        std::memcpy(&bytes[i], &floats_[k], size);
      } else {
        finite = finite && !(is_half(format) && (words_[k] & 0x7c00) == 0x7c00);
        std::memcpy(&bytes[i], &words_[k], size);
      }
    }
    if (bytes.size() % 2 != 0) bytes.back() = static_cast<uint8_t>(words_[0]);
    return finite;
  }

 private:
  static constexpr size_t kSize = 8;
  float floats_[kSize];
  uint16_t words_[kSize];
};

struct TextureCase {
  shd_texture_desc desc = shd_texture_desc_default();
  std::vector<uint8_t> texels;
  bool finite = false;
};

/// A texture of at most max_edge x max_edge texels and three layers.
inline void choose_texture(Source& source, TextureCase& c, uint32_t max_edge) {
  shd_texture_desc& desc = c.desc;
  desc.format = source.constant<shd_format>(kFormats);
  desc.width = source.between(1, max_edge);
  desc.height = source.between(1, max_edge);
  desc.layer_count = source.one_in(4) ? source.between(1, 3) : 1;
  desc.tables = source.flags(kAllTables);
  for (shd_channel& channel : desc.swizzle) channel = source.constant<shd_channel>(6);
  for (float& value : desc.fill) value = source.real();
  desc.flags = source.one_in(8) ? source.flags(SHD_TEXTURE_BORROW) : 0;
  const size_t pixel = shd_format_size(desc.format);
  const size_t rows = size_t{desc.height} * desc.layer_count;
  const size_t gap = source.one_in(8) ? 4 * source.below(8) : 0;
  if (gap != 0) desc.row_stride = desc.width * pixel + gap;
  c.texels.assign(rows * (desc.width * pixel + gap) + (desc.flags ? SHD_TEXTURE_PADDING : 0), 0);
  const uint32_t seed = source.below(256);
  c.finite = Palette(source).fill(desc.format, c.texels, seed);
  desc.texels = c.texels.data();
  // Refused below, before any texel is read.
  switch (source.below(128)) {
    case 1: desc.width = source.one_in(2) ? 0 : 65537; break;
    case 2: desc.height = source.one_in(2) ? 0 : 0xffffffffu; break;
    case 3: desc.layer_count = source.one_in(2) ? 0 : 2049; break;
    case 4: desc.texels = nullptr; break;
    case 5: desc.struct_size = source.one_in(2) ? source.below(16) : 0x80000000u | source.word(); break;
    case 6: desc.row_stride = desc.width * pixel > 2 ? 1 + source.below(2) : desc.row_stride; break;
    default: break;
  }
}

inline void choose_sampler(Source& source, shd_sampler_desc& desc) {
  desc.filter = source.constant<shd_filter>(kFilters);
  desc.magnification = source.constant<shd_magnification>(5);
  desc.max_anisotropy = source.one_in(8) ? source.real(1, 64) : 1.0f + static_cast<float>(source.below(8));
  desc.probe_weights = source.constant<shd_probe_weights>(2);
  desc.cubic = source.constant<shd_cubic>(3);
  desc.box = source.constant<shd_box>(2);
  constexpr shd_filter kEstimated[] = {SHD_FILTER_TRILINEAR,   SHD_FILTER_BILINEAR, SHD_FILTER_BICUBIC,
                                       SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA,      SHD_FILTER_NEAREST};
  desc.stochastic_filter = kEstimated[source.below(6)];
  if (source.one_in(4)) desc.cubic = SHD_CUBIC_B_SPLINE;
  if (source.one_in(8)) desc.stochastic = SHD_STOCHASTIC_QUAD;
  desc.profile = source.constant<shd_profile>(5);
  desc.seed = source.below(256);
  desc.width_x = source.one_in(8) ? source.real(0, 64) : 1.0f;
  desc.width_y = source.one_in(8) ? source.real(0, 64) : 1.0f;
  desc.blur_u = source.one_in(8) ? source.real(0, 1) : 0.0f;
  desc.blur_v = source.one_in(8) ? source.real(0, 1) : 0.0f;
  desc.tolerance = source.real(0.5f, 1.0f);  // a small tolerance makes SHD_FILTER_EXACT slow
  if (desc.tolerance < 0.25f && desc.tolerance > 0.0f) desc.tolerance = 0.25f;
  desc.wrap_u = source.constant<shd_wrap>(5);
  desc.wrap_v = source.constant<shd_wrap>(5);
  for (float& value : desc.border) value = source.real();
  desc.lod_bias = source.one_in(4) ? source.real(-15, 15) : 0.0f;
  desc.lod_min = source.one_in(4) ? source.real(0, 32) : 0.0f;
  desc.lod_max = source.one_in(4) ? source.real(0, 32) : 32.0f;
  desc.precision = source.constant<shd_precision>(2);
  desc.max_texels = source.one_in(4) ? source.word() >> source.below(32) : 0;
  desc.probe_slack = source.one_in(4) ? source.real(0, 1) : 0.125f;
  desc.level_blend = source.one_in(4) ? source.real(0, 1) : 1.0f;
}

}  // namespace shd::fuzz
