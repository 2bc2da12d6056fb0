/* SPDX-License-Identifier: MIT */
/* Borrowed base levels: refusals; nothing is copied, and all functions read the caller's memory. */
#include "support/check.h"

#include <stdlib.h>

#include <shd/shd.h>

enum { WIDTH = 12, HEIGHT = 5, SIZE = WIDTH * HEIGHT * 4, MAX_TAPS = 256 };

/* Aligned for every format. */
static uint64_t g_memory[(SIZE * 4 + SHD_TEXTURE_PADDING) / 8 + 1];
static unsigned char *const k_texels = (unsigned char *)g_memory;
static shd_context *g_context;

static int setup(void **state)
{
    size_t i;
    (void)state;
    for (i = 0; i < sizeof g_memory; ++i) k_texels[i] = (unsigned char)(i * 37 + i / 50);
    return shd_context_create(NULL, &g_context) == SHD_OK ? 0 : -1;
}
static int teardown(void **state)
{
    (void)state;
    shd_context_release(g_context);
    return 0;
}

static shd_texture_desc borrowing(void)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.texels = k_texels;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP;
    desc.flags |= SHD_TEXTURE_BORROW;
    return desc;
}

static void edit_nothing(shd_texture_desc *d) { (void)d; }
static void edit_unknown(shd_texture_desc *d) { d->flags = 9; }
static void edit_premultiplied(shd_texture_desc *d) { d->flags |= SHD_TEXTURE_PREMULTIPLIED; }
static void edit_packed(shd_texture_desc *d) { d->row_stride = WIDTH * 4; }
static void edit_stride(shd_texture_desc *d) { d->row_stride = WIDTH * 4 + 4; }
static void edit_layers(shd_texture_desc *d)
{
    d->layer_count = 2;
    d->height = 2;
}
static void edit_three(shd_texture_desc *d) { d->format = SHD_FORMAT_RGB8; }
static void edit_words_odd(shd_texture_desc *d) { d->texels = k_texels + 2; }
static void edit_pairs_odd(shd_texture_desc *d)
{
    d->format = SHD_FORMAT_RG8;
    d->texels = k_texels + 1;
}
static void edit_bytes_odd(shd_texture_desc *d)
{
    d->format = SHD_FORMAT_R8;
    d->texels = k_texels + 3;
}
static void edit_halves(shd_texture_desc *d)
{
    d->format = SHD_FORMAT_RGBA16F;
    d->texels = k_texels + 4;
}
static void edit_null(shd_texture_desc *d) { d->texels = NULL; }

static const struct create_case {
    const char *name;
    void (*edit)(shd_texture_desc *desc);
    const char *message; /* NULL = accepted */
} k_create[] = {
    {"create/rgba8", edit_nothing, NULL},
    {"create/packed_stride", edit_packed, NULL},
    {"create/bytes_anywhere", edit_bytes_odd, NULL},
    {"create/8_byte_texels_aligned_to_4", edit_halves, NULL},
    {"create/premultiplied", edit_premultiplied, NULL},
    {"create/flags_9", edit_unknown, "texture.flags: bits 0x8 are not known"},
    {"create/gaps_between_rows", edit_stride, "texture.flags: SHD_TEXTURE_BORROW, but texture.row_stride 52, not 48"},
    {"create/two_layers", edit_layers, "texture.flags: SHD_TEXTURE_BORROW, but 2 layers, not 1"},
    {"create/three_channels", edit_three, "texture.flags: SHD_TEXTURE_BORROW, but format 8 has three channels"},
    {"create/rgba8_aligned_to_2", edit_words_odd,
     "texture.flags: SHD_TEXTURE_BORROW, but texture.texels not aligned to 4 bytes"},
    {"create/rg8_aligned_to_1", edit_pairs_odd,
     "texture.flags: SHD_TEXTURE_BORROW, but texture.texels not aligned to 2 bytes"},
    {"create/null_texels", edit_null, "texture.texels: NULL"},
};

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_texture_desc desc = borrowing();
    shd_texture *texture = (shd_texture *)&desc;
    shd_result expected = c->message ? SHD_ERROR_INVALID_ARGUMENT : SHD_OK;
    c->edit(&desc);
    if (desc.flags & 8) expected = SHD_ERROR_UNSUPPORTED;
    shd_assert_result(c->name, shd_texture_create(g_context, &desc, &texture), expected, c->message ? c->message : "");
    if (c->message) assert_null(texture);
    shd_texture_release(texture);
}

/* Only the tables take memory. */
static void test_byte_size(void **state)
{
    shd_texture_desc desc = borrowing();
    shd_texture_info info = shd_texture_info_default();
    shd_texture *texture = NULL;
    (void)state;
    desc.tables = SHD_TABLE_NONE;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.byte_size, 0);
    shd_texture_release(texture);
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.byte_size, 4 * (6 * 2 + 3 + 1));
    shd_texture_release(texture);
}

static void read_red(const shd_texture *texture, shd_filter filter, shd_magnification magnification, float u, float v,
                     float *red)
{
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_sampler *sampler = NULL;
    shd_texels out;
    memset(&out, 0, sizeof out);
    sd.filter = filter;
    sd.magnification = magnification;
    shd_assert_ok(shd_sampler_create(g_context, &sd, &sampler));
    lookups.count = 1;
    lookups.u.data = &u;
    lookups.v.data = &v;
    out.channel[0].data = red;
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &out));
    shd_sampler_release(sampler);
}

