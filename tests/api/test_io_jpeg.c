/* SPDX-License-Identifier: MIT */
/* JPEG files whose frame header declares a large picture, or that have many scans: they are refused by their header,
 * before a decoder allocates memory or decodes. Markers: ITU-T T.81, Annex B. */
#define _GNU_SOURCE
#include "support/io_files.h"

#include <sys/resource.h>

#include <shd/shd.h>

static shd_context *g_context;

#ifdef SHD_IO_WORKER
static const char *const k_worker = SHD_IO_WORKER;
#else
static const char *const k_worker = NULL;
#endif

/* A progressive greyscale file of 8 x 8 pixels, written with libjpeg-turbo. */
static const unsigned char k_progressive[335] = {
    0xff, 0xd8, 0xff, 0xe0, 0x00, 0x10, 0x4a, 0x46, 0x49, 0x46, 0x00, 0x01, 0x01, 0x00, 0x00, 0x01, 0x00, 0x01, 0x00,
    0x00, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x03, 0x02, 0x02, 0x03, 0x02, 0x02, 0x03, 0x03, 0x03, 0x03, 0x04, 0x03, 0x03,
    0x04, 0x05, 0x08, 0x05, 0x05, 0x04, 0x04, 0x05, 0x0a, 0x07, 0x07, 0x06, 0x08, 0x0c, 0x0a, 0x0c, 0x0c, 0x0b, 0x0a,
    0x0b, 0x0b, 0x0d, 0x0e, 0x12, 0x10, 0x0d, 0x0e, 0x11, 0x0e, 0x0b, 0x0b, 0x10, 0x16, 0x10, 0x11, 0x13, 0x14, 0x15,
    0x15, 0x15, 0x0c, 0x0f, 0x17, 0x18, 0x16, 0x14, 0x18, 0x12, 0x14, 0x15, 0x14, 0xff, 0xc2, 0x00, 0x0b, 0x08, 0x00,
    0x08, 0x00, 0x08, 0x01, 0x01, 0x11, 0x00, 0xff, 0xc4, 0x00, 0x14, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0xff, 0xda, 0x00, 0x08, 0x01, 0x01, 0x00, 0x00, 0x00,
    0x01, 0x1f, 0xff, 0xc4, 0x00, 0x17, 0x10, 0x01, 0x00, 0x03, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x02, 0x01, 0x03, 0x06, 0xff, 0xda, 0x00, 0x08, 0x01, 0x01, 0x00, 0x01, 0x05, 0x02, 0x90,
    0x33, 0x35, 0x7f, 0xff, 0xc4, 0x00, 0x1c, 0x10, 0x00, 0x02, 0x02, 0x02, 0x03, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x02, 0x03, 0x51, 0x04, 0x61, 0x05, 0x11, 0x81, 0xff, 0xda, 0x00, 0x08, 0x01,
    0x01, 0x00, 0x06, 0x3f, 0x02, 0x5c, 0x1c, 0x14, 0x59, 0x39, 0x57, 0x15, 0xd8, 0x80, 0x59, 0xdd, 0x0f, 0x4e, 0xff,
    0x00, 0xff, 0xc4, 0x00, 0x19, 0x10, 0x01, 0x00, 0x02, 0x03, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x01, 0x11, 0x21, 0x00, 0x41, 0xa1, 0xff, 0xda, 0x00, 0x08, 0x01, 0x01, 0x00, 0x01, 0x3f, 0x21,
    0x09, 0x01, 0x96, 0x0b, 0x14, 0x7b, 0x65, 0xf1, 0x20, 0xcf, 0xff, 0xda, 0x00, 0x08, 0x01, 0x01, 0x00, 0x00, 0x00,
    0x10, 0xff, 0x00, 0xff, 0xc4, 0x00, 0x16, 0x10, 0x01, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 0x11, 0x00, 0xff, 0xda, 0x00, 0x08, 0x01, 0x01, 0x00, 0x01, 0x3f, 0x10, 0x73,
    0x0e, 0xb9, 0x4c, 0xa0, 0x22, 0x82, 0x29, 0x10, 0x37, 0x7f, 0xff, 0xd9,
};

