// SPDX-License-Identifier: MIT
// Debug view of the level of detail.

#if defined(SHD_MATERIAL_SHOW_LEVEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_SHOW_LEVEL_INL_H_
#undef SHD_MATERIAL_SHOW_LEVEL_INL_H_
#else
#define SHD_MATERIAL_SHOW_LEVEL_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "material/debug_view-inl.h"
#include "material/slot_lookup.h"
#include "raster/interpolate.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The level of detail of the diffuse texture divided by its last level: 0 is blue, 1/2 green, 1 red. Blue without a
/// texture.
struct ShowLevel : DebugView {
  static constexpr uint32_t kShownColumns = raster::kTexture;

  static void Show(const ShowInputs& in, float* const out[3]) {
    float* const lod = out[0];
    find_levels(in.simd, in.material, in.fragments, in.object_to_world, in.uv, lod);
    const texture::Texture* texture = in.material.slot[SHD_SLOT_DIFFUSE].texture;
    const float last = texture && texture->level_count > 1 ? static_cast<float>(texture->level_count - 1) : 1.0f;
    for (size_t i = 0; i < in.fragments.count; ++i) {
      const float part = std::min(std::max(lod[i] / last, 0.0f), 1.0f);
      out[0][i] = std::max(2.0f * part - 1.0f, 0.0f);
      out[1][i] = 1.0f - std::fabs(2.0f * part - 1.0f);
      out[2][i] = std::max(1.0f - 2.0f * part, 0.0f);
    }
  }
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_SHOW_LEVEL_INL_H_
