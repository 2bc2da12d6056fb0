/* SPDX-License-Identifier: MIT */
/* TGA files with palettes, run-length packets and damaged headers: valid ones have the expected pixels, the others are
 * refused before the decoder reads memory outside its buffers. Layout: Truevision, "TGA File Format Specification". */
#define _GNU_SOURCE
#include "support/io_files.h"

#include <shd/shd.h>

static shd_context *g_context;

/** A file and the colours of its pixels, or how it is refused. */
struct tga_case {
    const char *name;
    shd_result expected;
    const char *message; /* text of the failure */
    unsigned char rgb[4][3];
    size_t pixels;
    size_t size;
    unsigned char bytes[64];
};

#define OUTSIDE SHD_ERROR_CORRUPT, "TGA: a pixel is outside the palette", {{0}}, 0
#define CUT SHD_ERROR_CORRUPT, "TGA: cut off", {{0}}, 0
#define BAD_PALETTE SHD_ERROR_CORRUPT, "TGA: bad palette", {{0}}, 0
#define KIND SHD_ERROR_UNSUPPORTED, "TGA: kind", {{0}}, 0

/* Header: kind, first palette index, palette length and entry bits, width, height, pixel bits. Rows from the top. */
#define TGA(kind, first, length, bits, width, height, depth) \
    0, (length) > 0, kind, first, 0, length, 0, bits, 0, 0, 0, 0, width, 0, height, 0, depth, 0x20
#define PALETTE2 3, 2, 1, 6, 5, 4 /* (1, 2, 3) and (4, 5, 6), stored b, g, r */
#define TWO SHD_OK, "", {{1, 2, 3}, {4, 5, 6}}, 2

