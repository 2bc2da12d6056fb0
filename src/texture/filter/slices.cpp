// SPDX-License-Identifier: MIT
// Filters of 3D textures, except anisotropic.
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/slices.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/filters-inl.h"
#include "texture/filter/slices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

size_t RunNearestInSlices(const FilterCall& call) {
  return Run<NearestInSlices>(call);
}
size_t RunNearestMipInSlices(const FilterCall& call) {
  return Run<NearestMipInSlices>(call);
}
size_t RunLinearInSlices(const FilterCall& call) {
  return Run<LinearInSlices>(call);
}
size_t RunHermiteInSlices(const FilterCall& call) {
  return RunLinearInSlices(call);
}
size_t RunLinearMipInSlices(const FilterCall& call) {
  return Run<LinearMipInSlices>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
