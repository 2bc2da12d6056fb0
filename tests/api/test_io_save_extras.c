/* SPDX-License-Identifier: MIT */
/* The parts of a save besides the planes: texts, channels and matrices of OpenEXR, distances, compressions and JPEG. */
#define _GNU_SOURCE
#include "support/io_files.h"

enum { WIDTH = 16, HEIGHT = 2, PIXELS = WIDTH * HEIGHT };

static shd_context *g_context;
static shd_framebuffer *g_framebuffer;

static int set_up(void **state)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    desc.width = WIDTH;
    desc.height = HEIGHT;
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

/* The memory of a plane of the framebuffer, packed. */
static float *plane(shd_plane plane)
{
    shd_plane_view view = shd_plane_view_default();
    shd_assert_ok(shd_framebuffer_view_plane(g_framebuffer, plane, &view));
    assert_int_equal(view.row_stride, WIDTH * sizeof(float));
    return (float *)(uintptr_t)view.f32;
}

/* The bytes of a saved file. */
struct bytes {
    unsigned char data[1 << 16];
    size_t size;
};

static void save_bytes(const char *name, shd_save_desc desc, struct bytes *out)
{
    io_bytes file;
    shd_assert_ok(shd_framebuffer_save(g_framebuffer, io_path(name), &desc));
    file = io_read(io_path(name));
    assert_true(file.size <= sizeof out->data);
    memcpy(out->data, file.data, file.size);
    out->size = file.size;
    free(file.data);
}

/* The value of an attribute in the header of an OpenEXR file: name, 0, type, 0, size, value. */
static const unsigned char *attribute(const struct bytes *file, const char *name, const char *type, uint32_t *size)
{
    const size_t names = strlen(name) + 1, types = strlen(type) + 1;
    char mark[256];
    const unsigned char *at;
    memcpy(mark, name, names);
    memcpy(mark + names, type, types);
    at = memmem(file->data, file->size, mark, names + types);
    if (!at) fail_msg("no attribute %s of type %s", name, type);
    memcpy(size, at + names + types, sizeof *size);
    return at + names + types + sizeof *size;
}

static void test_texts(void **state)
{
    static const shd_file_attribute texts[2] = {{"Software", "a test"},
                                                {"cryptomatte/0123456/name",
                                                 "m\xc3\xa4"
                                                 "dchen"}};
    static struct bytes with, without;
    shd_save_desc desc = shd_save_desc_default();
    const unsigned char *value;
    uint32_t size, i;
    (void)state;
    desc.attributes = texts;
    desc.attribute_count = 2;
    save_bytes("a.exr", desc, &with);
    for (i = 0; i < 2; ++i) {
        value = attribute(&with, texts[i].name, "string", &size);
        assert_int_equal(size, strlen(texts[i].text));
        assert_memory_equal(value, texts[i].text, size);
    }
    save_bytes("a.png", desc, &with); /* other formats have none */
    save_bytes("a.png", shd_save_desc_default(), &without);
    assert_int_equal(with.size, without.size);
}

/* A channel of every other number of an array, in order. */
static void test_channels(void **state)
{
    static const shd_file_channel channel = {"mask.x", {NULL, 8}};
    static struct bytes bytes;
    shd_file_channel channels[2] = {channel, channel};
    shd_save_desc desc = shd_save_desc_default();
    float numbers[2 * PIXELS], row[WIDTH];
    const unsigned char *at;
    int i;
    (void)state;
    for (i = 0; i < 2 * PIXELS; ++i) numbers[i] = (float)i + 0.5f;
    channels[0].column.data = channels[1].column.data = numbers;
    desc.channels = channels;
    desc.channel_count = 1;
    desc.compression = "none";
    save_bytes("a.exr", desc, &bytes);
    for (i = 0; i < WIDTH; ++i) row[i] = numbers[2 * (WIDTH + i)];
    at = memmem(bytes.data, bytes.size, row, sizeof row); /* the second row, as it is in memory */
    assert_non_null(at);
    desc.channel_count = 2;
    shd_assert_result("twice", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.channels[1].name: there are two channels \"mask.x\"");
    channels[1].name = "Z";
    shd_assert_result("plane", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.channels[1].name: there are two channels \"Z\"");
}

