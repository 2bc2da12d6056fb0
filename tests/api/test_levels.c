/* SPDX-License-Identifier: MIT */
/* shd_texture_query_levels against log2 of the longer axis, with bias, clamps and strides. */
#include "support/check.h"
#include "support/noise.h"

#include <shd/shd.h>

enum { POINTS = 1500, WIDTH = 64, HEIGHT = 16 };

static shd_context *g_context;
static shd_texture *g_texture;
static float g_columns[6][POINTS], g_lod[2 * POINTS];
static uint32_t g_level[POINTS];

static int setup(void **state)
{
    static unsigned char texels[WIDTH * HEIGHT];
    shd_texture_desc desc = shd_texture_desc_default();
    uint32_t bits = 5;
    int i, c;
    (void)state;
    for (i = 0; i < POINTS; ++i) {
        for (c = 0; c < 6; ++c) {
            shd_noise(&bits);
            g_columns[c][i] = ldexpf((float)(bits >> 8) / 8388608.0f - 1.0f, -(i % 9));
        }
    }
    if (shd_context_create(NULL, &g_context) != SHD_OK) return -1;
    desc.format = SHD_FORMAT_R8;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    return shd_texture_create(g_context, &desc, &g_texture) == SHD_OK ? 0 : -1;
}
static int teardown(void **state)
{
    (void)state;
    shd_texture_release(g_texture);
    shd_context_release(g_context);
    return 0;
}

static shd_lookups make_lookups(void)
{
    shd_lookups lookups = shd_lookups_default();
    lookups.count = POINTS;
    lookups.u.data = g_columns[0];
    lookups.v.data = g_columns[1];
    lookups.dudx.data = g_columns[2];
    lookups.dvdx.data = g_columns[3];
    lookups.dudy.data = g_columns[4];
    lookups.dvdy.data = g_columns[5];
    return lookups;
}

struct level_case {
    const char *name;
    float bias, low, high;
    int lod_given;
    shd_profile profile;
};
static const struct level_case k_cases[] = {
    {"levels/derivatives", 0, 0, 32, 0, SHD_PROFILE_EXACT},
    {"levels/bias", 1.25f, 0, 32, 0, SHD_PROFILE_EXACT},
    {"levels/clamped", 0, 1.5f, 3.75f, 0, SHD_PROFILE_EXACT},
    {"levels/min_above_max", 0, 4, 2, 0, SHD_PROFILE_EXACT},
    {"levels/lod_column", -0.5f, 0, 32, 1, SHD_PROFILE_EXACT},
    {"levels/least_error", 0, 0, 32, 0, SHD_PROFILE_LEAST_ERROR},
    {"levels/least_error_bias", 1.25f, 0, 32, 0, SHD_PROFILE_LEAST_ERROR},
    {"levels/least_error_clamped", 0, 1.5f, 3.75f, 0, SHD_PROFILE_LEAST_ERROR},
    {"levels/least_error_lod_column", -0.5f, 0, 32, 1, SHD_PROFILE_LEAST_ERROR},
    {"levels/vulkan", 0, 0, 32, 0, SHD_PROFILE_VULKAN},
    {"levels/vulkan_bias", 0.75f, 0, 32, 0, SHD_PROFILE_VULKAN},
    {"levels/d3d11", -0.5f, 0.5f, 4, 0, SHD_PROFILE_D3D11},
    {"levels/oiio", 0, 0, 32, 0, SHD_PROFILE_OIIO},
    {"levels/oiio_lod_column", 0.25f, 0, 32, 1, SHD_PROFILE_OIIO},
};

/** Larger singular value, from the eigenvalues of the matrix times its transpose. */
static double longer_axis(int i)
{
    const double ux = (double)g_columns[2][i] * WIDTH, vx = (double)g_columns[3][i] * HEIGHT;
    const double uy = (double)g_columns[4][i] * WIDTH, vy = (double)g_columns[5][i] * HEIGHT;
    const double mean = (ux * ux + vx * vx + uy * uy + vy * vy) / 2, det = ux * vy - uy * vx;
    return sqrt(mean + sqrt(fmax(mean * mean - det * det, 0)));
}

