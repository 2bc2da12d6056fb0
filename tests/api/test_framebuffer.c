/* SPDX-License-Identifier: MIT */
/* Framebuffers: every field of the desc, planes, and the initial values in every format. */
#include "support/check.h"

#include <shd/framebuffer.h>

static shd_context *g_context;

#define ALL_AOVS (2 * SHD_AOV_TARGET3 - 1)

struct create_case {
    const char *name;
    uint32_t width, height, samples, aovs;
    shd_result expected;
    const char *message;
    size_t least_bytes; /* width * height * planes * 4 */
};

#define BAD SHD_ERROR_INVALID_ARGUMENT
static const struct create_case k_create[] = {
    {"create/1x1", 1, 1, 1, 0, SHD_OK, "", 20},
    {"create/17x3", 17, 3, 1, 0, SHD_OK, "", 1020},
    {"create/17x3_all_aovs", 17, 3, 1, ALL_AOVS, SHD_OK, "", 7548},
    {"create/64x64_uv", 64, 64, 1, SHD_AOV_UV, SHD_OK, "", 114688},
    {"create/16384x1", 16384, 1, 1, SHD_AOV_TRIANGLE, SHD_OK, "", 393216},
    {"create/1x16384", 1, 16384, 1, SHD_AOV_NORMAL, SHD_OK, "", 524288},
    {"create/width_0", 0, 4, 1, 0, BAD, "framebuffer.width: 0 is not in 1..16384", 0},
    {"create/height_0", 4, 0, 1, 0, BAD, "framebuffer.height: 0 is not in 1..16384", 0},
    {"create/width_16385", 16385, 4, 1, 0, BAD, "framebuffer.width: 16385", 0},
    {"create/height_uint32_max", 4, 0xffffffffu, 1, 0, BAD, "framebuffer.height: 4294967295", 0},
    {"create/samples_0", 4, 4, 0, 0, BAD, "framebuffer.sample_count: 0", 0},
    {"create/samples_2", 4, 4, 2, 0, SHD_OK, "", 320},
    {"create/samples_3", 4, 4, 3, 0, BAD, "framebuffer.sample_count: 3 is not 1, 2, 4, 8 or 16", 0},
    {"create/samples_4", 4, 4, 4, 0, SHD_OK, "", 320},
    {"create/samples_8", 4, 4, 8, 0, SHD_OK, "", 320},
    {"create/samples_16", 4, 4, 16, 0, SHD_OK, "", 320},
    {"create/samples_64", 4, 4, 64, 0, BAD, "framebuffer.sample_count: 64", 0},
    {"create/aovs_unknown", 4, 4, 1, 4097, SHD_ERROR_UNSUPPORTED, "framebuffer.aovs: bits 0x1000 ", 0},
};

static shd_framebuffer *make(uint32_t width, uint32_t height, uint32_t aovs)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    desc.width = width;
    desc.height = height;
    desc.aovs = aovs;
    shd_assert_ok(shd_framebuffer_create(g_context, &desc, &framebuffer));
    return framebuffer;
}

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = (shd_framebuffer *)&desc;
    shd_framebuffer_info info = shd_framebuffer_info_default();
    desc.width = c->width;
    desc.height = c->height;
    desc.sample_count = c->samples;
    desc.aovs = c->aovs;
    shd_assert_result(c->name, shd_framebuffer_create(g_context, &desc, &framebuffer), c->expected, c->message);
    if (c->expected != SHD_OK) {
        assert_null(framebuffer);
        return;
    }
    shd_assert_ok(shd_framebuffer_get_info(framebuffer, &info));
    assert_int_equal(info.width, c->width);
    assert_int_equal(info.height, c->height);
    assert_int_equal(info.sample_count, c->samples);
    assert_int_equal(info.aovs, c->aovs);
    assert_true(info.byte_size >= c->least_bytes);
    shd_framebuffer_release(framebuffer);
}

