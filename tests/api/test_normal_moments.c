/* SPDX-License-Identifier: MIT */
/* Moments of normal maps: every format against the oracle, lookups of moments and of lengths of mean normals, and
 * refusals. */
#include "support/check.h"
#include "support/image.h"
#include "support/noise.h"

#include <stdlib.h>

#include <shd/shd.h>

#include "ref/moments_ref.h"

enum { WIDTH = 13, HEIGHT = 7, SIZE = 64, LEVELS = 6 };

static const float k_nan = (float)NAN, k_inf = (float)INFINITY;

static float next_random(uint32_t *seed)
{
    shd_noise(seed);
    return 2 * (float)(*seed >> 8) / 16777216.0f - 1;
}

/* Half to float, for normal numbers and 0. */
static double half_value(uint16_t half)
{
    const int exponent = half >> 10 & 31;
    const double mantissa = half & 1023;
    const double value = exponent ? ldexp(1024 + mantissa, exponent - 25) : ldexp(mantissa, -24);
    return half & 0x8000 ? -value : value;
}

/* ---- every format ---- */

struct format_case {
    const char *name;
    shd_format format, out;
    uint32_t channels;
};
static const struct format_case k_formats[] = {
    {"format/rgb8_to_32f", SHD_FORMAT_RGB8, SHD_FORMAT_RGBA32F, 3},
    {"format/rgba8_to_16f", SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA16F, 4},
    {"format/rgb8_srgb_to_16f", SHD_FORMAT_RGB8_SRGB, SHD_FORMAT_RGBA16F, 3},
    {"format/rgba8_srgb_to_32f", SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA32F, 4},
    {"format/rgb16_to_32f", SHD_FORMAT_RGB16, SHD_FORMAT_RGBA32F, 3},
    {"format/rgba16_to_16f", SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA16F, 4},
    {"format/rgb16f_to_32f", SHD_FORMAT_RGB16F, SHD_FORMAT_RGBA32F, 3},
    {"format/rgba16f_to_16f", SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA16F, 4},
    {"format/rgb32f_to_32f", SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F, 3},
    {"format/rgba32f_to_16f", SHD_FORMAT_RGBA32F, SHD_FORMAT_RGBA16F, 4},
};

/* Stores a random channel; returns the value that the stored bits represent. */
static double store_channel(shd_format format, uint32_t *seed, unsigned char *to)
{
    const float value = next_random(seed);
    const uint16_t code = (uint16_t)((value + 1) / 2 * 65535);
    switch (format) {
        case SHD_FORMAT_RGB32F:
        case SHD_FORMAT_RGBA32F: {
            const float scaled = 5 * value; /* normals may have any length */
            memcpy(to, &scaled, sizeof scaled);
            return (double)scaled;
        }
        case SHD_FORMAT_RGB16F:
        case SHD_FORMAT_RGBA16F: {
            const uint16_t half = (uint16_t)((value < 0 ? 0x8000 : 0) | (0x2000 + (code & 0x1fff)));
            memcpy(to, &half, sizeof half);
            return half_value(half);
        }
        case SHD_FORMAT_RGB16:
        case SHD_FORMAT_RGBA16: memcpy(to, &code, sizeof code); return 2 * (double)code / 65535 - 1;
        default: *to = (unsigned char)(code >> 8); return 2 * (double)*to / 255 - 1;
    }
}

static double load_moment(shd_format format, const unsigned char *from, size_t channel)
{
    uint16_t half;
    float value;
    memcpy(&half, from + 2 * channel, sizeof half);
    memcpy(&value, from + 4 * channel, sizeof value);
    return format == SHD_FORMAT_RGBA16F ? half_value(half) : (double)value;
}

