/* SPDX-License-Identifier: MIT */
/* Baked displays against the exact path of OpenColorIO: the bound on codes for many views, bad numbers, equal bits on
 * all targets and workers, views that cannot be baked, failing allocations. */
#define _POSIX_C_SOURCE 200809L
#include "support/color_views.h"

#include <pthread.h>

#include <shd/shd.h>

#include "support/fault_allocator.h"
#include "support/rows.h"
#include "support/simd.h"

enum { SIDE = 512, PIXELS = SIDE * SIDE, UNBAKED_VIEWS = sizeof k_unbaked_views / sizeof k_unbaked_views[0] };

static char *g_config;     /* the config of color_views.h */
static float *g_rgba;      /* the colours of make_colors() */
static size_t g_log_lines; /* warnings so far */
static char g_log_line[1024];

static void write_log(shd_log_level level, const char *message, void *user_data)
{
    (void)user_data;
    if (level < SHD_LOG_LEVEL_WARNING) return;
    ++g_log_lines;
    snprintf(g_log_line, sizeof g_log_line, "%s", message);
}

static uint64_t g_state;
static double unit(void) /* SplitMix64 */
{
    uint64_t z = g_state += 0x9e3779b97f4a7c15ull;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ z >> 27) * 0x94d049bb133111ebull;
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

/** The stated set: the largest channel is 2^-14..2^6; greys, any ratios, saturated, on the gamut's edge, negative. */
static void make_colors(float *rgba)
{
    size_t i, c;
    g_state = 15;
    for (i = 0; i < PIXELS; ++i) {
        const double peak = exp2(-14 + 20 * unit());
        const size_t largest = (size_t)(3 * unit()), kind = i % 5;
        for (c = 0; c < 3; ++c) {
            double ratio = unit();
            if (kind == 1) ratio = exp2(-14 * ratio);
            if (kind == 2) ratio = ratio < 0.5 ? 0 : exp2(-14 * (2 * ratio - 1));
            if (kind == 3) ratio = ratio < 0.5 ? -exp2(-14 * ratio - 1) : exp2(-14 * (2 * ratio - 1));
            if (kind == 4) ratio = 1;
            rgba[4 * i + c] = (float)(c == largest ? peak : peak * ratio);
        }
        rgba[4 * i + 3] = 1.0f;
    }
}

static shd_color *make_color(const char *config, shd_simd simd, uint32_t workers, shd_display_precision precision,
                             shd_context **out_context)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_color_desc color_desc = shd_color_desc_default();
    shd_color *color = NULL;
    desc.simd = simd;
    desc.worker_count = workers;
    desc.log.write = write_log;
    shd_assert_ok(shd_context_create(&desc, out_context));
    color_desc.config_text = config;
    color_desc.display_precision = precision;
    shd_assert_ok(shd_color_create(*out_context, &color_desc, &color));
    return color;
}

/* A config with baked displays, and with exact ones. */
struct both_paths {
    shd_context *baked_context, *exact_context;
    shd_color *baked, *exact;
};

static struct both_paths open_paths(const char *config)
{
    struct both_paths paths = {NULL, NULL, NULL, NULL};
    paths.baked = make_color(config, SHD_SIMD_BEST, 1, SHD_DISPLAY_PRECISION_BAKED, &paths.baked_context);
    paths.exact = make_color(config, SHD_SIMD_BEST, 1, SHD_DISPLAY_PRECISION_EXACT, &paths.exact_context);
    return paths;
}

static void close_paths(const struct both_paths *paths)
{
    shd_color_release(paths->baked);
    shd_color_release(paths->exact);
    shd_context_release(paths->baked_context);
    shd_context_release(paths->exact_context);
}

static void apply(const shd_color *color, const float *rgba, uint32_t width, uint32_t height, const char *from,
                  const char *display, const char *view, uint8_t *out)
{
    shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, width, height, (void *)(uintptr_t)rgba);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA8, width, height, out);
    shd_assert_ok(shd_color_apply_display_image(color, &source, from, display, view, &image));
}

/* ---- the bound ---- */

struct config_row {
    const char *name;
    const char *const *config;
    const char *display;
};

