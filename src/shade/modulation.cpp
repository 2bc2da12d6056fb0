// SPDX-License-Identifier: MIT
#include "shade/modulation.h"

#include "light/projector.h"
#include "texture/texture.h"

namespace shd::shade {

ActiveLight modulate(const core::SimdTarget& simd, const light::Light& light, const raster::Fragments& rows, size_t k,
                     Columns* columns) {
  float* const* factor = columns->factor[k];
  const float* const position[3] = {rows.px, rows.py, rows.pz};
  light::project(simd, light, rows.count, position, columns->uv[0], columns->uv[1]);
  const texture::Lookups lookups = {rows.count, columns->uv[0], columns->uv[1], nullptr, nullptr,
                                    nullptr,    nullptr,        nullptr,        nullptr, nullptr};
  texture::sample(*light.texture, *light.sampler, simd, lookups, {{factor[0], factor[1], factor[2], nullptr}, {}, {}});
  return {&light, {factor[0], factor[1], factor[2]}};
}

}  // namespace shd::shade
