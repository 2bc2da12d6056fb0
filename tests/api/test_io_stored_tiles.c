/* SPDX-License-Identifier: MIT */
/* Textures whose tiles are read from KTX2 and DDS files against the same files in memory: every format and kind, files
 * larger than memory holds, damaged and changed files. */
#define _GNU_SOURCE
#include "support/fault_allocator.h"
#include "support/loads.h"
#include "support/rows.h"
#include "support/texture_formats.h"

#include <shd/shd.h>
#include <shd/tile_file.h>

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

enum { COUNT = 400, COLUMNS = 9, FILTERS = 6 };

static shd_tile_cache *g_small, *g_large; /* the small one evicts tiles of every file */

static shd_tile_cache *make_cache(shd_context *context, uint32_t tile_bytes, uint64_t budget)
{
    shd_tile_cache_desc desc = shd_tile_cache_desc_default();
    shd_tile_cache *cache = NULL;
    desc.tile_bytes = tile_bytes, desc.budget_bytes = budget;
    shd_assert_ok(shd_tile_cache_create(context, &desc, &cache));
    return cache;
}

static shd_result open_tiles(const char *path, shd_tile_cache *cache, shd_color_encoding encoding, shd_texture **out,
                             shd_tile_file_info *info)
{
    shd_tile_file_desc desc = shd_tile_file_desc_default();
    desc.cache = cache;
    desc.encoding = encoding;
    return shd_texture_open(g_context, path, &desc, out, info);
}

/** Lookups of all footprints, everywhere, in every kind of texture. */
struct batch {
    float column[COLUMNS][COUNT], out[4][COUNT];
    uint32_t layer[COUNT];
};

static void fill_batch(struct batch *b, uint64_t seed)
{
    int c, i;
    for (i = 0; i < COUNT; ++i) {
        for (c = 0; c < 3; ++c) b->column[c][i] = (float)(io_random(&seed) % 4096) / 1024.0f - 2.0f;
        for (c = 3; c < COLUMNS; ++c) b->column[c][i] = 1.0f / (float)(1u << io_random(&seed) % 8);
        b->layer[i] = (uint32_t)(io_random(&seed) % 3);
    }
}

static shd_result sample(struct batch *b, const shd_texture *texture, shd_filter filter)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_lookups in = shd_lookups_default();
    shd_texels to = shd_texels_default();
    shd_sampler *sampler = NULL;
    shd_f32_in *const ins[COLUMNS] = {&in.u, &in.v, &in.w, &in.dudx, &in.dvdx, &in.dwdx, &in.dudy, &in.dvdy, &in.dwdy};
    shd_result result;
    int c;
    desc.filter = filter;
    desc.wrap_u = SHD_WRAP_BORDER;
    shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
    in.count = COUNT;
    for (c = 0; c < COLUMNS; ++c) ins[c]->data = b->column[c];
    in.layer.data = b->layer;
    memset(b->out, 0, sizeof b->out);
    for (c = 0; c < 4; ++c) to.channel[c].data = b->out[c];
    result = shd_texture_sample(texture, sampler, &in, &to);
    shd_sampler_release(sampler);
    return result;
}

static const shd_filter k_filters[FILTERS] = {SHD_FILTER_NEAREST,   SHD_FILTER_BILINEAR,    SHD_FILTER_BICUBIC,
                                              SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA};

/** Returns the number of filters that both textures have, or -1 if lookups differ. Any thread. */
static int same_filters(const shd_texture *tiles, const shd_texture *memory, uint64_t seed)
{
    static __thread struct batch got, want;
    int f, same = 0;
    for (f = 0; f < FILTERS; ++f) {
        shd_result a, b;
        fill_batch(&got, seed), fill_batch(&want, seed);
        a = sample(&got, tiles, k_filters[f]), b = sample(&want, memory, k_filters[f]);
        if (a != b || memcmp(got.out, want.out, sizeof got.out) != 0) return -1;
        same += a == SHD_OK;
    }
    return same;
}

static void expect_same(const char *name, const shd_texture *tiles, const shd_texture *memory)
{
    const int same = same_filters(tiles, memory, 5);
    if (same != FILTERS) fail_msg("%s: %d filters are the same", name, same);
}

