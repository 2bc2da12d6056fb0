// SPDX-License-Identifier: MIT
// Rows with slots that read small textures. On the heap: cmocka fails by longjmp.
#pragma once

#include "support/check.h"

#include <algorithm>

#include "core/context.h"
#include "data/data.h"
#include "shade/parameters.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {

using raster::kBatch;

inline core::Context* context() {
  static core::Context* made = core::create_context(shd_context_desc_default());
  return made;
}

struct SlotFixture {
  material::Material material;
  geometry::Vertices vertices;
  raster::Fragments points, before, first;
  raster::Varyings varyings;
  shade::Columns columns, kept;
  texture::Sampler sampler;
};
inline SlotFixture* g;

inline int set_up(void**) {
  g = new SlotFixture;
  for (raster::Fragments* f : {&g->points, &g->before, &g->first}) raster::allocate(context()->allocator, f);
  shade::allocate(context()->allocator, 1, &g->columns);
  shade::allocate(context()->allocator, 1, &g->kept);
  return 0;
}
inline int tear_down(void**) {
  delete g;
  return 0;
}

inline texture::Texture* make_texture(shd_format format, uint32_t width, uint32_t height, const void* texels,
                                      uint32_t tables = SHD_TABLE_NONE) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.texels = texels;
  desc.tables = static_cast<shd_table>(tables);
  auto* made = core::create<texture::Texture>(context()->allocator);
  texture::build(*context(), desc, made);
  return made;
}
inline void free_texture(texture::Texture* texture) {
  core::destroy(context()->allocator, texture);
}

inline void copy_points(const raster::Fragments& from, raster::Fragments* to) {
  to->count = from.count;
  std::copy_n(from.block.data(), from.block.size(), to->block.data());
}

inline shade::DrawShading draw_shading() {
  return {&g->vertices, &g->material, SHD_FREQUENCY_PHONG, 1.0f, 3, 0, 0, nullptr, nullptr};
}

inline texture::Sampler make_sampler(shd_filter filter, shd_wrap wrap) {
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter;
  desc.wrap_u = desc.wrap_v = wrap;
  return texture::make_sampler(desc);
}

}  // namespace shd::tests