static const struct tga_case k_cases[] = {
    {"palette8", TWO, 26, {TGA(1, 0, 2, 24, 2, 1, 8), PALETTE2, 0, 1}},
    {"palette8/last_is_outside", OUTSIDE, 26, {TGA(1, 0, 2, 24, 2, 1, 8), PALETTE2, 0, 2}},
    {"palette8/255", OUTSIDE, 26, {TGA(1, 0, 2, 24, 2, 1, 8), PALETTE2, 255, 0}},
    {"palette8/cut", CUT, 25, {TGA(1, 0, 2, 24, 2, 1, 8), PALETTE2, 0}},
    {"palette8/id", TWO, 28, {2, 1, 1, 0, 0, 2, 0, 24, 0, 0, 0, 0, 2, 0, 1, 0, 8, 0x20, 'i', 'd', PALETTE2, 0, 1}},
    {"palette8/bits32",
     SHD_OK,
     "",
     {{1, 2, 3}, {5, 6, 7}},
     2,
     28,
     {TGA(1, 0, 2, 32, 2, 1, 8), 3, 2, 1, 4, 7, 6, 5, 8, 0, 1}},
    {"palette8/bits16",
     SHD_OK,
     "",
     {{255, 0, 0}, {0, 0, 255}},
     2,
     24,
     {TGA(1, 0, 2, 16, 2, 1, 8), 0x00, 0x7c, 0x1f, 0x00, 0, 1}},
    {"palette8/starts_at_2",
     SHD_ERROR_UNSUPPORTED,
     "TGA: a palette that starts at index 2",
     {{0}},
     0,
     26,
     {TGA(1, 2, 2, 24, 2, 1, 8), PALETTE2, 2, 3}},
    {"palette8/starts_at_65535",
     SHD_ERROR_UNSUPPORTED,
     "starts at index 65535",
     {{0}},
     0,
     26,
     {0, 1, 1, 255, 255, 2, 0, 24, 0, 0, 0, 0, 2, 0, 1, 0, 8, 0x20, PALETTE2, 0, 1}},
    {"palette8/palette_is_cut", BAD_PALETTE, 20, {TGA(1, 0, 2, 24, 2, 1, 8), 3, 2}},
    {"palette8/palette_is_empty", OUTSIDE, 20, {0, 1, 1, 0, 0, 0, 0, 24, 0, 0, 0, 0, 2, 0, 1, 0, 8, 0x20, 0, 0}},
    {"palette16", TWO, 28, {TGA(1, 0, 2, 24, 2, 1, 16), PALETTE2, 0, 0, 1, 0}},
    {"palette16/outside", OUTSIDE, 28, {TGA(1, 0, 2, 24, 2, 1, 16), PALETTE2, 0, 0, 0, 1}},
    {"palette16/cut", CUT, 27, {TGA(1, 0, 2, 24, 2, 1, 16), PALETTE2, 0, 0, 1}},
    {"palette24", KIND, 30, {TGA(1, 0, 2, 24, 2, 1, 24), PALETTE2, 0, 0, 0, 1, 0, 0}},
    {"palette32", KIND, 32, {TGA(1, 0, 2, 24, 2, 1, 32), PALETTE2, 0, 0, 0, 0, 1, 0, 0, 0}},
    {"packed8/run", SHD_OK, "", {{4, 5, 6}, {4, 5, 6}}, 2, 26, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 0x81, 1}},
    {"packed8/raw", TWO, 27, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 1, 0, 1}},
    {"packed8/long_run", SHD_OK, "", {{4, 5, 6}, {4, 5, 6}}, 2, 26, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 0xff, 1}},
    {"packed8/long_raw", TWO, 27, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 127, 0, 1}},
    {"packed8/run_across_rows",
     SHD_OK,
     "",
     {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {4, 5, 6}},
     4,
     28,
     {TGA(9, 0, 2, 24, 2, 2, 8), PALETTE2, 0x82, 0, 0, 1}},
    {"packed8/run_outside", OUTSIDE, 26, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 0x81, 2}},
    {"packed8/raw_outside", OUTSIDE, 27, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 1, 0, 2}},
    {"packed8/second_packet_outside", OUTSIDE, 28, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 0, 0, 0, 9}},
    {"packed8/no_packet", CUT, 24, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2}},
    {"packed8/cut", CUT, 25, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 0x81}},
    {"packed8/raw_cut", CUT, 26, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 1, 0}},
    {"packed8/second_packet_cut", CUT, 26, {TGA(9, 0, 2, 24, 2, 1, 8), PALETTE2, 0x80, 0}},
    {"packed16/run", SHD_OK, "", {{4, 5, 6}, {4, 5, 6}}, 2, 27, {TGA(9, 0, 2, 24, 2, 1, 16), PALETTE2, 0x81, 1, 0}},
    {"packed16/run_outside", OUTSIDE, 27, {TGA(9, 0, 2, 24, 2, 1, 16), PALETTE2, 0x81, 0, 1}},
    {"packed16/starts_at_1",
     SHD_ERROR_UNSUPPORTED,
     "starts at index 1",
     {{0}},
     0,
     27,
     {TGA(9, 1, 2, 24, 2, 1, 16), PALETTE2, 0x81, 1, 0}},
    {"rgb8", KIND, 20, {TGA(2, 0, 0, 0, 2, 1, 8), 1, 2}},
    {"rgb24", TWO, 24, {TGA(2, 0, 0, 0, 2, 1, 24), PALETTE2}},
    {"rgb24/unused_palette", TWO, 30, {TGA(2, 0, 2, 24, 2, 1, 24), 9, 9, 9, 9, 9, 9, PALETTE2}},
    {"rgb24/cut", CUT, 23, {TGA(2, 0, 0, 0, 2, 1, 24), 3, 2, 1, 6, 5}},
    {"rgb24/packed", TWO, 25, {TGA(10, 0, 0, 0, 2, 1, 24), 1, PALETTE2}},
    {"rgb24/packed_cut", CUT, 24, {TGA(10, 0, 0, 0, 2, 1, 24), 1, 3, 2, 1, 6, 5}},
    {"grey8", SHD_OK, "", {{7, 7, 7}, {9, 9, 9}}, 2, 20, {TGA(3, 0, 0, 0, 2, 1, 8), 7, 9}},
    {"grey15", KIND, 22, {TGA(3, 0, 0, 0, 2, 1, 15), 7, 9, 7, 9}},
    {"grey24", KIND, 24, {TGA(3, 0, 0, 0, 2, 1, 24), 7, 9, 7, 9, 7, 9}},
    {"grey32", KIND, 26, {TGA(11, 0, 0, 0, 2, 1, 32), 0x81, 7, 9, 7, 9, 7, 9, 7}},
    /* Two files of a few bytes that end a decoder without these checks: no palette, and an index far outside. */
    {"crash/empty_palette", KIND, 23, {0, 1, 9, 0, 0,  0,    0,    16,   0xab, 0xb0, 0x95, 0x1c,
                                       3, 0, 1, 0, 32, 0x23, 0xed, 0xea, 0x45, 0x23, 0xf9}},
    {"crash/26_bytes", KIND, 26, {0, 1, 9, 0x4f, 0,    0, 0,    15,   0xab, 0xbd, 0x5e, 0xd2, 3,
                                  0, 2, 0, 24,   0x1a, 6, 0xdc, 0x85, 0xa4, 5,    0x23, 0x1b, 0x93}},
};