/** A file in tiles of both caches and in memory: the same texture. Frees the bytes. */
static void check_file(const char *name, io_bytes file, const file_texture *t, shd_color_encoding encoding)
{
    const char *path = io_path("tiles");
    shd_load_desc load = shd_load_desc_default();
    shd_texture_info want = shd_texture_info_default(), got = shd_texture_info_default();
    shd_texture *memory = NULL, *tiles = NULL;
    int i;
    load.flags = SHD_LOAD_IN_PROCESS;
    load.encoding = encoding;
    if (t->level_count < 2) load.tables = 0;
    io_write(path, file.data, file.size);
    shd_assert_ok(load_file_memory(g_context, file.data, file.size, &load, NULL, &memory));
    shd_assert_ok(shd_texture_get_info(memory, &want));
    for (i = 0; i < 2; ++i) {
        shd_tile_file_info info = shd_tile_file_info_default();
        uint32_t l, k;
        shd_assert_ok(open_tiles(path, i ? g_small : g_large, encoding, &tiles, &info));
        assert_int_equal(info.file_count * info.column_count * info.row_count, 1);
        assert_int_equal(info.tile_width, t->block_w);
        assert_int_equal(info.tile_height, t->block_h);
        shd_assert_ok(shd_texture_get_info(tiles, &got));
        got.byte_size = want.byte_size;
        if (memcmp(&got, &want, sizeof got) != 0) fail_msg("%s: format %d, flags %x", name, got.format, got.flags);
        expect_same(name, tiles, memory);
        for (l = 0; l < want.level_count; ++l) {
            for (k = 0; k < want.layer_count; ++k) {
                io_bytes a = read_image(tiles, k, l), b = read_image(memory, k, l);
                if (memcmp(a.data, b.data, b.size) != 0) fail_msg("%s: image %u of level %u differs", name, k, l);
                free(a.data), free(b.data);
            }
        }
        shd_texture_release(tiles);
    }
    shd_texture_release(memory);
    free(file.data);
}

static void test_format(void **state)
{
    const struct format_case *c = (const struct format_case *)*state;
    const file_texture t = texture_of(c, 69, 45, 7);
    file_ktx2 k = ktx2_of(c);
    if (c->order != SAME) return;
    if (c->vulkan) check_file(c->name, file_make_ktx2(&t, &k, NULL), &t, SHD_COLOR_ENCODING_AUTO);
    if (c->vulkan && c->srgb) check_file(c->name, file_make_ktx2(&t, &k, NULL), &t, SHD_COLOR_ENCODING_DATA);
    if (c->dxgi) check_file(c->name, file_make_dds(&t, "DX10", c->dxgi), &t, SHD_COLOR_ENCODING_AUTO);
    k.swizzle = "bga1";
    if (c->vulkan) check_file(c->name, file_make_ktx2(&t, &k, NULL), &t, SHD_COLOR_ENCODING_AUTO);
}

static void test_kind(void **state)
{
    static const char *const k_rows[] = {"r16", "rgb8", "rgba8", "rgba16f", "bc1_rgba", "bc3", "bc5", "bc7"};
    const struct kind_case *c = (const struct kind_case *)*state;
    size_t row, i;
    for (row = 0; row < sizeof k_formats / sizeof k_formats[0]; ++row) {
        const struct format_case *f = &k_formats[row];
        file_texture t = texture_of(f, c->width, c->height, c->levels);
        const file_ktx2 k = ktx2_of(f);
        t.depth = c->depth, t.layers = c->layers, t.faces = c->faces;
        for (i = 0; i < sizeof k_rows / sizeof k_rows[0] && strcmp(k_rows[i], f->name) != 0; ++i) continue;
        if (i == sizeof k_rows / sizeof k_rows[0]) continue;
        check_file(c->name, file_make_ktx2(&t, &k, NULL), &t, SHD_COLOR_ENCODING_AUTO);
        if (f->dxgi) check_file(c->name, file_make_dds(&t, "DX10", f->dxgi), &t, SHD_COLOR_ENCODING_AUTO);
        if (c->width < 40 && c->faces == 1) { /* The level has many tiles. */
            t.width = 83, t.height = 41;
            check_file(c->name, file_make_ktx2(&t, &k, NULL), &t, SHD_COLOR_ENCODING_AUTO);
        }
    }
}

