// SPDX-License-Identifier: MIT
// Contract of filter/: shapes to streams. A filter is a struct that emits quads, rows and single texels of one vector
// of lookups to a sink (emitter-inl.h); Run() and RunDirections() call it for all blocks of a batch. Its file names it,
// and it has one row in each table of a domain: here, and in directions.cpp.
//
// Table of the filters: name, RunFilter, and whether the filter has derivatives (is a continuous tree of blends).

#if defined(SHD_TEXTURE_FILTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FILTERS_INL_H_
#undef SHD_TEXTURE_FILTERS_INL_H_
#else
#define SHD_TEXTURE_FILTERS_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/stream.h"

#ifndef SHD_TEXTURE_FILTERS
#define SHD_TEXTURE_FILTERS(ROW)                                 \
  ROW(SHD_FILTER_NEAREST, RunNearest, false)                     \
  ROW(SHD_FILTER_BILINEAR, RunBilinear, true)                    \
  ROW(SHD_FILTER_BICUBIC, RunBicubic, true)                      \
  ROW(SHD_FILTER_NEAREST_MIP, RunNearestMip, false)              \
  ROW(SHD_FILTER_BILINEAR_MIP, RunBilinearMip, true)             \
  ROW(SHD_FILTER_TRILINEAR, RunTrilinear, true)                  \
  ROW(SHD_FILTER_RIPMAP, RunRipmap, true)                        \
  ROW(SHD_FILTER_SUMMED_AREA, RunSummedArea, false)              \
  ROW(SHD_FILTER_ANISOTROPIC, RunAnisotropic, true)              \
  ROW(SHD_FILTER_EWA, RunEwa, true)                              \
  ROW(SHD_FILTER_STOCHASTIC, RunStochastic, false)               \
  ROW(SHD_FILTER_EXACT, RunExact, false)                         \
  ROW(SHD_FILTER_NEAREST_MIP_LINEAR, RunNearestMipLinear, false) \
  ROW(SHD_FILTER_HERMITE, RunHermite, true)

// The filters of 3D textures.
#define SHD_TEXTURE_SLICE_FILTERS(ROW)                            \
  ROW(SHD_FILTER_NEAREST, RunNearestInSlices)                     \
  ROW(SHD_FILTER_BILINEAR, RunLinearInSlices)                     \
  ROW(SHD_FILTER_BICUBIC, RunTricubicInSlices)                    \
  ROW(SHD_FILTER_NEAREST_MIP, RunNearestMipInSlices)              \
  ROW(SHD_FILTER_BILINEAR_MIP, RunLinearMipInSlices)              \
  ROW(SHD_FILTER_TRILINEAR, RunLinearMipInSlices)                 \
  ROW(SHD_FILTER_ANISOTROPIC, RunAnisotropicInSlices)             \
  ROW(SHD_FILTER_NEAREST_MIP_LINEAR, RunNearestMipLinearInSlices) \
  ROW(SHD_FILTER_EWA, RunEwaInSlices)                             \
  ROW(SHD_FILTER_STOCHASTIC, RunStochasticInSlices)               \
  ROW(SHD_FILTER_EXACT, RunExactInSlices)                         \
  ROW(SHD_FILTER_HERMITE, RunHermiteInSlices)
#endif

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

#define SHD_TEXTURE_DECLARE_FILTER(filter, run, gradient) size_t run(const FilterCall& call);
SHD_TEXTURE_FILTERS(SHD_TEXTURE_DECLARE_FILTER)
#undef SHD_TEXTURE_DECLARE_FILTER
#define SHD_TEXTURE_DECLARE_FILTER(filter, run) size_t run(const FilterCall& call);
SHD_TEXTURE_SLICE_FILTERS(SHD_TEXTURE_DECLARE_FILTER)
#undef SHD_TEXTURE_DECLARE_FILTER

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FILTERS_INL_H_
