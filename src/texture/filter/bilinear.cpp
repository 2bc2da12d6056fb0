// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/bilinear.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/filters-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

struct Bilinear : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PointBlock& block, size_t i, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
    sink.quad(d, kStart, QuadAt(d, sampler, level(d, block, i), u, v));
    sink.finish();
  }
};

}  // namespace

size_t RunBilinear(const FilterCall& call) {
  return Run<Bilinear>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