static const char *g_default_config;
static const char *g_views_config;
static const struct config_row k_configs[] = {
    {"bound/built-in_srgb", &g_default_config, "sRGB"},
    {"bound/built-in_rec709", &g_default_config, "Rec.709"},
    {"bound/aces", &g_views_config, "aces"},
    {"bound/made", &g_views_config, "made"},
};
static const struct config_row k_bad_configs[] = {
    {"bad/built-in_srgb", &g_default_config, "sRGB"},
    {"bad/built-in_rec709", &g_default_config, "Rec.709"},
    {"bad/aces", &g_views_config, "aces"},
    {"bad/made", &g_views_config, "made"},
};
static const struct config_row k_bits_configs[] = {
    {"bits/built-in_srgb", &g_default_config, "sRGB"},
    {"bits/built-in_rec709", &g_default_config, "Rec.709"},
    {"bits/aces", &g_views_config, "aces"},
    {"bits/made", &g_views_config, "made"},
};

/** Compares both paths from one space, and prints the figures. */
static void check_bound(const shd_color *baked, const shd_color *exact, const char *from, const char *display,
                        const char *view)
{
    uint8_t *got = (uint8_t *)malloc(4 * PIXELS), *want = (uint8_t *)malloc(4 * PIXELS);
    size_t i, different = 0, above_one = 0;
    int largest = 0;
    apply(baked, g_rgba, SIDE, SIDE, from, display, view, got);
    apply(exact, g_rgba, SIDE, SIDE, from, display, view, want);
    for (i = 0; i < 4 * (size_t)PIXELS; ++i) {
        const int difference = abs(got[i] - want[i]);
        different += difference > 0;
        above_one += difference > 1;
        if (difference > largest) largest = difference;
        if (i % 4 == 3) assert_int_equal(got[i], 255);
    }
    print_message("%s, %s from %s: %.5f %% of the codes differ, %.5f %% by more than 1, at most by %d\n", display, view,
                  from ? from : "the working space", 100.0 * (double)different / (3.0 * PIXELS),
                  100.0 * (double)above_one / (3.0 * PIXELS), largest);
    if (largest > 3 || (double)above_one > 0.001 * 3.0 * PIXELS) fail_msg("%s, %s: above the bound", display, view);
    free(got);
    free(want);
}

/** All views of a display are baked, and within the bound. */
static void test_bound(void **state)
{
    const struct config_row *c = (const struct config_row *)*state;
    const struct both_paths paths = open_paths(*c->config);
    const shd_color *const baked = paths.baked, *const exact = paths.exact;
    const int is_built_in = *c->config == g_default_config;
    uint32_t v;
    g_log_lines = 0;
    assert_true(shd_color_get_view_count(baked, c->display) > 0);
    for (v = 0; v < shd_color_get_view_count(baked, c->display); ++v) {
        const char *view = shd_color_get_view_name(baked, c->display, v);
        check_bound(baked, exact, NULL, c->display, view);
        if (is_built_in) {
            check_bound(baked, exact, "ACEScg", c->display, view);
            check_bound(baked, exact, "ACES2065-1", c->display, view);
            check_bound(baked, exact, "sRGB - Texture", c->display, view);
        }
        if (g_log_lines != 0) fail_msg("%s", g_log_line);
    }
    close_paths(&paths);
}

/** Views that are one curve per channel: every half float has the exact code. */
static void test_every_half(void **state)
{
    static const char *const k_views[][2] = {
        {"sRGB", "Plain"}, {"sRGB", "Raw"}, {"Rec.709", "Plain"}, {"Rec.709", "Raw"}};
    const struct both_paths paths = open_paths(g_default_config);
    const shd_color *const baked = paths.baked, *const exact = paths.exact;
    uint16_t *half = (uint16_t *)malloc(65536 * 8);
    uint8_t *got = (uint8_t *)malloc(65536 * 4), *want = (uint8_t *)malloc(65536 * 4);
    size_t i, v;
    (void)state;
    for (i = 0; i < 65536; ++i) {
        half[4 * i] = half[4 * i + 1] = half[4 * i + 2] = (uint16_t)i;
        half[4 * i + 3] = 0x3c00;
    }
    for (v = 0; v < sizeof k_views / sizeof k_views[0]; ++v) {
        shd_image source = shd_test_image(SHD_FORMAT_RGBA16F, 256, 256, half);
        shd_image a = shd_test_image(SHD_FORMAT_RGBA8, 256, 256, got);
        shd_image b = shd_test_image(SHD_FORMAT_RGBA8_SRGB, 256, 256, want);
        shd_assert_ok(shd_color_apply_display_image(baked, &source, NULL, k_views[v][0], k_views[v][1], &a));
        shd_assert_ok(shd_color_apply_display_image(exact, &source, NULL, k_views[v][0], k_views[v][1], &b));
        for (i = 0; i < 4 * 65536; ++i) {
            if (got[i] != want[i]) {
                fail_msg("%s: half 0x%04zx is %d, exactly %d", k_views[v][1], i / 4, got[i], want[i]);
            }
        }
    }
    free(half);
    free(got);
    free(want);
    close_paths(&paths);
}

