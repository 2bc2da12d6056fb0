// SPDX-License-Identifier: MIT
#include "shade/modulation.h"

#include <cstring>

#include "light/projector.h"
#include "texture/texture.h"

namespace shd::shade {

void keep_shadow_normals(const raster::Fragments& rows, Columns* columns) {
  const float* const normal[3] = {rows.nx, rows.ny, rows.nz};
  for (int c = 0; c < 3; ++c) std::memcpy(columns->shadow_normal[c], normal[c], rows.count * sizeof(float));
}

ActiveLight modulate(const core::SimdTarget& simd, const light::Light& light, const light::Shadow* shadow,
                     const raster::Fragments& rows, size_t k, Columns* columns) {
  float* const* factor = columns->factor[k];
  float* const visibility = light.texture ? columns->visibility : factor[0];
  if (shadow) {
    const float* const* normal = columns->shadow_normal;
    light::sample_shadow(simd, *shadow, {rows.count, {rows.px, rows.py, rows.pz}, {normal[0], normal[1], normal[2]}},
                         visibility);
  }
  if (!light.texture) return {&light, {visibility, visibility, visibility}};
  const float* const position[3] = {rows.px, rows.py, rows.pz};
  light::project(simd, light, rows.count, position, columns->uv[0], columns->uv[1]);
  const texture::Lookups lookups = {rows.count, columns->uv[0], columns->uv[1], nullptr, nullptr,
                                    nullptr,    nullptr,        nullptr,        nullptr, nullptr};
  texture::sample(*light.texture, *light.sampler, simd, lookups, {{factor[0], factor[1], factor[2], nullptr}, {}, {}});
  for (int c = 0; c < 3 && shadow; ++c) {
    for (size_t i = 0; i < rows.count; ++i) factor[c][i] *= visibility[i];
  }
  return {&light, {factor[0], factor[1], factor[2]}};
}

}  // namespace shd::shade