/* Depths of known distances, and matrices by their definition. */
static void test_view(void **state)
{
    static const double distances[4] = {1, 2.5, 7, 10}; /* from the near plane to the far one */
    static struct bytes bytes;
    shd_camera camera = shd_camera_default();
    shd_save_desc desc = shd_save_desc_default();
    shd_view view;
    float *depth = plane(SHD_PLANE_DEPTH), row[WIDTH], m[16];
    const unsigned char *at;
    uint32_t size;
    int ortho, i;
    (void)state;
    camera.near_plane = 1;
    camera.far_plane = 10;
    camera.aspect = 2;
    shd_assert_ok(shd_view_from_camera(&camera, &view)); /* the eye at (0, 0, 3), which looks along -Z */
    desc.view = &view;
    desc.compression = "none";
    for (ortho = 0; ortho < 2; ++ortho) {
        if (ortho) {
            const float flat[16] = {0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, -1 / 9.0f, 0, 0, 0, -1 / 9.0f, 1};
            memcpy(view.view_to_clip, flat, sizeof flat);
        }
        for (i = 0; i < PIXELS; ++i) {
            const double d = distances[i % 4];
            depth[i] = (float)(ortho ? (d - 1) / 9 : 10 * (d - 1) / (9 * d));
        }
        save_bytes("a.exr", desc, &bytes);
        at = attribute(&bytes, "worldToCamera", "m44f", &size);
        memcpy(m, at, sizeof m);
        assert_int_equal(size, sizeof m);
        for (i = 0; i < 16; ++i) { /* x and y stay, z is 3 - z */
            const float wanted = i == 0 || i == 5 || i == 15 ? 1.0f : i == 10 ? -1.0f : i == 14 ? 3.0f : 0.0f;
            shd_assert_close("worldToCamera", (size_t)i, m[i], wanted, 1e-6, 0);
        }
        memcpy(m, attribute(&bytes, "worldToNDC", "m44f", &size), sizeof m);
        for (i = 0; i < 2; ++i) { /* a point on the upper edge above the eye, and one on the left edge */
            const double x = i == 0 ? 0 : -1, y = i == 0 ? 1 : 0;
            const double half_x = ortho ? 2 : 1 / (double)view.view_to_clip[0];
            const double half_y = ortho ? 2 : 1 / (double)view.view_to_clip[5]; /* half sides at distance 1 */
            const double px = x * half_x, py = y * half_y, pz = 2;
            const double w = px * m[3] + py * m[7] + pz * m[11] + m[15];
            shd_assert_close("ndc x", (size_t)i, (px * m[0] + py * m[4] + pz * m[8] + m[12]) / w, i == 0 ? 0.5 : 0,
                             1e-6, 0);
            shd_assert_close("ndc y", (size_t)i, (px * m[1] + py * m[5] + pz * m[9] + m[13]) / w, i == 0 ? 0 : 0.5,
                             1e-6, 0);
        }
        /* Channels are in the order of the alphabet: Z is the last one of the last row. */
        memcpy(row, bytes.data + bytes.size - sizeof row, sizeof row);
        for (i = 0; i < WIDTH; ++i) shd_assert_close("Z", (size_t)i, row[i], distances[i % 4], 0, 1e-5);
    }
    memset(view.view_to_clip, 0, sizeof view.view_to_clip);
    shd_assert_result("view", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.view.view_to_clip: the matrix has no inverse");
    view.world_to_view[7] = NAN;
    shd_assert_result("nan", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.view.world_to_view[7]: nan is not finite");
    view.world_to_view[7] = 0;
    view.view_to_clip[15] = -INFINITY;
    shd_assert_result("infinity", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc),
                      SHD_ERROR_INVALID_ARGUMENT, "save.view.view_to_clip[15]: -inf is not finite");
    desc.compression = NULL;
    shd_assert_ok(shd_framebuffer_save(g_framebuffer, io_path("flat.png"), &desc)); /* other formats have no Z */
}

/* JPEG shows the codes of PNG over black. */
static void test_jpeg(void **state)
{
    static const float alphas[3] = {1, 0.5f, 0};
    shd_save_desc desc = shd_save_desc_default();
    size_t k;
    int i;
    (void)state;
    desc.encoding = SHD_COLOR_ENCODING_LINEAR;
    desc.compression = "100";
    for (k = 0; k < 3; ++k) {
        shd_bitmap *bitmap = NULL;
        shd_image image = shd_image_default();
        for (i = 0; i < PIXELS; ++i) {
            plane(SHD_PLANE_R)[i] = plane(SHD_PLANE_G)[i] = plane(SHD_PLANE_B)[i] = 0.8f * alphas[k];
            plane(SHD_PLANE_A)[i] = alphas[k];
        }
        shd_assert_ok(shd_framebuffer_save(g_framebuffer, io_path("a.jpeg"), &desc));
        shd_assert_ok(shd_bitmap_load(g_context, io_path("a.jpeg"), NULL, &bitmap));
        shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
        for (i = 0; i < 4 * PIXELS; ++i) {
            const double wanted = i % 4 == 3 ? 255 : 204.0 * (double)alphas[k];
            shd_assert_close("code", (size_t)i, ((const uint8_t *)image.pixels)[i], wanted, 1.01, 0);
        }
        shd_bitmap_release(bitmap);
    }
    desc.bit_depth = 16;
    shd_assert_result("depth", shd_framebuffer_save(g_framebuffer, "a.jpg", &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.bit_depth: 16 is not one that .jpg has");
}

struct refusal {
    const char *path, *compression, *name, *text, *message;
};
static const struct refusal k_refused[] = {
    {"r.exr", "lzw", "x", "", "save.compression: \"lzw\" is not one of none rle"},
    {"r.exr", "", "x", "", "save.compression: \"\" is not one of none rle"},
    {"r.exr", "none rle", "x", "", "save.compression: \"none rle\" is not one of"},
    {"r.tif", "piz", "x", "", "save.compression: \"piz\" is not one of none lzw"},
    {"r.png", "zip", "x", "", "save.compression: .png has none to choose"},
    {"r.hdr", "zip", "x", "", "save.compression: .hdr has none to choose"},
    {"r.jpg", "0", "x", "", "save.compression: \"0\" is not a quality of 1..100"},
    {"r.jpg", "101", "x", "", "save.compression: \"101\" is not a quality of 1..100"},
    {"r.jpg", "-5", "x", "", "save.compression: \"-5\" is not a quality of 1..100"},
    {"r.jpg", "", "x", "", "save.compression: \"\" is not a quality of 1..100"},
    {"r.exr", NULL, NULL, "", "save.attributes[0].name: NULL"},
    {"r.exr", NULL, "", "", "save.attributes[0].name: \"\" is not 1..255 printable bytes"},
    {"r.png", NULL, "a\nb", "", "save.attributes[0].name: \"a b\" is not 1..255 printable bytes"},
    {"r.exr", NULL, "channels", "", "save.attributes[0].name: \"channels\" is set by the writer"},
    {"r.exr", NULL, "worldToNDC", "", "save.attributes[0].name: \"worldToNDC\" is set by the writer"},
    {"r.exr", NULL, "x", NULL, "save.attributes[0].text: NULL"},
};

static void test_refused(void **state)
{
    static float pixels[4];
    char longest[257];
    shd_file_attribute text = {longest, ""};
    shd_file_channel channel = {"x", {NULL, 0}};
    shd_save_desc desc;
    shd_image image = shd_image_default();
    size_t i;
    (void)state;
    for (i = 0; i < sizeof k_refused / sizeof *k_refused; ++i) {
        const shd_file_attribute one = {k_refused[i].name, k_refused[i].text};
        desc = shd_save_desc_default();
        desc.compression = k_refused[i].compression;
        desc.attributes = &one;
        desc.attribute_count = 1;
        shd_assert_result(k_refused[i].message, shd_framebuffer_save(g_framebuffer, io_path(k_refused[i].path), &desc),
                          SHD_ERROR_INVALID_ARGUMENT, k_refused[i].message);
        assert_int_equal(io_count_files(k_refused[i].path, 0), 0);
    }
    desc = shd_save_desc_default();
    memset(longest, 'a', 256);
    longest[256] = 0;
    desc.attributes = &text;
    desc.attribute_count = 1;
    shd_assert_result("long", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "is not 1..255 printable bytes");
    desc.attribute_count = 1025;
    shd_assert_result("many", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.attribute_count: 1025 is not in 0..1024");
    desc = shd_save_desc_default();
    desc.channel_count = 1;
    shd_assert_result("null", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.channels: NULL, but the count is 1");
    desc.channels = &channel;
    shd_assert_result("data", shd_framebuffer_save(g_framebuffer, io_path("b.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.channels[0].column.data: NULL");
    image.format = SHD_FORMAT_RGBA32F;
    image.width = image.height = 1;
    image.pixels = pixels;
    shd_assert_result("image", shd_image_save(&image, io_path("a.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.channels: an image has its own alone");
    desc = shd_save_desc_default();
    desc.view = (const shd_view *)(const void *)pixels;
    shd_assert_result("image", shd_image_save(&image, io_path("a.exr"), &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.view: an image has none");
    shd_assert_result("jpeg", shd_image_save(&image, io_path("a.jpg"), NULL), SHD_ERROR_UNSUPPORTED,
                      "cannot be stored in .jpg as they are");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_texts), cmocka_unit_test(test_channels), cmocka_unit_test(test_view),
        cmocka_unit_test(test_jpeg),  cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests_name("api.io_save_extras", tests, set_up, tear_down);
}
