// SPDX-License-Identifier: MIT
// A block whose lookups all take the same filter is filtered in place. Otherwise the lookups of each filter are
// gathered and filtered, and the results are scattered.
#include "texture/lookup/magnify.h"

#include "texture/domain/lod.h"
#include "texture/domain/profile.h"
#include "texture/lookup/gathered.h"
#include "texture/lookup/sample.h"

namespace shd::texture {
namespace {

/// Returns the sampler's range of levels of detail, not limited to the levels of the texture.
LodRange free_range(const Sampler& sampler) {
  return {sampler.lod_min, sampler.lod_max};
}

/// Returns whether a sampler's filter, or the filter that it estimates, reads the levels of isotropic lookups.
bool is_isotropic(const Sampler& sampler) {
  return reads_isotropic_levels(sampler.filter == SHD_FILTER_STOCHASTIC ? sampler.stochastic_filter : sampler.filter);
}

/// Finds the levels of detail that decide between magnification and minification: those of the filter if it is
/// isotropic, those of the probes if the profile of another texture unit places them, or those of the longer axis.
/// Returns the number of lookups that were not finite.
size_t deciding_lod(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& in,
                    float* out) {
  const bool by_probes = sampler.filter == SHD_FILTER_ANISOTROPIC && is_profiled(sampler);
  Sampler rule = sampler;
  if (sampler.profile == SHD_PROFILE_LEAST_ERROR && !is_isotropic(sampler)) rule.profile = SHD_PROFILE_EXACT;
  return find_lods(texture, rule, free_range(sampler), by_probes ? LodAxis::kProbes : LodAxis::kLonger, simd, in, out);
}

void sample_rows(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& in,
                 const uint16_t* rows, size_t count, const Texels& out) {
  if (count == 0) return;
  if (count == in.count) {
    sample(texture, sampler, simd, in, out);
    return;
  }
  Gathered gathered;
  const Lookups some = gathered.load(in, rows, count);
  sample(texture, sampler, simd, some, gathered.wanted(out));
  gathered.scatter(rows, count, out);
}

}  // namespace

Sampler magnifier(const Sampler& sampler) {
  const Sampler plain = minifier(sampler);
  switch (sampler.magnification) {
    case SHD_MAGNIFICATION_NEAREST: return with_filter(plain, SHD_FILTER_NEAREST);
    case SHD_MAGNIFICATION_BILINEAR: return with_filter(plain, SHD_FILTER_BILINEAR);
    case SHD_MAGNIFICATION_BICUBIC: return with_filter(plain, SHD_FILTER_BICUBIC);
    case SHD_MAGNIFICATION_HERMITE: return with_filter(plain, SHD_FILTER_HERMITE);
    default: return plain;
  }
}

Sampler minifier(const Sampler& sampler) {
  Sampler minifier = sampler;
  minifier.magnification = SHD_MAGNIFICATION_DEFAULT;
  return minifier;
}

size_t sample_magnified(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                        const Lookups& lookups, const Texels& out) {
  const Sampler near = magnifier(sampler), far = minifier(sampler);
  size_t nonfinite = 0;
  for (size_t first = 0; first < lookups.count; first += kPart) {
    const size_t count = lookups.count - first < kPart ? lookups.count - first : kPart;
    const Lookups block = part_of(lookups, first, count);
    float lod[kPart];
    nonfinite += deciding_lod(texture, sampler, simd, block, lod);
    uint16_t near_rows[kPart], far_rows[kPart];
    size_t near_count = 0, far_count = 0;
    for (size_t i = 0; i < count; ++i) {
      if (lod[i] <= 0.0f) {
        near_rows[near_count++] = static_cast<uint16_t>(i);
      } else {
        far_rows[far_count++] = static_cast<uint16_t>(i);
      }
    }
    sample_rows(texture, near, simd, block, near_rows, near_count, part_of(out, first));
    sample_rows(texture, far, simd, block, far_rows, far_count, part_of(out, first));
  }
  return nonfinite;
}

Sampler sampler_of(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                   const Lookups& lookup) {
  if (sampler.magnification == SHD_MAGNIFICATION_DEFAULT) return sampler;
  float lod[1];
  deciding_lod(texture, sampler, simd, lookup, lod);
  return lod[0] <= 0.0f ? magnifier(sampler) : minifier(sampler);
}

}  // namespace shd::texture
