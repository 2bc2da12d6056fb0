/* SPDX-License-Identifier: MIT */
/* Files of voxels: every kind of number in both byte orders, texel for texel; wrong sizes, limits and descs. */
#define _GNU_SOURCE
#include "support/loads.h"
#include "support/volume_files.h"

#include <shd/shd.h>

enum { W = 5, H = 3, D = 4, COUNT = W * H * D };

static shd_context *g_context;

/** A kind of number: its size, and the format of its textures without channels. */
struct kind {
    shd_raw_sample sample;
    size_t size;
    shd_format format[4];
};
static const struct kind k_kinds[] = {
    {SHD_RAW_SAMPLE_U8, 1, {SHD_FORMAT_R8, SHD_FORMAT_RG8, SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8}},
    {SHD_RAW_SAMPLE_U16, 2, {SHD_FORMAT_R16, SHD_FORMAT_RG16, SHD_FORMAT_RGB16, SHD_FORMAT_RGBA16}},
    {SHD_RAW_SAMPLE_F16, 2, {SHD_FORMAT_R16F, SHD_FORMAT_RG16F, SHD_FORMAT_RGB16F, SHD_FORMAT_RGBA16F}},
    {SHD_RAW_SAMPLE_F32, 4, {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F}},
    {SHD_RAW_SAMPLE_I8, 1, {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F}},
    {SHD_RAW_SAMPLE_I16, 2, {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F}},
    {SHD_RAW_SAMPLE_U32, 4, {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F}},
    {SHD_RAW_SAMPLE_I32, 4, {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F}},
};

static shd_raw_desc make_desc(void)
{
    shd_raw_desc desc = shd_raw_desc_default();
    desc.width = W, desc.height = H, desc.depth = D;
    return desc;
}

/* Bits of number i, of at most 32 bits. */
static uint32_t bits_of(uint32_t i)
{
    uint32_t h = i * 2654435761u + 12345u;
    return h ^ h >> 13;
}

/* Number i as the texture stores it: its bytes in the machine's order, or a float. */
static void expect_number(const struct kind *kind, uint32_t i, unsigned char *out)
{
    const uint32_t bits = bits_of(i);
    const unsigned char byte = (unsigned char)bits;
    const uint16_t word = (uint16_t)bits;
    float value;
    switch (kind->sample) {
        case SHD_RAW_SAMPLE_U8: memcpy(out, &byte, 1); return;
        case SHD_RAW_SAMPLE_U16:
        case SHD_RAW_SAMPLE_F16: memcpy(out, &word, 2); return;
        case SHD_RAW_SAMPLE_F32: memcpy(out, &bits, 4); return;
        case SHD_RAW_SAMPLE_I8: value = (float)(signed char)byte; break;
        case SHD_RAW_SAMPLE_I16: value = (float)(int16_t)word; break;
        case SHD_RAW_SAMPLE_U32: value = (float)bits; break;
        default: value = (float)(int32_t)bits; break;
    }
    memcpy(out, &value, sizeof value);
}

/* Writes a header of 0xaa and `count` numbers. */
static const char *write_numbers(const struct kind *kind, size_t count, shd_byte_order order, size_t header)
{
    static unsigned char file[64 + 16 * COUNT];
    const char *path = io_path("voxels.raw");
    size_t i, b;
    memset(file, 0xaa, header);
    for (i = 0; i < count; ++i) {
        for (b = 0; b < kind->size; ++b) {
            const size_t byte = order == SHD_BYTE_ORDER_BIG ? kind->size - 1 - b : b;
            file[header + i * kind->size + b] = (unsigned char)(bits_of((uint32_t)i) >> 8 * byte);
        }
    }
    io_write(path, file, header + count * kind->size);
    return path;
}

/* A format of three channels is stored as four. */
static void check_texels(const struct kind *kind, uint32_t channels, int flipped, const shd_texture *texture)
{
    shd_texture_info info;
    io_bytes got = io_read_texels(texture, &info);
    const size_t stored = kind->format[0] == SHD_FORMAT_R32F ? 4 : kind->size, pixel = shd_format_size(info.format);
    uint32_t i, c;
    assert_true(info.width == W && info.height == H && info.depth == D);
    assert_int_equal(info.format, kind->format[channels == 3 ? 3 : channels - 1]);
    for (i = 0; i < COUNT; ++i) {
        const uint32_t y = i / W % H, row = flipped ? H - 1 - y : y;
        const uint32_t from = i - y * W + row * W;
        for (c = 0; c < channels; ++c) {
            unsigned char want[4];
            expect_number(kind, from * channels + c, want);
            assert_memory_equal(got.data + i * pixel + c * stored, want, stored);
        }
    }
    free(got.data);
}

