/* SPDX-License-Identifier: MIT */
/* Colour transforms: numbers, alpha, formats, sizes. */
#define _POSIX_C_SOURCE 200809L
#include "support/color.h"

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

/* ---- numbers ---- */

static void test_srgb_codes(void **state)
{
    float linear[256 * 4];
    uint8_t out[256 * 4];
    shd_framebuffer *framebuffer;
    size_t i, f;
    (void)state;
    for (i = 0; i < 256; ++i) {
        linear[4 * i] = (float)shd_srgb_decode((double)i / 255.0);
        linear[4 * i + 1] = (float)shd_srgb_decode((double)(255 - i) / 255.0);
        linear[4 * i + 2] = 0.0f;
        linear[4 * i + 3] = 1.0f;
    }
    framebuffer = shd_test_framebuffer(g_context, 16, 16, linear);
    for (f = 0; f < 2; ++f) {
        shd_image image = shd_test_image(k_formats[f], 16, 16, out);
        shd_assert_ok(shd_color_apply_display(g_color, framebuffer, "sRGB", "Plain", &image));
        for (i = 0; i < 256; ++i) {
            assert_int_equal(out[4 * i], i);
            assert_int_equal(out[4 * i + 1], 255 - i);
            assert_int_equal(out[4 * i + 2], 0);
            assert_int_equal(out[4 * i + 3], 255);
        }
    }
    shd_framebuffer_release(framebuffer);
}

/** Compares a curve with its formula in double, from 0 to values above 1. */
struct curve_case {
    const char *name;
    const char *from;
    const char *display;
    const char *view;
    double (*want)(double x);
    double tolerance;
};

static double bt1886(double x) { return pow(x, 1.0 / 2.4); }
static double same(double x) { return x; }

static const struct curve_case k_curves[] = {
    {"curve/plain_srgb", NULL, "sRGB", "Plain", shd_srgb_encode, 2e-5},
    {"curve/plain_rec709", NULL, "Rec.709", "Plain", bt1886, 1e-5},
    {"curve/raw_srgb", NULL, "sRGB", "Raw", same, 0.0},
    {"curve/raw_rec709", NULL, "Rec.709", "Raw", same, 0.0},
    {"curve/srgb_texture_to_srgb", "sRGB - Texture", "sRGB", "Plain", same, 3e-5},
    {"curve/acescg_grey_to_srgb", "ACEScg", "sRGB", "Plain", shd_srgb_encode, 2e-5},
    {"curve/aces2065_grey_to_srgb", "ACES2065-1", "sRGB", "Plain", shd_srgb_encode, 2e-5},
};

static void test_curve(void **state)
{
    const struct curve_case *c = (const struct curve_case *)*state;
    int i;
    for (i = 0; i <= 2048; ++i) {
        const float x = (float)i / 1024.0f;
        const float in[4] = {x, x, x, 1.0f};
        float out[4];
        int k;
        apply_one(c->from, c->display, c->view, in, out);
        for (k = 0; k < 3; ++k) {
            shd_assert_close(c->name, (size_t)i, out[k], c->want(x), c->tolerance, c->tolerance);
        }
    }
}

/** Single published numbers. ACES: the Academy output transform SDR 1.0 maps 0.18 to 0.356 in sRGB code values. */
struct figure_case {
    const char *name;
    const char *from;
    const char *view;
    float in[3];
    double out[3];
    double tolerance;
};

static const struct figure_case k_figures[] = {
    {"figure/plain_grey", NULL, "Plain", {0.18f, 0.18f, 0.18f}, {0.4614, 0.4614, 0.4614}, 1e-4},
    {"figure/aces_grey", "ACEScg", SHD_ACES_VIEW, {0.18f, 0.18f, 0.18f}, {0.356, 0.356, 0.356}, 5e-4},
    {"figure/aces_grey_rec709", NULL, SHD_ACES_VIEW, {0.18f, 0.18f, 0.18f}, {0.356, 0.356, 0.356}, 5e-4},
    {"figure/aces_black", NULL, SHD_ACES_VIEW, {0.0f, 0.0f, 0.0f}, {0.0, 0.0, 0.0}, 1e-6},
    {"figure/aces_clips_bright", NULL, SHD_ACES_VIEW, {1e4f, 1e4f, 1e4f}, {1.0, 1.0, 1.0}, 0.05},
    {"figure/acescg_red", "ACEScg", "Raw", {1.0f, 0.0f, 0.0f}, {1.0, 0.0, 0.0}, 0.0},
};

