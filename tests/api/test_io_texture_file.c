/* SPDX-License-Identifier: MIT */
/* KTX2 and DDS files, built byte by byte, as textures: every format, all kinds, levels, supercompression, swizzles and
 * curves. */
#define _GNU_SOURCE
#include "support/loads.h"
#include "support/rows.h"
#include "support/texture_formats.h"

#include <shd/shd.h>

static void test_format(void **state)
{
    const struct format_case *c = (const struct format_case *)*state;
    const file_texture t = texture_of(c, 13, 7, 4);
    const file_ktx2 k = ktx2_of(c);
    int by_path;
    for (by_path = 0; by_path < 2; ++by_path) {
        shd_texture_file_info info;
        shd_texture_info made = shd_texture_info_default();
        shd_texture *texture;
        if (c->vulkan) {
            texture = load(file_make_ktx2(&t, &k, NULL), NULL, by_path, &info);
            check_info(&info, SHD_TEXTURE_FILE_KIND_KTX2, &t, c->format);
            assert_int_equal(info.file_code, c->vulkan);
            check_images(c->name, texture, &t, 0, c->format, c->order);
            shd_assert_ok(shd_texture_get_info(texture, &made));
            assert_int_equal(made.format, stored_format(c->format));
            shd_texture_release(texture);
        }
        if (c->dxgi) {
            texture = load(file_make_dds(&t, "DX10", c->dxgi), NULL, by_path, &info);
            check_info(&info, SHD_TEXTURE_FILE_KIND_DDS, &t, c->format);
            assert_int_equal(info.file_code, c->dxgi);
            check_images(c->name, texture, &t, 0, c->format, c->order);
            shd_texture_release(texture);
        }
    }
}

static void test_kind(void **state)
{
    const struct kind_case *c = (const struct kind_case *)*state;
    int format, dds, scheme;
    for (format = 0; format < 3; ++format) {
        static const int k_rows[3] = {14, 8, 40}; /* r16, rgba8, bc7 */
        const struct format_case *row = &k_formats[k_rows[format]];
        for (dds = 0; dds < 2; ++dds) {
            for (scheme = 0; scheme < 4; ++scheme) {
                file_texture t = texture_of(row, c->width, c->height, c->levels);
                file_ktx2 k = ktx2_of(row);
                shd_load_desc desc = shd_load_desc_default();
                shd_texture_info made = shd_texture_info_default();
                shd_texture_file_info info;
                shd_texture *texture;
                if (scheme == 1 || (dds && scheme)) continue;
                t.depth = c->depth, t.layers = c->layers, t.faces = c->faces;
                k.scheme = (uint32_t)scheme;
                desc.subimage = c->chosen;
                if (c->levels == 1) desc.tables = 0;
                texture =
                    load(dds ? file_make_dds(&t, "DX10", row->dxgi) : file_make_ktx2(&t, &k, NULL), &desc, 0, &info);
                check_info(&info, dds ? SHD_TEXTURE_FILE_KIND_DDS : SHD_TEXTURE_FILE_KIND_KTX2, &t, row->format);
                assert_int_equal(info.supercompression, scheme);
                check_images(c->name, texture, &t, c->chosen * c->faces, row->format, SAME);
                shd_assert_ok(shd_texture_get_info(texture, &made));
                assert_int_equal(made.projection, c->faces == 6 ? SHD_PROJECTION_CUBE : SHD_PROJECTION_NONE);
                assert_int_equal(made.depth, c->depth);
                shd_texture_release(texture);
            }
        }
    }
}

