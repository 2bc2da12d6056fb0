/* SPDX-License-Identifier: MIT */
/* Metadata that attacks its parser: EXIF whose directories refer to themselves, ICC profiles with wrong sizes, endless
 * directories of TIFF files. The pixels are those of the file without it, or the load is refused. Also parts of OpenEXR
 * files, and the budget for the ratio of pixels to bytes. */
#define _GNU_SOURCE
#include "support/io_corpus.h"
#include "support/rows.h"

#include <shd/shd.h>

static shd_context *g_context;

static uint64_t load(const void *bytes, size_t size, const shd_load_desc *desc, shd_result *out_result)
{
    shd_bitmap *bitmap = NULL;
    uint64_t hash;
    *out_result = shd_bitmap_load_memory(g_context, bytes, size, desc, &bitmap);
    hash = bitmap ? io_hash_bitmap(bitmap) : 0;
    assert_true((bitmap != NULL) == (*out_result == SHD_OK));
    shd_bitmap_release(bitmap);
    return hash;
}

static const io_bytes *find_sample(const char *name)
{
    int i;
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
        if (strcmp(g_corpus[i].name, name) == 0) return &g_corpus[i].bytes;
    }
    fail_msg("no sample %s", name);
    return NULL;
}

/* ---- payloads ---- */

enum { PAYLOAD = 4000 };

static void put16(unsigned char *to, unsigned value)
{
    to[0] = (unsigned char)value;
    to[1] = (unsigned char)(value >> 8);
}

/* One directory entry of TIFF 6.0: tag, type, count, value or offset. */
static void put_entry(unsigned char *to, unsigned tag, unsigned type, uint32_t count, uint32_t value)
{
    put16(to, tag);
    put16(to + 2, type);
    io_put32(to + 4, count);
    io_put32(to + 8, value);
}

/* EXIF is a TIFF: the directory at 8 is its own EXIF directory (34665) and its own next directory. */
static void exif_own_child(unsigned char *to)
{
    memcpy(to, "II*\0", 4);
    io_put32(to + 4, 8);
    put16(to + 8, 2);
    put_entry(to + 10, 34665, 4, 1, 8);
    put_entry(to + 22, 34853, 4, 1, 8); /* GPS */
    io_put32(to + 34, 8);
}
/* Two hundred directories, each the EXIF directory of its predecessor; the last one refers to the first. */
static void exif_chain(unsigned char *to)
{
    uint32_t i;
    memcpy(to, "II*\0", 4);
    io_put32(to + 4, 8);
    for (i = 0; i < 200; ++i) {
        put16(to + 8 + 18 * i, 1);
        put_entry(to + 10 + 18 * i, 34665, 4, 1, i == 199 ? 8 : 8 + 18 * (i + 1));
    }
}
/* A text of 2^32 - 1 bytes at the end, an offset beyond it, and 65535 entries. */
static void exif_sizes(unsigned char *to)
{
    memcpy(to, "II*\0", 4);
    io_put32(to + 4, 8);
    put16(to + 8, 0xffff);
    put_entry(to + 10, 271, 2, 0xffffffffu, PAYLOAD - 1);
    put_entry(to + 22, 37500, 7, 0xffffffffu, 0xfffffff0u);
    put_entry(to + 34, 33434, 5, 0x20000000u, 0xfffffff0u);
}
static void all_ff(unsigned char *to) { memset(to, 0xff, PAYLOAD); }
static void all_zero(unsigned char *to) { (void)to; }
/* ICC.1:2010: 2^32 - 1 tags, and a profile size of 2^32 - 1. */
static void icc_sizes(unsigned char *to)
{
    memset(to, 0xff, 4);
    memcpy(to + 12, "mntrRGB XYZ ", 12);
    memcpy(to + 36, "acsp", 4);
    memset(to + 128, 0xff, PAYLOAD - 128);
}
/* XMP nested 1300 deep; test_io_load has a deeper one. */
static void xmp_nested(unsigned char *to)
{
    size_t i;
    for (i = 0; i < PAYLOAD; ++i) to[i] = (unsigned char)("<a>"[i % 3]);
}

struct payload_case {
    const char *name;
    void (*make)(unsigned char *to);
};
static const struct payload_case k_payloads[] = {
    {"exif_own_child", exif_own_child},
    {"exif_chain_of_200", exif_chain},
    {"exif_sizes_2^32-1", exif_sizes},
    {"icc_sizes_2^32-1", icc_sizes},
    {"xmp_nested_1300", xmp_nested},
    {"all_ff", all_ff},
    {"all_zero", all_zero},
};

