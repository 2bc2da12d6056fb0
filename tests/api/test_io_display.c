/* SPDX-License-Identifier: MIT */
/* Framebuffers saved through a display and with dithering: input and output of the display; dithered areas keep
 * their mean, and values that equal a code do not change. */
#define _GNU_SOURCE
#include "support/io_files.h"

#include <shd/extension.h>

enum { SIZE = 64, PIXELS = SIZE * SIZE };

static shd_context *g_context;
static shd_framebuffer *g_framebuffer;

static int set_up(void **state)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    desc.width = desc.height = SIZE;
    shd_assert_ok(shd_context_create(NULL, &g_context));
    shd_assert_ok(shd_framebuffer_create(g_context, &desc, &g_framebuffer));
    return io_make_folder(state);
}

static int tear_down(void **state)
{
    shd_framebuffer_release(g_framebuffer);
    shd_context_release(g_context);
    return io_remove_folder(state);
}

/* Fills the framebuffer with one colour: plane views point to the framebuffer's own memory. */
static void paint(const float rgba[4])
{
    int plane, x, y;
    for (plane = SHD_PLANE_R; plane <= SHD_PLANE_A; ++plane) {
        shd_plane_view view = shd_plane_view_default();
        shd_assert_ok(shd_framebuffer_view_plane(g_framebuffer, (shd_plane)plane, &view));
        for (y = 0; y < SIZE; ++y) {
            float *row = (float *)(uintptr_t)((uintptr_t)view.f32 + (size_t)y * view.row_stride);
            for (x = 0; x < SIZE; ++x) row[x] = rgba[plane];
        }
    }
}

/* Saves and loads; returns the sum and the range of the codes of each channel. */
struct codes {
    double sum[4];
    uint32_t least[4], most[4];
    uint64_t hash;
};