/** Levels that the file lacks: built for pixels, absent for blocks; without the table only the base is read. */
static void test_absent_levels(void **state)
{
    static const uint32_t k_levels[3] = {0, 1, 3};
    int i;
    (void)state;
    for (i = 0; i < 6; ++i) {
        const struct format_case *row = &k_formats[i < 3 ? 8 : 40];
        const file_texture t = texture_of(row, 16, 16, k_levels[i % 3]);
        const file_ktx2 k = ktx2_of(row);
        shd_load_desc desc = shd_load_desc_default();
        shd_texture_info made = shd_texture_info_default();
        shd_texture_file_info info;
        shd_texture *texture = load(file_make_ktx2(&t, &k, NULL), &desc, 0, &info);
        shd_assert_ok(shd_texture_get_info(texture, &made));
        assert_int_equal(made.level_count, i % 3 == 2 ? 3 : i < 3 ? 5 : 1);
        shd_texture_release(texture);
        desc.tables = 0;
        texture = load(file_make_ktx2(&t, &k, NULL), &desc, 0, &info);
        shd_assert_ok(shd_texture_get_info(texture, &made));
        assert_int_equal(made.level_count, 1);
        shd_texture_release(texture);
    }
}

/** The value of the texel at (u, v) with swizzle and fill. */
static void sample_texel(const shd_texture *texture, float u, float v, float out[4])
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    shd_sampler *sampler = NULL;
    int k;
    desc.filter = SHD_FILTER_NEAREST;
    lookups.count = 1;
    lookups.u.data = &u, lookups.v.data = &v;
    for (k = 0; k < 4; ++k) texels.channel[k].data = &out[k];
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    shd_sampler_release(sampler);
}

/** A DDS file of one pixel with masks. */
struct mask_case {
    const char *name;
    uint32_t flags, bits, mask[4], pixel;
    float expected[4]; /* codes of 8 bits, or -1 for 16 bits */
    shd_format format;
};
static const struct mask_case k_masks[] = {
    {"mask/argb8",
     0x41,
     32,
     {0xff0000, 0xff00, 0xff, 0xff000000},
     0x40302010,
     {0x30, 0x20, 0x10, 0x40},
     SHD_FORMAT_RGBA8},
    {"mask/xrgb8",
     0x40,
     32,
     {0xff0000, 0xff00, 0xff, 0xff000000},
     0x40302010,
     {0x30, 0x20, 0x10, 255},
     SHD_FORMAT_RGBA8},
    {"mask/abgr8",
     0x41,
     32,
     {0xff, 0xff00, 0xff0000, 0xff000000},
     0x40302010,
     {0x10, 0x20, 0x30, 0x40},
     SHD_FORMAT_RGBA8},
    {"mask/rgb8", 0x40, 24, {0xff0000, 0xff00, 0xff, 0}, 0x302010, {0x30, 0x20, 0x10, 255}, SHD_FORMAT_RGBA8},
    {"mask/r5g6b5", 0x40, 16, {0xf800, 0x7e0, 0x1f, 0}, 0xf810 | 31 << 5, {255, 125, 132, 255}, SHD_FORMAT_RGBA8},
    {"mask/a1r5g5b5", 0x41, 16, {0x7c00, 0x3e0, 0x1f, 0x8000}, 0x801f, {0, 0, 255, 255}, SHD_FORMAT_RGBA8},
    {"mask/a4r4g4b4", 0x41, 16, {0xf00, 0xf0, 0xf, 0xf000}, 0x8421, {0x44, 0x22, 0x11, 0x88}, SHD_FORMAT_RGBA8},
    {"mask/r3g3b2", 0x40, 8, {0xe0, 0x1c, 3, 0}, 0x81, {146, 0, 85, 255}, SHD_FORMAT_RGBA8},
    {"mask/l8", 0x20000, 8, {0xff, 0, 0, 0}, 0x80, {0x80, 0x80, 0x80, 255}, SHD_FORMAT_R8},
    {"mask/a8", 0x2, 8, {0, 0, 0, 0xff}, 0x80, {0, 0, 0, 0x80}, SHD_FORMAT_R8},
    {"mask/r8", 0x40, 8, {0xff, 0, 0, 0}, 0x80, {0x80, 0, 0, 255}, SHD_FORMAT_R8},
    {"mask/grey8", 0x40, 8, {0xff, 0xff, 0xff, 0}, 0x80, {0x80, 0x80, 0x80, 255}, SHD_FORMAT_R8},
    {"mask/a8l8", 0x20001, 16, {0xff, 0, 0, 0xff00}, 0x4080, {0x80, 0x80, 0x80, 0x40}, SHD_FORMAT_RGBA8},
    {"mask/l16", 0x20000, 16, {0xffff, 0, 0, 0}, 0x3333, {51, 51, 51, 255}, SHD_FORMAT_R16},
    {"mask/g16r16", 0x40, 32, {0xffff, 0xffff0000u, 0, 0}, 0xffff3333, {51, 255, 0, 255}, SHD_FORMAT_RG16},
};

