/* SPDX-License-Identifier: MIT */
/* A plug-in that is loaded and unloaded: libshd is loaded, used and unloaded 1000 times, 200 of them with threads. This
 * program does not link libshd (the build uses --as-needed), so the last dlclose can unload it with its dependencies.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <unistd.h>

#include "support/check.h"

#include <shd/context.h>
#include <shd/extension.h>

enum { k_loads = 1000, k_warm_up = 20 };

struct library {
    shd_result (*create)(const shd_context_desc *, shd_context **);
    void (*release)(shd_context *);
    shd_result (*parallel_for)(shd_context *, uint32_t, shd_task_fn, void *);
    const char *(*last_error)(void);
};

/* Function pointers are copied with memcpy, because ISO C has no cast from void pointers to them. */
static void find(void *handle, const char *name, void *function)
{
    void *symbol = dlsym(handle, name);
    if (!symbol) fail_msg("%s: %s", name, dlerror());
    memcpy(function, &symbol, sizeof symbol);
}

static void count_task(size_t index, size_t worker, void *data)
{
    (void)worker;
    ((unsigned char *)data)[index] = 1;
}

static void use_library(void *handle, uint32_t workers)
{
    unsigned char done[200];
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    struct library shd;
    size_t i;
    find(handle, "shd_context_create", &shd.create);
    find(handle, "shd_context_release", &shd.release);
    find(handle, "shd_context_parallel_for", &shd.parallel_for);
    find(handle, "shd_last_error", &shd.last_error);
    desc.worker_count = workers;
    memset(done, 0, sizeof done);
    assert_int_equal(shd.create(&desc, &context), SHD_OK);
    assert_int_equal(shd.parallel_for(context, sizeof done, count_task, done), SHD_OK);
    for (i = 0; i < sizeof done; ++i) assert_int_equal(done[i], 1);
    assert_int_not_equal(shd.create(&desc, NULL), SHD_OK);
    assert_string_equal(shd.last_error(), "out_context: NULL");
    shd.release(context);
}

/* Number of resident pages, and of lines of the memory map that name libshd. */
static size_t resident_pages(void)
{
    FILE *file = fopen("/proc/self/statm", "r");
    unsigned long total = 0, resident = 0;
    if (!file) return 0;
    if (fscanf(file, "%lu %lu", &total, &resident) != 2) resident = 0;
    fclose(file);
    return resident;
}
static size_t mapped_parts(void)
{
    FILE *file = fopen("/proc/self/maps", "r");
    char line[1024];
    size_t count = 0;
    if (!file) return 0;
    while (fgets(line, sizeof line, file)) count += strstr(line, "libshd.so") != NULL;
    fclose(file);
    return count;
}

static void test_reload(void **state)
{
    size_t warm = 0, parts = 0, i;
    (void)state;
    assert_int_equal(mapped_parts(), 0);
    for (i = 0; i < k_loads; ++i) {
        void *handle = dlopen(SHD_LIBRARY_PATH, RTLD_NOW | RTLD_LOCAL);
        if (!handle) fail_msg("%s", dlerror());
        use_library(handle, i % 5 == 0 ? 2 : 1);
        assert_int_equal(dlclose(handle), 0);
        /* oneTBB's threads free the memory of a context when they run the next time. */
        if (i % 5 == 0) usleep(1000);
        if (i == 0) parts = mapped_parts();
        if (i == k_warm_up) warm = resident_pages();
        assert_int_equal(mapped_parts(), parts); /* at most one copy remains */
    }
    print_message("%d loads: libshd %s, resident %zu -> %zu pages\n", k_loads, parts ? "stays mapped" : "unmapped",
                  warm, resident_pages());
    assert_true(resident_pages() < warm + 1024);
}

int main(void)
{
    static const struct CMUnitTest k_tests[] = {{"reload", test_reload, NULL, NULL, NULL}};
    return _cmocka_run_group_tests("api.host_reload", k_tests, 1, NULL, NULL);
}