/* Rows have gaps in both images, and the gaps do not change. */
static void test_format(void **state)
{
    static unsigned char in[HEIGHT * 256], out[HEIGHT * 256], product[HEIGHT * 64];
    const struct format_case *c = (const struct format_case *)*state;
    const size_t pixel = shd_format_size(c->format), channel = pixel / c->channels;
    const size_t out_pixel = shd_format_size(c->out);
    const double rounding = c->out == SHD_FORMAT_RGBA16F ? 0x1p-11 : 0x1p-24;
    shd_image normals = shd_test_image(c->format, WIDTH, HEIGHT, in),
              moments = shd_test_image(c->out, WIDTH, HEIGHT, out);
    const int is_half = c->out == SHD_FORMAT_RGBA16F;
    shd_image mixed = shd_test_image(is_half ? SHD_FORMAT_R32F : SHD_FORMAT_R16F, WIDTH, HEIGHT, product);
    static double want[HEIGHT][WIDTH][3];
    shd_context *context = NULL;
    uint32_t seed = 17, x, y, k;
    shd_assert_ok(shd_context_create(NULL, &context));
    normals.row_stride = moments.row_stride = 256;
    mixed.row_stride = 64;
    memset(out, 0xee, sizeof out);
    memset(product, 0xee, sizeof product);
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            for (k = 0; k < c->channels; ++k) {
                const double value = store_channel(c->format, &seed, in + 256 * y + pixel * x + channel * k);
                if (k < 3) want[y][x][k] = value;
            }
        }
    }
    shd_assert_ok(shd_mip_build_moments(context, &normals, &moments, &mixed));
    for (y = 0; y < HEIGHT; ++y) {
        const unsigned char *row = out + 256 * y, *products = product + 64 * y;
        for (x = 0; x < WIDTH; ++x) {
            const double *n = want[y][x];
            double b[2];
            shd_ref_slopes(n[0], n[1], n[2], b);
            shd_assert_close("product", x, load_moment(is_half ? SHD_FORMAT_RGBA32F : SHD_FORMAT_RGBA16F, products, x),
                             load_moment(c->out, row + out_pixel * x, 0) * load_moment(c->out, row + out_pixel * x, 1),
                             0x1p-25, is_half ? 0x1p-24 : 0x1.03p-11);
            for (k = 0; k < 2; ++k) {
                const double got = load_moment(c->out, row + out_pixel * x, k);
                shd_assert_close("slope", k, got, b[k], 0x1p-25, rounding * 1.01);
                shd_assert_close("square", k, load_moment(c->out, row + out_pixel * x, 2 + k), got * got, 0x1p-25,
                                 rounding * 1.01);
            }
        }
        for (k = (uint32_t)(out_pixel * WIDTH); k < 256; ++k) assert_int_equal(row[k], 0xee);
        for (k = (is_half ? 4 : 2) * WIDTH; k < 64; ++k) assert_int_equal(products[k], 0xee);
    }
    shd_context_release(context);
}

static void test_special(void **state)
{
    static const struct {
        float n[3], want[2];
    } k_rows[] = {
        {{0, 0, 1}, {0, 0}},           {{3, -4, 8}, {0.375f, -0.5f}},
        {{1e-40f, 0, 1e-40f}, {1, 0}}, {{3e38f, 3e38f, 3e38f}, {1, 1}},
        {{1, 0, 0}, {32, 0}},          {{0, -5, 0}, {0, -32}},
        {{0, 3, -4}, {0, 19.2f}}, /* backwards: z = length / 32 */
        {{0, 0, -1}, {0, 0}},          {{0, 0, 0}, {0, 0}},
    };
    const float bad[3] = {k_nan, k_inf, -k_inf};
    shd_context *context = NULL;
    float n[3], out[4];
    const shd_image normals = shd_test_image(SHD_FORMAT_RGB32F, 1, 1, n);
    const shd_image moments = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, out);
    size_t i, k, c;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (i = 0; i < sizeof k_rows / sizeof k_rows[0]; ++i) {
        memcpy(n, k_rows[i].n, sizeof n);
        shd_assert_ok(shd_mip_build_moments(context, &normals, &moments, NULL));
        for (k = 0; k < 2; ++k) {
            shd_assert_close("slope", i, (double)out[k], (double)k_rows[i].want[k], 0, 1e-6);
            assert_true(out[2 + k] == out[k] * out[k]);
        }
    }
    for (i = 0; i < 3; ++i) {
        for (c = 0; c < 3; ++c) {
            for (k = 0; k < 3; ++k) n[k] = k == c ? bad[i] : 0.5f;
            shd_assert_ok(shd_mip_build_moments(context, &normals, &moments, NULL));
            for (k = 0; k < 4; ++k) assert_true(out[k] == 0);
        }
    }
    shd_context_release(context);
}