/* Offset of the marker 0xff `marker`. */
static size_t find_marker(const unsigned char *bytes, size_t size, unsigned char marker)
{
    size_t at;
    for (at = 0; at + 1 < size; ++at) {
        if (bytes[at] == 0xff && bytes[at + 1] == marker) return at;
    }
    fail_msg("no marker 0x%02x", (unsigned)marker);
    return 0;
}

/* A copy of the file that declares another size. */
static io_bytes resized(unsigned width, unsigned height)
{
    io_bytes bytes = {(unsigned char *)malloc(sizeof k_progressive), sizeof k_progressive};
    unsigned char *frame;
    memcpy(bytes.data, k_progressive, bytes.size);
    frame = bytes.data + find_marker(bytes.data, bytes.size, 0xc2) + 5;
    frame[0] = (unsigned char)(height >> 8);
    frame[1] = (unsigned char)height;
    frame[2] = (unsigned char)(width >> 8);
    frame[3] = (unsigned char)width;
    return bytes;
}

/* A copy with `size` other bytes at `at`. */
static io_bytes with_bytes(io_bytes file, size_t at, const void *insert, size_t size)
{
    io_bytes out = {(unsigned char *)malloc(file.size + size), file.size + size};
    memcpy(out.data, file.data, at);
    memcpy(out.data + at, insert, size);
    memcpy(out.data + at + size, file.data + at, file.size - at);
    free(file.data);
    return out;
}

static shd_result load(const io_bytes *bytes, const shd_load_desc *desc)
{
    shd_bitmap *bitmap = NULL;
    const shd_result result = shd_bitmap_load_memory(g_context, bytes->data, bytes->size, desc, &bitmap);
    assert_true((result == SHD_OK) == (bitmap != NULL));
    shd_bitmap_release(bitmap);
    return result;
}

/* Loads by the worker, in this process and in parts, each with the same result. Frees the bytes. */
static void check(const char *name, io_bytes bytes, shd_load_desc desc, shd_result expected, const char *message)
{
    static const shd_load_flags flags[] = {SHD_LOAD_NONE, SHD_LOAD_IN_PROCESS, SHD_LOAD_IN_PROCESS | SHD_LOAD_PARTIAL};
    size_t i;
    desc.worker_path = k_worker;
    for (i = 0; i < sizeof flags / sizeof flags[0]; ++i) {
        desc.flags = flags[i];
        shd_assert_result(name, load(&bytes, &desc), expected, message);
    }
    free(bytes.data);
}

/* The message has the size of the header and names the budget, so the header was read and not the decoder's result. */
static void test_size(void **state)
{
    shd_load_desc desc = shd_load_desc_default();
    (void)state;
    check("whole", resized(8, 8), desc, SHD_OK, "");
    check("65500", resized(65500, 65500), desc, SHD_ERROR_LIMIT, "65500 x 65500 pixels is above load.max_pixels");
    check("ratio", resized(12000, 12000), desc, SHD_ERROR_LIMIT, "576000000 decoded bytes from 335 are above");
    desc.max_bytes = 16u << 20;
    check("bytes", resized(12000, 12000), desc, SHD_ERROR_LIMIT,
          "576000000 decoded bytes are above load.max_bytes 16777216");
    desc.max_pixels = 63;
    check("pixels", resized(8, 8), desc, SHD_ERROR_LIMIT, "image of 8 x 8 pixels is above load.max_pixels 63");
    desc.max_pixels = 64;
    check("pixels_exact", resized(8, 8), desc, SHD_OK, "");
    check("empty", resized(0, 8), desc, SHD_ERROR_CORRUPT, "image of 0 x 8 pixels");
}

/* With the address space limited to little more than is in use, a load that needed the declared memory would fail with
 * another result. */
static void test_memory(void **state)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    (void)state;
    skip(); /* sanitizers reserve more address space than a limit would leave */
