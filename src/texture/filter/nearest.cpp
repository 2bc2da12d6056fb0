// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/nearest.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/filters-inl.h"
#include "texture/filter/nearest-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

struct Nearest : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PointBlock& block, size_t i, Sink& sink) const {
    emit_nearest(d, sampler, level(d, block, i), block, i, sink);
  }
};

}  // namespace

size_t RunNearest(const FilterCall& call) {
  return Run<Nearest>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
