/* SPDX-License-Identifier: MIT */
/* Arrays of textures, formats of one to four channels, swizzles and fills: every texel through shd_texture_sample. */
#include "support/check.h"

#include <stdlib.h>

#include <shd/shd.h>

enum { WIDTH = 5, HEIGHT = 3, LAYERS = 4, TEXELS = WIDTH * HEIGHT };

static shd_context *g_context;
static float g_u[TEXELS * LAYERS], g_v[TEXELS * LAYERS], g_out[4][TEXELS * LAYERS];
static uint32_t g_layer[TEXELS * LAYERS];

static int setup(void **state)
{
    uint32_t i;
    (void)state;
    for (i = 0; i < TEXELS * LAYERS; ++i) {
        g_u[i] = ((float)(i % WIDTH) + 0.5f) / WIDTH;
        g_v[i] = ((float)(i / WIDTH % HEIGHT) + 0.5f) / HEIGHT;
        g_layer[i] = i / TEXELS;
    }
    return shd_context_create(NULL, &g_context) == SHD_OK ? 0 : -1;
}
static int teardown(void **state)
{
    (void)state;
    shd_context_release(g_context);
    return 0;
}

enum kind { UNORM8, SRGB8, UNORM16, HALF, FLOAT };
struct format_case {
    const char *name;
    shd_format format, stored;
    int channels;
    enum kind kind;
};
static const struct format_case k_formats[] = {
    {"r8", SHD_FORMAT_R8, SHD_FORMAT_R8, 1, UNORM8},
    {"rg8", SHD_FORMAT_RG8, SHD_FORMAT_RG8, 2, UNORM8},
    {"rgb8", SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8, 3, UNORM8},
    {"rgba8", SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8, 4, UNORM8},
    {"r8_srgb", SHD_FORMAT_R8_SRGB, SHD_FORMAT_R8_SRGB, 1, SRGB8},
    {"rg8_srgb", SHD_FORMAT_RG8_SRGB, SHD_FORMAT_RG8_SRGB, 2, SRGB8},
    {"rgb8_srgb", SHD_FORMAT_RGB8_SRGB, SHD_FORMAT_RGBA8_SRGB, 3, SRGB8},
    {"rgba8_srgb", SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA8_SRGB, 4, SRGB8},
    {"r16", SHD_FORMAT_R16, SHD_FORMAT_R16, 1, UNORM16},
    {"rg16", SHD_FORMAT_RG16, SHD_FORMAT_RG16, 2, UNORM16},
    {"rgb16", SHD_FORMAT_RGB16, SHD_FORMAT_RGBA16, 3, UNORM16},
    {"rgba16", SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA16, 4, UNORM16},
    {"r16f", SHD_FORMAT_R16F, SHD_FORMAT_R16F, 1, HALF},
    {"rg16f", SHD_FORMAT_RG16F, SHD_FORMAT_RG16F, 2, HALF},
    {"rgb16f", SHD_FORMAT_RGB16F, SHD_FORMAT_RGBA16F, 3, HALF},
    {"rgba16f", SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA16F, 4, HALF},
    {"r32f", SHD_FORMAT_R32F, SHD_FORMAT_R32F, 1, FLOAT},
    {"rg32f", SHD_FORMAT_RG32F, SHD_FORMAT_RG32F, 2, FLOAT},
    {"rgb32f", SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F, 3, FLOAT},
    {"rgba32f", SHD_FORMAT_RGBA32F, SHD_FORMAT_RGBA32F, 4, FLOAT},
};

/** Writes channel k of the i-th texel and returns its linear value. */
static double put_channel(enum kind kind, unsigned char *texel, int k, uint32_t i)
{
    const unsigned char code = (unsigned char)(17 * i + 61 * (uint32_t)k);
    const uint16_t wide = (uint16_t)(i * 1009 + (uint32_t)k * 257),
                   half = (uint16_t)(0x3800 + 8 * i + 64 * (uint32_t)k);
    const float value = (float)i - 10.0f * (float)k;
    const double encoded = code / 255.0;
    switch (kind) {
        case UNORM8: texel[k] = code; return encoded;
        case SRGB8:
            texel[k] = code;
            if (k == 3) return encoded;
            return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
        case UNORM16: memcpy(texel + 2 * k, &wide, 2); return wide / 65535.0;
        case HALF: memcpy(texel + 2 * k, &half, 2); return ldexp(1024 + half % 1024, half / 1024 - 25);
        default: memcpy(texel + 4 * k, &value, 4); return (double)value;
    }
}

static void sample(const shd_texture *texture, const uint32_t *layers)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_sampler *sampler = NULL;
    shd_texels out;
    int k;
    desc.filter = SHD_FILTER_BILINEAR;
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    lookups.count = TEXELS * LAYERS;
    lookups.u.data = g_u;
    lookups.v.data = g_v;
    lookups.layer.data = layers;
    memset(&out, 0, sizeof out);
    for (k = 0; k < 4; ++k) out.channel[k].data = g_out[k];
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &out));
    shd_sampler_release(sampler);
}