static void test_mask(void **state)
{
    const struct mask_case *c = (const struct mask_case *)*state;
    file_texture t = {2, 1, 0, 0, 1, 1, 0, 1, 1};
    shd_load_desc desc = shd_load_desc_default();
    shd_texture_file_info info;
    shd_texture *texture;
    io_bytes file = {NULL, 0};
    float texel[4];
    int k, pixel;
    file = file_make_dds(&t, "\0\0\0\0", 0);
    shd_dds_put(file.data + 80, c->flags);
    shd_dds_put(file.data + 88, c->bits);
    for (k = 0; k < 4; ++k) shd_dds_put(file.data + 92 + 4 * k, c->mask[k]);
    for (pixel = 0; pixel < 2; ++pixel) file_number(&file, c->pixel, c->bits / 8);
    desc.encoding = SHD_COLOR_ENCODING_DATA;
    texture = load(file, &desc, 0, &info);
    assert_int_equal(info.format, c->format);
    sample_texel(texture, 0.75f, 0.5f, texel);
    for (k = 0; k < 4; ++k)
        shd_assert_close(c->name, (size_t)k, (double)texel[k], (double)c->expected[k] / 255, 1e-6, 0);
    shd_texture_release(texture);
}

static void test_swizzle(void **state)
{
    const struct format_case *row = &k_formats[2]; /* rg8 */
    const file_texture t = texture_of(row, 1, 1, 1);
    file_ktx2 k = ktx2_of(row);
    const float r = (float)file_byte(0, 0, 0) / 255, g = (float)file_byte(0, 0, 1) / 255;
    const float expected[3][4] = {{g, r, 1, 0}, {r, r, r, g}, {0, 1, r, g}};
    const char *const values[3] = {"gr10", "rrrg", "barg"};
    int i, c;
    (void)state;
    for (i = 0; i < 3; ++i) {
        shd_texture_file_info info;
        shd_texture *texture;
        float texel[4];
        k.swizzle = values[i];
        k.orientation = "lu";
        texture = load(file_make_ktx2(&t, &k, NULL), NULL, 0, &info);
        assert_int_equal(info.flags, SHD_TEXTURE_FILE_BOTTOM_UP | SHD_TEXTURE_FILE_RIGHT_TO_LEFT);
        sample_texel(texture, 0.5f, 0.5f, texel);
        for (c = 0; c < 4; ++c)
            shd_assert_close(values[i], (size_t)c, (double)texel[c], (double)expected[i][c], 1e-6, 0);
        shd_texture_release(texture);
    }
}

/** SHD_LOAD_FLIP_V reverses the rows of every level. */
static void test_flip(void **state)
{
    const struct format_case *row = &k_formats[8];
    const file_texture t = texture_of(row, 4, 6, 2);
    const file_ktx2 k = ktx2_of(row);
    shd_load_desc desc = shd_load_desc_default();
    shd_texture_file_info info;
    shd_texture *texture;
    uint32_t l, y;
    (void)state;
    desc.flags = SHD_LOAD_FLIP_V;
    texture = load(file_make_ktx2(&t, &k, NULL), &desc, 0, &info);
    for (l = 0; l < 2; ++l) {
        io_bytes got = read_image(texture, 0, l), stored = {NULL, 0};
        const uint32_t h = 6u >> l, size = 4 * (4u >> l);
        file_image(&stored, &t, l, 0);
        for (y = 0; y < h; ++y) assert_memory_equal(got.data + y * size, stored.data + (h - 1 - y) * size, size);
        free(got.data);
        free(stored.data);
    }
    shd_texture_release(texture);
}

