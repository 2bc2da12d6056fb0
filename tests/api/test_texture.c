/* SPDX-License-Identifier: MIT */
/* Textures: the range of every field, the info of the texture, reading levels back. */
#include "support/fault_allocator.h"

#include <stdlib.h>

#include <shd/shd.h>

static uint64_t k_texels[128]; /* 1 KB, aligned for every format */

struct create_case {
    const char *name;
    void (*edit)(shd_texture_desc *desc);
    shd_result expected;
    const char *message;
};

static void edit_nothing(shd_texture_desc *d) { (void)d; }
static void edit_mipmap(shd_texture_desc *d) { d->tables = SHD_TABLE_MIPMAP; }
static void edit_r8(shd_texture_desc *d) { d->format = SHD_FORMAT_R8; }
static void edit_srgb(shd_texture_desc *d) { d->format = SHD_FORMAT_RGBA8_SRGB; }
static void edit_half(shd_texture_desc *d) { d->format = SHD_FORMAT_RGBA16F; }
static void edit_float(shd_texture_desc *d) { d->format = SHD_FORMAT_RGBA32F; }
static void edit_stride(shd_texture_desc *d) { d->row_stride = 64; }
static void edit_size_zero(shd_texture_desc *d) { d->struct_size = 0; }
static void edit_size_small(shd_texture_desc *d) { d->struct_size = 8; }
static void edit_format_none(shd_texture_desc *d) { d->format = SHD_FORMAT_NONE; }
static void edit_format_unknown(shd_texture_desc *d) { d->format = (shd_format)99; }
static void edit_format_negative(shd_texture_desc *d) { d->format = (shd_format)-1; }
static void edit_layers(shd_texture_desc *d) { d->layer_count = 3; }
static void edit_layers_0(shd_texture_desc *d) { d->layer_count = 0; }
static void edit_layers_2049(shd_texture_desc *d) { d->layer_count = 2049; }
static void edit_layers_too_many(shd_texture_desc *d)
{
    d->width = d->height = 1024;
    d->layer_count = 257;
}
static void edit_layer_stride_small(shd_texture_desc *d) { d->layer_stride = 63; }
static void edit_layer_stride_odd(shd_texture_desc *d)
{
    d->format = SHD_FORMAT_R16;
    d->layer_stride = 65;
}
static void edit_layer_stride_huge(shd_texture_desc *d)
{
    d->layer_count = 3;
    d->layer_stride = SIZE_MAX / 2;
}
static void edit_swizzle(shd_texture_desc *d)
{
    d->swizzle[0] = SHD_CHANNEL_A;
    d->swizzle[3] = SHD_CHANNEL_FILL;
}
static void edit_swizzle_unknown(shd_texture_desc *d) { d->swizzle[2] = (shd_channel)6; }
static void edit_fill_infinite(shd_texture_desc *d) { d->fill[1] = INFINITY; }
static void edit_kind(shd_texture_desc *d) { d->kind = (shd_texture_kind)3; }
static void edit_depth(shd_texture_desc *d) { d->kind = SHD_TEXTURE_KIND_3D, d->depth = 65537; }
static void edit_depth_0(shd_texture_desc *d) { d->kind = SHD_TEXTURE_KIND_3D; }
static void edit_projection(shd_texture_desc *d)
{
    d->kind = SHD_TEXTURE_KIND_DIRECTIONS;
    d->projection = SHD_PROJECTION_OCTAHEDRAL + 1;
}
static void edit_depth_of_2d(shd_texture_desc *d) { d->depth = 1; }
static void edit_projection_of_2d(shd_texture_desc *d) { d->projection = SHD_PROJECTION_OCTAHEDRAL; }
static void edit_width_zero(shd_texture_desc *d) { d->width = 0; }
static void edit_height_zero(shd_texture_desc *d) { d->height = 0; }
static void edit_width_65537(shd_texture_desc *d) { d->width = 65537; }
static void edit_height_negative(shd_texture_desc *d) { d->height = (uint32_t)-4; }
static void edit_too_many(shd_texture_desc *d)
{
    d->width = 65536;
    d->height = 4097;
}
static void edit_too_many_for_ripmap(shd_texture_desc *d)
{
    d->width = 8192;
    d->height = 8193;
    d->tables = SHD_TABLE_RIPMAP;
}
static void edit_overflow(shd_texture_desc *d) { d->width = d->height = 0x10000; }
static void edit_texels_null(shd_texture_desc *d) { d->texels = NULL; }
static void edit_texels_misaligned(shd_texture_desc *d)
{
    d->format = SHD_FORMAT_RGBA32F;
    d->texels = (const char *)k_texels + 2;
}
static void edit_half_misaligned(shd_texture_desc *d)
{
    d->format = SHD_FORMAT_RGBA16F;
    d->texels = (const char *)k_texels + 1;
}
static void edit_bytes_misaligned(shd_texture_desc *d) { d->texels = (const char *)k_texels + 3; }
static void edit_stride_small(shd_texture_desc *d) { d->row_stride = 15; }
static void edit_stride_odd(shd_texture_desc *d)
{
    d->format = SHD_FORMAT_RGBA16F;
    d->row_stride = 33;
}
static void edit_stride_huge(shd_texture_desc *d) { d->row_stride = SIZE_MAX; }
static void edit_stride_half_huge(shd_texture_desc *d) { d->row_stride = SIZE_MAX / 4; }
static void edit_tables_unknown(shd_texture_desc *d) { d->tables = 24; }

