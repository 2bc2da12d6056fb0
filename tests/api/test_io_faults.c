/* SPDX-License-Identifier: MIT */
/* Faults of the system while a file is read: it is deleted, replaced, cut or appended after it was opened, reads fail
 * or are short, no descriptor is left. Each load ends with an error or with the right pixels, and other textures keep
 * working. Wrong handles, repeated loads of cut files, 64 threads, hosts with unusual floating-point control. */
#define _GNU_SOURCE
#include "support/control.h"
#include "support/io_corpus.h"
#include "support/rows.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <shd/shd.h>

/* The libraries call these definitions instead of the C library's. */
#define HOOK __attribute__((visibility("default")))
static struct {
    void (*after_stat)(void); /* called once, after the size of the file is known */
    size_t reads, fail_at;    /* reads so far; 1 = the first one fails, 0 = none */
    size_t most;              /* bytes of one read; 0 = any number. Every third read is interrupted */
} g_hook;

HOOK int fstat(int fd, struct stat *out)
{
    const int result = fstatat(fd, "", out, AT_EMPTY_PATH);
    void (*deed)(void) = g_hook.after_stat;
    g_hook.after_stat = NULL;
    if (deed) deed();
    return result;
}

/* Returns whether a read fails, and limits its size. */
static int spoil(size_t *size)
{
    if (!g_hook.most && !g_hook.fail_at) return 0;
    errno = ++g_hook.reads == g_hook.fail_at ? EIO : EINTR;
    if (g_hook.most && *size > g_hook.most) *size = g_hook.most;
    return g_hook.reads == g_hook.fail_at || g_hook.reads % 3 == 0;
}
HOOK ssize_t read(int fd, void *to, size_t size) { return spoil(&size) ? -1 : syscall(SYS_read, fd, to, size); }
HOOK ssize_t pread(int fd, void *to, size_t size, off_t at)
{
    return spoil(&size) ? -1 : syscall(SYS_pread64, fd, to, size, at);
}
HOOK ssize_t pread64(int fd, void *to, size_t size, off64_t at) { return pread(fd, to, size, (off_t)at); }

static shd_context *g_context;
static shd_texture *g_texture; /* loaded before every fault */
static shd_sampler *g_sampler;
static uint64_t g_texture_bits, g_first, g_second; /* hashes: of lookups, of the first and the second file */

static uint64_t sample(void)
{
    enum { COUNT = 300 };
    float u[COUNT], out[4][COUNT];
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    size_t i;
    for (i = 0; i < COUNT; ++i) u[i] = 0.01f * (float)i;
    lookups.count = COUNT;
    lookups.u.data = lookups.v.data = u;
    for (i = 0; i < 4; ++i) texels.channel[i].data = out[i];
    if (shd_texture_sample(g_texture, g_sampler, &lookups, &texels) != SHD_OK) return 0;
    return shd_hash(SHD_HASH_START, out, sizeof out);
}

/* The faults are injected into this process, so the decoder must run in it. */
static shd_load_desc g_in_process;

/* Loads a file; returns the hash of its pixels, or 0 and the result. */
static uint64_t load(const char *path, shd_result *out_result)
{
    shd_bitmap *bitmap = (shd_bitmap *)&g_hook;
    uint64_t hash;
    *out_result = shd_bitmap_load(g_context, path, &g_in_process, &bitmap);
    assert_true((bitmap != NULL) == (*out_result == SHD_OK));
    hash = bitmap ? io_hash_bitmap(bitmap) : 0;
    shd_bitmap_release(bitmap);
    return hash;
}

/* ---- between open and read ---- */

static void delete_it(void) { assert_int_equal(unlink(io_path("a.png")), 0); }
static void replace_it(void)
{
    io_write(io_path("new.png"), g_corpus[1].bytes.data, g_corpus[1].bytes.size);
    assert_int_equal(rename(io_path("new.png"), io_path("a.png")), 0);
}
static void overwrite_it(void) { io_write(io_path("a.png"), g_corpus[1].bytes.data, g_corpus[1].bytes.size); }
static void cut_it(void) { assert_int_equal(truncate(io_path("a.png"), 10), 0); }
static void empty_it(void) { assert_int_equal(truncate(io_path("a.png"), 0), 0); }
static void append_to_it(void)
{
    FILE *file = fopen(io_path("a.png"), "ab");
    assert_true(file && fwrite("more", 1, 4, file) == 4 && fclose(file) == 0);
}

