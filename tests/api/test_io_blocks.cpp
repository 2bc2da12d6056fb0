// SPDX-License-Identifier: MIT
/* Compressed textures against the texels that OpenImageIO decodes from a DDS file of the same random blocks. BC6H and
 * BC7 are exact by their specification. OpenImageIO rounds the others to 8 bits in its own way. */
#include <OpenImageIO/imagebuf.h>

#include <vector>

#include <shd/io.h>
#include <shd/shd.h>

#include "support/check.h"
#include "support/dds_file.h"
#include "support/io_files.h"

enum { SIDE = 256, TEXELS = SIDE * SIDE, BLOCKS = TEXELS / 16, MOST_BYTES = SHD_DDS_HEADER + 16 * BLOCKS };

struct block_case {
    const char *name;
    shd_format format;
    const char *code; /**< see shd_dds_header() */
    uint32_t dxgi_format;
    int channels;     /**< that OpenImageIO and shd both have */
    double tolerance; /**< for values in 0..1 */
};
static const struct block_case k_cases[] = {
    {"bc1", SHD_FORMAT_BC1_RGBA, "DXT1", 0, 4, 1.001 / 255},
    {"bc2", SHD_FORMAT_BC2, "DXT3", 0, 4, 1.001 / 255},
    {"bc3", SHD_FORMAT_BC3, "DXT5", 0, 4, 1.001 / 255},
    {"bc4", SHD_FORMAT_BC4, "DX10", 80, 1, 1.001 / 255},
    {"bc5", SHD_FORMAT_BC5, "DX10", 83, 2, 1.001 / 255},
    {"ati1", SHD_FORMAT_BC4, "ATI1", 0, 1, 1.001 / 255},
    {"bc4u", SHD_FORMAT_BC4, "BC4U", 0, 1, 1.001 / 255},
    {"ati2", SHD_FORMAT_BC5, "ATI2", 0, 2, 1.001 / 255},
    {"bc5u", SHD_FORMAT_BC5, "BC5U", 0, 2, 1.001 / 255},
    {"bc6h", SHD_FORMAT_BC6H_UFLOAT, "DX10", 95, 3, 0},
    {"bc7", SHD_FORMAT_BC7, "DX10", 98, 4, 1e-7}, /* OpenImageIO multiplies by 1 / 255 */
};

static unsigned char s_file[MOST_BYTES];
static float s_u[TEXELS], s_v[TEXELS], s_decoded[4][TEXELS], s_own[4][TEXELS], s_bitmap[4][TEXELS];

static uint32_t random_bits(void)
{
    static uint32_t state = 12345;
    state = state * 1664525u + 1013904223u;
    return state >> 8;
}

/** Gives block i one of the modes of its format: each of them occurs equally often. */
static void set_mode(shd_format format, unsigned i, unsigned char *block)
{
    static const unsigned char k_bc6h[14] = {0, 1, 2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11, 15};
    if (format == SHD_FORMAT_BC7) {
        const unsigned bit = 1u << (i % 8);
        block[0] = (unsigned char)((block[0] & ~(2 * bit - 1)) | bit);
    } else if (format == SHD_FORMAT_BC6H_UFLOAT) {
        const unsigned char mode = k_bc6h[i % 14];
        block[0] = (unsigned char)((block[0] & (mode < 2 ? ~3u : ~31u)) | mode);
    }
}

/** Writes s_file. Returns the size of its header; *out_size: of all. */
static size_t make_file(const struct block_case *c, size_t *out_size)
{
    const size_t block_size = shd_format_block_size(c->format), data_size = block_size * BLOCKS;
    const size_t header = shd_dds_header(c->code, c->dxgi_format, SIDE, SIDE, (uint32_t)data_size, s_file);
    size_t i;
    for (i = 0; i < data_size; ++i) s_file[header + i] = (unsigned char)random_bits();
    for (i = 0; i < BLOCKS; ++i) set_mode(c->format, (unsigned)i, s_file + header + i * block_size);
    *out_size = header + data_size;
    return header;
}

static void make_places(void)
{
    int i;
    for (i = 0; i < TEXELS; ++i) {
        s_u[i] = ((float)(i % SIDE) + 0.5f) / SIDE;
        s_v[i] = ((float)(i / SIDE) + 0.5f) / SIDE;
    }
}

/** Reads every texel. */
static void read_texels(shd_context *context, shd_format format, const void *texels, float (*out)[TEXELS])
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_sampler_desc nearest = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels columns = shd_texels_default();
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    int k;
    desc.format = format;
    desc.width = desc.height = SIDE;
    desc.texels = texels;
    nearest.filter = SHD_FILTER_NEAREST;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    shd_assert_ok(shd_sampler_create(context, &nearest, &sampler));
    lookups.count = TEXELS;
    lookups.u.data = s_u;
    lookups.v.data = s_v;
    for (k = 0; k < 4; ++k) columns.channel[k].data = out[k];
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &columns));
    shd_sampler_release(sampler);
    shd_texture_release(texture);
}

/** The texels that OpenImageIO decodes. */
static void decode_file(const char *name, size_t size)
{
    const char *path = io_path(name);
    io_write(path, s_file, size);
    OIIO::ImageBuf image(path);
    const int channels = image.nchannels();
    std::vector<float> pixels(static_cast<size_t>(channels) * TEXELS);
    assert_true(image.get_pixels(OIIO::ROI(0, SIDE, 0, SIDE, 0, 1, 0, channels), OIIO::TypeFloat, pixels.data()));
    for (size_t i = 0; i < TEXELS; ++i) {
        const float *pixel = &pixels[i * static_cast<size_t>(channels)];
        for (int k = 0; k < channels && k < 4; ++k) s_decoded[k][i] = pixel[k];
    }
}

static void test_blocks(void **state)
{
    const struct block_case *c = (const struct block_case *)*state;
    shd_load_desc load = shd_load_desc_default();
    shd_image image = shd_image_default();
    shd_context *context = NULL;
    shd_bitmap *bitmap = NULL;
    size_t size, i;
    const size_t header = make_file(c, &size);
    int k;
    make_places();
    load.encoding = SHD_COLOR_ENCODING_DATA;
    shd_assert_ok(shd_context_create(NULL, &context));
    decode_file(c->name, size);
    read_texels(context, c->format, s_file + header, s_own);
    shd_assert_ok(shd_bitmap_load_memory(context, s_file, size, &load, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(image.width, SIDE);
    assert_int_equal(image.height, SIDE);
    assert_int_equal(image.row_stride, SIDE * shd_format_size(image.format));
    read_texels(context, image.format, image.pixels, s_bitmap);
    for (k = 0; k < c->channels; ++k) {
        for (i = 0; i < TEXELS; ++i) {
            shd_assert_close(c->name, 4 * i + (size_t)k, (double)s_own[k][i], (double)s_decoded[k][i], c->tolerance, 0);
            assert_true(s_bitmap[k][i] == s_own[k][i]);
        }
    }
    shd_bitmap_release(bitmap);
    shd_context_release(context);
}

int main(void)
{
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0) return 1;
    struct CMUnitTest tests[sizeof k_cases / sizeof k_cases[0]];
    size_t i;
    for (i = 0; i < sizeof k_cases / sizeof k_cases[0]; ++i) {
        tests[i] = {k_cases[i].name, test_blocks, NULL, NULL, (void *)&k_cases[i]};
    }
    failed = _cmocka_run_group_tests("api.io_blocks", tests, i, NULL, NULL);
    io_remove_folder(&state);
    return failed;
}
