/* SPDX-License-Identifier: MIT */
/* One small valid file of each default format, made with shd_image_save or by hand. */
#ifndef SHD_TESTS_SUPPORT_IO_CORPUS_H
#define SHD_TESTS_SUPPORT_IO_CORPUS_H

#include "support/io_files.h"
#include "support/io_samples.h"

/** A file of the corpus. */
typedef struct io_sample {
    const char *name;
    shd_file_format format;
    io_bytes bytes;
} io_sample;

#if defined(SHD_WITHOUT_OIIO)
enum { IO_SAMPLE_COUNT = 6 };
#else
enum { IO_SAMPLE_COUNT = 15 };
#endif

static io_sample g_corpus[IO_SAMPLE_COUNT];

/** Writes little-endian 32-bit words. */
static inline void io_put32(unsigned char *to, uint32_t value)
{
    int i;
    for (i = 0; i < 4; ++i) to[i] = (unsigned char)(value >> (8 * i));
}

/** Direct3D 9 DDS header (Microsoft, "Programming Guide for DDS") of 4 x 4 texels as one DXT1 block. */
static inline io_bytes io_make_dds(void)
{
    io_bytes bytes = {(unsigned char *)calloc(1, 136), 136};
    static const unsigned char block[8] = {0x00, 0xf8, 0x1f, 0x00, 0xe4, 0xe4, 0xe4, 0xe4};
    memcpy(bytes.data, "DDS ", 4);
    io_put32(bytes.data + 4, 124);
    io_put32(bytes.data + 8, 0x81007);
    io_put32(bytes.data + 12, 4);
    io_put32(bytes.data + 16, 4);
    io_put32(bytes.data + 20, 8);
    io_put32(bytes.data + 76, 32);
    io_put32(bytes.data + 80, 4);
    memcpy(bytes.data + 84, "DXT1", 4);
    io_put32(bytes.data + 108, 0x1000);
    memcpy(bytes.data + 128, block, sizeof block);
    return bytes;
}

static inline io_bytes io_copy(const void *data, size_t size)
{
    io_bytes bytes = {(unsigned char *)malloc(size), size};
    memcpy(bytes.data, data, size);
    return bytes;
}

/** The file that shd_image_save writes for a 5 x 4 pattern, unless it exists already; empty if saving fails. */
static inline io_bytes io_make_saved(shd_format format, const char *name)
{
    static unsigned char pixels[5 * 4 * 16];
    shd_image image = shd_image_default();
    float *floats = (float *)(void *)pixels;
    uint16_t *words = (uint16_t *)(void *)pixels;
    io_bytes none = {NULL, 0};
    size_t i;
    if (access(io_path(name), R_OK) == 0) return io_read(io_path(name));
    image.format = format;
    image.width = 5;
    image.height = 4;
    image.pixels = pixels;
    for (i = 0; i < 5 * 4 * 4; ++i) {
        if (format == SHD_FORMAT_RGBA32F) floats[i] = (float)(i % 13) / 12.0f;
        if (format == SHD_FORMAT_RGBA16F) words[i] = (uint16_t)(0x3800 + 37 * i);
        if (format == SHD_FORMAT_RGBA16) words[i] = (uint16_t)(803 * i);
        if (format == SHD_FORMAT_RGBA8 || format == SHD_FORMAT_RGBA8_SRGB || format == SHD_FORMAT_R8) {
            pixels[i] = (unsigned char)(7 + 3 * i);
        }
    }
    if (shd_image_save(&image, io_path(name), NULL) != SHD_OK) return none;
    return io_read(io_path(name));
}

static inline void io_add_sample(int *count, const char *name, shd_file_format format, io_bytes bytes)
{
    if (!bytes.data) fail_msg("no sample %s: %s", name, shd_last_error());
    g_corpus[*count].name = name;
    g_corpus[*count].format = format;
    g_corpus[*count].bytes = bytes;
    ++*count;
}

static inline void io_make_corpus(void)
{
#if !defined(SHD_WITHOUT_OIIO)
    static const char pgm[] = "P2\n# comment\n3 2\n255\n0 64 128\n192 255 7\n";
    static const char ppm[] = "P6\n2 2\n255\nabcdefghijkl";
#endif
    int n = 0;
    io_add_sample(&n, "png8", SHD_FILE_FORMAT_PNG, io_make_saved(SHD_FORMAT_RGBA8_SRGB, "c8.png"));
    io_add_sample(&n, "png16", SHD_FILE_FORMAT_PNG, io_make_saved(SHD_FORMAT_RGBA16, "c16.png"));
    io_add_sample(&n, "png_grey", SHD_FILE_FORMAT_PNG, io_make_saved(SHD_FORMAT_R8, "c1.png"));
    io_add_sample(&n, "jpeg", SHD_FILE_FORMAT_JPEG, io_copy(k_sample_jpeg, sizeof k_sample_jpeg));
    io_add_sample(&n, "hdr", SHD_FILE_FORMAT_HDR, io_make_saved(SHD_FORMAT_RGBA32F, "c.hdr"));
    io_add_sample(&n, "dds", SHD_FILE_FORMAT_DDS, io_make_dds());
#if !defined(SHD_WITHOUT_OIIO)
    io_add_sample(&n, "exr_half", SHD_FILE_FORMAT_EXR, io_make_saved(SHD_FORMAT_RGBA16F, "c16.exr"));
    io_add_sample(&n, "exr_float", SHD_FILE_FORMAT_EXR, io_make_saved(SHD_FORMAT_RGBA32F, "c32.exr"));
    io_add_sample(&n, "tiff8", SHD_FILE_FORMAT_TIFF, io_make_saved(SHD_FORMAT_RGBA8, "c8.tif"));
    io_add_sample(&n, "tiff_float", SHD_FILE_FORMAT_TIFF, io_make_saved(SHD_FORMAT_RGBA32F, "c32.tif"));
    io_add_sample(&n, "tga", SHD_FILE_FORMAT_TGA, io_make_saved(SHD_FORMAT_RGBA8, "c.tga"));
    io_add_sample(&n, "bmp", SHD_FILE_FORMAT_BMP, io_make_saved(SHD_FORMAT_RGBA8, "c.bmp"));
    io_add_sample(&n, "webp", SHD_FILE_FORMAT_WEBP, io_copy(k_sample_webp, sizeof k_sample_webp));
    io_add_sample(&n, "pgm_text", SHD_FILE_FORMAT_PNM, io_copy(pgm, sizeof pgm - 1));
    io_add_sample(&n, "ppm", SHD_FILE_FORMAT_PNM, io_copy(ppm, sizeof ppm - 1));
#endif
    assert_int_equal(n, IO_SAMPLE_COUNT);
}

static inline void io_free_corpus(void)
{
    int i;
    for (i = 0; i < IO_SAMPLE_COUNT; ++i) free(g_corpus[i].bytes.data);
}

#endif /* SHD_TESTS_SUPPORT_IO_CORPUS_H */