static void test_numbers(void **state)
{
    const struct kind *kind = (const struct kind *)*state;
    uint32_t channels;
    int order, flip;
    for (channels = 1; channels <= 4; ++channels) {
        for (order = 0; order < 2; ++order) {
            for (flip = 0; flip < 2; ++flip) {
                const size_t header = channels * 3 - 3;
                shd_raw_desc desc = make_desc();
                shd_load_desc load = shd_load_desc_default();
                shd_texture *texture = NULL;
                const char *path = write_numbers(kind, COUNT * channels, (shd_byte_order)order, header);
                desc.sample = kind->sample;
                desc.channel_count = channels;
                desc.byte_order = (shd_byte_order)order;
                desc.header_bytes = flip ? SHD_RAW_HEADER_REST : header;
                load.flags = flip ? SHD_LOAD_FLIP_V : 0;
                shd_assert_ok(load_raw(g_context, path, &desc, &load, &texture));
                check_texels(kind, channels, flip, texture);
                shd_texture_release(texture);
            }
        }
    }
}

/* Every wrong size of the file. */
static void test_sizes(void **state)
{
    enum { HEADER = 11, WHOLE = HEADER + 2 * COUNT };
    unsigned char bytes[WHOLE + 5] = {0};
    shd_raw_desc desc = make_desc();
    size_t size;
    (void)state;
    desc.sample = SHD_RAW_SAMPLE_U16;
    desc.header_bytes = HEADER;
    for (size = 0; size < sizeof bytes; ++size) {
        const shd_result expected = size == WHOLE ? SHD_OK : SHD_ERROR_CORRUPT;
        shd_texture *texture = (shd_texture *)g_context;
        io_write(io_path("cut.raw"), bytes, size);
        shd_assert_result("size", load_raw(g_context, io_path("cut.raw"), &desc, NULL, &texture), expected,
                          size == 0 ? "is empty" : "not 11 of a header and 120 of 5 x 3 x 4 voxels");
        assert_true((texture != NULL) == (size == WHOLE));
        shd_texture_release(texture);
    }
    desc.header_bytes = SHD_RAW_HEADER_REST;
    for (size = 2 * COUNT - 3; size < sizeof bytes; ++size) {
        shd_texture *texture = NULL;
        io_write(io_path("cut.raw"), bytes, size);
        shd_assert_result("rest", load_raw(g_context, io_path("cut.raw"), &desc, NULL, &texture),
                          size < 2 * COUNT ? SHD_ERROR_CORRUPT : SHD_OK, "of 5 x 3 x 4 voxels");
        shd_texture_release(texture);
    }
}

/** A desc that is refused. The file has the 60 bytes of the default one. */
struct bad_case {
    const char *name;
    shd_result expected;
    const char *message;
    uint32_t width, height, depth; /* 0 = the default one; ~0 = 0 */
    uint32_t sample, channels, order;
    uint64_t header;
    uint32_t load_flags, tables;
    uint64_t max_pixels, max_bytes, max_file_bytes;
};
#define ARGUMENT SHD_ERROR_INVALID_ARGUMENT
static const struct bad_case k_bad[] = {
    {"zero_width", ARGUMENT, "raw.width: 0 is not in 1..65536", .width = ~0u},
    {"zero_height", ARGUMENT, "raw.height: 0 is not in 1..65536", .height = ~0u},
    {"zero_depth", ARGUMENT, "raw.depth: 0 is not in 1..65536", .depth = ~0u},
    {"wide", ARGUMENT, "raw.width: 65537 is not in 1..65536", .width = 65537},
    {"deep", ARGUMENT, "raw.depth: 4294967294 is not in", .depth = ~1u},
    {"sample", ARGUMENT, "raw.sample: 8 is not a shd_raw_sample", .sample = 8},
    {"channels", ARGUMENT, "raw.channel_count: 5 is not in 1..4", .channels = 5},
    {"no_channels", ARGUMENT, "raw.channel_count: 0 is not in 1..4", .channels = ~0u},
    {"byte_order", ARGUMENT, "raw.byte_order: 2 is not a shd_byte_order", .order = 2},
    {"load_flags", SHD_ERROR_UNSUPPORTED, "load.flags: bits 0x2 have no meaning for a file of voxels",
     .load_flags = SHD_LOAD_PARTIAL},
    {"tables", SHD_ERROR_UNSUPPORTED, "load.tables: 0x4, but a 3D texture", .tables = SHD_TABLE_SUMMED_AREA},
    {"header_beyond", SHD_ERROR_CORRUPT, "has 60 bytes, not 61 of a header", .header = 61},
    {"header_huge", SHD_ERROR_CORRUPT, "has 60 bytes, not 18446744073709551556 of a header",
     .header = 0xffffffffffffffc4u}, /* + 60 = 2^64 */
    {"product", SHD_ERROR_LIMIT, "volume of 65536 x 65536 x 65536 voxels is above load.max_pixels 268435456",
     .width = 65536, .height = 65536, .depth = 65536},
    {"product_32_bits", SHD_ERROR_LIMIT, "above load.max_pixels", .width = 65536, .height = 65536, .depth = 1},
    {"product_no_budget", SHD_ERROR_CORRUPT, "not 0 of a header and 4503599627370496 of", .width = 65536,
     .height = 65536, .depth = 65536, .sample = SHD_RAW_SAMPLE_F32, .channels = 4, .max_pixels = ~(uint64_t)0,
     .max_bytes = ~(uint64_t)0},
    {"pixels", SHD_ERROR_LIMIT, "volume of 5 x 3 x 4 voxels is above load.max_pixels 59", .max_pixels = 59},
    {"bytes", SHD_ERROR_LIMIT, "60 decoded bytes are above load.max_bytes 59", .max_bytes = 59},
    {"converted_bytes", SHD_ERROR_LIMIT, "240 decoded bytes are above", .sample = SHD_RAW_SAMPLE_I8, .max_bytes = 239},
    {"file_bytes", SHD_ERROR_LIMIT, "has 60 bytes, above load.max_file_bytes 59", .max_file_bytes = 59},
    {"whole", SHD_OK, "", .max_pixels = 60, .max_bytes = 60, .max_file_bytes = 60},
};

