/* SPDX-License-Identifier: MIT */
/* KTX2 and DDS files that are cut off, contradict themselves or exceed budgets; wrong arguments; every allocation that
 * fails. A file lies in memory of exactly its size, so that a sanitizer reports reads beyond it. */
#define _GNU_SOURCE
#include "support/fault_allocator.h"
#include "support/loads.h"
#include "support/rows.h"
#include "support/texture_files.h"

#include <shd/shd.h>

static shd_context *g_context;

#define CORRUPT SHD_ERROR_CORRUPT
#define UNSUPPORTED SHD_ERROR_UNSUPPORTED

/* The files that are changed: KTX2 of RGBA8 and of BC7 with Zstandard and zlib, DDS of BC1 and BC7 with 4 levels. */
enum { KTX2, KTX2_ZSTD, KTX2_ZLIB, KTX2_CUBE, DDS, DDS_DX10, FILES };
static io_bytes g_files[FILES];
static int g_absent[FILES]; /* whether libshd_io lacks the decoder of the file */

static void make_files(void)
{
    static const file_texture k_pixels = {12, 8, 0, 0, 1, 4, 4, 1, 1}, k_blocks = {12, 8, 0, 0, 1, 4, 16, 4, 4},
                              k_cube = {8, 8, 0, 0, 6, 1, 4, 1, 1}, k_small_blocks = {12, 8, 0, 0, 1, 4, 8, 4, 4};
    file_ktx2 k = {37, 1, 1, 1, 0, "rgba", "rd"};
    g_files[KTX2] = file_make_ktx2(&k_pixels, &k, NULL);
    g_files[KTX2_CUBE] = file_make_ktx2(&k_cube, &k, NULL);
    k.format = 145, k.model = 134, k.scheme = 2;
    g_files[KTX2_ZSTD] = file_make_ktx2(&k_blocks, &k, NULL);
    k.scheme = 3;
    g_files[KTX2_ZLIB] = file_make_ktx2(&k_blocks, &k, NULL);
    g_files[DDS] = file_make_dds(&k_small_blocks, "DXT1", 0);
    g_files[DDS_DX10] = file_make_dds(&k_blocks, "DX10", 98);
}

/** Loads a copy in memory of exactly this size; by default in this process, so that sanitizers check the parser. */
static shd_result load(shd_context *context, const unsigned char *bytes, size_t size, const shd_load_desc *desc,
                       shd_texture **out)
{
    unsigned char *exact = (unsigned char *)malloc(size ? size : 1);
    shd_texture_file_info info = shd_texture_file_info_default();
    shd_load_desc in_process = shd_load_desc_default();
    shd_result result;
    in_process.flags = SHD_LOAD_IN_PROCESS;
    if (!desc) desc = &in_process;
    memcpy(exact, bytes, size);
    *out = (shd_texture *)&g_context;
    result = load_file_memory(context, exact, size, desc, &info, out);
    free(exact);
    assert_true((*out != NULL) == (result == SHD_OK));
    assert_true((info.width != 0) == (result == SHD_OK));
    assert_int_not_equal(result, SHD_ERROR_INTERNAL);
    return result;
}