struct change_case {
    const char *name;
    void (*deed)(void);
    shd_result expected; /* SHD_OK = the pixels of the file that was opened */
};
static const struct change_case k_changes[] = {
    {"changed/deleted", delete_it, SHD_OK},
    {"changed/replaced", replace_it, SHD_OK},
    {"changed/appended", append_to_it, SHD_OK},
    {"changed/cut", cut_it, SHD_ERROR_IO},
    {"changed/emptied", empty_it, SHD_ERROR_IO},
    {"changed/overwritten", overwrite_it, SHD_RESULT_MAX_ENUM}, /* any error, or old or new pixels */
};

static void test_change(void **state)
{
    const struct change_case *c = (const struct change_case *)*state;
    shd_result result;
    uint64_t hash;
    io_write(io_path("a.png"), g_corpus[0].bytes.data, g_corpus[0].bytes.size);
    g_hook.after_stat = c->deed;
    hash = load(io_path("a.png"), &result);
    assert_null(g_hook.after_stat); /* it happened */
    if (c->expected == SHD_OK) {
        shd_assert_result(c->name, result, SHD_OK, "");
        assert_true(hash == g_first);
    } else if (c->expected == SHD_ERROR_IO) {
        shd_assert_result(c->name, result, SHD_ERROR_IO, "became shorter while it was read");
    } else {
        assert_true(result != SHD_OK || hash == g_first || hash == g_second);
        assert_int_not_equal(result, SHD_ERROR_INTERNAL);
    }
    assert_true(sample() == g_texture_bits);
    io_write(io_path("a.png"), g_corpus[0].bytes.data, g_corpus[0].bytes.size);
    assert_true(load(io_path("a.png"), &result) == g_first);
}

/* ---- reads ---- */

/* Reads of at most 7 bytes, and interrupted ones, give the same pixels. */
static void test_short_reads(void **state)
{
    shd_result result;
    uint64_t hash;
    (void)state;
    io_write(io_path("a.png"), g_corpus[0].bytes.data, g_corpus[0].bytes.size);
    g_hook.reads = 0;
    g_hook.most = 7;
    hash = load(io_path("a.png"), &result);
    g_hook.most = 0;
    shd_assert_result("short", result, SHD_OK, "");
    assert_true(hash == g_first);
}

/* The n-th read fails, for every n: an error, of the file or of the pipe from the process that decodes it. */
static void test_read_errors(void **state)
{
    size_t n, failed = 0;
    (void)state;
    io_write(io_path("a.png"), g_corpus[0].bytes.data, g_corpus[0].bytes.size);
    for (n = 1; n < 1000; ++n) {
        shd_result result;
        uint64_t hash;
        if (n % 3 == 0) continue; /* an interrupted read */
        g_hook.reads = 0;
        g_hook.most = 7;
        g_hook.fail_at = n;
        hash = load(io_path("a.png"), &result);
        g_hook.most = g_hook.fail_at = 0;
        assert_true(sample() == g_texture_bits);
        if (g_hook.reads < n) { /* the file was read without the fault */
            shd_assert_result("no fault", result, SHD_OK, "");
            assert_true(hash == g_first);
            break;
        }
        if (result != SHD_ERROR_IO && result != SHD_ERROR_CORRUPT) fail_msg("read %zu: %s", n, shd_result_name(result));
        ++failed;
    }
    print_message("%zu reads failed\n", failed);
    assert_true(n < 1000);
}

