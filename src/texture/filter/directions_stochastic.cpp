// SPDX-License-Identifier: MIT
// Stochastic filtering of textures of directions: the picks of filters whose texels beyond edges are folded.
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/directions_stochastic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/anisotropic-inl.h"
#include "texture/filter/bilinear-inl.h"
#include "texture/filter/directions-inl.h"
#include "texture/filter/directions_cubic-inl.h"
#include "texture/filter/pick_sink-inl.h"
#include "texture/filter/run_directions-inl.h"
#include "texture/filter/trilinear-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

size_t RunStochasticDirections(const FilterCall& call) {
  switch (call.sampler.stochastic_filter) {
    case SHD_FILTER_BILINEAR: return RunDirections<Bilinear, PickSink>(call);
    case SHD_FILTER_BICUBIC: return RunDirections<CubicDirections, PickSink>(call);
    case SHD_FILTER_ANISOTROPIC: return RunDirections<Anisotropic, PickSink>(call);
    case SHD_FILTER_EWA: return RunPickedEwaDirections(call);
    default: return RunDirections<Trilinear, PickSink>(call);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
