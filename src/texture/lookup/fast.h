// SPDX-License-Identifier: MIT
#pragma once

#include <shd/sampler.h>

#include "image/format.h"
#include "texture/support.h"
#include "texture/texture.h"

namespace shd::texture {

/// Whether lookups with SHD_PRECISION_FAST have values of their own, which differ from those of SHD_PRECISION_FULL: the
/// table of support.h has the cell, the texels are unorm of 8 bits, no lookup reads the border colour, and probes have
/// equal weights.
/// Rejected: sRGB, with texels decoded to 15 bits by a table. It had 0.5 (AVX-512) to 0.9 (AVX2, SSE4) of the speed of
/// floats, because every texel takes three loads from the table.
inline bool has_fast_values(const Texture& texture, const Sampler& sampler) {
  if (sampler.precision != SHD_PRECISION_FAST || texture.component != image::Component::kUnorm8) return false;
  if (has_border(texture, sampler)) return false;
  if (sampler.filter == SHD_FILTER_ANISOTROPIC && sampler.probe_weights != SHD_PROBE_WEIGHTS_EQUAL) return false;
  return !refusal_of({sampler.filter, domain_of(texture), texture.store, Use::kFast});
}

}  // namespace shd::texture
