// SPDX-License-Identifier: MIT
#include "texture/domain/probes.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/domain/probes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/domain/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Implements find_probes().
size_t ProbesOfFilter(const Texture& texture, const Sampler& sampler, const Lookups& in, ProbeBlock* out) {
  return FindShapes(texture, sampler, in, out);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(ProbesOfFilter);
}  // namespace

size_t find_probes(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                   ProbeBlock* out) {
  return SHD_DISPATCH(ProbesOfFilter, simd)(texture, sampler, lookups, out);
}

}  // namespace shd::texture
#endif
