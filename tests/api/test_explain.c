/* SPDX-License-Identifier: MIT */
/* Explanations: a replay gives exactly the bits of shd_texture_sample; refusals. */
#include "support/check.h"
#include "support/noise.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include <shd/shd.h>

enum { POINTS = 200, WIDTH = 48, HEIGHT = 20, LAYERS = 2, MAX_TAPS = 16384 };

static shd_context *g_context;
static float g_columns[6][POINTS], g_out[4][POINTS];
static uint32_t g_layers[POINTS];
static shd_tap g_taps[MAX_TAPS];
static shd_blend_step g_blends[MAX_TAPS];

static const struct {
    const char *name;
    shd_filter filter, stochastic_filter;
} k_filters[] = {{"nearest", SHD_FILTER_NEAREST, SHD_FILTER_TRILINEAR},
                 {"bilinear", SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR},
                 {"bicubic", SHD_FILTER_BICUBIC, SHD_FILTER_TRILINEAR},
                 {"hermite", SHD_FILTER_HERMITE, SHD_FILTER_TRILINEAR},
                 {"nearest_mip", SHD_FILTER_NEAREST_MIP, SHD_FILTER_TRILINEAR},
                 {"nearest_mip_linear", SHD_FILTER_NEAREST_MIP_LINEAR, SHD_FILTER_TRILINEAR},
                 {"bilinear_mip", SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR},
                 {"trilinear", SHD_FILTER_TRILINEAR, SHD_FILTER_TRILINEAR},
                 {"ripmap", SHD_FILTER_RIPMAP, SHD_FILTER_TRILINEAR},
                 {"anisotropic", SHD_FILTER_ANISOTROPIC, SHD_FILTER_TRILINEAR},
                 {"ewa", SHD_FILTER_EWA, SHD_FILTER_TRILINEAR},
                 {"stochastic_bicubic", SHD_FILTER_STOCHASTIC, SHD_FILTER_BICUBIC},
                 {"stochastic_anisotropic", SHD_FILTER_STOCHASTIC, SHD_FILTER_ANISOTROPIC},
                 {"stochastic_ewa", SHD_FILTER_STOCHASTIC, SHD_FILTER_EWA}};
enum { FILTERS = sizeof k_filters / sizeof k_filters[0] };

/* Filters with a profile, each with one format and wrap. */
static const struct {
    const char *name;
    shd_profile profile;
} k_profiles[] = {{"vulkan", SHD_PROFILE_VULKAN}, {"d3d11", SHD_PROFILE_D3D11}, {"oiio", SHD_PROFILE_OIIO}};
enum { PROFILES = sizeof k_profiles / sizeof k_profiles[0] };

static const shd_format k_formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RG8,  SHD_FORMAT_RGBA8_SRGB,
                                       SHD_FORMAT_RGB16, SHD_FORMAT_R16F, SHD_FORMAT_RGBA32F};
enum { FORMATS = sizeof k_formats / sizeof k_formats[0] };

static uint32_t random_bits(uint32_t *state) { return shd_noise(state); }
static float random_in(uint32_t *state, float low, float high)
{
    return low + (high - low) * (float)(random_bits(state) >> 8) * (1.0f / 16777216.0f);
}

static int setup(void **state)
{
    uint32_t seed = 7;
    int i, c;
    (void)state;
    for (i = 0; i < POINTS; ++i) {
        const float scale = ldexpf(1, (int)(random_bits(&seed) >> 29) - 7);
        g_columns[0][i] = random_in(&seed, -1.5f, 2.5f);
        g_columns[1][i] = random_in(&seed, -1.5f, 2.5f);
        for (c = 2; c < 6; ++c) g_columns[c][i] = scale * random_in(&seed, -1, 1);
        g_layers[i] = (uint32_t)i % 3;
    }
    g_columns[0][0] = NAN;
    g_columns[2][1] = INFINITY;
    g_columns[3][2] = 1e30f;
    for (c = 2; c < 6; ++c) g_columns[c][3] = 0;
    return shd_context_create(NULL, &g_context) == SHD_OK ? 0 : -1;
}
static int teardown(void **state)
{
    (void)state;
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
    lookups.layer.data = g_layers;
    return lookups;
}

