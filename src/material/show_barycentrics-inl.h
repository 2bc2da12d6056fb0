// SPDX-License-Identifier: MIT
// Debug view of the barycentric coordinates.

#if defined(SHD_MATERIAL_SHOW_BARYCENTRICS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_SHOW_BARYCENTRICS_INL_H_
#undef SHD_MATERIAL_SHOW_BARYCENTRICS_INL_H_
#else
#define SHD_MATERIAL_SHOW_BARYCENTRICS_INL_H_
#endif

#include <algorithm>

#include "material/debug_view-inl.h"
#include "raster/interpolate.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The barycentric coordinates in the triangle.
struct ShowBarycentrics : DebugView {
  static constexpr uint32_t kShownColumns = raster::kBarycentrics;

  static void Show(const ShowInputs& in, float* const out[3]) {
    for (int c = 0; c < 3; ++c) std::copy_n(in.fragments.bary[c], in.fragments.count, out[c]);
  }
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_SHOW_BARYCENTRICS_INL_H_
