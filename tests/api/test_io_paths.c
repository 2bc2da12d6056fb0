/* SPDX-License-Identifier: MIT */
/* Paths that name no readable regular file: every function of libshd_io that takes a path refuses each of them at once,
 * with a message that names the path. */
#define _GNU_SOURCE
#include "support/loads.h"
#include "support/odd_paths.h"
#include "support/rows.h"

#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/tile_file.h>
#include <shd/volume_file.h>

static shd_context *g_context;
static shd_tile_cache *g_cache;

static shd_result load_bitmap(const char *path, shd_load_flags flags)
{
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = (shd_bitmap *)&desc;
    shd_result result;
    desc.flags = flags;
    result = shd_bitmap_load(g_context, path, &desc, &bitmap);
    assert_null(bitmap);
    return result;
}

static shd_result bitmap_worker(const char *path) { return load_bitmap(path, SHD_LOAD_NONE); }
static shd_result bitmap_in_process(const char *path) { return load_bitmap(path, SHD_LOAD_IN_PROCESS); }

/* The functions that make a texture. Each gets a handle that is not NULL. */
typedef shd_result make_texture(const char *path, shd_texture **texture);

static shd_result image_file(const char *path, shd_texture **texture)
{
    return shd_texture_load(g_context, path, NULL, texture);
}

static shd_result texture_file(const char *path, shd_texture **texture)
{
    return load_file(g_context, path, NULL, NULL, texture);
}

static shd_result raw_file(const char *path, shd_texture **texture)
{
    shd_raw_desc raw = shd_raw_desc_default();
    raw.width = raw.height = raw.depth = 1;
    return load_raw(g_context, path, &raw, NULL, texture);
}

static shd_result stack_page(const char *path, shd_texture **texture)
{
    shd_stack_desc stack = shd_stack_desc_default();
    stack.paths = &path;
    stack.path_count = 1;
    return load_stack(g_context, &stack, NULL, texture);
}

static shd_result stack_slices(const char *path, shd_texture **texture)
{
    shd_stack_desc stack = shd_stack_desc_default();
    const char *paths[2];
    paths[0] = io_path("good.png");
    paths[1] = path;
    stack.paths = paths;
    stack.path_count = 2;
    return load_stack(g_context, &stack, NULL, texture);
}

static shd_result stack_pattern(const char *path, shd_texture **texture)
{
    shd_stack_desc stack = shd_stack_desc_default();
    char pattern[700];
    snprintf(pattern, sizeof pattern, "%.*s%%d", (int)strlen(path) - 1, path);
    stack.pattern = pattern;
    return load_stack(g_context, &stack, NULL, texture);
}

static shd_result vdb_file(const char *path, shd_texture **texture)
{
    return load_vdb(g_context, path, NULL, NULL, NULL, texture);
}

static shd_result tiled_file(const char *path, shd_texture **texture)
{
    shd_tile_file_desc desc = shd_tile_file_desc_default();
    desc.cache = g_cache;
    return shd_texture_open(g_context, path, &desc, texture, NULL);
}

/* One file of a UDIM set is a link to the path. */
static shd_result udim_set(const char *path, shd_texture **texture)
{
    shd_result result;
    assert_int_equal(symlink(path, io_path("udim.1001.tx")), 0);
    result = tiled_file(io_path("udim.<UDIM>.tx"), texture);
    assert_int_equal(unlink(io_path("udim.1001.tx")), 0);
    return result;
}

#define TEXTURE(function)                                   \
    static shd_result load_##function(const char *path)     \
    {                                                       \
        shd_texture *texture = (shd_texture *)&g_folder;    \
        const shd_result result = function(path, &texture); \
        assert_null(texture);                               \
        return result;                                      \
    }
TEXTURE(image_file)
TEXTURE(texture_file)
TEXTURE(raw_file)
TEXTURE(stack_page)
TEXTURE(stack_slices)
TEXTURE(stack_pattern)
TEXTURE(vdb_file)
TEXTURE(tiled_file)
TEXTURE(udim_set)

struct loader {
    const char *name;
    shd_result (*load)(const char *path);
    const char *named; /* name in the message; NULL = that of the path */
};

static const struct loader k_loaders[] = {
    {"shd_bitmap_load", bitmap_worker, NULL},
    {"shd_bitmap_load in process", bitmap_in_process, NULL},
    {"shd_texture_load", load_image_file, NULL},
    {"shd_texture_load_file", load_texture_file, NULL},
    {"shd_texture_load_raw", load_raw_file, NULL},
    {"shd_texture_load_stack, pages", load_stack_page, NULL},
    {"shd_texture_load_stack, slices", load_stack_slices, NULL},
    {"shd_texture_load_stack, pattern", load_stack_pattern, NULL},
    {"shd_texture_load_vdb", load_vdb_file, NULL},
    {"shd_texture_open", load_tiled_file, NULL},
    {"shd_texture_open, UDIM", load_udim_set, "udim.1001.tx"},
};

static void test_loader(void **state)
{
    const struct loader *loader = (const struct loader *)*state;
    size_t i;
    for (i = 0; i < ODD_PATHS; ++i) {
        const odd_path *p = &k_odd_paths[i];
        char name[128], path[600];
        if (!has_odd_path(p)) continue;
        snprintf(name, sizeof name, "%s: %s", loader->name, p->name);
        snprintf(path, sizeof path, "%s", io_path(p->name));
        alarm(20); /* ends the test if the load waits */
        shd_assert_result(name, loader->load(path), p->expected, p->message);
        alarm(0);
        if (!strstr(shd_last_error(), loader->named ? loader->named : p->name)) {
            fail_msg("%s: \"%s\" does not name it", name, shd_last_error());
        }
    }
}

/* A worker that is no program. */
static void test_worker_path(void **state)
{
    size_t i;
    (void)state;
    for (i = 0; i < ODD_PATHS; ++i) {
        shd_load_desc desc = shd_load_desc_default();
        shd_bitmap *bitmap = NULL;
        char path[600];
        shd_result result;
        if (!has_odd_path(&k_odd_paths[i])) continue;
        snprintf(path, sizeof path, "%s", io_path(k_odd_paths[i].name));
        desc.worker_path = path;
        alarm(20);
        result = shd_bitmap_load(g_context, io_path("good.png"), &desc, &bitmap);
        alarm(0);
        assert_true(result == SHD_ERROR_IO || result == SHD_ERROR_NOT_FOUND);
        assert_non_null(strstr(shd_last_error(), "cannot run"));
        assert_null(bitmap);
    }
}

int main(void)
{
    shd_tile_cache_desc cache = shd_tile_cache_desc_default();
    shd_image image = shd_image_default();
    uint8_t pixel[4] = {1, 2, 3, 255};
    void *state = NULL;
    int failed;
    image.format = SHD_FORMAT_RGBA8;
    image.width = image.height = 1;
    image.pixels = pixel;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK ||
        shd_tile_cache_create(g_context, &cache, &g_cache) != SHD_OK ||
        shd_image_save(&image, io_path("good.png"), NULL) != SHD_OK) {
        return 1;
    }
    make_odd_paths();
    ADD_ROWS(k_loaders, test_loader);
    add("worker_path", test_worker_path, NULL);
    failed = _cmocka_run_group_tests("api.io_paths", g_tests, g_count, NULL, NULL);
    io_remove_folder(&state);
    shd_tile_cache_release(g_cache);
    shd_context_release(g_context);
    return failed;
}