/* ---- bad numbers and alpha ---- */

static const float k_bad[] = {NAN,    INFINITY, -INFINITY, 1e30f, -1e30f, 3e38f,  1e-40f, -1e-40f, -0.0f, 0.0f,
                              -0.01f, -1.0f,    -64.0f,    65504, 1e12f,  -1e12f, 1e6f,   0.18f,   1.0f,  1e-8f};
static const float k_alpha[] = {1.0f, 0.5f, 1e-6f, 0.0f, -1.0f, 2.0f, NAN, INFINITY, 1e-40f, 0.999f};
#define BAD ((uint32_t)(sizeof k_bad / sizeof k_bad[0]))
#define ALPHAS (sizeof k_alpha / sizeof k_alpha[0])

/** All triples of bad values with all alphas: alpha as in the exact path, colour within the bound. */
static void test_bad_numbers(void **state)
{
    const struct config_row *c = (const struct config_row *)*state;
    const size_t pixels = (size_t)BAD * BAD * BAD;
    float *rgba = (float *)malloc(pixels * 16);
    uint8_t *got = (uint8_t *)malloc(pixels * 4), *want = (uint8_t *)malloc(pixels * 4);
    const struct both_paths paths = open_paths(*c->config);
    const shd_color *const baked = paths.baked, *const exact = paths.exact;
    size_t i;
    uint32_t v;
    for (i = 0; i < pixels; ++i) {
        rgba[4 * i] = k_bad[i % BAD];
        rgba[4 * i + 1] = k_bad[i / BAD % BAD];
        rgba[4 * i + 2] = k_bad[i / BAD / BAD];
        rgba[4 * i + 3] = k_alpha[i % ALPHAS];
    }
    for (v = 0; v < shd_color_get_view_count(baked, c->display); ++v) {
        const char *view = shd_color_get_view_name(baked, c->display, v);
        apply(baked, rgba, BAD, BAD * BAD, NULL, c->display, view, got);
        apply(exact, rgba, BAD, BAD * BAD, NULL, c->display, view, want);
        for (i = 0; i < 4 * pixels; ++i) {
            const float *in = rgba + i / 4 * 4;
            if (abs(got[i] - want[i]) > (i % 4 == 3 ? 0 : 3)) {
                fail_msg("%s, channel %zu of %g %g %g, %g: %d, exactly %d", view, i % 4, (double)in[0], (double)in[1],
                         (double)in[2], (double)in[3], got[i], want[i]);
            }
            if (!(in[3] > 0.0f)) assert_int_equal(got[i], 0);
        }
    }
    free(rgba);
    free(got);
    free(want);
    close_paths(&paths);
}

/* ---- the same bits ---- */

/** Hash of a framebuffer with padding through all views of a display; also of RGBA8 and RGBA8_SRGB. */
static uint64_t hash_views(const char *config, const char *display, shd_simd simd, uint32_t workers)
{
    shd_context *context = NULL;
    shd_color *color = make_color(config, simd, workers, SHD_DISPLAY_PRECISION_BAKED, &context);
    const uint32_t width = 331, height = 67;
    const size_t stride = 4 * (size_t)width + 12;
    shd_framebuffer *framebuffer = shd_test_framebuffer(context, width, height, g_rgba);
    uint8_t *out = (uint8_t *)malloc(stride * height);
    uint64_t hash = SHD_HASH_START;
    uint32_t v, y;
    for (v = 0; v < shd_color_get_view_count(color, display); ++v) {
        shd_image image = shd_test_image(v % 2 ? SHD_FORMAT_RGBA8 : SHD_FORMAT_RGBA8_SRGB, width, height, out);
        image.row_stride = stride;
        memset(out, 0xa5, stride * height);
        shd_assert_ok(
            shd_color_apply_display(color, framebuffer, display, shd_color_get_view_name(color, display, v), &image));
        for (y = 0; y < height; ++y) {
            size_t k;
            for (k = 4 * (size_t)width; k < stride; ++k) assert_int_equal(out[y * stride + k], 0xa5);
        }
        hash = shd_hash(hash, out, stride * height);
    }
    free(out);
    shd_framebuffer_release(framebuffer);
    shd_color_release(color);
    shd_context_release(context);
    return hash;
}