static void test_figure(void **state)
{
    const struct figure_case *c = (const struct figure_case *)*state;
    const float in[4] = {c->in[0], c->in[1], c->in[2], 1.0f};
    float out[4];
    size_t k;
    apply_one(c->from, "sRGB", c->view, in, out);
    for (k = 0; k < 3; ++k) shd_assert_close(c->name, k, out[k], c->out[k], c->tolerance, 0.0);
    assert_true(out[3] == 1.0f);
}

/** Rec.709 primaries in AP1, Bradford-adapted from D65 to the ACES white. */
struct convert_case {
    const char *name;
    const char *from;
    const char *to;
    float in[3];
    double out[3];
    double tolerance;
};

static const struct convert_case k_converts[] = {
    {"convert/rec709_red_to_acescg", "Linear Rec.709", "ACEScg", {1, 0, 0}, {0.613097, 0.070194, 0.020616}, 2e-6},
    {"convert/rec709_green_to_acescg", "Linear Rec.709", "ACEScg", {0, 1, 0}, {0.339523, 0.916354, 0.109570}, 2e-6},
    {"convert/rec709_blue_to_acescg", "Linear Rec.709", "ACEScg", {0, 0, 1}, {0.047379, 0.013452, 0.869815}, 2e-6},
    {"convert/white", "Linear Rec.709", "ACES2065-1", {1, 1, 1}, {1, 1, 1}, 2e-6},
    {"convert/role", "scene_linear", "ACEScg", {1, 0, 0}, {0.613097, 0.070194, 0.020616}, 2e-6},
    {"convert/to_working_space", "ACEScg", NULL, {0.613097f, 0.070194f, 0.020616f}, {1, 0, 0}, 3e-6},
    {"convert/texture", "sRGB - Texture", NULL, {0.5f, 0.04f, 1.0f}, {0.2140411, 0.0030960, 1.0}, 2e-6},
    {"convert/texture_back", NULL, "sRGB - Texture", {0.2140411f, 0.0030960f, 1.0f}, {0.5, 0.04, 1.0}, 2e-5},
    {"convert/texture_negative", "sRGB - Texture", NULL, {-0.5f, -0.04f, -1}, {-0.2140411, -0.0030960, -1}, 2e-6},
    {"convert/same", "ACEScg", "ACEScg", {0.1f, -2.0f, 3e6f}, {0.1f, -2.0, 3e6}, 0.0},
    {"convert/raw", "Raw", "ACEScg", {0.1f, -2.0f, 3e6f}, {0.1f, -2.0, 3e6}, 0.0},
};

static void test_convert(void **state)
{
    const struct convert_case *c = (const struct convert_case *)*state;
    float pixel[4] = {c->in[0], c->in[1], c->in[2], -7.0f};
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, pixel);
    size_t k;
    shd_assert_ok(shd_color_convert(g_color, &image, c->from ? c->from : "scene_linear", c->to));
    for (k = 0; k < 3; ++k) shd_assert_close(c->name, k, pixel[k], c->out[k], c->tolerance, 0.0);
    assert_true(pixel[3] == -7.0f);
}

static void test_convert_ramp(void **state)
{
    float ramp[1025 * 4];
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 205, 5, ramp);
    size_t i;
    (void)state;
    for (i = 0; i < 1025 * 4; ++i) ramp[i] = (float)(i / 4) / 1024.0f;
    shd_assert_ok(shd_color_convert(g_color, &image, "sRGB - Texture", "Linear Rec.709"));
    for (i = 0; i < 1025; ++i) {
        const float x = (float)i / 1024.0f;
        shd_assert_close("decode", i, ramp[4 * i + 1], shd_srgb_decode(x), 1e-6, 3e-5);
        assert_true(ramp[4 * i + 3] == x);
    }
}