/* ---- lookups ---- */

static float g_normals[SIZE * SIZE * 4], g_moments[SIZE * SIZE * 4];
static float g_levels[2][LEVELS][SIZE * SIZE];

static void bumpy(float height)
{
    uint32_t seed = 5, i, c;
    for (i = 0; i < SIZE * SIZE; ++i) {
        float n[3] = {height * next_random(&seed) + 0.25f, height * next_random(&seed), 1};
        const float length = sqrtf(n[0] * n[0] + n[1] * n[1] + 1);
        for (c = 0; c < 3; ++c) g_normals[4 * i + c] = n[c] / length;
        g_normals[4 * i + 3] = 1;
    }
}

static shd_texture *with_levels(shd_context *context, float *base, shd_texel_content semantic)
{
    shd_image levels[LEVELS];
    const shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, SIZE, SIZE, base);
    shd_mip_desc mip = shd_mip_desc_default();
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    uint32_t l;
    for (l = 0; l < LEVELS; ++l) {
        levels[l] = shd_test_image(SHD_FORMAT_RGBA32F, SIZE >> (l + 1), SIZE >> (l + 1),
                                   g_levels[semantic == SHD_TEXEL_CONTENT_NORMAL][l]);
    }
    mip.content = semantic;
    shd_assert_ok(shd_mip_build(context, &image, &mip, LEVELS, levels));
    desc.format = SHD_FORMAT_RGBA32F;
    desc.width = desc.height = SIZE;
    desc.texels = base;
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = levels;
    desc.level_count = LEVELS;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

static void look_up(shd_context *context, const shd_texture *texture, float u, float v, float lod, float out[4])
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_sampler *sampler = NULL;
    const float zero = 0;
    shd_texels texels;
    int c;
    desc.filter = SHD_FILTER_TRILINEAR;
    desc.lod_bias = lod; /* the footprint is one texel */
    desc.profile = SHD_PROFILE_EXACT;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    memset(&texels, 0, sizeof texels);
    lookups.count = 1;
    lookups.u.data = &u;
    lookups.v.data = &v;
    {
        const float texel = 1.0f / SIZE;
        lookups.dudx.data = lookups.dvdy.data = &texel;
        lookups.dvdx.data = lookups.dudy.data = &zero;
        for (c = 0; c < 4; ++c) texels.channel[c].data = out + c;
        shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    }
    shd_sampler_release(sampler);
}

static double variance_of(const float m[4])
{
    const double bx = (double)m[0], by = (double)m[1];
    return fmax(0, (double)m[2] + (double)m[3] - bx * bx - by * by) / 2;
}

/* A texel of a level gives the variance of the slopes that it covers, which the test sums one by one. Without bumps
 * the variance is 0. */
