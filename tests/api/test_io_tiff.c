/* SPDX-License-Identifier: MIT */
/* Hostile TIFF directories: refused at once, before libtiff reads them. Layout: Adobe, "TIFF 6.0". */
#define _GNU_SOURCE
#include "support/io_files.h"

#include <unistd.h>

#include <shd/shd.h>

static shd_context *g_context;

enum { ENTRIES = 9, DIRECTORY = 8, PIXELS = DIRECTORY + 2 + 12 * ENTRIES + 4, SIZE = PIXELS + 4 };
enum { SHORT = 3, LONG = 4, STRIP_OFFSETS = 273, STRIP_BYTE_COUNTS = 279 };

struct entry {
    unsigned tag, type;
    uint32_t count, value;
};
static const struct entry k_entries[ENTRIES] = {
    {256, LONG, 1, 2},                /* width */
    {257, LONG, 1, 2},                /* height */
    {258, SHORT, 1, 8},               /* bits */
    {259, SHORT, 1, 1},               /* not compressed */
    {262, SHORT, 1, 1},               /* black is zero */
    {STRIP_OFFSETS, LONG, 1, PIXELS}, /* one strip */
    {277, SHORT, 1, 1},               /* channels */
    {278, LONG, 1, 2},                /* rows of a strip */
    {STRIP_BYTE_COUNTS, LONG, 1, 4},
};

/** A file whose entries of strips are replaced, and how it is refused. */
struct tiff_case {
    const char *name;
    shd_result expected;
    const char *message;
    struct entry offsets, sizes; /* tag 0 = unchanged */
    uint32_t next;               /* offset of the next directory */
};
#define KEPT       \
    {              \
        0, 0, 0, 0 \
    }
#define BEYOND SHD_ERROR_CORRUPT, "TIFF: strips or tiles beyond the end of the file"
#define TYPES SHD_ERROR_CORRUPT, "TIFF: offsets or sizes of strips are no SHORT, LONG or LONG8"

static const struct tiff_case k_cases[] = {
    {"whole", SHD_OK, "", KEPT, KEPT, 0},
    {"offset/last_byte", SHD_OK, "", {STRIP_OFFSETS, SHORT, 1, PIXELS}, KEPT, 0},
    {"offset/beyond", BEYOND, {STRIP_OFFSETS, LONG, 1, PIXELS + 1}, KEPT, 0},
    {"size/beyond", BEYOND, KEPT, {STRIP_BYTE_COUNTS, LONG, 1, 5}, 0},
    {"offsets/huge_count", BEYOND, {STRIP_OFFSETS, SHORT, 0xffffffffu, 8}, KEPT, 0},
    {"offsets/unknown_type", TYPES, {STRIP_OFFSETS, 0, 1, PIXELS}, KEPT, 0},
    {"sizes/unknown_type", TYPES, KEPT, {STRIP_BYTE_COUNTS, 99, 1, 4}, 0},
    /* Without a size of elements nothing is read, so that the end of the file does not end a loop over 2^32 strips. */
    {"both/unknown_type_huge_count",
     TYPES,
     {STRIP_OFFSETS, 0, 0xffffffffu, 0},
     {STRIP_BYTE_COUNTS, 7, 4, 0},
     DIRECTORY},
    /* Every directory of a circle lists the strips again. */
    {"circle", BEYOND, KEPT, KEPT, DIRECTORY},
    /* To remove its metadata would change the header. */
    {"directory_in_header", SHD_ERROR_CORRUPT, "TIFF: a directory at byte 7, in the header", KEPT, KEPT, 7},
};

static void put(unsigned char *to, uint32_t value, int bytes)
{
    int i;
    for (i = 0; i < bytes; ++i) to[i] = (unsigned char)(value >> 8 * i);
}

static void make_file(const struct tiff_case *c, unsigned char *file)
{
    size_t i;
    memset(file, 0, SIZE);
    memcpy(file, "II*", 4);
    put(file + 4, DIRECTORY, 4);
    put(file + DIRECTORY, ENTRIES, 2);
    for (i = 0; i < ENTRIES; ++i) {
        unsigned char *at = file + DIRECTORY + 2 + 12 * i;
        struct entry entry = k_entries[i];
        if (c->offsets.tag == entry.tag) entry = c->offsets;
        if (c->sizes.tag == entry.tag) entry = c->sizes;
        put(at, entry.tag, 2);
        put(at + 2, entry.type, 2);
        put(at + 4, entry.count, 4);
        put(at + 8, entry.value, 4);
    }
    put(file + DIRECTORY + 2 + 12 * ENTRIES, c->next, 4);
    put(file + PIXELS, 0x40302010, 4);
}

static void test_case(void **state)
{
    const struct tiff_case *c = (const struct tiff_case *)*state;
    unsigned char file[SIZE];
    shd_bitmap *bitmap = NULL;
    make_file(c, file);
    alarm(20); /* a loop over the strips takes minutes */
    shd_assert_result(c->name, shd_bitmap_load_memory(g_context, file, sizeof file, NULL, &bitmap), c->expected,
                      c->message);
    alarm(0);
    if (c->expected == SHD_OK) {
        shd_image image = shd_image_default();
        int i;
        shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
        assert_true(image.width == 2 && image.height == 2);
        for (i = 0; i < 4; ++i) {
            const unsigned char *row = (const unsigned char *)image.pixels + (size_t)(i / 2) * image.row_stride;
            assert_int_equal(row[i % 2 * 4], 0x10 * (i + 1));
        }
    }
    shd_bitmap_release(bitmap);
}

int main(void)
{
    enum { CASES = sizeof k_cases / sizeof k_cases[0] };
    struct CMUnitTest tests[CASES];
    size_t i;
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < CASES; ++i)
        tests[i] = (struct CMUnitTest){k_cases[i].name, test_case, NULL, NULL, (void *)&k_cases[i]};
    failed = _cmocka_run_group_tests("api.io_tiff", tests, CASES, NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
