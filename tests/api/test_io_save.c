/* SPDX-License-Identifier: MIT */
/* Saving: round trips of images and framebuffers, and every failure of writing. */
#define _GNU_SOURCE
#include "support/io_files.h"
#include "support/rows.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>

enum { WIDTH = 7, HEIGHT = 5, PIXELS = WIDTH * HEIGHT };

static shd_context *g_context;

/* Images. */

struct image_case {
    const char *file;
    shd_format format;
    shd_color_encoding encoding;
    shd_format loaded; /* format of the bitmap; NONE = the save is refused */
    const char *color_space;
    int channels; /* channels of the loaded file */
    double tolerance;
};

static const struct image_case k_images[] = {
    {"i_srgb.png", SHD_FORMAT_RGBA8_SRGB, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, "sRGB", 4, 0},
    {"i_untagged.png", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, "sRGB", 4, 0},
    {"i_linear.PNG", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_LINEAR, SHD_FORMAT_RGBA8, "Linear Rec.709", 4, 0},
    {"i_16.png", SHD_FORMAT_RGBA16, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA16, "sRGB", 4, 0},
    {"i_grey.png", SHD_FORMAT_R8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, "sRGB", 1, 0},
    {"i_half.exr", SHD_FORMAT_RGBA16F, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA16F, "Linear Rec.709", 4, 0},
    {"i_float.exr", SHD_FORMAT_RGBA32F, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA32F, "Linear Rec.709", 4, 0},
    {"i_float.hdr", SHD_FORMAT_RGBA32F, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA32F, "Linear Rec.709", 3, 1.0 / 128},
    {"i_8.tif", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, "sRGB", 4, 0},
    {"i_srgb.tiff", SHD_FORMAT_RGBA8_SRGB, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, "sRGB", 4, 0},
    {"i_16.tif", SHD_FORMAT_RGBA16, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA16, "sRGB", 4, 0},
    {"i_half.tif", SHD_FORMAT_RGBA16F, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "cannot be stored in .tif", 0, 0},
    {"i_float.tif", SHD_FORMAT_RGBA32F, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA32F, "Linear Rec.709", 4, 0},
    {"i_8.tga", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, "sRGB", 4, 0},
    {"i_8.bmp", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, "sRGB", 3, 0},
    {"i_float.png", SHD_FORMAT_RGBA32F, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "cannot be stored in .png", 0, 0},
    {"i_8.exr", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "cannot be stored in .exr", 0, 0},
    {"i_16.hdr", SHD_FORMAT_RGBA16, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "cannot be stored in .hdr", 0, 0},
    {"i_16.tga", SHD_FORMAT_RGBA16, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "cannot be stored in .tga", 0, 0},
    {"i_8.jpg", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "cannot be stored in .jpg as they are", 0,
     0},
    {"i_none", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "extension \"\" is not", 0, 0},
};

/* Rows are padded, so that ignoring the stride is detected. */
static union {
    unsigned char bytes[HEIGHT][WIDTH * 16 + 16];
    uint16_t words[HEIGHT][WIDTH * 8 + 8];
    float floats[HEIGHT][WIDTH * 4 + 4];
} g_pixels;

static shd_image make_image(shd_format format)
{
    shd_image image = shd_image_default();
    int x, y;
    image.format = format;
    image.width = WIDTH;
    image.height = HEIGHT;
    image.pixels = &g_pixels;
    image.row_stride = sizeof g_pixels.bytes[0];
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH * 4; ++x) {
            if (format == SHD_FORMAT_RGBA32F) {
                g_pixels.floats[y][x] = (float)(1 + x + 31 * y) / 64.0f;
            } else if (format == SHD_FORMAT_RGBA16F) {
                g_pixels.words[y][x] = (uint16_t)(0x2c00 + 101 * x + 13 * y);
            } else if (format == SHD_FORMAT_RGBA16) {
                g_pixels.words[y][x] = (uint16_t)(65535 - 1999 * x - 7 * y);
            } else {
                g_pixels.bytes[y][x] = (unsigned char)(255 - 9 * x - y);
            }
        }
    }
    return image;
}

