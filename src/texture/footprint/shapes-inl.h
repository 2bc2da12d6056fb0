// SPDX-License-Identifier: MIT
// The kernels that fill blocks, one for each shape. Each is compiled once per target and shared by all filters. Each
// returns the number of lookups with an input that is not finite.

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

size_t FindPoints(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* out);

/// Finds the levels of detail of the longer axis, clamped to a range, according to the sampler's profile.
size_t FindLods(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                const Lookups& in, LodBlock* out);

/// Finds probes along the longer axis, on the level of the shorter axis, according to the sampler's profile.
size_t FindProbes(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                  const Lookups& in, ProbeBlock* out);

size_t FindEllipses(const Texture& texture, const Sampler& sampler, const Lookups& in, EllipseBlock* out);

/// Implement FindLods() and FindProbes() for the profiles other than SHD_PROFILE_EXACT.
size_t FindProfiledLods(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                        const Lookups& in, LodBlock* out);
size_t FindProfiledProbes(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                          const Lookups& in, ProbeBlock* out);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_SHAPES_INL_H_
