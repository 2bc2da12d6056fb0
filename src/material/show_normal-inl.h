// SPDX-License-Identifier: MIT
// Debug view of the shading normal.

#if defined(SHD_MATERIAL_SHOW_NORMAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_SHOW_NORMAL_INL_H_
#undef SHD_MATERIAL_SHOW_NORMAL_INL_H_
#else
#define SHD_MATERIAL_SHOW_NORMAL_INL_H_
#endif

#include "material/debug_view-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// (n + 1) / 2.
struct ShowNormal : DebugView {
  static constexpr uint32_t kSlots = kColorSlots | kNormalSlots;
  static constexpr bool kHasNormal = true;

  static void Show(const ShowInputs& in, float* const out[3]) {
    const float* const n[3] = {in.fragments.nx, in.fragments.ny, in.fragments.nz};
    for (int c = 0; c < 3; ++c) {
      for (size_t i = 0; i < in.fragments.count; ++i) out[c][i] = 0.5f + 0.5f * n[c][i];
    }
  }
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_SHOW_NORMAL_INL_H_
