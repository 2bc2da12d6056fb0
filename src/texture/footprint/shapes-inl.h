// SPDX-License-Identifier: MIT
// What fills blocks of lookups: first where they lie, then the shape of their footprints, one function for each kind of
// block. They are functions of their target, compiled once for all filters.

#if defined(SHD_TEXTURE_SHAPES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_SHAPES_INL_H_
#undef SHD_TEXTURE_SHAPES_INL_H_
#else
#define SHD_TEXTURE_SHAPES_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/footprint/block.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Where lookups lie: every filter finds this first. Returns how many lookups have an input that is not finite.
size_t FindPoints(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* out);

/// Levels of detail of the longer axis, clamped to a range; by the sampler's profile.
void FindLods(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
              const Lookups& in, LodBlock* out);

/// Probes along the longer axis, on the level of the shorter one; by the sampler's profile.
void FindProbes(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                const Lookups& in, ProbeBlock* out);

void FindEllipses(const Texture& texture, const Sampler& sampler, const Lookups& in, EllipseBlock* out);

/// FindLods() and FindProbes() of the profiles that are not SHD_PROFILE_EXACT.
void FindProfiledLods(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                      const Lookups& in, LodBlock* out);
void FindProfiledProbes(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                        const Lookups& in, ProbeBlock* out);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_SHAPES_INL_H_