/* Loads a file twice. The results must be equal; returns the hash of the pixels, 0 for a failure. */
static uint64_t load_twice(const char *name, const void *bytes, size_t size, shd_load_flags flags, shd_result *result)
{
    shd_load_desc desc = shd_load_desc_default();
    uint64_t hash[2] = {0, 0};
    shd_result results[2];
    int i;
    desc.flags = flags;
    for (i = 0; i < 2; ++i) {
        shd_bitmap *bitmap = NULL;
        void *copy = malloc(size); /* its size is exact, so that memory checkers find reads beyond it */
        memcpy(copy, bytes, size);
        results[i] = shd_bitmap_load_memory(g_context, copy, size, &desc, &bitmap);
        if (bitmap) hash[i] = io_hash_bitmap(bitmap);
        free(copy);
        shd_bitmap_release(bitmap);
    }
    if (results[0] != results[1] || hash[0] != hash[1]) fail_msg("%s: two loads differ", name);
    *result = results[0];
    return hash[0];
}

/* Loads twice in the default setting and twice in this process: all four are equal. */
static uint64_t load_all(const char *name, const void *bytes, size_t size, shd_result *result)
{
    shd_result in_process;
    const uint64_t hash = load_twice(name, bytes, size, SHD_LOAD_NONE, result);
    if (load_twice(name, bytes, size, SHD_LOAD_IN_PROCESS, &in_process) != hash || in_process != *result) {
        fail_msg("%s: loads by the worker and in process differ", name);
    }
    return hash;
}

