/* SPDX-License-Identifier: MIT */
/* Every filter with its settings, and one texture on every SIMD target of this machine, for tests of bad lookups. */
#ifndef SHD_TESTS_SUPPORT_FILTERS_H
#define SHD_TESTS_SUPPORT_FILTERS_H

#include "support/check.h"
#include "support/noise.h"

#include <shd/shd.h>

/** A filter, and the most texels that one of its lookups may read; 0 = no list of texels (shd_texture_explain). */
typedef struct shd_filter_row {
    const char *name;
    shd_filter filter, stochastic_filter;
    uint32_t most_taps;
    float slack; /* overshoot beyond the range of the texels */
} shd_filter_row;

#define SHD_TEST_ANISOTROPY 16
static const shd_filter_row k_filters[] = {
    {"nearest", SHD_FILTER_NEAREST, SHD_FILTER_BILINEAR, 1, 0},
    {"bilinear", SHD_FILTER_BILINEAR, SHD_FILTER_BILINEAR, 4, 0},
    {"bicubic", SHD_FILTER_BICUBIC, SHD_FILTER_BILINEAR, 16, 0.6f},
    {"hermite", SHD_FILTER_HERMITE, SHD_FILTER_BILINEAR, 4, 0},
    {"nearest_mip", SHD_FILTER_NEAREST_MIP, SHD_FILTER_BILINEAR, 1, 0},
    {"nearest_mip_linear", SHD_FILTER_NEAREST_MIP_LINEAR, SHD_FILTER_BILINEAR, 2, 0},
    {"bilinear_mip", SHD_FILTER_BILINEAR_MIP, SHD_FILTER_BILINEAR, 4, 0},
    {"trilinear", SHD_FILTER_TRILINEAR, SHD_FILTER_BILINEAR, 8, 0},
    {"ripmap", SHD_FILTER_RIPMAP, SHD_FILTER_BILINEAR, 16, 0},
    {"summed_area", SHD_FILTER_SUMMED_AREA, SHD_FILTER_BILINEAR, 0, 0},
    {"anisotropic", SHD_FILTER_ANISOTROPIC, SHD_FILTER_BILINEAR, 8 * SHD_TEST_ANISOTROPY, 0},
    {"ewa", SHD_FILTER_EWA, SHD_FILTER_BILINEAR, 16 * (SHD_TEST_ANISOTROPY + 1), 0},
    {"stochastic_bilinear", SHD_FILTER_STOCHASTIC, SHD_FILTER_BILINEAR, 1, 0},
    {"stochastic_ewa", SHD_FILTER_STOCHASTIC, SHD_FILTER_EWA, 1, 0},
    {"exact", SHD_FILTER_EXACT, SHD_FILTER_BILINEAR, 0, 0},
};
enum { SHD_FILTER_ROWS = sizeof k_filters / sizeof k_filters[0], SHD_TEST_WRAPS = 5, SHD_TEST_TARGETS = 8 };
static const char *const k_wraps[SHD_TEST_WRAPS] = {"repeat", "clamp", "mirror", "border", "mirror_once"};

/** A texture of 13 x 9 random RGBA8 texels with every table, once on each target. */
static struct {
    shd_context *context[SHD_TEST_TARGETS];
    shd_texture *texture[SHD_TEST_TARGETS];
    int count;
} g_targets;

static inline int shd_open_targets(void **state)
{
    static unsigned char texels[13 * 9 * 4];
    uint32_t bits = 3;
    size_t i;
    int simd;
    (void)state;
    for (i = 0; i < sizeof texels; ++i) {
        shd_noise(&bits);
        texels[i] = (unsigned char)(bits >> 24);
    }
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        shd_texture_desc texture = shd_texture_desc_default();
        desc.simd = (shd_simd)simd;
        desc.worker_count = 1;
        if (shd_context_create(&desc, &g_targets.context[g_targets.count]) != SHD_OK) continue;
        texture.format = SHD_FORMAT_RGBA8;
        texture.width = 13;
        texture.height = 9;
        texture.texels = texels;
        texture.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
        shd_assert_ok(
            shd_texture_create(g_targets.context[g_targets.count], &texture, &g_targets.texture[g_targets.count]));
        ++g_targets.count;
    }
    return g_targets.count > 0 ? 0 : -1;
}

static inline int shd_close_targets(void **state)
{
    (void)state;
    while (g_targets.count-- > 0) {
        shd_texture_release(g_targets.texture[g_targets.count]);
        shd_context_release(g_targets.context[g_targets.count]);
    }
    return 0;
}

/** A sampler of one filter and wrap, whose border lies within the range of the texels. */
static inline shd_sampler *shd_make_sampler(const shd_filter_row *row, int wrap)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_sampler *sampler = NULL;
    int c;
    desc.filter = row->filter;
    desc.stochastic_filter = row->stochastic_filter;
    desc.cubic = row->filter == SHD_FILTER_STOCHASTIC ? SHD_CUBIC_B_SPLINE : SHD_CUBIC_CATMULL_ROM;
    desc.max_anisotropy = SHD_TEST_ANISOTROPY;
    desc.wrap_u = desc.wrap_v = (shd_wrap)wrap;
    for (c = 0; c < 4; ++c) desc.border[c] = 0.25f + 0.125f * (float)c;
    shd_assert_ok(shd_sampler_create(g_targets.context[0], &desc, &sampler));
    return sampler;
}

#endif /* SHD_TESTS_SUPPORT_FILTERS_H */
