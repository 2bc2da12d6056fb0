/* SPDX-License-Identifier: MIT */
/* KTX2 and DDS files, built byte by byte (Khronos, "KTX File Format Specification 2.0", 2021, section 3; Microsoft,
 * "Programming Guide for DDS"). */
#ifndef SHD_TESTS_SUPPORT_TEXTURE_FILES_H
#define SHD_TESTS_SUPPORT_TEXTURE_FILES_H

#include "support/dds_file.h"
#include "support/io_files.h"

#include <shd/texture_file.h>

/** Whether a load was refused because its decoder was absent when libshd_io was built. Prints the package. */
static inline int file_is_absent(shd_result result)
{
    if (result != SHD_ERROR_UNSUPPORTED || !strstr(shd_last_error(), "was built without")) return 0;
    print_message("skipped: %s\n", shd_last_error());
    return 1;
}

/** A texture: its storage, and the bytes of all images. */
typedef struct file_texture {
    uint32_t width, height, depth, layers; /**< as in the header of KTX2: 0 = no such dimension */
    uint32_t faces, level_count;
    uint32_t unit;             /**< bytes of a pixel or block */
    uint32_t block_w, block_h; /**< texels of a unit */
} file_texture;

/** Fields of a KTX2 file beside its texture. */
typedef struct file_ktx2 {
    uint32_t format, type_size;        /**< VkFormat */
    uint32_t model, transfer;          /**< fields of the descriptor */
    uint32_t scheme;                   /**< supercompression 0, 2 or 3; streams of stored blocks */
    const char *swizzle, *orientation; /**< NULL = none */
} file_ktx2;

static inline uint32_t file_side(uint32_t base, uint32_t level) { return base >> level ? base >> level : 1; }

/** Bytes of an image of a level, with all slices. */
static inline size_t file_image_size(const file_texture *t, uint32_t level)
{
    const uint32_t w = file_side(t->width, level), h = file_side(t->height, level), d = file_side(t->depth, level);
    return (size_t)((w + t->block_w - 1) / t->block_w) * ((h + t->block_h - 1) / t->block_h) * d * t->unit;
}

static inline uint32_t file_image_count(const file_texture *t) { return (t->layers ? t->layers : 1) * t->faces; }

/** Byte i of an image: all bit patterns occur, but no half or float that is NaN in its last byte. */
static inline unsigned char file_byte(uint32_t level, uint32_t image, size_t i)
{
    uint32_t h = (uint32_t)i * 2654435761u + level * 40503u + image * 977u + 7;
    h ^= h >> 15;
    h *= 2246822519u;
    return (unsigned char)((h >> 13) & 0x3b);
}

static inline void file_put(io_bytes *out, const void *bytes, size_t size)
{
    out->data = (unsigned char *)realloc(out->data, out->size + size + 1);
    memcpy(out->data + out->size, bytes, size);
    out->size += size;
}

static inline void file_number(io_bytes *out, uint64_t value, size_t size)
{
    unsigned char bytes[8];
    size_t i;
    for (i = 0; i < size; ++i) bytes[i] = (unsigned char)(value >> (8 * i));
    file_put(out, bytes, size);
}

static inline void file_set(io_bytes *out, size_t at, uint64_t value, size_t size)
{
    size_t i;
    for (i = 0; i < size; ++i) out->data[at + i] = (unsigned char)(value >> (8 * i));
}

static inline void file_image(io_bytes *out, const file_texture *t, uint32_t level, uint32_t image)
{
    const size_t size = file_image_size(t, level);
    size_t i;
    for (i = 0; i < size; ++i) {
        const unsigned char byte = file_byte(level, image, i);
        file_put(out, &byte, 1);
    }
}

/** A Zstandard frame of one raw block (RFC 8878, 3.1.1). At most 2^17 bytes. */
static inline void file_zstd(io_bytes *out, const io_bytes *in)
{
    file_number(out, 0xfd2fb528u, 4);
    file_number(out, 0xa0, 1); /* one segment, content size of four bytes */
    file_number(out, in->size, 4);
    file_number(out, 1 | in->size << 3, 3);
    file_put(out, in->data, in->size);
}

/** A zlib stream of stored blocks (RFC 1950, RFC 1951 3.2.4). */
static inline void file_zlib(io_bytes *out, const io_bytes *in)
{
    uint32_t a = 1, b = 0;
    size_t i, at = 0;
    file_number(out, 0x0178, 2);
    do {
        const size_t piece = in->size - at < 65535 ? in->size - at : 65535;
        file_number(out, at + piece == in->size, 1);
        file_number(out, piece, 2);
        file_number(out, ~piece, 2);
        file_put(out, in->data + at, piece);
        at += piece;
    } while (at < in->size);
    for (i = 0; i < in->size; ++i) a = (a + in->data[i]) % 65521, b = (b + a) % 65521;
    file_number(out, b >> 8, 1), file_number(out, b, 1), file_number(out, a >> 8, 1), file_number(out, a, 1);
}