static void test_no_descriptors(void **state)
{
    struct rlimit old, none;
    shd_result result;
    (void)state;
    io_write(io_path("a.png"), g_corpus[0].bytes.data, g_corpus[0].bytes.size);
    assert_int_equal(getrlimit(RLIMIT_NOFILE, &old), 0);
    none = old;
    none.rlim_cur = 0;
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &none), 0);
    (void)load(io_path("a.png"), &result);
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &old), 0);
    shd_assert_result("descriptors", result, SHD_ERROR_IO, "Too many open files");
    assert_true(sample() == g_texture_bits);
    assert_true(load(io_path("a.png"), &result) == g_first);
}

/* ---- cut files ---- */

/* Two loads of a cut file have the same result and the same pixels. */
static void test_cut_twice(void **state)
{
    const io_sample *sample_file = (const io_sample *)*state;
    size_t size, loads = 0;
    for (size = 1; size < sample_file->bytes.size; size += 5) {
        shd_result result[2];
        uint64_t hash[2];
        int round;
        io_write(io_path("cut"), sample_file->bytes.data, size);
        for (round = 0; round < 2; ++round, ++loads) hash[round] = load(io_path("cut"), &result[round]);
        assert_int_equal(result[0], result[1]);
        assert_true(hash[0] == hash[1]);
        assert_int_not_equal(result[0], SHD_ERROR_INTERNAL);
    }
    print_message("%s: %zu loads\n", sample_file->name, loads);
}

/* ---- handles ---- */

static void test_handles(void **state)
{
    uint64_t zeros[16] = {0};
    shd_bitmap *bitmap = NULL, *released = NULL;
    void *wrong[5];
    size_t i;
    (void)state;
    shd_assert_ok(shd_bitmap_load_memory(g_context, g_corpus[0].bytes.data, g_corpus[0].bytes.size, NULL, &bitmap));
    shd_assert_ok(shd_bitmap_load_memory(g_context, g_corpus[0].bytes.data, g_corpus[0].bytes.size, NULL, &released));
    shd_bitmap_release(released);
    wrong[0] = NULL;
    wrong[1] = released;
    wrong[2] = g_texture;
    wrong[3] = g_context;
    wrong[4] = zeros;
    for (i = 0; i < sizeof wrong / sizeof wrong[0]; ++i) {
        shd_bitmap *handle = (shd_bitmap *)wrong[i], *none = bitmap;
        shd_image image = shd_image_default();
        shd_bitmap_info info = shd_bitmap_info_default();
        const char *message = i == 0 ? "bitmap: NULL" : "bitmap: not a live handle of its type";
        shd_assert_result("image", shd_bitmap_get_image(handle, &image), SHD_ERROR_INVALID_ARGUMENT, message);
        shd_assert_result("info", shd_bitmap_get_info(handle, &info), SHD_ERROR_INVALID_ARGUMENT, message);
        assert_string_equal(shd_bitmap_get_color_space(handle), "");
        shd_bitmap_retain(handle);
        shd_bitmap_release(handle);
        shd_bitmap_release(handle);
        if (wrong[i] == g_context) continue;
        shd_assert_result("context", shd_bitmap_load((shd_context *)wrong[i], "x", NULL, &none),
                          SHD_ERROR_INVALID_ARGUMENT, "context: ");
        assert_null(none);
    }
    assert_true(io_hash_bitmap(bitmap) == g_first);
    assert_true(sample() == g_texture_bits);
    shd_bitmap_release(bitmap);
}

/* ---- threads ---- */

struct worker {
    pthread_t thread;
    size_t index, mistakes;
};

/* Threads sample a texture while others load files, one of them cut. */
static void *work(void *data)
{
    struct worker *worker = (struct worker *)data;
    int round;
    for (round = 0; round < 3; ++round) {
        shd_bitmap *bitmap = NULL;
        const io_bytes *bytes = &g_corpus[0].bytes;
        if (worker->index % 2) {
            worker->mistakes += sample() != g_texture_bits;
        } else if (worker->index % 4) {
            worker->mistakes += shd_bitmap_load_memory(g_context, bytes->data, 20, NULL, &bitmap) == SHD_OK;
        } else {
            worker->mistakes += shd_bitmap_load_memory(g_context, bytes->data, bytes->size, NULL, &bitmap) != SHD_OK ||
                                io_hash_bitmap(bitmap) != g_first;
        }
        shd_bitmap_release(bitmap);
    }
    return NULL;
}

