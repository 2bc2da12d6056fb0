/* SPDX-License-Identifier: MIT */
/* The host's process is not disturbed by colour calls: floating-point control, errno, locale, signals, directory and
 * descriptors stay unchanged, also in calls that fail, and results have the same bits under every control. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include "support/color.h"
#include "support/control.h"

#include <shd/shd.h>

enum { PIXELS = 512 };

struct process {
    sigset_t signals;
    char directory[4096], locale[256];
    int descriptors;
};

static struct process look_at_process(void)
{
    struct process p;
    int fd;
    memset(&p, 0, sizeof p);
    sigemptyset(&p.signals);
    pthread_sigmask(SIG_SETMASK, NULL, &p.signals);
    assert_non_null(getcwd(p.directory, sizeof p.directory));
    snprintf(p.locale, sizeof p.locale, "%s", setlocale(LC_ALL, NULL));
    for (fd = 0; fd < 256; ++fd) p.descriptors += fcntl(fd, F_GETFD) >= 0;
    return p;
}

static unsigned g_control;
static size_t g_calls;

/* State of the host before a call, which must be equal after it. */
static void enter(void)
{
    errno = 1234;
    shd_write_control(g_control);
}
static shd_result leave(shd_result result)
{
    const unsigned control = shd_read_control();
    const int found_errno = errno;
    shd_write_control(0x1f80);
    if (control != g_control && SHD_HAS_MXCSR) fail_msg("MXCSR 0x%x became 0x%x", g_control, control);
    assert_int_equal(found_errno, 1234);
    ++g_calls;
    return result;
}
#define CHECKED(call) (enter(), leave(call))

static void make_pixels(float *rgba)
{
    static const float k_values[] = {0.18f, 1e-42f, -1e-40f, 65504, NAN, INFINITY, -2, 1e30f, 0.999f, 3};
    int i;
    for (i = 0; i < 4 * PIXELS; ++i) {
        rgba[i] = i % 4 == 3 ? 1.0f : k_values[(i * 7 + i / 11) % 10] * (i % 3 ? 1.0f : 0.37f);
    }
}

/* Creates a handle, transforms pixels in three ways and provokes errors. Returns the hash of the results. */
static uint64_t visit(void)
{
    static float rgba[4 * PIXELS], out[4 * PIXELS];
    static unsigned char bytes[4 * PIXELS];
    shd_color_desc broken = shd_color_desc_default();
    shd_context *context = NULL;
    shd_color *color = NULL, *none = NULL;
    shd_image source, image, eight;
    uint64_t hash = SHD_HASH_START;
    make_pixels(rgba);
    source = shd_test_image(SHD_FORMAT_RGBA32F, PIXELS, 1, rgba);
    image = shd_test_image(SHD_FORMAT_RGBA32F, PIXELS, 1, out);
    eight = shd_test_image(SHD_FORMAT_RGBA8, PIXELS, 1, bytes);
    shd_assert_ok(CHECKED(shd_context_create(NULL, &context)));
    shd_assert_ok(CHECKED(shd_color_create(context, NULL, &color)));
    shd_assert_ok(CHECKED(shd_color_apply_display_image(color, &source, "ACEScg", NULL, NULL, &image)));
    hash = shd_hash(hash, out, sizeof out);
    shd_assert_ok(CHECKED(shd_color_apply_display_image(color, &source, NULL, "sRGB", "Plain", &eight)));
    hash = shd_hash(hash, bytes, sizeof bytes);
    shd_assert_ok(CHECKED(shd_color_convert(color, &source, "ACES2065-1", "sRGB - Texture")));
    hash = shd_hash(hash, rgba, sizeof rgba);
    broken.config_text = "ocio_profile_version: [";
    shd_assert_result("broken", CHECKED(shd_color_create(context, &broken, &none)), SHD_ERROR_CORRUPT, "config_text");
    broken.config_text = NULL;
    broken.config_path = "/nowhere/config.ocio";
    shd_assert_result("path", CHECKED(shd_color_create(context, &broken, &none)), SHD_ERROR_NOT_FOUND, "config_path");
    shd_assert_result("space", CHECKED(shd_color_convert(color, &source, "gone", NULL)), SHD_ERROR_NOT_FOUND, "gone");
    enter();
    shd_color_release(color);
    (void)leave(SHD_OK);
    enter();
    shd_context_release(context);
    (void)leave(SHD_OK);
    return hash;
}

static void test_control(void **state)
{
    const struct control_case *c = (const struct control_case *)*state;
    struct process before, after;
    uint64_t want;
    int s;
    g_control = 0x1f80;
    want = visit();
    before = look_at_process();
    g_control = c->mxcsr;
    g_calls = 0;
    assert_true(visit() == want);
    after = look_at_process();
    for (s = 1; s < 32; ++s) assert_int_equal(sigismember(&after.signals, s), sigismember(&before.signals, s));
    assert_string_equal(after.directory, before.directory);
    assert_string_equal(after.locale, before.locale);
    assert_int_equal(after.descriptors, before.descriptors);
    print_message("%s: %zu calls, 0 changes\n", c->name, g_calls);
}

int main(void)
{
    struct CMUnitTest tests[sizeof k_controls / sizeof k_controls[0]];
    size_t n = 0;
    unsetenv("OCIO");
    for (; n < sizeof k_controls / sizeof k_controls[0]; ++n) {
        tests[n] = (struct CMUnitTest){k_controls[n].name, test_control, NULL, NULL, (void *)&k_controls[n]};
    }
    return _cmocka_run_group_tests("api.color_host", tests, n, NULL, NULL);
}
