// SPDX-License-Identifier: MIT
/// @file
/// Columns of lookups, valid and invalid, and the texture and the sampler that they read.
#pragma once

#include <vector>

#include "texture_case.h"

namespace shd::fuzz {

constexpr size_t kMaxLookups = 8;
constexpr int kColumns = 10;

/// A texture, a sampler and lookups that one input describes, so that they can run on several contexts.
struct LookupCase {
  TextureCase texture;
  shd_sampler_desc sampler = shd_sampler_desc_default();
  size_t count = 0;
  std::vector<float> columns[kColumns];  // u, v, dudx, dvdx, dudy, dvdy, lod, w, dwdx, dwdy
  size_t steps[kColumns] = {};
  std::vector<uint32_t> integers[2];  // layer, random
  uint32_t outputs = 0;               // bits
  size_t out_step = 1;
  uint64_t budget = 0;
};

inline void choose_column(Source& source, LookupCase& c, int k, float scale) {
  c.steps[k] = 1 + source.below(2);
  const bool hostile = source.one_in(4);
  c.columns[k].resize(c.count == 0 ? 1 : (c.count - 1) * c.steps[k] + 1);
  for (size_t i = 0; i < c.count; ++i) {
    c.columns[k][i * c.steps[k]] = hostile ? source.hostile() : scale * source.real();
  }
}

inline void choose_lookups(Source& source, LookupCase& c) {
  c.count = source.below(kMaxLookups + 1);
  for (int k = 0; k < 7; ++k) {
    if (k >= 2 && source.one_in(k == 6 ? 2 : 8)) continue;
    choose_column(source, c, k, k < 2 ? 2.0f : k < 6 ? 0.5f : 4.0f);
  }
  for (std::vector<uint32_t>& column : c.integers) {
    if (!source.one_in(4)) continue;
    column.resize(c.count + 1);
    for (size_t i = 0; i < c.count; ++i) column[i] = source.one_in(2) ? source.word() : source.below(4);
  }
  c.outputs = source.one_in(4) ? source.below(1 << 12) : 15;
  c.out_step = 1 + source.below(2);
}

/// Turns the layers of a texture into slices.
inline void choose_slices(Source& source, LookupCase& c) {
  if (!source.one_in(4) || c.texture.desc.layer_count > 3) return;  // more layers have no texels
  c.texture.desc.kind = SHD_TEXTURE_KIND_3D;
  c.texture.desc.depth = static_cast<uint32_t>(c.texture.desc.layer_count);
  c.texture.desc.layer_count = 1;
  c.texture.desc.level_count = 0;
  if (!source.one_in(8)) c.texture.desc.tables &= SHD_TABLE_MIPMAP;
  c.sampler.wrap_w = static_cast<shd_wrap>(source.below(source.one_in(16) ? 8 : 5));
  if (!source.one_in(8)) c.sampler.profile = SHD_PROFILE_LEAST_ERROR;
  if (!source.one_in(8)) c.sampler.blur_u = c.sampler.blur_v = 0.0f;
  for (int k = 7; k < kColumns; ++k) {
    if (!source.one_in(8)) choose_column(source, c, k, k == 7 ? 2.0f : 0.5f);
  }
  if (source.one_in(4)) c.outputs |= source.below(16) << 12;
}

/// Makes the texture one of directions, of at most 5 x 5 texels a face.
inline void choose_directions(Source& source, LookupCase& c) {
  shd_texture_desc& desc = c.texture.desc;
  desc.projection = source.constant<shd_projection>(6);
  for (int k = 7; k < 10; ++k) {
    if (!source.one_in(16)) choose_column(source, c, k, k == 7 ? 2.0f : 0.5f);
  }
  if (!desc.texels || desc.width - 1 >= 9 || desc.height - 1 >= 9 || desc.layer_count > 6 || desc.flags ||
      source.one_in(32))
    return;
  desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
  if (desc.projection != SHD_PROJECTION_LAT_LONG) desc.width = desc.height = desc.width < 5 ? desc.width : 5;
  if (desc.projection == SHD_PROJECTION_CUBE) desc.layer_count = 6;
  if (!source.one_in(32)) desc.tables &= SHD_TABLE_MIPMAP;
  const size_t pixel = shd_format_size(desc.format);
  const size_t stride = desc.row_stride ? desc.row_stride : desc.width * pixel;
  const size_t given = c.texture.texels.size(), size = stride * desc.height * desc.layer_count;
  for (size_t i = given; given > 0 && i < size; ++i) c.texture.texels.push_back(c.texture.texels[i - given]);
  desc.texels = c.texture.texels.data();
}

inline shd_lookups make_lookups(const LookupCase& c) {
  shd_lookups lookups = shd_lookups_default();
  lookups.count = c.count;
  shd_f32_in* columns[kColumns] = {&lookups.u,    &lookups.v,   &lookups.dudx, &lookups.dvdx, &lookups.dudy,
                                   &lookups.dvdy, &lookups.lod, &lookups.w,    &lookups.dwdx, &lookups.dwdy};
  for (int k = 0; k < kColumns; ++k) {
    if (!c.columns[k].empty()) *columns[k] = shd_f32_column(c.columns[k].data(), 4 * c.steps[k]);
  }
  if (!c.integers[0].empty()) lookups.layer.data = c.integers[0].data();
  if (!c.integers[1].empty()) lookups.random.data = c.integers[1].data();
  return lookups;
}

struct Objects {
  shd_texture* texture = nullptr;
  shd_sampler* sampler = nullptr;
  ~Objects() {
    shd_sampler_release(sampler);
    shd_texture_release(texture);
  }
};

}  // namespace shd::fuzz