/* Lookups, levels and explanations read the caller's texels, also after an update. */
static void test_reads(void **state)
{
    shd_texture_desc desc = borrowing();
    shd_texture *texture = NULL;
    unsigned char level[SIZE], want[SIZE];
    shd_image image = shd_image_default();
    float red = 0;
    (void)state;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    image.format = SHD_FORMAT_RGBA8;
    image.width = WIDTH;
    image.height = HEIGHT;
    image.pixels = level;
    shd_assert_ok(shd_texture_read_level(texture, 0, 0, &image));
    assert_memory_equal(level, k_texels, SIZE);

    k_texels[4 * (2 * WIDTH + 7)] ^= 0x80;
    image.width = image.height = 1;
    shd_assert_result("pixels", shd_texture_update(texture, 0, 7, 2, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "texels.pixels: not NULL, but the base level is borrowed");
    image.pixels = NULL;
    image.width = 6;
    shd_assert_result("width", shd_texture_update(texture, 0, 7, 2, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "texels.width: 6 is not in 1..5");
    shd_assert_result("null", shd_texture_update(texture, 0, 7, 2, NULL), SHD_ERROR_INVALID_ARGUMENT, "texels: NULL");
    image.width = 1;
    shd_assert_ok(shd_texture_update(texture, 0, 7, 2, &image));
    read_red(texture, SHD_FILTER_NEAREST, SHD_MAGNIFICATION_DEFAULT, 7.5f / WIDTH, 2.5f / HEIGHT, &red);
    shd_assert_close("nearest", 0, (double)red, k_texels[4 * (2 * WIDTH + 7)] / 255.0, 1e-7, 0);
    read_red(texture, SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_BILINEAR, 7.5f / WIDTH, 2.5f / HEIGHT, &red);
    shd_assert_close("bilinear", 0, (double)red, k_texels[4 * (2 * WIDTH + 7)] / 255.0, 1e-7, 0);

    /* The levels equal the levels of a texture that copied the changed texels. */
    {
        shd_texture *copy = NULL;
        desc.flags = 0;
        shd_assert_ok(shd_texture_create(g_context, &desc, &copy));
        image.width = WIDTH / 2;
        image.height = HEIGHT / 2;
        image.pixels = level;
        shd_assert_ok(shd_texture_read_level(texture, 0, 1, &image));
        image.pixels = want;
        shd_assert_ok(shd_texture_read_level(copy, 0, 1, &image));
        assert_memory_equal(level, want, 4 * (WIDTH / 2) * (HEIGHT / 2));
        shd_texture_release(copy);
    }
    shd_texture_release(texture);
}

/* Taps of the base and of levels, by every filter that can be explained. */
static void test_explain(void **state)
{
    static const shd_filter filters[] = {SHD_FILTER_NEAREST,   SHD_FILTER_BILINEAR, SHD_FILTER_BICUBIC,
                                         SHD_FILTER_TRILINEAR, SHD_FILTER_RIPMAP,   SHD_FILTER_ANISOTROPIC};
    static shd_tap taps[2][MAX_TAPS];
    static shd_blend_step blends[2][MAX_TAPS];
    shd_texture_desc desc = borrowing();
    shd_texture *texture[2] = {NULL, NULL};
    const float u = 0.63f, v = 0.41f, dudx = 1.6f / WIDTH, dvdy = 1.3f / HEIGHT, zero = 0;
    shd_lookups lookups = shd_lookups_default();
    size_t k, i;
    (void)state;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture[0]));
    desc.flags = 0;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture[1]));
    lookups.count = 1;
    lookups.u.data = &u;
    lookups.v.data = &v;
    lookups.dudx.data = &dudx;
    lookups.dvdx.data = &zero;
    lookups.dudy.data = &zero;
    lookups.dvdy.data = &dvdy;
    for (k = 0; k < sizeof filters / sizeof filters[0]; ++k) {
        shd_sampler_desc sd = shd_sampler_desc_default();
        shd_sampler *sampler = NULL;
        shd_explanation e[2];
        sd.filter = filters[k];
        shd_assert_ok(shd_sampler_create(g_context, &sd, &sampler));
        memset(taps, 0, sizeof taps);
        for (i = 0; i < 2; ++i) {
            e[i] = shd_explanation_default();
            e[i].taps = taps[i];
            e[i].blends = blends[i];
            e[i].tap_capacity = e[i].blend_capacity = MAX_TAPS;
            shd_assert_ok(shd_texture_explain(texture[i], sampler, &lookups, 0, &e[i]));
        }
        assert_int_equal(e[0].tap_count, e[1].tap_count);
        assert_memory_equal(taps[0], taps[1], sizeof taps[0]);
        assert_memory_equal(e[0].result, e[1].result, sizeof e[0].result);
        shd_sampler_release(sampler);
    }
    shd_texture_release(texture[0]);
    shd_texture_release(texture[1]);
}

int main(void)
{
    struct CMUnitTest tests[32];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_create / sizeof k_create[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    tests[n++] = (struct CMUnitTest){"byte_size", test_byte_size, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"reads", test_reads, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"explain", test_explain, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.texture_borrow", tests, n, setup, teardown);
}