/** Every half float except NaN and infinities keeps its bits in a conversion between equal spaces. */
static void test_convert_halves(void **state)
{
    uint16_t *pixels = (uint16_t *)malloc(65536 * 4 * sizeof *pixels);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA16F, 256, 256, pixels);
    uint32_t i;
    (void)state;
    for (i = 0; i < 65536 * 4; ++i) pixels[i] = (uint16_t)(i / 4);
    shd_assert_ok(shd_color_convert(g_color, &image, "Raw", "ACEScg"));
    for (i = 0; i < 65536; ++i) {
        const double value = shd_test_half((uint16_t)i);
        uint16_t want = (uint16_t)i;
        if (isnan(value)) want = 0;
        if (isinf(value)) want = value > 0 ? 0x7bff : 0xfbff;
        if (pixels[4 * i] != want || pixels[4 * i + 2] != want || pixels[4 * i + 3] != i) {
            fail_msg("half 0x%04x: got 0x%04x 0x%04x alpha 0x%04x", i, pixels[4 * i], pixels[4 * i + 2],
                     pixels[4 * i + 3]);
        }
    }
    free(pixels);
}

/* ---- alpha ---- */

struct alpha_case {
    const char *name;
    float in[4]; /* premultiplied */
    double linear[3];
    double alpha;
};

static const struct alpha_case k_alpha[] = {
    {"alpha/opaque", {0.18f, 0.5f, 1.0f, 1.0f}, {0.18, 0.5, 1.0}, 1.0},
    {"alpha/half", {0.09f, 0.25f, 0.5f, 0.5f}, {0.18, 0.5, 1.0}, 0.5},
    {"alpha/thin", {0.18e-6f, 0.5e-6f, 1e-6f, 1e-6f}, {0.18, 0.5, 1.0}, 1e-6},
    {"alpha/denormal", {1e-40f, 0.0f, 1e-40f, 1e-40f}, {1.0, 0.0, 1.0}, 1e-40},
    {"alpha/zero_with_light", {0.18f, 0.5f, 1.0f, 0.0f}, {0, 0, 0}, 0.0},
    {"alpha/negative", {0.18f, 0.5f, 1.0f, -1.0f}, {0, 0, 0}, 0.0},
    {"alpha/above_one", {0.18f, 0.5f, 1.0f, 4.0f}, {0.18, 0.5, 1.0}, 1.0},
    {"alpha/nan", {0.18f, 0.5f, 1.0f, NAN}, {0, 0, 0}, 0.0},
    {"alpha/infinite", {0.18f, 0.5f, 1.0f, INFINITY}, {0.18, 0.5, 1.0}, 1.0},
};

static void test_alpha(void **state)
{
    const struct alpha_case *c = (const struct alpha_case *)*state;
    shd_framebuffer *framebuffer = shd_test_framebuffer(g_context, 1, 1, c->in);
    size_t f, k;
    for (f = 0; f < FORMAT_COUNT; ++f) {
        static const double steps[] = {0.5 / 255, 0.5 / 255, 0.5 / 65535, 5e-4, 0.0};
        uint32_t out[4] = {0, 0, 0, 0};
        shd_image image = shd_test_image(k_formats[f], 1, 1, out);
        shd_assert_ok(shd_color_apply_display(g_color, framebuffer, "sRGB", "Plain", &image));
        for (k = 0; k < 3; ++k) {
            const double want = shd_srgb_encode(c->linear[k]);
            shd_assert_close(c->name, k, shd_test_channel(&image, k), want, steps[f] + 3e-5, 0.0);
        }
        shd_assert_close(c->name, 3, shd_test_channel(&image, 3), c->alpha, steps[f] + 1e-12, 1e-6);
    }
    shd_framebuffer_release(framebuffer);
}

/* ---- formats and sizes ---- */

static const struct {
    uint32_t width, height;
} k_sizes[] = {{1, 1}, {1, 7}, {5, 3}, {1023, 3}, {1024, 2}, {1025, 2}, {3, 6000}, {129, 257}};

