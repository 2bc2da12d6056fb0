// SPDX-License-Identifier: MIT
#include "film/aovs.h"

#include <algorithm>
#include <type_traits>

#include "material/slot_lookup.h"
#include "raster/interpolate.h"
#include "texture/domain/profile.h"

namespace shd::film {
namespace {

/// Level of detail and level of the diffuse texture, as shd_texture_query_levels reports them; 0 without a texture.
void find_levels(const core::SimdTarget& simd, const AovDraw& draw, const raster::Fragments& f,
                 float* const* scratch_uv, AovScratch* scratch) {
  const material::Material& material = draw.material;
  material::find_levels(simd, material, f, draw.object_to_world, scratch_uv, scratch->lod);
  std::fill_n(scratch->level, f.count, 0u);
  if (!material::has_slot(material, SHD_SLOT_DIFFUSE) || !material.slot[SHD_SLOT_DIFFUSE].texture) return;
  const texture::Sampler& sampler = *material.slot[SHD_SLOT_DIFFUSE].sampler;
  for (size_t i = 0; i < f.count; ++i) scratch->level[i] = texture::nearest_level(sampler, scratch->lod[i]);
}

/// Position of a tile's pixel in a plane.
size_t plane_index(const TileArea& area, const Framebuffer& framebuffer, uint32_t pixel) {
  return (area.top + size_t{pixel / raster::kTile}) * framebuffer.stride + area.left + pixel % raster::kTile;
}

}  // namespace

uint32_t columns_of(uint32_t aovs) {
  uint32_t columns = 0;
  if (aovs & (SHD_AOV_UV | SHD_AOV_DERIVATIVES | SHD_AOV_LEVEL)) columns |= raster::kTexture;
  if (aovs & SHD_AOV_NORMAL) columns |= raster::kNormal;
  if (aovs & SHD_AOV_POSITION) columns |= raster::kPosition;
  if (aovs & SHD_AOV_BARYCENTRICS) columns |= raster::kBarycentrics;
  return columns;
}

void find_rows(const raster::Fragments& f, AovScratch* scratch) {
  scratch->row_count = 0;
  for (size_t i = 0; i < f.count; ++i) {
    if (f.mask[i] & 1) scratch->row[scratch->row_count++] = static_cast<uint16_t>(i);
  }
}

void write_aovs(const core::SimdTarget& simd, const TileArea& area, const AovDraw& draw, const raster::Fragments& f,
                float* const* scratch_uv, AovScratch* scratch, Framebuffer* framebuffer) {
  if (!scratch->row_count) return;
  if (framebuffer->aovs & SHD_AOV_LEVEL) find_levels(simd, draw, f, scratch_uv, scratch);
  if (framebuffer->aovs & SHD_AOV_DRAW) std::fill_n(scratch->draw, f.count, draw.index);
  const AovColumns columns = {f, scratch->lod, scratch->level, scratch->draw};
  for (uint32_t p = 0; p < kPlaneCount; ++p) {
    const PlaneInfo& info = kPlanes[p];
    if (!info.column || !wants_plane(framebuffer->aovs, p)) continue;
    const void* column = info.column(columns);
    const auto scatter = [&](auto* plane) {
      const auto* from = static_cast<const std::remove_pointer_t<decltype(plane)>*>(column);
      for (size_t i = 0; i < scratch->row_count; ++i) {
        const uint32_t row = scratch->row[i];
        plane[plane_index(area, *framebuffer, f.pixel[row])] = from[row];
      }
    };
    info.is_integer ? scatter(framebuffer->u32_plane[p].data()) : scatter(framebuffer->plane[p].data());
  }
}

void count_overdraw(const TileArea& area, uint32_t pixel, Framebuffer* framebuffer) {
  ++framebuffer->u32_plane[SHD_PLANE_OVERDRAW][plane_index(area, *framebuffer, pixel)];
}

}  // namespace shd::film