struct plane_case {
    const char *name;
    shd_plane plane;
    uint32_t aov;
    double empty;
    int is_integer;
};
static const struct plane_case k_planes[] = {
    {"planes/r", SHD_PLANE_R, 0, 0, 0},
    {"planes/g", SHD_PLANE_G, 0, 0, 0},
    {"planes/b", SHD_PLANE_B, 0, 0, 0},
    {"planes/a", SHD_PLANE_A, 0, 0, 0},
    {"planes/depth", SHD_PLANE_DEPTH, 0, 1, 0},
    {"planes/u", SHD_PLANE_U, SHD_AOV_UV, 0, 0},
    {"planes/v", SHD_PLANE_V, SHD_AOV_UV, 0, 0},
    {"planes/nx", SHD_PLANE_NX, SHD_AOV_NORMAL, 0, 0},
    {"planes/ny", SHD_PLANE_NY, SHD_AOV_NORMAL, 0, 0},
    {"planes/nz", SHD_PLANE_NZ, SHD_AOV_NORMAL, 0, 0},
    {"planes/triangle", SHD_PLANE_TRIANGLE, SHD_AOV_TRIANGLE, 4294967295.0, 1},
    {"planes/px", SHD_PLANE_PX, SHD_AOV_POSITION, 0, 0},
    {"planes/py", SHD_PLANE_PY, SHD_AOV_POSITION, 0, 0},
    {"planes/pz", SHD_PLANE_PZ, SHD_AOV_POSITION, 0, 0},
    {"planes/dudx", SHD_PLANE_DUDX, SHD_AOV_DERIVATIVES, 0, 0},
    {"planes/dvdx", SHD_PLANE_DVDX, SHD_AOV_DERIVATIVES, 0, 0},
    {"planes/dudy", SHD_PLANE_DUDY, SHD_AOV_DERIVATIVES, 0, 0},
    {"planes/dvdy", SHD_PLANE_DVDY, SHD_AOV_DERIVATIVES, 0, 0},
    {"planes/b0", SHD_PLANE_B0, SHD_AOV_BARYCENTRICS, 0, 0},
    {"planes/b1", SHD_PLANE_B1, SHD_AOV_BARYCENTRICS, 0, 0},
    {"planes/b2", SHD_PLANE_B2, SHD_AOV_BARYCENTRICS, 0, 0},
    {"planes/lod", SHD_PLANE_LOD, SHD_AOV_LEVEL, 0, 0},
    {"planes/level", SHD_PLANE_LEVEL, SHD_AOV_LEVEL, 0, 1},
    {"planes/draw", SHD_PLANE_DRAW, SHD_AOV_DRAW, 4294967295.0, 1},
    {"planes/overdraw", SHD_PLANE_OVERDRAW, SHD_AOV_OVERDRAW, 0, 1},
    {"planes/target1_r", SHD_PLANE_TARGET1_R, SHD_AOV_TARGET1, 0, 0},
    {"planes/target1_a", SHD_PLANE_TARGET1_A, SHD_AOV_TARGET1, 0, 0},
    {"planes/target2_g", SHD_PLANE_TARGET2_G, SHD_AOV_TARGET2, 0, 0},
    {"planes/target3_b", SHD_PLANE_TARGET3_B, SHD_AOV_TARGET3, 0, 0},
    {"planes/target3_a", SHD_PLANE_TARGET3_A, SHD_AOV_TARGET3, 0, 0},
};

static union {
    float f32[256];
    uint32_t u32[256];
} g_pixels;

static double pixel(const struct plane_case *c, size_t i)
{
    return c->is_integer ? (double)g_pixels.u32[i] : (double)g_pixels.f32[i];
}

/* Reads with the function for the plane's type, or with the other function. */
static shd_result read_plane(const struct plane_case *c, const shd_framebuffer *framebuffer, size_t stride, int other)
{
    const shd_f32_out floats = {g_pixels.f32, stride};
    const shd_u32_out integers = {g_pixels.u32, stride};
    return c->is_integer != other ? shd_framebuffer_read_u32_plane(framebuffer, c->plane, &integers)
                                  : shd_framebuffer_read_plane(framebuffer, c->plane, &floats);
}

/* For every combination of AOVs, a plane exists with the value of an empty frame or is NOT_FOUND, and only one
 * function reads it. */
