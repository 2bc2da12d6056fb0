/* SPDX-License-Identifier: MIT */
/* Normal maps of height maps: every slope, wrap and format against the oracle, known normals, the same normals as bumps
 * of a material read them, and refusals. */
#include "support/check.h"
#include "support/image.h"
#include "support/noise.h"

#include <shd/shd.h>

#include "ref/height_normals_ref.h"

enum { WIDTH = 13, HEIGHT = 7, STRIDE = 256 };
static const float k_nan = (float)NAN, k_inf = (float)INFINITY;

static shd_context *make_context(uint32_t workers)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    desc.worker_count = workers;
    shd_assert_ok(shd_context_create(&desc, &context));
    return context;
}

/* ---- against the oracle ---- */

static double half_value(uint16_t half)
{
    const int exponent = half >> 10 & 31;
    const double mantissa = half & 1023, value = exponent ? ldexp(1024 + mantissa, exponent - 25) : ldexp(mantissa, -24);
    if (exponent == 31) return k_nan;
    return half & 0x8000 ? -value : value;
}

/* The first channel of a pixel, as a number. */
static double first_channel(shd_format format, const unsigned char *pixel)
{
    uint16_t code;
    float value;
    memcpy(&code, pixel, sizeof code);
    memcpy(&value, pixel, sizeof value);
    switch (format) {
        case SHD_FORMAT_R32F:
        case SHD_FORMAT_RGB32F:
        case SHD_FORMAT_RGBA32F: return (double)value;
        case SHD_FORMAT_R16F:
        case SHD_FORMAT_RGBA16F: return half_value(code);
        case SHD_FORMAT_R16:
        case SHD_FORMAT_RGBA16: return code / 65535.0;
        default: return *pixel / 255.0;
    }
}

struct format_case {
    const char *name;
    shd_format format;
    size_t channels;
    double error; /* largest one of a component */
};
static const struct format_case k_heights[] = {
    {"r8", SHD_FORMAT_R8, 1, 0},           {"rg8", SHD_FORMAT_RG8, 2, 0},
    {"r8_srgb", SHD_FORMAT_R8_SRGB, 1, 0}, {"rgba8_srgb", SHD_FORMAT_RGBA8_SRGB, 4, 0},
    {"r16", SHD_FORMAT_R16, 1, 0},         {"r16f", SHD_FORMAT_R16F, 1, 0},
    {"r32f", SHD_FORMAT_R32F, 1, 0},       {"rgba32f", SHD_FORMAT_RGBA32F, 4, 0},
};
static const struct format_case k_normals[] = {
    {"rgb8", SHD_FORMAT_RGB8, 3, 1.0 / 255},         {"rgba8", SHD_FORMAT_RGBA8, 4, 1.0 / 255},
    {"rgb8_srgb", SHD_FORMAT_RGB8_SRGB, 3, 1.0 / 255}, {"rgba16", SHD_FORMAT_RGBA16, 4, 1.0 / 65535},
    {"rgba16f", SHD_FORMAT_RGBA16F, 4, 0x1p-11},     {"rgb32f", SHD_FORMAT_RGB32F, 3, 0x1p-24},
    {"rgba32f", SHD_FORMAT_RGBA32F, 4, 0x1p-24},
};

/* Component c of a normal, -1..1; alpha for c = 3. */
static double component(const struct format_case *format, const unsigned char *pixel, size_t c)
{
    const size_t size = shd_format_size(format->format) / format->channels;
    const double value = first_channel(format->format, pixel + c * size);
    const int is_float = format->error < 1e-3 && format->error != 1.0 / 65535;
    return is_float || c == 3 ? value : 2 * value - 1;
}

static void fill_heights(shd_format format, unsigned char *bytes)
{
    uint32_t seed = 11, i;
    float *floats = (float *)(void *)bytes;
    for (i = 0; i < STRIDE * HEIGHT; ++i) bytes[i] = (unsigned char)shd_noise(&seed);
    if (format == SHD_FORMAT_R32F || format == SHD_FORMAT_RGBA32F) {
        for (i = 0; i < STRIDE / 4 * HEIGHT; ++i) floats[i] = 8 * (float)(shd_noise(&seed) & 0xffff) / 65536.0f;
        floats[0] = k_nan;
        floats[STRIDE / 4] = k_inf;
        floats[2 * STRIDE / 4] = -k_inf;
    }
}