static void test_64_threads(void **state)
{
    static struct worker workers[64];
    size_t i;
    (void)state;
    for (i = 0; i < 64; ++i) {
        workers[i].index = i;
        workers[i].mistakes = 0;
        assert_int_equal(pthread_create(&workers[i].thread, NULL, work, &workers[i]), 0);
    }
    for (i = 0; i < 64; ++i) pthread_join(workers[i].thread, NULL);
    for (i = 0; i < 64; ++i) assert_int_equal(workers[i].mistakes, 0);
}

/* ---- floating-point control ---- */

/* Loads and saves files of every format while the host has `control` set. Returns the hash of the pixels. */
static uint64_t visit(unsigned control)
{
    uint64_t hash = SHD_HASH_START;
    int i;
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
        shd_bitmap *bitmap = NULL;
        shd_image image = shd_image_default();
        shd_result result, saved = SHD_OK;
        unsigned after, after_save;
        shd_write_control(control);
        result =
            shd_bitmap_load_memory(g_context, g_corpus[i].bytes.data, g_corpus[i].bytes.size, &g_in_process, &bitmap);
        after = shd_read_control();
        shd_write_control(0x1f80);
        shd_assert_result(g_corpus[i].name, result, SHD_OK, "");
        shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
        shd_write_control(control);
        saved = shd_image_save(&image,
                               io_path(image.format == SHD_FORMAT_RGBA16F   ? "c.exr"
                                       : image.format == SHD_FORMAT_RGBA32F ? "c.hdr"
                                                                            : "c.png"),
                               NULL);
        after_save = shd_read_control();
        shd_write_control(0x1f80);
        shd_assert_result("save", saved, SHD_OK, "");
        if (SHD_HAS_MXCSR && (after != control || after_save != control)) {
            fail_msg("%s: MXCSR 0x%x became 0x%x and 0x%x", g_corpus[i].name, control, after, after_save);
        }
        hash = shd_hash(hash, &(uint64_t){io_hash_bitmap(bitmap)}, sizeof hash);
        shd_bitmap_release(bitmap);
    }
    return hash;
}

static void test_control(void **state)
{
    const struct control_case *c = (const struct control_case *)*state;
    assert_true(visit(c->mxcsr) == visit(0x1f80));
}

int main(void)
{
    static char names[IO_SAMPLE_COUNT][40];
    void *state = NULL;
    shd_result result;
    int failed, i;
    g_in_process = shd_load_desc_default();
    g_in_process.flags = SHD_LOAD_IN_PROCESS;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    io_make_corpus();
    io_write(io_path("b.png"), g_corpus[1].bytes.data, g_corpus[1].bytes.size);
    io_write(io_path("a.png"), g_corpus[0].bytes.data, g_corpus[0].bytes.size);
    g_first = load(io_path("a.png"), &result);
    g_second = load(io_path("b.png"), &result);
    if (shd_texture_load(g_context, io_path("a.png"), NULL, &g_texture) != SHD_OK) return 1;
    if (shd_sampler_create(g_context, NULL, &g_sampler) != SHD_OK) return 1;
    g_texture_bits = sample();
    ADD_ROWS(k_changes, test_change);
    add("reads/short_and_interrupted", test_short_reads, NULL);
    add("reads/each_one_fails", test_read_errors, NULL);
    add("no_descriptors", test_no_descriptors, NULL);
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
        snprintf(names[i], sizeof names[i], "cut_twice/%s", g_corpus[i].name);
        add(names[i], test_cut_twice, &g_corpus[i]);
    }
    add("wrong_handles", test_handles, NULL);
    add("64_threads", test_64_threads, NULL);
    ADD_ROWS(k_controls, test_control);
    failed = _cmocka_run_group_tests("api.io_faults", g_tests, g_count, NULL, NULL);
    shd_sampler_release(g_sampler);
    shd_texture_release(g_texture);
    shd_context_release(g_context);
    io_free_corpus();
    io_remove_folder(&state);
    return failed;
}
