// SPDX-License-Identifier: MIT
// Textures of directions for tests: texels from a function of the direction or at random, and lookups of them.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include <shd/shd.h>

#include "ref/projection_ref.h"
#include "support/check.h"
#include "support/context.h"
#include "support/random.h"

namespace shd::tests
{

constexpr shd_projection kProjections[] = {SHD_PROJECTION_LAT_LONG, SHD_PROJECTION_MIRROR_BALL, SHD_PROJECTION_ANGULAR,
                                           SHD_PROJECTION_CUBE, SHD_PROJECTION_OCTAHEDRAL};
constexpr const char *kProjectionNames[] = {"none", "lat_long", "mirror_ball", "angular", "cube", "octahedral"};

inline bool is_disc(shd_projection projection)
{
    return projection == SHD_PROJECTION_MIRROR_BALL || projection == SHD_PROJECTION_ANGULAR;
}

/// A direction, uniform on the sphere.
inline void random_direction(Random *random, double *n)
{
    const double z = random->in(-1.0, 1.0), a = random->in(0.0, 2.0 * M_PI), r = std::sqrt(1.0 - z * z);
    n[0] = r * std::cos(a), n[1] = z, n[2] = r * std::sin(a);
}

/// Texels [face][height][width] of one channel.
struct DirectionImage {
    shd_projection projection;
    uint32_t width, height;
    std::vector<float> texels;

    DirectionImage(shd_projection of, uint32_t w, uint32_t h) : projection(of), width(w), height(h)
    {
        texels.resize(size_t{w} * h * (of == SHD_PROJECTION_CUBE ? 6 : 1));
    }
    /// Values of f at the texel centres. Outside the disc: f of the direction where the image continues.
    void fill(const std::function<double(const double *)> &f)
    {
        for (size_t i = 0; i < texels.size(); ++i) {
            const auto face = static_cast<uint32_t>(i / (size_t{width} * height));
            long double u = (static_cast<long double>(i % width) + 0.5L) / width;
            long double v = (static_cast<long double>(i / width % height) + 0.5L) / height;
            const long double p = 2.0L * u - 1.0L, q = 2.0L * v - 1.0L, r = std::hypot(p, q);
            if (is_disc(projection) && r > 1.0L)
                u = 0.5L - 0.5L * p * (2.0L - r) / r, v = 0.5L - 0.5L * q * (2.0L - r) / r;
            long double n[3];
            ref_unproject(projection, u, v, face, n);
            const double direction[3] = {static_cast<double>(n[0]), static_cast<double>(n[1]),
                                         static_cast<double>(n[2])};
            texels[i] = static_cast<float>(f(direction));
        }
    }
    void fill_noise(uint32_t seed)
    {
        Random random{seed};
        for (float &texel : texels) texel = static_cast<float>(random.unit());
    }
    shd_texture *texture(shd_context *context) const
    {
        shd_texture_desc desc = shd_texture_desc_default();
        desc.format = SHD_FORMAT_R32F;
        desc.width = width, desc.height = height;
        desc.layer_count = projection == SHD_PROJECTION_CUBE ? 6 : 1;
        desc.projection = projection;
        if (projection) desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
        desc.texels = texels.data();
        desc.tables = SHD_TABLE_MIPMAP;
        shd_texture *texture = nullptr;
        shd_assert_ok(shd_texture_create(context, &desc, &texture));
        return texture;
    }
};

/// Columns of lookups of directions, and their results.
struct DirectionLookups {
    std::vector<float> column[9], lod, value;  // n, dn/dx, dn/dy
    std::vector<float> slope[3];               // derivatives of the value in the components of n
    size_t nonfinite = 0;

    size_t count() const { return column[0].size(); }
    void add(const double *n, const double *dx = nullptr, const double *dy = nullptr)
    {
        for (int c = 0; c < 3; ++c) {
            column[c].push_back(static_cast<float>(n[c]));
            column[3 + c].push_back(dx ? static_cast<float>(dx[c]) : 0.0f);
            column[6 + c].push_back(dy ? static_cast<float>(dy[c]) : 0.0f);
        }
    }
    shd_lookups lookups() const
    {
        shd_lookups lookups = shd_lookups_default();
        shd_f32_in *const to[9] = {&lookups.u,    &lookups.v,    &lookups.w,    &lookups.dudx, &lookups.dvdx,
                                   &lookups.dwdx, &lookups.dudy, &lookups.dvdy, &lookups.dwdy};
        lookups.count = count();
        for (int c = 0; c < 9; ++c) *to[c] = shd_f32_column(column[c].data(), 0);
        if (!lod.empty()) lookups.lod = shd_f32_column(lod.data(), 0);
        return lookups;
    }
    /// Values of the first channel.
    const std::vector<float> &sample(const shd_texture *texture, const shd_sampler *sampler)
    {
        const shd_lookups in = lookups();
        shd_texels out = shd_texels_default();
        value.assign(count(), NAN);
        out.channel[0] = shd_f32_out_column(value.data(), 0);
        shd_assert_ok(shd_texture_sample(texture, sampler, &in, &out));
        nonfinite = out.nonfinite_count;
        return value;
    }
    /// Values of the first channel and their derivatives.
    void sample_slopes(const shd_texture *texture, const shd_sampler *sampler)
    {
        const shd_lookups in = lookups();
        shd_texels out = shd_texels_default();
        shd_f32_out *const to[4] = {out.channel, out.du, out.dv, out.dw};
        std::vector<float> *const from[4] = {&value, &slope[0], &slope[1], &slope[2]};
        for (int i = 0; i < 4; ++i) {
            from[i]->assign(count(), NAN);
            to[i][0] = shd_f32_out_column(from[i]->data(), 0);
        }
        shd_assert_ok(shd_texture_sample(texture, sampler, &in, &out));
        nonfinite = out.nonfinite_count;
    }
};

struct DirectionFilter {
    const char *name;
    shd_filter filter;
};
constexpr DirectionFilter kDirectionFilters[] = {
    {"nearest", SHD_FILTER_NEAREST},           {"bilinear", SHD_FILTER_BILINEAR},
    {"nearest_mip", SHD_FILTER_NEAREST_MIP},   {"nearest_mip_linear", SHD_FILTER_NEAREST_MIP_LINEAR},
    {"bilinear_mip", SHD_FILTER_BILINEAR_MIP}, {"trilinear", SHD_FILTER_TRILINEAR},
    {"anisotropic", SHD_FILTER_ANISOTROPIC},   {"ewa", SHD_FILTER_EWA},
    {"hermite", SHD_FILTER_HERMITE},
};

/// Whether values have steps at the edges of texels.
inline bool has_steps(shd_filter filter)
{
    return filter == SHD_FILTER_NEAREST || filter == SHD_FILTER_NEAREST_MIP || filter == SHD_FILTER_NEAREST_MIP_LINEAR;
}

inline shd_sampler *make_sampler(shd_context *context, shd_filter filter)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    return sampler;
}

}  // namespace shd::tests
