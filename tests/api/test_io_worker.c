/* SPDX-License-Identifier: MIT */
/* The worker of default loads: it is reused, replaced when it fails, and ends with its host; the children that decode
 * are killed at the deadline, and their deaths harm neither the host nor other loads. */
#define _GNU_SOURCE
#include "support/io_corpus.h"
#include "support/io_worker.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>

static shd_context *g_context;
static const char *g_worker; /* a copy of the worker */
static uint64_t *g_hash;     /* hashes of the samples, decoded in process */

static shd_result load(int sample, double time_limit, uint64_t *hash)
{
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    shd_result result;
    desc.worker_path = g_worker;
    desc.time_limit = time_limit;
    result =
        shd_bitmap_load_memory(g_context, g_corpus[sample].bytes.data, g_corpus[sample].bytes.size, &desc, &bitmap);
    if (hash) *hash = bitmap ? io_hash_bitmap(bitmap) : 0;
    assert_true((bitmap != NULL) == (result == SHD_OK));
    shd_bitmap_release(bitmap);
    return result;
}

static void load_well(int sample)
{
    uint64_t hash = 0;
    shd_assert_ok(load(sample, 60, &hash));
    assert_true(hash == g_hash[sample]);
}

/* Waits until the worker has its spare child and no other, no zombie, and only the descriptors that it always has: the
 * socket of the host, /dev/null twice, signals and the socket of the spare child. The spare child has its end of that
 * socket and /dev/null twice; a child that still ends has others. */
static io_worker settle(void)
{
    const double end = io_seconds() + 10;
    io_worker worker = io_await_worker(g_worker, 1);
    while (io_count_descriptors(worker.server) != 5 || io_count_descriptors(worker.children[0]) != 3) {
        if (io_seconds() > end) {
            fail_msg("%d and %d descriptors", io_count_descriptors(worker.server),
                     io_count_descriptors(worker.children[0]));
        }
        io_sleep(0.01);
        worker = io_await_worker(g_worker, 1);
    }
    return worker;
}

static void end_worker(void)
{
    const io_worker worker = io_find_worker(g_worker);
    if (worker.server > 0) assert_int_equal(kill(worker.server, SIGKILL), 0);
    io_await_worker(g_worker, -1);
}

/* 200 loads, one of three fails: one worker, no zombie, no descriptor more on either side, no child of this process. */
static void test_reused(void **state)
{
    io_worker before, after;
    int ours, i;
    (void)state;
    load_well(0);
    before = settle();
    ours = io_count_descriptors(getpid());
    for (i = 0; i < 200; ++i) {
        load_well(i % IO_SAMPLE_COUNT);
        if (i % 3 == 0) {
            shd_load_desc desc = shd_load_desc_default();
            shd_bitmap *bitmap = NULL;
            desc.worker_path = g_worker;
            shd_assert_result("cut", shd_bitmap_load_memory(g_context, g_corpus[0].bytes.data, 60, &desc, &bitmap),
                              SHD_ERROR_CORRUPT, "PNG");
        }
    }
    after = settle();
    assert_int_equal(after.server, before.server);
    assert_int_equal(io_count_descriptors(getpid()), ours);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    assert_int_equal(errno, ECHILD);
}

struct background {
    int sample;
    double time_limit;
    shd_result result;
    uint64_t hash;
    char message[256];
};

static void *load_in_background(void *data)
{
    struct background *b = (struct background *)data;
    b->result = load(b->sample, b->time_limit, &b->hash);
    snprintf(b->message, sizeof b->message, "%s", b->result == SHD_OK ? "" : shd_last_error());
    return NULL;
}

/* The child that decodes dies: its load is refused, and the same worker decodes the next file. */
static void test_child_dies(void **state)
{
    static const int signals[] = {SIGSEGV, SIGABRT, SIGKILL};
    size_t i;
    (void)state;
    load_well(0);
    for (i = 0; i < sizeof signals / sizeof signals[0]; ++i) {
        struct background b = {3, 60, SHD_OK, 0, ""};
        const io_worker before = settle();
        pthread_t thread;
        char end[32];
        assert_int_equal(kill(before.children[0], SIGSTOP), 0);
        assert_int_equal(pthread_create(&thread, NULL, load_in_background, &b), 0);
        io_await_worker(g_worker, 2); /* the stopped child has the file, and there is a new spare */
        assert_int_equal(kill(before.children[0], signals[i]), 0);
        kill(before.children[0], SIGCONT);
        pthread_join(thread, NULL);
        snprintf(end, sizeof end, "(signal %d)", signals[i]);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        /* The sanitizer's handler ends the child. */
        if (signals[i] == SIGSEGV) snprintf(end, sizeof end, "(exit status ");
#endif
        assert_int_equal(b.result, SHD_ERROR_CORRUPT);
        assert_non_null(strstr(b.message, "the decoder died on the file"));
        assert_non_null(strstr(b.message, end));
        load_well(3);
        assert_int_equal(settle().server, before.server);
    }
}