static void test_plane(void **state)
{
    enum { k_width = 19, k_height = 5, k_pixels = k_width * k_height };
    const struct plane_case *c = (const struct plane_case *)*state;
    uint32_t aovs;
    for (aovs = 0; aovs <= ALL_AOVS; ++aovs) {
        shd_framebuffer *framebuffer = make(k_width, k_height, aovs);
        shd_plane_view view = {sizeof view, g_pixels.f32, g_pixels.u32, 77};
        shd_result result = shd_framebuffer_view_plane(framebuffer, c->plane, &view);
        size_t i;
        memset(&g_pixels, 0x55, sizeof g_pixels);
        shd_assert_result("kind", read_plane(c, framebuffer, 0, 1), BAD,
                          c->is_integer ? " holds integers; take shd_framebuffer_read_u32_plane"
                                        : " holds floats; take shd_framebuffer_read_plane");
        if (c->aov && !(aovs & c->aov)) {
            shd_assert_result("view", result, SHD_ERROR_NOT_FOUND, "plane: ");
            assert_true(!view.f32 && !view.u32 && view.row_stride == 0);
            shd_assert_result("read", read_plane(c, framebuffer, 0, 0), SHD_ERROR_NOT_FOUND, "plane: ");
            for (i = 0; i < 256; ++i) assert_int_equal(g_pixels.u32[i], 0x55555555u);
            shd_framebuffer_release(framebuffer);
            continue;
        }
        shd_assert_ok(result);
        assert_true(!view.u32 == !c->is_integer && !view.f32 == !!c->is_integer);
        assert_true(((uintptr_t)view.f32 | (uintptr_t)view.u32) % 64 == 0);
        assert_true(view.row_stride % 64 == 0 && view.row_stride >= k_width * sizeof(float));
        for (i = 0; i < k_pixels; ++i) {
            const size_t at = i / k_width * (view.row_stride / 4) + i % k_width;
            assert_true((view.u32 ? (double)view.u32[at] : (double)view.f32[at]) == c->empty);
        }
        shd_assert_ok(read_plane(c, framebuffer, 0, 0));
        for (i = 0; i < k_pixels; ++i) assert_true(pixel(c, i) == c->empty);
        assert_int_equal(g_pixels.u32[k_pixels], 0x55555555u);
        memset(&g_pixels, 0x55, sizeof g_pixels);
        shd_assert_ok(read_plane(c, framebuffer, 8, 0));
        for (i = 0; i < 2 * k_pixels; i += 2) assert_true(pixel(c, i) == c->empty);
        for (i = 1; i < 2 * k_pixels; i += 2) assert_int_equal(g_pixels.u32[i], 0x55555555u);
        shd_framebuffer_release(framebuffer);
    }
}

static void test_bad_u32_reads(void **state)
{
    shd_framebuffer *framebuffer = make(5, 3, SHD_AOV_TRIANGLE);
    shd_u32_out none = {NULL, 0}, odd = {g_pixels.u32, 6}, out = {g_pixels.u32, 0};
    (void)state;
    shd_assert_result("null", shd_framebuffer_read_u32_plane(framebuffer, SHD_PLANE_TRIANGLE, &none), BAD,
                      "out.data: NULL");
    shd_assert_result("null", shd_framebuffer_read_u32_plane(framebuffer, SHD_PLANE_TRIANGLE, NULL), BAD, "out: NULL");
    shd_assert_result("stride", shd_framebuffer_read_u32_plane(framebuffer, SHD_PLANE_TRIANGLE, &odd), BAD,
                      "out.stride: 6");
    shd_assert_result("absent", shd_framebuffer_read_u32_plane(framebuffer, SHD_PLANE_DRAW, &out), SHD_ERROR_NOT_FOUND,
                      "plane: 23");
    shd_assert_result("unknown", shd_framebuffer_read_u32_plane(framebuffer, (shd_plane)37, &out), BAD,
                      "plane: 37 is not in 0..36");
    shd_assert_result("negative", shd_framebuffer_read_u32_plane(framebuffer, (shd_plane)-1, &out), BAD, "plane: ");
    shd_assert_result("handle", shd_framebuffer_read_u32_plane(NULL, SHD_PLANE_TRIANGLE, &out), BAD,
                      "framebuffer: NULL");
    shd_framebuffer_release(framebuffer);
}

