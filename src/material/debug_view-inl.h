// SPDX-License-Identifier: MIT
// Base of the models that show an attribute of fragments.

#if defined(SHD_MATERIAL_DEBUG_VIEW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_DEBUG_VIEW_INL_H_
#undef SHD_MATERIAL_DEBUG_VIEW_INL_H_
#else
#define SHD_MATERIAL_DEBUG_VIEW_INL_H_
#endif

#include "material/model-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The colour is lobe 0, which Show() writes.
struct DebugView : ModelBase {
  static constexpr uint32_t kSlots = kColorSlots | 1u << SHD_SLOT_HEIGHT;
  static constexpr bool kHasNormal = false;

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D, const ChannelAt<D, Slots>& c) {
      return c.Lobe(0);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_DEBUG_VIEW_INL_H_
