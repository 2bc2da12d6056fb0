/* SPDX-License-Identifier: MIT */
/* A batch of more than 2^31 lookups: every one is made, and nothing is written behind the last. The columns are 8 GiB
 * of addresses over a few MiB of memory, which is mapped many times. */
#define _GNU_SOURCE
#include <sys/mman.h>
#include <unistd.h>

#include "support/check.h"

#include <shd/shd.h>

enum { WINDOW = 1 << 25 }; /* bytes of memory */
#define COUNT (((size_t)1 << 31) + 4099)
#define WINDOWS (COUNT * sizeof(float) / WINDOW + 1)

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)

static void test_2_31(void **state)
{
    (void)state;
    print_message("skipped: too many lookups for an instrumented build\n");
    skip();
}

#else

/* `COUNT` floats; all windows but the last share their memory. NULL if the system refuses. */
static float *map_column(void)
{
    const int all = memfd_create("shd", 0), last = memfd_create("shd", 0);
    unsigned char *base = (unsigned char *)mmap(NULL, WINDOWS * WINDOW, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    size_t i;
    int ok = all >= 0 && last >= 0 && base != MAP_FAILED && ftruncate(all, WINDOW) == 0 && ftruncate(last, WINDOW) == 0;
    for (i = 0; ok && i < WINDOWS; ++i) {
        ok = mmap(base + i * WINDOW, WINDOW, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED,
                  i + 1 == WINDOWS ? last : all, 0) != MAP_FAILED;
    }
    close(all);
    close(last);
    if (!ok && base != MAP_FAILED) munmap(base, WINDOWS * WINDOW);
    return ok ? (float *)(void *)base : NULL;
}

static void test_2_31(void **state)
{
    static const unsigned char k_texels[4] = {10, 20, 30, 40};
    const size_t in_window = WINDOW / sizeof(float), tail = COUNT % in_window;
    float *in = map_column(), *out = map_column();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    size_t i;
    (void)state;
    if (!in || !out) {
        print_message("skipped: no address space\n");
        skip();
    }
    for (i = 0; i < in_window; ++i) {
        in[i] = 0.125f + 0.25f * (float)(i % 4);
        in[COUNT - tail + i] = i == tail - 2 ? NAN : 0.625f; /* the last window */
        out[i] = -1;
        out[COUNT - tail + i] = -1;
    }
    desc.format = SHD_FORMAT_R8;
    desc.width = 4;
    desc.height = 1;
    desc.texels = k_texels;
    sampler_desc.filter = SHD_FILTER_NEAREST;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    shd_assert_ok(shd_sampler_create(context, &sampler_desc, &sampler));
    lookups.count = COUNT;
    lookups.u.data = lookups.v.data = in;
    texels.channel[0].data = out;
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    assert_int_equal(texels.nonfinite_count, 1);
    for (i = 0; i < in_window; ++i) {
        assert_true(out[i] == (float)(10 + 10 * (i % 4)) / 255);
        if (i >= tail) {
            assert_true(out[COUNT - tail + i] == -1);
        } else {
            assert_true(out[COUNT - tail + i] == (i == tail - 2 ? 10.0f : 30.0f) / 255);
        }
    }
    shd_sampler_release(sampler);
    shd_texture_release(texture);
    shd_context_release(context);
    munmap(in, WINDOWS * WINDOW);
    munmap(out, WINDOWS * WINDOW);
}

#endif

int main(void)
{
    static const struct CMUnitTest k_tests[] = {{"count/2^31_and_4099", test_2_31, NULL, NULL, NULL}};
    return _cmocka_run_group_tests("api.lookup_many", k_tests, 1, NULL, NULL);
}