static void test_bad_reads(void **state)
{
    float pixels[64];
    shd_framebuffer *framebuffer = make(4, 4, 0);
    shd_f32_out out = {pixels, 0}, none = {NULL, 0}, odd = {pixels, 2}, huge = {pixels, SIZE_MAX - 3};
    shd_plane_view view = {sizeof view, pixels, NULL, 1};
    shd_framebuffer_info info = {sizeof info, 1, 2, 3, 4, SHD_FORMAT_R8, 5};
    (void)state;
    shd_assert_result("unknown", shd_framebuffer_read_plane(framebuffer, (shd_plane)37, &out), BAD,
                      "plane: 37 is not in 0..36");
    shd_assert_result("negative", shd_framebuffer_read_plane(framebuffer, (shd_plane)-1, &out), BAD, "plane: ");
    shd_assert_result("null", shd_framebuffer_read_plane(framebuffer, SHD_PLANE_R, &none), BAD, "out.data: NULL");
    shd_assert_result("null", shd_framebuffer_read_plane(framebuffer, SHD_PLANE_R, NULL), BAD, "out: NULL");
    shd_assert_result("stride", shd_framebuffer_read_plane(framebuffer, SHD_PLANE_R, &odd), BAD, "out.stride: 2");
    shd_assert_result("overflow", shd_framebuffer_read_plane(framebuffer, SHD_PLANE_R, &huge), BAD, "out: 16 elements");
    shd_assert_result("handle", shd_framebuffer_read_plane(NULL, SHD_PLANE_R, &out), BAD, "framebuffer: NULL");
    shd_assert_result("view", shd_framebuffer_view_plane(framebuffer, (shd_plane)99, &view), BAD, "plane: 99");
    assert_true(!view.f32 && view.row_stride == 0);
    shd_assert_result("view", shd_framebuffer_view_plane(framebuffer, SHD_PLANE_R, NULL), BAD, "out_view: NULL");
    shd_assert_result("info", shd_framebuffer_get_info(framebuffer, NULL), BAD, "out_info: NULL");
    shd_assert_result("info", shd_framebuffer_get_info(NULL, &info), BAD, "framebuffer: NULL");
    assert_true(info.width == 0 && info.height == 0 && info.sample_count == 0 && info.aovs == 0 && info.byte_size == 0);
    assert_int_equal(info.struct_size, sizeof info);
    info.struct_size = 8;
    shd_assert_result("info", shd_framebuffer_get_info(framebuffer, &info), BAD, "out_info.struct_size: 8 is below 16");
    view.struct_size = 0;
    shd_assert_result("view", shd_framebuffer_view_plane(framebuffer, SHD_PLANE_R, &view), BAD,
                      "out_view.struct_size: 0");
    view.struct_size = sizeof view - 4;
    shd_assert_result("view", shd_framebuffer_view_plane(framebuffer, SHD_PLANE_R, &view), BAD,
                      "out_view.struct_size: 28 is not a multiple of 8, the alignment of the struct");
    shd_framebuffer_release(framebuffer);
}

