/* SPDX-License-Identifier: MIT */
/* Loading does not change descriptors, children, signals, locale, errno or memory; eight threads load concurrently. */
#define _GNU_SOURCE
#include "support/io_corpus.h"

#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>

static shd_context *g_context;

#ifdef SHD_IO_WORKER
static const char *const k_worker = SHD_IO_WORKER;
#else
static const char *const k_worker = NULL;
#endif

static int count_descriptors(void)
{
    int fd, count = 0;
    for (fd = 0; fd < 256; ++fd) count += fcntl(fd, F_GETFD) >= 0;
    return count;
}

static void load_everything(uint32_t flags)
{
    shd_load_desc desc = shd_load_desc_default();
    int i;
    desc.flags = flags;
    desc.worker_path = k_worker;
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
        shd_bitmap *bitmap = NULL;
        const io_bytes *bytes = &g_corpus[i].bytes;
        shd_assert_ok(shd_bitmap_load_memory(g_context, bytes->data, bytes->size, &desc, &bitmap));
        shd_bitmap_release(bitmap);
        bitmap = NULL;
        if (shd_bitmap_load_memory(g_context, bytes->data, bytes->size / 2, &desc, &bitmap) != SHD_OK) {
            assert_null(bitmap);
        }
        shd_bitmap_release(bitmap);
    }
}

/* Replaces the worker by one that cannot start, so that there is none. */
static void stop_worker(void)
{
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    desc.worker_path = "/bin/true";
    shd_assert_result("stop",
                      shd_bitmap_load_memory(g_context, g_corpus[0].bytes.data, g_corpus[0].bytes.size, &desc, &bitmap),
                      SHD_ERROR_INTERNAL, "did not start");
}

static void test_hygiene(void **state)
{
    sigset_t before, after;
    char folder[1024], folder_after[1024];
    const char *locale = setlocale(LC_ALL, NULL);
    char saved_locale[256];
    int descriptors, i;
    (void)state;
    load_everything(SHD_LOAD_NONE);       /* opens the descriptors of the worker before they are counted */
    load_everything(SHD_LOAD_IN_PROCESS); /* and those that OpenImageIO keeps open */
    snprintf(saved_locale, sizeof saved_locale, "%s", locale);
    assert_non_null(getcwd(folder, sizeof folder));
    sigprocmask(SIG_SETMASK, NULL, &before);
    descriptors = count_descriptors();
    errno = 4711;
    load_everything(SHD_LOAD_IN_PROCESS);
    load_everything(SHD_LOAD_NONE);
    assert_int_equal(errno, 4711);
    assert_int_equal(count_descriptors(), descriptors);
    sigprocmask(SIG_SETMASK, NULL, &after);
    for (i = 1; i < 32; ++i) assert_int_equal(sigismember(&after, i), sigismember(&before, i));
    assert_string_equal(setlocale(LC_ALL, NULL), saved_locale);
    assert_non_null(getcwd(folder_after, sizeof folder_after));
    assert_string_equal(folder, folder_after);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1); /* no child is left, running or zombie */
    assert_int_equal(errno, ECHILD);
}

static void test_sigchld_ignored(void **state)
{
    void (*old)(int) = signal(SIGCHLD, SIG_IGN);
    (void)state;
    stop_worker();
    load_everything(SHD_LOAD_NONE); /* starts a worker */
    signal(SIGCHLD, old);
}

/* With standard input, output and error closed, the worker's sockets get the descriptors 0 to 2 and must still work. */
static void test_no_standard_streams(void **state)
{
    int saved[3], fd;
    (void)state;
    stop_worker();
    for (fd = 0; fd < 3; ++fd) {
        saved[fd] = fcntl(fd, F_DUPFD_CLOEXEC, 100);
        close(fd);
    }
    {
        const io_bytes *png = &g_corpus[0].bytes;
        shd_load_desc desc = shd_load_desc_default();
        shd_bitmap *bitmap = NULL;
        shd_result result;
        desc.worker_path = k_worker;
        result = shd_bitmap_load_memory(g_context, png->data, png->size, &desc, &bitmap);
        for (fd = 0; fd < 3; ++fd) {
            dup2(saved[fd], fd);
            close(saved[fd]);
        }
        shd_assert_ok(result);
        shd_bitmap_release(bitmap);
    }
}

/* The worker's memory is limited by max_bytes; the smallest max_bytes that a file needs leaves enough. */
static void test_exact_budgets(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
        const io_bytes *bytes = &g_corpus[i].bytes;
        shd_load_desc desc = shd_load_desc_default();
        shd_image image = shd_image_default();
        shd_bitmap *bitmap = NULL;
        shd_assert_ok(shd_bitmap_load_memory(g_context, bytes->data, bytes->size, &desc, &bitmap));
        shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
        desc.worker_path = k_worker;
        desc.max_file_bytes = bytes->size;
        desc.max_pixels = (uint64_t)image.width * image.height;
        desc.max_bytes = image.row_stride * image.height;
        shd_bitmap_release(bitmap);
        bitmap = NULL;
        shd_assert_ok(shd_bitmap_load_memory(g_context, bytes->data, bytes->size, &desc, &bitmap));
        shd_bitmap_release(bitmap);
    }
}

/* Loads the first sample with a shell script as the worker. */
static void load_by_script(const char *script, double time_limit, shd_result expected, const char *message)
{
    const io_bytes *png = &g_corpus[0].bytes;
    const char *path = io_path("worker.sh");
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    io_write(path, script, strlen(script));
    assert_int_equal(chmod(path, 0700), 0);
    desc.worker_path = path;
    desc.time_limit = time_limit;
    shd_assert_result(script, shd_bitmap_load_memory(g_context, png->data, png->size, &desc, &bitmap), expected,
                      message);
    assert_true((bitmap != NULL) == (expected == SHD_OK));
    shd_bitmap_release(bitmap);
    stop_worker();
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1); /* the script is killed and reaped */
}

