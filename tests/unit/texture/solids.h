// SPDX-License-Identifier: MIT
// 3D textures, lookups in them and their oracles, for the tests of their filters.
#pragma once

#include "points.h"

#include "ref/slices_ref.h"

namespace fixture {

struct SolidSize {
  const char* name;
  uint32_t width, height, depth;
};
constexpr SolidSize kSolidSizes[] = {{"1x1x1", 1, 1, 1}, {"5x3x7", 5, 3, 7},     {"16x8x4", 16, 8, 4},
                                     {"1x1x9", 1, 1, 9}, {"33x17x5", 33, 17, 5}, {"32x32x32", 32, 32, 32}};
constexpr shd_format kSolidFormats[] = {SHD_FORMAT_R8,   SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RG16,   SHD_FORMAT_RGBA16F,
                                        SHD_FORMAT_R32F, SHD_FORMAT_RGBA8,      SHD_FORMAT_RGBA32F};

/// Columns of lookups with three coordinates.
struct SolidBatch : Batch {
  float w[kMaxPoints], dwdx[kMaxPoints], dwdy[kMaxPoints];

  Lookups places(bool derivatives, bool with_lod) const {
    Lookups all = lookups(derivatives, with_lod);
    all.w = w;
    all.dwdx = derivatives ? dwdx : nullptr;
    all.dwdy = derivatives ? dwdy : nullptr;
    return all;
  }
};
inline void make_places(SolidBatch* batch) {
  Random random{777};
  make_points(batch);
  for (size_t i = 0; i < kPoints; ++i) {
    const size_t other = (i * 37 + 11) % kPoints;
    const float scale = ldexpf(1, static_cast<int>(random.next() >> 29) - 7);
    batch->w[i] = i % 3 == 0 ? batch->v[other] : random.real(-2, 3);
    batch->dwdx[i] = i < 64 ? 0 : scale * random.real(-1, 1);
    batch->dwdy[i] = i < 64 ? 0 : scale * random.real(-1, 1);
  }
}

inline shd_texture_desc solid_desc(shd_format format, const SolidSize& size, const uint8_t* texels) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = size.width;
  desc.height = size.height;
  desc.depth = size.depth;
  desc.texels = texels;
  desc.tables = SHD_TABLE_MIPMAP;
  return desc;
}
inline Texture* build_solid(const shd_texture_desc& desc) {
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  return texture;
}
inline uint8_t* solid_texels(shd_format format, const SolidSize& size, uint32_t seed) {
  const size_t count = size_t{size.width} * size.height * size.depth;
  auto* texels = static_cast<uint8_t*>(malloc(count * 16 + SHD_TEXTURE_PADDING));
  random_texels(format, count, seed, texels);
  return texels;
}
inline Texture* random_solid(shd_format format, const SolidSize& size) {
  uint8_t* texels = solid_texels(format, size, size.width * 31 + size.depth);
  Texture* texture = build_solid(solid_desc(format, size, texels));
  free(texels);
  return texture;
}

inline ref::Solid oracle_solid(const Texture& texture, const shd_sampler_desc& sampler, ref::SolidLevel* levels) {
  using shd::texture::level_size;
  for (uint32_t l = 0; l < texture.level_count; ++l) {
    levels[l] = {shd::texture::row_of(texture, 0, l, 0), level_size(texture.width, l), level_size(texture.height, l),
                 level_size(texture.depth, l)};
  }
  return {texture.format, levels, static_cast<int>(texture.level_count), &sampler};
}

/// A filter with one of 25 triples of wraps, in which every pair of wraps of two axes occurs.
inline shd_sampler_desc solid_sampler(shd_filter filter, uint32_t triple) {
  const float border[] = {0.25f, -1.5f, 2.0f, 0.75f};
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter;
  desc.profile = SHD_PROFILE_EXACT;
  desc.wrap_u = static_cast<shd_wrap>(triple % 5);
  desc.wrap_v = static_cast<shd_wrap>(triple / 5 % 5);
  desc.wrap_w = static_cast<shd_wrap>((triple + triple / 5) % 5);
  desc.max_anisotropy = triple % 2 ? 16.0f : 3.5f;
  desc.cubic = static_cast<shd_cubic>(triple % 3);
  desc.probe_weights = triple % 3 ? SHD_PROBE_WEIGHTS_EQUAL : SHD_PROBE_WEIGHTS_GAUSSIAN;
  memcpy(desc.border, border, sizeof border);
  return desc;
}

inline ref::Place place_of(const SolidBatch& batch, size_t i) {
  return {static_cast<double>(batch.u[i]), static_cast<double>(batch.v[i]), static_cast<double>(batch.w[i])};
}
inline ref::Spread spread_at(const SolidBatch& batch, const SolidSize& size, size_t i) {
  const auto texels = [](float value, uint32_t n) { return static_cast<double>(value) * n; };
  return ref::spread_of(
      {texels(batch.dudx[i], size.width), texels(batch.dvdx[i], size.height), texels(batch.dwdx[i], size.depth)},
      {texels(batch.dudy[i], size.width), texels(batch.dvdy[i], size.height), texels(batch.dwdy[i], size.depth)});
}

}  // namespace fixture