static const struct create_case k_create[] = {
    {"create/4x4", edit_nothing, SHD_OK, ""},
    {"create/mipmap", edit_mipmap, SHD_OK, ""},
    {"create/r8", edit_r8, SHD_OK, ""},
    {"create/srgb", edit_srgb, SHD_OK, ""},
    {"create/half", edit_half, SHD_OK, ""},
    {"create/float", edit_float, SHD_OK, ""},
    {"create/strided", edit_stride, SHD_OK, ""},
    {"create/bytes_need_no_alignment", edit_bytes_misaligned, SHD_OK, ""},
    {"create/struct_size_zero", edit_size_zero, SHD_ERROR_INVALID_ARGUMENT, "texture.struct_size: 0"},
    {"create/struct_size_small", edit_size_small, SHD_ERROR_INVALID_ARGUMENT, "texture.struct_size: 8"},
    {"create/no_format", edit_format_none, SHD_ERROR_INVALID_ARGUMENT, "texture.format: 0 is not a format"},
    {"create/unknown_format", edit_format_unknown, SHD_ERROR_INVALID_ARGUMENT, "texture.format: 99"},
    {"create/negative_format", edit_format_negative, SHD_ERROR_INVALID_ARGUMENT, "texture.format: 4294967295"},
    {"create/3_layers", edit_layers, SHD_OK, ""},
    {"create/swizzle", edit_swizzle, SHD_OK, ""},
    {"create/zero_layers", edit_layers_0, SHD_ERROR_INVALID_ARGUMENT, "texture.layer_count: 0 is not in 1..2048"},
    {"create/2049_layers", edit_layers_2049, SHD_ERROR_INVALID_ARGUMENT, "texture.layer_count: 2049"},
    {"create/2^28_and_a_layer", edit_layers_too_many, SHD_ERROR_INVALID_ARGUMENT,
     "texture.width * texture.height * texture.layer_count: 269484032"},
    {"create/layer_stride_below_layer", edit_layer_stride_small, SHD_ERROR_INVALID_ARGUMENT,
     "texture.layer_stride: 63 is below 64"},
    {"create/layer_stride_odd_for_16_bits", edit_layer_stride_odd, SHD_ERROR_INVALID_ARGUMENT,
     "texture.layer_stride: 65 is not a multiple of 2"},
    {"create/layer_stride_overflow", edit_layer_stride_huge, SHD_ERROR_INVALID_ARGUMENT, "exceeds the address space"},
    {"create/unknown_swizzle", edit_swizzle_unknown, SHD_ERROR_INVALID_ARGUMENT, "texture.swizzle: 6 is not in 0..5"},
    {"create/infinite_fill", edit_fill_infinite, SHD_ERROR_INVALID_ARGUMENT, "texture.fill[1]: inf is not finite"},
    {"create/depth_65537", edit_depth, SHD_ERROR_INVALID_ARGUMENT, "texture.depth: 65537 is not in 1..65536"},
    {"create/depth_0", edit_depth_0, SHD_ERROR_INVALID_ARGUMENT, "texture.depth: 0 is not in 1..65536"},
    {"create/kind_unknown", edit_kind, SHD_ERROR_INVALID_ARGUMENT, "texture.kind: 3 is not in 0..2"},
    {"create/projection_unknown", edit_projection, SHD_ERROR_INVALID_ARGUMENT, "texture.projection: 6 is not in 1..5"},
    {"create/depth_of_2d", edit_depth_of_2d, SHD_ERROR_INVALID_ARGUMENT,
     "texture.depth: 1, but texture.kind is not SHD_TEXTURE_KIND_3D"},
    {"create/projection_of_2d", edit_projection_of_2d, SHD_ERROR_INVALID_ARGUMENT,
     "texture.projection: 5, but texture.kind is not SHD_TEXTURE_KIND_DIRECTIONS"},
    {"create/zero_width", edit_width_zero, SHD_ERROR_INVALID_ARGUMENT, "texture.width: 0 is not in 1..65536"},
    {"create/zero_height", edit_height_zero, SHD_ERROR_INVALID_ARGUMENT, "texture.height: 0 is not in 1..65536"},
    {"create/width_65537", edit_width_65537, SHD_ERROR_INVALID_ARGUMENT, "texture.width: 65537"},
    {"create/negative_height", edit_height_negative, SHD_ERROR_INVALID_ARGUMENT, "texture.height: 4294967292"},
    {"create/2^28_and_a_row", edit_too_many, SHD_ERROR_INVALID_ARGUMENT,
     "texture.width * texture.height * texture.layer_count: 268500992 is not in 1..268435456"},
    {"create/ripmap_of_2^26_and_a_row", edit_too_many_for_ripmap, SHD_ERROR_INVALID_ARGUMENT,
     "texture.width * texture.height * texture.layer_count: 67117056 is not in 1..67108864"},
    {"create/32_bit_overflow", edit_overflow, SHD_ERROR_INVALID_ARGUMENT,
     "texture.width * texture.height * texture.layer_count: 4294967296"},
    {"create/null_texels", edit_texels_null, SHD_ERROR_INVALID_ARGUMENT, "texture.texels: NULL"},
    {"create/misaligned_floats", edit_texels_misaligned, SHD_ERROR_INVALID_ARGUMENT,
     "texture.texels: not aligned to 4"},
    {"create/misaligned_halves", edit_half_misaligned, SHD_ERROR_INVALID_ARGUMENT, "texture.texels: not aligned to 2"},
    {"create/stride_below_row", edit_stride_small, SHD_ERROR_INVALID_ARGUMENT, "texture.row_stride: 15 is below 16"},
    {"create/stride_odd_for_halves", edit_stride_odd, SHD_ERROR_INVALID_ARGUMENT,
     "texture.row_stride: 33 is not a multiple of 2"},
    {"create/stride_overflow", edit_stride_huge, SHD_ERROR_INVALID_ARGUMENT, "exceeds the address space"},
    {"create/stride_times_rows_overflow", edit_stride_half_huge, SHD_ERROR_INVALID_ARGUMENT,
     "exceeds the address space"},
    {"create/unknown_tables", edit_tables_unknown, SHD_ERROR_UNSUPPORTED, "texture.tables: bits 0x18"},
};