/* Workers that never become ready and run for longer than this test may; they do not answer, or close their socket. A
 * script around the real worker may go on after it. */
static void test_worker_stays(void **state)
{
    char script[1024];
    (void)state;
    load_by_script("#!/bin/sh\nexec sleep 3600\n", 0.3, SHD_ERROR_LIMIT, "load.time_limit 0.3 s");
    load_by_script("#!/bin/sh\nexec 0<&-\nexec sleep 3600\n", 3600, SHD_ERROR_INTERNAL, "did not start (killed");
    load_by_script("#!/bin/sh\nexec 0<&-\nexit 7\n", 60, SHD_ERROR_INTERNAL, "did not start (exit status 7)");
    load_by_script("#!/bin/sh\nkill -9 $$\n", 60, SHD_ERROR_INTERNAL, "did not start (signal 9)");
    if (!k_worker) return;
    snprintf(script, sizeof script, "#!/bin/sh\n'%s'\nexec sleep 3600\n", k_worker);
    load_by_script(script, 3600, SHD_OK, "");
}

struct fault {
    long countdown; /* number of allocations before one fails; negative = never */
    size_t live;
};

static void *fault_allocate(size_t size, size_t alignment, void *user_data)
{
    struct fault *fault = (struct fault *)user_data;
    void *memory = NULL;
    if (fault->countdown >= 0 && fault->countdown-- == 0) return NULL;
    if (posix_memalign(&memory, alignment, size) != 0) return NULL;
    fault->live += size;
    return memory;
}

static void fault_free(void *memory, size_t size, size_t alignment, void *user_data)
{
    struct fault *fault = (struct fault *)user_data;
    (void)alignment;
    fault->live -= size;
    free(memory);
}

static void check_allocation_faults(shd_load_flags flags, long fewest)
{
    const io_bytes *png = &g_corpus[0].bytes;
    shd_load_desc load = shd_load_desc_default();
    struct fault fault = {-1, 0};
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    long n;
    load.flags = flags;
    load.worker_path = k_worker;
    desc.worker_count = 1;
    desc.allocator.allocate = fault_allocate;
    desc.allocator.free = fault_free;
    desc.allocator.user_data = &fault;
    shd_assert_ok(shd_context_create(&desc, &context));
    for (n = 0; n < 100; ++n) {
        shd_bitmap *bitmap = NULL;
        shd_result result;
        fault.countdown = n;
        result = shd_bitmap_load_memory(context, png->data, png->size, &load, &bitmap);
        fault.countdown = -1;
        shd_bitmap_release(bitmap);
        if (result == SHD_OK) break;
        shd_assert_result("fault", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        assert_null(bitmap);
    }
    assert_true(n >= fewest && n < 100);
    shd_context_release(context);
    assert_int_equal(fault.live, 0);
}

static void test_allocation_faults(void **state)
{
    (void)state;
    check_allocation_faults(SHD_LOAD_IN_PROCESS, 4);
    check_allocation_faults(SHD_LOAD_NONE, 2);
}

static uint64_t g_want[IO_SAMPLE_COUNT];

static void *load_many(void *data)
{
    shd_load_desc desc = shd_load_desc_default();
    size_t failures = 0;
    int round, i;
    desc.flags = SHD_LOAD_IN_PROCESS; /* api.io_worker has the threads of the default setting */
    for (round = 0; round < 20; ++round) {
        for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
            const int k = (i + (int)(size_t)data) % IO_SAMPLE_COUNT;
            shd_bitmap *bitmap = NULL;
            if (shd_bitmap_load_memory(g_context, g_corpus[k].bytes.data, g_corpus[k].bytes.size, &desc, &bitmap) !=
                    SHD_OK ||
                io_hash_bitmap(bitmap) != g_want[k]) {
                ++failures;
            }
            shd_bitmap_release(bitmap);
        }
    }
    return (void *)failures;
}

static void test_threads(void **state)
{
    pthread_t threads[8];
    size_t i;
    (void)state;
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
        shd_bitmap *bitmap = NULL;
        shd_assert_ok(shd_bitmap_load_memory(g_context, g_corpus[i].bytes.data, g_corpus[i].bytes.size, NULL, &bitmap));
        g_want[i] = io_hash_bitmap(bitmap);
        shd_bitmap_release(bitmap);
    }
    for (i = 0; i < 8; ++i) assert_int_equal(pthread_create(&threads[i], NULL, load_many, (void *)i), 0);
    for (i = 0; i < 8; ++i) {
        void *failures = NULL;
        pthread_join(threads[i], &failures);
        assert_null(failures);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        {"hygiene", test_hygiene, NULL, NULL, NULL},
        {"sigchld_ignored", test_sigchld_ignored, NULL, NULL, NULL},
        {"no_standard_streams", test_no_standard_streams, NULL, NULL, NULL},
        {"exact_budgets", test_exact_budgets, NULL, NULL, NULL},
        {"worker_stays", test_worker_stays, NULL, NULL, NULL},
        {"allocation_faults", test_allocation_faults, NULL, NULL, NULL},
        {"threads", test_threads, NULL, NULL, NULL},
    };
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    io_make_corpus();
    failed = _cmocka_run_group_tests("api.io_host", tests, sizeof tests / sizeof tests[0], NULL, NULL);
    io_free_corpus();
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
