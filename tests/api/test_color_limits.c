/* SPDX-License-Identifier: MIT */
/* Colour transforms: bad values, refusals, threads. */
#define _POSIX_C_SOURCE 200809L
#include "support/color.h"

#include <pthread.h>

#include <shd/shd.h>

static const shd_format k_formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA16F,
                                       SHD_FORMAT_RGBA32F};
#define FORMAT_COUNT (sizeof k_formats / sizeof k_formats[0])

static shd_context *g_context;
static shd_color *g_color;

static int set_up(void **state)
{
    (void)state;
    g_color = shd_test_color(2, &g_context);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    shd_color_release(g_color);
    shd_context_release(g_context);
    return 0;
}

/** One grey or coloured value through a transform, as floats. */
static void apply_one(const char *from, const char *display, const char *view, const float in[4], float out[4])
{
    shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, (void *)(uintptr_t)in);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, out);
    shd_assert_ok(shd_color_apply_display_image(g_color, &source, from, display, view, &image));
}

/* ---- bad values ---- */

static const char *const k_views[][2] = {{"sRGB", SHD_ACES_VIEW},    {"sRGB", "Plain"},    {"sRGB", "Raw"},
                                         {"Rec.709", SHD_ACES_VIEW}, {"Rec.709", "Plain"}, {"Rec.709", "Raw"}};
static const char *const k_spaces[] = {"Linear Rec.709", "ACEScg", "ACES2065-1", "sRGB - Texture", "Raw"};
static const float k_bad[] = {NAN,    INFINITY, -INFINITY, 1e30f, -1e30f, 3e38f, -3e38f, 1e-40f, -1e-40f, -0.0f,
                              -0.01f, -1.0f,    65504.0f,  1e12f, 1e6f,   0.18f, 1.0f,   -1e6f,  1e-8f,   2.0f};
#define BAD_COUNT (sizeof k_bad / sizeof k_bad[0])

/** All triples of bad values, through every display, view and format: finite. */
static void test_bad_values(void **state)
{
    const uint32_t side = (uint32_t)BAD_COUNT;
    const size_t pixels = BAD_COUNT * BAD_COUNT * BAD_COUNT;
    float *rgba = (float *)malloc(pixels * 16), *out = (float *)malloc(pixels * 16);
    shd_framebuffer *framebuffer;
    size_t i, v, f;
    (void)state;
    for (i = 0; i < pixels; ++i) {
        rgba[4 * i] = k_bad[i % side];
        rgba[4 * i + 1] = k_bad[i / side % side];
        rgba[4 * i + 2] = k_bad[i / side / side];
        rgba[4 * i + 3] = i % 7 == 6 ? k_bad[i % 5] : 1.0f;
    }
    framebuffer = shd_test_framebuffer(g_context, side, side * side, rgba);
    for (v = 0; v < sizeof k_views / sizeof k_views[0]; ++v) {
        for (f = 0; f < FORMAT_COUNT; ++f) {
            shd_image image = shd_test_image(k_formats[f], side, side * side, out);
            shd_assert_ok(shd_color_apply_display(g_color, framebuffer, k_views[v][0], k_views[v][1], &image));
            for (i = 0; i < pixels * 4; ++i) {
                if (!isfinite(shd_test_channel(&image, i))) {
                    fail_msg("%s %s format %d: pixel %zu is not finite", k_views[v][0], k_views[v][1],
                             (int)k_formats[f], i / 4);
                }
            }
        }
    }
    shd_framebuffer_release(framebuffer);
    for (v = 0; v < 25; ++v) {
        shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, side, side * side, out);
        memcpy(out, rgba, pixels * 16);
        shd_assert_ok(shd_color_convert(g_color, &image, k_spaces[v / 5], k_spaces[v % 5]));
        for (i = 0; i < pixels * 4; ++i) {
            if (i % 4 != 3 && !isfinite(out[i])) {
                fail_msg("%s to %s: pixel %zu is not finite", k_spaces[v / 5], k_spaces[v % 5], i / 4);
            }
        }
    }
    free(rgba);
    free(out);
}

/** Single bad values give the results that the header documents. */
static void test_bad_policy(void **state)
{
    float out[4];
    const float nan_red[4] = {NAN, 0.5f, 0.5f, 1.0f}, huge[4] = {1e30f, 1e30f, 1e30f, 1.0f};
    const float infinite[4] = {INFINITY, -INFINITY, 0.0f, 1.0f};
    (void)state;
    apply_one(NULL, "sRGB", "Plain", nan_red, out);
    shd_assert_close("nan", 0, out[0], 0.0, 1e-6, 0.0);
    shd_assert_close("nan", 1, out[1], shd_srgb_encode(0.5), 2e-5, 0.0);
    apply_one(NULL, "sRGB", SHD_ACES_VIEW, huge, out);
    assert_true(out[0] >= 1.0f && out[1] >= 1.0f && out[2] >= 1.0f);
    apply_one(NULL, "sRGB", "Raw", infinite, out);
    assert_true(out[0] == 1e12f && out[1] == -1e12f && out[2] == 0.0f);
}