static void test_case(void **state)
{
    const struct tga_case *c = (const struct tga_case *)*state;
    shd_image image = shd_image_default();
    shd_bitmap *bitmap = NULL;
    shd_result result, partial;
    size_t i;
    load_all(c->name, c->bytes, c->size, &result);
    shd_assert_result(c->name, result, c->expected, c->message);
    load_twice(c->name, c->bytes, c->size, SHD_LOAD_PARTIAL, &partial);
    assert_int_equal(partial, result);
    if (result != SHD_OK) return;
    shd_assert_ok(shd_bitmap_load_memory(g_context, c->bytes, c->size, NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(image.width * image.height, c->pixels);
    for (i = 0; i < c->pixels; ++i) {
        const unsigned char *pixel = (const unsigned char *)image.pixels + i / image.width * image.row_stride;
        assert_memory_equal(pixel + i % image.width * 4, c->rgb[i], 3);
    }
    shd_bitmap_release(bitmap);
}

/* 256 indices of a palette with one entry; a decoder would return 765 bytes of heap memory. */
static void test_palette_of_one(void **state)
{
    unsigned char file[277] = {0, 1, 1, 0, 0, 1, 0, 24, 0, 0, 0, 0, 0, 1, 1, 0, 8, 0x20, 1, 2, 3};
    shd_result result;
    size_t i;
    (void)state;
    for (i = 0; i < 256; ++i) file[21 + i] = (unsigned char)i;
    load_all("palette_of_one", file, sizeof file, &result);
    shd_assert_result("palette_of_one", result, SHD_ERROR_CORRUPT, "TGA: a pixel is outside the palette");
}

/* 16-bit grey is a byte of grey and one of alpha. */
static void test_grey_alpha(void **state)
{
    static const unsigned char file[22] = {TGA(3, 0, 0, 0, 2, 1, 16), 10, 20, 30, 40};
    static const unsigned char wanted[8] = {10, 10, 10, 20, 30, 30, 30, 40};
    unsigned char with_alpha[sizeof file];
    shd_image image = shd_image_default();
    shd_bitmap *bitmap = NULL;
    shd_result result;
    (void)state;
    memcpy(with_alpha, file, sizeof file);
    with_alpha[17] |= 8; /* bits of alpha */
    load_all("grey_alpha", with_alpha, sizeof with_alpha, &result);
    shd_assert_ok(shd_bitmap_load_memory(g_context, with_alpha, sizeof with_alpha, NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_memory_equal(image.pixels, wanted, sizeof wanted);
    shd_bitmap_release(bitmap);
}

enum { EXTENSION = 495, FOOTER = 26, EXTENDED = 24 + EXTENSION + FOOTER };

/* Two pixels, an extension area at `area` with the 16-bit size 495 and `fill` elsewhere, and a footer. */
static void extended_file(unsigned char file[EXTENDED], unsigned area, unsigned char fill)
{
    static const unsigned char pixels[24] = {TGA(2, 0, 0, 0, 2, 1, 24), PALETTE2};
    unsigned char *footer = file + EXTENDED - FOOTER;
    memset(file, fill, EXTENDED);
    memcpy(file, pixels, sizeof pixels);
    file[24] = EXTENSION & 255;
    file[25] = EXTENSION >> 8;
    memset(file + 24 + 478, 0, 4); /* no gamma */
    file[24 + 494] = 0;            /* no alpha */
    memset(footer, 0, FOOTER);
    footer[0] = (unsigned char)area;
    footer[1] = (unsigned char)(area >> 8);
    memcpy(footer + 8, "TRUEVISION-XFILE.", 18);
}

/* Texts without an end, dates and offsets that are no numbers of the format: none changes the pixels. */
static void test_extension(void **state)
{
    static const unsigned char fills[] = {0, 1, 'x', 0xff};
    unsigned char file[EXTENDED];
    uint64_t first = 0;
    shd_bitmap *bitmap = NULL;
    shd_result result;
    size_t i;
    (void)state;
    for (i = 0; i < sizeof fills; ++i) {
        uint64_t hash;
        extended_file(file, 24, fills[i]);
        hash = load_all("extension", file, sizeof file, &result);
        shd_assert_ok(result);
        if (i == 0) first = hash;
        assert_true(hash == first);
    }
    extended_file(file, 24, 0);
    file[24 + 478] = 22; /* gamma 2.2 = 22 / 10 */
    file[24 + 480] = 10;
    shd_assert_ok(shd_bitmap_load_memory(g_context, file, sizeof file, NULL, &bitmap));
    assert_string_not_equal(shd_bitmap_get_color_space(bitmap), "sRGB");
    shd_bitmap_release(bitmap);
    extended_file(file, 22, 0);
    file[22] = file[23] = 0xff; /* the last pixel is the size of the area */
    load_all("over_pixels", file, sizeof file, &result);
    shd_assert_result("over_pixels", result, SHD_ERROR_CORRUPT, "TGA: bad extension area");
    extended_file(file, 60, 0xff);
    load_all("cut", file, sizeof file, &result);
    shd_assert_result("cut", result, SHD_ERROR_CORRUPT, "TGA: bad extension area");
}

/* Small files with plausible headers and random contents: none ends this process, and reloads are equal. */
static void test_random(void **state)
{
    static const unsigned char kinds[] = {1, 2, 3, 9, 10, 11};
    static const unsigned char depths[] = {8, 15, 16, 24, 32};
    uint64_t random = 0x9e3779b97f4a7c15ull;
    int n, loaded = 0;
    (void)state;
    for (n = 0; n < 4000; ++n) {
        unsigned char file[64];
        const size_t size = 18 + io_random(&random) % 46;
        shd_result result;
        size_t i;
        for (i = 0; i < sizeof file; ++i) file[i] = (unsigned char)io_random(&random);
        file[0] = io_random(&random) % 3 ? 0 : file[0] % 8;
        file[2] = kinds[io_random(&random) % 6];
        file[1] = file[2] % 8 == 1;
        if (io_random(&random) % 4) file[3] = file[4] = 0;
        file[5] %= 4;
        if (io_random(&random) % 8) file[6] = 0;
        file[7] = depths[io_random(&random) % 5];
        file[12] %= 4;
        file[14] %= 4;
        if (io_random(&random) % 8) file[13] = file[15] = 0;
        file[16] = depths[io_random(&random) % 5];
        file[17] &= 0x3f;
        load_twice("random", file, size, SHD_LOAD_IN_PROCESS | (n % 2 ? SHD_LOAD_PARTIAL : SHD_LOAD_NONE), &result);
        if (n % 16 == 0) load_all("random", file, size, &result);
        loaded += result == SHD_OK;
    }
    print_message("%d random TGA files: %d loaded\n", n, loaded);
    assert_true(loaded > 100);
}

int main(void)
{
    enum { CASES = sizeof k_cases / sizeof k_cases[0] };
    struct CMUnitTest tests[CASES + 4];
    size_t i;
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < CASES; ++i)
        tests[i] = (struct CMUnitTest){k_cases[i].name, test_case, NULL, NULL, (void *)&k_cases[i]};
    tests[CASES] = (struct CMUnitTest){"palette_of_one", test_palette_of_one, NULL, NULL, NULL};
    tests[CASES + 1] = (struct CMUnitTest){"random", test_random, NULL, NULL, NULL};
    tests[CASES + 2] = (struct CMUnitTest){"extension", test_extension, NULL, NULL, NULL};
    tests[CASES + 3] = (struct CMUnitTest){"grey_alpha", test_grey_alpha, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.io_tga", tests, CASES + 4, NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
