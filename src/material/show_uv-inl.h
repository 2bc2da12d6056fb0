// SPDX-License-Identifier: MIT
// Debug view of the texture coordinates.

#if defined(SHD_MATERIAL_SHOW_UV_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_SHOW_UV_INL_H_
#undef SHD_MATERIAL_SHOW_UV_INL_H_
#else
#define SHD_MATERIAL_SHOW_UV_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "material/debug_view-inl.h"
#include "raster/interpolate.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// (u - floor(u), v - floor(v), 0).
struct ShowUv : DebugView {
  static constexpr uint32_t kShownColumns = raster::kTexture;

  static void Show(const ShowInputs& in, float* const out[3]) {
    const float* const uv[2] = {in.fragments.u, in.fragments.v};
    for (int c = 0; c < 2; ++c) {
      for (size_t i = 0; i < in.fragments.count; ++i) out[c][i] = uv[c][i] - std::floor(uv[c][i]);
    }
    std::fill_n(out[2], in.fragments.count, 0.0f);
  }
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_SHOW_UV_INL_H_