/**
 * All 65536 half floats as grey, through every view: the output is finite, and a brighter input never gives a darker
 * output.
 */
static void test_all_halves(void **state)
{
    uint16_t *in = (uint16_t *)malloc(65536 * 8);
    float *out = (float *)malloc(65536 * 16);
    shd_image source = shd_test_image(SHD_FORMAT_RGBA16F, 256, 256, in);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 256, 256, out);
    size_t i, v;
    (void)state;
    for (i = 0; i < 65536; ++i) {
        in[4 * i] = in[4 * i + 1] = in[4 * i + 2] = (uint16_t)i;
        in[4 * i + 3] = 0x3c00;
    }
    for (v = 0; v < sizeof k_views / sizeof k_views[0]; ++v) {
        shd_assert_ok(shd_color_apply_display_image(g_color, &source, NULL, k_views[v][0], k_views[v][1], &image));
        for (i = 0; i < 65536; ++i) {
            assert_true(isfinite(out[4 * i]) && isfinite(out[4 * i + 1]) && isfinite(out[4 * i + 2]));
            if (i > 0 && i < 0x7c00 && out[4 * i + 1] < out[4 * i - 3] - 1e-5f) {
                fail_msg("%s: half 0x%04zx gives %g after %g", k_views[v][1], i, (double)out[4 * i + 1],
                         (double)out[4 * i - 3]);
            }
        }
    }
    free(in);
    free(out);
}

/* ---- refusals ---- */

struct refuse_case {
    const char *name;
    const char *display;
    const char *view;
    void (*edit)(shd_image *image);
    const char *message;
    shd_result expected;
};

static void edit_nothing(shd_image *i) { (void)i; }
static void edit_width(shd_image *i) { i->width = 3; }
static void edit_height(shd_image *i) { i->height = 1; }
static void edit_zero(shd_image *i) { i->width = 0; }
static void edit_huge(shd_image *i) { i->width = 65537; }
static void edit_pixels(shd_image *i) { i->pixels = NULL; }
static void edit_format(shd_image *i) { i->format = SHD_FORMAT_NONE; }
static void edit_format_unknown(shd_image *i) { i->format = (shd_format)4711; }
static void edit_r8(shd_image *i) { i->format = SHD_FORMAT_R8; }
static void edit_stride(shd_image *i) { i->row_stride = 31; }
static void edit_stride_odd(shd_image *i) { i->row_stride = 34; }
static void edit_stride_huge(shd_image *i) { i->row_stride = SIZE_MAX / 2; }
static void edit_misaligned(shd_image *i) { i->pixels = (char *)i->pixels + 2; }
static void edit_size(shd_image *i) { i->struct_size = 4; }

#define BAD SHD_ERROR_INVALID_ARGUMENT
static const struct refuse_case k_refuse[] = {
    {"refuse/nothing", "sRGB", "Plain", edit_nothing, "", SHD_OK},
    {"refuse/display", "Screen %s %n", NULL, edit_nothing, "display: no 'Screen %s %n'; there are 'sRGB', 'Rec.709'",
     SHD_ERROR_NOT_FOUND},
    {"refuse/display_empty", "", NULL, edit_nothing, "display: no ''", SHD_ERROR_NOT_FOUND},
    {"refuse/view", NULL, "%n%s", edit_nothing,
     "view: no '%n%s' on display 'sRGB'; there are '" SHD_ACES_VIEW "', 'Plain', 'Raw'", SHD_ERROR_NOT_FOUND},
    {"refuse/view_not_utf8", "Rec.709", "\xff\xc0", edit_nothing, "on display 'Rec.709'", SHD_ERROR_NOT_FOUND},
    {"refuse/width", NULL, NULL, edit_width, "out: 3 x 2 is not the input's 2 x 2", BAD},
    {"refuse/height", NULL, NULL, edit_height, "out: 2 x 1 is not the input's 2 x 2", BAD},
    {"refuse/zero_width", NULL, NULL, edit_zero, "out.width: 0 is not in 1..65536", BAD},
    {"refuse/huge_width", NULL, NULL, edit_huge, "out.width: 65537", BAD},
    {"refuse/null_pixels", NULL, NULL, edit_pixels, "out.pixels: NULL", BAD},
    {"refuse/no_format", NULL, NULL, edit_format, "out.format: 0", BAD},
    {"refuse/unknown_format", NULL, NULL, edit_format_unknown, "out.format: 4711", BAD},
    {"refuse/one_channel", NULL, NULL, edit_r8, "out.format: 1 has not four channels", BAD},
    {"refuse/stride_small", NULL, NULL, edit_stride, "out.row_stride: 31 is below 32", BAD},
    {"refuse/stride_misaligned", NULL, NULL, edit_stride_odd, "not aligned to a channel of 4 bytes", BAD},
    {"refuse/stride_huge", NULL, NULL, edit_stride_huge, "exceeds the address space", BAD},
    {"refuse/pixels_misaligned", NULL, NULL, edit_misaligned, "not aligned to a channel of 4 bytes", BAD},
    {"refuse/struct_size", NULL, NULL, edit_size, "out.struct_size: 4 is below", BAD},
};