static inline void file_key(io_bytes *out, const char *key, const char *value)
{
    const size_t length = strlen(key) + strlen(value) + 2;
    file_number(out, length, 4);
    file_put(out, key, strlen(key) + 1);
    file_put(out, value, strlen(value) + 1);
    file_number(out, 0, (4 - length % 4) % 4);
}

static inline void file_descriptor(io_bytes *out, const file_texture *t, const file_ktx2 *k)
{
    file_number(out, 4 + 24 + 16, 4);
    file_number(out, 0, 4);
    file_number(out, 2, 2);
    file_number(out, 24 + 16, 2);
    file_number(out, k->model, 1), file_number(out, 1, 1), file_number(out, k->transfer, 1), file_number(out, 0, 1);
    file_number(out, t->block_w - 1, 1), file_number(out, t->block_h - 1, 1), file_number(out, 0, 2);
    file_number(out, t->unit, 8);
    file_number(out, 0, 8), file_number(out, 0xffffffff00000000u, 8); /* a sample, which no load reads */
}

/** Offset of the level index. */
enum { FILE_KTX2_INDEX = 80 };

/** The caller must free() it. `levels` NULL = the bytes of file_byte(), else [level_count] levels. */
static inline io_bytes file_make_ktx2(const file_texture *t, const file_ktx2 *k, const io_bytes *levels)
{
    static const unsigned char k_identifier[12] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};
    const uint32_t numbers[9] = {k->format, k->type_size, t->width,       t->height, t->depth,
                                 t->layers, t->faces,     t->level_count, k->scheme};
    io_bytes out = {NULL, 0};
    const uint32_t count = t->level_count ? t->level_count : 1;
    uint32_t l, i;
    size_t at;
    file_put(&out, k_identifier, 12);
    for (i = 0; i < 9; ++i) file_number(&out, numbers[i], 4);
    for (i = 0; i < 4 + 2 * 2 + 6 * count; ++i) file_number(&out, 0, 4);
    at = out.size;
    file_descriptor(&out, t, k);
    file_set(&out, 48, at, 4), file_set(&out, 52, out.size - at, 4);
    at = out.size;
    if (k->orientation) file_key(&out, "KTXorientation", k->orientation);
    if (k->swizzle) file_key(&out, "KTXswizzle", k->swizzle);
    if (out.size != at) file_set(&out, 56, at, 4), file_set(&out, 60, out.size - at, 4);
    for (l = count; l-- > 0;) {
        io_bytes level = {NULL, 0};
        while (k->scheme == 0 && out.size % 48 != 0) file_number(&out, 0, 1); /* a multiple of every unit and of 4 */
        at = out.size;
        if (levels) {
            file_put(&level, levels[l].data, levels[l].size);
        } else {
            for (i = 0; i < file_image_count(t); ++i) file_image(&level, t, l, i);
        }
        if (k->scheme == 2) file_zstd(&out, &level);
        if (k->scheme == 3) file_zlib(&out, &level);
        if (k->scheme == 0) file_put(&out, level.data, level.size);
        file_set(&out, FILE_KTX2_INDEX + 24 * l, at, 8);
        file_set(&out, FILE_KTX2_INDEX + 24 * l + 8, out.size - at, 8);
        file_set(&out, FILE_KTX2_INDEX + 24 * l + 16, level.size, 8);
        free(level.data);
    }
    return out;
}

/** A DDS file; code and dxgi as for shd_dds_header(). The caller must free() it. */
static inline io_bytes file_make_dds(const file_texture *t, const char *code, uint32_t dxgi)
{
    unsigned char header[SHD_DDS_HEADER];
    const size_t size = shd_dds_header(code, dxgi, t->width, t->height ? t->height : 1, 0, header);
    io_bytes out = {NULL, 0};
    uint32_t i, l;
    shd_dds_put(header + 8, 0x21007 | (t->depth ? 0x800000u : 0));
    shd_dds_put(header + 24, t->depth);
    shd_dds_put(header + 28, t->level_count);
    shd_dds_put(header + 112, (t->faces == 6 ? 0xfe00u : 0) | (t->depth ? 0x200000u : 0));
    if (dxgi) {
        shd_dds_put(header + 132, t->depth ? 4 : t->height ? 3 : 2);
        shd_dds_put(header + 136, t->faces == 6 ? 4 : 0);
        shd_dds_put(header + 140, t->layers ? t->layers : 1);
    }
    file_put(&out, header, size);
    for (i = 0; i < file_image_count(t); ++i)
        for (l = 0; l < t->level_count; ++l) file_image(&out, t, l, i);
    return out;
}

#endif /* SHD_TESTS_SUPPORT_TEXTURE_FILES_H */