/* The spare child dies before it gets a file: the next load succeeds. */
static void test_spare_dies(void **state)
{
    io_worker before;
    (void)state;
    load_well(0);
    before = settle();
    assert_int_equal(kill(before.children[0], SIGKILL), 0);
    io_await_worker(g_worker, 0);
    load_well(1);
    assert_int_equal(settle().server, before.server);
}

/* The child that decodes hangs: the load ends at its deadline, and the child is killed. */
static void test_child_hangs(void **state)
{
    io_worker before, after;
    double start;
    (void)state;
    load_well(0);
    before = settle();
    assert_int_equal(kill(before.children[0], SIGSTOP), 0);
    start = io_seconds();
    shd_assert_result("hangs", load(0, 0.3, NULL), SHD_ERROR_LIMIT, "load.time_limit 0.3 s");
    assert_true(io_seconds() - start < 2);
    load_well(0);
    after = settle();
    assert_int_equal(after.server, before.server);
    assert_int_not_equal(after.children[0], before.children[0]);
}

/* A worker that was killed is replaced by the next load. */
static void test_worker_killed(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 3; ++i) {
        io_worker before;
        load_well(0);
        before = settle();
        assert_int_equal(kill(before.server, SIGKILL), 0);
        load_well(0);
        assert_int_not_equal(settle().server, before.server);
    }
}

/* A worker that is killed during a load takes its children with it; the load fails, and the next one succeeds. */
static void test_worker_killed_in_flight(void **state)
{
    struct background b = {3, 60, SHD_OK, 0, ""};
    pthread_t thread;
    io_worker before;
    (void)state;
    load_well(0);
    before = settle();
    assert_int_equal(kill(before.children[0], SIGSTOP), 0);
    assert_int_equal(pthread_create(&thread, NULL, load_in_background, &b), 0);
    io_await_worker(g_worker, 2);
    assert_int_equal(kill(before.server, SIGKILL), 0);
    pthread_join(thread, NULL);
    assert_int_equal(b.result, SHD_ERROR_CORRUPT);
    load_well(3);
    settle();
    assert_int_equal(io_runs(before.children[0], g_worker), 0);
}

/* A worker that takes no requests fails the loads until it has been silent for two seconds; then it is replaced. */
static void test_worker_hangs(void **state)
{
    io_worker before;
    double start;
    (void)state;
    load_well(0);
    before = settle();
    assert_int_equal(kill(before.server, SIGSTOP), 0);
    start = io_seconds();
    shd_assert_result("short", load(0, 0.3, NULL), SHD_ERROR_LIMIT, "load.time_limit 0.3 s");
    assert_true(io_seconds() - start < 2);
    shd_assert_result("long", load(0, 2.2, NULL), SHD_ERROR_LIMIT, "load.time_limit 2.2 s");
    assert_true(io_seconds() - start < 5);
    load_well(0);
    assert_int_not_equal(settle().server, before.server);
}

static void *load_many(void *data)
{
    size_t failures = 0;
    int i;
    for (i = 0; i < 2 * IO_SAMPLE_COUNT; ++i) {
        const int k = (i + 2 * (int)(size_t)data) % IO_SAMPLE_COUNT;
        uint64_t hash = 0;
        if (load(k, 60, &hash) != SHD_OK || hash != g_hash[k]) ++failures;
    }
    return (void *)failures;
}

/* Eight threads, which also race to start the worker. */
static void test_threads(void **state)
{
    pthread_t threads[8];
    size_t i;
    (void)state;
    end_worker();
    for (i = 0; i < 8; ++i) assert_int_equal(pthread_create(&threads[i], NULL, load_many, (void *)i), 0);
    for (i = 0; i < 8; ++i) {
        void *failures = NULL;
        pthread_join(threads[i], &failures);
        assert_null(failures);
    }
    settle();
}

