// SPDX-License-Identifier: MIT
#if defined(SHD_TEXTURE_FUSED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FUSED_INL_H_
#undef SHD_TEXTURE_FUSED_INL_H_
#else
#define SHD_TEXTURE_FUSED_INL_H_
#endif

#include <hwy/highway.h>

#include "image/format.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Returns a filter and a format compiled together, for values of samplers without border colour. Returns null if the
/// pair is not compiled together.
RunFilter FusedOf(shd_filter filter, image::Component component);

/// Filters 1 to core::kNarrowLanes lookups, as a RunFilter does.
using RunFew = size_t (*)(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out);

/// Returns such a pair for few lookups of textures in memory, without gradients, or null.
RunFew FewOf(const Texture& texture, shd_filter filter);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FUSED_INL_H_
