/* SPDX-License-Identifier: MIT */
/* Updates of a rectangle: refusals, lookups after the update, and memory that runs out during it. */
#define _POSIX_C_SOURCE 200112L
#include "support/check.h"
#include "support/fault_allocator.h"

#include <stdlib.h>

#include <shd/shd.h>

enum { WIDTH = 8, HEIGHT = 4, LAYERS = 2, TEXELS = WIDTH * HEIGHT * LAYERS };

static unsigned char g_base[TEXELS * 4];
static uint32_t g_patch[TEXELS];

static shd_texture_desc base_desc(void)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.layer_count = LAYERS;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
    desc.texels = g_base;
    return desc;
}

static shd_image patch_image(uint32_t width, uint32_t height)
{
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8;
    image.width = width;
    image.height = height;
    image.pixels = g_patch;
    return image;
}

/* All levels of all layers, one after another. */
static size_t read_all(const shd_texture *texture, unsigned char *out)
{
    shd_texture_info info = shd_texture_info_default();
    unsigned char *at = out;
    uint32_t layer, level;
    shd_assert_ok(shd_texture_get_info(texture, &info));
    for (layer = 0; layer < info.layer_count; ++layer) {
        for (level = 0; level < info.level_count; ++level) {
            shd_image image = shd_image_default();
            image.format = info.format;
            image.width = info.width >> level ? info.width >> level : 1;
            image.height = info.height >> level ? info.height >> level : 1;
            image.pixels = at;
            shd_assert_ok(shd_texture_read_level(texture, layer, level, &image));
            at += (size_t)image.width * image.height * shd_format_size(info.format);
        }
    }
    return (size_t)(at - out);
}

/* The arguments of an update. */
struct update {
    uint32_t layer, x, y;
    shd_image image;
};
static void edit_nothing(struct update *u) { (void)u; }
static void edit_last_texel(struct update *u)
{
    u->layer = 1;
    u->x = 7;
    u->y = 3;
    u->image.width = u->image.height = 1;
}
static void edit_layer(struct update *u) { u->layer = 2; }
static void edit_x(struct update *u) { u->x = 8; }
static void edit_y(struct update *u) { u->y = 0xffffffffu; }
static void edit_right(struct update *u) { u->x = 6; }
static void edit_below(struct update *u) { u->y = 3; }
static void edit_overflow(struct update *u)
{
    u->x = 7;
    u->image.width = 65536;
}
static void edit_zero(struct update *u) { u->image.width = 0; }
static void edit_null(struct update *u) { u->image.pixels = NULL; }
static void edit_format(struct update *u) { u->image.format = SHD_FORMAT_R8; }
static void edit_three(struct update *u) { u->image.format = SHD_FORMAT_RGB8; }
static void edit_unknown(struct update *u) { u->image.format = (shd_format)77; }
static void edit_stride(struct update *u) { u->image.row_stride = 11; }
static void edit_size(struct update *u) { u->image.struct_size = 0; }

static const struct update_case {
    const char *name;
    void (*edit)(struct update *u);
    const char *message; /* NULL = accepted */
} k_updates[] = {
    {"update/3x2", edit_nothing, NULL},
    {"update/last_texel", edit_last_texel, NULL},
    {"update/layer_2", edit_layer, "layer: 2 is not in 0..1"},
    {"update/x_8", edit_x, "x: 8 is not in 0..7"},
    {"update/negative_y", edit_y, "y: 4294967295 is not in 0..3"},
    {"update/beyond_the_right", edit_right, "texels.width: 3 is not in 1..2"},
    {"update/beyond_the_bottom", edit_below, "texels.height: 2 is not in 1..1"},
    {"update/width_65536", edit_overflow, "texels.width: 65536 is not in 1..1"},
    {"update/zero_width", edit_zero, "texels.width: 0"},
    {"update/null_texels", edit_null, "texels.pixels: NULL"},
    {"update/other_format", edit_format, "texels.format: 1 is not the texture's 2"},
    {"update/three_channels_for_four", edit_three, "texels.format: 8 is not the texture's 2"},
    {"update/unknown_format", edit_unknown, "texels.format: 77 is not a format"},
    {"update/stride_below_row", edit_stride, "texels.row_stride: 11 is below 12"},
    {"update/struct_size_zero", edit_size, "texels.struct_size: 0"},
};

