// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/bilinear.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/bilinear-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

size_t RunBilinear(const FilterCall& call) {
  return Run<Bilinear>(call);
}
/// Sinks change the weights (Weights::kHermite).
size_t RunHermite(const FilterCall& call) {
  return RunBilinear(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
