// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/mip.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/mip-inl.h"
#include "texture/filter/nearest-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

struct NearestMip : OnMipLevels {
  using OnMipLevels::OnMipLevels;

  /// Never prefetches: for one texel per lookup, prefetches cost more than they save.
  static bool is_scattered(const Texture&, const PointBlock&) { return false; }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, Sink& sink) const {
    emit_nearest(d, sampler, NearestLevel(d, texture, block, i), block, i, sink);
  }
};

}  // namespace

size_t RunNearestMip(const FilterCall& call) {
  return Run<NearestMip>(call);
}
size_t RunBilinearMip(const FilterCall& call) {
  return Run<BilinearMip>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