#else
    io_bytes small = resized(8, 8), large = resized(65500, 65500);
    shd_load_desc desc = shd_load_desc_default();
    struct rlimit old, low;
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    shd_result result;
    (void)state;
    if (!file) skip();
    desc.flags = SHD_LOAD_IN_PROCESS;
    shd_assert_ok(load(&small, &desc));
    assert_int_equal(fscanf(file, "%lu", &pages), 1);
    fclose(file);
    desc.max_pixels = UINT64_MAX;
    desc.max_bytes = UINT64_C(1) << 34; /* 65500 x 65500 pixels need more */
    assert_int_equal(getrlimit(RLIMIT_AS, &old), 0);
    low = old;
    low.rlim_cur = (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE) + (64u << 20);
    assert_int_equal(setrlimit(RLIMIT_AS, &low), 0);
    result = load(&large, &desc);
    assert_int_equal(setrlimit(RLIMIT_AS, &old), 0);
    shd_assert_result("memory", result, SHD_ERROR_LIMIT, "17161000000 decoded bytes");
    free(small.data);
    free(large.data);
#endif
}

/* Bytes between segments, which decoders skip, and segments of metadata do not hide the frame header. JFIF ends at 20.
 */
static void test_hidden(void **state)
{
    static const unsigned char zeros[] = {0, 0, 0xff, 0, 0x12, 0xff, 0xff};
    static const unsigned char marker[] = {0xff, 0, 0, 8, 1, 2, 3, 4, 5, 6};
    static const unsigned char small_frame[] = {0xff, 0xe1, 0, 13, 0xff, 0xc2, 0, 11, 8, 0, 8, 0, 8, 1, 1};
    const shd_load_desc desc = shd_load_desc_default();
    const char *message = "65500 x 65500 pixels is above load.max_pixels";
    (void)state;
    check("zeros", with_bytes(resized(65500, 65500), 20, zeros, sizeof zeros), desc, SHD_ERROR_LIMIT, message);
    check("marker", with_bytes(resized(65500, 65500), 20, marker, sizeof marker), desc, SHD_ERROR_LIMIT, message);
    check("metadata", with_bytes(resized(65500, 65500), 20, small_frame, sizeof small_frame), desc, SHD_ERROR_LIMIT,
          message);
    check("small", with_bytes(resized(8, 8), 20, small_frame, sizeof small_frame), desc, SHD_OK, "");
}

/* The last scan of the file is repeated, up to 256 scans and one more. */
static void test_scans(void **state)
{
    const io_bytes file = {(unsigned char *)(uintptr_t)k_progressive, sizeof k_progressive};
    const shd_load_desc desc = shd_load_desc_default();
    const size_t end = find_marker(file.data, file.size, 0xd9);
    size_t last = 0, at, scans = 0;
    (void)state;
    for (at = 0; at + 1 < end; ++at) {
        if (file.data[at] == 0xff && file.data[at + 1] == 0xda) {
            last = at;
            ++scans;
        }
    }
    assert_true(scans > 1);
    for (at = 256; at <= 257; ++at) {
        io_bytes many = {(unsigned char *)malloc(file.size), file.size};
        size_t added;
        memcpy(many.data, file.data, file.size);
        for (added = scans; added < at; ++added) many = with_bytes(many, end, file.data + last, end - last);
        check("scans", many, desc, at == 256 ? SHD_OK : SHD_ERROR_LIMIT, "JPEG: 257 scans are above 256");
    }
}

static void test_no_frame(void **state)
{
    static const unsigned char no_frame[] = {0xff, 0xd8, 0xff, 0xe0, 0, 4, 0, 0, 0xff, 0xda, 0, 2, 0xff, 0xd9};
    static const unsigned char cut[] = {0xff, 0xd8, 0xff, 0xc2, 0, 11, 8, 0, 8};
    const io_bytes file = {(unsigned char *)(uintptr_t)no_frame, sizeof no_frame};
    const io_bytes short_file = {(unsigned char *)(uintptr_t)cut, sizeof cut};
    (void)state;
    shd_assert_result("no_frame", load(&file, NULL), SHD_ERROR_CORRUPT, "JPEG: no frame header");
    shd_assert_result("cut", load(&short_file, NULL), SHD_ERROR_CORRUPT, "JPEG header is cut off");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        {"size", test_size, NULL, NULL, NULL},         {"memory", test_memory, NULL, NULL, NULL},
        {"hidden", test_hidden, NULL, NULL, NULL},     {"scans", test_scans, NULL, NULL, NULL},
        {"no_frame", test_no_frame, NULL, NULL, NULL},
    };
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    failed = _cmocka_run_group_tests("api.io_jpeg", tests, sizeof tests / sizeof tests[0], NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
