// SPDX-License-Identifier: MIT
#if defined(SHD_TEXTURE_PROJECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PROJECT_INL_H_
#undef SHD_TEXTURE_PROJECT_INL_H_
#else
#define SHD_TEXTURE_PROJECT_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/domain/direction.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Projects the directions of a block (project.cpp). Returns the number of lookups with an input that is not finite, or
/// without a direction.
size_t ProjectLookups(const Texture& texture, const Lookups& in, ProjectedBlock* out);

/// Finds the derivatives of the points of a block (project.cpp).
void ProjectRates(const Texture& texture, const Lookups& in, DirectionRates* out);

/// Returns the properties of the fold of a projection (project.cpp).
FoldTraits TraitsOf(shd_projection projection);

/// Returns a sampler with the wraps of a projection, without border and without rounded weights (project.cpp).
Sampler SamplerOfDirections(const Texture& texture, const Sampler& sampler);

/// Projects lookup i in doubles (project.cpp).
DirectionPoint ProjectPrecisely(const Texture& texture, const Lookups& in, size_t i);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PROJECT_INL_H_