/** A file with up to two changed numbers. */
struct bad_case {
    const char *name;
    int file;
    shd_result expected;
    const char *message;
    size_t at, size;
    uint64_t value;
    size_t at2;
    uint64_t value2; /* four bytes */
};
/* Offsets in files of four levels: level l of the index at 80 + 24 l, the descriptor at 176, its entries at 220. */
enum { INDEX = FILE_KTX2_INDEX, DFD = INDEX + 4 * 24, KVD = DFD + 44 };
static const struct bad_case k_bad[] = {
    {"unchanged", KTX2, SHD_OK, "", 0, 0, 0, 0, 0},
    {"identifier", KTX2, UNSUPPORTED, "of no known image format", 5, 1, '1', 0, 0},
    {"vk_format", KTX2, UNSUPPORTED, "vkFormat 1000054000 is not a format of shd", 12, 4, 1000054000, 0, 0},
    {"vk_undefined", KTX2, UNSUPPORTED, "vkFormat 0 is not", 12, 4, 0, 0, 0},
    {"type_size", KTX2, CORRUPT, "typeSize 2, but vkFormat 37 has 1", 16, 4, 2, 0, 0},
    {"no_width", KTX2, CORRUPT, "0 x 8 texels", 20, 4, 0, 0, 0},
    {"width", KTX2, SHD_ERROR_LIMIT, "width 65537 is above 65536", 20, 4, 65537, 0, 0},
    {"width_max", KTX2, SHD_ERROR_LIMIT, "width 4294967295", 20, 4, 0xffffffff, 0, 0},
    {"wider", KTX2, CORRUPT, "uncompressedByteLength of level 0 is 384, not 416", 20, 4, 13, 0, 0},
    {"texels", KTX2, SHD_ERROR_LIMIT, "4294967296 texels are above 2^28", 20, 4, 65536, 24, 65536},
    {"no_height", KTX2, CORRUPT, "pixelHeight 0, but pixelDepth 3", 24, 4, 0, 28, 3},
    {"depth_blocks", KTX2_ZSTD, CORRUPT, "uncompressedByteLength of level 0 is 96, not 192", 28, 4, 2, 0, 0},
    {"depth_layers", KTX2, UNSUPPORTED, "an array of 3D textures", 28, 4, 2, 32, 2},
    {"layers", KTX2, SHD_ERROR_LIMIT, "2049 layers are above 2048", 32, 4, 2049, 0, 0},
    {"layers_more", KTX2, CORRUPT, "uncompressedByteLength of level 0 is 384, not 768", 32, 4, 2, 0, 0},
    {"layers_max", KTX2, SHD_ERROR_LIMIT, "4294967295 layers", 32, 4, 0xffffffff, 0, 0},
    {"no_faces", KTX2, CORRUPT, "0 faces, not 1 or 6", 36, 4, 0, 0, 0},
    {"faces", KTX2, CORRUPT, "5 faces", 36, 4, 5, 0, 0},
    {"oblong_cube", KTX2, CORRUPT, "a cube map of 12 x 8 texels", 36, 4, 6, 0, 0},
    {"deep_cube", KTX2_CUBE, CORRUPT, "a cube map of 8 x 8 texels and 2 slices", 28, 4, 2, 0, 0},
    {"levels", KTX2, CORRUPT, "the data format descriptor at 176 of 44 bytes is not in 200..", 40, 4, 5, 0, 0},
    {"levels_max", KTX2, CORRUPT, "4294967295 levels are above 21", 40, 4, 0xffffffff, 0, 0},
    {"scheme", KTX2, UNSUPPORTED, "supercompressionScheme 4 is not in 0..3", 44, 4, 4, 0, 0},
    {"basis_lz", KTX2, UNSUPPORTED, "Basis Universal (ETC1S, BasisLZ). No package of Debian", 44, 4, 1, 0, 0},
    {"uastc", KTX2, UNSUPPORTED, "Basis Universal (UASTC)", DFD + 12, 1, 166, 0, 0},
    {"uastc_hdr", KTX2, UNSUPPORTED, "Basis Universal (UASTC HDR)", DFD + 12, 1, 167, 12, 1000066000},
    {"dfd_outside", KTX2, CORRUPT, "the data format descriptor at 4000 of 44 bytes", 48, 4, 4000, 0, 0},
    {"dfd_in_index", KTX2, CORRUPT, "the data format descriptor at 96", 48, 4, 96, 0, 0},
    {"no_dfd", KTX2, CORRUPT, "dfdByteLength 0", 52, 4, 0, 0, 0},
    {"dfd_length", KTX2, CORRUPT, "dfdByteLength 44, but the descriptor has 45", DFD, 4, 45, 0, 0},
    {"dfd_type", KTX2, CORRUPT, "a data format descriptor of type 0x1", DFD + 4, 4, 1, 0, 0},
    {"dfd_block", KTX2, CORRUPT, "and 56 bytes", DFD + 10, 2, 56, 0, 0},
    {"dfd_model", KTX2, CORRUPT, "the colour model of the descriptor is 2, not 1", DFD + 12, 1, 2, 0, 0},
    {"dfd_texels", KTX2, CORRUPT, "the blocks of the descriptor have 5 x 1 x 1", DFD + 16, 1, 4, 0, 0},
    {"dfd_plane", KTX2, CORRUPT, "bytesPlane0 of the descriptor is 3, not 4", DFD + 20, 1, 3, 0, 0},
    {"kvd_outside", KTX2, CORRUPT, "the key/value data at", 60, 4, 100000, 0, 0},
    {"kvd_entry", KTX2, CORRUPT, "an entry of 1 bytes among the last", KVD, 4, 1, 0, 0},
    {"kvd_entry_long", KTX2, CORRUPT, "an entry of 4294967295 bytes", KVD, 4, 0xffffffff, 0, 0},
    {"kvd_key", KTX2, CORRUPT, "a key without an end", KVD, 4, 3, 0, 0},
    {"kvd_orientation", KTX2, CORRUPT, "KTXorientation \"xd\" is not as", KVD + 4 + 15, 1, 'x', 0, 0},
    {"kvd_swizzle", KTX2, CORRUPT, "KTXswizzle \"rgbx\" is not four of", KVD + 24 + 4 + 11 + 3, 1, 'x', 0, 0},
    {"sgd", KTX2, CORRUPT, "sgdByteLength 4, but supercompressionScheme 0", 64, 8, 300, 72, 4},
    {"sgd_outside", KTX2, CORRUPT, "the supercompression data at 0 of 4", 72, 8, 4, 0, 0},
    {"level_outside", KTX2, CORRUPT, "a level at 18446744073709551600 of 384 bytes is not in 176..", INDEX, 8,
     0xfffffffffffffff0u, 0, 0},
    {"level_in_header", KTX2, CORRUPT, "a level at 175", INDEX, 8, 175, 0, 0},
    {"level_length", KTX2, CORRUPT, "byteLength of level 1 is 92, not 96", INDEX + 32, 8, 92, 0, 0},
    {"level_length_max", KTX2, CORRUPT, "of 18446744073709551615 bytes", INDEX + 8, 8, ~(uint64_t)0, 0, 0},
    {"level_unpacked", KTX2, CORRUPT, "uncompressedByteLength of level 3 is 5, not 4", INDEX + 3 * 24 + 16, 8, 5, 0, 0},
    {"level_in_dfd", KTX2, CORRUPT, "overlaps the one at", INDEX + 3 * 24, 8, DFD + 8, 0, 0},
    {"level_in_level", KTX2, CORRUPT, "overlaps the one at", INDEX + 3 * 24, 8, 481, 0, 0},
    {"zstd_empty", KTX2_ZSTD, CORRUPT, "byteLength of level 3 is 0, not 16", INDEX + 3 * 24 + 8, 8, 0, 0, 0},
    {"zstd_cut", KTX2_ZSTD, CORRUPT, "Zstandard", INDEX + 3 * 24 + 8, 8, 20, 0, 0},
    {"zstd_bomb", KTX2_ZSTD, CORRUPT, "uncompressedByteLength of level 3 is 1099511627776, not 16", INDEX + 3 * 24 + 16,
     8, (uint64_t)1 << 40, 0, 0},
    {"zlib_cut", KTX2_ZLIB, CORRUPT, "zlib: the stream is cut off", INDEX + 3 * 24 + 8, 8, 20, 0, 0},
    {"dds_header", DDS, CORRUPT, "headers of 123 and 32 bytes", 4, 4, 123, 0, 0},
    {"dds_pixel_format", DDS, CORRUPT, "headers of 124 and 31 bytes", 76, 4, 31, 0, 0},
    {"dds_code", DDS, UNSUPPORTED, "dwFourCC 0x42475841", 84, 4, 0x42475841, 0, 0},
    {"dds_levels", DDS, CORRUPT, "9 levels, not 1..4", 28, 4, 9, 0, 0},
    {"dds_levels_max", DDS, CORRUPT, "4294967295 levels", 28, 4, 0xffffffff, 0, 0},
    {"dds_width", DDS, SHD_ERROR_LIMIT, "width 65540", 16, 4, 65540, 0, 0},
    {"dds_larger", DDS, CORRUPT, "bytes are below 128 of the header and", 16, 4, 16, 0, 0},
    {"dds_faces", DDS, UNSUPPORTED, "a cube map without all faces, dwCaps2 0x600", 112, 4, 0x600, 0, 0},
    {"dds_volume", DDS, CORRUPT, "bytes are below 128 of the header and", 24, 4, 2, 112, 0x200000},
    {"dds_pixels", DDS, UNSUPPORTED, "pixels of 0 bits", 80, 4, 0x40, 0, 0},
    {"dds_mask", DDS, UNSUPPORTED, "pixels of 8 bits, masks 0x100", 80, 8, 0x40, 88, 8},
    {"dds_palette", DDS, UNSUPPORTED, "pixels of 8 bits, masks 0x0", 80, 8, 0x21, 88, 8},
    {"dds_yuv", DDS, UNSUPPORTED, "and flags 0x201", 80, 8, 0x201, 88, 16},
    {"dds_signed", DDS, UNSUPPORTED, "and flags 0x80001", 80, 8, 0x80001, 88, 32},
    {"dx10_format", DDS_DX10, UNSUPPORTED, "dxgiFormat 97 is not a format of shd", 128, 4, 97, 0, 0},
    {"dx10_dimension", DDS_DX10, CORRUPT, "resourceDimension 1 is not in 2..4", 132, 4, 1, 0, 0},
    {"dx10_no_layers", DDS_DX10, SHD_OK, "", 140, 4, 0, 0, 0}, /* as 1 */
    {"dx10_no_dimension", DDS_DX10, SHD_OK, "", 132, 4, 0, 0, 0},
    {"dds_pixel_format_24", DDS, SHD_OK, "", 76, 4, 24, 0, 0},
    {"dds_pixel_format_0", DDS, SHD_OK, "", 76, 4, 0, 0, 0},
    {"dds_one_level_too_many", DDS, SHD_OK, "", 28, 4, 5, 0, 0},
    {"dx10_layers", DDS_DX10, SHD_ERROR_LIMIT, "4294967295 layers are above 2048", 140, 4, 0xffffffff, 0, 0},
    {"dx10_more_layers", DDS_DX10, CORRUPT, "of 4 levels and 2 images", 140, 4, 2, 0, 0},
    {"dx10_volume", DDS_DX10, CORRUPT, "bytes are below 148 of the header and", 24, 4, 2, 132, 4},
};

