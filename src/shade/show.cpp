// SPDX-License-Identifier: MIT
#include "shade/show.h"

#include <algorithm>
#include <cmath>

#include "shade/parameters.h"
#include "texture/footprint/lod.h"

namespace shd::shade {

void show_normals(const raster::Fragments& f, float* const out[3]) {
  const float* const n[3] = {f.nx, f.ny, f.nz};
  for (int c = 0; c < 3; ++c) {
    for (size_t i = 0; i < f.count; ++i) out[c][i] = 0.5f + 0.5f * n[c][i];
  }
}

void show_uv(const raster::Fragments& f, float* const out[3]) {
  const float* const uv[2] = {f.u, f.v};
  for (int c = 0; c < 2; ++c) {
    for (size_t i = 0; i < f.count; ++i) out[c][i] = uv[c][i] - std::floor(uv[c][i]);
  }
  std::fill_n(out[2], f.count, 0.0f);
}

void show_barycentrics(const raster::Fragments& f, float* const out[3]) {
  for (int c = 0; c < 3; ++c) std::copy_n(f.bary[c], f.count, out[c]);
}

void find_levels(const core::SimdTarget& simd, const material::Material& material, const raster::Fragments& f,
                 float* const scratch[6], float* lod) {
  const material::Slot& slot = material.slot[SHD_SLOT_DIFFUSE];
  std::fill_n(lod, f.count, 0.0f);
  if (!material::has_slot(material, SHD_SLOT_DIFFUSE) || !slot.texture) return;
  texture::find_lods(*slot.texture, *slot.sampler, texture::lod_range(*slot.texture, *slot.sampler),
                     texture::LodAxis::kLonger, simd,
                      lookups_of(slot, f, true, scratch), lod);
}

void show_levels(const core::SimdTarget& simd, const material::Material& material, const raster::Fragments& f,
                 Columns* columns) {
  float* lod = columns->variance;
  find_levels(simd, material, f, columns->uv, lod);
  const texture::Texture* texture = material.slot[SHD_SLOT_DIFFUSE].texture;
  const float last = texture && texture->level_count > 1 ? static_cast<float>(texture->level_count - 1) : 1.0f;
  float* const* out = columns->lobes.lobe[0];
  for (size_t i = 0; i < f.count; ++i) {
    const float part = std::min(std::max(lod[i] / last, 0.0f), 1.0f);
    out[0][i] = std::max(2.0f * part - 1.0f, 0.0f);
    out[1][i] = 1.0f - std::fabs(2.0f * part - 1.0f);
    out[2][i] = std::max(1.0f - 2.0f * part, 0.0f);
  }
}

void show_matcap(const core::SimdTarget& simd, const material::Material& material, const shd_view& view,
                 const raster::Fragments& f, Columns* columns) {
  float* const* out = columns->lobes.lobe[0];
  for (int c = 0; c < 3; ++c) std::fill_n(out[c], f.count, 1.0f);
  const material::Slot& slot = material.slot[SHD_SLOT_MATCAP];
  if (!material::has_slot(material, SHD_SLOT_MATCAP)) return;
  const float* m = view.world_to_view;
  float *u = columns->uv[0], *v = columns->uv[1];
  for (size_t i = 0; i < f.count; ++i) {
    const float x = m[0] * f.nx[i] + m[4] * f.ny[i] + m[8] * f.nz[i];
    const float y = m[1] * f.nx[i] + m[5] * f.ny[i] + m[9] * f.nz[i];
    const float z = m[2] * f.nx[i] + m[6] * f.ny[i] + m[10] * f.nz[i];
    const float squared = x * x + y * y + z * z;
    const float scale = squared > 0.0f && squared < 1e30f ? 0.5f / std::sqrt(squared) : 0.0f;
    u[i] = 0.5f + x * scale;
    v[i] = 0.5f - y * scale;
  }
  const texture::Lookups lookups = {f.count, u, v, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr};
  texture::sample(*slot.texture, *slot.sampler, simd, lookups, {{out[0], out[1], out[2], nullptr}, {}, {}});
}

}  // namespace shd::shade