/* Number of channel c of pixel (x, y) as stored; grey repeats. */
static double stored_value(const shd_image *image, int x, int y, int c)
{
    const unsigned char *row = (const unsigned char *)image->pixels + (size_t)y * image->row_stride;
    switch (image->format) {
        case SHD_FORMAT_R8: return row[x];
        case SHD_FORMAT_RGBA32F: return (double)((const float *)(const void *)row)[4 * x + c];
        case SHD_FORMAT_RGBA16F:
        case SHD_FORMAT_RGBA16: return ((const uint16_t *)(const void *)row)[4 * x + c];
        default: return row[4 * x + c];
    }
}

static void test_image(void **state)
{
    const struct image_case *c = (const struct image_case *)*state;
    const shd_image image = make_image(c->format);
    shd_save_desc desc = shd_save_desc_default();
    shd_bitmap *bitmap = NULL;
    shd_image loaded = shd_image_default();
    int x, y, k;
    desc.encoding = c->encoding;
    if (c->loaded == SHD_FORMAT_NONE) {
        shd_assert_result(c->file, shd_image_save(&image, io_path(c->file), &desc), SHD_ERROR_UNSUPPORTED,
                          c->color_space);
        assert_int_equal(access(io_path(c->file), F_OK), -1);
        return;
    }
    shd_assert_ok(shd_image_save(&image, io_path(c->file), &desc));
    shd_assert_ok(shd_bitmap_load(g_context, io_path(c->file), NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &loaded));
    assert_int_equal(loaded.format, c->loaded);
    assert_string_equal(shd_bitmap_get_color_space(bitmap), c->color_space);
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            double largest = 0;
            for (k = 0; k < 3; ++k) largest = fmax(largest, stored_value(&image, x, y, k));
            for (k = 0; k < (c->channels == 4 ? 4 : 3); ++k) {
                shd_assert_close(c->file, (size_t)(4 * (WIDTH * y + x) + k), stored_value(&loaded, x, y, k),
                                 stored_value(&image, x, y, k), c->tolerance * largest, 0);
            }
        }
    }
    shd_bitmap_release(bitmap);
}

/* Refusals. */

