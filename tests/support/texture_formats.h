/* SPDX-License-Identifier: MIT */
/* The formats and kinds of textures in KTX2 and DDS files, and their comparison with loaded textures. */
#ifndef SHD_TESTS_SUPPORT_TEXTURE_FORMATS_H
#define SHD_TESTS_SUPPORT_TEXTURE_FORMATS_H

#include "support/loads.h"
#include "support/texture_files.h"

static shd_context *g_context;

/** The bytes of an image of a texture, slices one after the other. The caller must free() them. */
static inline io_bytes read_image(const shd_texture *texture, uint32_t layer, uint32_t level)
{
    shd_texture_info info = shd_texture_info_default();
    shd_image image = shd_image_default();
    io_bytes out = {NULL, 0};
    uint32_t z, slices, w, h;
    size_t block, size;
    shd_assert_ok(shd_texture_get_info(texture, &info));
    block = shd_format_block_size(info.format);
    w = file_side(info.width, level), h = file_side(info.height, level);
    size = block ? block * ((w + 3) / 4) * ((h + 3) / 4) : shd_format_size(info.format) * w * h;
    slices = info.depth ? file_side(info.depth, level) : 1;
    out.data = (unsigned char *)malloc(size * slices);
    out.size = size * slices;
    image.format = info.format, image.width = w, image.height = h;
    for (z = 0; z < slices; ++z) {
        image.pixels = out.data + z * size;
        shd_assert_ok(shd_texture_read_level(texture, info.depth ? z : layer, level, &image));
    }
    return out;
}

/** A format of three channels as stored. */
static inline shd_format stored_format(shd_format format)
{
    switch (format) {
        case SHD_FORMAT_RGB8: return SHD_FORMAT_RGBA8;
        case SHD_FORMAT_RGB8_SRGB: return SHD_FORMAT_RGBA8_SRGB;
        case SHD_FORMAT_RGB16: return SHD_FORMAT_RGBA16;
        case SHD_FORMAT_RGB16F: return SHD_FORMAT_RGBA16F;
        case SHD_FORMAT_RGB32F: return SHD_FORMAT_RGBA32F;
        default: return format;
    }
}

enum { SAME, SWAP3, SWAP4, SWAPX };

/** The bytes of the texture for an image of the file: red and blue in order, three channels as four. */
static inline io_bytes expect_image(const file_texture *t, uint32_t level, uint32_t image, shd_format format, int order)
{
    io_bytes stored = {NULL, 0}, out = {NULL, 0};
    const size_t size = stored_format(format) != format ? t->unit / 3 * 4 : t->unit;
    size_t i;
    file_image(&stored, t, level, image);
    for (i = 0; i < stored.size; i += t->unit) {
        unsigned char unit[16] = {0};
        memcpy(unit, stored.data + i, t->unit);
        if (order != SAME) unit[0] = stored.data[i + 2], unit[2] = stored.data[i];
        if (order == SWAPX) unit[3] = 255;
        file_put(&out, unit, size);
    }
    free(stored.data);
    return out;
}

/** Whether all images of a texture are those of the file. `first` is the image of the file that is layer 0. */
static inline void check_images(const char *name, const shd_texture *texture, const file_texture *t, uint32_t first,
                                shd_format stored, int order)
{
    shd_texture_info info = shd_texture_info_default();
    uint32_t l, i;
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.level_count, t->level_count ? t->level_count : 1);
    for (l = 0; l < info.level_count; ++l) {
        for (i = 0; i < info.layer_count; ++i) {
            io_bytes got = read_image(texture, i, l), want = expect_image(t, l, first + i, stored, order);
            if (got.size != want.size || memcmp(got.data, want.data, got.size) != 0) {
                fail_msg("%s: level %u of image %u differs", name, l, i);
            }
            free(got.data);
            free(want.data);
        }
    }
}