static void test_bad(void **state)
{
    const struct bad_case *c = (const struct bad_case *)*state;
    shd_raw_desc desc = make_desc();
    shd_load_desc load = shd_load_desc_default();
    shd_texture *texture = (shd_texture *)g_context;
    const char *path = write_numbers(&k_kinds[0], COUNT, SHD_BYTE_ORDER_LITTLE, 0);
    if (c->width) desc.width = c->width == ~0u ? 0 : c->width;
    if (c->height) desc.height = c->height == ~0u ? 0 : c->height;
    if (c->depth) desc.depth = c->depth == ~0u ? 0 : c->depth;
    if (c->channels) desc.channel_count = c->channels == ~0u ? 0 : c->channels;
    desc.sample = (shd_raw_sample)c->sample;
    desc.byte_order = (shd_byte_order)c->order;
    desc.header_bytes = c->header;
    load.flags = c->load_flags;
    if (c->tables) load.tables = c->tables;
    if (c->max_pixels) load.max_pixels = c->max_pixels;
    if (c->max_bytes) load.max_bytes = c->max_bytes;
    if (c->max_file_bytes) load.max_file_bytes = c->max_file_bytes;
    shd_assert_result(c->name, load_raw(g_context, path, &desc, &load, &texture), c->expected, c->message);
    assert_true((texture != NULL) == (c->expected == SHD_OK));
    shd_texture_release(texture);
}

static void test_arguments(void **state)
{
    const shd_raw_desc desc = make_desc();
    const char *path = write_numbers(&k_kinds[0], COUNT, SHD_BYTE_ORDER_LITTLE, 0);
    shd_texture *texture = NULL;
    shd_texture_info info = shd_texture_info_default();
    (void)state;
    shd_assert_result("context", load_raw(NULL, path, &desc, NULL, &texture), ARGUMENT, "context: NULL");
    shd_assert_result("path", load_raw(g_context, NULL, &desc, NULL, &texture), ARGUMENT, "path: NULL");
    shd_assert_result("out", load_raw(g_context, path, &desc, NULL, NULL), ARGUMENT, "out_texture: NULL");
    shd_assert_result("absent", load_raw(g_context, io_path("absent.raw"), &desc, NULL, &texture), SHD_ERROR_NOT_FOUND,
                      "absent.raw");
    shd_assert_result("folder", load_raw(g_context, "/", &desc, NULL, &texture), SHD_ERROR_IO, "is not a regular file");
    shd_assert_ok(load_raw(g_context, path, &desc, NULL, &texture));
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.level_count, 3); /* the default tables: 5 x 3 x 4, 2 x 1 x 2, 1 x 1 x 1 */
    shd_texture_release(texture);
}

int main(void)
{
    enum { KINDS = sizeof k_kinds / sizeof k_kinds[0], BAD = sizeof k_bad / sizeof k_bad[0] };
    static const char *const names[KINDS] = {"numbers/u8", "numbers/u16", "numbers/f16", "numbers/f32",
                                             "numbers/i8", "numbers/i16", "numbers/u32", "numbers/i32"};
    struct CMUnitTest tests[KINDS + BAD + 2];
    char bad_names[BAD][64];
    size_t i, n = 0;
    int failed;
    void *state = NULL;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < KINDS; ++i)
        tests[n++] = (struct CMUnitTest){names[i], test_numbers, NULL, NULL, (void *)&k_kinds[i]};
    for (i = 0; i < BAD; ++i) {
        snprintf(bad_names[i], sizeof bad_names[i], "bad/%s", k_bad[i].name);
        tests[n++] = (struct CMUnitTest){bad_names[i], test_bad, NULL, NULL, (void *)&k_bad[i]};
    }
    tests[n++] = (struct CMUnitTest){"sizes", test_sizes, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"arguments", test_arguments, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.io_raw", tests, n, NULL, NULL);
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
