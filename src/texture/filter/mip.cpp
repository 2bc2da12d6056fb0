// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/mip.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/filters-inl.h"
#include "texture/filter/mip-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
size_t RunNearestMip(const FilterCall& call) {
  return Run<NearestMip>(call);
}
size_t RunBilinearMip(const FilterCall& call) {
  return Run<BilinearMip>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
