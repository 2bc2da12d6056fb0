// SPDX-License-Identifier: MIT
/// @file
/// Rules of peers, after their sources, in doubles.
#pragma once

#include "verdicts.h"

namespace shootout {

/// Levels of detail of OpenImageIO 2.4 without anisotropy: texturesys.cpp, texture_lookup_trilinear_mipmap() and
/// compute_miplevels(). `one_level`: the mode that reads one level.
std::vector<float> openimageio_levels(const Texture& texture, const Lookups& q, bool one_level);

/// Levels of detail of llvmpipe: lp_bld_sample.c, lp_build_rho(), and lp_bld_arit.c, lp_build_fast_log2().
std::vector<float> llvmpipe_levels(const Texture& texture, const Lookups& q);

/// Anisotropic values of llvmpipe: lp_bld_sample_soa.c, lp_build_sample_aniso(). `texel_before`: texels are addressed
/// by rounded numbers, as there.
std::vector<float> llvmpipe_ellipses(const Texture& texture, const Lookups& q, bool texel_before);

}  // namespace shootout