/** A file that libshd_io writes from memory, opened, and written again from its tiles. */
static void test_saved(void **state)
{
    static const file_texture k_textures[] = {{93, 70, 0, 0, 1, 7, 16, 4, 4},
                                              {50, 31, 0, 3, 1, 6, 16, 4, 4},
                                              {45, 45, 0, 0, 6, 6, 16, 4, 4},
                                              {33, 30, 19, 0, 1, 6, 16, 4, 4}};
    const file_ktx2 k = {145, 1, 134, 1, 0, NULL, NULL};
    size_t i;
    (void)state;
    for (i = 0; i < sizeof k_textures / sizeof k_textures[0]; ++i) {
        shd_load_desc desc = shd_load_desc_default();
        shd_texture_file_info info;
        shd_texture *memory = load(file_make_ktx2(&k_textures[i], &k, NULL), &desc, 0, &info), *tiles = NULL;
        io_bytes first, second;
        shd_assert_ok(shd_texture_save_ktx2(memory, io_path("saved.ktx2"), NULL));
        shd_assert_ok(open_tiles(io_path("saved.ktx2"), g_small, SHD_COLOR_ENCODING_AUTO, &tiles, NULL));
        expect_same("saved", tiles, memory);
        shd_assert_ok(shd_texture_save_ktx2(tiles, io_path("again.ktx2"), NULL));
        first = io_read(io_path("saved.ktx2")), second = io_read(io_path("again.ktx2"));
        assert_int_equal(first.size, second.size);
        assert_memory_equal(first.data, second.data, first.size);
        free(first.data), free(second.data);
        shd_texture_release(tiles);
        shd_texture_release(memory);
    }
}

/** A file of 8 GiB, of which only the header and the last row of blocks are on the disk. */
static void test_large(void **state)
{
    enum { SIDE = 131072, ACROSS = SIDE / 4 };
    const uint64_t size = (uint64_t)ACROSS * ACROSS * 8, levels_at = 4096;
    const file_texture small = {4, 4, 0, 0, 1, 1, 8, 4, 4};
    const file_ktx2 k = {133, 1, 128, 1, 0, NULL, NULL};
    const unsigned char white[8] = {0xff, 0xff, 0, 0, 0, 0, 0, 0};
    io_bytes file = file_make_ktx2(&small, &k, NULL);
    shd_texture *texture = NULL;
    static struct batch b;
    int fd, i;
    (void)state;
    file_set(&file, 20, SIDE, 4), file_set(&file, 24, SIDE, 4);
    file_set(&file, FILE_KTX2_INDEX, levels_at, 8);
    file_set(&file, FILE_KTX2_INDEX + 8, size, 8), file_set(&file, FILE_KTX2_INDEX + 16, size, 8);
    io_write(io_path("large.ktx2"), file.data, file.size);
    fd = open(io_path("large.ktx2"), O_WRONLY);
    assert_int_equal(ftruncate(fd, (off_t)(levels_at + size)), 0);
    for (i = 0; i < ACROSS / 2; ++i) { /* the right half */
        assert_int_equal(pwrite(fd, white, 8, (off_t)(levels_at + size) - 8 * (i + 1)), 8);
    }
    assert_int_equal(close(fd), 0);
    free(file.data);
    shd_assert_ok(open_tiles(io_path("large.ktx2"), g_small, SHD_COLOR_ENCODING_AUTO, &texture, NULL));
    fill_batch(&b, 3);
    for (i = 0; i < COUNT; ++i) {
        b.column[0][i] = ((float)(i * 327) + 0.5f) / SIDE;
        b.column[1][i] = ((float)(SIDE - 1 - i % 8) + 0.5f) / SIDE;
    }
    shd_assert_ok(sample(&b, texture, SHD_FILTER_NEAREST));
    for (i = 0; i < COUNT; ++i) {
        const int lit = i * 327 >= SIDE / 2 && i % 8 < 4;
        if (b.out[0][i] != (lit ? 1.0f : 0.0f)) fail_msg("texel %d, row %d: %g", i * 327, i % 8, (double)b.out[0][i]);
    }
    shd_texture_release(texture);
    assert_int_equal(unlink(io_path("large.ktx2")), 0);
}

/** A file that is refused, by its name. */
struct refused_case {
    const char *name;
    shd_result expected;
    const char *message;
    uint32_t format, model, scheme; /* fields of a KTX2 file; 0 = a DDS file */
    uint32_t dxgi;
};
static const struct refused_case k_refused[] = {
    {"zstd", SHD_ERROR_UNSUPPORTED, "are supercompressed, and tiles are read as they are stored: shd_texture_load()",
     145, 134, 2, 0},
    {"zlib", SHD_ERROR_UNSUPPORTED, "are supercompressed", 145, 134, 3, 0},
    {"basis_lz", SHD_ERROR_UNSUPPORTED, "KTX2: Basis Universal", 145, 134, 1, 0},
    {"astc", SHD_ERROR_UNSUPPORTED, "the blocks are ASTC, and tiles", 157, 162, 0, 0},
    {"bgra", SHD_ERROR_UNSUPPORTED, "the channels are in another order, or bit fields, and tiles", 44, 1, 0, 0},
    {"dds_bgra", SHD_ERROR_UNSUPPORTED, "the channels are in another order", 0, 0, 0, 87},
    {"vulkan", SHD_ERROR_UNSUPPORTED, "vkFormat 1 is not a format of shd", 1, 1, 0, 0},
};

