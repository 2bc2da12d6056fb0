// SPDX-License-Identifier: MIT
#pragma once

#include "texture/texture.h"

namespace shd::texture {

struct Recording;

/// Filters any number of lookups on the calling thread. The texture must have the tables that the filter reads. If
/// `recording` is not null, lookups are recorded there instead of written to the columns; the filter must have
/// explanations (support.h) and the sampler no magnification. Returns the number of lookups with a coordinate,
/// derivative or level of detail that is not finite.
///
/// Error bounds against exact arithmetic on the same floats, for texels and borders of magnitude up to m (1 for unorm)
/// and a base level of w x h texels. In 3D textures of d slices the bounds have w + h + d in place of w + h, and the
/// bound of bicubic is m (6e-6 + 8e-6 (w + h + d)):
///   nearest    the texel lies within 4e-7 w and 4e-7 h texels of the point; relative error of its value 1.2e-7
///   bilinear   m (3e-7 + 8e-7 (w + h)); m 3e-7 where u w - 1/2 and v h - 1/2 are floats
///   hermite    m (1e-6 + 12e-7 (w + h)): the largest slope of a weight is 3/2; m 1e-6 where that of bilinear is m 3e-7
///   trilinear  bound of bilinear, plus m 4e-6 for the level of detail
///   bicubic    m (3e-6 + 4e-6 (w + h)): slopes and lobes of the kernels are at most 5 times those of bilinear
///   mip        bound of nearest or bilinear on the level ceil(lod + 1/2) - 1, for a lod within 2e-6
///   nearest, two levels  bound of nearest on both levels, plus m 4e-6 for the level of detail
///   ripmap     bound of bilinear, plus m 8e-6 for the levels of detail
///   summed-area m (5e-7 + 2e-6 (w + h)) for the positions of the edges, each divided by the length of its side in
///              texels; if sums are doubles, plus m 2^-50 w h / (area of the box in texels) (summed_area.h)
///   anisotropic bound of trilinear, plus m 4e-6 max_anisotropy for the positions and the level of the probes
///   ewa        m (3e-6 + 4e-6 (w + h) + 4e-6 max_anisotropy); a level of detail within 2e-6 of a whole number may
///              use either level
///   stochastic one texel, whose probability is its weight within 2e-6 + 8e-7 (w + h), or within the bound of EWA for
///              m = 1 if the filter is EWA; a texel of weight 0 is never chosen
///   ewa 3D     m (3e-5 + 4e-6 (w + h + d) + 4e-6 max_anisotropy), otherwise as ewa
///   exact      m 1e-6 if cell_bound() (parallelogram.h) of the footprint on level 0 is at most 16 / tolerance^2
///              (clamped to 2^10..2^24 cells); otherwise the integral of the finest level within this limit, or of a
///              footprint shortened to the limit on the coarsest level
///
/// Anisotropic: a >= b are the half axes of the footprint in base texels (footprint-inl.h), r = min(a / b,
/// max_anisotropy). The result is the average of N = ceil(r 2^(l - m) - probe_slack) trilinear lookups on the level m.
/// l is log2(a / r) + bias, clamped; SHD_PROFILE_LEAST_ERROR has log2(sqrt(((a / r)^2 + b^2) / 2)) - 1/8 - 1/(4 r) in
/// place of log2(a / r). m is l with the fraction of level_blend: l itself by default. Probe k = 0..N - 1 lies at the
/// point + t a (unit vector of the longer axis), t = (2 k + 1 - N) / (2 N). Gaussian weights are exp(-2 x^2), x = 2 t.
/// The probes are averaged on each of the two levels; the two averages are then blended. N = r = 1: bits of trilinear.
///
/// EWA: the level is l = floor(log2(a / r) + bias), clamped. In its texels, a' = a 2^(bias - l) and b' = a' / r; if the
/// clamp raised l, b' = 1 and a' >= 1. The ellipse has the half axes sqrt(0.84^2 a'^2 + c) and sqrt(0.84^2 b'^2 + c)
/// along and across the longer axis, c = 1 - 0.6127 (1 - 4^-l). The result is the sum of w t divided by the sum of w
/// over the texels t at a distance r < 1 in the norm of the ellipse, w = exp(-2 r^2) - exp(-2). It is blended with
/// bilinear on l by 2 - clamp(a 2^(bias - lod_min), 1, 2). The area of the ellipse is below 10.4 max_anisotropy + 8;
/// with one more row along its edge it holds at most 16 (max_anisotropy + 1) texels, and at least two.
///
/// 3D textures: the axes a and b are those of the ellipse that the two derivatives span in space (places-inl.h).
/// BICUBIC is the product of the cubic on three axes. The ellipse of EWA becomes an ellipsoid with one more half axis
/// normal to its plane: 1, and 1 + (1 - (64 b / a)^2) (bb - 1) in its square if 64 b < a, where bb is the square of the
/// half axis across; a level of detail has a ball. An ellipsoid holds at most 64 (max_anisotropy + 1) texels: its
/// volume, widened by half the diagonal of a texel, is below 63 max_anisotropy + 54 (Steiner's formula). It is blended
/// with linear. STOCHASTIC picks a texel of these filters, or with SHD_STOCHASTIC_QUAD both quads of a level. EXACT is
/// the average over the parallelogram in space, or over the box of 2^lod base texels.
///
/// Directions: EXACT averages BILINEAR over the points of the image whose directions lie in the footprint, which is the
/// parallelogram on the plane of the face or on the map. Its position and its sides are doubles (docs/filter-exact.md).
///
/// SHD_PRECISION_FAST: the bound of the filter plus 2^-11 (format/fixed-inl.h). Anisotropic has the lines of
/// fast_lines(), whose places are sums of rounded steps: plus 2^-22 (w + h) for footprints of up to 4 textures.
///
/// Profiles (profile.h): levels of detail and positions of probes are within 4e-6 of the profile's, 3e-6 max_anisotropy
/// for anisotropic. Weights and fractions that a profile rounds to 8 bits are rounded to nearest.
size_t sample(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
              const Texels& out, Recording* recording = nullptr);

/// Whether sample() can write pixels to Texels::rgba8: values of three stored channels in 0..1, by a linear filter.
bool writes_rgba8(const Texture& texture, const Sampler& sampler);

}  // namespace shd::texture
