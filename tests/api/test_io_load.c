/* SPDX-License-Identifier: MIT */
/* Loading: options, paths, budgets, formats, colour spaces, OpenEXR windows, isolation. */
#define _GNU_SOURCE
#include "support/io_corpus.h"
#include "support/rows.h"

#include <fcntl.h>

static shd_context *g_context;

/* Options. */

struct desc_case {
    const char *name;
    void (*edit)(shd_load_desc *desc);
    shd_result expected;
    const char *message;
};

static void edit_size(shd_load_desc *d) { d->struct_size = 7; }
static void edit_formats(shd_load_desc *d) { d->formats = 1u << 20; }
static void edit_flags(shd_load_desc *d) { d->flags = 1u << 9; }
static void edit_encoding(shd_load_desc *d) { d->encoding = (shd_color_encoding)9; }
static void edit_subimage(shd_load_desc *d) { d->subimage = 70000; }
static void edit_subimage_absent(shd_load_desc *d) { d->subimage = 1; }
static void edit_ratio_nan(shd_load_desc *d) { d->max_ratio = (double)NAN; }
static void edit_ratio_negative(shd_load_desc *d) { d->max_ratio = -1; }
static void edit_time_infinite(shd_load_desc *d) { d->time_limit = (double)INFINITY; }
static void edit_time_tiny(shd_load_desc *d) { d->time_limit = 1e-9; }
static void edit_worker_empty(shd_load_desc *d) { d->worker_path = ""; }
static void edit_file_bytes(shd_load_desc *d) { d->max_file_bytes = 100; }
static void edit_pixels_exact(shd_load_desc *d) { d->max_pixels = 20; }
static void edit_pixels(shd_load_desc *d) { d->max_pixels = 19; }
static void edit_bytes_exact(shd_load_desc *d) { d->max_bytes = 80; }
static void edit_bytes(shd_load_desc *d) { d->max_bytes = 79; }
static void edit_png_only(shd_load_desc *d) { d->formats = SHD_FILE_FORMAT_PNG; }
static void edit_exr_only(shd_load_desc *d) { d->formats = SHD_FILE_FORMAT_EXR | SHD_FILE_FORMAT_JPEG; }
static void edit_any(shd_load_desc *d) { d->formats = SHD_FILE_FORMAT_ANY; }
static void edit_in_process(shd_load_desc *d)
{
    d->flags = SHD_LOAD_IN_PROCESS;
    d->worker_path = "/nonexistent/shd-io-worker";
}
static void edit_worker_missing(shd_load_desc *d) { d->worker_path = "/nonexistent/shd-io-worker"; }
static void edit_worker_dies(shd_load_desc *d) { d->worker_path = "/bin/true"; }
static void edit_worker_hangs(shd_load_desc *d)
{
    d->worker_path = "/bin/cat"; /* sends no greeting */
    d->time_limit = 0.2;
}
static void edit_worker_folder(shd_load_desc *d) { d->worker_path = "/tmp"; }

