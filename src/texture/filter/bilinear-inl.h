// SPDX-License-Identifier: MIT

#if defined(SHD_TEXTURE_BILINEAR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_BILINEAR_INL_H_
#undef SHD_TEXTURE_BILINEAR_INL_H_
#else
#define SHD_TEXTURE_BILINEAR_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/filter/rows-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Bilinear : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PointBlock& block, size_t i, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
    sink.quad(d, kStart, level(d, block, i), u, v);
    sink.finish();
  }

  /// Finds the levels that lookups share, for rows.
  static bool share_levels(const Texture&, const RowBlock&, RowLevels* out) {
    *out = {0, 0, false};
    return true;
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_BILINEAR_INL_H_