static void test_variance(void **state)
{
    const float height = (float)*(const int *)*state / 100.0f;
    const shd_image normals = shd_test_image(SHD_FORMAT_RGBA32F, SIZE, SIZE, g_normals);
    const shd_image moments = shd_test_image(SHD_FORMAT_RGBA32F, SIZE, SIZE, g_moments);
    shd_context *context = NULL;
    shd_texture *texture;
    uint32_t level, x, y;
    shd_assert_ok(shd_context_create(NULL, &context));
    bumpy(height);
    shd_assert_ok(shd_mip_build_moments(context, &normals, &moments, NULL));
    texture = with_levels(context, g_moments, SHD_TEXEL_CONTENT_DATA);
    for (level = 0; level <= LEVELS; level += 2) {
        const uint32_t edge = 1u << level, left = 16u % SIZE / edge * edge;
        double sum[4] = {0, 0, 0, 0}, want;
        float got[4];
        for (y = 0; y < edge; ++y) {
            for (x = 0; x < edge; ++x) {
                const float *n = g_normals + 4 * ((left + y) * SIZE + left + x);
                double b[2];
                shd_ref_slopes((double)n[0], (double)n[1], (double)n[2], b);
                sum[0] += b[0];
                sum[1] += b[1];
                sum[2] += b[0] * b[0];
                sum[3] += b[1] * b[1];
            }
        }
        for (x = 0; x < 4; ++x) sum[x] /= (double)edge * edge;
        want = (sum[2] + sum[3] - sum[0] * sum[0] - sum[1] * sum[1]) / 2;
        look_up(context, texture, ((float)left + 0.5f * (float)edge) / SIZE, ((float)left + 0.5f * (float)edge) / SIZE,
                (float)level, got);
        shd_assert_close("bx", level, (double)got[0], sum[0], 1e-6, 1e-6);
        shd_assert_close("by", level, (double)got[1], sum[1], 1e-6, 1e-6);
        shd_assert_close("variance", level, variance_of(got), want, 2e-7, 1e-5);
        if (level == LEVELS) /* the variance of a uniform distribution on +-height */
            shd_assert_close("variance", 99, variance_of(got), (double)(height * height) / 3, 1e-6, 0.03);
    }
    shd_texture_release(texture);
    shd_context_release(context);
}

/* The fourth channel of levels of normals is the length of the mean normal. A trilinear lookup blends the lengths of
 * two levels. With gentle bumps the length gives the same variance as the moments. */
static void test_length(void **state)
{
    const shd_image normals = shd_test_image(SHD_FORMAT_RGBA32F, SIZE, SIZE, g_normals);
    const shd_image moments = shd_test_image(SHD_FORMAT_RGBA32F, SIZE, SIZE, g_moments);
    shd_context *context = NULL;
    shd_texture *by_length, *by_moments;
    int i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    bumpy(0.1f);
    shd_assert_ok(shd_mip_build_moments(context, &normals, &moments, NULL));
    by_moments = with_levels(context, g_moments, SHD_TEXEL_CONTENT_DATA);
    by_length = with_levels(context, g_normals, SHD_TEXEL_CONTENT_NORMAL);
    for (i = 0; i <= 4 * LEVELS; ++i) {
        const float lod = (float)i / 4, u = 0.375f, v = 0.75f;
        float lower[4], upper[4], got[4], m[4];
        look_up(context, by_length, u, v, floorf(lod), lower);
        look_up(context, by_length, u, v, ceilf(lod), upper);
        look_up(context, by_length, u, v, lod, got);
        shd_assert_close("length", (size_t)i, (double)got[3],
                         (double)lower[3] + (double)(lod - floorf(lod)) * ((double)upper[3] - (double)lower[3]), 1e-6,
                         0);
        assert_true(got[3] <= 1 && got[3] > 0.99f);
        if (lod == 0) assert_true(got[3] == 1);
        if (lod < 4) continue; /* only means of many texels, because the two lookups may cover different ones */
        look_up(context, by_moments, u, v, lod, m);
        /* Toksvig's variance is of directions; the variance of slopes is larger because of the mean slope of 1/4. */
        shd_assert_close("variance", (size_t)i, shd_ref_toksvig((double)got[3]), variance_of(m), 0, 0.15);
    }
    shd_texture_release(by_length);
    shd_texture_release(by_moments);
    shd_context_release(context);
}

