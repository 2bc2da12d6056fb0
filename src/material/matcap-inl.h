// SPDX-License-Identifier: MIT
// Material capture: a texture indexed by the normal.

#if defined(SHD_MATERIAL_MATCAP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_MATCAP_INL_H_
#undef SHD_MATERIAL_MATCAP_INL_H_
#else
#define SHD_MATERIAL_MATCAP_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "material/model-inl.h"
#include "texture/lookup/sample.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// k_d times SHD_SLOT_MATCAP at (1/2 + x/2, 1/2 - y/2) of the unit normal in view space, the middle for a
/// normal without a direction; 1 without a texture.
struct Matcap : ModelBase {
  static constexpr uint32_t kSlots = kColorSlots | kNormalSlots | 1u << SHD_SLOT_MATCAP;

  static void Show(const ShowInputs& in, float* const out[3]) {
    const raster::Fragments& f = in.fragments;
    for (int c = 0; c < 3; ++c) std::fill_n(out[c], f.count, 1.0f);
    const Slot& slot = in.material.slot[SHD_SLOT_MATCAP];
    if (!has_slot(in.material, SHD_SLOT_MATCAP)) return;
    const float* m = in.view.world_to_view;
    float *u = in.uv[0], *v = in.uv[1];
    for (size_t i = 0; i < f.count; ++i) {
      const float x = m[0] * f.nx[i] + m[4] * f.ny[i] + m[8] * f.nz[i];
      const float y = m[1] * f.nx[i] + m[5] * f.ny[i] + m[9] * f.nz[i];
      const float z = m[2] * f.nx[i] + m[6] * f.ny[i] + m[10] * f.nz[i];
      const float squared = x * x + y * y + z * z;
      const bool has_direction = squared > 0.0f && squared < 1e30f;
      const float scale = 0.5f / std::sqrt(squared);
      u[i] = has_direction ? 0.5f + x * scale : 0.5f;
      v[i] = has_direction ? 0.5f - y * scale : 0.5f;
    }
    texture::Lookups lookups = {};
    lookups.count = f.count;
    lookups.u = u;
    lookups.v = v;
    texture::Texels texels = {};
    for (int c = 0; c < 3; ++c) texels.channel[c] = out[c];
    texture::sample(*slot.texture, *slot.sampler, in.simd, lookups, texels);
  }

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D, const ChannelAt<D, Slots>& c) {
      return c.Diffuse() * c.Lobe(0);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_MATCAP_INL_H_