/* ---- JPEG and PNG ---- */

/* A copy of a file with `size` bytes more at `at`. */
static io_bytes with_bytes(const io_bytes *file, size_t at, const void *insert, size_t size)
{
    io_bytes out = {(unsigned char *)malloc(file->size + size), file->size + size};
    memcpy(out.data, file->data, at);
    memcpy(out.data + at, insert, size);
    memcpy(out.data + at + size, file->data + at, file->size - at);
    return out;
}

/* JPEG segments: ITU-T T.81, B.1.1.4; the headers are those of EXIF 2.3, ICC.1:2010 annex B.4 and XMP part 3. */
static const struct {
    const char *name;
    unsigned char marker;
    const char *header;
    size_t header_size;
} k_segments[] = {
    {"exif", 0xe1, "Exif\0\0", 6},
    {"icc", 0xe2, "ICC_PROFILE\0\1\1", 14},
    {"icc_255_of_1", 0xe2, "ICC_PROFILE\0\xff\1", 14},
    {"xmp", 0xe1, "http://ns.adobe.com/xap/1.0/", 29},
    {"extended_xmp", 0xe1, "http://ns.adobe.com/xmp/extension/", 35},
    {"iptc", 0xed, "Photoshop 3.0\0008BIM\4\4\0\0\xff\xff\xff\xff", 26},
    {"comment", 0xfe, "", 0},
};