/** Root mean square of both axes. */
static double size_of_footprint(int i)
{
    const double longer = longer_axis(i);
    const double ux = (double)g_columns[2][i] * WIDTH, vx = (double)g_columns[3][i] * HEIGHT;
    const double uy = (double)g_columns[4][i] * WIDTH, vy = (double)g_columns[5][i] * HEIGHT;
    const double shorter = fabs(ux * vy - uy * vx) / longer;
    return sqrt((longer * longer + shorter * shorter) / 2);
}

static double longer_derivative(int i)
{
    return fmax(hypot((double)g_columns[2][i] * WIDTH, (double)g_columns[3][i] * HEIGHT),
                hypot((double)g_columns[4][i] * WIDTH, (double)g_columns[5][i] * HEIGHT));
}

/** Levels are WIDTH >> m by HEIGHT >> m, the smaller side from 16 down to 1 and 1 again on levels 5 and 6. */
static double oiio_lambda(int i)
{
    const double x = fmax(fabs((double)g_columns[2][i]), fabs((double)g_columns[3][i]));
    const double width = fmax(x, fmax(fabs((double)g_columns[4][i]), fabs((double)g_columns[5][i])));
    int m;
    for (m = 0; m <= 6; ++m) {
        const double texels = width * (m < 4 ? HEIGHT >> m : 1);
        if (texels <= 1) return m == 0 ? log2(texels) : m - 1 + fmax(2 * texels - 1, 0);
    }
    return 6;
}

static double lambda_of(shd_profile profile, int i)
{
    if (profile == SHD_PROFILE_LEAST_ERROR) return log2(size_of_footprint(i)) - 0.375;
    if (profile == SHD_PROFILE_VULKAN) return log2(longer_derivative(i));
    return profile == SHD_PROFILE_OIIO ? oiio_lambda(i) : log2(longer_axis(i));
}

static double level_of(shd_profile profile, float lod)
{
    if (profile == SHD_PROFILE_D3D11) return floor(floor((double)lod * 256 + 0.5) / 256 + 0.5);
    return profile == SHD_PROFILE_OIIO ? ceil((double)lod) : ceil((double)lod + 0.5) - 1;
}

static void test_levels(void **state)
{
    const struct level_case *c = (const struct level_case *)*state;
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_sampler *sampler = NULL;
    shd_lookups lookups = make_lookups();
    shd_levels out = shd_levels_default();
    int i;
    desc.filter = SHD_FILTER_NEAREST; /* does not matter */
    desc.lod_bias = c->bias;
    desc.lod_min = c->low;
    desc.lod_max = c->high;
    desc.profile = c->profile;
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    out.lod.data = g_lod;
    out.lod.stride = 8;
    out.level.data = g_level;
    if (c->lod_given) lookups.lod.data = g_columns[4];
    shd_assert_ok(shd_texture_query_levels(g_texture, sampler, &lookups, &out));
    for (i = 0; i < POINTS; ++i) {
        const double lambda = (c->lod_given ? (double)g_columns[4][i] : lambda_of(c->profile, i)) + (double)c->bias;
        const double high = fmin(fmax((double)c->high, (double)c->low), 6), low = fmin((double)c->low, 6);
        const double want = fmin(fmax(lambda, low), high);
        shd_assert_close(c->name, (size_t)i, (double)g_lod[2 * i], want, 3e-6, 0);
        assert_true((double)g_level[i] == level_of(c->profile, g_lod[2 * i]));
    }
    out.lod.data = NULL;
    memset(g_level, 0xff, sizeof g_level);
    shd_assert_ok(shd_texture_query_levels(g_texture, sampler, &lookups, &out));
    for (i = 0; i < POINTS; ++i) assert_true((double)g_level[i] == level_of(c->profile, g_lod[2 * i]));
    shd_sampler_release(sampler);
}