static void test_targets_and_workers(void **state)
{
    const struct config_row *c = (const struct config_row *)*state;
    const uint64_t want = hash_views(*c->config, c->display, SHD_SIMD_BEST, 1);
    int simd, targets = 0;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        if (!shd_simd_can_run(simd)) continue;
        ++targets;
        assert_true(hash_views(*c->config, c->display, (shd_simd)simd, 3) == want);
    }
    assert_true(targets > 0);
}

/** A pixel's bytes depend on the pixel alone: all widths up to 70, from either float format. */
static void test_widths(void **state)
{
    shd_context *context = NULL;
    shd_color *color = make_color(g_default_config, SHD_SIMD_BEST, 1, SHD_DISPLAY_PRECISION_BAKED, &context);
    uint8_t want[4 * 70], got[4 * 70 + 1];
    uint32_t width;
    (void)state;
    apply(color, g_rgba, 70, 1, NULL, "sRGB", SHD_ACES_VIEW, want);
    for (width = 1; width <= 70; ++width) {
        memset(got, 0xa5, sizeof got);
        apply(color, g_rgba, width, 1, NULL, "sRGB", SHD_ACES_VIEW, got);
        assert_memory_equal(got, want, 4 * width);
        assert_int_equal(got[4 * width], 0xa5);
    }
    shd_color_release(color);
    shd_context_release(context);
}

/** The first calls come from several threads at once. */
struct caller {
    const shd_color *color;
    uint8_t out[4 * 64];
    pthread_t thread;
};

static void *run_caller(void *argument)
{
    struct caller *caller = (struct caller *)argument;
    shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, 64, 1, g_rgba);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA8, 64, 1, caller->out);
    return shd_color_apply_display_image(caller->color, &source, NULL, NULL, NULL, &image) == SHD_OK ? NULL : caller;
}

static void test_first_calls(void **state)
{
    static struct caller callers[6];
    shd_context *context = NULL;
    shd_color *color = make_color(g_default_config, SHD_SIMD_BEST, 2, SHD_DISPLAY_PRECISION_BAKED, &context);
    size_t i;
    (void)state;
    for (i = 0; i < 6; ++i) {
        callers[i].color = color;
        assert_int_equal(pthread_create(&callers[i].thread, NULL, run_caller, &callers[i]), 0);
    }
    for (i = 0; i < 6; ++i) {
        void *failed = NULL;
        pthread_join(callers[i].thread, &failed);
        assert_null(failed);
        assert_memory_equal(callers[i].out, callers[0].out, sizeof callers[0].out);
    }
    shd_color_release(color);
    shd_context_release(context);
}

/* ---- views that stay exact ---- */

/** Pixels are those of the exact path, and the log has one line about it. */
static void test_unbaked(void **state)
{
    const struct view_row *c = (const struct view_row *)*state;
    const struct both_paths paths = open_paths(g_config);
    const shd_color *const baked = paths.baked, *const exact = paths.exact;
    uint8_t *got = (uint8_t *)malloc(4 * PIXELS), *want = (uint8_t *)malloc(4 * PIXELS);
    int round;
    g_log_lines = 0;
    apply(exact, g_rgba, SIDE, SIDE, NULL, "unbaked", c->name, want);
    assert_int_equal(g_log_lines, 0);
    for (round = 0; round < 2; ++round) {
        memset(got, 0, 4 * PIXELS);
        apply(baked, g_rgba, SIDE, SIDE, NULL, "unbaked", c->name, got);
        assert_memory_equal(got, want, 4 * PIXELS);
        assert_int_equal(g_log_lines, 1);
    }
    assert_non_null(strstr(g_log_line, c->name));
    assert_non_null(strstr(g_log_line, "exact path"));
    print_message("%s\n", g_log_line);
    free(got);
    free(want);
    close_paths(&paths);
}

/** Other formats do not depend on the precision, and a baked handle gives them without baking. */
static void test_other_formats(void **state)
{
    static const shd_format k_formats[] = {SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA32F};
    const struct both_paths paths = open_paths(g_default_config);
    const shd_color *const baked = paths.baked, *const exact = paths.exact;
    static unsigned char got[4096 * 16], want[4096 * 16];
    size_t f;
    (void)state;
    for (f = 0; f < 3; ++f) {
        shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, 64, 64, g_rgba);
        shd_image a = shd_test_image(k_formats[f], 64, 64, got), b = shd_test_image(k_formats[f], 64, 64, want);
        shd_assert_ok(shd_color_apply_display_image(baked, &source, NULL, NULL, NULL, &a));
        shd_assert_ok(shd_color_apply_display_image(exact, &source, NULL, NULL, NULL, &b));
        assert_memory_equal(got, want, 4096 * shd_format_size(k_formats[f]));
    }
    close_paths(&paths);
}