/* A refused update changes no level; every other update gives the texture of the changed base. */
static void test_update(void **state)
{
    const struct update_case *c = (const struct update_case *)*state;
    static unsigned char got[TEXELS * 8], want[TEXELS * 8];
    struct update u = {0, 1, 2, shd_image_default()};
    shd_texture_desc desc = base_desc();
    shd_context *context = NULL;
    shd_texture *texture = NULL, *other = NULL;
    uint32_t i, y;
    size_t size;
    for (i = 0; i < sizeof g_base; ++i) g_base[i] = (unsigned char)(i * 29);
    for (i = 0; i < TEXELS; ++i) g_patch[i] = 0x01234567u * (i + 3);
    u.image = patch_image(3, 2);
    c->edit(&u);
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    shd_assert_result(c->name, shd_texture_update(texture, u.layer, u.x, u.y, &u.image),
                      c->message ? SHD_ERROR_INVALID_ARGUMENT : SHD_OK, c->message ? c->message : "");
    for (y = 0; !c->message && y < u.image.height; ++y) {
        const size_t at = ((size_t)u.layer * HEIGHT + u.y + y) * WIDTH + u.x;
        memcpy(g_base + 4 * at, g_patch + y * u.image.width, u.image.width * 4);
    }
    shd_assert_ok(shd_texture_create(context, &desc, &other));
    size = read_all(texture, got);
    assert_int_equal(read_all(other, want), size);
    assert_memory_equal(got, want, size);
    shd_texture_release(texture);
    shd_texture_release(other);
    shd_context_release(context);
}