/** Effect of color_space on a declared curve. */
struct curve_case {
    const char *name;
    uint32_t vulkan, model, unit, block, transfer; /* or DXT5 of DDS if vulkan is 0 */
    shd_color_encoding encoding;
    shd_format format; /* NONE = refused */
    shd_result result;
    const char *message;
};
static const struct curve_case k_curves[] = {
    {"curve/declared_srgb", 43, 1, 4, 1, 2, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, SHD_OK, ""},
    {"curve/srgb_as_data", 43, 1, 4, 1, 2, SHD_COLOR_ENCODING_DATA, SHD_FORMAT_RGBA8, SHD_OK, ""},
    {"curve/linear_as_srgb", 145, 134, 16, 4, 1, SHD_COLOR_ENCODING_SRGB, SHD_FORMAT_BC7_SRGB, SHD_OK, ""},
    {"curve/unspecified", 145, 134, 16, 4, 0, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_BC7, SHD_OK, ""},
    {"curve/contradiction", 145, 134, 16, 4, 2, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, SHD_ERROR_CORRUPT,
     "vkFormat 145, but transfer 2 in the descriptor: set color_space"},
    {"curve/contradiction_srgb", 146, 134, 16, 4, 1, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, SHD_ERROR_CORRUPT,
     "vkFormat 146, but transfer 1"},
    {"curve/contradiction_overruled", 145, 134, 16, 4, 2, SHD_COLOR_ENCODING_LINEAR, SHD_FORMAT_BC7, SHD_OK, ""},
    {"curve/bc5_as_srgb", 141, 132, 16, 4, 1, SHD_COLOR_ENCODING_SRGB, SHD_FORMAT_NONE, SHD_ERROR_UNSUPPORTED,
     "load.encoding: SRGB, but format 31 of the KTX2 file has no _SRGB format"},
    {"curve/r16_declared_srgb", 70, 1, 2, 1, 2, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, SHD_ERROR_UNSUPPORTED,
     "the sRGB curve with format 12"},
    {"curve/bt709", 37, 1, 4, 1, 3, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, SHD_ERROR_UNSUPPORTED,
     "neither sRGB nor linear"},
    {"curve/bt709_as_data", 37, 1, 4, 1, 3, SHD_COLOR_ENCODING_DATA, SHD_FORMAT_RGBA8, SHD_OK, ""},
    {"curve/dds_auto", 0, 0, 16, 4, 0, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_BC3_SRGB, SHD_OK, ""},
    {"curve/dds_data", 0, 0, 16, 4, 0, SHD_COLOR_ENCODING_DATA, SHD_FORMAT_BC3, SHD_OK, ""},
};

static void test_curve(void **state)
{
    const struct curve_case *c = (const struct curve_case *)*state;
    const file_texture t = {8, 8, 0, 0, 1, 1, c->unit, c->block, c->block};
    const file_ktx2 k = {c->vulkan, c->vulkan == 70 ? 2u : 1u, c->model, c->transfer, 0, NULL, NULL};
    shd_load_desc desc = shd_load_desc_default();
    shd_texture_file_info info = shd_texture_file_info_default();
    shd_texture *texture = NULL;
    io_bytes file = c->vulkan ? file_make_ktx2(&t, &k, NULL) : file_make_dds(&t, "DXT5", 0);
    desc.encoding = c->encoding;
    shd_assert_result(c->name, load_file_memory(g_context, file.data, file.size, &desc, &info, &texture), c->result,
                      c->message);
    assert_int_equal(info.format, c->format);
    assert_true((texture != NULL) == (c->result == SHD_OK));
    shd_texture_release(texture);
    free(file.data);
}