/* Rows have gaps, which stay as they are. */
static void check_all(const struct format_case *from, const struct format_case *to, const shd_normals_desc *desc)
{
    static unsigned char in[STRIDE * HEIGHT + 16], out[STRIDE * HEIGHT];
    static double numbers[HEIGHT * WIDTH];
    shd_image heights = shd_test_image(from->format, WIDTH, HEIGHT, in),
              normals = shd_test_image(to->format, WIDTH, HEIGHT, out);
    const size_t size_in = shd_format_size(from->format), size_out = shd_format_size(to->format);
    const struct shd_ref_heights map = {numbers, WIDTH, HEIGHT, desc->wrap_u, desc->wrap_v};
    shd_context *context = make_context(0);
    size_t x, y, c;
    heights.row_stride = normals.row_stride = STRIDE;
    fill_heights(from->format, in);
    memset(out, 0xee, sizeof out);
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) numbers[y * WIDTH + x] = first_channel(from->format, in + STRIDE * y + size_in * x);
    }
    shd_assert_ok(shd_mip_build_normals(context, &heights, desc, &normals));
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            const unsigned char *pixel = out + STRIDE * y + size_out * x;
            double want[3];
            shd_ref_height_normal(&map, desc->slope, (double)desc->scale, (long)x, (long)y, want);
            for (c = 0; c < 3; ++c) {
                shd_assert_close(to->name, y * WIDTH + x, component(to, pixel, c), want[c], 1.001 * to->error, 0);
            }
            if (to->channels == 4) assert_true(component(to, pixel, 3) == 1);
        }
        for (x = size_out * WIDTH; x < STRIDE; ++x) assert_int_equal(out[STRIDE * y + x], 0xee);
    }
    shd_context_release(context);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static void test_formats(void **state)
{
    shd_normals_desc desc = shd_normals_desc_default();
    size_t i, j;
    (void)state;
    desc.scale = 3;
    for (i = 0; i < COUNT(k_heights); ++i) {
        for (j = 0; j < COUNT(k_normals); ++j) check_all(&k_heights[i], &k_normals[j], &desc);
    }
}

static void test_slopes_and_wraps(void **state)
{
    static const float k_scales[] = {0, -2, 0.01f, 1e6f};
    int slope, u, v;
    size_t i;
    (void)state;
    for (slope = 0; slope <= SHD_HEIGHT_SLOPE_SOBEL; ++slope) {
        for (u = 0; u <= SHD_WRAP_MIRROR_ONCE; ++u) {
            for (v = 0; v <= SHD_WRAP_MIRROR_ONCE; ++v) {
                for (i = 0; i < COUNT(k_scales); ++i) {
                    shd_normals_desc desc = shd_normals_desc_default();
                    desc.scale = k_scales[i];
                    desc.slope = (shd_height_slope)slope;
                    desc.wrap_u = (shd_wrap)u;
                    desc.wrap_v = (shd_wrap)v;
                    check_all(&k_heights[6], &k_normals[6], &desc);
                }
            }
        }
    }
}

/* ---- known normals ---- */