/* Lengths in eight bits: codes 0..255 represent components -1..1 and lengths 0..1. */
static void test_length_in_codes(void **state)
{
    static unsigned char codes[LEVELS + 1][SIZE * SIZE * 4];
    shd_image images[LEVELS + 1];
    shd_mip_desc mip = shd_mip_desc_default();
    shd_texture_desc desc = shd_texture_desc_default();
    shd_context *context = NULL;
    shd_texture *by_length, *by_codes = NULL;
    uint32_t i, l;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    bumpy(1);
    for (i = 0; i < SIZE * SIZE * 4; ++i) {
        codes[0][i] = (unsigned char)(i % 4 == 3 ? 255 : (g_normals[i] + 1) / 2 * 255 + 0.5f);
    }
    for (l = 0; l <= LEVELS; ++l) images[l] = shd_test_image(SHD_FORMAT_RGBA8, SIZE >> l, SIZE >> l, codes[l]);
    mip.content = SHD_TEXEL_CONTENT_NORMAL;
    shd_assert_ok(shd_mip_build(context, &images[0], &mip, LEVELS, images + 1));
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = desc.height = SIZE;
    desc.texels = codes[0];
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = images + 1;
    desc.level_count = LEVELS;
    shd_assert_ok(shd_texture_create(context, &desc, &by_codes));
    by_length = with_levels(context, g_normals, SHD_TEXEL_CONTENT_NORMAL);
    for (i = 0; i <= 4 * LEVELS; ++i) {
        float got[4], want[4];
        int c;
        look_up(context, by_codes, 0.375f, 0.75f, (float)i / 4, got);
        look_up(context, by_length, 0.375f, 0.75f, (float)i / 4, want);
        for (c = 0; c < 4; ++c) {
            const double value = c == 3 ? (double)got[c] : 2 * (double)got[c] - 1;
            shd_assert_close("channel", (size_t)c, value, (double)want[c], 0.01, 0);
        }
        if (i > 8) assert_true(got[3] < 0.95f && got[3] > 0.7f);
    }
    shd_texture_release(by_length);
    shd_texture_release(by_codes);
    shd_context_release(context);
}

/* The result has the same bits for any number of workers. */
static void test_workers(void **state)
{
    static uint16_t out[SIZE * SIZE * 4];
    const shd_image normals = shd_test_image(SHD_FORMAT_RGBA32F, SIZE, SIZE, g_normals);
    const shd_image moments = shd_test_image(SHD_FORMAT_RGBA16F, SIZE, SIZE, out);
    uint64_t want = 0;
    uint32_t workers;
    (void)state;
    bumpy(3);
    for (workers = 1; workers <= 16; workers *= 4) {
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = NULL;
        uint64_t hash;
        desc.worker_count = workers;
        shd_assert_ok(shd_context_create(&desc, &context));
        shd_assert_ok(shd_mip_build_moments(context, &normals, &moments, NULL));
        hash = shd_hash(SHD_HASH_START, out, sizeof out);
        if (workers > 1) assert_true(hash == want);
        want = hash;
        shd_context_release(context);
    }
}

/* ---- refusals ---- */

struct bad_case {
    const char *name;
    shd_format format, out;
    uint32_t width, height;
    const char *message;
};
static const struct bad_case k_bad[] = {
    {"refused/two_channels", SHD_FORMAT_RG8, SHD_FORMAT_RGBA32F, 4, 4, "normals.format: normals need 3 or 4 channels"},
    {"refused/one_channel", SHD_FORMAT_R32F, SHD_FORMAT_RGBA32F, 4, 4, "normals.format: normals need 3 or 4 channels"},
    {"refused/no_format", (shd_format)99, SHD_FORMAT_RGBA32F, 4, 4, "normals.format: 99 is not a format"},
    {"refused/out_rgba8", SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8, 4, 4, "out.format: 2 is neither RGBA16F nor RGBA32F"},
    {"refused/out_rgb32f", SHD_FORMAT_RGB8, SHD_FORMAT_RGB32F, 4, 4, "out.format: 20 is neither RGBA16F nor RGBA32F"},
    {"refused/width", SHD_FORMAT_RGB8, SHD_FORMAT_RGBA32F, 3, 4, "out.width: 3 is not in 4..4"},
    {"refused/height", SHD_FORMAT_RGB8, SHD_FORMAT_RGBA32F, 4, 5, "out.height: 5 is not in 4..4"},
    {"refused/no_width", SHD_FORMAT_RGB8, SHD_FORMAT_RGBA32F, 0, 4, "out.width: 0"},
};