static shd_texture *make_texture(shd_format format)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    const size_t size = (size_t)WIDTH * HEIGHT * LAYERS * shd_format_size(format);
    const int floats = format == SHD_FORMAT_RGBA32F;
    unsigned char *texels = (unsigned char *)malloc(size);
    uint32_t seed = 99;
    size_t i;
    for (i = 0; i < size; i += 2) {
        const uint16_t half = (uint16_t)(random_bits(&seed) >> 16 & 0xbbff);
        memcpy(texels + i, &half, 2);
    }
    for (i = 0; floats && i < size; i += 4) {
        const float value = random_in(&seed, -8, 8);
        memcpy(texels + i, &value, 4);
    }
    desc.format = format;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.layer_count = LAYERS;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP;
    desc.swizzle[0] = SHD_CHANNEL_A;
    desc.swizzle[2] = SHD_CHANNEL_R;
    desc.fill[1] = 0.125f;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    free(texels);
    return texture;
}

static shd_sampler *make_sampler(shd_filter filter, shd_filter stochastic_filter, shd_wrap wrap, shd_profile profile)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    const float border[4] = {0.25f, -1.5f, 2.0f, 0.75f};
    shd_sampler *sampler = NULL;
    desc.filter = filter;
    desc.stochastic_filter = stochastic_filter;
    desc.cubic = stochastic_filter == SHD_FILTER_BICUBIC ? SHD_CUBIC_B_SPLINE : SHD_CUBIC_CATMULL_ROM;
    desc.profile = profile;
    desc.magnification = SHD_MAGNIFICATION_BICUBIC;
    desc.wrap_u = wrap;
    desc.wrap_v = wrap == SHD_WRAP_BORDER ? SHD_WRAP_CLAMP : wrap;
    memcpy(desc.border, border, sizeof border);
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    return sampler;
}

static uint32_t level_size(uint32_t size, uint32_t level) { return size >> level > 0 ? size >> level : 1; }

/** A blend as shd/explain.h defines it, for finite a and b. */
static float blend_nodes(float a, float b, float s)
{
    float mixed = a + s * (b - a);
    if (s == 0) return a;
    if (!isfinite(mixed)) mixed = (1 - s) * a + s * b;
    return mixed > FLT_MAX ? FLT_MAX : mixed < -FLT_MAX ? -FLT_MAX : mixed;
}

/** Stored channel c of the result, computed from the tree. */
static float replay(const shd_explanation *e, uint32_t c)
{
    static float v[2 * MAX_TAPS];
    const uint32_t nodes = e->tap_count + e->blend_count;
    uint32_t i;
    float last;
    for (i = 0; i < e->tap_count; ++i) v[i] = e->taps[i].value[c];
    for (i = 0; i < e->blend_count; ++i) {
        const shd_blend_step *blend = &e->blends[i];
        assert_true(blend->a < e->tap_count + i && blend->b < e->tap_count + i);
        v[e->tap_count + i] = blend_nodes(v[blend->a], v[blend->b], blend->s);
    }
    last = v[nodes - 1];
    return e->scale_low[c] == 0 ? last : last * e->scale_high[c] + last * e->scale_low[c];
}

