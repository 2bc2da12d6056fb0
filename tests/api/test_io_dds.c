/* SPDX-License-Identifier: MIT */
/* Block-compressed DDS files, BC1 to BC7: blocks are built field by field, and the values of a texture made from
 * them are compared. Block layouts: Microsoft, "Texture Block Compression in Direct3D 11". */
#include "support/check.h"
#include "support/dds_file.h"

#include <shd/io.h>
#include <shd/shd.h>

enum { BLOCK = 16 };

/** Appends bits to a block, lowest first. */
struct bits {
    unsigned char data[BLOCK];
    unsigned count;
};
static void put(struct bits *b, unsigned width, uint32_t value)
{
    unsigned i;
    for (i = 0; i < width; ++i, ++b->count) {
        b->data[b->count / 8] = (unsigned char)(b->data[b->count / 8] | (value >> i & 1u) << b->count % 8);
    }
}

/** In every block here texel (x, y) has index x, with `width` bits. The first index of BC6H and BC7 has no top bit. */
static void put_indices(struct bits *b, unsigned width, int anchored)
{
    uint32_t i;
    for (i = 0; i < 16; ++i) put(b, anchored && i == 0 ? width - 1 : width, i % 4);
}

/** Two endpoints of 5:6:5 bits, red 31 and blue 31 in four-colour order, then indices of 2 bits. */
static void put_bc1_color(struct bits *b)
{
    put(b, 16, 31u << 11);
    put(b, 16, 31u);
    put_indices(b, 2, 0);
}
/** Endpoints 210 and 0, six values between them; indices of 3 bits. */
static void put_bc4_channel(struct bits *b)
{
    put(b, 8, 210);
    put(b, 8, 0);
    put_indices(b, 3, 0);
}

static void make_bc1(struct bits *b) { put_bc1_color(b); }
static void make_bc2(struct bits *b)
{
    uint32_t i;
    for (i = 0; i < 16; ++i) put(b, 4, 5 * (i % 4));
    put_bc1_color(b);
}
static void make_bc3(struct bits *b)
{
    put_bc4_channel(b);
    put_bc1_color(b);
}
static void make_bc4(struct bits *b) { put_bc4_channel(b); }
static void make_bc5(struct bits *b)
{
    put_bc4_channel(b);
    put_bc4_channel(b);
}
/** Mode 11: one region, endpoints of 10 bits without transform, indices of 4 bits. */
static void make_bc6h(struct bits *b)
{
    static const uint32_t k_endpoints[6] = {0, 256, 512, 960, 256, 0};
    int i;
    put(b, 5, 3);
    for (i = 0; i < 6; ++i) put(b, 10, k_endpoints[i]);
    put_indices(b, 4, 1);
}
/** Mode 6: one region, endpoints of 7 bits and one shared low bit each, indices of 4 bits. */
static void make_bc7(struct bits *b)
{
    static const uint32_t k_endpoints[8] = {0, 100, 127, 127, 64, 0, 127, 20};
    int i;
    put(b, 7, 1u << 6);
    for (i = 0; i < 8; ++i) put(b, 7, k_endpoints[i]);
    put(b, 1, 0);
    put(b, 1, 1);
    put_indices(b, 4, 1);
}

/** Returns the value of two unquantised 10-bit endpoints of BC6H, blended by weight / 64 and converted to binary16. */
static double bc6h_value(uint32_t a, uint32_t b, uint32_t weight)
{
    const uint32_t low = a == 0 ? 0 : (a * 65536u + 32768u) >> 10, high = b == 0 ? 0 : (b * 65536u + 32768u) >> 10;
    const uint32_t half = (low * (64 - weight) + high * weight + 32) / 64 * 31 / 64;
    const int exponent = (int)(half >> 10);
    return exponent == 0 ? ldexp((double)half, -24) : ldexp((double)(1024 + half % 1024), exponent - 25);
}
static double bc7_value(uint32_t a, uint32_t b, uint32_t weight)
{
    return (double)((a * (64 - weight) + b * weight + 32) / 64) / 255;
}

/** Expected texel in column x of the block. */
static const double k_red[4] = {1, 0, 170 / 255.0, 85 / 255.0}, k_blue[4] = {0, 1, 85 / 255.0, 170 / 255.0};
static const double k_bc4[4] = {210 / 255.0, 0, 180 / 255.0, 150 / 255.0};
static const uint32_t k_weights4[4] = {0, 4, 9, 13};
static void want_color(int x, double *rgba)
{
    rgba[0] = k_red[x];
    rgba[1] = 0;
    rgba[2] = k_blue[x];
    rgba[3] = 1;
}
static void want_bc2(int x, double *rgba)
{
    want_color(x, rgba);
    rgba[3] = 5 * x / 15.0;
}
static void want_bc3(int x, double *rgba)
{
    want_color(x, rgba);
    rgba[3] = k_bc4[x];
}
static void want_bc4(int x, double *rgba)
{
    rgba[0] = k_bc4[x];
    rgba[1] = rgba[2] = -1; /* grey or 0: not part of the format */
    rgba[3] = 1;
}
static void want_bc5(int x, double *rgba)
{
    rgba[0] = rgba[1] = k_bc4[x];
    rgba[2] = -1;
    rgba[3] = 1;
}
static void want_bc6h(int x, double *rgba)
{
    rgba[0] = bc6h_value(0, 960, k_weights4[x]);
    rgba[1] = bc6h_value(256, 256, k_weights4[x]);
    rgba[2] = bc6h_value(512, 0, k_weights4[x]);
    rgba[3] = 1;
}
static void want_bc7(int x, double *rgba)
{
    rgba[0] = bc7_value(0, 201, k_weights4[x]);
    rgba[1] = bc7_value(254, 255, k_weights4[x]);
    rgba[2] = bc7_value(128, 1, k_weights4[x]);
    rgba[3] = bc7_value(254, 41, k_weights4[x]);
}

