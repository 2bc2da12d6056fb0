/* SPDX-License-Identifier: MIT */
/* Framebuffers: every field of the desc, planes, and what a new one reads as in every format. */
#include "support/check.h"

#include <shd/framebuffer.h>

static shd_context *g_context;

#define ALL_AOVS (SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE)

struct create_case {
    const char *name;
    uint32_t width, height, samples, aovs, reserved;
    shd_result expected;
    const char *message;
    size_t least_bytes; /* width * height * planes * 4 */
};

#define BAD SHD_ERROR_INVALID_ARGUMENT
static const struct create_case k_create[] = {
    {"create/1x1", 1, 1, 1, 0, 0, SHD_OK, "", 20},
    {"create/17x3", 17, 3, 1, 0, 0, SHD_OK, "", 1020},
    {"create/17x3_all_aovs", 17, 3, 1, ALL_AOVS, 0, SHD_OK, "", 2244},
    {"create/64x64_uv", 64, 64, 1, SHD_AOV_UV, 0, SHD_OK, "", 114688},
    {"create/16384x1", 16384, 1, 1, SHD_AOV_TRIANGLE, 0, SHD_OK, "", 393216},
    {"create/1x16384", 1, 16384, 1, SHD_AOV_NORMAL, 0, SHD_OK, "", 524288},
    {"create/width_0", 0, 4, 1, 0, 0, BAD, "framebuffer.width: 0 is not in 1..16384", 0},
    {"create/height_0", 4, 0, 1, 0, 0, BAD, "framebuffer.height: 0 is not in 1..16384", 0},
    {"create/width_16385", 16385, 4, 1, 0, 0, BAD, "framebuffer.width: 16385", 0},
    {"create/height_uint32_max", 4, 0xffffffffu, 1, 0, 0, BAD, "framebuffer.height: 4294967295", 0},
    {"create/samples_0", 4, 4, 0, 0, 0, BAD, "framebuffer.samples: 0", 0},
    {"create/samples_2", 4, 4, 2, 0, 0, SHD_OK, "", 320},
    {"create/samples_3", 4, 4, 3, 0, 0, BAD, "framebuffer.samples: 3 is not 1, 2, 4, 8 or 16", 0},
    {"create/samples_4", 4, 4, 4, 0, 0, SHD_OK, "", 320},
    {"create/samples_8", 4, 4, 8, 0, 0, SHD_OK, "", 320},
    {"create/samples_16", 4, 4, 16, 0, 0, SHD_OK, "", 320},
    {"create/samples_64", 4, 4, 64, 0, 0, BAD, "framebuffer.samples: 64", 0},
    {"create/aovs_unknown", 4, 4, 1, 9, 0, SHD_ERROR_UNSUPPORTED, "framebuffer.aovs: bits 0x8 ", 0},
    {"create/reserved_5", 4, 4, 1, 0, 5, BAD, "framebuffer.reserved: 5 is not 0", 0},
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
    shd_framebuffer_info info;
    desc.width = c->width;
    desc.height = c->height;
    desc.samples = c->samples;
    desc.aovs = c->aovs;
    desc.reserved = c->reserved;
    shd_assert_result(c->name, shd_framebuffer_create(g_context, &desc, &framebuffer), c->expected, c->message);
    if (c->expected != SHD_OK) {
        assert_null(framebuffer);
        return;
    }
    shd_assert_ok(shd_framebuffer_get_info(framebuffer, &info));
    assert_int_equal(info.width, c->width);
    assert_int_equal(info.height, c->height);
    assert_int_equal(info.samples, c->samples);
    assert_int_equal(info.aovs, c->aovs);
    assert_true(info.byte_size >= c->least_bytes);
    shd_framebuffer_release(framebuffer);
}

static int is_there(uint32_t aovs, int plane)
{
    if (plane <= SHD_PLANE_DEPTH) return 1;
    if (plane <= SHD_PLANE_V) return (aovs & SHD_AOV_UV) != 0;
    if (plane <= SHD_PLANE_NZ) return (aovs & SHD_AOV_NORMAL) != 0;
    return (aovs & SHD_AOV_TRIANGLE) != 0;
}

/* Each plane of each combination: there or NOT_FOUND, with the value of an empty frame. */
static void test_planes(void **state)
{
    enum { k_width = 19, k_height = 5, k_pixels = k_width * k_height };
    uint32_t aovs;
    (void)state;
    for (aovs = 0; aovs <= ALL_AOVS; ++aovs) {
        shd_framebuffer *framebuffer = make(k_width, k_height, aovs);
        int plane;
        for (plane = SHD_PLANE_R; plane <= SHD_PLANE_NZ; ++plane) {
            const float want = plane == SHD_PLANE_DEPTH ? 1.0f : 0.0f;
            float pixels[2 * k_pixels + 2];
            shd_f32_out packed = {pixels, 0}, strided = {pixels, 8};
            shd_plane_view view = {pixels, NULL, 77};
            shd_result result;
            size_t i;
            for (i = 0; i < 2 * k_pixels + 2; ++i) pixels[i] = -7.0f;
            result = shd_framebuffer_view_plane(framebuffer, (shd_plane)plane, &view);
            if (!is_there(aovs, plane)) {
                shd_assert_result("view", result, SHD_ERROR_NOT_FOUND, "plane: ");
                assert_true(!view.f32 && !view.u32 && view.row_stride == 0);
                shd_assert_result("read", shd_framebuffer_read_plane(framebuffer, (shd_plane)plane, packed),
                                  SHD_ERROR_NOT_FOUND, "plane: ");
                assert_true(pixels[0] == -7.0f);
                continue;
            }
            shd_assert_ok(result);
            assert_true(view.f32 && !view.u32 && view.row_stride >= k_width * sizeof(float));
            assert_true((uintptr_t)view.f32 % 64 == 0 && view.row_stride % 64 == 0);
            for (i = 0; i < k_pixels; ++i) {
                assert_true(view.f32[i / k_width * (view.row_stride / 4) + i % k_width] == want);
            }
            shd_assert_ok(shd_framebuffer_read_plane(framebuffer, (shd_plane)plane, packed));
            for (i = 0; i < k_pixels; ++i) assert_true(pixels[i] == want);
            assert_true(pixels[k_pixels] == -7.0f);
            for (i = 0; i < 2 * k_pixels; ++i) pixels[i] = -7.0f;
            shd_assert_ok(shd_framebuffer_read_plane(framebuffer, (shd_plane)plane, strided));
            for (i = 0; i < k_pixels; ++i) assert_true(pixels[2 * i] == want && pixels[2 * i + 1] == -7.0f);
        }
        shd_framebuffer_release(framebuffer);
    }
}