static void check_point(const shd_texture *texture, const shd_sampler *sampler, const shd_lookups *lookups, size_t i)
{
    static const float k_fill[4] = {0, 0.125f, 0, 1};
    shd_explanation e = shd_explanation_default(), counted = shd_explanation_default();
    double sum = 0;
    uint32_t k;
    e.taps = g_taps;
    e.blends = g_blends;
    e.tap_capacity = e.blend_capacity = MAX_TAPS;
    shd_assert_ok(shd_texture_explain(texture, sampler, lookups, i, &counted));
    shd_assert_ok(shd_texture_explain(texture, sampler, lookups, i, &e));
    assert_int_equal(counted.tap_count, e.tap_count);
    assert_int_equal(counted.blend_count, e.blend_count);
    assert_in_range(e.tap_count, 1, MAX_TAPS);
    assert_int_equal(e.blend_count + 1, e.tap_count);
    for (k = 0; k < e.tap_count; ++k) {
        assert_in_range(e.taps[k].layer, 0, LAYERS - 1);
        assert_int_equal(e.taps[k].layer, g_layers[i] < LAYERS ? g_layers[i] : LAYERS - 1);
        assert_true(e.taps[k].x < level_size(WIDTH, e.taps[k].level_u));
        assert_true(e.taps[k].y < level_size(HEIGHT, e.taps[k].level_v));
        sum += (double)e.taps[k].weight;
    }
    shd_assert_close("weights", i, sum, 1, 1e-5, 0);
    for (k = 0; k < 4; ++k) {
        const float want = g_out[k][i];
        const float got = e.channel_source[k] == 4 ? k_fill[k] : replay(&e, e.channel_source[k]);
        assert_memory_equal(&e.result[k], &want, sizeof want);
        if (memcmp(&got, &want, sizeof want) != 0) {
            fail_msg("point %zu channel %u: replayed %.9g, sampled %.9g", i, k, (double)got, (double)want);
        }
    }
}

struct replay_case {
    char name[64];
    shd_filter filter, stochastic_filter;
    shd_format format;
    shd_wrap wrap;
    shd_profile profile;
};

static void test_replay(void **state)
{
    const struct replay_case *c = (const struct replay_case *)*state;
    shd_texture *texture = make_texture(c->format);
    shd_sampler *sampler = make_sampler(c->filter, c->stochastic_filter, c->wrap, c->profile);
    const shd_lookups lookups = make_lookups();
    shd_texels out;
    size_t i;
    memset(&out, 0, sizeof out);
    for (i = 0; i < 4; ++i) out.channel[i].data = g_out[i];
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &out));
    for (i = 0; i < POINTS; ++i) check_point(texture, sampler, &lookups, i);
    shd_sampler_release(sampler);
    shd_texture_release(texture);
}

/** The four texels of one bilinear lookup, computed by hand. */
static void test_bilinear_by_hand(void **state)
{
    const unsigned char texels[] = {0, 51, 102, 255};
    const float u = 0.625f, v = 0.5f;
    const float want[] = {0.0f, 51.0f, 102.0f, 255.0f}, weight[] = {0.125f, 0.375f, 0.125f, 0.375f};
    shd_texture_desc desc = shd_texture_desc_default();
    shd_explanation e = shd_explanation_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    shd_sampler_desc bilinear = shd_sampler_desc_default();
    shd_tap taps[4];
    uint32_t k;
    (void)state;
    desc.format = SHD_FORMAT_R8;
    desc.width = desc.height = 2;
    desc.texels = texels;
    bilinear.filter = SHD_FILTER_BILINEAR;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    shd_assert_ok(shd_sampler_create(g_context, &bilinear, &sampler));
    lookups.count = 1;
    lookups.u.data = &u;
    lookups.v.data = &v;
    e.taps = taps;
    e.tap_capacity = 4;
    shd_assert_ok(shd_texture_explain(texture, sampler, &lookups, 0, &e));
    assert_int_equal(e.tap_count, 4);
    assert_int_equal(e.blend_count, 3);
    assert_int_equal(e.filter, SHD_FILTER_BILINEAR);
    for (k = 0; k < 4; ++k) {
        assert_int_equal(taps[k].level_u + taps[k].level_v, 0);
        assert_int_equal(taps[k].x, k % 2);
        assert_int_equal(taps[k].y, k / 2);
        assert_int_equal(taps[k].border, 0);
        /* s = 0.625 * 2 - 0.5 = 0.75, t = 0.5 */
        assert_true(taps[k].value[0] == want[k]);
        assert_true(taps[k].weight == weight[k]);
    }
    shd_assert_close("result", 0, (double)e.result[0], (0.375 * 51 + 0.125 * 102 + 0.375 * 255) / 255, 1e-7, 0);
    shd_sampler_release(sampler);
    shd_texture_release(texture);
}

/**
 * Ellipses computed by hand: rotated by 30 degrees, half axes of 8 and 2 texels; then both doubled by the sampler's
 * widths.
 */