/* A plane that rises by 3/4 to the right and by 1 downwards leans to the left and up in the picture. */
static void test_plane(void **state)
{
    float heights[5][4], normals[5][4][3];
    const shd_image in = shd_test_image(SHD_FORMAT_R32F, 4, 5, heights);
    const shd_image out = shd_test_image(SHD_FORMAT_RGB32F, 4, 5, normals);
    const double length = sqrt(0.75 * 0.75 + 1 + 1);
    shd_context *context = make_context(1);
    int slope, x, y;
    (void)state;
    for (y = 0; y < 5; ++y) {
        for (x = 0; x < 4; ++x) heights[y][x] = 0.75f * (float)x + (float)y;
    }
    for (slope = 0; slope <= SHD_HEIGHT_SLOPE_SOBEL; ++slope) {
        shd_normals_desc desc = shd_normals_desc_default();
        desc.slope = (shd_height_slope)slope;
        shd_assert_ok(shd_mip_build_normals(context, &in, &desc, &out));
        for (y = 1; y < 4; ++y) {
            for (x = 1; x < 3; ++x) {
                shd_assert_close("x", 0, (double)normals[y][x][0], -0.75 / length, 6e-8, 0);
                shd_assert_close("y", 0, (double)normals[y][x][1], 1 / length, 6e-8, 0);
                shd_assert_close("z", 0, (double)normals[y][x][2], 1 / length, 6e-8, 0);
            }
        }
    }
    shd_context_release(context);
}

/* A single texel, alone with itself, is flat; with a border it is not where the slope is one-sided. */
static void test_single(void **state)
{
    float height = 3e38f, normal[4];
    unsigned char code[3];
    const shd_image in = shd_test_image(SHD_FORMAT_R32F, 1, 1, &height);
    const shd_image out = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, normal),
                    out8 = shd_test_image(SHD_FORMAT_RGB8, 1, 1, code);
    shd_normals_desc desc = shd_normals_desc_default();
    shd_context *context = make_context(1);
    (void)state;
    shd_assert_ok(shd_mip_build_normals(context, &in, NULL, &out));
    assert_true(normal[0] == 0 && normal[1] == 0 && normal[2] == 1 && normal[3] == 1);
    shd_assert_ok(shd_mip_build_normals(context, &in, NULL, &out8));
    assert_true(code[0] == 128 && code[1] == 128 && code[2] == 255);
    desc.wrap_u = desc.wrap_v = SHD_WRAP_BORDER;
    desc.slope = SHD_HEIGHT_SLOPE_FORWARD;
    desc.scale = 1e6f;
    shd_assert_ok(shd_mip_build_normals(context, &in, &desc, &out));
    shd_assert_close("steep", 0, (double)normal[0], sqrt(0.5), 6e-8, 0);
    shd_assert_close("steep", 1, (double)normal[1], -sqrt(0.5), 6e-8, 0);
    shd_context_release(context);
}

static void test_workers(void **state)
{
    static float heights[64 * 64], normals[64 * 64 * 3];
    const shd_image in = shd_test_image(SHD_FORMAT_R32F, 64, 64, heights);
    const shd_image out = shd_test_image(SHD_FORMAT_RGB32F, 64, 64, normals);
    uint64_t want = 0;
    uint32_t workers, i, seed = 3;
    (void)state;
    for (i = 0; i < 64 * 64; ++i) heights[i] = (float)(shd_noise(&seed) & 0xffff) / 4096.0f;
    for (workers = 1; workers <= 16; workers *= 4) {
        shd_context *context = make_context(workers);
        uint64_t hash;
        shd_assert_ok(shd_mip_build_normals(context, &in, NULL, &out));
        hash = shd_hash(SHD_HASH_START, normals, sizeof normals);
        if (workers > 1) assert_true(hash == want);
        want = hash;
        shd_context_release(context);
    }
    assert_int_equal(want, 0x5c7d429189e9be22ull);
}

/* ---- refusals ---- */

struct bad_case {
    const char *name;
    shd_format in, out;
    uint32_t width, height;
    void (*edit)(shd_normals_desc *desc);
    const char *message;
};
static void edit_nothing(shd_normals_desc *d) { (void)d; }
static void edit_size(shd_normals_desc *d) { d->struct_size = 3; }
static void edit_scale(shd_normals_desc *d) { d->scale = 2e6f; }
static void edit_scale_nan(shd_normals_desc *d) { d->scale = k_nan; }
static void edit_slope(shd_normals_desc *d) { d->slope = (shd_height_slope)3; }
static void edit_wrap_u(shd_normals_desc *d) { d->wrap_u = (shd_wrap)9; }
static void edit_wrap_v(shd_normals_desc *d) { d->wrap_v = (shd_wrap)-1; }