static void test_bad(void **state)
{
    const struct bad_case *c = (const struct bad_case *)*state;
    const io_bytes *file = &g_files[c->file];
    unsigned char *changed = (unsigned char *)malloc(file->size);
    io_bytes edit = {changed, file->size};
    shd_texture *texture;
    if (g_absent[c->file]) {
        free(changed);
        skip();
    }
    memcpy(changed, file->data, file->size);
    file_set(&edit, c->at, c->value, c->size);
    if (c->at2) file_set(&edit, c->at2, c->value2, 4);
    if (c->at == 80 && c->at2) file_set(&edit, 104, 0xff, 4); /* a mask of alpha, too */
    if (strcmp(c->name, "dds_mask") == 0) file_set(&edit, 92, 0x100, 4);
    shd_assert_result(c->name, load(g_context, changed, file->size, NULL, &texture), c->expected, c->message);
    shd_texture_release(texture);
    free(changed);
}

/* Every truncation is refused, and leaves no memory. */
static void test_truncations(void **state)
{
    int f;
    (void)state;
    for (f = 0; f < FILES; ++f) {
        if (g_absent[f]) continue;
        shd_fault_allocator faults = {0};
        const shd_context_desc desc = shd_fault_context_desc(&faults);
        shd_context *context = NULL;
        shd_texture *texture;
        size_t size;
        shd_assert_ok(shd_context_create(&desc, &context));
        for (size = 0; size < g_files[f].size; ++size) {
            const size_t bytes = faults.live_bytes;
            const shd_result result = load(context, g_files[f].data, size, NULL, &texture);
            /* Less than the identifier is no file of either kind. */
            const shd_result expected = size > 0 && size < (f < DDS ? 12u : 4u) ? UNSUPPORTED : CORRUPT;
            if (result != expected) fail_msg("file %d, %zu bytes: %s", f, size, shd_result_name(result));
            assert_int_equal(faults.live_bytes, bytes);
        }
        shd_assert_ok(load(context, g_files[f].data, size, NULL, &texture));
        shd_texture_release(texture);
        shd_context_release(context);
        shd_assert_all_freed("truncations", &faults);
    }
}