static void test_bad_precision(void **state)
{
    static const uint32_t k_values[] = {2, 77, 0x7fffffffu, 0xffffffffu};
    shd_context *context = NULL;
    size_t i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (i = 0; i < sizeof k_values / sizeof k_values[0]; ++i) {
        shd_color_desc desc = shd_color_desc_default();
        shd_color *color = (shd_color *)&desc;
        char message[64];
        desc.config_text = g_default_config;
        memcpy(&desc.display_precision, &k_values[i], sizeof k_values[i]);
        snprintf(message, sizeof message, "color.display_precision: %u", k_values[i]);
        shd_assert_result("precision", shd_color_create(context, &desc, &color), SHD_ERROR_INVALID_ARGUMENT, message);
        assert_null(color);
    }
    shd_context_release(context);
}

/* ---- allocations ---- */

/** Each allocation of a bake fails in turn: an error, no leak, and the next call works. Prints the bake's memory. */
static void test_allocations(void **state)
{
    shd_fault_allocator memory;
    shd_context_desc desc;
    shd_context *context = NULL;
    shd_color *color = NULL;
    shd_color_desc color_desc = shd_color_desc_default();
    uint8_t out[4];
    shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, g_rgba);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA8, 1, 1, out);
    size_t n = 0, before, calls = 0;
    shd_result result = SHD_ERROR_INTERNAL;
    (void)state;
    memset(&memory, 0, sizeof memory);
    desc = shd_fault_context_desc(&memory);
    shd_assert_ok(shd_context_create(&desc, &context));
    color_desc.config_text = g_default_config;
    shd_assert_ok(shd_color_create(context, &color_desc, &color));
    before = memory.live_bytes;
    while (result != SHD_OK) {
        shd_fault_arm(&memory, ++n, 0);
        result = shd_color_apply_display_image(color, &source, NULL, "sRGB", SHD_ACES_VIEW, &image);
        calls = memory.calls;
        if (result == SHD_OK) break;
        shd_assert_result("bake", result, SHD_ERROR_OUT_OF_MEMORY, "");
        assert_int_equal(memory.live_bytes, before);
        if (n > 100) fail_msg("allocation %zu still fails", n);
    }
    assert_true(n > 3 && calls == n - 1);
    print_message("%zu bytes in %zu allocations\n", memory.live_bytes - before, calls);
    assert_true(memory.live_bytes - before < 1 << 20);
    shd_fault_arm(&memory, 1, 1);
    shd_assert_ok(shd_color_apply_display_image(color, &source, NULL, "sRGB", SHD_ACES_VIEW, &image));
    shd_fault_arm(&memory, 0, 0);
    shd_color_release(color);
    shd_context_release(context);
    shd_assert_all_freed("bake", &memory);
}

static char g_unbaked_names[UNBAKED_VIEWS][64];

int main(void)
{
    void *state = NULL;
    size_t i;
    int failed;
    unsetenv("OCIO");
    if (io_make_folder(&state) != 0) return 1;
    g_rgba = (float *)malloc(sizeof(float) * 4 * PIXELS);
    make_colors(g_rgba);
    write_tables();
    g_config = make_views_config();
    g_views_config = g_config;
    g_default_config = shd_color_default_config();
    ADD_ROWS(k_configs, test_bound);
    add("bound/every_half", test_every_half, NULL);
    ADD_ROWS(k_bad_configs, test_bad_numbers);
    ADD_ROWS(k_bits_configs, test_targets_and_workers);
    add("bits/widths", test_widths, NULL);
    add("bits/first_calls", test_first_calls, NULL);
    for (i = 0; i < UNBAKED_VIEWS; ++i) {
        snprintf(g_unbaked_names[i], sizeof g_unbaked_names[i], "unbaked/%s", k_unbaked_views[i].name);
        add(g_unbaked_names[i], test_unbaked, &k_unbaked_views[i]);
    }
    add("precision/other_formats", test_other_formats, NULL);
    add("precision/bad", test_bad_precision, NULL);
    add("allocations", test_allocations, NULL);
    failed = _cmocka_run_group_tests("api.color_baked", g_tests, g_count, NULL, NULL);
    free(g_config);
    free(g_rgba);
    return io_remove_folder(&state) == 0 ? failed : 1;
}
