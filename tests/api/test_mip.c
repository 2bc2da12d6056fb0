/* SPDX-License-Identifier: MIT */
/* Arguments of shd_mip_build(), and textures made from the caller's own levels. */
#include "support/fault_allocator.h"

#include <shd/shd.h>

enum { WIDTH = 8, HEIGHT = 4, LEVELS = 3 };

/** Valid arguments, of which each case makes one invalid. */
struct arguments {
    shd_image base, levels[LEVELS];
    shd_mip_desc desc;
    uint32_t level_count;
    uint64_t pixels[LEVELS + 1][64];
};

static void set_up(struct arguments *a)
{
    uint32_t l;
    memset(a, 0, sizeof *a);
    for (l = 0; l <= LEVELS; ++l) {
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGBA8;
        image.width = WIDTH >> l;
        image.height = HEIGHT >> l ? HEIGHT >> l : 1;
        image.pixels = a->pixels[l];
        memset(a->pixels[l], (int)(10 + 40 * l), sizeof a->pixels[l]);
        if (l == 0) {
            a->base = image;
        } else {
            a->levels[l - 1] = image;
        }
    }
    a->desc = shd_mip_desc_default();
    a->level_count = LEVELS;
}

struct mip_case {
    const char *name;
    void (*edit)(struct arguments *a);
    shd_result expected;
    const char *message;
};

static void set_formats(struct arguments *a, shd_format format)
{
    int l;
    a->base.format = format;
    for (l = 0; l < LEVELS; ++l) a->levels[l].format = format;
}
static void edit_nothing(struct arguments *a) { (void)a; }
static void edit_no_levels(struct arguments *a) { a->level_count = 0; }
static void edit_two(struct arguments *a) { a->level_count = 2; }
static void edit_four(struct arguments *a) { a->level_count = 4; }
static void edit_base_size(struct arguments *a) { a->base.struct_size = 0; }
static void edit_base_format(struct arguments *a) { a->base.format = (shd_format)77; }
static void edit_base_null(struct arguments *a) { a->base.pixels = NULL; }
static void edit_base_huge(struct arguments *a) { a->base.width = a->base.height = 65536; }
static void edit_size(struct arguments *a) { a->desc.struct_size = 4; }
static void edit_kernel(struct arguments *a) { a->desc.kernel = (shd_mip_kernel)4; }
static void edit_source(struct arguments *a) { a->desc.source = (shd_mip_source)2; }
static void edit_content(struct arguments *a) { a->desc.content = (shd_texel_content)6; }
static void edit_wrap_u(struct arguments *a) { a->desc.wrap_u = (shd_wrap)5; }
static void edit_wrap_v(struct arguments *a) { a->desc.wrap_v = (shd_wrap)-1; }
static void edit_cutoff(struct arguments *a) { a->desc.alpha_cutoff = 1.5f; }
static void edit_cutoff_nan(struct arguments *a) { a->desc.alpha_cutoff = NAN; }
static void edit_normal_rg(struct arguments *a)
{
    set_formats(a, SHD_FORMAT_RG8);
    a->desc.content = SHD_TEXEL_CONTENT_NORMAL;
}
static void edit_coverage_rgb(struct arguments *a)
{
    set_formats(a, SHD_FORMAT_RGB8);
    a->desc.content = SHD_TEXEL_CONTENT_ALPHA_COVERAGE;
}
static void edit_level_format(struct arguments *a) { a->levels[1].format = SHD_FORMAT_RGBA8_SRGB; }
static void edit_level_width(struct arguments *a) { a->levels[1].width = 3; }
static void edit_level_height(struct arguments *a) { a->levels[2].height = 2; }
static void edit_level_null(struct arguments *a) { a->levels[2].pixels = NULL; }
static void edit_level_stride(struct arguments *a) { a->levels[0].row_stride = 15; }
static void edit_level_in_base(struct arguments *a) { a->levels[1].pixels = (char *)a->base.pixels + 4; }
static void edit_level_twice(struct arguments *a) { a->levels[2].pixels = (char *)a->levels[0].pixels + 12; }

