// SPDX-License-Identifier: MIT
#include "shade/one_texture.h"

#include "material/slot_lookup.h"
#include "texture/lookup/sample.h"
#include "texture/store/storage.h"

namespace shd::shade {
bool is_one_texture(const material::Material& material) {
  if (material.model != SHD_MODEL_UNLIT || material.slots != 1u << SHD_SLOT_DIFFUSE) return false;
  const material::Slot& slot = material.slot[SHD_SLOT_DIFFUSE];
  if (!slot.texture || material::reads_places(slot) || slot.uv_set != 0 || texture::has_border(*slot.sampler))
    return false;
  for (float emitted : material.emission) {
    if (emitted > 0.0f) return false;
  }
  return image::is_unorm(slot.texture->component) && !slot.texture->premultiplied;
}

bool writes_rgba8(const material::Material& material) {
  const material::Slot& slot = material.slot[SHD_SLOT_DIFFUSE];
  for (const float factor : material.diffuse) {
    if (factor != 1.0f) return false;
  }
  return texture::writes_rgba8(*slot.texture, *slot.sampler);
}

void shade_one_texture(const core::SimdTarget& simd, const DrawShading& shading, const raster::TrianglePixels& pixels,
                       size_t rows, Workspace* workspace, float* const out[3], uint32_t* rgba8) {
  const material::Material& material = *shading.material;
  const material::Slot& slot = material.slot[SHD_SLOT_DIFFUSE];
  raster::Fragments& f = workspace->fragments;
  raster::interpolate_texture(simd, pixels, &f);
  const float* const uv[6] = {f.u, f.v, f.dudx, f.dvdx, f.dudy, f.dvdy};
  texture::Texels texels = {};
  for (int c = 0; c < 3; ++c) texels.channel[c] = out[c];
  texels.rgba8 = rgba8;
  texture::Lookups lookups = material::lookups_of(slot, uv, rows, workspace->columns.uv);
  lookups.finite = !slot.is_transformed;  // a transform may overflow
  lookups.one_footprint = lookups.finite && raster::is_affine(pixels.planes);
  texture::sample(*slot.texture, *slot.sampler, simd, lookups, texels);
  for (int c = 0; c < 3; ++c) {
    for (size_t i = 0; i < rows && material.diffuse[c] != 1.0f; ++i) out[c][i] *= material.diffuse[c];
  }
}

}  // namespace shd::shade
