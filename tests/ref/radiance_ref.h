// SPDX-License-Identifier: MIT
// Radiance of models from their lobes and coefficients, for a single channel, in long double.
#pragma once

#include <cmath>

#include "material/material.h"

namespace shd::ref {

/// Values of slots at a row in one channel; 1 for unset slots.
struct SlotValues {
  long double of[material::kSlotCount];
  long double alpha;  // alpha of the diffuse slot
};

/// A sum and the sum of its terms' magnitudes, which bounds its rounding errors.
struct Sum {
  long double value, magnitude;
  void add(long double term) {
    value += term;
    magnitude += fabsl(term);
  }
};

/// I_a k_a of the model, with occlusion.
inline long double ambient_of(const material::Material& m, const SlotValues& s, long double ambient, int c) {
  const bool own = m.model != SHD_MODEL_COMBINED;
  const long double occlusion = 1 + m.occlusion_strength * (s.of[SHD_SLOT_OCCLUSION] - 1);
  return (own ? m.ambient[c] * s.of[SHD_SLOT_AMBIENT] : 1) * ambient * occlusion;
}

inline Sum metallic_radiance(const material::Material& m, const SlotValues& s, long double ambient,
                             const long double lobe[3], int c) {
  const long double pi = acosl(-1.0L), f = m.dielectric_f0, base = m.diffuse[c] * s.of[SHD_SLOT_DIFFUSE];
  const long double metal = m.metallic * s.of[SHD_SLOT_METALLIC], f0 = f * (1 - metal) + base * metal;
  Sum sum = {};
  sum.add(ambient * (base * (1 - metal) + f0));
  sum.add(base * (1 - metal) * (1 - f) / pi * lobe[0]);
  sum.add(f0 * lobe[1]);
  sum.add(lobe[2]);
  return sum;
}

/// L of a row in channel c, with emission and without opacity.
/// @param lights   number of lights except ambient ones
/// @param ambient  I_a, once or once per light
inline Sum radiance(const material::Material& m, const SlotValues& s, long double lights, long double ambient,
                    const long double lobe[3], int c) {
  const long double pi = acosl(-1.0L), diffuse = m.diffuse[c] * s.of[SHD_SLOT_DIFFUSE];
  const long double specular = m.specular[c] * s.of[SHD_SLOT_SPECULAR], from_all = ambient_of(m, s, ambient, c);
  Sum sum = {};
  switch (static_cast<uint32_t>(m.model)) {
    case SHD_MODEL_UNLIT: sum.add(diffuse); break;
    case SHD_MODEL_MATCAP: sum.add(diffuse * lobe[0]); break;
    case static_cast<uint32_t>(material::key_of(SHD_DEBUG_VIEW_NORMAL)):
    case static_cast<uint32_t>(material::key_of(SHD_DEBUG_VIEW_UV)):
    case static_cast<uint32_t>(material::key_of(SHD_DEBUG_VIEW_LEVEL)):
    case static_cast<uint32_t>(material::key_of(SHD_DEBUG_VIEW_BARYCENTRICS)): sum.add(lobe[0]); break;
    case SHD_MODEL_GOOCH: {
      const long double warmth = lights > 0 ? lobe[0] / lights : 0.5L;
      sum.add(warmth * (m.warm[c] + m.warm_mix * diffuse));
      sum.add(m.cool[c] + m.cool_mix * diffuse);  // two terms, because 1 - warmth cancels near 1
      sum.add(-warmth * (m.cool[c] + m.cool_mix * diffuse));
      break;
    }
    case SHD_MODEL_COMBINED:
      sum.add(diffuse * from_all);
      sum.add(diffuse * lobe[0]);
      sum.add(specular * lobe[1]);
      break;
    case SHD_MODEL_METALLIC_ROUGHNESS: sum = metallic_radiance(m, s, from_all, lobe, c); break;
    default:
      sum.add(from_all);
      sum.add(diffuse * lobe[0] / (m.model == SHD_MODEL_BLINN_PHONG_NORMALIZED ? pi : 1));
      if (m.model != SHD_MODEL_LAMBERT) sum.add(specular * lobe[1]);
  }
  sum.add(m.emission[c] * s.of[SHD_SLOT_EMISSION]);
  return sum;
}

}  // namespace shd::ref