static const struct mip_case k_cases[] = {
    {"defaults", edit_nothing, SHD_OK, ""},
    {"no_levels", edit_no_levels, SHD_OK, ""},
    {"two_levels", edit_two, SHD_OK, ""},
    {"four_levels", edit_four, SHD_ERROR_INVALID_ARGUMENT, "level_count: 4 is not in 0..3"},
    {"base_struct_size", edit_base_size, SHD_ERROR_INVALID_ARGUMENT, "base.struct_size: 0"},
    {"base_format", edit_base_format, SHD_ERROR_INVALID_ARGUMENT, "base.format: 77 is not a format"},
    {"base_pixels", edit_base_null, SHD_ERROR_INVALID_ARGUMENT, "base.pixels: NULL"},
    {"base_2^32_pixels", edit_base_huge, SHD_ERROR_INVALID_ARGUMENT, "base.width * base.height: 4294967296"},
    {"struct_size", edit_size, SHD_ERROR_INVALID_ARGUMENT, "mip.struct_size: 4"},
    {"kernel", edit_kernel, SHD_ERROR_INVALID_ARGUMENT, "mip.kernel: 4 is not in 0..3"},
    {"source", edit_source, SHD_ERROR_INVALID_ARGUMENT, "mip.source: 2 is not in 0..1"},
    {"content", edit_content, SHD_ERROR_INVALID_ARGUMENT, "mip.content: 6 is not in 0..5"},
    {"wrap_u", edit_wrap_u, SHD_ERROR_INVALID_ARGUMENT, "mip.wrap_u: 5 is not in 0..4"},
    {"wrap_v", edit_wrap_v, SHD_ERROR_INVALID_ARGUMENT, "mip.wrap_v: 4294967295"},
    {"cutoff_1.5", edit_cutoff, SHD_ERROR_INVALID_ARGUMENT, "mip.alpha_cutoff: 1.5 is not in 0..1"},
    {"cutoff_nan", edit_cutoff_nan, SHD_ERROR_INVALID_ARGUMENT, "mip.alpha_cutoff: nan"},
    {"normals_of_2_channels", edit_normal_rg, SHD_ERROR_INVALID_ARGUMENT, "mip.content: normals need 3 or 4"},
    {"coverage_of_3_channels", edit_coverage_rgb, SHD_ERROR_INVALID_ARGUMENT, "mip.content: alpha coverage needs 4"},
    {"level_format", edit_level_format, SHD_ERROR_INVALID_ARGUMENT, "levels[1].format: 3 is not the base's 2"},
    {"level_width", edit_level_width, SHD_ERROR_INVALID_ARGUMENT, "levels[1].width: 3 is not in 2..2"},
    {"level_height", edit_level_height, SHD_ERROR_INVALID_ARGUMENT, "levels[2].height: 2 is not in 1..1"},
    {"level_pixels", edit_level_null, SHD_ERROR_INVALID_ARGUMENT, "levels[2].pixels: NULL"},
    {"level_in_base", edit_level_in_base, SHD_ERROR_INVALID_ARGUMENT, "levels[1].pixels: overlaps base.pixels"},
    {"level_twice", edit_level_twice, SHD_ERROR_INVALID_ARGUMENT, "levels[2].pixels: overlaps levels[0].pixels"},
    {"level_stride", edit_level_stride, SHD_ERROR_INVALID_ARGUMENT, "levels[0].row_stride: 15 is below 16"},
};

static void test_case(void **state)
{
    const struct mip_case *c = (const struct mip_case *)*state;
    struct arguments a;
    uint64_t before[LEVELS + 1][64];
    shd_context *context = NULL;
    set_up(&a);
    memcpy(before, a.pixels, sizeof before);
    c->edit(&a);
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_result(c->name, shd_mip_build(context, &a.base, &a.desc, a.level_count, a.levels), c->expected,
                      c->message);
    if (c->expected == SHD_OK) {
        uint32_t l, i;
        for (l = 1; l <= a.level_count; ++l) {
            const size_t size = 4u * (WIDTH >> l) * (HEIGHT >> l ? HEIGHT >> l : 1);
            for (i = 0; i < size; ++i) assert_int_equal(((unsigned char *)a.pixels[l])[i], 10);
            assert_int_equal(((unsigned char *)a.pixels[l])[size], 10 + 40 * l);
        }
    } else {
        assert_memory_equal(a.pixels, before, sizeof before);
    }
    shd_context_release(context);
}

/* The second level lies to the right of the first in the rows of one picture: their rows alternate in memory and do
 * not overlap. */
static void test_beside(void **state)
{
    struct arguments a;
    shd_context *context = NULL;
    const unsigned char *first = (const unsigned char *)a.pixels[1];
    (void)state;
    set_up(&a);
    a.levels[0].row_stride = a.levels[1].row_stride = 4 * (size_t)(a.levels[0].width + a.levels[1].width);
    a.levels[1].pixels = (char *)a.levels[0].pixels + 4 * a.levels[0].width;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_mip_build(context, &a.base, &a.desc, 2, a.levels));
    assert_int_equal(first[0], 10);
    assert_int_equal(first[4 * a.levels[0].width], 10);
    a.levels[1].pixels = (char *)a.levels[1].pixels - 4;
    shd_assert_result("one pixel", shd_mip_build(context, &a.base, &a.desc, 2, a.levels), SHD_ERROR_INVALID_ARGUMENT,
                      "levels[1].pixels: overlaps levels[0].pixels");
    shd_context_release(context);
}