struct dds_case {
    const char *name;
    const char *code; /**< four-character code of the header; "DX10" = a second header with dxgi_format follows */
    uint32_t dxgi_format;
    unsigned block_size;
    void (*make)(struct bits *b);
    void (*want)(int x, double *rgba);
};
static const struct dds_case k_cases[] = {
    {"bc1", "DXT1", 0, 8, make_bc1, want_color}, {"bc2", "DXT3", 0, 16, make_bc2, want_bc2},
    {"bc3", "DXT5", 0, 16, make_bc3, want_bc3},  {"bc4", "DX10", 80, 8, make_bc4, want_bc4},
    {"bc5", "DX10", 83, 16, make_bc5, want_bc5}, {"bc6h", "DX10", 95, 16, make_bc6h, want_bc6h},
    {"bc7", "DX10", 98, 16, make_bc7, want_bc7},
};

/** A file of 4 x 4 texels. */
static size_t make_file(const struct dds_case *c, unsigned char *file)
{
    struct bits block;
    size_t size;
    memset(&block, 0, sizeof block);
    c->make(&block);
    assert_int_equal(block.count, 8 * c->block_size);
    size = shd_dds_header(c->code, c->dxgi_format, 4, 4, c->block_size, file);
    memcpy(file + size, block.data, c->block_size);
    return size + c->block_size;
}

static shd_texture *make_texture(shd_context *context, const shd_bitmap *bitmap)
{
    shd_image image = shd_image_default();
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(image.width, 4);
    assert_int_equal(image.height, 4);
    desc.format = image.format;
    desc.width = image.width;
    desc.height = image.height;
    desc.texels = image.pixels;
    desc.row_stride = image.row_stride;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

static void test_block(void **state)
{
    const struct dds_case *c = (const struct dds_case *)*state;
    unsigned char file[SHD_DDS_HEADER + BLOCK];
    float u[16], v[16], rgba[4][16];
    const size_t size = make_file(c, file);
    shd_context *context = NULL;
    shd_bitmap *bitmap = NULL;
    shd_sampler *sampler = NULL;
    shd_texture *texture;
    shd_load_desc load = shd_load_desc_default();
    shd_sampler_desc nearest = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels out;
    int i, k;
    shd_assert_ok(shd_context_create(NULL, &context));
    load.encoding = SHD_COLOR_ENCODING_DATA; /* the codes without conversion */
    shd_assert_ok(shd_bitmap_load_memory(context, file, size, &load, &bitmap));
    texture = make_texture(context, bitmap);
    nearest.filter = SHD_FILTER_NEAREST;
    shd_assert_ok(shd_sampler_create(context, &nearest, &sampler));
    for (i = 0; i < 16; ++i) {
        u[i] = ((float)(i % 4) + 0.5f) / 4;
        v[i] = ((float)(i / 4) + 0.5f) / 4;
    }
    lookups.count = 16;
    lookups.u.data = u;
    lookups.v.data = v;
    memset(&out, 0, sizeof out);
    for (k = 0; k < 4; ++k) out.channel[k].data = rgba[k];
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &out));
    for (i = 0; i < 16; ++i) {
        double want[4];
        c->want(i % 4, want);
        for (k = 0; k < 4; ++k) {
            if (want[k] >= 0) shd_assert_close(c->name, (size_t)(4 * i + k), (double)rgba[k][i], want[k], 2e-6, 1e-6);
        }
    }
    shd_sampler_release(sampler);
    shd_texture_release(texture);
    shd_bitmap_release(bitmap);
    shd_context_release(context);
}

/** Every file, truncated at every byte, gives an error and no crash. */
static void test_truncated(void **state)
{
    const struct dds_case *c = (const struct dds_case *)*state;
    unsigned char file[SHD_DDS_HEADER + BLOCK];
    const size_t size = make_file(c, file);
    size_t cut;
    shd_context *context = NULL;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (cut = 0; cut < size; ++cut) {
        shd_bitmap *bitmap = NULL;
        assert_int_not_equal(shd_bitmap_load_memory(context, file, cut, NULL, &bitmap), SHD_OK);
        assert_null(bitmap);
    }
    shd_context_release(context);
}

int main(void)
{
    struct CMUnitTest tests[16];
    static char names[16][32];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_cases / sizeof k_cases[0]; ++i) {
        snprintf(names[n], sizeof names[n], "block/%s", k_cases[i].name);
        tests[n] = (struct CMUnitTest){names[n], test_block, NULL, NULL, (void *)&k_cases[i]};
        ++n;
        snprintf(names[n], sizeof names[n], "truncated/%s", k_cases[i].name);
        tests[n] = (struct CMUnitTest){names[n], test_truncated, NULL, NULL, (void *)&k_cases[i]};
        ++n;
    }
    return _cmocka_run_group_tests("api.io_dds", tests, n, NULL, NULL);
}