/* Each loads the 5 x 4 RGBA8 PNG of the corpus. */
static const struct desc_case k_desc[] = {
    {"desc/struct_size_small", edit_size, SHD_ERROR_INVALID_ARGUMENT, "load.struct_size: 7"},
    {"desc/formats_unknown", edit_formats, SHD_ERROR_UNSUPPORTED, "load.formats: bits 0x100000"},
    {"desc/flags_unknown", edit_flags, SHD_ERROR_UNSUPPORTED, "load.flags: bits 0x200"},
    {"desc/color_space_9", edit_encoding, SHD_ERROR_INVALID_ARGUMENT, "load.encoding: 9"},
    {"desc/subimage_70000", edit_subimage, SHD_ERROR_INVALID_ARGUMENT, "load.subimage: 70000 is not in 0..65535"},
    {"desc/subimage_absent", edit_subimage_absent, SHD_ERROR_NOT_FOUND, "load.subimage: the file has no part 1"},
    {"desc/max_ratio_nan", edit_ratio_nan, SHD_ERROR_INVALID_ARGUMENT, "load.max_ratio"},
    {"desc/max_ratio_negative", edit_ratio_negative, SHD_ERROR_INVALID_ARGUMENT, "load.max_ratio: -1"},
    {"desc/time_limit_infinite", edit_time_infinite, SHD_ERROR_INVALID_ARGUMENT, "load.time_limit"},
    {"desc/time_limit_passed", edit_time_tiny, SHD_OK, ""},
    {"desc/worker_path_empty", edit_worker_empty, SHD_ERROR_INVALID_ARGUMENT, "load.worker_path: empty"},
    {"desc/max_file_bytes", edit_file_bytes, SHD_ERROR_LIMIT, "load.max_file_bytes 100"},
    {"desc/max_pixels_exact", edit_pixels_exact, SHD_OK, ""},
    {"desc/max_pixels", edit_pixels, SHD_ERROR_LIMIT, "5 x 4 pixels is above load.max_pixels 19"},
    {"desc/max_bytes_exact", edit_bytes_exact, SHD_OK, ""},
    {"desc/max_bytes", edit_bytes, SHD_ERROR_LIMIT, "80 decoded bytes are above load.max_bytes 79"},
    {"desc/formats_png", edit_png_only, SHD_OK, ""},
    {"desc/formats_exr_and_jpeg", edit_exr_only, SHD_ERROR_UNSUPPORTED, "PNG, which load.formats does not allow"},
    {"desc/formats_any", edit_any, SHD_OK, ""},
    {"desc/in_process", edit_in_process, SHD_OK, ""},
    {"desc/worker_missing", edit_worker_missing, SHD_ERROR_NOT_FOUND,
     "cannot run \"/nonexistent/shd-io-worker\": No such file or directory; a load with SHD_LOAD_IN_PROCESS needs no "
     "worker"},
    {"desc/worker_dies", edit_worker_dies, SHD_ERROR_INTERNAL,
     "the worker \"/bin/true\" did not start (exit status 0)"},
    {"desc/worker_hangs", edit_worker_hangs, SHD_ERROR_LIMIT, "load.time_limit 0.2 s"},
    {"desc/worker_is_a_folder", edit_worker_folder, SHD_ERROR_IO, "cannot run"},
};

static void test_desc(void **state)
{
    const struct desc_case *c = (const struct desc_case *)*state;
    const io_bytes *png = &g_corpus[0].bytes;
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = (shd_bitmap *)&desc;
    shd_result result;
    c->edit(&desc);
    result = shd_bitmap_load_memory(g_context, png->data, png->size, &desc, &bitmap);
    if (c->edit == edit_time_tiny && result == SHD_ERROR_LIMIT) result = SHD_OK; /* 1 ms is the shortest limit */
    shd_assert_result(c->name, result, c->expected, c->message);
    if (c->expected != SHD_OK) assert_null(bitmap);
    shd_bitmap_release(bitmap);
}

/* Paths. */

struct path_case {
    const char *name;
    const char *path; /* without a leading slash: relative to the folder of the test */
    shd_result expected;
    const char *message;
};

static const struct path_case k_paths[] = {
    {"path/missing", "missing.png", SHD_ERROR_NOT_FOUND, "missing.png\": No such file"},
    {"path/missing_folder", "no/such/folder.png", SHD_ERROR_NOT_FOUND, "cannot open"},
    {"path/folder", "/tmp", SHD_ERROR_IO, "\"/tmp\" is not a regular file"},
    {"path/dev_zero", "/dev/zero", SHD_ERROR_IO, "is not a regular file"},
    {"path/fifo", "fifo.png", SHD_ERROR_IO, "is not a regular file"},
    {"path/empty_file", "empty.png", SHD_ERROR_CORRUPT, "is empty"},
    {"path/sparse_5_gib", "sparse.png", SHD_ERROR_LIMIT, "has 5368709120 bytes, above load.max_file_bytes 1073741824"},
    {"path/text_file", "text.png", SHD_ERROR_UNSUPPORTED, "no known image format"},
    {"path/one_byte", "one.png", SHD_ERROR_UNSUPPORTED, "no known image format"},
    {"path/png_named_jpg", "really_png.jpg", SHD_OK, ""},
    {"path/png_without_extension", "really_png", SHD_OK, ""},
    {"path/format_directives", "%s%n%d.png", SHD_ERROR_NOT_FOUND, "%s%n%d.png"},
    {"path/udim", "tile.<UDIM>.png", SHD_ERROR_NOT_FOUND, "<UDIM>"},
    {"path/udim_literal", "tile.<UDIM>.exists.png", SHD_OK, ""},
    {"path/invalid_utf8", "\xff\xfe\x80.png", SHD_ERROR_NOT_FOUND, "???.png"},
    {"path/newline", "a\nb.png", SHD_ERROR_NOT_FOUND, "a b.png"},
    {"path/empty", "", SHD_ERROR_INVALID_ARGUMENT, "path: empty"},
};