/** Legacy codes of DDS. api.io_blocks compares the texels with those of OpenImageIO's decoder. */
struct code_case {
    const char *name;
    const char *code;
    uint32_t dxgi, unit, block;
    shd_format format;
    shd_texture_file_flags flags;
};
static const struct code_case k_codes[] = {
    {"code/dxt1", "DXT1", 0, 8, 4, SHD_FORMAT_BC1_RGBA, 0},
    {"code/dxt2", "DXT2", 0, 16, 4, SHD_FORMAT_BC2, SHD_TEXTURE_FILE_PREMULTIPLIED},
    {"code/dxt3", "DXT3", 0, 16, 4, SHD_FORMAT_BC2, 0},
    {"code/dxt4", "DXT4", 0, 16, 4, SHD_FORMAT_BC3, SHD_TEXTURE_FILE_PREMULTIPLIED},
    {"code/dxt5", "DXT5", 0, 16, 4, SHD_FORMAT_BC3, 0},
    {"code/ati1", "ATI1", 0, 8, 4, SHD_FORMAT_BC4, 0},
    {"code/bc4u", "BC4U", 0, 8, 4, SHD_FORMAT_BC4, 0},
    {"code/bc4s", "BC4S", 0, 8, 4, SHD_FORMAT_BC4_SNORM, 0},
    {"code/ati2", "ATI2", 0, 16, 4, SHD_FORMAT_BC5, 0},
    {"code/bc5u", "BC5U", 0, 16, 4, SHD_FORMAT_BC5, 0},
    {"code/bc5s", "BC5S", 0, 16, 4, SHD_FORMAT_BC5_SNORM, 0},
    {"code/rxgb", "RXGB", 0, 16, 4, SHD_FORMAT_BC3, 0},
    {"code/dx10_bc6h", "DX10", 95, 16, 4, SHD_FORMAT_BC6H_UFLOAT, 0},
    {"code/dx10_bc7", "DX10", 98, 16, 4, SHD_FORMAT_BC7, 0},
    {"code/rgba16", "\x24\0\0\0", 0, 8, 1, SHD_FORMAT_RGBA16, 0},
    {"code/r16f", "\x6f\0\0\0", 0, 2, 1, SHD_FORMAT_R16F, 0},
    {"code/rg16f", "\x70\0\0\0", 0, 4, 1, SHD_FORMAT_RG16F, 0},
    {"code/rgba16f", "\x71\0\0\0", 0, 8, 1, SHD_FORMAT_RGBA16F, 0},
    {"code/r32f", "\x72\0\0\0", 0, 4, 1, SHD_FORMAT_R32F, 0},
    {"code/rg32f", "\x73\0\0\0", 0, 8, 1, SHD_FORMAT_RG32F, 0},
    {"code/rgba32f", "\x74\0\0\0", 0, 16, 1, SHD_FORMAT_RGBA32F, 0},
};

static void test_code(void **state)
{
    const struct code_case *c = (const struct code_case *)*state;
    const file_texture t = {32, 16, 0, 0, 1, 6, c->unit, c->block, c->block};
    io_bytes file = file_make_dds(&t, c->code, c->dxgi);
    shd_load_desc desc = shd_load_desc_default();
    shd_texture_file_info info = shd_texture_file_info_default();
    shd_texture *texture = NULL;
    desc.encoding = SHD_COLOR_ENCODING_DATA;
    shd_assert_ok(load_file_memory(g_context, file.data, file.size, &desc, &info, &texture));
    assert_int_equal(info.format, c->format);
    assert_int_equal(info.flags, c->flags);
    check_images(c->name, texture, &t, 0, c->format, SAME);
    shd_texture_release(texture);
    free(file.data);
}