static void test_null(void **state)
{
    struct arguments a;
    shd_context *context = NULL;
    (void)state;
    set_up(&a);
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_result("context", shd_mip_build(NULL, &a.base, &a.desc, 1, a.levels), SHD_ERROR_INVALID_ARGUMENT,
                      "context: NULL");
    shd_assert_result("base", shd_mip_build(context, NULL, &a.desc, 1, a.levels), SHD_ERROR_INVALID_ARGUMENT,
                      "base: NULL");
    shd_assert_result("desc", shd_mip_build(context, &a.base, NULL, 1, a.levels), SHD_ERROR_INVALID_ARGUMENT,
                      "mip: NULL");
    shd_assert_result("levels", shd_mip_build(context, &a.base, &a.desc, 1, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "levels: NULL");
    shd_assert_ok(shd_mip_build(context, &a.base, &a.desc, 0, NULL));
    shd_context_release(context);
}

/** Every allocation fails in turn; nothing leaks and the next call works. */
static void test_allocation_faults(void **state)
{
    size_t n;
    (void)state;
    for (n = 0; n < 64; ++n) {
        shd_fault_allocator memory = {0};
        struct arguments a;
        shd_context_desc cd = shd_fault_context_desc(&memory);
        shd_context *context = NULL;
        shd_result result;
        set_up(&a);
        a.desc.kernel = SHD_MIP_KERNEL_KAISER;
        a.desc.content = SHD_TEXEL_CONTENT_ALPHA_COVERAGE;
        shd_assert_ok(shd_context_create(&cd, &context));
        shd_fault_arm(&memory, n + 1, 1);
        result = shd_mip_build(context, &a.base, &a.desc, LEVELS, a.levels);
        shd_fault_arm(&memory, 0, 0);
        if (result != SHD_OK) shd_assert_result("fault", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        shd_context_release(context);
        shd_assert_all_freed("allocation_faults", &memory);
        if (result == SHD_OK) break;
    }
    assert_true(n > 8 && n < 64);
}

struct extreme_case {
    const char *name;
    shd_format format;
    float negative, positive; /* alphas of the two texels of the level */
    float lowest;             /* finite number of the format */
};
static const struct extreme_case k_extremes[] = {
    {"coverage/lowest_alpha/32", SHD_FORMAT_RGBA32F, -1e38f, 1e-30f, -3.40282347e38f},
    {"coverage/lowest_alpha/16", SHD_FORMAT_RGBA16F, -32768, 0x1p-14f, -65504},
};

/** A tiny positive alpha is scaled to the cutoff; a negative one would leave the format and becomes its lowest. */
static void test_extreme_alpha(void **state)
{
    const struct extreme_case *c = (const struct extreme_case *)*state;
    const int wide = c->format == SHD_FORMAT_RGBA32F;
    float texels[4][4] = {{0}}, got[2];
    uint16_t halves[4][4] = {{0}}, level16[2][4];
    float level32[2][4];
    shd_image base = shd_image_default(), level = shd_image_default();
    shd_mip_desc desc = shd_mip_desc_default();
    shd_context *context = NULL;
    int i;
    for (i = 0; i < 4; ++i) {
        texels[i][3] = i < 2 ? c->negative : c->positive;
        halves[i][3] = i < 2 ? 0xf800 : 0x0400; /* -32768 and 2^-14 */
    }
    base.format = level.format = c->format;
    base.width = 4, level.width = 2;
    base.height = level.height = 1;
    base.pixels = wide ? (void *)texels : (void *)halves;
    level.pixels = wide ? (void *)level32 : (void *)level16;
    desc.content = SHD_TEXEL_CONTENT_ALPHA_COVERAGE;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_mip_build(context, &base, &desc, 1, &level));
    for (i = 0; i < 2; ++i) got[i] = wide ? level32[i][3] : level16[i][3] == 0xfbff ? -65504 : (float)level16[i][3];
    assert_true(got[0] == c->lowest);
    assert_true(wide ? got[1] > 0.49f && got[1] < 0.5f : level16[1][3] == 0x37ff); /* no texel of the base passes */
    shd_context_release(context);
}

struct texture_case {
    const char *name;
    shd_format format, stored;
    uint32_t level_count, layers;
};
static const struct texture_case k_textures[] = {
    {"given/all", SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8, 3, 1},
    {"given/one", SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8, 1, 1},
    {"given/three_channels", SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8, 3, 1},
    {"given/layers", SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA8_SRGB, 2, 3},
};

/** Level l of layer k is filled with 10 + 40 l + k. */
static void test_given_levels(void **state)
{
    const struct texture_case *c = (const struct texture_case *)*state;
    static unsigned char texels[3][LEVELS + 1][WIDTH * HEIGHT * 4], base[3][WIDTH * HEIGHT * 4];
    shd_image levels[9], out = shd_image_default();
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture_info info = shd_texture_info_default();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    unsigned char got[WIDTH * HEIGHT * 4];
    uint32_t k, l, i;
    desc.format = c->format;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.layer_count = c->layers;
    desc.layer_stride = sizeof base[0];
    desc.texels = base;
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = levels;
    desc.level_count = c->level_count;
    for (k = 0; k < 3; ++k) {
        memset(base[k], (int)(10 + k), sizeof base[k]);
        for (l = 1; l <= c->level_count; ++l) {
            shd_image image = shd_image_default();
            image.format = c->format;
            image.width = WIDTH >> l;
            image.height = HEIGHT >> l ? HEIGHT >> l : 1;
            image.pixels = texels[k][l];
            memset(texels[k][l], (int)(10 + 40 * l + k), sizeof texels[k][l]);
            if (k < c->layers) levels[k * c->level_count + l - 1] = image;
        }
    }
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    memset(texels, 0, sizeof texels); /* copied */
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.level_count, c->level_count + 1);
    for (k = 0; k < c->layers; ++k) {
        for (l = 0; l <= c->level_count; ++l) {
            out.format = c->stored;
            out.width = WIDTH >> l;
            out.height = HEIGHT >> l ? HEIGHT >> l : 1;
            out.pixels = got;
            shd_assert_ok(shd_texture_read_level(texture, k, l, &out));
            for (i = 0; i < out.width * out.height * 4; ++i) {
                if (c->format == SHD_FORMAT_RGB8 && i % 4 == 3) continue;
                assert_int_equal(got[i], 10 + 40 * l + k);
            }
        }
    }
    shd_texture_release(texture);
    shd_context_release(context);
}