/** All formats equal the float output up to their own rounding, and the padding of rows does not change. */
static void test_formats(void **state)
{
    size_t s, f, i;
    (void)state;
    for (s = 0; s < sizeof k_sizes / sizeof k_sizes[0]; ++s) {
        const uint32_t width = k_sizes[s].width, height = k_sizes[s].height;
        const size_t channels = (size_t)width * height * 4;
        float *rgba = (float *)malloc(channels * sizeof *rgba);
        float *want = (float *)malloc(channels * sizeof *want);
        shd_image reference = shd_test_image(SHD_FORMAT_RGBA32F, width, height, want);
        shd_framebuffer *framebuffer;
        for (i = 0; i < channels; ++i) rgba[i] = i % 4 == 3 ? 1.0f : shd_test_value(i);
        framebuffer = shd_test_framebuffer(g_context, width, height, rgba);
        shd_assert_ok(shd_color_apply_display(g_color, framebuffer, NULL, NULL, &reference));
        for (f = 0; f < FORMAT_COUNT; ++f) {
            static const double scale[] = {255.0, 255.0, 65535.0, 0.0, 0.0};
            const size_t packed = shd_format_size(k_formats[f]) * width, stride = packed + 16;
            unsigned char *bytes = (unsigned char *)malloc(stride * height);
            shd_image image = shd_test_image(k_formats[f], width, height, bytes);
            uint32_t y;
            memset(bytes, 0xa5, stride * height);
            image.row_stride = stride;
            shd_assert_ok(shd_color_apply_display(g_color, framebuffer, NULL, NULL, &image));
            for (y = 0; y < height; ++y) {
                shd_image row = shd_test_image(k_formats[f], width, 1, bytes + y * stride);
                for (i = 0; i < (size_t)width * 4; ++i) {
                    const double exact = (double)want[(size_t)y * width * 4 + i];
                    const double got = shd_test_channel(&row, i);
                    const double clamped = exact < 0 ? 0 : exact > 1 ? 1 : exact;
                    if (scale[f] > 0) {
                        shd_assert_close("unorm", i, got * scale[f], clamped * scale[f], 0.5 + 1.0 / 256, 0.0);
                    } else {
                        shd_assert_close("float", i, got, exact, f == 3 ? 3e-8 : 0.0, f == 3 ? 0x1p-11 : 0.0);
                    }
                }
                for (i = packed; i < stride; ++i) assert_int_equal(bytes[y * stride + i], 0xa5);
            }
            free(bytes);
        }
        shd_framebuffer_release(framebuffer);
        free(rgba);
        free(want);
    }
}

/** A framebuffer, a float image, and an image over itself give the same pixels. */
static void test_sources_agree(void **state)
{
    enum { W = 67, H = 41 };
    float rgba[W * H * 4], a[W * H * 4], b[W * H * 4];
    shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, W, H, rgba);
    shd_image image_a = shd_test_image(SHD_FORMAT_RGBA32F, W, H, a);
    shd_image image_b = shd_test_image(SHD_FORMAT_RGBA32F, W, H, b);
    shd_framebuffer *framebuffer;
    size_t i;
    (void)state;
    for (i = 0; i < W * H * 4; ++i) rgba[i] = i % 4 == 3 ? (float)(i % 5) / 4.0f : shd_test_value(i);
    framebuffer = shd_test_framebuffer(g_context, W, H, rgba);
    shd_assert_ok(shd_color_apply_display(g_color, framebuffer, NULL, NULL, &image_a));
    shd_assert_ok(shd_color_apply_display_image(g_color, &source, NULL, NULL, NULL, &image_b));
    assert_memory_equal(a, b, sizeof a);
    shd_assert_ok(shd_color_apply_display_image(g_color, &source, "Linear Rec.709", "sRGB", SHD_ACES_VIEW, &source));
    assert_memory_equal(a, rgba, sizeof a);
    shd_framebuffer_release(framebuffer);
}

