/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Pixel formats, and plain images in the caller's memory.
 *
 * Row 0 is the top row. Channels are interleaved in the order of the format's name, in native endianness.
 *
 * Thread safety: any thread.
 *
 * @code
 * shd_image image = shd_image_default();
 * image.format = SHD_FORMAT_RGBA8;
 * image.width = width, image.height = height;
 * image.pixels = malloc(shd_format_size(image.format) * width * height);
 * @endcode
 */
#ifndef SHD_IMAGE_H
#define SHD_IMAGE_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/**
 * Storage of one pixel or texel.
 *
 * Unsigned integer channels hold value / maximum, in [0, 1]; F channels are IEEE 754 binary16 or binary32. All channels
 * are linear, except r, g and b of the _SRGB formats, which are encoded (IEC 61966-2-1). Textures take every format;
 * framebuffers, colour transforms and files list the formats that they take.
 *
 * BC formats are blocks of 4 x 4 texels, row by row from the top left (Khronos Data Format Specification 1.3, chapters
 * 18 to 20). Only shd_texture_create() and shd_texture_read_level() take them. docs/compressed.md has their values.
 */
typedef enum shd_format {
    SHD_FORMAT_NONE = 0,
    SHD_FORMAT_R8 = 1,
    SHD_FORMAT_RGBA8 = 2,
    SHD_FORMAT_RGBA8_SRGB = 3,
    SHD_FORMAT_RGBA16F = 4,
    SHD_FORMAT_RGBA32F = 5,
    SHD_FORMAT_RGBA16 = 6,
    SHD_FORMAT_RG8 = 7,
    SHD_FORMAT_RGB8 = 8,
    SHD_FORMAT_R8_SRGB = 9,
    SHD_FORMAT_RG8_SRGB = 10,
    SHD_FORMAT_RGB8_SRGB = 11,
    SHD_FORMAT_R16 = 12,
    SHD_FORMAT_RG16 = 13,
    SHD_FORMAT_RGB16 = 14,
    SHD_FORMAT_R16F = 15,
    SHD_FORMAT_RG16F = 16,
    SHD_FORMAT_RGB16F = 17,
    SHD_FORMAT_R32F = 18,
    SHD_FORMAT_RG32F = 19,
    SHD_FORMAT_RGB32F = 20,
    SHD_FORMAT_BC1_RGB = 21, /**< blocks of 8 bytes; every texel is opaque */
    SHD_FORMAT_BC1_RGB_SRGB = 22,
    SHD_FORMAT_BC1_RGBA = 23, /**< blocks of 8 bytes; texels may be transparent black */
    SHD_FORMAT_BC1_RGBA_SRGB = 24,
    SHD_FORMAT_BC2 = 25, /**< blocks of 16 bytes, as all of the following except BC4 */
    SHD_FORMAT_BC2_SRGB = 26,
    SHD_FORMAT_BC3 = 27,
    SHD_FORMAT_BC3_SRGB = 28,
    SHD_FORMAT_BC4 = 29,         /**< one channel in 0..1, blocks of 8 bytes */
    SHD_FORMAT_BC4_SNORM = 30,   /**< one channel in -1..1, blocks of 8 bytes */
    SHD_FORMAT_BC5 = 31,         /**< two channels in 0..1 */
    SHD_FORMAT_BC5_SNORM = 32,   /**< two channels in -1..1 */
    SHD_FORMAT_BC6H_UFLOAT = 33, /**< three channels from 0 to 65504 */
    SHD_FORMAT_BC6H_SFLOAT = 34, /**< three channels from -65504 to 65504 */
    SHD_FORMAT_BC7 = 35,
    SHD_FORMAT_BC7_SRGB = 36,
    /**
     * One uint32_t: r, g, b as numbers of 9 bits from bit 0 on, e in bits 27 to 31. A channel is its number times 2^(e
     * - 24): 0 to 65408.
     */
    SHD_FORMAT_RGB9E5 = 37,
    SHD_FORMAT_MAX_ENUM = 0x7fffffff
} shd_format;

/** Bytes of one pixel; 0 for an unknown format, and for formats of blocks. Any thread. @since 0.1 */
SHD_API size_t shd_format_size(shd_format format);

/** Bytes of one block of 4 x 4 texels: 8 or 16; 0 for formats of pixels, and unknown ones. Any thread. @since 0.1 */
SHD_API size_t shd_format_block_size(shd_format format);

/** An image in the caller's memory. Required: format, width, height, pixels. */
typedef struct shd_image {
    uint32_t struct_size; /**< set by shd_image_default() */
    shd_format format;    /**< storage of `pixels` */
    uint32_t width;       /**< pixels, 1..65536 */
    uint32_t height;      /**< pixels, 1..65536 */
    /** [height][width], row 0 on top; borrowed for the call; blocks are [ceil(height / 4)][ceil(width / 4)]. */
    void *pixels;
    size_t row_stride; /**< bytes between rows of pixels or blocks, at least the bytes of a row; 0 = packed */
    /* ---- end of 0.1; append below ---- */
} shd_image;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_image shd_image_default(void)
{
    shd_image image = SHD_ZERO_INIT;
    image.struct_size = (uint32_t)sizeof image;
    return image;
}

/** A rectangle of pixels or texels. Frozen. */
typedef struct shd_region {
    uint32_t x;      /**< first column from the left */
    uint32_t y;      /**< first row from the top */
    uint32_t width;  /**< columns */
    uint32_t height; /**< rows */
} shd_region;

SHD_END_DECLS

#endif /* SHD_IMAGE_H */
