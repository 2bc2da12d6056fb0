/* SPDX-License-Identifier: MIT */
/* shd/worker.h: a module in children of the worker. The module is tests/support/module/worker_module.c. */
#define _XOPEN_SOURCE 700
#include <shd/context.h>
#include <shd/worker.h>

#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

#include "support/check.h"

enum { kLarge = 5000000 };

static unsigned char *g_large; /* a file above the size that is copied */

struct outcome {
    size_t wanted; /* bytes that `receive` reads */
    unsigned char *bytes;
};

static shd_result find_file(const char *name, shd_worker_file *out, void *user)
{
    (void)user;
    if (strcmp(name, "large") == 0) {
        out->bytes = g_large;
        out->size = kLarge;
        return SHD_OK;
    }
    if (strcmp(name, "small") == 0) {
        out->bytes = "abc";
        out->size = 3;
        return SHD_OK;
    }
    if (strcmp(name, "disk") == 0) {
        char path[] = "/tmp/shd_module_XXXXXX";
        out->descriptor = mkstemp(path);
        unlink(path);
        if (out->descriptor < 0 || write(out->descriptor, "on disk", 7) != 7) return SHD_ERROR_IO;
        out->size = 7;
        return SHD_OK;
    }
    return strcmp(name, "stop") == 0 ? SHD_ERROR_LIMIT : SHD_ERROR_NOT_FOUND;
}

static shd_result receive(shd_worker_stream *reply, void *user)
{
    struct outcome *out = user;
    return shd_worker_read(reply, out->bytes, out->wanted);
}

static shd_result run(const char *request, size_t wanted, unsigned char *bytes)
{
    struct outcome out = {wanted, bytes};
    shd_worker_task task = SHD_ZERO_INIT;
    task.module = SHD_TEST_MODULE;
    task.request = request;
    task.request_size = strlen(request) + 1;
    task.time_limit = request[0] == 'h' ? 1 : 60;
    task.max_bytes = (uint64_t)1 << 28;
    task.find = find_file;
    task.receive = receive;
    task.user_data = &out;
    return shd_worker_run(&task);
}

struct run_case {
    const char *name, *request;
    size_t wanted;
    shd_result expected;
    const char *text; /* text of the message, or the reply */
};
static const struct run_case k_runs[] = {
    {"run/bytes", "esmall", 3, SHD_OK, "abc"},
    {"run/descriptor", "edisk", 7, SHD_OK, "on disk"},
    {"run/no_such_file", "eother", 3, SHD_ERROR_NOT_FOUND, "no file \"other\""},
    {"run/find_refuses", "estop", 3, SHD_ERROR_LIMIT, ""},
    {"run/message", "?", 0, SHD_ERROR_UNSUPPORTED, "request ?"},
    {"run/crash", "c", 1, SHD_ERROR_CORRUPT, "signal 11"},
    {"run/silent_end", "x", 1, SHD_ERROR_CORRUPT, "exit status 0"},
    {"run/too_short", "esmall", 4, SHD_ERROR_CORRUPT, "ends too early"},
    {"run/too_long", "esmall", 2, SHD_ERROR_CORRUPT, "too long"},
#if !defined(__SANITIZE_ADDRESS__) /* its children have no limit of memory */
    {"run/memory", "m", 0, SHD_ERROR_OUT_OF_MEMORY, ""},
#endif
    {"run/questions", "q", 1, SHD_ERROR_LIMIT, "more than 65536 other files"},
    {"run/hang", "h", 1, SHD_ERROR_LIMIT, "longer than"},
};

static void test_run(void **state)
{
    const struct run_case *c = *state;
    unsigned char bytes[16] = {0};
    assert_int_equal(run(c->request, c->wanted, bytes), c->expected);
    if (c->expected == SHD_OK)
        assert_memory_equal(bytes, c->text, c->wanted);
    else
        assert_non_null(strstr(shd_last_error(), c->text));
}

static void test_large(void **state)
{
    (void)state;
    unsigned char *bytes = calloc(kLarge, 1);
    assert_int_equal(run("elarge", kLarge, bytes), SHD_OK);
    assert_memory_equal(bytes, g_large, kLarge);
    free(bytes);
}

/* Every run is in a fresh child, and all children have one server. */
static void test_fresh(void **state)
{
    (void)state;
    int runs = 0;
    pid_t first = 0, second = 0;
    for (int i = 0; i < 3; ++i) {
        assert_int_equal(run("n", sizeof runs, (unsigned char *)&runs), SHD_OK);
        assert_int_equal(runs, 1);
    }
    assert_int_equal(run("p", sizeof first, (unsigned char *)&first), SHD_OK);
    assert_int_equal(run("c", 1, (unsigned char *)&runs), SHD_ERROR_CORRUPT);
    assert_int_equal(run("p", sizeof second, (unsigned char *)&second), SHD_OK);
    assert_int_equal(first, second);
    assert_true(first > 0);
}

struct bad_case {
    const char *name, *module;
    size_t request_size;
    double time_limit;
    shd_result expected;
    const char *text;
};
static const struct bad_case k_bad[] = {
    {"bad/null_module", NULL, 0, 1, SHD_ERROR_INVALID_ARGUMENT, "worker.module: NULL"},
    {"bad/relative_module", "module.so", 0, 1, SHD_ERROR_INVALID_ARGUMENT, "worker.module: is not an absolute path"},
    {"bad/missing_module", "/nonexistent/module.so", 0, 9, SHD_ERROR_NOT_FOUND, "/nonexistent/module.so"},
    {"bad/request_size", "/module.so", 1025, 1, SHD_ERROR_INVALID_ARGUMENT, "worker.request_size: 1025"},
    {"bad/time_limit", "/module.so", 0, -1, SHD_ERROR_INVALID_ARGUMENT, "worker.time_limit: -1"},
};

static void test_bad(void **state)
{
    const struct bad_case *c = *state;
    static const char request[1025];
    unsigned char byte;
    struct outcome out = {1, &byte};
    shd_worker_task task = SHD_ZERO_INIT;
    task.module = c->module;
    task.request = request;
    task.request_size = c->request_size;
    task.time_limit = c->time_limit;
    task.receive = receive;
    task.user_data = &out;
    assert_int_equal(shd_worker_run(&task), c->expected);
    assert_non_null(strstr(shd_last_error(), c->text));
}

int main(void)
{
    struct CMUnitTest tests[sizeof k_runs / sizeof *k_runs + sizeof k_bad / sizeof *k_bad + 2];
    size_t n = 0;
    g_large = malloc(kLarge);
    for (size_t i = 0; i < kLarge; ++i) g_large[i] = (unsigned char)(i * 2654435761u >> 13);
    for (size_t i = 0; i < sizeof k_runs / sizeof *k_runs; ++i)
        tests[n++] = (struct CMUnitTest){k_runs[i].name, test_run, NULL, NULL, (void *)&k_runs[i]};
    for (size_t i = 0; i < sizeof k_bad / sizeof *k_bad; ++i)
        tests[n++] = (struct CMUnitTest){k_bad[i].name, test_bad, NULL, NULL, (void *)&k_bad[i]};
    tests[n++] = (struct CMUnitTest){"run/large", test_large, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"run/fresh_child", test_fresh, NULL, NULL, NULL};
    const int failed = _cmocka_run_group_tests("io_module", tests, n, NULL, NULL);
    free(g_large);
    return failed;
}