/** Interleaved framebuffers have the pixels of their decoded colour. */
static void test_interleaved(void **state)
{
    enum { W = 61, H = 5 };
    static const shd_format k_colors[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F};
    static float rgba[W * H * 4], a[W * H * 4], b[W * H * 4];
    shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, W, H, rgba);
    shd_image image_a = shd_test_image(SHD_FORMAT_RGBA32F, W, H, a);
    shd_image image_b = shd_test_image(SHD_FORMAT_RGBA32F, W, H, b);
    size_t f, i, y;
    (void)state;
    for (f = 0; f < 3; ++f) {
        shd_framebuffer_desc desc = shd_framebuffer_desc_default();
        shd_framebuffer *framebuffer = NULL;
        shd_image view = shd_image_default();
        desc.width = W;
        desc.height = H;
        desc.color_format = k_colors[f];
        shd_assert_ok(shd_framebuffer_create(g_context, &desc, &framebuffer));
        shd_assert_ok(shd_framebuffer_view_color(framebuffer, &view));
        for (y = 0; y < H; ++y) {
            unsigned char *row = (unsigned char *)view.pixels + y * view.row_stride;
            for (i = 0; i < W * shd_format_size(view.format); ++i) row[i] = (unsigned char)((i * 37 + y * 11) % 123);
        }
        shd_assert_ok(shd_framebuffer_read_color(framebuffer, &source));
        shd_assert_ok(shd_color_apply_display(g_color, framebuffer, NULL, NULL, &image_a));
        shd_assert_ok(shd_color_apply_display_image(g_color, &source, NULL, NULL, NULL, &image_b));
        assert_memory_equal(a, b, sizeof a);
        assert_true(a[4] != a[8]);
        shd_framebuffer_release(framebuffer);
    }
}

/** A shd_color_view as a display: the pixels and the refusals of shd_color_apply_display. */
static void test_view_as_display(void **state)
{
    enum { W = 5, H = 3 };
    float rgba[W * H * 4], a[W * H * 4], b[W * H * 4];
    shd_image image_a = shd_test_image(SHD_FORMAT_RGBA32F, W, H, a);
    shd_image image_b = shd_test_image(SHD_FORMAT_RGBA32F, W, H, b);
    shd_color_view view = {g_color, "sRGB", "Plain"};
    shd_display display = {shd_color_apply_view, &view};
    shd_framebuffer *framebuffer;
    size_t i;
    (void)state;
    for (i = 0; i < W * H * 4; ++i) rgba[i] = i % 4 == 3 ? 0.5f : shd_test_value(i);
    framebuffer = shd_test_framebuffer(g_context, W, H, rgba);
    shd_assert_ok(shd_color_apply_display(g_color, framebuffer, "sRGB", "Plain", &image_a));
    shd_assert_ok(display.apply(framebuffer, &image_b, display.user_data));
    assert_memory_equal(a, b, sizeof a);
    shd_assert_result("null", display.apply(framebuffer, &image_b, NULL), SHD_ERROR_INVALID_ARGUMENT, "color_view");
    view.view = "Plainer";
    shd_assert_result("view", display.apply(framebuffer, &image_b, &view), SHD_ERROR_NOT_FOUND, "Plainer");
    view.color = NULL;
    shd_assert_result("color", display.apply(framebuffer, &image_b, &view), SHD_ERROR_INVALID_ARGUMENT, "");
    shd_framebuffer_release(framebuffer);
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
    struct CMUnitTest tests[96];
    size_t n = 0, i;
    unsetenv("OCIO");
    ADD_ALL(k_curves, test_curve);
    ADD_ALL(k_figures, test_figure);
    ADD_ALL(k_converts, test_convert);
    ADD_ALL(k_alpha, test_alpha);
    ADD("srgb_codes", test_srgb_codes);
    ADD("convert/ramp", test_convert_ramp);
    ADD("convert/all_halves", test_convert_halves);
    ADD("formats", test_formats);
    ADD("sources_agree", test_sources_agree);
    ADD("interleaved", test_interleaved);
    ADD("view_as_display", test_view_as_display);
    return _cmocka_run_group_tests("api.color_pixels", tests, n, set_up, tear_down);
}