static void test_handles(void **state)
{
    shd_image image = patch_image(1, 1);
    shd_texture_desc desc = base_desc();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_result("null", shd_texture_update(NULL, 0, 0, 0, &image), SHD_ERROR_INVALID_ARGUMENT, "texture: NULL");
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    shd_assert_result("texels", shd_texture_update(texture, 0, 0, 0, NULL), SHD_ERROR_INVALID_ARGUMENT, "texels: NULL");
    shd_texture_release(texture);
    shd_assert_result("released", shd_texture_update(texture, 0, 0, 0, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "texture: not a live handle");
    shd_context_release(context);
}

/* The n-th allocation of an update fails: nothing changes, and the next update works. */
static void test_faults(void **state)
{
    enum { EDGE = 64 };
    static unsigned char texels[EDGE * EDGE * 4], changed[EDGE * EDGE * 4];
    static unsigned char before[EDGE * EDGE * 8], after[EDGE * EDGE * 8], want[EDGE * EDGE * 8];
    size_t n, size, points = 0;
    (void)state;
    for (n = 0; n < sizeof texels; ++n) texels[n] = (unsigned char)(n * 31);
    memcpy(changed, texels, sizeof texels);
    for (n = 0; n < 3; ++n) memcpy(changed + 4 * ((20 + n) * EDGE + 40), g_patch + 5 * n, 5 * 4);
    for (n = 1; n < 100; ++n) {
        shd_fault_allocator memory;
        shd_context_desc cd = shd_context_desc_default();
        shd_texture_desc desc = base_desc();
        shd_image image = patch_image(5, 3);
        shd_context *context = NULL;
        shd_texture *texture = NULL, *other = NULL;
        shd_result result;
        memset(&memory, 0, sizeof memory);
        cd.worker_count = 1;
        cd.allocator.allocate = shd_fault_allocate;
        cd.allocator.free = shd_fault_free;
        cd.allocator.user_data = &memory;
        shd_assert_ok(shd_context_create(&cd, &context));
        desc.width = desc.height = EDGE;
        desc.layer_count = 1;
        desc.texels = texels;
        shd_assert_ok(shd_texture_create(context, &desc, &texture));
        size = read_all(texture, before);
        shd_fault_arm(&memory, n, 1);
        result = shd_texture_update(texture, 0, 40, 20, &image);
        shd_fault_arm(&memory, 0, 0);
        if (result != SHD_OK) {
            ++points;
            shd_assert_result("fault", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
            read_all(texture, after);
            assert_memory_equal(after, before, size);
            shd_assert_ok(shd_texture_update(texture, 0, 40, 20, &image));
        }
        desc.texels = changed;
        shd_assert_ok(shd_texture_create(context, &desc, &other));
        assert_int_equal(read_all(other, want), size);
        assert_memory_not_equal(want, before, size);
        assert_int_equal(read_all(texture, after), size);
        assert_memory_equal(after, want, size);
        shd_texture_release(other);
        shd_texture_release(texture);
        shd_context_release(context);
        shd_assert_all_freed("update", &memory);
        if (result == SHD_OK) break;
    }
    assert_int_equal(points, 3); /* sums of the mip levels and their flags, rows of the ripmap */
}

/* An executor that fails in call number `fail_at`. */
struct lazy {
    uint32_t calls, fail_at;
};
static shd_result lazy_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    struct lazy *self = (struct lazy *)user_data;
    uint32_t i;
    if (++self->calls == self->fail_at) return SHD_ERROR_INTERNAL;
    for (i = 0; i < count; ++i) task(i, 0, task_data);
    return SHD_OK;
}

/* After an executor failed during an update, repeating the update repairs the texture. */
static void test_executor(void **state)
{
    static unsigned char got[TEXELS * 8], want[TEXELS * 8];
    uint32_t fail_at, failed = 0;
    (void)state;
    for (fail_at = 1; fail_at < 40; ++fail_at) {
        struct lazy lazy = {0, 0};
        shd_context_desc cd = shd_context_desc_default();
        shd_texture_desc desc = base_desc();
        shd_image image = patch_image(3, 2);
        shd_context *context = NULL;
        shd_texture *texture = NULL, *other = NULL;
        shd_result result;
        cd.executor.parallel_for = lazy_parallel_for;
        cd.executor.worker_count = 1;
        cd.executor.user_data = &lazy;
        shd_assert_ok(shd_context_create(&cd, &context));
        shd_assert_ok(shd_texture_create(context, &desc, &texture));
        shd_assert_ok(shd_texture_create(context, &desc, &other));
        shd_assert_ok(shd_texture_update(other, 1, 4, 1, &image));
        lazy.calls = 0;
        lazy.fail_at = fail_at;
        result = shd_texture_update(texture, 1, 4, 1, &image);
        lazy.fail_at = 0;
        if (result != SHD_OK) {
            ++failed;
            assert_int_equal(result, SHD_ERROR_CALLBACK);
            shd_assert_ok(shd_texture_update(texture, 1, 4, 1, &image));
        }
        assert_int_equal(read_all(texture, got), read_all(other, want));
        assert_memory_equal(got, want, sizeof got);
        shd_texture_release(texture);
        shd_texture_release(other);
        shd_context_release(context);
        if (result == SHD_OK) break;
    }
    assert_true(failed > 0 && failed < 39);
}

int main(void)
{
    struct CMUnitTest tests[32];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_updates / sizeof k_updates[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_updates[i].name, test_update, NULL, NULL, (void *)&k_updates[i]};
    }
    tests[n++] = (struct CMUnitTest){"handles", test_handles, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"faults", test_faults, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"executor", test_executor, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.texture_update", tests, n, NULL, NULL);
}
