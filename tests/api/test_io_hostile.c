/* SPDX-License-Identifier: MIT */
/* Damaged files: one small file of each format, truncated at every byte and with bytes changed by a seeded
 * generator. Each is loaded in a child process, so that a crash of a decoder is counted and does not end the test. */
#define _GNU_SOURCE
#include "support/io_corpus.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>

enum { MAX_CASES = 4096, FLIPS = 400 };

/** Result of one load, in memory shared with the child processes. */
struct outcome {
    int result; /* shd_result, or a negative signal number */
    uint64_t hash;
};
static struct outcome *g_outcomes;

/* Receives standard output and error of the child processes, which must be empty. */
static int g_printed = -1;

static long printed_bytes(void)
{
    struct stat status;
    return fstat(g_printed, &status) == 0 ? (long)status.st_size : -1;
}

static void damage(const io_sample *sample, size_t index, io_bytes *out)
{
    out->size = sample->bytes.size;
    memcpy(out->data, sample->bytes.data, out->size);
    if (index < sample->bytes.size) {
        out->size = index;
    } else if (index < sample->bytes.size + FLIPS) {
        uint64_t random = 0x9e3779b97f4a7c15ull * (index + 1);
        int flips = 1 + (int)(io_random(&random) % 4);
        while (flips-- > 0) {
            const size_t at = io_random(&random) % out->size;
            out->data[at] = (unsigned char)(out->data[at] ^ (1 + io_random(&random) % 255));
        }
    }
}

/* Loads cases [first, count) until one kills this process. */
static void run_cases(const io_sample *sample, size_t first, size_t count, const shd_load_desc *desc)
{
    shd_context_desc one_worker = shd_context_desc_default();
    shd_context *context = NULL;
    io_bytes damaged = {(unsigned char *)malloc(sample->bytes.size), 0};
    size_t i;
    one_worker.worker_count = 1;
    dup2(g_printed, 1);
    dup2(g_printed, 2);
    if (shd_context_create(&one_worker, &context) != SHD_OK) _exit(99);
    for (i = first; i < count; ++i) {
        shd_bitmap *bitmap = NULL;
        damage(sample, i, &damaged);
        g_outcomes[i].result = -1;
        alarm(20);
        g_outcomes[i].result = shd_bitmap_load_memory(context, damaged.data, damaged.size, desc, &bitmap);
        g_outcomes[i].hash = bitmap ? io_hash_bitmap(bitmap) : 0;
        shd_bitmap_release(bitmap);
    }
    shd_context_release(context);
    free(damaged.data);
}

/* Returns the number of cases that killed a child process. */
static int run_all(const io_sample *sample, size_t count, const shd_load_desc *desc)
{
    size_t first = 0;
    int deaths = 0;
    while (first < count) {
        int status = 0;
        const pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0) {
            run_cases(sample, first, count, desc);
            _exit(0);
        }
        assert_int_equal(waitpid(child, &status, 0), child);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
        while (first < count && g_outcomes[first].result != -1) ++first;
        g_outcomes[first].result = -1000 - (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
        ++deaths;
        ++first;
    }
    return deaths;
}

static void test_damaged(void **state)
{
    const io_sample *sample = (const io_sample *)*state;
    shd_load_desc desc = shd_load_desc_default();
    const size_t count = sample->bytes.size + FLIPS + 1; /* the last case is the undamaged file */
    size_t i, loaded = 0, refused = 0, silent = 0;
    uint64_t whole = 0;
    int deaths;
    assert_true(count <= MAX_CASES);
    desc.flags = SHD_LOAD_IN_PROCESS;
    memset(g_outcomes, 0xff, count * sizeof *g_outcomes);
    deaths = run_all(sample, count, &desc);
    assert_int_equal(g_outcomes[count - 1].result, SHD_OK);
    whole = g_outcomes[count - 1].hash;
    for (i = 0; i < count; ++i) {
        if (g_outcomes[i].result == SHD_OK) {
            ++loaded;
            if (i < sample->bytes.size && g_outcomes[i].hash != whole) ++silent;
        } else if (g_outcomes[i].result > 0) {
            ++refused;
        } else {
            print_message("%s: case %zu ended with signal %d\n", sample->name, i, -g_outcomes[i].result - 1000);
        }
    }
    print_message("%s: %zu truncations and %d flips in process: %zu loaded, %zu refused, %d deaths\n", sample->name,
                  sample->bytes.size, FLIPS, loaded, refused, deaths);
    assert_int_equal(deaths, 0);
    assert_int_equal(silent, 0); /* a truncated file is refused, unless the missing bytes have no effect */
    assert_int_equal(printed_bytes(), 0);
}

/* Damaged files of each format in the default setting: two loads are equal to the one in process, and this process
 * survives. */
static void test_default(void **state)
{
    const io_sample *sample = (const io_sample *)*state;
    shd_load_desc desc = shd_load_desc_default();
    const size_t count = sample->bytes.size + FLIPS;
    size_t i;
    io_bytes damaged = {(unsigned char *)malloc(sample->bytes.size), 0};
    shd_context *context = NULL;
    desc.time_limit = 20;
#ifdef SHD_IO_WORKER
    desc.worker_path = SHD_IO_WORKER;
#endif
    shd_assert_ok(shd_context_create(NULL, &context));
    for (i = 0; i < count; i += 1 + count / 40) {
        int twice;
        damage(sample, i, &damaged);
        for (twice = 0; twice < 2; ++twice) {
            shd_bitmap *bitmap = NULL;
            const shd_result result = shd_bitmap_load_memory(context, damaged.data, damaged.size, &desc, &bitmap);
            assert_int_equal(result, g_outcomes[i].result);
            if (bitmap) assert_true(io_hash_bitmap(bitmap) == g_outcomes[i].hash);
            shd_bitmap_release(bitmap);
        }
    }
    shd_context_release(context);
    free(damaged.data);
}

/* Decoding threads do not survive a fork, so this process itself never decodes or encodes. */
static void make_corpus_in_child(void)
{
    int status = 0;
    const pid_t child = fork();
    if (child == 0) {
        io_make_corpus();
        _exit(0);
    }
    waitpid(child, &status, 0);
    io_make_corpus();
}

int main(void)
{
    struct CMUnitTest tests[2 * IO_SAMPLE_COUNT];
    static char names[2 * IO_SAMPLE_COUNT][64];
    size_t n = 0, i;
    void *state = NULL;
    int failed;
    g_outcomes = (struct outcome *)mmap(NULL, MAX_CASES * sizeof *g_outcomes, PROT_READ | PROT_WRITE,
                                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (g_outcomes == MAP_FAILED || io_make_folder(&state) != 0) return 1;
    make_corpus_in_child();
    g_printed = open(io_path("printed"), O_RDWR | O_CREAT, 0600);
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
        snprintf(names[n], sizeof names[n], "damaged/%s", g_corpus[i].name);
        tests[n] = (struct CMUnitTest){names[n], test_damaged, NULL, NULL, &g_corpus[i]};
        ++n;
        snprintf(names[n], sizeof names[n], "default/%s", g_corpus[i].name);
        tests[n] = (struct CMUnitTest){names[n], test_default, NULL, NULL, &g_corpus[i]};
        ++n;
    }
    failed = _cmocka_run_group_tests("api.io_hostile", tests, n, NULL, NULL);
    io_free_corpus();
    io_remove_folder(&state);
    return failed;
}