static void test_arguments(void **state)
{
    const shd_result invalid = SHD_ERROR_INVALID_ARGUMENT;
    shd_lookups lookups = make_lookups();
    shd_sampler *sampler = NULL;
    shd_levels out = shd_levels_default();
    (void)state;
    shd_assert_ok(shd_sampler_create(g_context, NULL, &sampler));
    shd_assert_result("texture", shd_texture_query_levels(NULL, sampler, &lookups, &out), invalid, "texture: NULL");
    shd_assert_result("sampler", shd_texture_query_levels(g_texture, NULL, &lookups, &out), invalid, "sampler: NULL");
    shd_assert_result("lookups", shd_texture_query_levels(g_texture, sampler, NULL, &out), invalid, "lookups: NULL");
    shd_assert_result("levels", shd_texture_query_levels(g_texture, sampler, &lookups, NULL), invalid, "levels: NULL");
    out.level.data = g_level;
    out.level.stride = 6;
    shd_assert_result("stride", shd_texture_query_levels(g_texture, sampler, &lookups, &out), invalid,
                      "levels.level.stride: 6");
    lookups.count = 0;
    out.level.stride = 0;
    shd_assert_ok(shd_texture_query_levels(g_texture, sampler, &lookups, &out));
    shd_sampler_release(sampler);
}

static float g_shared[4 * POINTS + 2];

struct overlap_case {
    const char *name;
    size_t in, in_stride, lod, lod_stride, level, level_stride; /**< elements of g_shared; 0 strides = packed */
    const char *message;                                        /**< "" = accepted */
};
static const struct overlap_case k_overlaps[] = {
    {"overlaps/apart", 0, 4, 1, 4, 2, 4, ""},
    {"overlaps/lod_is_in", 0, 4, 0, 4, 2, 4, "levels.lod: overlaps lookups.lod"},
    {"overlaps/packed_level_over_in", 1, 4, 2, 4, 0, 0, "levels.level: overlaps lookups.lod"},
    {"overlaps/level_is_lod", 0, 4, 1, 4, 1, 4, "levels.level: overlaps levels.lod"},
    {"overlaps/one_row_later", 0, 2, 1, 2, 3, 2, "levels.level: overlaps levels.lod"},
};

static void test_overlaps(void **state)
{
    const struct overlap_case *c = (const struct overlap_case *)*state;
    shd_lookups lookups = make_lookups();
    shd_sampler *sampler = NULL;
    shd_levels out = shd_levels_default();
    shd_assert_ok(shd_sampler_create(g_context, NULL, &sampler));
    lookups.lod.data = g_shared + c->in;
    lookups.lod.stride = 4 * c->in_stride;
    out.lod.data = g_shared + c->lod;
    out.lod.stride = 4 * c->lod_stride;
    out.level.data = (uint32_t *)(void *)(g_shared + c->level);
    out.level.stride = 4 * c->level_stride;
    shd_assert_result(c->name, shd_texture_query_levels(g_texture, sampler, &lookups, &out),
                      c->message[0] ? SHD_ERROR_INVALID_ARGUMENT : SHD_OK, c->message);
    shd_sampler_release(sampler);
}

int main(void)
{
    struct CMUnitTest tests[32];
    size_t n = 0, i;
    for (; n < sizeof k_cases / sizeof k_cases[0]; ++n) {
        tests[n] = (struct CMUnitTest){k_cases[n].name, test_levels, NULL, NULL, (void *)&k_cases[n]};
    }
    tests[n++] = (struct CMUnitTest){"arguments", test_arguments, NULL, NULL, NULL};
    for (i = 0; i < sizeof k_overlaps / sizeof k_overlaps[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_overlaps[i].name, test_overlaps, NULL, NULL, (void *)&k_overlaps[i]};
    }
    return _cmocka_run_group_tests("api.levels", tests, n, setup, teardown);
}