static void test_axes(void **state)
{
    shd_texture *texture = make_texture(SHD_FORMAT_RGBA8);
    const float u = 0.5f, v = 0.5f, c = 0.8660254f, s = 0.5f;
    const float dudx = 8 * c / WIDTH, dvdx = 8 * s / HEIGHT, dudy = -2 * s / WIDTH, dvdy = 2 * c / HEIGHT, lod = 1.5f;
    float width;
    (void)state;
    for (width = 1; width <= 2; width += 1) {
        shd_sampler_desc desc = shd_sampler_desc_default();
        shd_explanation e = shd_explanation_default();
        shd_lookups lookups = shd_lookups_default();
        shd_sampler *sampler = NULL;
        desc.width_x = desc.width_y = width;
        shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
        lookups.count = 1;
        lookups.u.data = &u;
        lookups.v.data = &v;
        lookups.dudx.data = &dudx;
        lookups.dvdx.data = &dvdx;
        lookups.dudy.data = &dudy;
        lookups.dvdy.data = &dvdy;
        shd_assert_ok(shd_texture_explain(texture, sampler, &lookups, 0, &e));
        shd_assert_close("longer u", 0, fabs((double)e.longer_axis[0]), 8.0 * (double)(c * width), 1e-4, 0);
        shd_assert_close("longer v", 0, fabs((double)e.longer_axis[1]), 8.0 * (double)(s * width), 1e-4, 0);
        shd_assert_close("shorter u", 0, fabs((double)e.shorter_axis[0]), 2.0 * (double)(s * width), 1e-4, 0);
        shd_assert_close("shorter v", 0, fabs((double)e.shorter_axis[1]), 2.0 * (double)(c * width), 1e-4, 0);
        assert_true(e.longer_axis[0] * e.longer_axis[1] > 0 && e.shorter_axis[0] * e.shorter_axis[1] < 0);
        lookups.lod.data = &lod;
        shd_assert_ok(shd_texture_explain(texture, sampler, &lookups, 0, &e));
        shd_assert_close("round", 0, (double)e.longer_axis[0], sqrt(8), 1e-5, 0);
        shd_assert_close("round", 1, (double)e.shorter_axis[1], sqrt(8), 1e-5, 0);
        assert_true(e.longer_axis[1] == 0 && e.shorter_axis[0] == 0);
        shd_sampler_release(sampler);
    }
    shd_texture_release(texture);
}

/** Texels near the largest float: bicubic blends overflow, and the replay still has the bits of the lookup. */
static void test_largest_texels(void **state)
{
    static float texels[WIDTH * HEIGHT * LAYERS * 4];
    shd_texture_desc desc = shd_texture_desc_default();
    shd_lookups lookups = make_lookups();
    shd_texels out = shd_texels_default();
    shd_sampler *sampler = make_sampler(SHD_FILTER_BICUBIC, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PROFILE_EXACT);
    shd_texture *texture = NULL;
    uint32_t seed = 5;
    size_t i;
    (void)state;
    for (i = 0; i < sizeof texels / sizeof texels[0]; ++i) {
        texels[i] = (random_bits(&seed) >> 31 ? FLT_MAX : -FLT_MAX) * random_in(&seed, 0.8f, 1.0f);
    }
    desc.format = SHD_FORMAT_RGBA32F;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.layer_count = LAYERS;
    desc.texels = texels;
    desc.swizzle[0] = SHD_CHANNEL_A;
    desc.swizzle[2] = SHD_CHANNEL_R;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    for (i = 0; i < 4; ++i) out.channel[i].data = g_out[i];
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &out));
    for (i = 0; i < POINTS; ++i) check_point(texture, sampler, &lookups, i);
    shd_sampler_release(sampler);
    shd_texture_release(texture);
}