static void test_path(void **state)
{
    const struct path_case *c = (const struct path_case *)*state;
    const char *path = *c->path == '/' || !*c->path ? c->path : io_path(c->path);
    shd_bitmap *bitmap = (shd_bitmap *)&bitmap;
    shd_assert_result(c->name, shd_bitmap_load(g_context, path, NULL, &bitmap), c->expected, c->message);
    if (c->expected != SHD_OK) assert_null(bitmap);
    shd_bitmap_release(bitmap);
}

static void test_long_path(void **state)
{
    const size_t size = 1 << 20;
    char *path = (char *)malloc(size + 1);
    shd_bitmap *bitmap = NULL;
    shd_result result;
    (void)state;
    memset(path, 'x', size);
    path[size] = 0;
    result = shd_bitmap_load(g_context, path, NULL, &bitmap);
    free(path);
    shd_assert_result("1 MiB", result, SHD_ERROR_INVALID_ARGUMENT, "xxx...xxx");
    assert_null(bitmap);
}

static void make_path_files(void)
{
    const io_bytes *png = &g_corpus[0].bytes;
    int fd;
    assert_int_equal(mkfifo(io_path("fifo.png"), 0600), 0);
    io_write(io_path("empty.png"), "", 0);
    io_write(io_path("text.png"), "hello, world\n", 13);
    io_write(io_path("one.png"), "\x89", 1);
    io_write(io_path("really_png.jpg"), png->data, png->size);
    io_write(io_path("really_png"), png->data, png->size);
    io_write(io_path("tile.<UDIM>.exists.png"), png->data, png->size);
    fd = open(io_path("sparse.png"), O_CREAT | O_WRONLY, 0600);
    assert_true(fd >= 0);
    assert_int_equal(ftruncate(fd, (off_t)5 << 30), 0);
    close(fd);
}