struct color_case {
    const char *name;
    shd_format format;
    uint32_t width, height;
    size_t offset, stride; /* stride of pixels, in bytes */
    shd_result expected;
    const char *message;
};
static const struct color_case k_color[] = {
    {"color/rgba8", SHD_FORMAT_RGBA8, 7, 3, 0, 0, SHD_OK, ""},
    {"color/rgba8_srgb", SHD_FORMAT_RGBA8_SRGB, 7, 3, 1, 31, SHD_OK, ""},
    {"color/rgba16", SHD_FORMAT_RGBA16, 7, 3, 2, 58, SHD_OK, ""},
    {"color/rgba16f", SHD_FORMAT_RGBA16F, 7, 3, 0, 64, SHD_OK, ""},
    {"color/rgba32f", SHD_FORMAT_RGBA32F, 7, 3, 4, 116, SHD_OK, ""},
    {"color/r8", SHD_FORMAT_R8, 7, 3, 0, 0, BAD, "out.format: 1 is not an RGBA format"},
    {"color/format_0", SHD_FORMAT_NONE, 7, 3, 0, 0, BAD, "out.format: 0"},
    {"color/format_99", (shd_format)99, 7, 3, 0, 0, BAD, "out.format: 99"},
    {"color/format_negative", (shd_format)-1, 7, 3, 0, 0, BAD, "out.format: 4294967295 is not a format"},
    {"color/width_6", SHD_FORMAT_RGBA8, 6, 3, 0, 0, BAD, "out.width: 6x3 is not the framebuffer's 7x3"},
    {"color/height_4", SHD_FORMAT_RGBA8, 7, 4, 0, 0, BAD, "out.height: 7x4"},
    {"color/width_0", SHD_FORMAT_RGBA8, 0, 3, 0, 0, BAD, "out.width: 0"},
    {"color/height_uint32_max", SHD_FORMAT_RGBA8, 7, 0xffffffffu, 0, 0, BAD, "out.height: 4294967295"},
    {"color/stride_27", SHD_FORMAT_RGBA8, 7, 3, 0, 27, BAD, "out.row_stride: 27 is below 28"},
    {"color/stride_size_max", SHD_FORMAT_RGBA8, 7, 3, 0, SIZE_MAX, BAD, "out.row_stride: "},
    {"color/rgba16_odd_address", SHD_FORMAT_RGBA16, 7, 3, 1, 0, BAD, "out.pixels: "},
    {"color/rgba32f_stride_114", SHD_FORMAT_RGBA32F, 7, 3, 0, 114, BAD, "out.pixels: "},
};

static void test_color(void **state)
{
    const struct color_case *c = (const struct color_case *)*state;
    enum { k_size = 1024 };
    static union {
        float align;
        unsigned char bytes[k_size];
    } memory;
    const size_t pixel = shd_format_size(c->format);
    const size_t stride = c->stride ? c->stride : 7 * pixel;
    shd_framebuffer *framebuffer = make(7, 3, 0);
    shd_image image = shd_image_default();
    shd_result result;
    size_t i, y;
    memset(memory.bytes, 0xa5, k_size);
    image.format = c->format;
    image.width = c->width;
    image.height = c->height;
    image.row_stride = c->stride;
    image.pixels = memory.bytes + c->offset;
    result = shd_framebuffer_read_color(framebuffer, &image);
    shd_assert_result(c->name, result, c->expected, c->message);
    if (result == SHD_OK) { /* an empty frame is 0 in every format; bytes between rows do not change */
        for (y = 0; y < 3; ++y) {
            for (i = 0; i < 7 * pixel; ++i) {
                unsigned char *byte = &memory.bytes[c->offset + y * stride + i];
                assert_int_equal(*byte, 0);
                *byte = 0xa5;
            }
        }
    }
    for (i = 0; i < k_size; ++i) assert_int_equal(memory.bytes[i], 0xa5);
    shd_framebuffer_release(framebuffer);
}

static void test_color_null(void **state)
{
    shd_framebuffer *framebuffer = make(7, 3, 0);
    shd_image image = shd_image_default();
    (void)state;
    shd_assert_result("image", shd_framebuffer_read_color(framebuffer, NULL), BAD, "out: NULL");
    image.format = SHD_FORMAT_RGBA8;
    image.width = 7;
    image.height = 3;
    shd_assert_result("pixels", shd_framebuffer_read_color(framebuffer, &image), BAD, "out.pixels: NULL");
    shd_assert_result("handle", shd_framebuffer_read_color(NULL, &image), BAD, "framebuffer: NULL");
    shd_framebuffer_release(framebuffer);
}

/* Every position lies on the standard's grid and is that of one sample; samples of a pixel share no row or column. The
 * values themselves are checked by unit.raster.sample_pattern and, in frames, by api.render_samples. */
static void test_sample_positions(void **state)
{
    uint32_t samples, s;
    (void)state;
    for (samples = 1; samples <= 16; samples *= 2) {
        unsigned columns = 0, rows = 0;
        for (s = 0; s < samples; ++s) {
            float x = -1, y = -1;
            shd_assert_ok(shd_sample_position(samples, s, &x, &y));
            assert_true(x >= 0 && x < 1 && y >= 0 && y < 1);
            assert_true(x * 16 == (float)(int)(x * 16) && y * 16 == (float)(int)(y * 16));
            assert_false(columns >> (int)(x * 16) & 1 || rows >> (int)(y * 16) & 1);
            columns |= 1u << (int)(x * 16);
            rows |= 1u << (int)(y * 16);
        }
    }
}

