// SPDX-License-Identifier: MIT
// Filters of textures of directions.

#if defined(SHD_TEXTURE_DIRECTION_FILTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_DIRECTION_FILTERS_INL_H_
#undef SHD_TEXTURE_DIRECTION_FILTERS_INL_H_
#else
#define SHD_TEXTURE_DIRECTION_FILTERS_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// The run of a filter on directions, or null (directions.cpp).
RunFilter DirectionFilterOf(shd_filter filter);

/// Runs the filter of a call for the derivatives of values in the three components of directions; the call has no
/// values (directions_gradient.cpp).
size_t RunDirectionGradient(const FilterCall& call);

size_t RunEwaDirections(const FilterCall& call);
size_t RunPickedEwaDirections(const FilterCall& call);
size_t RunStochasticDirections(const FilterCall& call);
size_t RunExactDirections(const FilterCall& call);  // exact.cpp

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_DIRECTION_FILTERS_INL_H_
