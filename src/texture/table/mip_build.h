// SPDX-License-Identifier: MIT
#pragma once

#include <shd/image.h>
#include <shd/mip.h>

#include "core/context.h"

namespace shd::texture {

/// Computes `level` from `source`, which is the base or the previous level. Both images have the same format and their
/// row strides set. If `lengths` is set, the fourth channel of a source of normals holds the lengths of averaged
/// normals. If `alpha` is not null, it receives the unrounded alpha values [height][width], 1 = opaque. Throws
/// std::bad_alloc.
void filter_level(const core::Context& context, const shd_image& source, const shd_mip_desc& desc, bool lengths,
                  const shd_image& level, float* alpha);

/// Returns the number of texels with alpha >= cutoff in an image of four channels.
uint64_t count_covered(const core::Context& context, const shd_image& image, double cutoff);

/// Scales `alpha` [height][width] so that about `wanted` texels reach the cutoff, and stores it in `level`.
void store_covered(const core::Context& context, const float* alpha, double cutoff, uint64_t wanted,
                   const shd_image& level);

/// Builds the levels 1..count of shd_mip_build, whose arguments are checked. `read_level(l)` returns level l.
template <class ReadLevel>
void build_levels(const core::Context& context, const shd_image& base, const shd_mip_desc& desc, uint32_t count,
                  ReadLevel&& read_level) {
  const bool covered = desc.content == SHD_TEXEL_CONTENT_ALPHA_COVERAGE && desc.alpha_cutoff > 0;
  const double cutoff = static_cast<double>(desc.alpha_cutoff);
  const uint64_t texels = uint64_t{base.width} * base.height;
  const uint64_t base_count = covered ? count_covered(context, base, cutoff) : 0;
  shd_image source = base;
  for (uint32_t l = 1; l <= count; ++l) {
    const shd_image level = read_level(l);
    const size_t size = size_t{level.width} * level.height;
    core::Array<float> alpha;
    if (covered) alpha = core::Array<float>(context.allocator, size);
    const bool previous = desc.source == SHD_MIP_SOURCE_PREVIOUS;
    filter_level(context, source, desc, previous && l > 1, level, alpha.data());
    if (covered) store_covered(context, alpha.data(), cutoff, (base_count * size + texels / 2) / texels, level);
    if (previous) source = level;
  }
}

}  // namespace shd::texture