struct position_case {
    const char *name;
    uint32_t samples, index;
    float x, y; /* 0 on failure */
    shd_result expected;
    const char *message;
};
static const struct position_case k_positions[] = {
    {"position/1", 1, 0, 0.5f, 0.5f, SHD_OK, ""},
    {"position/4_last", 4, 3, 0.625f, 0.875f, SHD_OK, ""},
    {"position/16_second", 16, 2, 0.3125f, 0.625f, SHD_OK, ""},
    {"position/16_eleventh", 16, 11, 0.125f, 0.75f, SHD_OK, ""},
    {"position/samples_0", 0, 0, 0, 0, BAD, "sample_count: 0 is not 1, 2, 4, 8 or 16"},
    {"position/samples_3", 3, 0, 0, 0, BAD, "sample_count: 3 is not 1, 2, 4, 8 or 16"},
    {"position/samples_32", 32, 0, 0, 0, BAD, "sample_count: 32 is not"},
    {"position/samples_max", 0xffffffffu, 0, 0, 0, BAD, "sample_count: 4294967295 is not"},
    {"position/index_1_of_1", 1, 1, 0, 0, BAD, "index: 1 is not in 0..0"},
    {"position/index_8_of_8", 8, 8, 0, 0, BAD, "index: 8 is not in 0..7"},
    {"position/index_max", 16, 0xffffffffu, 0, 0, BAD, "index: 4294967295 is not in 0..15"},
};

static void test_position(void **state)
{
    const struct position_case *c = (const struct position_case *)*state;
    float x = -1, y = -1;
    shd_assert_result(c->name, shd_sample_position(c->samples, c->index, &x, &y), c->expected, c->message);
    assert_true(x == c->x && y == c->y);
}

static void test_position_null(void **state)
{
    float value = -1;
    (void)state;
    shd_assert_result("x", shd_sample_position(4, 0, NULL, &value), BAD, "out_x: NULL");
    assert_true(value == 0);
    value = -1;
    shd_assert_result("y", shd_sample_position(4, 0, &value, NULL), BAD, "out_y: NULL");
    assert_true(value == 0);
    shd_assert_result("both", shd_sample_position(3, 0, NULL, NULL), BAD, "sample_count: 3");
}

static void test_null_desc(void **state)
{
    shd_framebuffer *framebuffer = (shd_framebuffer *)&g_context;
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    (void)state;
    shd_assert_result("null", shd_framebuffer_create(g_context, NULL, &framebuffer), BAD, "framebuffer: NULL");
    assert_null(framebuffer);
    desc.struct_size = 1u << 20;
    shd_assert_result("size", shd_framebuffer_create(g_context, &desc, &framebuffer), BAD,
                      "framebuffer.struct_size: 1048576");
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_create) + COUNT(k_color) + COUNT(k_planes) + COUNT(k_positions) + 8];
    size_t n = 0, i;
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < COUNT(k_create); ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    for (i = 0; i < COUNT(k_color); ++i) {
        tests[n++] = (struct CMUnitTest){k_color[i].name, test_color, NULL, NULL, (void *)&k_color[i]};
    }
    tests[n++] = (struct CMUnitTest){"create/null_desc", test_null_desc, NULL, NULL, NULL};
    for (i = 0; i < COUNT(k_planes); ++i) {
        tests[n++] = (struct CMUnitTest){k_planes[i].name, test_plane, NULL, NULL, (void *)&k_planes[i]};
    }
    for (i = 0; i < COUNT(k_positions); ++i) {
        tests[n++] = (struct CMUnitTest){k_positions[i].name, test_position, NULL, NULL, (void *)&k_positions[i]};
    }
    tests[n++] = (struct CMUnitTest){"position/all", test_sample_positions, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"position/null", test_position_null, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bad_u32_reads", test_bad_u32_reads, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bad_reads", test_bad_reads, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"color/null", test_color_null, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.framebuffer", tests, n, NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