static void test_arguments(void **state)
{
    const shd_image image = make_image(SHD_FORMAT_RGBA8);
    shd_image bad = image;
    shd_save_desc desc = shd_save_desc_default();
    (void)state;
    shd_assert_result("image", shd_image_save(NULL, "a.png", NULL), SHD_ERROR_INVALID_ARGUMENT, "image: NULL");
    shd_assert_result("path", shd_image_save(&image, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "path: NULL");
    shd_assert_result("path", shd_image_save(&image, "", NULL), SHD_ERROR_INVALID_ARGUMENT, "path: empty");
    bad.width = 0;
    shd_assert_result("width", shd_image_save(&bad, "a.png", NULL), SHD_ERROR_INVALID_ARGUMENT, "image.width: 0");
    bad = image;
    bad.pixels = NULL;
    shd_assert_result("pixels", shd_image_save(&bad, "a.png", NULL), SHD_ERROR_INVALID_ARGUMENT, "image.pixels: NULL");
    desc.struct_size = 4;
    shd_assert_result("size", shd_image_save(&image, "a.png", &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.struct_size: 4");
    desc.struct_size = sizeof desc - 4;
    shd_assert_result("size", shd_image_save(&image, "a.png", &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.struct_size: 76 is not a multiple of 8, the alignment of the struct");
    desc = shd_save_desc_default();
    desc.bit_depth = 8;
    shd_assert_result("depth", shd_image_save(&image, "a.png", &desc), SHD_ERROR_INVALID_ARGUMENT, "save.bit_depth: 8");
    desc = shd_save_desc_default();
    desc.dither = (shd_dither)3;
    shd_assert_result("dither", shd_image_save(&image, "a.png", &desc), SHD_ERROR_INVALID_ARGUMENT, "save.dither: 3");
    desc = shd_save_desc_default();
    desc.encoding = (shd_color_encoding)77;
    shd_assert_result("encoding", shd_image_save(&image, "a.png", &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "save.encoding: 77");
    shd_assert_result("framebuffer", shd_framebuffer_save(NULL, "a.png", NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "framebuffer: NULL");
}

struct place_case {
    const char *name;
    const char *path; /* without a leading slash: relative to the folder of the test */
    shd_result expected;
    const char *message;
};

static const struct place_case k_places[] = {
    {"place/missing_folder", "no/such/a.png", SHD_ERROR_NOT_FOUND, "cannot create a file beside"},
    {"place/under_a_file", "old.png/a.png", SHD_ERROR_NOT_FOUND, "cannot create a file beside"},
    {"place/folder_named_png", "folder.png", SHD_ERROR_IO, "is not a regular file: not replaced"},
    {"place/fifo", "fifo.png", SHD_ERROR_IO, "is not a regular file: not replaced"},
    {"place/dangling_link", "dangling.png", SHD_ERROR_NOT_FOUND, "cannot follow"},
    {"place/read_only_file_system", "/proc/a.png", SHD_ERROR_NOT_FOUND, "cannot create a file beside"},
    {"place/format_directives", "%s%n.png", SHD_OK, ""},
    {"place/udim", "t.<UDIM>.png", SHD_OK, ""},
    {"place/not_utf8", "\xff\xfe.png", SHD_OK, ""},
};

static void test_place(void **state)
{
    const struct place_case *c = (const struct place_case *)*state;
    const char *path = *c->path == '/' ? c->path : io_path(c->path);
    const shd_image image = make_image(SHD_FORMAT_RGBA8);
    shd_assert_result(c->name, shd_image_save(&image, path, NULL), c->expected, c->message);
    if (c->expected == SHD_OK) assert_int_equal(access(path, R_OK), 0);
    assert_int_equal(io_count_files(".shd-", 0), 0);
}

static void test_link(void **state)
{
    const shd_image image = make_image(SHD_FORMAT_RGBA8);
    struct stat status;
    (void)state;
    io_write(io_path("target.png"), "old", 3);
    assert_int_equal(chmod(io_path("target.png"), 0640), 0);
    assert_int_equal(symlink("target.png", io_path("link.png")), 0);
    shd_assert_ok(shd_image_save(&image, io_path("link.png"), NULL));
    assert_int_equal(lstat(io_path("link.png"), &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    assert_int_equal(stat(io_path("target.png"), &status), 0);
    assert_true(status.st_size > 3);
    assert_int_equal(status.st_mode & 0777, 0640);
}

/* Permissions of the file that a save changes, just before the change; -1 = none was changed. Replaces the function of
 * the C library. */
static int g_mode_before = -1;
__attribute__((visibility("default"))) int fchmod(int fd, mode_t mode)
{
    struct stat status;
    if (fstat(fd, &status) == 0) g_mode_before = (int)(status.st_mode & 0777);
    return (int)syscall(SYS_fchmod, fd, mode);
}

struct mode_case {
    const char *name;
    mode_t old, mask; /* permissions of the file that is replaced (0 = none), and the umask */
    mode_t expected;
};

static const struct mode_case k_modes[] = {
    {"mode/private", 0600, 0022, 0600},  {"mode/group", 0640, 0022, 0640}, {"mode/all", 0666, 0077, 0666},
    {"mode/as_user", 04755, 0022, 0755}, {"mode/new", 0, 0022, 0644},      {"mode/new_private", 0, 0077, 0600},
};

/* A save keeps the permissions of a file, and nobody may open its successor before. A new file has those that the umask
 * leaves. */
static void test_mode(void **state)
{
    const struct mode_case *c = (const struct mode_case *)*state;
    const shd_image image = make_image(SHD_FORMAT_RGBA8);
    struct stat status;
    mode_t mask;
    unlink(io_path("mode.png"));
    if (c->old) {
        io_write(io_path("mode.png"), "old", 3);
        assert_int_equal(chmod(io_path("mode.png"), c->old), 0);
    }
    g_mode_before = -1;
    mask = umask(c->mask);
    shd_assert_ok(shd_image_save(&image, io_path("mode.png"), NULL));
    umask(mask);
    assert_int_equal(stat(io_path("mode.png"), &status), 0);
    assert_int_equal(status.st_mode & 07777, c->expected);
    assert_true(status.st_size > 3);
    assert_int_equal(g_mode_before, c->old ? 0600 : -1);
}

/* Overwriting a file that is open: a reader continues to read the old contents. */
static void test_over_open_input(void **state)
{
    const shd_image image = make_image(SHD_FORMAT_RGBA8);
    char text[8] = "";
    FILE *file;
    (void)state;
    io_write(io_path("open.png"), "the old", 7);
    file = fopen(io_path("open.png"), "rb");
    assert_non_null(file);
    shd_assert_ok(shd_image_save(&image, io_path("open.png"), NULL));
    assert_int_equal(fread(text, 1, 7, file), 7);
    assert_string_equal(text, "the old");
    fclose(file);
}

/* A full disk, simulated by a limit on file sizes: an error, the old file is intact, and no temporary file is left. */
static void test_disk_full(void **state)
{
    static const char *const files[] = {"full.png", "full.exr", "full.tif", "full.hdr"};
    static const shd_format formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F, SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA32F};
    struct rlimit old, small;
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    size_t i;
    (void)state;
    getrlimit(RLIMIT_FSIZE, &old);
    small = old;
    small.rlim_cur = 60;
    for (i = 0; i < 4; ++i) {
        const shd_image image = make_image(formats[i]);
        shd_result result;
        io_bytes bytes;
        io_write(io_path(files[i]), "old", 3);
        setrlimit(RLIMIT_FSIZE, &small);
        result = shd_image_save(&image, io_path(files[i]), NULL);
        setrlimit(RLIMIT_FSIZE, &old);
        shd_assert_result(files[i], result, SHD_ERROR_IO, "cannot write");
        bytes = io_read(io_path(files[i]));
        assert_int_equal(bytes.size, 3);
        assert_memory_equal(bytes.data, "old", 3);
        free(bytes.data);
        assert_int_equal(io_count_files(".shd-", 0), 0);
    }
    signal(SIGXFSZ, handler);
}

/* Framebuffers. */

static shd_framebuffer *make_framebuffer(uint32_t aovs)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.aovs = aovs;
    shd_assert_ok(shd_framebuffer_create(g_context, &desc, &framebuffer));
    return framebuffer;
}

/* Writes known colours to the planes: plane views point to the framebuffer's own memory. */
static const float k_colors[6][4] = {
    {0.5f, 0.25f, 0.125f, 1.0f}, {0.25f, 0.125f, 0.0f, 0.5f},  {4.0f, -1.0f, NAN, 1.0f}, {0, 0, 0, 0},
    {0.002f, 1.0f, 0.18f, 1.0f}, {0.1f, 0.1f, 0.1f, INFINITY},
};

static void paint(shd_framebuffer *framebuffer)
{
    int plane, i;
    for (plane = SHD_PLANE_R; plane <= SHD_PLANE_A; ++plane) {
        shd_plane_view view = shd_plane_view_default();
        shd_assert_ok(shd_framebuffer_view_plane(framebuffer, (shd_plane)plane, &view));
        for (i = 0; i < PIXELS; ++i) {
            float *row = (float *)(uintptr_t)((uintptr_t)view.f32 + (size_t)(i / WIDTH) * view.row_stride);
            row[i % WIDTH] = k_colors[i % 6][plane];
        }
    }
}

/* Rounded sRGB code of a straight linear number (IEC 61966-2-1). */
static double code_of(double linear, double maximum)
{
    linear = linear > 0 ? fmin(linear, 1) : 0;
    return floor((linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055) * maximum + 0.5);
}

struct frame_case {
    const char *file;
    uint32_t bit_depth;
    shd_color_encoding encoding;
    shd_format loaded; /* NONE = refused */
    const char *message;
};

static const struct frame_case k_frames[] = {
    {"f_default.png", 0, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, ""},
    {"f_8.png", 8, SHD_COLOR_ENCODING_SRGB, SHD_FORMAT_RGBA8_SRGB, ""},
    {"f_16.png", 16, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA16, ""},
    {"f_linear.png", 8, SHD_COLOR_ENCODING_LINEAR, SHD_FORMAT_RGBA8, ""},
    {"f_8.tif", 8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB, ""},
    {"f_default.exr", 0, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA16F, ""},
    {"f_32.exr", 32, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA32F, ""},
    {"f_default.tif", 0, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA32F, ""},
    {"f_default.hdr", 0, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA32F, ""},
    {"f_32.png", 32, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "save.bit_depth: 32 is not one that .png has"},
    {"f_8.exr", 8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "save.bit_depth: 8 is not one that .exr has"},
    {"f_8.hdr", 8, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "save.bit_depth: 8"},
    {"f_7.png", 7, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "save.bit_depth: 7"},
    {"f.bmp", 0, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_NONE, "a framebuffer cannot be saved as .bmp"},
};

static double wanted_value(const struct frame_case *c, const shd_image *loaded, int i, int k)
{
    const float *color = k_colors[i % 6];
    const double alpha = (double)color[3];
    const double straight = alpha > 0 ? (double)color[k] / alpha : (double)color[k];
    const double maximum = loaded->format == SHD_FORMAT_RGBA16 ? 65535 : 255;
    if (loaded->format == SHD_FORMAT_RGBA32F) return (double)color[k];
    if (k == 3) return floor((alpha > 0 ? fmin(alpha, 1) : 0) * maximum + 0.5);
    if (c->encoding == SHD_COLOR_ENCODING_LINEAR) return floor((straight > 0 ? fmin(straight, 1) : 0) * maximum + 0.5);
    return code_of(straight, maximum);
}

static void test_frame(void **state)
{
    const struct frame_case *c = (const struct frame_case *)*state;
    shd_framebuffer *framebuffer = make_framebuffer(SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE);
    shd_save_desc desc = shd_save_desc_default();
    shd_bitmap *bitmap = NULL;
    shd_bitmap_info info = shd_bitmap_info_default();
    shd_image loaded = shd_image_default();
    int i, k;
    paint(framebuffer);
    desc.bit_depth = c->bit_depth;
    desc.encoding = c->encoding;
    if (c->loaded == SHD_FORMAT_NONE) {
        const shd_result result = shd_framebuffer_save(framebuffer, io_path(c->file), &desc);
        shd_framebuffer_release(framebuffer);
        assert_true(result == SHD_ERROR_INVALID_ARGUMENT || result == SHD_ERROR_UNSUPPORTED);
        assert_non_null(strstr(shd_last_error(), c->message));
        return;
    }
    shd_assert_ok(shd_framebuffer_save(framebuffer, io_path(c->file), &desc));
    shd_framebuffer_release(framebuffer);
    shd_assert_ok(shd_bitmap_load(g_context, io_path(c->file), NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &loaded));
    shd_assert_ok(shd_bitmap_get_info(bitmap, &info));
    assert_int_equal(loaded.format, c->loaded);
    assert_int_equal((info.flags & SHD_BITMAP_PREMULTIPLIED) != 0,
                     strstr(c->file, ".exr") || strcmp(c->file, "f_default.tif") == 0);
    if (strstr(c->file, ".exr")) assert_int_equal(info.channel_count, 11);
    for (i = 0; i < PIXELS && !strstr(c->file, ".hdr") && loaded.format != SHD_FORMAT_RGBA16F; ++i) {
        for (k = 0; k < 4; ++k) {
            shd_assert_close(c->file, (size_t)(4 * i + k), stored_value(&loaded, i % WIDTH, i / WIDTH, k),
                             wanted_value(c, &loaded, i, k), 0, 0);
        }
    }
    shd_bitmap_release(bitmap);
}

/* Interleaved colour is saved as it is decoded. */
static void test_interleaved(void **state)
{
    static const shd_format k_interleaved[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F};
    static float want[PIXELS * 4];
    size_t f;
    (void)state;
    for (f = 0; f < 3; ++f) {
        shd_framebuffer_desc desc = shd_framebuffer_desc_default();
        shd_save_desc save = shd_save_desc_default();
        shd_framebuffer *framebuffer = NULL;
        shd_bitmap *bitmap = NULL;
        shd_image view = shd_image_default(), read = shd_image_default(), loaded = shd_image_default();
        int i, k;
        desc.width = WIDTH;
        desc.height = HEIGHT;
        desc.color_format = k_interleaved[f];
        shd_assert_ok(shd_framebuffer_create(g_context, &desc, &framebuffer));
        shd_assert_ok(shd_framebuffer_view_color(framebuffer, &view));
        for (i = 0; i < HEIGHT; ++i) {
            unsigned char *row = (unsigned char *)view.pixels + (size_t)i * view.row_stride;
            for (k = 0; k < WIDTH * (int)shd_format_size(view.format); ++k) row[k] = (unsigned char)(k * 5 % 120);
        }
        read.format = SHD_FORMAT_RGBA32F;
        read.width = WIDTH;
        read.height = HEIGHT;
        read.pixels = want;
        shd_assert_ok(shd_framebuffer_read_color(framebuffer, &read));
        save.bit_depth = 32;
        shd_assert_ok(shd_framebuffer_save(framebuffer, io_path("interleaved.exr"), &save));
        shd_framebuffer_release(framebuffer);
        shd_assert_ok(shd_bitmap_load(g_context, io_path("interleaved.exr"), NULL, &bitmap));
        shd_assert_ok(shd_bitmap_get_image(bitmap, &loaded));
        assert_int_equal(loaded.format, SHD_FORMAT_RGBA32F);
        for (i = 0; i < PIXELS; ++i) {
            for (k = 0; k < 4; ++k) {
                assert_true(stored_value(&loaded, i % WIDTH, i / WIDTH, k) == (double)want[4 * i + k]);
            }
        }
        assert_true(want[4] != want[8]);
        shd_bitmap_release(bitmap);
    }
}

/* Every plane becomes a channel of an EXR file. */
static void test_all_planes(void **state)
{
    shd_framebuffer *framebuffer = make_framebuffer(2 * SHD_AOV_TARGET3 - 1);
    shd_bitmap *bitmap = NULL;
    shd_bitmap_info info = shd_bitmap_info_default();
    (void)state;
    shd_assert_ok(shd_framebuffer_save(framebuffer, io_path("all_planes.exr"), NULL));
    shd_framebuffer_release(framebuffer);
    shd_assert_ok(shd_bitmap_load(g_context, io_path("all_planes.exr"), NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_info(bitmap, &info));
    assert_int_equal(info.channel_count, SHD_PLANE_TARGET3_A + 1);
    shd_bitmap_release(bitmap);
}

static void test_half(void **state)
{
    static const struct {
        int k;
        uint16_t bits;
    } want[] = {{0, 0x3800}, {1, 0x3400}, {2, 0x3000},  {3, 0x3c00},
                {8, 0x4400}, {9, 0xbc00}, {16, 0x1819}, {23, 0x7c00}};
    shd_framebuffer *framebuffer = make_framebuffer(0);
    shd_bitmap *bitmap = NULL;
    shd_image loaded = shd_image_default();
    size_t i;
    (void)state;
    paint(framebuffer);
    shd_assert_ok(shd_framebuffer_save(framebuffer, io_path("half.exr"), NULL));
    shd_framebuffer_release(framebuffer);
    shd_assert_ok(shd_bitmap_load(g_context, io_path("half.exr"), NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &loaded));
    for (i = 0; i < sizeof want / sizeof want[0]; ++i) {
        assert_int_equal(((const uint16_t *)loaded.pixels)[want[i].k], want[i].bits);
    }
    shd_bitmap_release(bitmap);
}

/* Textures. */

struct texture_case {
    const char *file;
    shd_format stored;
    shd_color_encoding encoding;
    shd_format texture;
};

static const struct texture_case k_textures[] = {
    {"t_srgb.png", SHD_FORMAT_RGBA8_SRGB, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA8_SRGB},
    {"t_data.png", SHD_FORMAT_RGBA8, SHD_COLOR_ENCODING_DATA, SHD_FORMAT_RGBA8},
    {"t_16.png", SHD_FORMAT_RGBA16, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA32F},
    {"t_16_data.png", SHD_FORMAT_RGBA16, SHD_COLOR_ENCODING_DATA, SHD_FORMAT_RGBA32F},
    {"t_half.exr", SHD_FORMAT_RGBA16F, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA16F},
    {"t_float.exr", SHD_FORMAT_RGBA32F, SHD_COLOR_ENCODING_AUTO, SHD_FORMAT_RGBA32F},
    {"t_float_srgb.exr", SHD_FORMAT_RGBA32F, SHD_COLOR_ENCODING_SRGB, SHD_FORMAT_RGBA32F},
};

static double linear_of(double value) { return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4); }

/* The bytes of the file give the same texture; invalid arguments give no texture. */
static void assert_same_from_memory(const char *file, const shd_load_desc *desc, const shd_image *want)
{
    const io_bytes bytes = io_read(io_path(file));
    static float level[PIXELS * 4];
    shd_image out = *want;
    shd_texture *texture = NULL;
    out.pixels = level;
    shd_assert_ok(shd_texture_load_memory(g_context, bytes.data, bytes.size, desc, &texture));
    shd_assert_ok(shd_texture_read_level(texture, 0, 0, &out));
    assert_memory_equal(out.pixels, want->pixels, PIXELS * shd_format_size(out.format));
    shd_texture_release(texture);
    shd_assert_result("null", shd_texture_load_memory(g_context, NULL, 4, desc, &texture), SHD_ERROR_INVALID_ARGUMENT,
                      "bytes: NULL");
    assert_null(texture);
    shd_assert_result("cut", shd_texture_load_memory(g_context, bytes.data, 20, desc, &texture), SHD_ERROR_CORRUPT, "");
    shd_assert_result("out", shd_texture_load_memory(g_context, bytes.data, bytes.size, desc, NULL),
                      SHD_ERROR_INVALID_ARGUMENT, "out_texture: NULL");
    free(bytes.data);
}

static void test_texture(void **state)
{
    const struct texture_case *c = (const struct texture_case *)*state;
    const shd_image image = make_image(c->stored);
    shd_load_desc desc = shd_load_desc_default();
    shd_texture *texture = NULL;
    shd_texture_info info = shd_texture_info_default();
    static float level[PIXELS * 4];
    shd_image out = shd_image_default();
    int i, k;
    desc.encoding = c->encoding;
    shd_assert_ok(shd_image_save(&image, io_path(c->file), NULL));
    shd_assert_ok(shd_texture_load(g_context, io_path(c->file), &desc, &texture));
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.format, c->texture);
    assert_int_equal(info.width, WIDTH);
    assert_int_equal(info.height, HEIGHT);
    assert_int_equal(info.level_count, 3);
    out.format = c->texture;
    out.width = WIDTH;
    out.height = HEIGHT;
    out.pixels = level;
    shd_assert_ok(shd_texture_read_level(texture, 0, 0, &out));
    shd_texture_release(texture);
    assert_same_from_memory(c->file, &desc, &out);
    out.row_stride = WIDTH * shd_format_size(out.format);
    for (i = 0; i < PIXELS; ++i) {
        for (k = 0; k < 4; ++k) {
            double want = stored_value(&image, i % WIDTH, i / WIDTH, k);
            const int curve = c->encoding != SHD_COLOR_ENCODING_DATA && k < 3;
            if (c->stored == SHD_FORMAT_RGBA16) want = curve ? linear_of(want / 65535) : want / 65535;
            if (c->stored == SHD_FORMAT_RGBA32F && c->encoding == SHD_COLOR_ENCODING_SRGB && k < 3)
                want = linear_of(want);
            shd_assert_close(c->file, (size_t)(4 * i + k), stored_value(&out, i % WIDTH, i / WIDTH, k), want, 1e-9,
                             1e-6);
        }
    }
}

int main(void)
{
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    if (mkfifo(io_path("fifo.png"), 0600) != 0 || mkdir(io_path("folder.png"), 0700) != 0 ||
        symlink("nowhere/at.all", io_path("dangling.png")) != 0) {
        return 1;
    }
    io_write(io_path("old.png"), "old", 3);
    ADD_ROWS(k_images, test_image);
    ADD_ROWS(k_places, test_place);
    ADD_ROWS(k_modes, test_mode);
    ADD_ROWS(k_frames, test_frame);
    ADD_ROWS(k_textures, test_texture);
    add("all_planes", test_all_planes, NULL);
    add("interleaved", test_interleaved, NULL);
    add("half", test_half, NULL);
    add("arguments", test_arguments, NULL);
    add("symbolic_link", test_link, NULL);
    add("over_open_input", test_over_open_input, NULL);
    add("disk_full", test_disk_full, NULL);
    failed = _cmocka_run_group_tests("api.io_save", g_tests, g_count, NULL, NULL);
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
