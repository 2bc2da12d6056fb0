// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/directions.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/anisotropic-inl.h"
#include "texture/filter/bilinear-inl.h"
#include "texture/filter/directions-inl.h"
#include "texture/filter/directions_cubic-inl.h"
#include "texture/filter/mip-inl.h"
#include "texture/filter/nearest-inl.h"
#include "texture/filter/nearest_mip_linear-inl.h"
#include "texture/filter/run_directions-inl.h"
#include "texture/filter/trilinear-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

RunFilter DirectionFilterOf(shd_filter filter) {
  switch (filter) {
    case SHD_FILTER_NEAREST: return RunDirections<Nearest>;
    case SHD_FILTER_BILINEAR:
    case SHD_FILTER_HERMITE: return RunDirections<Bilinear>;
    case SHD_FILTER_BICUBIC: return RunDirections<CubicDirections>;
    case SHD_FILTER_NEAREST_MIP: return RunDirections<NearestMip>;
    case SHD_FILTER_BILINEAR_MIP: return RunDirections<BilinearMip>;
    case SHD_FILTER_TRILINEAR: return RunDirections<Trilinear>;
    case SHD_FILTER_ANISOTROPIC: return RunDirections<Anisotropic>;
    case SHD_FILTER_NEAREST_MIP_LINEAR: return RunDirections<NearestMipLinear>;
    case SHD_FILTER_EWA: return RunEwaDirections;
    case SHD_FILTER_STOCHASTIC: return RunStochasticDirections;
    case SHD_FILTER_EXACT: return RunExactDirections;
    default: return nullptr;
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