static const struct bad_case k_bad[] = {
    {"no_format", (shd_format)99, SHD_FORMAT_RGB8, 4, 4, edit_nothing, "heights.format: 99 is not a format"},
    {"blocks", SHD_FORMAT_BC4, SHD_FORMAT_RGB8, 4, 4, edit_nothing, "heights.format: "},
    {"two_channels", SHD_FORMAT_R8, SHD_FORMAT_RG8, 4, 4, edit_nothing, "out.format: normals need 3 or 4 channels, not 2"},
    {"width", SHD_FORMAT_R8, SHD_FORMAT_RGB8, 3, 4, edit_nothing, "out.width: 3 is not in 4..4"},
    {"height", SHD_FORMAT_R8, SHD_FORMAT_RGB8, 4, 5, edit_nothing, "out.height: 5 is not in 4..4"},
    {"struct_size", SHD_FORMAT_R8, SHD_FORMAT_RGB8, 4, 4, edit_size, "normals.struct_size: 3"},
    {"scale", SHD_FORMAT_R8, SHD_FORMAT_RGB8, 4, 4, edit_scale, "normals.scale: 2e+06 is not in -1e+06..1e+06"},
    {"scale_nan", SHD_FORMAT_R8, SHD_FORMAT_RGB8, 4, 4, edit_scale_nan, "normals.scale: "},
    {"slope", SHD_FORMAT_R8, SHD_FORMAT_RGB8, 4, 4, edit_slope, "normals.slope: 3 is not in 0..2"},
    {"wrap_u", SHD_FORMAT_R8, SHD_FORMAT_RGB8, 4, 4, edit_wrap_u, "normals.wrap_u: 9 is not in"},
    {"wrap_v", SHD_FORMAT_R8, SHD_FORMAT_RGB8, 4, 4, edit_wrap_v, "normals.wrap_v: "},
};

static void test_bad(void **state)
{
    unsigned char in[64] = {0}, out[64];
    shd_context *context = make_context(1);
    shd_image heights = shd_test_image(SHD_FORMAT_R8, 4, 4, in), normals = shd_test_image(SHD_FORMAT_RGB8, 4, 4, out);
    size_t i;
    (void)state;
    memset(out, 0xee, sizeof out);
    for (i = 0; i < COUNT(k_bad); ++i) {
        const shd_image from = shd_test_image(k_bad[i].in, 4, 4, in),
                        to = shd_test_image(k_bad[i].out, k_bad[i].width, k_bad[i].height, out);
        shd_normals_desc desc = shd_normals_desc_default();
        k_bad[i].edit(&desc);
        shd_assert_result(k_bad[i].name, shd_mip_build_normals(context, &from, &desc, &to), SHD_ERROR_INVALID_ARGUMENT,
                          k_bad[i].message);
    }
    shd_assert_result("context", shd_mip_build_normals(NULL, &heights, NULL, &normals), SHD_ERROR_INVALID_ARGUMENT,
                      "context: NULL");
    shd_assert_result("heights", shd_mip_build_normals(context, NULL, NULL, &normals), SHD_ERROR_INVALID_ARGUMENT,
                      "heights: NULL");
    shd_assert_result("out", shd_mip_build_normals(context, &heights, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out: NULL");
    normals.pixels = in + 8;
    shd_assert_result("overlap", shd_mip_build_normals(context, &heights, NULL, &normals), SHD_ERROR_INVALID_ARGUMENT,
                      "out");
    for (i = 0; i < sizeof out; ++i) assert_int_equal(out[i], 0xee);
    shd_context_release(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_formats), cmocka_unit_test(test_slopes_and_wraps), cmocka_unit_test(test_plane),
        cmocka_unit_test(test_single),  cmocka_unit_test(test_workers),          cmocka_unit_test(test_bad),
    };
    return _cmocka_run_group_tests("api.height_normals", tests, COUNT(tests), NULL, NULL);
}