/* Each bit of a file is wrong once: any result but a crash, a leak or an internal error. */
static void test_bits(void **state)
{
    int f;
    size_t loaded = 0, refused = 0;
    (void)state;
    for (f = 0; f < FILES; ++f) {
        if (g_absent[f]) continue;
        size_t bit;
        for (bit = 0; bit < 8 * g_files[f].size; ++bit) {
            shd_texture *texture;
            g_files[f].data[bit / 8] ^= (unsigned char)(1u << bit % 8);
            if (load(g_context, g_files[f].data, g_files[f].size, NULL, &texture) == SHD_OK) {
                ++loaded;
            } else {
                ++refused;
            }
            shd_texture_release(texture);
            g_files[f].data[bit / 8] ^= (unsigned char)(1u << bit % 8);
        }
    }
    print_message("%zu loaded, %zu refused\n", loaded, refused);
    assert_true(loaded > 0 && refused > 0);
}

/* Each allocation fails once: SHD_ERROR_OUT_OF_MEMORY, nothing is left, and the next load works. */
static void test_allocations(void **state)
{
    int f;
    (void)state;
    for (f = 0; f < FILES; ++f) {
        if (g_absent[f]) continue;
        shd_fault_allocator faults = {0};
        const shd_context_desc desc = shd_fault_context_desc(&faults);
        shd_context *context = NULL;
        shd_texture *texture = NULL;
        const char *path = io_path("faults");
        size_t n, live;
        io_write(path, g_files[f].data, g_files[f].size);
        shd_assert_ok(shd_context_create(&desc, &context));
        shd_assert_ok(load(context, g_files[f].data, g_files[f].size, NULL, &texture)); /* the context's own tables */
        shd_texture_release(texture);
        texture = NULL;
        live = faults.live_bytes;
        for (n = 1; n < 1000; ++n) {
            shd_result result;
            shd_fault_arm(&faults, n, 0);
            result = load_file(context, path, NULL, NULL, &texture);
            shd_fault_arm(&faults, 0, 0);
            if (result == SHD_OK) break;
            shd_assert_result("allocation", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
            assert_null(texture);
            assert_int_equal(faults.live_bytes, live);
            shd_assert_ok(load(context, g_files[f].data, g_files[f].size, NULL, &texture));
            shd_texture_release(texture);
        }
        assert_true(n > 2 && n < 1000);
        shd_texture_release(texture);
        shd_context_release(context);
        shd_assert_all_freed("allocations", &faults);
    }
}

/** A load desc that is refused. */
struct budget_case {
    const char *name;
    int file;
    shd_result expected;
    const char *message;
    uint64_t max_file_bytes, max_pixels, max_bytes;
    uint32_t flags, formats, subimage;
};
static const struct budget_case k_budgets[] = {
    {"budget/file", DDS, SHD_ERROR_LIMIT, "above load.max_file_bytes 100", 100, 0, 0, 0, 0, 0},
    {"budget/pixels", KTX2, SHD_ERROR_LIMIT, "96 texels are above load.max_pixels 95", 0, 95, 0, 0, 0, 0},
    {"budget/pixels_fit", KTX2, SHD_OK, "", 0, 96, 0, 0, 0, 0},
    {"budget/bytes", KTX2, SHD_ERROR_LIMIT, "508 bytes of texels are above load.max_bytes 507", 0, 0, 507, 0, 0, 0},
    {"budget/bytes_fit", KTX2, SHD_OK, "", 0, 0, 508, 0, 0, 0},
    {"budget/linear", KTX2, UNSUPPORTED, "SHD_LOAD_LINEAR, but textures", 0, 0, 0, SHD_LOAD_LINEAR, 0, 0},
    {"budget/flip_blocks", DDS, UNSUPPORTED, "SHD_LOAD_FLIP_V, but rows within blocks", 0, 0, 0, SHD_LOAD_FLIP_V, 0, 0},
    {"budget/formats", DDS, UNSUPPORTED, "the content is DDS, which load.formats does not allow", 0, 0, 0, 0,
     SHD_FILE_FORMAT_KTX2, 0},
    {"budget/formats_fit", DDS, SHD_OK, "", 0, 0, 0, 0, SHD_FILE_FORMAT_DDS, 0},
    {"budget/subimage", KTX2_CUBE, SHD_ERROR_INVALID_ARGUMENT, "load.subimage: 1 is not in 0..0", 0, 0, 0, 0, 0, 1},
};

static void test_budget(void **state)
{
    const struct budget_case *c = (const struct budget_case *)*state;
    shd_load_desc desc = shd_load_desc_default();
    shd_texture *texture;
    if (c->max_file_bytes) desc.max_file_bytes = c->max_file_bytes;
    if (c->max_pixels) desc.max_pixels = c->max_pixels;
    if (c->max_bytes) desc.max_bytes = c->max_bytes;
    desc.flags = c->flags;
    if (c->formats) desc.formats = c->formats;
    desc.subimage = c->subimage;
    shd_assert_result(c->name, load(g_context, g_files[c->file].data, g_files[c->file].size, &desc, &texture),
                      c->expected, c->message);
    shd_texture_release(texture);
}

/* A small file of a large texture: the ratio is checked before memory is allocated. */
static void test_bomb(void **state)
{
    const file_texture t = {16384, 16384, 0, 0, 1, 1, 16, 4, 4};
    const file_ktx2 k = {145, 1, 134, 1, 0, NULL, NULL};
    shd_fault_allocator faults = {0};
    const shd_context_desc desc = shd_fault_context_desc(&faults);
    const file_texture small = {4, 4, 0, 0, 1, 1, 16, 4, 4};
    io_bytes file = file_make_ktx2(&small, &k, NULL);
    shd_context *context = NULL;
    shd_texture *texture;
    (void)state;
    file_set(&file, 20, t.width, 4);
    file_set(&file, 24, t.height, 4);
    file_set(&file, 44, SHD_SUPERCOMPRESSION_ZSTD, 4);
    file_set(&file, FILE_KTX2_INDEX + 16, file_image_size(&t, 0), 8);
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_assert_result("bomb", load(context, file.data, file.size, NULL, &texture), SHD_ERROR_LIMIT,
                      "268435456 bytes of texels from 208 are above load.max_ratio 4000");
    assert_true(faults.peak_bytes < 1 << 20);
    shd_context_release(context);
    free(file.data);
}

static void test_arguments(void **state)
{
    const io_bytes *file = &g_files[KTX2];
    shd_texture *texture = NULL;
    shd_texture_file_info info = shd_texture_file_info_default();
    const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
    (void)state;
    shd_assert_result("out", load_file(g_context, "x", NULL, NULL, NULL), bad, "out_texture: NULL");
    shd_assert_result("context", load_file(NULL, "x", NULL, NULL, &texture), bad, "context: NULL");
    shd_assert_result("path", load_file(g_context, NULL, NULL, NULL, &texture), bad, "path: NULL");
    shd_assert_result("absent", load_file(g_context, io_path("no.dds"), NULL, NULL, &texture), SHD_ERROR_NOT_FOUND,
                      "no.dds");
    shd_assert_result("bytes", load_file_memory(g_context, NULL, 9, NULL, NULL, &texture), bad, "bytes: NULL");
    info.struct_size = 4;
    shd_assert_result("info", load_file_memory(g_context, file->data, file->size, NULL, &info, &texture), bad,
                      "load.info.struct_size");
    io_write(io_path("bad.dds"), "DDS ", 4);
    shd_assert_result("names the path", load_file(g_context, io_path("bad.dds"), NULL, NULL, &texture), CORRUPT,
                      "bad.dds\": DDS: 4 bytes end within the header");
    assert_null(texture);
}

int main(void)
{
    void *state = NULL;
    int failed, f;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    make_files();
    for (f = 0; f < FILES; ++f) {
        shd_texture *texture = NULL;
        g_absent[f] =
            file_is_absent(load_file_memory(g_context, g_files[f].data, g_files[f].size, NULL, NULL, &texture));
        shd_texture_release(texture);
    }
    ADD_ROWS(k_bad, test_bad);
    ADD_ROWS(k_budgets, test_budget);
    add("truncations", test_truncations, NULL);
    add("bits", test_bits, NULL);
    add("allocations", test_allocations, NULL);
    add("bomb", test_bomb, NULL);
    add("arguments", test_arguments, NULL);
    failed = _cmocka_run_group_tests("api.io_texture_bad", g_tests, g_count, NULL, NULL);
    for (f = 0; f < FILES; ++f) free(g_files[f].data);
    shd_context_release(g_context);
    io_remove_folder(&state);
    return failed;
}