/** A FourCC that a writer left behind counts only with DDPF_FOURCC (Microsoft, "DDS_PIXELFORMAT structure"). */
static void test_stale_code(void **state)
{
    static const char *const k_codes_left[3] = {"DX10", "DXT1", "ABCD"};
    int i, k;
    (void)state;
    for (i = 0; i < 3; ++i) {
        const file_texture t = {2, 1, 0, 0, 1, 1, 0, 1, 1};
        io_bytes file = file_make_dds(&t, "\0\0\0\0", 0);
        shd_texture_file_info info;
        shd_load_desc desc = shd_load_desc_default();
        shd_texture *texture;
        float texel[4];
        static const float k_expected[4] = {0x30, 0x20, 0x10, 0x40};
        memcpy(file.data + 84, k_codes_left[i], 4);
        shd_dds_put(file.data + 80, 0x41), shd_dds_put(file.data + 88, 32);
        shd_dds_put(file.data + 92, 0xff0000), shd_dds_put(file.data + 96, 0xff00), shd_dds_put(file.data + 100, 0xff);
        shd_dds_put(file.data + 104, 0xff000000u);
        for (k = 0; k < 2; ++k) file_number(&file, 0x40302010, 4);
        desc.encoding = SHD_COLOR_ENCODING_DATA;
        texture = load(file, &desc, 0, &info);
        sample_texel(texture, 0.75f, 0.5f, texel);
        for (k = 0; k < 4; ++k)
            shd_assert_close(k_codes_left[i], (size_t)k, (double)texel[k], (double)k_expected[k] / 255, 1e-6, 0);
        shd_texture_release(texture);
    }
}

/** A cube map whose arraySize counts its six faces is one cube map. */
static void test_counted_faces(void **state)
{
    const struct format_case *row = &k_formats[8];
    file_texture t = texture_of(row, 4, 4, 3);
    io_bytes file;
    shd_texture_file_info info;
    shd_texture *texture;
    (void)state;
    t.faces = 6;
    file = file_make_dds(&t, "DX10", row->dxgi);
    shd_dds_put(file.data + 140, 6);
    texture = load(file, NULL, 0, &info);
    check_info(&info, SHD_TEXTURE_FILE_KIND_DDS, &t, row->format);
    check_images("counted_faces", texture, &t, 0, row->format, SAME);
    shd_texture_release(texture);
}

/** Red of RXGB lies in alpha. */
static void test_rxgb(void **state)
{
    const file_texture t = {4, 4, 0, 0, 1, 1, 16, 4, 4};
    io_bytes file = file_make_dds(&t, "RXGB", 0);
    /* Alpha 0x80 everywhere; colour 0, 63 / 63, 0 of 5:6:5 bits. */
    static const unsigned char k_block[16] = {0x80, 0, 0, 0, 0, 0, 0, 0, 0xe0, 7, 0, 0, 0, 0, 0, 0};
    static const float k_expected[4] = {128.f / 255, 1, 0, 1};
    shd_texture_file_info info;
    shd_texture *texture;
    float texel[4];
    int k;
    (void)state;
    memcpy(file.data + file.size - 16, k_block, 16);
    texture = load(file, NULL, 0, &info);
    assert_int_equal(info.format, SHD_FORMAT_BC3); /* vectors, without the sRGB curve */
    sample_texel(texture, 0.5f, 0.5f, texel);
    for (k = 0; k < 4; ++k) shd_assert_close("rxgb", (size_t)k, (double)texel[k], (double)k_expected[k], 1e-6, 0);
    shd_texture_release(texture);
}

/** By default a worker parses the file: without its program a load fails, except in this process. */
static void test_worker(void **state)
{
    const struct format_case *row = &k_formats[8];
    const file_texture t = texture_of(row, 4, 4, 1);
    const file_ktx2 k = ktx2_of(row);
    int kind;
    (void)state;
    for (kind = 0; kind < 2; ++kind) {
        io_bytes file = kind ? file_make_dds(&t, "DX10", row->dxgi) : file_make_ktx2(&t, &k, NULL);
        shd_load_desc desc = shd_load_desc_default();
        shd_texture *texture = NULL;
        desc.worker_path = io_path("absent-worker");
        assert_int_not_equal(shd_texture_load_memory(g_context, file.data, file.size, &desc, &texture), SHD_OK);
        desc.flags = SHD_LOAD_IN_PROCESS;
        shd_assert_ok(shd_texture_load_memory(g_context, file.data, file.size, &desc, &texture));
        shd_texture_release(texture);
        free(file.data);
    }
}

