/* SPDX-License-Identifier: MIT */
/* A process that links libshd_io, and one that loads in the default setting, does not load OpenImageIO: it has no other
 * thread, and exit() of a forked child returns. The first load in the process opens the module with OpenImageIO. */
#define _GNU_SOURCE
#include "support/io_files.h"
#include "support/io_samples.h"
#include "support/io_worker.h"

#include <dlfcn.h>
#include <sys/wait.h>

#include <shd/shd.h>

static shd_context *g_context;

#ifdef SHD_IO_WORKER
static const char *const k_worker = SHD_IO_WORKER;
#else
static const char *const k_worker = NULL;
#endif

/* Number of threads of this process, or -1 without /proc. */
static int count_threads(void)
{
    DIR *folder = opendir("/proc/self/task");
    struct dirent *entry;
    int count = 0;
    if (!folder) return -1;
    while ((entry = readdir(folder)) != NULL) count += entry->d_name[0] != '.';
    closedir(folder);
    return count;
}

static int is_loaded(const char *library)
{
    char line[1024];
    int found = 0;
    FILE *file = fopen("/proc/self/maps", "r");
    if (!file) return -1;
    while (fgets(line, sizeof line, file)) found = found || strstr(line, library) != NULL;
    fclose(file);
    return found;
}

static void check_untouched(void)
{
    int status = 0;
    pid_t child;
    if (count_threads() < 0) skip();
    assert_int_equal(count_threads(), 1);
    assert_int_equal(is_loaded("libOpenImageIO"), 0);
    child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        alarm(60);
        exit(0); /* runs the destructors of every loaded library */
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

static void test_link(void **state)
{
    (void)state;
    check_untouched();
}

/* A file that is refused by its header, and files that the worker decodes, whole or not. */
static void test_default(void **state)
{
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    shd_texture *texture = NULL;
    int i;
    (void)state;
    shd_assert_result("refused", shd_bitmap_load_memory(g_context, "GIF89a", 6, NULL, &bitmap), SHD_ERROR_UNSUPPORTED,
                      "GIF");
    desc.worker_path = k_worker;
    for (i = 0; i < 10; ++i) {
        shd_assert_ok(shd_bitmap_load_memory(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap));
        shd_bitmap_release(bitmap);
        shd_assert_ok(shd_texture_load_memory(g_context, k_sample_webp, sizeof k_sample_webp, &desc, &texture));
        shd_texture_release(texture);
        assert_int_not_equal(shd_bitmap_load_memory(g_context, k_sample_jpeg, 400, &desc, &bitmap), SHD_OK);
    }
    check_untouched();
}

typedef shd_result load_function(shd_context *, const void *, size_t, const shd_load_desc *, shd_bitmap **);

/* A copy of the library in a folder without the module, where it loads by a worker alone. Unloading ends the worker,
 * and leaves nothing behind that a later fork() would call. */
static void test_module_missing(void **state)
{
    const io_bytes library = io_read(SHD_IO_LIBRARY);
    const char *path = io_path("libshd_io_alone.so");
    shd_bitmap *bitmap = NULL;
    shd_load_desc desc = shd_load_desc_default();
    load_function *load = NULL;
    const char *worker;
    void *handle, *symbol;
    (void)state;
    assert_non_null(library.data);
    io_write(path, library.data, library.size);
    free(library.data);
    handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!handle) fail_msg("%s", dlerror());
    symbol = dlsym(handle, "shd_bitmap_load_memory");
    assert_non_null(symbol);
    memcpy(&load, &symbol, sizeof load);
    desc.flags = SHD_LOAD_IN_PROCESS;
    shd_assert_result("missing", load(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap),
                      SHD_ERROR_NOT_FOUND, "cannot open libshd_io_oiio.so");
    assert_null(bitmap);
    desc.flags = SHD_LOAD_DEFAULT;
    worker = io_copy_worker(k_worker, "worker");
    desc.worker_path = worker;
    shd_assert_ok(load(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap));
    shd_bitmap_release(bitmap);
    io_await_worker(worker, 1);
    dlclose(handle);
    io_await_worker(worker, -1);
    check_untouched();
}

static void test_in_process(void **state)
{
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    (void)state;
    desc.flags = SHD_LOAD_IN_PROCESS;
    shd_assert_ok(shd_bitmap_load_memory(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap));
    shd_bitmap_release(bitmap);
    assert_int_not_equal(is_loaded("libOpenImageIO"), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        {"link", test_link, NULL, NULL, NULL},
        {"default", test_default, NULL, NULL, NULL},
        {"module_missing", test_module_missing, NULL, NULL, NULL},
        {"in_process", test_in_process, NULL, NULL, NULL},
    };
    shd_context_desc one_worker = shd_context_desc_default();
    void *state = NULL;
    int failed;
    one_worker.worker_count = 1;
    if (io_make_folder(&state) != 0 || shd_context_create(&one_worker, &g_context) != SHD_OK) return 1;
    failed = _cmocka_run_group_tests("api.io_link", tests, sizeof tests / sizeof tests[0], NULL, NULL);
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