/** A format in both kinds of file. */
struct format_case {
    const char *name;
    shd_format format; /* as declared; three channels before they are stored as four */
    uint32_t unit, block;
    uint32_t vulkan, type_size, model; /* 0 = not in KTX2 */
    uint32_t dxgi;                     /* 0 = not in DDS */
    int srgb, order;
};
static const struct format_case k_formats[] = {
    {"r8", SHD_FORMAT_R8, 1, 1, 9, 1, 1, 61, 0, SAME},
    {"r8_srgb", SHD_FORMAT_R8_SRGB, 1, 1, 15, 1, 1, 0, 1, SAME},
    {"rg8", SHD_FORMAT_RG8, 2, 1, 16, 1, 1, 49, 0, SAME},
    {"rg8_srgb", SHD_FORMAT_RG8_SRGB, 2, 1, 22, 1, 1, 0, 1, SAME},
    {"rgb8", SHD_FORMAT_RGB8, 3, 1, 23, 1, 1, 0, 0, SAME},
    {"rgb8_srgb", SHD_FORMAT_RGB8_SRGB, 3, 1, 29, 1, 1, 0, 1, SAME},
    {"bgr8", SHD_FORMAT_RGB8, 3, 1, 30, 1, 1, 0, 0, SWAP3},
    {"bgr8_srgb", SHD_FORMAT_RGB8_SRGB, 3, 1, 36, 1, 1, 0, 1, SWAP3},
    {"rgba8", SHD_FORMAT_RGBA8, 4, 1, 37, 1, 1, 28, 0, SAME},
    {"rgba8_srgb", SHD_FORMAT_RGBA8_SRGB, 4, 1, 43, 1, 1, 29, 1, SAME},
    {"bgra8", SHD_FORMAT_RGBA8, 4, 1, 44, 1, 1, 87, 0, SWAP4},
    {"bgra8_srgb", SHD_FORMAT_RGBA8_SRGB, 4, 1, 50, 1, 1, 91, 1, SWAP4},
    {"bgrx8", SHD_FORMAT_RGBA8, 4, 1, 0, 1, 1, 88, 0, SWAPX},
    {"bgrx8_srgb", SHD_FORMAT_RGBA8_SRGB, 4, 1, 0, 1, 1, 93, 1, SWAPX},
    {"r16", SHD_FORMAT_R16, 2, 1, 70, 2, 1, 56, 0, SAME},
    {"r16f", SHD_FORMAT_R16F, 2, 1, 76, 2, 1, 54, 0, SAME},
    {"rg16", SHD_FORMAT_RG16, 4, 1, 77, 2, 1, 35, 0, SAME},
    {"rg16f", SHD_FORMAT_RG16F, 4, 1, 83, 2, 1, 34, 0, SAME},
    {"rgb16", SHD_FORMAT_RGB16, 6, 1, 84, 2, 1, 0, 0, SAME},
    {"rgb16f", SHD_FORMAT_RGB16F, 6, 1, 90, 2, 1, 0, 0, SAME},
    {"rgba16", SHD_FORMAT_RGBA16, 8, 1, 91, 2, 1, 11, 0, SAME},
    {"rgba16f", SHD_FORMAT_RGBA16F, 8, 1, 97, 2, 1, 10, 0, SAME},
    {"r32f", SHD_FORMAT_R32F, 4, 1, 100, 4, 1, 41, 0, SAME},
    {"rg32f", SHD_FORMAT_RG32F, 8, 1, 103, 4, 1, 16, 0, SAME},
    {"rgb32f", SHD_FORMAT_RGB32F, 12, 1, 106, 4, 1, 6, 0, SAME},
    {"rgba32f", SHD_FORMAT_RGBA32F, 16, 1, 109, 4, 1, 2, 0, SAME},
    {"rgb9e5", SHD_FORMAT_RGB9E5, 4, 1, 123, 4, 1, 67, 0, SAME},
    {"bc1_rgb", SHD_FORMAT_BC1_RGB, 8, 4, 131, 1, 128, 0, 0, SAME},
    {"bc1_rgb_srgb", SHD_FORMAT_BC1_RGB_SRGB, 8, 4, 132, 1, 128, 0, 1, SAME},
    {"bc1_rgba", SHD_FORMAT_BC1_RGBA, 8, 4, 133, 1, 128, 71, 0, SAME},
    {"bc1_rgba_srgb", SHD_FORMAT_BC1_RGBA_SRGB, 8, 4, 134, 1, 128, 72, 1, SAME},
    {"bc2", SHD_FORMAT_BC2, 16, 4, 135, 1, 129, 74, 0, SAME},
    {"bc2_srgb", SHD_FORMAT_BC2_SRGB, 16, 4, 136, 1, 129, 75, 1, SAME},
    {"bc3", SHD_FORMAT_BC3, 16, 4, 137, 1, 130, 77, 0, SAME},
    {"bc3_srgb", SHD_FORMAT_BC3_SRGB, 16, 4, 138, 1, 130, 78, 1, SAME},
    {"bc4", SHD_FORMAT_BC4, 8, 4, 139, 1, 131, 80, 0, SAME},
    {"bc4_snorm", SHD_FORMAT_BC4_SNORM, 8, 4, 140, 1, 131, 81, 0, SAME},
    {"bc5", SHD_FORMAT_BC5, 16, 4, 141, 1, 132, 83, 0, SAME},
    {"bc5_snorm", SHD_FORMAT_BC5_SNORM, 16, 4, 142, 1, 132, 84, 0, SAME},
    {"bc6h_uf", SHD_FORMAT_BC6H_UFLOAT, 16, 4, 143, 1, 133, 95, 0, SAME},
    {"bc6h_sf", SHD_FORMAT_BC6H_SFLOAT, 16, 4, 144, 1, 133, 96, 0, SAME},
    {"bc7", SHD_FORMAT_BC7, 16, 4, 145, 1, 134, 98, 0, SAME},
    {"bc7_srgb", SHD_FORMAT_BC7_SRGB, 16, 4, 146, 1, 134, 99, 1, SAME},
};

