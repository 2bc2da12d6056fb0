/* SPDX-License-Identifier: MIT */
/* Workers that misbehave: replies with wrong fields, too few bytes or none, and workers that do not start. Each load
 * ends with its error before its time limit and a second more, and the next load with the real worker succeeds. */
#define _GNU_SOURCE
#include "support/io_files.h"
#include "support/io_samples.h"
#include "support/io_worker.h"

#include <sys/wait.h>

static shd_context *g_context;
static const double k_limit = 0.4;

struct reply_case {
    const char *mode; /* name of a fault in tests/support/fake_worker.cpp */
    shd_result expected;
    const char *message;
};

static const struct reply_case k_cases[] = {
    {"good", SHD_OK, ""},
    {"long", SHD_ERROR_CORRUPT, "the decoder sent too many pixels"},
    {"huge_piece", SHD_ERROR_CORRUPT, "the decoder sent too many pixels"},
    {"few", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"no_final", SHD_ERROR_CORRUPT, "the decoder died on the file (signal 9)"},
    {"final_magic", SHD_ERROR_CORRUPT, "the decoder sent a wrong reply"},
    {"final_refuses", SHD_ERROR_CORRUPT, "row 3 is damaged"},
    {"final_turned", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"final_format", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"final_grows", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"final_info", SHD_ERROR_CORRUPT, "the decoder sent wrong properties"},
    {"color_space", SHD_OK, ""},
    {"reply_magic", SHD_ERROR_CORRUPT, "the decoder sent a wrong reply"},
    {"code", SHD_ERROR_CORRUPT, "the decoder sent a wrong reply"},
    {"text", SHD_ERROR_CORRUPT, "????????"},
    {"format", SHD_ERROR_CORRUPT, "the decoder sent format 77"},
    {"zero", SHD_ERROR_CORRUPT, "image of 0 x 4 pixels"},
    {"wide", SHD_ERROR_LIMIT, "image of 70000 x 4 pixels"},
    {"pixels", SHD_ERROR_LIMIT, "above load.max_pixels"},
    {"no_level", SHD_ERROR_CORRUPT, "the decoder sent 0 mip levels"},
    {"levels", SHD_ERROR_CORRUPT, "the decoder sent 2 mip levels"}, /* the load did not ask for levels */
    {"size", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"overflow", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"info_format", SHD_ERROR_CORRUPT, "the decoder sent wrong properties"},
    {"info_flags", SHD_ERROR_CORRUPT, "the decoder sent wrong properties"},
    {"short", SHD_ERROR_CORRUPT, "the decoder died on the file (signal 9)"},
    {"cut", SHD_ERROR_CORRUPT, "the decoder died on the file (signal 9)"},
    {"closes", SHD_ERROR_CORRUPT, "the decoder died on the file (no reply)"},
    {"hangs", SHD_ERROR_LIMIT, "load.time_limit 0.4 s"},
    {"drips", SHD_ERROR_LIMIT, "load.time_limit 0.4 s"},
    {"refuses", SHD_ERROR_OUT_OF_MEMORY, "cannot start \"a child of the worker\""},
    {"ends", SHD_ERROR_INTERNAL, "ends when it gets a file"},
    {"silent", SHD_ERROR_INTERNAL, "ends when it gets a file"}, /* closes the connection of the load */
    {"started_short", SHD_ERROR_INTERNAL, "ends when it gets a file"},
    {"hello_magic", SHD_ERROR_INTERNAL, "belongs to another version of shd"},
    {"hello_error", SHD_ERROR_IO, "Resource temporarily unavailable"},
    {"hello_short", SHD_ERROR_INTERNAL, "did not start"},
    {"hello_never", SHD_ERROR_INTERNAL, "did not start (exit status 7)"},
    {"hello_late", SHD_ERROR_LIMIT, "load.time_limit 0.4 s"},
};

static void test_case(void **state)
{
    const struct reply_case *c = (const struct reply_case *)*state;
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    char name[64];
    const char *path;
    double start;
    shd_result result;
    snprintf(name, sizeof name, "fake-%s", c->mode);
    path = io_path(name);
    assert_int_equal(symlink(SHD_FAKE_WORKER, path), 0);
    desc.worker_path = path;
    desc.time_limit = k_limit;
    start = io_seconds();
    result = shd_bitmap_load_memory(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap);
    assert_true(io_seconds() - start < k_limit + 1);
    shd_assert_result(c->mode, result, c->expected, c->message);
    assert_true((bitmap != NULL) == (result == SHD_OK));
    if (strcmp(c->mode, "color_space") == 0) {
        const char *text = shd_bitmap_color_space(bitmap);
        assert_int_equal(strlen(text), 63);
        assert_int_equal(strspn(text, "?"), 63);
    }
    shd_bitmap_release(bitmap);
    bitmap = NULL;
    desc.worker_path = SHD_IO_WORKER;
    desc.time_limit = 60;
    shd_assert_ok(shd_bitmap_load_memory(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap));
    shd_bitmap_release(bitmap);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1); /* no child is left, running or zombie */
}

int main(void)
{
    enum { CASES = sizeof k_cases / sizeof k_cases[0] };
    struct CMUnitTest tests[CASES];
    void *state = NULL;
    size_t i;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < CASES; ++i)
        tests[i] = (struct CMUnitTest){k_cases[i].mode, test_case, NULL, NULL, (void *)&k_cases[i]};
    failed = _cmocka_run_group_tests("api.io_reply", tests, CASES, NULL, NULL);
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