/* Ways for a process to end. */
static void end_by_exit(void) { exit(0); }
static void end_by_quick_exit(void) { _exit(0); }
static void end_by_kill(void) { raise(SIGKILL); }

/* A forked child has a worker of its own, which ends with it; that of the parent stays. */
static void test_fork(void **state)
{
    void (*const ends[])(void) = {end_by_exit, end_by_quick_exit, end_by_kill};
    const char *ours = g_worker;
    io_worker before, after;
    size_t i;
    (void)state;
    load_well(0);
    before = settle();
    for (i = 0; i < sizeof ends / sizeof ends[0]; ++i) {
        static const char *const names[] = {"worker-exit", "worker-quick-exit", "worker-kill"};
        const char *program = io_copy_worker(SHD_IO_WORKER, names[i]);
        int status = 0;
        const pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0) {
            uint64_t hash = 0;
            alarm(60);
            if (load(2, 60, &hash) != SHD_OK || hash != g_hash[2]) _exit(1); /* starts another worker of our program */
            if (io_find_worker(g_worker).server == 0) _exit(2);
            g_worker = program;
            if (load(2, 60, &hash) != SHD_OK || hash != g_hash[2]) _exit(3);
            if (io_find_worker(program).server == 0) _exit(4);
            ends[i]();
        }
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status) ? WTERMSIG(status) == SIGKILL : WEXITSTATUS(status) == 0);
        io_await_worker(program, -1);
    }
    g_worker = ours;
    load_well(0);
    after = settle();
    assert_int_equal(after.server, before.server);
}

static void *load_until_killed(void *data)
{
    (void)data;
    while (1) load(0, 60, NULL);
    return NULL;
}

/* exit() while four threads load. */
static void test_exit_in_flight(void **state)
{
    const char *program = io_copy_worker(SHD_IO_WORKER, "worker-in-flight");
    int status = 0, i;
    pid_t child;
    (void)state;
    child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        pthread_t threads[4];
        alarm(60);
        g_worker = program;
        load_well(0);
        for (i = 0; i < 4; ++i) pthread_create(&threads[i], NULL, load_until_killed, NULL);
        io_sleep(0.2);
        exit(0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    io_await_worker(program, -1);
}

/* The worker gets no variable of the host's environment, and no descriptor. */
static void test_nothing_inherited(void **state)
{
    char path[64];
    io_bytes environment;
    io_worker worker;
    int inherited;
    (void)state;
    end_worker();
    setenv("SHD_TEST_SECRET", "secret", 1);
    inherited = dup(1); /* without FD_CLOEXEC */
    load_well(0);
    close(inherited);
    worker = settle();
    assert_int_equal(io_count_descriptors(worker.children[0]), 3);
    snprintf(path, sizeof path, "/proc/%d/environ", (int)worker.server);
    {
        FILE *file = fopen(path, "r");
        char text[4096] = "";
        assert_non_null(file);
        environment.size = fread(text, 1, sizeof text, file);
        fclose(file);
        assert_null(memmem(text, environment.size, "SHD_TEST_SECRET", 15));
    }
}

/* Without descriptors a load fails, and the worker stays. */
static void test_out_of_descriptors(void **state)
{
    struct rlimit old, tight;
    io_worker before;
    int highest, room;
    (void)state;
    load_well(0);
    before = settle();
    assert_int_equal(getrlimit(RLIMIT_NOFILE, &old), 0);
    highest = dup(1);
    close(highest);
    for (room = 0; room < 8; ++room) {
        shd_result result;
        tight = old;
        tight.rlim_cur = (rlim_t)(highest + room);
        assert_int_equal(setrlimit(RLIMIT_NOFILE, &tight), 0);
        result = load(0, 60, NULL);
        setrlimit(RLIMIT_NOFILE, &old);
        if (room == 0) shd_assert_result("none", result, SHD_ERROR_IO, "Too many open files");
        assert_true(result == SHD_ERROR_IO || result == SHD_OK);
        load_well(0);
    }
    assert_int_equal(settle().server, before.server);
}

/* Runs in a child: closes all descriptors above 2 as daemons do, gives their numbers to own files or leaves them free,
 * and loads. Returns 0, or the number of what failed. */
static int load_without_descriptors(int own_files)
{
    struct stat before[64], now;
    uint64_t hash = 0;
    double start;
    char byte;
    int fd;
    if (load(2, 60, &hash) != SHD_OK || hash != g_hash[2]) return 1;
    for (fd = 3; fd < 64; ++fd) close(fd);
    for (fd = 3; own_files && fd < 64; ++fd) {
        if (open(io_path("own"), O_RDWR | O_CREAT | O_APPEND, 0600) != fd || fstat(fd, &before[fd]) != 0) return 2;
    }
    start = io_seconds();
    if (load(2, 60, &hash) != SHD_OK || hash != g_hash[2]) return 3;
    if (load(3, 60, &hash) != SHD_OK || hash != g_hash[3]) return 4;
    if (io_seconds() - start > 20) return 5; /* a new worker starts in less than a second */
    for (fd = 3; own_files && fd < 64; ++fd) {
        if (fstat(fd, &now) != 0 || now.st_ino != before[fd].st_ino || now.st_dev != before[fd].st_dev) return 6;
        if (pread(fd, &byte, 1, 0) != 0) return 7; /* nothing was written */
    }
    return 0;
}

/* A host that closes descriptors that it did not open: the next load starts another worker, and touches no file of the
 * host that has the number of a closed descriptor. */
static void test_descriptors_closed(void **state)
{
    int own_files;
    (void)state;
    for (own_files = 0; own_files < 2; ++own_files) {
        int status = 0;
        const pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0) {
            alarm(120);
            exit(load_without_descriptors(own_files)); /* the unload of the library touches none, either */
        }
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_int_equal(status, 0);
    }
}