/** All layers of a format with gaps between rows and layers; missing channels read the fill. */
static void test_format(void **state)
{
    const struct format_case *c = (const struct format_case *)*state;
    const float fill[4] = {9, 8, 7, 6};
    const size_t texel = shd_format_size(c->format), row = texel * (WIDTH + 2), layer = row * HEIGHT + 4 * texel;
    unsigned char *texels = (unsigned char *)calloc(LAYERS, layer);
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture_info info = shd_texture_info_default();
    shd_texture *texture = NULL;
    uint32_t i;
    int k;
    static double want[4][TEXELS * LAYERS];
    for (i = 0; i < TEXELS * LAYERS; ++i) {
        unsigned char *at = texels + i / TEXELS * layer + i / WIDTH % HEIGHT * row + i % WIDTH * texel;
        for (k = 0; k < 4; ++k) {
            want[k][i] = k < c->channels ? put_channel(c->kind, at, k, i) : (double)fill[k];
        }
    }
    desc.format = c->format;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.layer_count = LAYERS;
    desc.row_stride = row;
    desc.layer_stride = layer;
    desc.texels = texels;
    memcpy(desc.fill, fill, sizeof fill);
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    free(texels);
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.format, c->stored);
    assert_int_equal(info.layer_count, LAYERS);
    assert_int_equal(info.byte_size, TEXELS * LAYERS * shd_format_size(c->stored));
    sample(texture, g_layer);
    for (i = 0; i < TEXELS * LAYERS; ++i) {
        for (k = 0; k < 4; ++k) shd_assert_close(c->name, i, (double)g_out[k][i], want[k][i], 1e-6, 2e-6);
    }
    shd_texture_release(texture);
}

/** Layer numbers beyond the last read the last layer; without a column the first layer is read. */
static void test_layers(void **state)
{
    unsigned char texels[TEXELS * LAYERS];
    uint32_t layers[TEXELS * LAYERS];
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    uint32_t i;
    (void)state;
    for (i = 0; i < TEXELS * LAYERS; ++i) {
        texels[i] = (unsigned char)(51 * (i / TEXELS));
        layers[i] = i % 3 == 0 ? UINT32_MAX : i % 3 == 1 ? LAYERS : LAYERS - 2;
    }
    desc.format = SHD_FORMAT_R8;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.layer_count = LAYERS;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    sample(texture, layers);
    for (i = 0; i < TEXELS * LAYERS; ++i) assert_true(g_out[0][i] == (i % 3 == 2 ? 0.4f : 0.6f));
    sample(texture, NULL);
    for (i = 0; i < TEXELS * LAYERS; ++i) assert_true(g_out[0][i] == 0.0f);
    shd_texture_release(texture);
}

struct swizzle_case {
    const char *name;
    shd_format format;
    shd_channel swizzle[4];
    float want[4]; /**< expected for the texel 51, 102, 153, 204 and the fill 5, 6, 7, 8 */
};
static const struct swizzle_case k_swizzles[] = {
    {"swizzle/default", SHD_FORMAT_RGBA8, {SHD_CHANNEL_DEFAULT}, {0.2f, 0.4f, 0.6f, 0.8f}},
    {"swizzle/grey",
     SHD_FORMAT_R8,
     {SHD_CHANNEL_R, SHD_CHANNEL_R, SHD_CHANNEL_R, SHD_CHANNEL_FILL},
     {0.2f, 0.2f, 0.2f, 8}},
    {"swizzle/bgra",
     SHD_FORMAT_RGBA8,
     {SHD_CHANNEL_B, SHD_CHANNEL_G, SHD_CHANNEL_R, SHD_CHANNEL_A},
     {0.6f, 0.4f, 0.2f, 0.8f}},
    {"swizzle/alpha_everywhere",
     SHD_FORMAT_RGBA8,
     {SHD_CHANNEL_A, SHD_CHANNEL_A, SHD_CHANNEL_A, SHD_CHANNEL_A},
     {0.8f, 0.8f, 0.8f, 0.8f}},
    {"swizzle/missing_alpha",
     SHD_FORMAT_RG8,
     {SHD_CHANNEL_A, SHD_CHANNEL_R, SHD_CHANNEL_DEFAULT, SHD_CHANNEL_G},
     {5, 0.2f, 7, 0.4f}},
    {"swizzle/all_filled",
     SHD_FORMAT_RGBA8,
     {SHD_CHANNEL_FILL, SHD_CHANNEL_FILL, SHD_CHANNEL_FILL, SHD_CHANNEL_FILL},
     {5, 6, 7, 8}},
    {"swizzle/alpha_of_rgb",
     SHD_FORMAT_RGB8,
     {SHD_CHANNEL_DEFAULT, SHD_CHANNEL_A, SHD_CHANNEL_B, SHD_CHANNEL_DEFAULT},
     {0.2f, 6, 0.6f, 8}},
};

static void test_swizzle(void **state)
{
    const struct swizzle_case *c = (const struct swizzle_case *)*state;
    const unsigned char texel[4] = {51, 102, 153, 204};
    const float fill[4] = {5, 6, 7, 8};
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    int i, k;
    desc.format = c->format;
    desc.width = desc.height = 1;
    desc.texels = texel;
    memcpy(desc.swizzle, c->swizzle, sizeof desc.swizzle);
    memcpy(desc.fill, fill, sizeof fill);
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    sample(texture, NULL);
    for (k = 0; k < 4; ++k) {
        for (i = 0; i < TEXELS * LAYERS; ++i) assert_true(g_out[k][i] == c->want[k]);
    }
    shd_texture_release(texture);
}

int main(void)
{
    struct CMUnitTest tests[32];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_formats / sizeof k_formats[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_formats[i].name, test_format, NULL, NULL, (void *)&k_formats[i]};
    }
    for (i = 0; i < sizeof k_swizzles / sizeof k_swizzles[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_swizzles[i].name, test_swizzle, NULL, NULL, (void *)&k_swizzles[i]};
    }
    tests[n++] = (struct CMUnitTest){"layers", test_layers, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.texture_array", tests, n, setup, teardown);
}
