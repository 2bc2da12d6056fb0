// SPDX-License-Identifier: MIT
#include "shade/modulation.h"

#include <cstring>

#include "light/projector.h"
#include "texture/lookup/sample.h"
#include "texture/texture.h"

namespace shd::shade {

void keep_shadow_normals(const raster::Fragments& points, Columns* columns) {
  const float* const normal[3] = {points.nx, points.ny, points.nz};
  for (int c = 0; c < 3; ++c) std::memcpy(columns->shadow_normal[c], normal[c], points.count * sizeof(float));
}

ActiveLight modulate(const core::SimdTarget& simd, const light::Light& light, const light::Shadow* shadow,
                     const raster::Fragments& points, size_t k, Columns* columns) {
  float* const* factor = columns->factor[k];
  float* const visibility = light.cookie ? columns->visibility : factor[0];
  if (shadow) {
    const float* const* normal = columns->shadow_normal;
    light::sample_shadow(simd, *shadow,
                         {points.count, {points.px, points.py, points.pz}, {normal[0], normal[1], normal[2]}},
                         visibility);
  }
  if (!light.cookie) return {&light, {visibility, visibility, visibility}};
  const float* const position[3] = {points.px, points.py, points.pz};
  light::project(simd, light, points.count, position, columns->uv[0], columns->uv[1]);
  texture::Lookups lookups = {};
  lookups.count = points.count;
  lookups.u = columns->uv[0];
  lookups.v = columns->uv[1];
  texture::Texels texels = {};
  for (int c = 0; c < 3; ++c) texels.channel[c] = factor[c];
  texture::sample(*light.cookie, *light.cookie_sampler, simd, lookups, texels);
  for (int c = 0; c < 3 && shadow; ++c) {
    for (size_t i = 0; i < points.count; ++i) factor[c][i] *= visibility[i];
  }
  return {&light, {factor[0], factor[1], factor[2]}};
}

}  // namespace shd::shade