/* Makes the samples and their hashes in a child: exit() may hang in a process that has opened OpenImageIO. */
static int prepare(void)
{
    int status = 0, i;
    pid_t child;
    g_hash = (uint64_t *)mmap(NULL, IO_SAMPLE_COUNT * sizeof *g_hash, PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (g_hash == MAP_FAILED) return 0;
    child = fork();
    if (child == 0) {
        io_make_corpus();
        for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
            shd_load_desc desc = shd_load_desc_default();
            shd_bitmap *bitmap = NULL;
            const io_bytes *bytes = &g_corpus[i].bytes;
            desc.flags = SHD_LOAD_IN_PROCESS;
            if (shd_bitmap_load_memory(g_context, bytes->data, bytes->size, &desc, &bitmap) != SHD_OK) _exit(1);
            g_hash[i] = io_hash_bitmap(bitmap);
            shd_bitmap_release(bitmap);
        }
        _exit(0);
    }
    if (waitpid(child, &status, 0) != child || status != 0) return 0;
    io_make_corpus();
    return 1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        {"reused", test_reused, NULL, NULL, NULL},
        {"child_dies", test_child_dies, NULL, NULL, NULL},
        {"spare_dies", test_spare_dies, NULL, NULL, NULL},
        {"child_hangs", test_child_hangs, NULL, NULL, NULL},
        {"worker_killed", test_worker_killed, NULL, NULL, NULL},
        {"worker_killed_in_flight", test_worker_killed_in_flight, NULL, NULL, NULL},
        {"worker_hangs", test_worker_hangs, NULL, NULL, NULL},
        {"threads", test_threads, NULL, NULL, NULL},
        {"fork", test_fork, NULL, NULL, NULL},
        {"exit_in_flight", test_exit_in_flight, NULL, NULL, NULL},
        {"nothing_inherited", test_nothing_inherited, NULL, NULL, NULL},
        {"out_of_descriptors", test_out_of_descriptors, NULL, NULL, NULL},
        {"descriptors_closed", test_descriptors_closed, NULL, NULL, NULL},
    };
    shd_context_desc one_worker = shd_context_desc_default();
    char worker[600];
    void *state = NULL;
    int failed;
    one_worker.worker_count = 1;
    if (io_make_folder(&state) != 0 || shd_context_create(&one_worker, &g_context) != SHD_OK || !prepare()) return 1;
    snprintf(worker, sizeof worker, "%s", io_copy_worker(SHD_IO_WORKER, "worker"));
    g_worker = worker;
    failed = _cmocka_run_group_tests("api.io_worker", tests, sizeof tests / sizeof tests[0], NULL, NULL);
    io_free_corpus();
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