/** Loads a file at an address that is aligned to nothing, or from a path. Frees the bytes. */
static inline shd_texture *load(io_bytes file, const shd_load_desc *desc, int by_path, shd_texture_file_info *info)
{
    shd_texture *texture = NULL;
    unsigned char *moved = (unsigned char *)malloc(file.size + 1);
    shd_result result;
    *info = shd_texture_file_info_default();
    memcpy(moved + 1, file.data, file.size);
    if (by_path) {
        io_write(io_path("texture"), file.data, file.size);
        result = load_file(g_context, io_path("texture"), desc, info, &texture);
    } else {
        result = load_file_memory(g_context, moved + 1, file.size, desc, info, &texture);
    }
    free(moved);
    free(file.data);
    if (file_is_absent(result)) skip();
    shd_assert_ok(result);
    return texture;
}

static inline file_ktx2 ktx2_of(const struct format_case *c)
{
    file_ktx2 k = {0};
    k.format = c->vulkan, k.type_size = c->type_size, k.model = c->model, k.transfer = c->srgb ? 2 : 1;
    return k;
}

static inline file_texture texture_of(const struct format_case *c, uint32_t width, uint32_t height, uint32_t levels)
{
    file_texture t = {0};
    t.width = width, t.height = height, t.faces = 1, t.level_count = levels;
    t.unit = c->unit, t.block_w = t.block_h = c->block;
    return t;
}

static inline void check_info(const shd_texture_file_info *info, shd_texture_file_kind kind, const file_texture *t,
                              shd_format format)
{
    assert_int_equal(info->kind, kind);
    assert_int_equal(info->format, format);
    assert_int_equal(info->width, t->width);
    assert_int_equal(info->height, t->height ? t->height : 1);
    assert_int_equal(info->depth, t->depth);
    assert_int_equal(info->layer_count, t->layers ? t->layers : 1);
    assert_int_equal(info->face_count, t->faces);
    assert_int_equal(info->level_count, t->level_count ? t->level_count : 1);
}

/** A kind of texture. */
struct kind_case {
    const char *name;
    uint32_t width, height, depth, layers, faces, levels, chosen;
};
static const struct kind_case k_kinds[] = {
    {"kind/1d", 9, 0, 0, 0, 1, 4, 0},           {"kind/2d", 8, 4, 0, 0, 1, 4, 0},
    {"kind/array", 10, 6, 0, 3, 1, 3, 0},       {"kind/array_of_one", 5, 5, 0, 1, 1, 1, 0},
    {"kind/3d", 6, 5, 7, 0, 1, 3, 0},           {"kind/3d_flat", 6, 5, 1, 0, 1, 3, 0},
    {"kind/cube", 12, 12, 0, 0, 6, 4, 0},       {"kind/cubes", 8, 8, 0, 3, 6, 2, 2},
    {"kind/base_alone", 12, 12, 0, 0, 1, 1, 0}, {"kind/levels_end", 64, 32, 0, 0, 1, 2, 0},
};

#endif /* SHD_TESTS_SUPPORT_TEXTURE_FORMATS_H */