static void test_arguments(void **state)
{
    shd_texture *texture = make_texture(SHD_FORMAT_RGBA8);
    shd_sampler *sampler = make_sampler(SHD_FILTER_TRILINEAR, SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT, SHD_PROFILE_EXACT);
    shd_lookups lookups = make_lookups();
    shd_explanation e = shd_explanation_default();
    const shd_result invalid = SHD_ERROR_INVALID_ARGUMENT;
    (void)state;
    shd_assert_result("texture", shd_texture_explain(NULL, sampler, &lookups, 0, &e), invalid, "texture: NULL");
    shd_assert_result("sampler", shd_texture_explain(texture, NULL, &lookups, 0, &e), invalid, "sampler: NULL");
    shd_assert_result("lookups", shd_texture_explain(texture, sampler, NULL, 0, &e), invalid, "lookups: NULL");
    shd_assert_result("out", shd_texture_explain(texture, sampler, &lookups, 0, NULL), invalid, "explanation: NULL");
    shd_assert_result("index", shd_texture_explain(texture, sampler, &lookups, POINTS, &e), invalid,
                      "index: 200 is not below lookups.count 200");
    e.tap_capacity = 1;
    shd_assert_result("taps", shd_texture_explain(texture, sampler, &lookups, 0, &e), invalid,
                      "explanation.taps: NULL");
    e.tap_capacity = 0;
    e.blend_capacity = 1;
    shd_assert_result("blends", shd_texture_explain(texture, sampler, &lookups, 0, &e), invalid,
                      "explanation.blends: NULL");
    e.blend_capacity = 0;
    e.tap_size = sizeof(shd_tap) - 1;
    shd_assert_result("tap_size", shd_texture_explain(texture, sampler, &lookups, 0, &e), invalid,
                      "explanation.tap_size: 47 is not in 48..4096");
    e.tap_size = sizeof(shd_tap) + 2;
    shd_assert_result("tap_size", shd_texture_explain(texture, sampler, &lookups, 0, &e), invalid,
                      "explanation.tap_size: 50 is not a multiple of 4");
    e = shd_explanation_default();
    e.blend_size = 1u << 13;
    shd_assert_result("blend_size", shd_texture_explain(texture, sampler, &lookups, 0, &e), invalid,
                      "explanation.blend_size: 8192 is not in 12..4096");
    lookups.u.data = NULL;
    shd_assert_result("u", shd_texture_explain(texture, sampler, &lookups, 0, &e), invalid, "lookups.u.data: NULL");
    shd_sampler_release(sampler);
    shd_texture_release(texture);
}

int main(void)
{
    static struct replay_case cases[FILTERS * FORMATS * 5 + FILTERS * PROFILES];
    static struct CMUnitTest tests[FILTERS * FORMATS * 5 + FILTERS * PROFILES + 4];
    size_t n = 0, k;
    for (; n < FILTERS * FORMATS * 5; ++n) {
        struct replay_case *c = &cases[n];
        c->wrap = (shd_wrap)(n % 5);
        c->format = k_formats[n / 5 % FORMATS];
        c->filter = k_filters[n / 5 / FORMATS].filter;
        c->stochastic_filter = k_filters[n / 5 / FORMATS].stochastic_filter;
        snprintf(c->name, sizeof c->name, "replay/%s/format_%d/wrap_%d", k_filters[n / 5 / FORMATS].name,
                 (int)c->format, (int)c->wrap);
        tests[n] = (struct CMUnitTest){c->name, test_replay, NULL, NULL, c};
    }
    for (k = 0; k < FILTERS * PROFILES; ++k) {
        struct replay_case *c = &cases[n];
        c->wrap = (shd_wrap)(k % 5);
        c->format = k_formats[k % FORMATS];
        c->filter = k_filters[k / PROFILES].filter;
        c->stochastic_filter = k_filters[k / PROFILES].stochastic_filter;
        c->profile = k_profiles[k % PROFILES].profile;
        snprintf(c->name, sizeof c->name, "replay/%s/%s", k_filters[k / PROFILES].name, k_profiles[k % PROFILES].name);
        tests[n++] = (struct CMUnitTest){c->name, test_replay, NULL, NULL, c};
    }
    tests[n++] = (struct CMUnitTest){"bilinear_by_hand", test_bilinear_by_hand, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"axes", test_axes, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"largest_texels", test_largest_texels, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"arguments", test_arguments, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.explain", tests, n, setup, teardown);
}
