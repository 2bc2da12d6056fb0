// SPDX-License-Identifier: MIT
// Constant colour without light.

#if defined(SHD_MATERIAL_UNLIT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_UNLIT_INL_H_
#undef SHD_MATERIAL_UNLIT_INL_H_
#else
#define SHD_MATERIAL_UNLIT_INL_H_
#endif

#include "material/model-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// k_d.
struct Unlit : ModelBase {
  static constexpr uint32_t kSlots = kColorSlots | 1u << SHD_SLOT_HEIGHT;
  static constexpr bool kHasNormal = false;

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D, const ChannelAt<D, Slots>& c) {
      return c.Diffuse();
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_UNLIT_INL_H_