static void expect_refused(const char *path, shd_result expected, const char *message)
{
    shd_texture *texture = (shd_texture *)&g_context;
    shd_tile_file_info info = shd_tile_file_info_default();
    info.column_count = 7;
    shd_assert_result(message, open_tiles(path, g_small, SHD_COLOR_ENCODING_AUTO, &texture, &info), expected, message);
    shd_assert_result(path, expected, expected, strrchr(path, '/') + 1); /* the text names the file */
    assert_null(texture);
    assert_int_equal(info.column_count, 0);
}

static void test_refused(void **state)
{
    const struct refused_case *c = (const struct refused_case *)*state;
    const uint32_t unit = c->model > 100 ? 16 : 4, block = c->model > 100 ? 4 : 1;
    const file_texture t = {12, 8, 0, 0, 1, 1, unit, block, block};
    const file_ktx2 k = {c->format, 1, c->model, 1, c->scheme, NULL, NULL};
    io_bytes file = c->format ? file_make_ktx2(&t, &k, NULL) : file_make_dds(&t, "DX10", c->dxgi);
    io_write(io_path("refused"), file.data, file.size);
    free(file.data);
    expect_refused(io_path("refused"), c->expected, c->message);
}

static void test_places(void **state)
{
    const file_texture t = {12, 8, 0, 0, 1, 1, 16, 4, 4};
    const file_ktx2 k = {145, 1, 134, 1, 0, "rgba", "rd"};
    io_bytes file = file_make_ktx2(&t, &k, NULL);
    shd_texture *texture = NULL;
    uint32_t at, size;
    (void)state;
    io_write(io_path("set.1001.ktx2"), file.data, file.size);
    shd_assert_ok(open_tiles(io_path("set.<UDIM>.ktx2"), g_small, SHD_COLOR_ENCODING_AUTO, &texture, NULL));
    shd_texture_release(texture);
    io_write(io_path("set.1002.ktx2"), file.data, file.size);
    expect_refused(io_path("set.<UDIM>.ktx2"), SHD_ERROR_UNSUPPORTED, "sets of KTX2 or DDS files");
    expect_refused(io_path("no.ktx2"), SHD_ERROR_NOT_FOUND, "cannot open");
    assert_int_equal(mkdir(io_path("folder.ktx2"), 0700), 0);
    expect_refused(io_path("folder.ktx2"), SHD_ERROR_IO, "is not a regular file");
    assert_int_equal(rmdir(io_path("folder.ktx2")), 0);
    for (size = 0; size < file.size; ++size) { /* cut at every byte */
        io_write(io_path("cut"), file.data, size);
        assert_int_not_equal(open_tiles(io_path("cut"), g_small, SHD_COLOR_ENCODING_AUTO, &texture, NULL), SHD_OK);
        assert_non_null(strstr(shd_last_error(), "cut\""));
        assert_null(texture);
    }
    memcpy(&at, file.data + 56, 4), memcpy(&size, file.data + 60, 4);
    file.data = (unsigned char *)realloc(file.data, (2u << 20) + size);
    memcpy(file.data + (2u << 20), file.data + at, size);
    file_set(&file, 56, 2u << 20, 4);
    io_write(io_path("far"), file.data, (2u << 20) + size);
    expect_refused(io_path("far"), SHD_ERROR_LIMIT, "data before the levels end beyond the first 1048576 bytes");
    free(file.data);
}

/** A file that changes while it is open. */
static void test_changes(void **state)
{
    const file_texture t = {256, 256, 0, 0, 1, 9, 16, 4, 4};
    const file_ktx2 k = {145, 1, 134, 1, 0, NULL, NULL};
    io_bytes file = file_make_ktx2(&t, &k, NULL);
    const char *path = io_path("changes");
    shd_texture_file_info info;
    shd_texture *memory = load(file_make_ktx2(&t, &k, NULL), NULL, 0, &info), *tiles = NULL;
    static struct batch b;
    unsigned char blocks[64 * 64 * 16];
    shd_image image = shd_image_default();
    int i;
    (void)state;
    io_write(path, file.data, file.size);
    shd_assert_ok(open_tiles(path, g_small, SHD_COLOR_ENCODING_AUTO, &tiles, NULL));
    fill_batch(&b, 1);
    image.format = SHD_FORMAT_BC7, image.width = image.height = 256, image.pixels = blocks;
    for (i = 0; i < 2; ++i) {
        assert_int_equal(truncate(path, i ? 0 : (off_t)file.size / 2), 0);
        shd_assert_result("cut", sample(&b, tiles, SHD_FILTER_NEAREST), SHD_ERROR_CALLBACK,
                          "/changes\": mip level 0, layer 0, columns ");
        shd_assert_result("cut", shd_texture_read_level(tiles, 0, 0, &image), SHD_ERROR_CALLBACK,
                          "SHD_ERROR_CORRUPT for 1 tiles");
    }
    io_write(path, file.data, file.size); /* the same inode */
    expect_same("repaired", tiles, memory);
    shd_texture_release(tiles);
    shd_texture_release(memory);
    free(file.data);
}