static shd_texture_desc desc_4x4(void)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = 4;
    desc.height = 4;
    desc.texels = k_texels;
    return desc;
}

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_texture_desc desc = desc_4x4();
    shd_context *context = NULL;
    shd_texture *texture = (shd_texture *)&desc;
    shd_assert_ok(shd_context_create(NULL, &context));
    c->edit(&desc);
    shd_assert_result(c->name, shd_texture_create(context, &desc, &texture), c->expected, c->message);
    if (c->expected == SHD_OK) {
        assert_non_null(texture);
    } else {
        assert_null(texture);
    }
    shd_texture_release(texture);
    shd_context_release(context);
}

static void test_null_arguments(void **state)
{
    shd_context *context = NULL;
    shd_texture_desc desc = desc_4x4();
    shd_texture *texture = (shd_texture *)&desc;
    shd_texture_info info = shd_texture_info_default();
    shd_image image = shd_image_default();
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_result("out", shd_texture_create(context, &desc, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_texture: NULL");
    shd_assert_result("desc", shd_texture_create(context, NULL, &texture), SHD_ERROR_INVALID_ARGUMENT, "texture: NULL");
    assert_null(texture);
    shd_assert_result("context", shd_texture_create(NULL, &desc, &texture), SHD_ERROR_INVALID_ARGUMENT,
                      "context: NULL");
    memset(&info, 0xab, sizeof info);
    shd_assert_result("size", shd_texture_get_info(NULL, &info), SHD_ERROR_INVALID_ARGUMENT, "out_info.struct_size");
    info.struct_size = sizeof info;
    shd_assert_result("info", shd_texture_get_info(NULL, &info), SHD_ERROR_INVALID_ARGUMENT, "texture: NULL");
    assert_int_equal(info.width, 0);
    assert_int_equal(info.byte_size, 0);
    shd_assert_result("read", shd_texture_read_level(NULL, 0, 0, &image), SHD_ERROR_INVALID_ARGUMENT, "texture: NULL");
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    shd_assert_result("info", shd_texture_get_info(texture, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_info: NULL");
    shd_assert_result("read", shd_texture_read_level(texture, 0, 0, NULL), SHD_ERROR_INVALID_ARGUMENT, "out: NULL");
    shd_texture_release(texture);
    shd_texture_retain(NULL);
    shd_texture_release(NULL);
    shd_context_release(context);
}

struct info_case {
    const char *name;
    shd_format format;
    uint32_t width, height, tables, level_count;
    size_t byte_size;
};
static const struct info_case k_info[] = {
    {"info/1x1", SHD_FORMAT_R8, 1, 1, SHD_TABLE_MIPMAP, 1, 1},
    {"info/8x8_base", SHD_FORMAT_RGBA8, 8, 8, 0, 1, 256},
    {"info/8x8_mipmap", SHD_FORMAT_RGBA8, 8, 8, SHD_TABLE_MIPMAP, 4, 4 * (64 + 16 + 4 + 1)},
    {"info/5x3_mipmap", SHD_FORMAT_RGBA16F, 5, 3, SHD_TABLE_MIPMAP, 3, 8 * (15 + 2 + 1)},
    {"info/1x7_mipmap", SHD_FORMAT_RGBA32F, 1, 7, SHD_TABLE_MIPMAP, 3, 16 * (7 + 3 + 1)},
    {"info/8x8_ripmap", SHD_FORMAT_RGBA8, 8, 8, SHD_TABLE_RIPMAP, 1, 4 * 15 * 15},
    {"info/8x8_mipmap_ripmap", SHD_FORMAT_RGBA8, 8, 8, SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP, 4, 4 * 15 * 15},
    {"info/5x3_ripmap", SHD_FORMAT_RGBA16F, 5, 3, SHD_TABLE_RIPMAP, 1, 8 * (5 + 2 + 1) * (3 + 1)},
    {"info/1x7_mipmap_ripmap", SHD_FORMAT_R16, 1, 7, SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP, 3, 2 * (7 + 3 + 1)},
    {"info/8x8_sums", SHD_FORMAT_RGBA8, 8, 8, SHD_TABLE_SUMMED_AREA, 1, 4 * 64 + 4 * 4 * 81 + 8 * 4},
    {"info/5x3_sums", SHD_FORMAT_R16, 5, 3, SHD_TABLE_SUMMED_AREA, 1, 2 * 15 + 8 * 6 * 4 + 8},
    {"info/5x3_srgb_sums", SHD_FORMAT_RG8_SRGB, 5, 3, SHD_TABLE_SUMMED_AREA, 1, 2 * 15 + 8 * 2 * 6 * 4 + 8 * 2},
    {"info/1x7_float_sums", SHD_FORMAT_RGBA32F, 1, 7, SHD_TABLE_SUMMED_AREA, 1, 16 * 7 + 8 * 4 * 2 * 8 + 8 * 4},
    {"info/65536x1_mipmap", SHD_FORMAT_R8, 65536, 1, SHD_TABLE_MIPMAP, 17, 131071},
};

static void test_info(void **state)
{
    const struct info_case *c = (const struct info_case *)*state;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture_info info = shd_texture_info_default();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    void *texels = calloc((size_t)c->width * c->height, 16);
    shd_assert_ok(shd_context_create(NULL, &context));
    desc.format = c->format;
    desc.width = c->width;
    desc.height = c->height;
    desc.tables = c->tables;
    desc.texels = texels;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    free(texels); /* copied */
    shd_context_release(context);
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.format, c->format);
    assert_int_equal(info.width, c->width);
    assert_int_equal(info.height, c->height);
    assert_int_equal(info.level_count, c->level_count);
    assert_int_equal(info.byte_size, c->byte_size);
    shd_texture_release(texture);
}

static void test_read_level(void **state)
{
    const unsigned char base[] = {10, 20, 30, 40, 50, 60, 70, 80};
    unsigned char pixels[3][16];
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_image image = shd_image_default();
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    desc.format = SHD_FORMAT_R8;
    desc.width = 4;
    desc.height = 2;
    desc.texels = base;
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    image.format = SHD_FORMAT_R8;
    image.width = 4;
    image.height = 2;
    image.pixels = pixels;
    image.row_stride = 16;
    memset(pixels, 0xee, sizeof pixels);
    shd_assert_ok(shd_texture_read_level(texture, 0, 0, &image));
    assert_memory_equal(pixels[0], base, 4);
    assert_memory_equal(pixels[1], base + 4, 4);
    assert_int_equal(pixels[0][4], 0xee);
    assert_int_equal(pixels[2][0], 0xee);

    shd_assert_result("size", shd_texture_read_level(texture, 0, 1, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "out.width: 4 is not in 2..2");
    image.width = 2;
    shd_assert_result("height", shd_texture_read_level(texture, 0, 1, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "out.height: 2 is not in 1..1");
    image.height = 1;
    shd_assert_ok(shd_texture_read_level(texture, 0, 1, &image));
    assert_int_equal(pixels[0][0], 35);
    assert_int_equal(pixels[0][1], 55);
    image.width = 1;
    shd_assert_ok(shd_texture_read_level(texture, 0, 2, &image));
    assert_int_equal(pixels[0][0], 45);

    shd_assert_result("level", shd_texture_read_level(texture, 0, 3, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "level: 3 is not in 0..2");
    image.format = SHD_FORMAT_RGBA8;
    shd_assert_result("format", shd_texture_read_level(texture, 0, 2, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "out.format: 2 is not the texture's 1");
    shd_texture_release(texture);
    shd_context_release(context);
}

static void test_stale_handle(void **state)
{
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_texture_info info = shd_texture_info_default();
    shd_texture_desc desc = desc_4x4();
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    shd_texture_release(texture);
    shd_assert_result("released", shd_texture_get_info(texture, &info), SHD_ERROR_INVALID_ARGUMENT,
                      "texture: not a live handle");
    shd_context_release(context);
}

static void test_allocation_faults(void **state)
{
    size_t n;
    void *texels = calloc(256 * 256, 4);
    (void)state;
    for (n = 0; n < 32; ++n) {
        shd_fault_allocator memory = {0};
        shd_context_desc cd = shd_fault_context_desc(&memory);
        shd_texture_desc desc = shd_texture_desc_default();
        shd_context *context = NULL;
        shd_texture *texture = (shd_texture *)&memory;
        shd_result result;
        shd_assert_ok(shd_context_create(&cd, &context));
        desc.format = SHD_FORMAT_RGBA8;
        desc.width = 256;
        desc.height = 256;
        desc.texels = texels;
        desc.tables = SHD_TABLE_MIPMAP;
        shd_fault_arm(&memory, n + 1, 1);
        result = shd_texture_create(context, &desc, &texture);
        shd_fault_arm(&memory, 0, 0);
        if (result != SHD_OK) {
            shd_assert_result("fault", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
            assert_null(texture);
        }
        shd_texture_release(texture);
        shd_context_release(context);
        shd_assert_all_freed("allocation_faults", &memory);
        if (result == SHD_OK) break;
    }
    assert_true(n > 2 && n < 32);
    free(texels);
}

int main(void)
{
    struct CMUnitTest tests[64];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_create / sizeof k_create[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    for (i = 0; i < sizeof k_info / sizeof k_info[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_info[i].name, test_info, NULL, NULL, (void *)&k_info[i]};
    }
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null_arguments, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"read_level", test_read_level, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"stale_handle", test_stale_handle, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"allocation_faults", test_allocation_faults, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.texture", tests, n, NULL, NULL);
}