static struct codes save(const shd_save_desc *desc, const char *file)
{
    struct codes codes = {{0, 0, 0, 0}, {~0u, ~0u, ~0u, ~0u}, {0, 0, 0, 0}, SHD_HASH_START};
    shd_bitmap *bitmap = NULL;
    shd_image image = shd_image_default();
    int i, c;
    shd_assert_ok(shd_framebuffer_save(g_framebuffer, io_path(file), desc));
    shd_assert_ok(shd_bitmap_load(g_context, io_path(file), NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(image.width, SIZE);
    for (i = 0; i < PIXELS; ++i) {
        for (c = 0; c < 4; ++c) {
            const int wide = image.format == SHD_FORMAT_RGBA16;
            const uint32_t code =
                wide ? ((const uint16_t *)image.pixels)[4 * i + c] : ((const uint8_t *)image.pixels)[4 * i + c];
            codes.sum[c] += code;
            if (code < codes.least[c]) codes.least[c] = code;
            if (code > codes.most[c]) codes.most[c] = code;
            codes.hash = shd_hash(codes.hash, &code, sizeof code);
        }
    }
    shd_bitmap_release(bitmap);
    return codes;
}

/* For a value between two codes, both codes occur, and their mean is the value. */
static void test_dither_mean(void **state)
{
    static const uint32_t k_depths[2] = {8, 16};
    int d, c, step;
    (void)state;
    for (d = 0; d < 2; ++d) {
        const double maximum = d ? 65535 : 255;
        for (step = 1; step < 16; ++step) {
            const float rgba[4] = {(float)((100 + step / 16.0) / maximum), (float)((7 + step / 16.0) / maximum),
                                   (float)((200 + step / 16.0) / maximum), 1};
            shd_save_desc desc = shd_save_desc_default();
            struct codes codes;
            desc.bit_depth = k_depths[d];
            desc.encoding = SHD_COLOR_ENCODING_LINEAR;
            desc.dither = SHD_DITHER_ORDERED;
            paint(rgba);
            codes = save(&desc, "mean.png");
            for (c = 0; c < 3; ++c) {
                shd_assert_close("mean", (size_t)c, codes.sum[c] / PIXELS, (double)rgba[c] * maximum, 0.004, 0);
                assert_int_equal(codes.most[c], codes.least[c] + 1);
            }
            assert_int_equal(codes.least[3], maximum);
        }
    }
}

/* Dithering does not change values that equal a code, 0, 1, values outside 0..1 and NaN. Alpha is rounded to the
 * nearest code. */
static void test_dither_exact(void **state)
{
    static const float k_colors[3][4] = {{0.2f, 0.4f, 0.6f, 1}, {0, 1, 7, 1}, {-3, NAN, 0.5f * 0.5f, 0.5f}};
    static const uint32_t k_codes[3][4] = {{51, 102, 153, 255}, {0, 255, 255, 255}, {0, 0, 127, 128}};
    int k, c;
    (void)state;
    for (k = 0; k < 3; ++k) {
        shd_save_desc desc = shd_save_desc_default();
        struct codes codes;
        desc.encoding = SHD_COLOR_ENCODING_LINEAR;
        desc.dither = SHD_DITHER_ORDERED;
        paint(k_colors[k]);
        codes = save(&desc, "exact.png");
        for (c = 0; c < 4; ++c) {
            assert_int_equal(codes.least[c], k_codes[k][c]);
            if (k == 2 && c == 2) continue; /* 127.5 lies between two codes */
            assert_int_equal(codes.most[c], k_codes[k][c]);
        }
    }
}

/* The pattern depends only on the position: the same bits on every machine. */
static void test_dither_bits(void **state)
{
    const float rgba[4] = {0.1f, 0.01f, 0.5f, 1};
    shd_save_desc desc = shd_save_desc_default();
    struct codes first, again, nearest;
    (void)state;
    paint(rgba);
    nearest = save(&desc, "nearest.png");
    desc.dither = SHD_DITHER_ORDERED;
    first = save(&desc, "first.png");
    desc.bit_depth = 8;
    again = save(&desc, "again.tif");
    assert_true(first.hash == again.hash);
    assert_true(first.hash != nearest.hash);
    assert_int_equal(first.hash, 0x9d63a2dc05201b05ull);
}

/* Displays. */

struct display {
    int calls;
    shd_result result;
    const char *text;
    float value;
};

static shd_result show(const shd_framebuffer *framebuffer, const shd_image *out, void *user_data)
{
    struct display *display = (struct display *)user_data;
    size_t i;
    ++display->calls;
    assert_ptr_equal(framebuffer, g_framebuffer);
    assert_true(out->format == SHD_FORMAT_RGBA32F && out->width == SIZE && out->height == SIZE);
    assert_true(out->row_stride == 0 || out->row_stride == SIZE * 16);
    for (i = 0; i < 4 * (size_t)PIXELS; ++i) ((float *)out->pixels)[i] = display->value;
    return display->result == SHD_OK ? SHD_OK : shd_report_error(display->result, display->text);
}

static void test_display(void **state)
{
    const float rgba[4] = {0.25f, 0.5f, 0.75f, 1};
    struct display display = {0, SHD_OK, "", 0.8f};
    shd_save_desc desc = shd_save_desc_default();
    struct codes codes;
    (void)state;
    paint(rgba);
    desc.display.apply = show;
    desc.display.user_data = &display;
    codes = save(&desc, "display.png"); /* no further curve, no division by alpha */
    assert_true(codes.least[0] == 204 && codes.most[3] == 204);
    display.value = 204.5f / 255;
    desc.dither = SHD_DITHER_ORDERED;
    codes = save(&desc, "display.png");
    assert_true(codes.least[0] == 204 && codes.most[0] == 205);
    shd_assert_close("mean", 0, codes.sum[0] / PIXELS, 204.5, 0.004, 0);
    assert_int_equal(display.calls, 2);
    display.value = (float)NAN;
    codes = save(&desc, "display.png");
    assert_true(codes.most[0] == 0 && codes.most[3] == 0);
    assert_int_equal(display.calls, 3);
    shd_assert_ok(shd_framebuffer_save(g_framebuffer, io_path("display.exr"), &desc)); /* linear files do not use the
                                                                                          display */
    assert_int_equal(display.calls, 3);
}

/* A failure of the display is the result of the call, and no file appears. */
static void test_display_fails(void **state)
{
    struct display display = {0, SHD_ERROR_NOT_FOUND, "display: no view of that name", 0};
    shd_save_desc desc = shd_save_desc_default();
    (void)state;
    desc.display.apply = show;
    desc.display.user_data = &display;
    shd_assert_result("fails", shd_framebuffer_save(g_framebuffer, io_path("fails.png"), &desc), SHD_ERROR_NOT_FOUND,
                      "no view of that name");
    assert_int_equal(io_count_files("fails", 0), 0);
}

static void test_refused(void **state)
{
    static float pixels[4];
    shd_save_desc desc = shd_save_desc_default();
    shd_image image = shd_image_default();
    (void)state;
    image.format = SHD_FORMAT_RGBA32F;
    image.width = image.height = 1;
    image.pixels = pixels;
    desc.dither = (shd_dither)2;
    shd_assert_result("dither", shd_framebuffer_save(g_framebuffer, io_path("a.png"), &desc),
                      SHD_ERROR_INVALID_ARGUMENT, "save.dither: 2");
    desc.dither = SHD_DITHER_ORDERED;
    shd_assert_result("image", shd_image_save(&image, io_path("a.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.dither: an image keeps its pixels");
    desc = shd_save_desc_default();
    desc.display.apply = show;
    shd_assert_result("image", shd_image_save(&image, io_path("a.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.display: an image keeps its pixels");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dither_mean), cmocka_unit_test(test_dither_exact),  cmocka_unit_test(test_dither_bits),
        cmocka_unit_test(test_display),     cmocka_unit_test(test_display_fails), cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests_name("api.io_display", tests, set_up, tear_down);
}
