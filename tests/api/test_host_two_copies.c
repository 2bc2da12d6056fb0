/* SPDX-License-Identifier: MIT */
/* Two copies of libshd in one process, as when two plug-ins bring their own: both work, with the same bits, in any
 * order, also concurrently. Each has its own functions, error texts and handles. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>

#include "support/io_files.h"
#include "support/rows.h"
#include "support/scene.h"

/* The functions of the second copy. */
static struct {
    void *module;
    shd_result (*context_create)(const shd_context_desc *, shd_context **);
    void (*context_release)(shd_context *);
    shd_result (*texture_create)(shd_context *, const shd_texture_desc *, shd_texture **);
    void (*texture_release)(shd_texture *);
    shd_result (*sampler_create)(shd_context *, const shd_sampler_desc *, shd_sampler **);
    void (*sampler_release)(shd_sampler *);
    shd_result (*texture_sample)(const shd_texture *, const shd_sampler *, const shd_lookups *, shd_texels *);
    const char *(*last_error)(void);
} g_copy;

/* Function pointers are copied with memcpy, because ISO C has no cast from void pointers to them. */
static void find(const char *name, void *function)
{
    void *symbol = dlsym(g_copy.module, name);
    if (!symbol) fail_msg("%s: %s", name, dlerror());
    memcpy(function, &symbol, sizeof symbol);
}

/* A second copy is a file of its own: the loader would return the first copy for the same file. The file must not be
 * written again, because a library may stay mapped after dlclose. */
static void open_copy(const char *name, int flags)
{
    const io_bytes bytes = io_read(SHD_LIBRARY_PATH);
    const char *path = io_path(name);
    assert_non_null(bytes.data);
    io_write(path, bytes.data, bytes.size);
    free(bytes.data);
    g_copy.module = dlopen(path, RTLD_NOW | flags);
    if (!g_copy.module) fail_msg("%s", dlerror());
    find("shd_context_create", &g_copy.context_create);
    find("shd_context_release", &g_copy.context_release);
    find("shd_texture_create", &g_copy.texture_create);
    find("shd_texture_release", &g_copy.texture_release);
    find("shd_sampler_create", &g_copy.sampler_create);
    find("shd_sampler_release", &g_copy.sampler_release);
    find("shd_texture_sample", &g_copy.texture_sample);
    find("shd_last_error", &g_copy.last_error);
}

enum { COUNT = 40000 };

/* Samples with one of the copies, on two workers; returns the hash of the results, or 0. */
static uint64_t sample(int second)
{
    static const unsigned char k_texels[4 * 5 * 3] = {9, 90, 200, 255, 17, 0, 3, 255, 250, 130, 7, 8};
    float *columns = (float *)shd_scene_memory(5 * COUNT * sizeof(float));
    shd_context_desc context_desc = shd_context_desc_default();
    shd_texture_desc desc = shd_texture_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    uint64_t hash = 0;
    size_t i, c;
    shd_result result;
    for (i = 0; i < COUNT; ++i) columns[i] = 0.0001f * (float)i;
    context_desc.worker_count = 2;
    desc.format = SHD_FORMAT_RGBA8_SRGB;
    desc.width = 5;
    desc.height = 3;
    desc.texels = k_texels;
    desc.tables = SHD_TABLE_MIPMAP;
    lookups.count = COUNT;
    lookups.u.data = lookups.v.data = lookups.dudx.data = columns;
    for (c = 0; c < 4; ++c) texels.channel[c].data = columns + (1 + c) * COUNT;
    result = second ? g_copy.context_create(&context_desc, &context) : shd_context_create(&context_desc, &context);
    if (result == SHD_OK) {
        result =
            second ? g_copy.texture_create(context, &desc, &texture) : shd_texture_create(context, &desc, &texture);
    }
    if (result == SHD_OK) {
        result = second ? g_copy.sampler_create(context, NULL, &sampler) : shd_sampler_create(context, NULL, &sampler);
    }
    if (result == SHD_OK) {
        result = second ? g_copy.texture_sample(texture, sampler, &lookups, &texels)
                        : shd_texture_sample(texture, sampler, &lookups, &texels);
    }
    if (result == SHD_OK) hash = shd_hash(SHD_HASH_START, columns + COUNT, 4 * COUNT * sizeof(float));
    (second ? g_copy.sampler_release : shd_sampler_release)(sampler);
    (second ? g_copy.texture_release : shd_texture_release)(texture);
    (second ? g_copy.context_release : shd_context_release)(context);
    free(columns);
    return hash;
}

static void *sample_often(void *data)
{
    const int second = *(const int *)data;
    const uint64_t want = sample(second);
    size_t mistakes = want == 0;
    int round;
    for (round = 0; round < 10; ++round) mistakes += sample(second) != want;
    return mistakes ? data : NULL;
}

struct copy_case {
    const char *name;
    int flags;
};
static const struct copy_case k_copies[] = {
    {"local", RTLD_LOCAL},
    {"global", RTLD_GLOBAL},
    {"deep_bind", RTLD_LOCAL | RTLD_DEEPBIND},
};

static void test_copy(void **state)
{
    const struct copy_case *c = (const struct copy_case *)*state;
    shd_result (*own)(const shd_context_desc *, shd_context **) = shd_context_create;
    shd_texture_desc bad = shd_texture_desc_default();
    shd_context *first = NULL, *second = NULL;
    shd_texture *texture = NULL;
    static int k_which[4] = {0, 1, 0, 1};
    pthread_t threads[4];
    uint64_t want;
    int i;
    open_copy(c->name, c->flags);
    assert_true(memcmp(&own, &g_copy.context_create, sizeof own) != 0);
    want = sample(0);
    assert_true(want != 0);
    assert_true(sample(1) == want);
    for (i = 0; i < 4; ++i) assert_int_equal(pthread_create(&threads[i], NULL, sample_often, &k_which[i]), 0);
    for (i = 0; i < 4; ++i) {
        void *mistake = NULL;
        pthread_join(threads[i], &mistake);
        assert_null(mistake);
    }
    /* Each copy keeps its own error text. */
    shd_assert_ok(shd_context_create(NULL, &first));
    assert_int_equal(g_copy.context_create(NULL, &second), SHD_OK);
    assert_int_equal(shd_texture_create(first, &bad, &texture), SHD_ERROR_INVALID_ARGUMENT);
    assert_int_equal(g_copy.context_create(NULL, NULL), SHD_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(shd_last_error(), "texture."));
    assert_string_equal(g_copy.last_error(), "out_context: NULL");
    shd_context_release(first);
    g_copy.context_release(second);
    assert_int_equal(dlclose(g_copy.module), 0);
    assert_true(sample(0) == want);
}

int main(void)
{
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0) return 1;
    ADD_ROWS(k_copies, test_copy);
    failed = _cmocka_run_group_tests("api.host_two_copies", g_tests, g_count, NULL, NULL);
    return io_remove_folder(&state) == 0 ? failed : 1;
}