static void test_bad(void **state)
{
    const struct bad_case *c = (const struct bad_case *)*state;
    static float in[64], out[64];
    const shd_image normals = shd_test_image(c->format, 4, 4, in),
                    moments = shd_test_image(c->out, c->width, c->height, out);
    shd_context *context = NULL;
    shd_assert_ok(shd_context_create(NULL, &context));
    out[0] = 7;
    shd_assert_result(c->name, shd_mip_build_moments(context, &normals, &moments, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      c->message);
    assert_true(out[0] == 7);
    shd_context_release(context);
}

static void test_bad_arguments(void **state)
{
    static float in[64], out[64], product[64];
    const shd_image normals = shd_test_image(SHD_FORMAT_RGBA32F, 4, 4, in);
    shd_image moments = shd_test_image(SHD_FORMAT_RGBA32F, 4, 4, out);
    shd_context *context = NULL;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_result("context", shd_mip_build_moments(NULL, &normals, &moments, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "context: ");
    shd_assert_result("normals", shd_mip_build_moments(context, NULL, &moments, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "normals: NULL");
    shd_assert_result("out", shd_mip_build_moments(context, &normals, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out: NULL");
    moments.pixels = NULL;
    shd_assert_result("pixels", shd_mip_build_moments(context, &normals, &moments, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out.pixels: NULL");
    moments.pixels = (char *)out + 2;
    shd_assert_result("aligned", shd_mip_build_moments(context, &normals, &moments, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out.pixels: ");
    moments.pixels = normals.pixels;
    shd_assert_result("overlap", shd_mip_build_moments(context, &normals, &moments, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out.pixels: overlaps normals.pixels");
    moments.pixels = out;
    moments.row_stride = 60;
    shd_assert_result("stride", shd_mip_build_moments(context, &normals, &moments, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out.row_stride: 60 is below 64");
    moments.row_stride = 0;
    {
        shd_image mixed = shd_test_image(SHD_FORMAT_RGBA32F, 4, 4, product);
        shd_assert_result("mixed.format", shd_mip_build_moments(context, &normals, &moments, &mixed),
                          SHD_ERROR_INVALID_ARGUMENT, "mixed.format: 5 is neither R16F nor R32F");
        mixed.format = SHD_FORMAT_R32F;
        mixed.width = 3;
        shd_assert_result("mixed.width", shd_mip_build_moments(context, &normals, &moments, &mixed),
                          SHD_ERROR_INVALID_ARGUMENT, "mixed.width: 3 is not in 4..4");
        mixed.width = 4;
        mixed.pixels = out;
        shd_assert_result("mixed", shd_mip_build_moments(context, &normals, &moments, &mixed),
                          SHD_ERROR_INVALID_ARGUMENT, "mixed.pixels: overlaps out.pixels");
        mixed.pixels = in;
        shd_assert_result("mixed", shd_mip_build_moments(context, &normals, &moments, &mixed),
                          SHD_ERROR_INVALID_ARGUMENT, "mixed.pixels: overlaps normals.pixels");
        mixed.pixels = NULL;
        shd_assert_result("mixed", shd_mip_build_moments(context, &normals, &moments, &mixed),
                          SHD_ERROR_INVALID_ARGUMENT, "mixed.pixels: NULL");
    }
    shd_context_release(context);
}

int main(void)
{
    static const int k_heights[] = {0, 5, 30, 100};
    static struct CMUnitTest tests[40];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_formats / sizeof k_formats[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_formats[i].name, test_format, NULL, NULL, (void *)&k_formats[i]};
    }
    for (i = 0; i < sizeof k_bad / sizeof k_bad[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_bad[i].name, test_bad, NULL, NULL, (void *)&k_bad[i]};
    }
    tests[n++] = (struct CMUnitTest){"refused/arguments", test_bad_arguments, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"special", test_special, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"variance/flat", test_variance, NULL, NULL, (void *)&k_heights[0]};
    tests[n++] = (struct CMUnitTest){"variance/gentle", test_variance, NULL, NULL, (void *)&k_heights[1]};
    tests[n++] = (struct CMUnitTest){"variance/bumpy", test_variance, NULL, NULL, (void *)&k_heights[2]};
    tests[n++] = (struct CMUnitTest){"variance/steep", test_variance, NULL, NULL, (void *)&k_heights[3]};
    tests[n++] = (struct CMUnitTest){"length_of_mean", test_length, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"length_of_mean/rgba8", test_length_in_codes, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"workers", test_workers, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.normal_moments", tests, n, NULL, NULL);
}
