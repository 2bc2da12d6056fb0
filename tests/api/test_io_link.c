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
    desc.flags = SHD_LOAD_NONE;
    worker = io_copy_worker(k_worker, "worker");
    desc.worker_path = worker;
    shd_assert_ok(load(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap));
    shd_bitmap_release(bitmap);
    io_await_worker(worker, 1);
    dlclose(handle);
    io_await_worker(worker, -1);
    check_untouched();
}

/* Links to a file beside libshd_io, or to its worker, under the name `name` in the folder of the test. */
static void link_beside(const char *name)
{
    char target[1024];
    const char *slash = strrchr(SHD_IO_LIBRARY, '/');
    snprintf(target, sizeof target, "%.*s/%s", (int)(slash - SHD_IO_LIBRARY), SHD_IO_LIBRARY, strrchr(name, '/') + 1);
    assert_int_equal(symlink(strstr(name, "worker") ? k_worker : target, io_path(name)), 0);
}

static void make_folder(const char *name) { assert_int_equal(mkdir(io_path(name), 0700), 0); }

static shd_result load_sample(load_function *load, shd_load_flags flags)
{
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    shd_result result;
    desc.flags = flags;
    result = load(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap);
    shd_bitmap_release(bitmap);
    return result;
}

/* Runs in a child: opens the library by a relative path, goes to the folder of a stranger, and loads. Returns 0, or the
 * number of what failed. */
static int load_in_folder_of_stranger(void)
{
    load_function *load = NULL;
    void *handle, *symbol;
    if (chdir(io_path("ours")) != 0) return 1;
    handle = dlopen("lib/libshd_io_link.so", RTLD_NOW | RTLD_LOCAL);
    if (!handle || chdir(io_path("stranger")) != 0) return 2;
    setenv("LD_LIBRARY_PATH", "lib:", 1); /* for the worker: the dynamic linker of this process has read it before */
    symbol = dlsym(handle, "shd_bitmap_load_memory");
    memcpy(&load, &symbol, sizeof load);
    if (load_sample(load, SHD_LOAD_NONE) != SHD_OK) return 3;
    if (load_sample(load, SHD_LOAD_IN_PROCESS) != SHD_OK) return 4;
    setenv("SHD_IO_WORKER", "lib/shd-io-worker", 1);
    if (load_sample(load, SHD_LOAD_NONE) != SHD_ERROR_INVALID_ARGUMENT) return 5;
    if (!strstr(shd_last_error(), "SHD_IO_WORKER: \"lib/shd-io-worker\" is not an absolute path")) return 6;
    setenv("SHD_IO_WORKER", io_path("ours/lib/shd-io-worker"), 1);
    if (load_sample(load, SHD_LOAD_NONE) != SHD_OK) return 7;
    return access(io_path("stranger_ran"), F_OK) == 0 ? 8 : 0;
}

/* The library was found by a relative path, and the process is in another folder when the first load needs the worker
 * and the module. Programs and libraries of the same names in that folder are not used. */
static void test_relative_path(void **state)
{
    static const char *const libraries[] = {"stranger/lib/shd/libshd_io_oiio.so", "stranger/lib/libshd_io_oiio.so",
                                            "stranger/lib/libstdc++.so.6", "stranger/libstdc++.so.6"};
    const io_bytes library = io_read(SHD_IO_LIBRARY);
    char script[700];
    int status = 0;
    pid_t child;
    size_t i;
    (void)state;
    make_folder("ours");
    make_folder("ours/lib");
    make_folder("stranger");
    make_folder("stranger/lib");
    make_folder("stranger/lib/shd");
    io_write(io_path("ours/lib/libshd_io_link.so"), library.data, library.size);
    free(library.data);
    link_beside("ours/lib/shd-io-worker");
    link_beside("ours/lib/libshd_io_oiio.so");
    snprintf(script, sizeof script, "#!/bin/sh\ntouch '%s'\n", io_path("stranger_ran"));
    io_write(io_path("stranger/lib/shd-io-worker"), script, strlen(script));
    assert_int_equal(chmod(io_path("stranger/lib/shd-io-worker"), 0700), 0);
    for (i = 0; i < sizeof libraries / sizeof libraries[0]; ++i) io_write(io_path(libraries[i]), "no library", 10);
    child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        alarm(60);
        unsetenv("SHD_IO_WORKER");
        _exit(load_in_folder_of_stranger());
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    assert_int_equal(access(io_path("stranger_ran"), F_OK), -1);
    for (i = 0; i < sizeof libraries / sizeof libraries[0]; ++i) unlink(io_path(libraries[i]));
    unlink(io_path("stranger/lib/shd-io-worker"));
    rmdir(io_path("stranger/lib/shd"));
    rmdir(io_path("stranger/lib"));
    unlink(io_path("ours/lib/libshd_io_link.so"));
    unlink(io_path("ours/lib/shd-io-worker"));
    unlink(io_path("ours/lib/libshd_io_oiio.so"));
    rmdir(io_path("ours/lib"));
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
        {"relative_path", test_relative_path, NULL, NULL, NULL},
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