static void test_null_arguments(void **state)
{
    shd_bitmap *bitmap = NULL;
    shd_texture *texture = NULL;
    shd_image image = shd_image_default();
    shd_bitmap_info info = shd_bitmap_info_default();
    (void)state;
    shd_assert_result("out", shd_bitmap_load(g_context, "x", NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_bitmap: NULL");
    shd_assert_result("context", shd_bitmap_load(NULL, "x", NULL, &bitmap), SHD_ERROR_INVALID_ARGUMENT,
                      "context: NULL");
    shd_assert_result("path", shd_bitmap_load(g_context, NULL, NULL, &bitmap), SHD_ERROR_INVALID_ARGUMENT,
                      "path: NULL");
    shd_assert_result("bytes", shd_bitmap_load_memory(g_context, NULL, 4, NULL, &bitmap), SHD_ERROR_INVALID_ARGUMENT,
                      "bytes: NULL");
    shd_assert_result("size", shd_bitmap_load_memory(g_context, "x", 0, NULL, &bitmap), SHD_ERROR_CORRUPT, "empty");
    shd_assert_result("texture out", shd_texture_load(g_context, "x", NULL, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_texture: NULL");
    shd_assert_result("texture path", shd_texture_load(g_context, NULL, NULL, &texture), SHD_ERROR_INVALID_ARGUMENT,
                      "path: NULL");
    shd_assert_result("image", shd_bitmap_get_image(NULL, &image), SHD_ERROR_INVALID_ARGUMENT, "NULL");
    assert_null(image.pixels);
    shd_assert_result("image out", shd_bitmap_get_image(NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_image: NULL");
    shd_assert_result("info", shd_bitmap_get_info(NULL, &info), SHD_ERROR_INVALID_ARGUMENT, "NULL");
    shd_assert_result("info out", shd_bitmap_get_info(NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_info: NULL");
    assert_string_equal(shd_bitmap_get_color_space(NULL), "");
    shd_bitmap_retain(NULL);
    shd_bitmap_release(NULL);
}

/* A decoder that needs a path gets the one of an anonymous file. It is in no message, because it differs from load to
 * load. */
static void test_anonymous_path(void **state)
{
    static const shd_load_flags flags[] = {SHD_LOAD_NONE, SHD_LOAD_IN_PROCESS};
    char text[2][1024];
    int used[4], i;
    (void)state;
    for (i = 0; i < 4; ++i) {
        shd_load_desc desc = shd_load_desc_default();
        shd_bitmap *bitmap = NULL;
        used[i] = dup(1); /* so that the next load gets other numbers */
        desc.formats = SHD_FILE_FORMAT_ANY;
        desc.flags = flags[i / 2];
        shd_assert_result("any", shd_bitmap_load(g_context, io_path("text.png"), &desc, &bitmap), SHD_ERROR_UNSUPPORTED,
                          "has no reader for the file");
        snprintf(text[i % 2], sizeof text[0], "%s", shd_last_error());
        assert_null(strstr(text[i % 2], "/proc/"));
        if (i % 2) assert_string_equal(text[0], text[1]);
    }
    for (i = 0; i < 4; ++i) close(used[i]);
}

static void test_lifecycle(void **state)
{
    const io_bytes *png = &g_corpus[0].bytes;
    shd_context *context = NULL;
    shd_bitmap *bitmap = NULL;
    shd_image image = shd_image_default();
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_bitmap_load_memory(context, png->data, png->size, NULL, &bitmap));
    shd_bitmap_retain(bitmap);
    shd_bitmap_release(bitmap);
    shd_context_release(context); /* the bitmap keeps it */
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(((unsigned char *)image.pixels)[79], 7 + 3 * 79);
    shd_context_retain(context);
    shd_bitmap_release(bitmap);
    assert_string_equal(shd_bitmap_get_color_space(bitmap), "");
    shd_assert_result("released", shd_bitmap_get_image(bitmap, &image), SHD_ERROR_INVALID_ARGUMENT,
                      "not a live handle");
    shd_context_release(context);
}

/* Decompression bombs: headers that claim more than the file contains. */

struct bomb_case {
    const char *name;
    const char *header;
    size_t size;
    shd_result expected;
    const char *message;
};

#define BOMB(text) text, sizeof(text) - 1
static const struct bomb_case k_bombs[] = {
    {"bomb/png_65535", BOMB("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xff\xff\0\0\xff\xff\x08\x06\0\0\0....."),
     SHD_ERROR_LIMIT, "65535 x 65535 pixels is above load.max_pixels"},
    {"bomb/png_2_31", BOMB("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\x7f\xff\xff\xff\x7f\xff\xff\xff\x08\x06\0\0\0....."),
     SHD_ERROR_LIMIT, "a side is above 65536"},
    {"bomb/png_negative", BOMB("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\xff\xff\xff\xff\0\0\0\1\x08\x06\0\0\0....."),
     SHD_ERROR_CORRUPT, "4294967295 x 1 pixels"},
    {"bomb/png_zero", BOMB("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\0\0\0\0\0\x08\x06\0\0\0....."), SHD_ERROR_CORRUPT,
     "0 x 0 pixels"},
    {"bomb/png_ratio", BOMB("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x40\0\0\0\x40\0\x08\x06\0\0\0....."), SHD_ERROR_LIMIT,
     "are above load.max_ratio"},
    {"bomb/tga_65535", BOMB("\0\0\2\0\0\0\0\0\0\0\0\0\xff\xff\xff\xff\x20\x08"), SHD_ERROR_LIMIT, "load.max_pixels"},
    {"bomb/bmp_2_31", BOMB("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\xff\xff\xff\x7f\xff\xff\xff\x7f\1\0\x20\0"),
     SHD_ERROR_LIMIT, "a side is above 65536"},
    {"bomb/bmp_min_height", BOMB("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\1\0\0\0\0\0\0\x80\1\0\x20\0"),
     SHD_ERROR_CORRUPT, "1 x 2147483648 pixels"},
    {"bomb/webp", BOMB("RIFF\x40\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\xff\0\xff\xff\0"), SHD_ERROR_LIMIT,
     "65536 x 65536 pixels is above"},
    {"bomb/webp_first_chunk", BOMB("RIFF\x40\0\0\0WEBPALPH\x0a\0\0\0\0\0\0\0\1\0\1\0\1\0\1\0\1\0"), SHD_ERROR_CORRUPT,
     "WebP: unknown first chunk"},
    {"bomb/exr",
     BOMB("\x76\x2f\x31\1\2\0\0\0dataWindow\0box2i\0\x10\0\0\0\0\0\0\x80\0\0\0\x80\xff\xff\xff\x7f\xff\xff\xff\x7f\0"),
     SHD_ERROR_CORRUPT, "data window of 4294967296 x 4294967296"},
    {"bomb/exr_display",
     BOMB("\x76\x2f\x31\1\2\0\0\0displayWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0\xff\xff\0\0\xff\xff\0\0\0"),
     SHD_ERROR_LIMIT, "display window of 65536 x 65536"},
    {"bomb/exr_attribute_size", BOMB("\x76\x2f\x31\1\2\0\0\0comment\0string\0\xff\xff\xff\xff...."), SHD_ERROR_CORRUPT,
     "cut off"},
    {"bomb/ppm", BOMB("P6\n65535 65535\n255\n...."), SHD_ERROR_LIMIT, "load.max_pixels"},
    {"bomb/hdr", BOMB("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 65535 +X 65535\n....."), SHD_ERROR_LIMIT,
     "load.max_pixels"},
};

static void test_bomb(void **state)
{
    const struct bomb_case *c = (const struct bomb_case *)*state;
    shd_bitmap *bitmap = NULL;
    shd_assert_result(c->name, shd_bitmap_load_memory(g_context, c->header, c->size, NULL, &bitmap), c->expected,
                      c->message);
    assert_null(bitmap);
}

/* The pixel format, size, channels and colour space of a file of each format. */

struct format_case {
    const char *sample;
    shd_format format;
    uint32_t width, height, channels;
    const char *color_space;
};

static const struct format_case k_formats[] = {
    {"png8", SHD_FORMAT_RGBA8_SRGB, 5, 4, 4, "sRGB"},
    {"png16", SHD_FORMAT_RGBA16, 5, 4, 4, "sRGB"},
    {"png_grey", SHD_FORMAT_RGBA8_SRGB, 5, 4, 1, "sRGB"},
    {"jpeg", SHD_FORMAT_RGBA8_SRGB, 9, 7, 3, "sRGB"},
    {"exr_half", SHD_FORMAT_RGBA16F, 5, 4, 4, "Linear Rec.709"},
    {"exr_float", SHD_FORMAT_RGBA32F, 5, 4, 4, "Linear Rec.709"},
    {"tiff8", SHD_FORMAT_RGBA8_SRGB, 5, 4, 4, "sRGB"},
    {"tiff_float", SHD_FORMAT_RGBA32F, 5, 4, 4, "Linear Rec.709"},
    {"hdr", SHD_FORMAT_RGBA32F, 5, 4, 3, "Linear Rec.709"},
    {"tga", SHD_FORMAT_RGBA8_SRGB, 5, 4, 4, "sRGB"},
    {"bmp", SHD_FORMAT_RGBA8_SRGB, 5, 4, 4, "sRGB"},
    {"dds", SHD_FORMAT_RGBA8_SRGB, 4, 4, 4, "sRGB"},
    {"webp", SHD_FORMAT_RGBA8_SRGB, 9, 7, 3, "sRGB"},
    {"pgm_text", SHD_FORMAT_RGBA8, 3, 2, 1, "Rec709"},
    {"ppm", SHD_FORMAT_RGBA8, 2, 2, 3, "Rec709"},
};

static const io_sample *find_sample(const char *name)
{
    int i;
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) {
        if (strcmp(g_corpus[i].name, name) == 0) return &g_corpus[i];
    }
    fail_msg("no sample %s", name);
    return NULL;
}

static void test_format(void **state)
{
    const struct format_case *c = (const struct format_case *)*state;
    const io_sample *sample = find_sample(c->sample);
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL, *in_process = NULL;
    shd_image image = shd_image_default();
    shd_bitmap_info info = shd_bitmap_info_default();
    shd_assert_ok(shd_bitmap_load_memory(g_context, sample->bytes.data, sample->bytes.size, NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    shd_assert_ok(shd_bitmap_get_info(bitmap, &info));
    assert_string_equal(shd_bitmap_get_color_space(bitmap), c->color_space);
    assert_int_equal(image.format, c->format);
    assert_int_equal(image.width, c->width);
    assert_int_equal(image.height, c->height);
    assert_int_equal(info.channel_count, c->channels);
    assert_int_equal(info.file_format, sample->format);
    assert_int_equal(info.flags, sample->format == SHD_FILE_FORMAT_EXR ? SHD_BITMAP_PREMULTIPLIED : SHD_BITMAP_NONE);
    desc.flags = SHD_LOAD_IN_PROCESS;
    shd_assert_ok(shd_bitmap_load_memory(g_context, sample->bytes.data, sample->bytes.size, &desc, &in_process));
    assert_true(io_hash_bitmap(bitmap) == io_hash_bitmap(in_process));
    shd_bitmap_release(in_process);
    shd_bitmap_release(bitmap);
}

/* Colour spaces. */

struct color_case {
    const char *name;
    const char *sample;
    shd_color_encoding encoding;
    shd_format format;
    const char *color_space;
};

static const struct color_case k_colors[] = {
    {"color/png_as_data", "png8", SHD_COLOR_ENCODING_DATA, SHD_FORMAT_RGBA8, "data"},
    {"color/png_as_linear", "png8", SHD_COLOR_ENCODING_LINEAR, SHD_FORMAT_RGBA8, "Linear Rec.709"},
    {"color/png_as_srgb", "png8", SHD_COLOR_ENCODING_SRGB, SHD_FORMAT_RGBA8_SRGB, "sRGB"},
    {"color/exr_as_srgb", "exr_half", SHD_COLOR_ENCODING_SRGB, SHD_FORMAT_RGBA16F, "sRGB"},
    {"color/png16_as_data", "png16", SHD_COLOR_ENCODING_DATA, SHD_FORMAT_RGBA16, "data"},
};

static void test_color(void **state)
{
    const struct color_case *c = (const struct color_case *)*state;
    const io_sample *sample = find_sample(c->sample);
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    shd_image image = shd_image_default();
    desc.encoding = c->encoding;
    shd_assert_ok(shd_bitmap_load_memory(g_context, sample->bytes.data, sample->bytes.size, &desc, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(image.format, c->format);
    assert_string_equal(shd_bitmap_get_color_space(bitmap), c->color_space);
    shd_bitmap_release(bitmap);
}

static void test_flip(void **state)
{
    const io_sample *sample = find_sample("png8");
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    shd_image image = shd_image_default();
    uint32_t y;
    (void)state;
    desc.flags = SHD_LOAD_FLIP_V;
    shd_assert_ok(shd_bitmap_load_memory(g_context, sample->bytes.data, sample->bytes.size, &desc, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    for (y = 0; y < 4; ++y) {
        assert_int_equal(((unsigned char *)image.pixels)[y * image.row_stride], 7 + 3 * 20 * (3 - y));
    }
    shd_bitmap_release(bitmap);
}

/* A grey pixel has r = g = b and an opaque alpha; metadata is ignored; a partial load returns the rows that exist. */
static void test_grey(void **state)
{
    const io_sample *sample = find_sample("pgm_text");
    static const unsigned char want[] = {0, 64, 128, 192, 255, 7};
    shd_bitmap *bitmap = NULL;
    shd_image image = shd_image_default();
    size_t i;
    (void)state;
    shd_assert_ok(shd_bitmap_load_memory(g_context, sample->bytes.data, sample->bytes.size, NULL, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    for (i = 0; i < 24; ++i) {
        assert_int_equal(((unsigned char *)image.pixels)[i], i % 4 == 3 ? 255 : want[i / 4]);
    }
    shd_bitmap_release(bitmap);
}

/* An APP1 segment with XMP nested 20,000 deep, which overruns the stack of a recursive parser. */
static void test_nested_metadata(void **state)
{
    enum { SEGMENT = 60000 };
    static const char head[] = "http://ns.adobe.com/xap/1.0/";
    const size_t size = sizeof k_sample_jpeg + 2 + SEGMENT;
    unsigned char *bytes = (unsigned char *)malloc(size);
    shd_bitmap *plain = NULL, *bitmap = NULL;
    size_t i;
    (void)state;
    memcpy(bytes, k_sample_jpeg, 2);
    bytes[2] = 0xff;
    bytes[3] = 0xe1;
    bytes[4] = SEGMENT >> 8;
    bytes[5] = SEGMENT & 255;
    for (i = 6; i < SEGMENT + 4; ++i) bytes[i] = (unsigned char)("<a>"[i % 3]);
    memcpy(bytes + 6, head, sizeof head);
    memcpy(bytes + 4 + SEGMENT, k_sample_jpeg + 2, sizeof k_sample_jpeg - 2);
    shd_assert_ok(shd_bitmap_load_memory(g_context, k_sample_jpeg, sizeof k_sample_jpeg, NULL, &plain));
    shd_assert_ok(shd_bitmap_load_memory(g_context, bytes, size, NULL, &bitmap));
    assert_true(io_hash_bitmap(plain) == io_hash_bitmap(bitmap));
    free(bytes);
    shd_bitmap_release(plain);
    shd_bitmap_release(bitmap);
}

static void test_partial(void **state)
{
    const io_sample *jpeg = find_sample("jpeg");
    const io_sample *hdr = find_sample("exr_float");
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    shd_bitmap_info info = shd_bitmap_info_default();
    (void)state;
    shd_assert_result("jpeg", shd_bitmap_load_memory(g_context, jpeg->bytes.data, jpeg->bytes.size - 2, NULL, &bitmap),
                      SHD_ERROR_CORRUPT, "JPEG: the end is missing");
    shd_assert_result("exr", shd_bitmap_load_memory(g_context, hdr->bytes.data, hdr->bytes.size - 9, NULL, &bitmap),
                      SHD_ERROR_CORRUPT, "OpenEXR");
    desc.flags = SHD_LOAD_PARTIAL;
    shd_assert_ok(shd_bitmap_load_memory(g_context, jpeg->bytes.data, jpeg->bytes.size - 2, &desc, &bitmap));
    shd_assert_ok(shd_bitmap_get_info(bitmap, &info));
    assert_true(info.flags & SHD_BITMAP_PARTIAL);
    shd_bitmap_release(bitmap);
    bitmap = NULL;
    shd_assert_ok(shd_bitmap_load_memory(g_context, hdr->bytes.data, hdr->bytes.size - 9, &desc, &bitmap));
    shd_assert_ok(shd_bitmap_get_info(bitmap, &info));
    assert_true(info.flags & SHD_BITMAP_PARTIAL);
    shd_bitmap_release(bitmap);
}

/* OpenEXR windows, written byte by byte ("OpenEXR File Layout"): one float channel Y, uncompressed. */

struct exr_case {
    const char *name;
    int data[4];    /* x min, y min, x max, y max */
    int display[4]; /* display window: x min, y min, x max, y max */
    int sampling;
    uint32_t version;
    shd_result expected;
    const char *message;
};

static const struct exr_case k_exr[] = {
    {"exr/plain", {0, 0, 3, 2}, {0, 0, 3, 2}, 1, 2, SHD_OK, ""},
    {"exr/offset", {1, 1, 2, 2}, {0, 0, 3, 2}, 1, 2, SHD_OK, ""},
    {"exr/negative_origin", {-5, -4, -2, -2}, {-5, -4, -2, -2}, 1, 2, SHD_OK, ""},
    {"exr/overscan", {-1, -2, 5, 4}, {0, 0, 3, 2}, 1, 2, SHD_OK, ""},
    {"exr/apart", {10, 10, 12, 12}, {0, 0, 3, 2}, 1, 2, SHD_OK, ""},
    {"exr/subsampled", {0, 0, 3, 3}, {0, 0, 3, 3}, 2, 2, SHD_ERROR_UNSUPPORTED, "channel \"Y\" is subsampled"},
    {"exr/deep", {0, 0, 3, 2}, {0, 0, 3, 2}, 1, 2 | 0x800, SHD_ERROR_UNSUPPORTED, "deep OpenEXR"},
    {"exr/inverted_window", {3, 2, 0, 0}, {0, 0, 3, 2}, 1, 2, SHD_ERROR_CORRUPT, "data window"},
};

static size_t put_attribute(unsigned char *to, const char *name, const char *type, const void *value, uint32_t size)
{
    const size_t name_size = strlen(name) + 1, type_size = strlen(type) + 1;
    memcpy(to, name, name_size);
    memcpy(to + name_size, type, type_size);
    io_put32(to + name_size + type_size, size);
    memcpy(to + name_size + type_size + 4, value, size);
    return name_size + type_size + 4 + size;
}

static float exr_value(int x, int y) { return (float)(100 + x + 10 * y); }

static size_t make_exr(const struct exr_case *c, unsigned char *to)
{
    unsigned char channels[2 + 16 + 1] = "Y", window[16];
    const float one = 1, center[2] = {0, 0};
    const int width = c->data[2] - c->data[0] + 1;
    size_t n = 8, offsets;
    int i, x, y;
    io_put32(to, 20000630);
    io_put32(to + 4, c->version);
    channels[2] = 2; /* float */
    io_put32(channels + 10, (uint32_t)c->sampling);
    io_put32(channels + 14, (uint32_t)c->sampling);
    n += put_attribute(to + n, "channels", "chlist", channels, sizeof channels);
    n += put_attribute(to + n, "compression", "compression", "\0", 1);
    for (i = 0; i < 4; ++i) io_put32(window + 4 * i, (uint32_t)c->data[i]);
    n += put_attribute(to + n, "dataWindow", "box2i", window, 16);
    for (i = 0; i < 4; ++i) io_put32(window + 4 * i, (uint32_t)c->display[i]);
    n += put_attribute(to + n, "displayWindow", "box2i", window, 16);
    n += put_attribute(to + n, "lineOrder", "lineOrder", "\0", 1);
    n += put_attribute(to + n, "pixelAspectRatio", "float", &one, 4);
    n += put_attribute(to + n, "screenWindowCenter", "v2f", center, 8);
    n += put_attribute(to + n, "screenWindowWidth", "float", &one, 4);
    to[n++] = 0;
    offsets = n;
    n += 8 * (size_t)(c->data[3] >= c->data[1] ? c->data[3] - c->data[1] + 1 : 0);
    for (y = c->data[1]; y <= c->data[3]; ++y) {
        io_put32(to + offsets, (uint32_t)n);
        io_put32(to + offsets + 4, 0);
        offsets += 8;
        io_put32(to + n, (uint32_t)y);
        io_put32(to + n + 4, (uint32_t)(4 * width));
        n += 8;
        for (x = c->data[0]; x <= c->data[2]; ++x, n += 4) {
            const float value = exr_value(x, y);
            memcpy(to + n, &value, 4);
        }
    }
    return n;
}

static void test_exr(void **state)
{
    const struct exr_case *c = (const struct exr_case *)*state;
    static unsigned char bytes[4096];
    const size_t size = make_exr(c, bytes);
    const int *d = c->data, *w = c->display;
    shd_bitmap *bitmap = NULL;
    shd_image image = shd_image_default();
    int x, y;
    shd_assert_result(c->name, shd_bitmap_load_memory(g_context, bytes, size, NULL, &bitmap), c->expected, c->message);
    if (c->expected != SHD_OK) return;
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(image.width, w[2] - w[0] + 1);
    assert_int_equal(image.height, w[3] - w[1] + 1);
    for (y = w[1]; y <= w[3]; ++y) {
        for (x = w[0]; x <= w[2]; ++x) {
            const float *pixel = (const float *)image.pixels + 4 * ((y - w[1]) * (int)image.width + x - w[0]);
            const int inside = x >= d[0] && x <= d[2] && y >= d[1] && y <= d[3];
            shd_assert_close("grey", (size_t)(x - w[0]), (double)pixel[1], inside ? (double)exr_value(x, y) : 0, 0, 0);
            shd_assert_close("alpha", (size_t)(x - w[0]), (double)pixel[3], inside ? 1 : 0, 0, 0);
        }
    }
    shd_bitmap_release(bitmap);
}

int main(void)
{
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    io_make_corpus();
    make_path_files();
    ADD_ROWS(k_desc, test_desc);
    ADD_ROWS(k_paths, test_path);
    ADD_ROWS(k_bombs, test_bomb);
    ADD_ROWS(k_formats, test_format);
    ADD_ROWS(k_colors, test_color);
    ADD_ROWS(k_exr, test_exr);
    add("path/1_mib_long", test_long_path, NULL);
    add("path/anonymous", test_anonymous_path, NULL);
    add("null_arguments", test_null_arguments, NULL);
    add("lifecycle", test_lifecycle, NULL);
    add("flip", test_flip, NULL);
    add("grey", test_grey, NULL);
    add("nested_metadata", test_nested_metadata, NULL);
    add("partial", test_partial, NULL);
    failed = _cmocka_run_group_tests("api.io_load", g_tests, g_count, NULL, NULL);
    io_free_corpus();
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