static uint32_t crc_of(const unsigned char *bytes, size_t size)
{
    uint32_t crc = 0xffffffffu;
    size_t i;
    int bit;
    for (i = 0; i < size; ++i) {
        crc ^= bytes[i];
        for (bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}
static void put32_big(unsigned char *to, uint32_t value)
{
    int i;
    for (i = 0; i < 4; ++i) to[i] = (unsigned char)(value >> (24 - 8 * i));
}

/* Chunks of PNG (ISO/IEC 15948:2004, clause 11.3), with what precedes the payload. */
static const struct {
    const char *name, *type, *header;
    size_t header_size;
} k_chunks[] = {
    {"eXIf", "eXIf", "", 0},
    {"iCCP", "iCCP", "name\0\0x\x9c", 8},
    {"zTXt", "zTXt", "Comment\0\0x\x9c", 11},
    {"tEXt", "tEXt", "Raw profile type exif\0\n", 23},
    {"iTXt", "iTXt", "XML:com.adobe.xmp\0\0\0\0\0", 22},
    {"cHRM", "cHRM", "", 0},
    {"unknown", "abCd", "", 0},
};

/* A result with the bits of the plain file; for chunks that change colours, also a refusal. */
static void check(const char *what, const char *payload, const io_bytes *plain, const io_bytes *bytes)
{
    shd_result result;
    const uint64_t want = load(plain->data, plain->size, NULL, &result);
    const uint64_t got = load(bytes->data, bytes->size, NULL, &result);
    if (result == SHD_OK ? got != want : result == SHD_ERROR_INTERNAL) {
        fail_msg("%s, %s: %s (%s)", what, payload, shd_result_name(result), shd_last_error());
    }
}

static void test_payload(void **state)
{
    const struct payload_case *c = (const struct payload_case *)*state;
    const io_bytes *jpeg = find_sample("jpeg"), *png = find_sample("png8");
    static unsigned char insert[PAYLOAD + 100];
    size_t i;
    for (i = 0; i < sizeof k_segments / sizeof k_segments[0]; ++i) {
        const size_t header = k_segments[i].header_size, length = 2 + header + PAYLOAD;
        io_bytes bytes;
        memset(insert, 0, sizeof insert);
        insert[0] = 0xff;
        insert[1] = k_segments[i].marker;
        insert[2] = (unsigned char)(length >> 8);
        insert[3] = (unsigned char)length;
        memcpy(insert + 4, k_segments[i].header, header);
        c->make(insert + 4 + header);
        bytes = with_bytes(jpeg, 2, insert, 2 + length);
        check(k_segments[i].name, c->name, jpeg, &bytes);
        free(bytes.data);
    }
    for (i = 0; i < sizeof k_chunks / sizeof k_chunks[0]; ++i) {
        const size_t header = k_chunks[i].header_size, length = header + PAYLOAD;
        io_bytes bytes;
        memset(insert, 0, sizeof insert);
        put32_big(insert, (uint32_t)length);
        memcpy(insert + 4, k_chunks[i].type, 4);
        memcpy(insert + 8, k_chunks[i].header, header);
        c->make(insert + 8 + header);
        put32_big(insert + 8 + length, crc_of(insert + 4, 4 + length));
        bytes = with_bytes(png, 33, insert, 12 + length); /* after IHDR */
        check(k_chunks[i].name, c->name, png, &bytes);
        free(bytes.data);
    }
}

/* ---- TIFF ---- */

/* A 1 x 1 grey TIFF whose directory at 8 has eight entries and `extra`, followed by `next`. */
static size_t make_tiff(unsigned char *to, unsigned extra_tag, uint32_t extra_count, uint32_t extra_value,
                        uint32_t next)
{
    static const struct {
        unsigned tag, type;
        uint32_t value;
    } k_entries[8] = {{256, 3, 1}, {257, 3, 1},   {258, 3, 8}, {259, 3, 1},
                      {262, 3, 1}, {273, 4, 130}, {278, 3, 1}, {279, 4, 1}};
    size_t i, n = 0;
    memset(to, 0, 200);
    memcpy(to, "II*\0", 4);
    io_put32(to + 4, 8);
    for (i = 0; i < 8; ++i) put_entry(to + 10 + 12 * n++, k_entries[i].tag, k_entries[i].type, 1, k_entries[i].value);
    if (extra_tag) put_entry(to + 10 + 12 * n++, extra_tag, 4, extra_count, extra_value);
    put16(to + 8, (unsigned)n);
    io_put32(to + 10 + 12 * n, next);
    to[130] = 77;
    return 140;
}

struct tiff_case {
    const char *name;
    unsigned tag;
    uint32_t count, value, next;
};
static const struct tiff_case k_tiffs[] = {
    {"tiff/plain", 0, 0, 0, 0},
    {"tiff/own_next_directory", 0, 0, 0, 8},
    {"tiff/next_directory_inside", 0, 0, 0, 10},
    {"tiff/next_directory_beyond", 0, 0, 0, 0xfffffff0u},
    {"tiff/own_exif", 34665, 1, 8, 0},
    {"tiff/exif_beyond", 34665, 1, 0xfffffff0u, 0},
    {"tiff/own_gps", 34853, 1, 8, 8},
    {"tiff/own_subdirectory", 330, 1, 8, 0},
    {"tiff/2^29_subdirectories", 330, 1u << 29, 8, 0},
    {"tiff/icc_of_2^32-1", 34675, 0xffffffffu, 8, 0},
    {"tiff/xmp_of_2^32-1", 700, 0xffffffffu, 8, 0},
    {"tiff/text_of_2^32-1", 270, 0xffffffffu, 8, 0},
};

static void test_tiff(void **state)
{
    const struct tiff_case *c = (const struct tiff_case *)*state;
    unsigned char bytes[200];
    shd_result result, again;
    const size_t size = make_tiff(bytes, c->tag, c->count, c->value, c->next);
    uint64_t plain, hash;
    unsigned char plain_bytes[200];
    (void)make_tiff(plain_bytes, 0, 0, 0, 0);
    plain = load(plain_bytes, size, NULL, &result);
    shd_assert_result("plain", result, SHD_OK, "");
    hash = load(bytes, size, NULL, &result);
    if (result == SHD_OK ? hash != plain : result == SHD_ERROR_INTERNAL) {
        fail_msg("%s: %s (%s)", c->name, shd_result_name(result), shd_last_error());
    }
    assert_true(load(bytes, size, NULL, &again) == hash && again == result);
}

/* ---- OpenEXR with two parts ---- */

static size_t put_attribute(unsigned char *to, const char *name, const char *type, const void *value, uint32_t size)
{
    const size_t name_size = strlen(name) + 1, type_size = strlen(type) + 1;
    memcpy(to, name, name_size);
    memcpy(to + name_size, type, type_size);
    io_put32(to + name_size + type_size, size);
    memcpy(to + name_size + type_size + 4, value, size);
    return name_size + type_size + 4 + size;
}

/* Parts of 2 x 1 pixels of one float channel, uncompressed ("OpenEXR File Layout"): part p has the value 10 p + x. */
static size_t make_parts(unsigned char *to, const char *second_type)
{
    static const int k_window[4] = {0, 0, 1, 0};
    unsigned char channels[2 + 16 + 1] = "Y";
    const float one = 1, center[2] = {0, 0};
    const uint32_t chunks = 1;
    size_t n = 8, offsets, part, x;
    io_put32(to, 20000630);
    io_put32(to + 4, 2 | 0x1000);
    channels[2] = 2;
    io_put32(channels + 10, 1);
    io_put32(channels + 14, 1);
    for (part = 0; part < 2; ++part) {
        const char *type = part ? second_type : "scanlineimage";
        n += put_attribute(to + n, "channels", "chlist", channels, sizeof channels);
        n += put_attribute(to + n, "chunkCount", "int", &chunks, 4);
        n += put_attribute(to + n, "compression", "compression", "\0", 1);
        n += put_attribute(to + n, "dataWindow", "box2i", k_window, 16);
        n += put_attribute(to + n, "displayWindow", "box2i", k_window, 16);
        n += put_attribute(to + n, "lineOrder", "lineOrder", "\0", 1);
        n += put_attribute(to + n, "name", "string", part ? "two" : "one", 3);
        n += put_attribute(to + n, "pixelAspectRatio", "float", &one, 4);
        n += put_attribute(to + n, "screenWindowCenter", "v2f", center, 8);
        n += put_attribute(to + n, "screenWindowWidth", "float", &one, 4);
        n += put_attribute(to + n, "type", "string", type, (uint32_t)strlen(type));
        to[n++] = 0;
    }
    to[n++] = 0;
    offsets = n;
    n += 16;
    for (part = 0; part < 2; ++part) {
        io_put32(to + offsets + 8 * part, (uint32_t)n);
        io_put32(to + offsets + 8 * part + 4, 0);
        io_put32(to + n, (uint32_t)part);
        io_put32(to + n + 4, 0);
        io_put32(to + n + 8, 8);
        n += 12;
        for (x = 0; x < 2; ++x, n += 4) {
            const float value = (float)(10 * part + x);
            memcpy(to + n, &value, 4);
        }
    }
    return n;
}

static void test_parts(void **state)
{
    static unsigned char bytes[4096];
    const size_t size = make_parts(bytes, "scanlineimage");
    uint32_t part, x;
    (void)state;
    for (part = 0; part < 3; ++part) {
        shd_load_desc desc = shd_load_desc_default();
        shd_bitmap *bitmap = NULL;
        shd_image image = shd_image_default();
        shd_result result;
        desc.subimage = part;
        result = shd_bitmap_load_memory(g_context, bytes, size, &desc, &bitmap);
        shd_assert_result("part", result, part < 2 ? SHD_OK : SHD_ERROR_NOT_FOUND, "the file has no part 2");
        if (part == 2) break;
        shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
        for (x = 0; x < 2; ++x) {
            assert_true(((const float *)image.pixels)[4 * x] == (float)(10 * part + x));
        }
        shd_bitmap_release(bitmap);
    }
}

static void test_deep_part(void **state)
{
    static unsigned char bytes[4096];
    const size_t size = make_parts(bytes, "deepscanline");
    shd_result result;
    (void)state;
    (void)load(bytes, size, NULL, &result);
    shd_assert_result("deep", result, SHD_ERROR_UNSUPPORTED, "deep OpenEXR");
}

/* ---- ratio ---- */

/* 2048 x 2048 pixels of one colour, 2^24 bytes, in a PNG of less than a hundredth: the budget for the ratio decides. */
static void test_ratio(void **state)
{
    enum { SIDE = 2304 };
    shd_image image = shd_image_default();
    shd_load_desc desc = shd_load_desc_default();
    shd_result result;
    io_bytes file;
    double ratio;
    (void)state;
    image.format = SHD_FORMAT_RGBA8;
    image.width = image.height = SIDE;
    image.pixels = calloc((size_t)SIDE * SIDE, 4);
    shd_assert_ok(shd_image_save(&image, io_path("ratio.png"), NULL));
    free(image.pixels);
    file = io_read(io_path("ratio.png"));
    ratio = 4.0 * SIDE * SIDE / (double)file.size;
    assert_true(ratio > 100);
    desc.max_ratio = 0.99 * ratio;
    (void)load(file.data, file.size, &desc, &result);
    shd_assert_result("below", result, SHD_ERROR_LIMIT, "above load.max_ratio");
    desc.max_ratio = 1.01 * ratio;
    (void)load(file.data, file.size, &desc, &result);
    shd_assert_result("above", result, SHD_OK, "");
    free(file.data);
}

int main(void)
{
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    io_make_corpus();
    ADD_ROWS(k_payloads, test_payload);
    ADD_ROWS(k_tiffs, test_tiff);
    add("exr/two_parts", test_parts, NULL);
    add("exr/deep_second_part", test_deep_part, NULL);
    add("ratio", test_ratio, NULL);
    failed = _cmocka_run_group_tests("api.io_metadata", g_tests, g_count, NULL, NULL);
    shd_context_release(g_context);
    io_free_corpus();
    io_remove_folder(&state);
    return failed;
}