struct worker {
    pthread_t thread;
    const shd_texture *tiles, *memory;
    uint64_t seed;
    int same;
};
static void *work(void *data)
{
    struct worker *w = (struct worker *)data;
    int i;
    for (i = 0; i < 8; ++i) w->same += same_filters(w->tiles, w->memory, w->seed + (uint64_t)i);
    return NULL;
}

static void test_threads(void **state)
{
    const file_texture t = {512, 256, 0, 0, 1, 10, 8, 4, 4};
    const file_ktx2 k = {133, 1, 128, 1, 0, NULL, NULL};
    shd_texture_file_info info;
    shd_tile_cache *cache = make_cache(g_context, 4096, 1 << 17);
    shd_tile_cache_stats stats = shd_tile_cache_stats_default();
    shd_texture *memory = load(file_make_ktx2(&t, &k, NULL), NULL, 1, &info), *tiles = NULL;
    struct worker workers[4];
    uint64_t i;
    (void)state;
    shd_assert_ok(open_tiles(io_path("texture"), cache, SHD_COLOR_ENCODING_AUTO, &tiles, NULL));
    for (i = 0; i < 4; ++i) {
        const struct worker w = {0, tiles, memory, 1 + 100 * i, 0};
        workers[i] = w;
        assert_int_equal(pthread_create(&workers[i].thread, NULL, work, &workers[i]), 0);
    }
    for (i = 0; i < 4; ++i) {
        pthread_join(workers[i].thread, NULL);
        assert_int_equal(workers[i].same, 8 * FILTERS);
    }
    shd_assert_ok(shd_tile_cache_get_stats(cache, &stats));
    assert_true(stats.evicted_tile_count > stats.tile_count); /* some were read again */
    shd_texture_release(tiles);
    shd_texture_release(memory);
    shd_tile_cache_release(cache);
}

/** Each allocation of an open fails once. */
static void test_allocations(void **state)
{
    const file_texture t = {12, 8, 0, 0, 1, 4, 16, 4, 4};
    const file_ktx2 k = {145, 1, 134, 1, 0, NULL, NULL};
    io_bytes file = file_make_ktx2(&t, &k, NULL);
    shd_fault_allocator faults = {0};
    const shd_context_desc desc = shd_fault_context_desc(&faults);
    shd_tile_file_desc open = shd_tile_file_desc_default();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    size_t n, live;
    (void)state;
    io_write(io_path("faults"), file.data, file.size);
    free(file.data);
    shd_assert_ok(shd_context_create(&desc, &context));
    open.cache = make_cache(context, 1024, 1 << 18);
    live = faults.live_bytes;
    for (n = 1; n < 100; ++n) {
        shd_result result;
        shd_fault_arm(&faults, n, 0);
        result = shd_texture_open(context, io_path("faults"), &open, &texture, NULL);
        shd_fault_arm(&faults, 0, 0);
        if (result == SHD_OK) break;
        shd_assert_result("allocation", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        assert_null(texture);
        assert_int_equal(faults.live_bytes, live);
    }
    assert_true(n > 2 && n < 100);
    shd_texture_release(texture);
    shd_tile_cache_release(open.cache);
    shd_context_release(context);
    shd_assert_all_freed("allocations", &faults);
}

int main(void)
{
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    g_small = make_cache(g_context, 1024, 1 << 17);
    g_large = make_cache(g_context, 65536, 1 << 22);
    ADD_ROWS(k_formats, test_format);
    ADD_ROWS(k_kinds, test_kind);
    ADD_ROWS(k_refused, test_refused);
    add("saved", test_saved, NULL);
    add("large", test_large, NULL);
    add("places", test_places, NULL);
    add("changes", test_changes, NULL);
    add("threads", test_threads, NULL);
    add("allocations", test_allocations, NULL);
    failed = _cmocka_run_group_tests("api.io_stored_tiles", g_tests, g_count, NULL, NULL);
    shd_tile_cache_release(g_small);
    shd_tile_cache_release(g_large);
    shd_context_release(g_context);
    io_remove_folder(&state);
    return failed;
}