/** A lookup beyond the last given level reads that level. */
static void test_given_lookup(void **state)
{
    struct arguments a;
    const float u = 0.5f, lod = 9;
    float red = -1;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels out = {0};
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    (void)state;
    set_up(&a);
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.texels = a.pixels[0];
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = a.levels;
    desc.level_count = 2;
    sampler_desc.filter = SHD_FILTER_TRILINEAR;
    lookups.count = 1;
    lookups.u.data = &u;
    lookups.v.data = &u;
    lookups.lod.data = &lod;
    out.channel[0].data = &red;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    shd_assert_ok(shd_sampler_create(context, &sampler_desc, &sampler));
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &out));
    shd_assert_close("red", 0, (double)red, 90 / 255.0, 1e-7, 0);
    shd_sampler_release(sampler);
    shd_texture_release(texture);
    shd_context_release(context);
}

static void refuse(const char *name, const struct arguments *a, uint32_t tables, uint32_t level_count,
                   const shd_image *levels, const char *message)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.texels = a->pixels[0];
    desc.tables = tables;
    desc.level_images = levels;
    desc.level_count = level_count;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_result(name, shd_texture_create(context, &desc, &texture), SHD_ERROR_INVALID_ARGUMENT, message);
    assert_null(texture);
    shd_context_release(context);
}

static void test_given_refused(void **state)
{
    struct arguments a;
    (void)state;
    set_up(&a);
    refuse("table", &a, 0, 1, a.levels, "texture.level_count: 1 without SHD_TABLE_MIPMAP");
    refuse("many", &a, SHD_TABLE_MIPMAP, 4, a.levels, "texture.level_count: 4 is not in 0..3");
    refuse("null", &a, SHD_TABLE_MIPMAP, 1, NULL, "texture.level_images: NULL");
    a.levels[2].width = 2;
    refuse("width", &a, SHD_TABLE_MIPMAP, 3, a.levels, "texture.level_images[2].width: 2 is not in 1..1");
    a.levels[1].format = SHD_FORMAT_R8;
    refuse("format", &a, SHD_TABLE_MIPMAP, 3, a.levels, "texture.level_images[1].format: 1 is not the base's 2");
    a.levels[0].pixels = NULL;
    refuse("pixels", &a, SHD_TABLE_MIPMAP, 3, a.levels, "texture.level_images[0].pixels: NULL");
}

int main(void)
{
    struct CMUnitTest tests[40];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_cases / sizeof k_cases[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_cases[i].name, test_case, NULL, NULL, (void *)&k_cases[i]};
    }
    for (i = 0; i < sizeof k_textures / sizeof k_textures[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_textures[i].name, test_given_levels, NULL, NULL, (void *)&k_textures[i]};
    }
    for (i = 0; i < sizeof k_extremes / sizeof k_extremes[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_extremes[i].name, test_extreme_alpha, NULL, NULL, (void *)&k_extremes[i]};
    }
    tests[n++] = (struct CMUnitTest){"levels_beside", test_beside, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"allocation_faults", test_allocation_faults, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"given/lookup", test_given_lookup, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"given/refused", test_given_refused, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.mip", tests, n, NULL, NULL);
}
