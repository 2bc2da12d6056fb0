// SPDX-License-Identifier: MIT
#pragma once

#include "texture/explain/record.h"
#include "texture/texture.h"

namespace shd::texture {

/// The filters behind sample(), for the channels that the format stores. Error bounds against exact arithmetic on the
/// same floats, for texels and borders of magnitude up to m (1 for unorm) and a base level of w x h:
///   nearest    a texel within 4e-7 w and 4e-7 h texels of the point; its value within 1.2e-7, relative
///   bilinear   m (3e-7 + 8e-7 (w + h)); m 3e-7 where u w - 1/2 and v h - 1/2 are floats
///   trilinear  that of bilinear, and m 4e-6 for the level of detail
///   bicubic    m (3e-6 + 4e-6 (w + h)): the kernels' slopes and lobes are at most 5 times those of bilinear
///   mip        those of nearest and bilinear on the level ceil(lod + 1/2) - 1, for a lod within 2e-6
///   ripmap     that of bilinear, and m 8e-6 for the levels of detail
///   summed-area m (5e-7 + 2e-6 (w + h)) for the places of the edges, each over the length of its side in texels;
///              where sums are doubles m 2^-50 w h / (area of the box in texels) more (summed_area.h)
///   anisotropic that of trilinear, and m 4e-6 max_anisotropy for the places and the level of the probes
///   ewa        m (3e-6 + 4e-6 (w + h) + 4e-6 max_anisotropy); a level of detail within 2e-6 of a whole one may take
///              either level
///   stochastic one texel, picked with the weights of its filter within 2e-6 + 8e-7 (w + h), of EWA within that filter's
///              bound for m = 1; a texel of weight 0 is never picked
///   exact      m 1e-6 where level 0 serves, i.e. where cell_bound() (parallelogram.h) of the footprint's sides is at
///              most 16 / tolerance^2 (2^10..2^24 cells); else the integral of the finest level that does, or of a
///              footprint shortened to that many cells of the coarsest
///
/// Anisotropic: with the footprint's longer and shorter half axis a >= b in base texels (footprint-inl.h) and
/// r = min(a / b, max_anisotropy), the average of N = ceil(r - 1/8) trilinear lookups on the level log2(a / r) + bias
/// at the point + t a (unit vector of the longer axis), t = (2 k + 1 - N) / (2 N), k = 0..N - 1; Gaussian weights are
/// exp(-2 x^2), x = 2 t. The lookups are averaged on each of the two levels, and then blended between them. N = 1 with
/// r = 1 has the bits of trilinear.
///
/// EWA: on the level l = floor(log2(a / r) + bias), clamped, in its texels: a' = a 2^(bias - l) and b' = a' / r, where
/// the clamp raised l: b' = 1 and a' >= 1. The sum of w t over the sum of w, w = exp(-2 r^2) - exp(-2), over the texels
/// t at a distance of r < 1 in the norm of the ellipse with half axes sqrt(0.84^2 a'^2 + c), sqrt(0.84^2 b'^2 + c)
/// along and across the longer axis, c = 1 - 0.6127 (1 - 4^-l); blended with bilinear on l by 2 - clamp(a 2^(bias -
/// lod_min), 1, 2). With the area of that ellipse below 10.4 max_anisotropy + 8 and a row more along its edge it holds
/// at most 16 (max_anisotropy + 1) texels, and at least two.
///
/// Profiles (profile.h): levels of detail and places of probes within 4e-6 of theirs, 3e-6 max_anisotropy for
/// anisotropic; weights and fractions that they round to 8 bits are rounded to nearest.
///
/// Runs the filter that sampler.filter names, on the calling thread; its magnification does not count. Lookups go to
/// `recording` in place of the columns where that is not null; the filter is_explainable() then. Returns how many of
/// them were not finite.
size_t run_filter(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                  const Texels& out, Recording* recording);

}  // namespace shd::texture