/** ASTC blocks of one colour: LDR, HDR, and a reserved mode (Data Format Specification 1.3, 23.23 and 23.24). */
static void test_astc(void **state)
{
    static const unsigned char k_ldr[16] = {0xfc, 0xfd, 255,  255,  255,  255,  255,  255,
                                            0x40, 0x40, 0x80, 0x80, 0xff, 0xff, 0x20, 0x20};
    static const unsigned char k_hdr[16] = {0xfc, 0xff, 255, 255,  255, 255,  255, 255,
                                            0,    0x3c, 0,   0x40, 0,   0x50, 0,   0x3c};
    static const float k_expected[4][4] = {{64.f / 255, 128.f / 255, 1, 32.f / 255},
                                           {64.f / 255, 128.f / 255, 1, 32.f / 255},
                                           {1, 2, 32, 1},
                                           {1, 0, 1, 1}};
    static const uint32_t k_vulkan[4] = {157 + 2 * 4, 157 + 2 * 13 + 1, 1000066000 + 7, 157}, k_side[4] = {6, 12, 8, 4};
    static const shd_format k_format[4] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F,
                                           SHD_FORMAT_RGBA8};
    int i, c;
    (void)state;
    for (i = 0; i < 4; ++i) {
        const file_texture t = {13, 9, 0, 0, 1, 2, 16, k_side[i], k_side[i]};
        const file_ktx2 k = {k_vulkan[i], 1, 162, i == 1 ? 2u : 1u, i == 3 ? 2u : 0u, NULL, NULL};
        shd_texture_file_info info = shd_texture_file_info_default();
        shd_load_desc desc = shd_load_desc_default();
        io_bytes levels[2] = {{NULL, 0}, {NULL, 0}}, file;
        shd_texture *texture = NULL;
        shd_result result;
        float texel[4];
        size_t at;
        for (c = 0; c < 2; ++c) {
            const unsigned char none[16] = {0};
            for (at = 0; at < file_image_size(&t, (uint32_t)c); at += 16)
                file_put(&levels[c], i < 2 ? k_ldr : i == 2 ? k_hdr : none, 16);
        }
        file = file_make_ktx2(&t, &k, levels);
        if (i == 1) desc.encoding = SHD_COLOR_ENCODING_DATA;
        result = load_file_memory(g_context, file.data, file.size, &desc, &info, &texture);
        free(levels[0].data), free(levels[1].data), free(file.data);
        if (file_is_absent(result)) skip();
        shd_assert_result("astc", result, SHD_OK, "");
        assert_int_equal(info.format, i == 1 ? SHD_FORMAT_RGBA8 : k_format[i]);
        sample_texel(texture, 0.99f, 0.99f, texel);
        for (c = 0; c < 4; ++c)
            shd_assert_close("astc", (size_t)(4 * i + c), (double)texel[c], (double)k_expected[i][c], 1e-6, 0);
        shd_texture_release(texture);
    }
}

int main(void)
{
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    ADD_ROWS(k_formats, test_format);
    ADD_ROWS(k_kinds, test_kind);
    ADD_ROWS(k_masks, test_mask);
    ADD_ROWS(k_curves, test_curve);
    ADD_ROWS(k_codes, test_code);
    add("absent_levels", test_absent_levels, NULL);
    add("swizzle", test_swizzle, NULL);
    add("stale_code", test_stale_code, NULL);
    add("counted_faces", test_counted_faces, NULL);
    add("rxgb", test_rxgb, NULL);
    add("worker", test_worker, NULL);
    add("flip", test_flip, NULL);
    add("astc", test_astc, NULL);
    failed = _cmocka_run_group_tests("api.io_texture_file", g_tests, g_count, NULL, NULL);
    shd_context_release(g_context);
    io_remove_folder(&state);
    return failed;
}