static void test_refuse(void **state)
{
    const struct refuse_case *c = (const struct refuse_case *)*state;
    const float rgba[16] = {0.18f, 0.18f, 0.18f, 1.0f};
    float out[17], before[17];
    shd_framebuffer *framebuffer = shd_test_framebuffer(g_context, 2, 2, rgba);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 2, 2, out);
    shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, 2, 2, (void *)(uintptr_t)rgba);
    memset(out, 0x5a, sizeof out);
    memcpy(before, out, sizeof out);
    c->edit(&image);
    shd_assert_result(c->name, shd_color_apply_display(g_color, framebuffer, c->display, c->view, &image), c->expected,
                      c->message);
    if (c->expected != SHD_OK) assert_memory_equal(out, before, sizeof out);
    shd_assert_result(c->name, shd_color_apply_display_image(g_color, &source, NULL, c->display, c->view, &image),
                      c->expected, c->message);
    if (c->expected != SHD_OK) assert_memory_equal(out, before, sizeof out);
    image = shd_test_image(SHD_FORMAT_RGBA32F, 2, 2, out);
    shd_assert_ok(shd_color_apply_display(g_color, framebuffer, "sRGB", "Plain", &image));
    shd_assert_close("afterwards", 0, out[0], 0.4614, 1e-4, 0.0);
    shd_framebuffer_release(framebuffer);
}

static void test_refuse_arguments(void **state)
{
    float pixel[16] = {0};
    uint8_t bytes[4];
    char *name = (char *)malloc((1 << 20) + 1);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, pixel);
    shd_image shifted = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, pixel + 1);
    shd_image other_format = shd_test_image(SHD_FORMAT_RGBA16F, 1, 1, pixel);
    shd_image eight = shd_test_image(SHD_FORMAT_RGBA8, 1, 1, bytes);
    shd_framebuffer *framebuffer = shd_test_framebuffer(g_context, 1, 1, pixel), *foreign;
    shd_context *other = NULL;
    const shd_color *not_color = (const shd_color *)(const void *)framebuffer;
    const shd_framebuffer *not_framebuffer = (const shd_framebuffer *)(const void *)g_color;
    (void)state;
    memset(name, 'x', 1 << 20);
    name[1 << 20] = '\0';
    shd_assert_ok(shd_context_create(NULL, &other));
    foreign = shd_test_framebuffer(other, 1, 1, pixel);
    shd_assert_result("null color", shd_color_apply_display(NULL, framebuffer, NULL, NULL, &image), BAD, "color: NULL");
    shd_assert_result("not color", shd_color_apply_display(not_color, framebuffer, NULL, NULL, &image), BAD, "color: ");
    shd_assert_result("null fb", shd_color_apply_display(g_color, NULL, NULL, NULL, &image), BAD, "framebuffer: NULL");
    shd_assert_result("not fb", shd_color_apply_display(g_color, not_framebuffer, NULL, NULL, &image), BAD,
                      "framebuffer");
    shd_assert_result("foreign", shd_color_apply_display(g_color, foreign, NULL, NULL, &image), BAD, "another context");
    shd_assert_result("null out", shd_color_apply_display(g_color, framebuffer, NULL, NULL, NULL), BAD, "out: NULL");
    shd_assert_result("null in", shd_color_apply_display_image(g_color, NULL, NULL, NULL, NULL, &image), BAD,
                      "in: NULL");
    shd_assert_result("8-bit in", shd_color_apply_display_image(g_color, &eight, NULL, NULL, NULL, &image), BAD,
                      "in.format: 2 is not RGBA16F or RGBA32F");
    shd_assert_result("overlap", shd_color_apply_display_image(g_color, &image, NULL, NULL, NULL, &shifted), BAD,
                      "overlaps");
    shd_assert_result("overlap", shd_color_apply_display_image(g_color, &image, NULL, NULL, NULL, &other_format), BAD,
                      "overlaps");
    shd_assert_result("from", shd_color_apply_display_image(g_color, &image, "Nowhere", NULL, NULL, &image),
                      SHD_ERROR_NOT_FOUND, "from_space: no colour space 'Nowhere'; there are");
    shd_assert_result("null from", shd_color_convert(g_color, &image, NULL, NULL), BAD, "from_space: NULL");
    shd_assert_result("long from", shd_color_convert(g_color, &image, name, NULL), SHD_ERROR_NOT_FOUND, "there are");
    shd_assert_result("to", shd_color_convert(g_color, &image, "ACEScg", "%s%n"), SHD_ERROR_NOT_FOUND,
                      "to_space: no colour space '%s%n'");
    shd_assert_result("8-bit", shd_color_convert(g_color, &eight, "ACEScg", NULL), BAD, "in_out.format: 2");
    shd_assert_result("null image", shd_color_convert(g_color, NULL, "ACEScg", NULL), BAD, "in_out: NULL");
    shd_assert_ok(shd_color_convert(g_color, &image, "ACEScg", NULL));
    free(name);
    shd_framebuffer_release(framebuffer);
    shd_framebuffer_release(foreign);
    shd_context_release(other);
}