static void test_triangles(void **state)
{
    uint32_t ids[3 * 15 + 1];
    shd_framebuffer *with = make(5, 3, SHD_AOV_TRIANGLE), *without = make(5, 3, 0);
    shd_u32_out packed = {ids, 0}, strided = {ids, 12}, none = {NULL, 0}, odd = {ids, 6};
    shd_f32_out floats = {(float *)(void *)ids, 0};
    shd_plane_view view;
    size_t i;
    (void)state;
    memset(ids, 0x55, sizeof ids);
    shd_assert_ok(shd_framebuffer_read_triangles(with, packed));
    for (i = 0; i < 15; ++i) assert_int_equal(ids[i], 0xffffffffu);
    assert_int_equal(ids[15], 0x55555555u);
    memset(ids, 0x55, sizeof ids);
    shd_assert_ok(shd_framebuffer_read_triangles(with, strided));
    for (i = 0; i < 45; ++i) assert_int_equal(ids[i], i % 3 ? 0x55555555u : 0xffffffffu);
    assert_int_equal(ids[45], 0x55555555u);
    shd_assert_ok(shd_framebuffer_view_plane(with, SHD_PLANE_TRIANGLE, &view));
    assert_true(view.u32 && !view.f32 && view.u32[0] == 0xffffffffu);
    shd_assert_result("absent", shd_framebuffer_read_triangles(without, packed), SHD_ERROR_NOT_FOUND, "plane: 10");
    shd_assert_result("null", shd_framebuffer_read_triangles(with, none), BAD, "out.data: NULL");
    shd_assert_result("stride", shd_framebuffer_read_triangles(with, odd), BAD, "out.stride: 6");
    shd_assert_result("float", shd_framebuffer_read_plane(with, SHD_PLANE_TRIANGLE, floats), BAD,
                      "plane: SHD_PLANE_TRIANGLE holds integers");
    shd_framebuffer_release(with);
    shd_framebuffer_release(without);
}

static void test_bad_reads(void **state)
{
    float pixels[64];
    shd_framebuffer *framebuffer = make(4, 4, 0);
    shd_f32_out out = {pixels, 0}, none = {NULL, 0}, odd = {pixels, 2}, huge = {pixels, SIZE_MAX - 3};
    shd_plane_view view = {pixels, NULL, 1};
    shd_framebuffer_info info = {1, 2, 3, 4, 5};
    (void)state;
    shd_assert_result("unknown", shd_framebuffer_read_plane(framebuffer, (shd_plane)11, out), BAD,
                      "plane: 11 is not in 0..10");
    shd_assert_result("negative", shd_framebuffer_read_plane(framebuffer, (shd_plane)-1, out), BAD, "plane: ");
    shd_assert_result("null", shd_framebuffer_read_plane(framebuffer, SHD_PLANE_R, none), BAD, "out.data: NULL");
    shd_assert_result("stride", shd_framebuffer_read_plane(framebuffer, SHD_PLANE_R, odd), BAD, "out.stride: 2");
    shd_assert_result("overflow", shd_framebuffer_read_plane(framebuffer, SHD_PLANE_R, huge), BAD, "out: 16 elements");
    shd_assert_result("handle", shd_framebuffer_read_plane(NULL, SHD_PLANE_R, out), BAD, "framebuffer: NULL");
    shd_assert_result("view", shd_framebuffer_view_plane(framebuffer, (shd_plane)99, &view), BAD, "plane: 99");
    assert_true(!view.f32 && view.row_stride == 0);
    shd_assert_result("view", shd_framebuffer_view_plane(framebuffer, SHD_PLANE_R, NULL), BAD, "out_view: NULL");
    shd_assert_result("info", shd_framebuffer_get_info(framebuffer, NULL), BAD, "out_info: NULL");
    shd_assert_result("info", shd_framebuffer_get_info(NULL, &info), BAD, "framebuffer: NULL");
    assert_true(info.width == 0 && info.height == 0 && info.samples == 0 && info.aovs == 0 && info.byte_size == 0);
    shd_framebuffer_release(framebuffer);
}

struct color_case {
    const char *name;
    shd_format format;
    uint32_t width, height;
    size_t offset, stride; /* of pixels, in bytes */
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
    if (result == SHD_OK) { /* an empty frame is 0 in every format; what lies between rows stays */
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
    static struct CMUnitTest tests[COUNT(k_create) + COUNT(k_color) + 8];
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
    tests[n++] = (struct CMUnitTest){"planes", test_planes, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"triangles", test_triangles, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bad_reads", test_bad_reads, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"color/null", test_color_null, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.framebuffer", tests, n, NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