/* ---- threads ---- */

enum { SIDE = 257 };

static uint64_t hash_of_view(shd_color *color, const shd_image *source, size_t view)
{
    uint8_t *out = (uint8_t *)malloc(SIDE * SIDE * 4);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA8, SIDE, SIDE, out);
    const shd_result result =
        shd_color_apply_display_image(color, source, NULL, k_views[view][0], k_views[view][1], &image);
    const uint64_t hash = result == SHD_OK ? shd_hash(SHD_HASH_START, out, SIDE * SIDE * 4) : 0;
    free(out);
    return hash;
}

static float *make_source(shd_image *source)
{
    float *rgba = (float *)malloc(SIDE * SIDE * 16);
    size_t i;
    for (i = 0; i < SIDE * SIDE * 4; ++i) rgba[i] = i % 4 == 3 ? 1.0f : shd_test_value(i);
    *source = shd_test_image(SHD_FORMAT_RGBA32F, SIDE, SIDE, rgba);
    return rgba;
}

static void test_worker_counts(void **state)
{
    uint64_t hashes[2][6];
    shd_image source;
    float *rgba = make_source(&source);
    size_t w, v;
    (void)state;
    for (w = 0; w < 2; ++w) {
        shd_context *context = NULL;
        shd_color *color = shd_test_color(w == 0 ? 1 : 4, &context);
        for (v = 0; v < 6; ++v) hashes[w][v] = hash_of_view(color, &source, v);
        shd_color_release(color);
        shd_context_release(context);
    }
    for (v = 0; v < 6; ++v) {
        assert_true(hashes[0][v] != 0);
        assert_true(hashes[0][v] == hashes[1][v]);
    }
    free(rgba);
}

struct worker {
    shd_color *color;
    const shd_image *source;
    size_t view;
    uint64_t hash;
};

static void *run_worker(void *data)
{
    struct worker *worker = (struct worker *)data;
    int i;
    for (i = 0; i < 3; ++i) {
        shd_color_retain(worker->color);
        worker->hash = hash_of_view(worker->color, worker->source, worker->view);
        shd_color_release(worker->color);
    }
    return NULL;
}

/** Eight threads use a handle whose cache is empty. */
static void test_concurrent(void **state)
{
    shd_context *context = NULL;
    shd_color *color = shd_test_color(2, &context);
    shd_image source;
    float *rgba = make_source(&source);
    pthread_t threads[8];
    struct worker workers[8];
    size_t i;
    (void)state;
    for (i = 0; i < 8; ++i) {
        workers[i] = (struct worker){color, &source, i % 6, 0};
        assert_int_equal(pthread_create(&threads[i], NULL, run_worker, &workers[i]), 0);
    }
    for (i = 0; i < 8; ++i) pthread_join(threads[i], NULL);
    for (i = 0; i < 8; ++i) assert_true(workers[i].hash == hash_of_view(g_color, &source, i % 6));
    free(rgba);
    shd_color_release(color);
    shd_context_release(context);
}

static shd_result failing_parallel_for(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    int *fail = (int *)user_data;
    uint32_t i;
    if (*fail) return SHD_ERROR_IO;
    for (i = 0; i < count; ++i) task(i, 0, task_data);
    return SHD_OK;
}

static void test_executor_fails(void **state)
{
    int fail = 1;
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    shd_color *color = NULL;
    shd_image image;
    float *pixels = make_source(&image);
    (void)state;
    pixels[0] = 0.18f;
    desc.executor.parallel_for = failing_parallel_for;
    desc.executor.user_data = &fail;
    desc.executor.worker_count = 1;
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_assert_ok(shd_color_create(context, NULL, &color));
    shd_assert_result("executor", shd_color_apply_display_image(color, &image, NULL, "sRGB", "Plain", &image),
                      SHD_ERROR_CALLBACK, "");
    fail = 0;
    shd_assert_ok(shd_color_apply_display_image(color, &image, NULL, "sRGB", "Plain", &image));
    shd_assert_close("afterwards", 0, pixels[0], 0.4614, 1e-4, 0.0);
    free(pixels);
    shd_color_release(color);
    shd_context_release(context);
}

/* ---- memory ---- */

struct budget {
    long allowed; /* number of allocations before one fails; negative = none fails */
    long live;
};

static void *budget_allocate(size_t size, size_t alignment, void *user_data)
{
    struct budget *budget = (struct budget *)user_data;
    void *memory = NULL;
    if (budget->allowed == 0) return NULL;
    if (budget->allowed > 0) --budget->allowed;
    if (alignment < sizeof(void *)) alignment = sizeof(void *);
    if (posix_memalign(&memory, alignment, size) != 0) return NULL;
    ++budget->live;
    return memory;
}

static void budget_free(void *memory, size_t size, size_t alignment, void *user_data)
{
    (void)size;
    (void)alignment;
    --((struct budget *)user_data)->live;
    free(memory);
}

/**
 * The n-th allocation from the host fails, for every n: the result is out of memory, nothing leaks, and the next call
 * works.
 */
static void test_memory(void **state)
{
    long allowed;
    int succeeded = 0;
    (void)state;
    for (allowed = 0; !succeeded && allowed < 1000; ++allowed) {
        struct budget budget = {-1, 0};
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = NULL;
        shd_color *color = NULL;
        shd_result result;
        float pixel[4] = {0.18f, 0.18f, 0.18f, 1.0f};
        shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, pixel);
        desc.worker_count = 1;
        desc.allocator.allocate = budget_allocate;
        desc.allocator.free = budget_free;
        desc.allocator.user_data = &budget;
        shd_assert_ok(shd_context_create(&desc, &context));
        budget.allowed = allowed;
        result = shd_color_create(context, NULL, &color);
        if (result == SHD_OK) result = shd_color_apply_display_image(color, &image, NULL, "sRGB", "Plain", &image);
        if (result != SHD_OK) {
            shd_assert_result("memory", result, SHD_ERROR_OUT_OF_MEMORY, "memory");
            budget.allowed = -1;
            if (!color) shd_assert_ok(shd_color_create(context, NULL, &color));
            shd_assert_ok(shd_color_apply_display_image(color, &image, NULL, "sRGB", "Plain", &image));
        } else {
            succeeded = 1;
        }
        shd_assert_close("pixel", 0, pixel[0], 0.4614, 1e-4, 0.0);
        shd_color_release(color);
        shd_context_release(context);
        assert_int_equal(budget.live, 0);
    }
    assert_true(succeeded && allowed > 1);
}

#define ADD_ALL(cases, body)                                                              \
    for (i = 0; i < sizeof cases / sizeof cases[0]; ++i) tests[n++] = (struct CMUnitTest) \
        {                                                                                 \
            cases[i].name, body, NULL, NULL, (void *)(uintptr_t)&cases[i]                 \
        }
#define ADD(name, body) \
    tests[n++] = (struct CMUnitTest) { name, body, NULL, NULL, NULL }

int main(void)
{
    struct CMUnitTest tests[64];
    size_t n = 0, i;
    unsetenv("OCIO");
    ADD_ALL(k_refuse, test_refuse);
    ADD("refuse/arguments", test_refuse_arguments);
    ADD("bad/values", test_bad_values);
    ADD("bad/policy", test_bad_policy);
    ADD("bad/all_halves", test_all_halves);
    ADD("threads/worker_counts", test_worker_counts);
    ADD("threads/concurrent", test_concurrent);
    ADD("threads/executor_fails", test_executor_fails);
    ADD("memory/every_allocation_fails", test_memory);
    return _cmocka_run_group_tests("api.color_limits", tests, n, set_up, tear_down);
}
