/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Pixel formats, and plain images in the caller's memory.
 *
 * Row 0 is the top row. Channels are interleaved in the order of the format's name, in native endianness.
 */
#ifndef SHD_IMAGE_H
#define SHD_IMAGE_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** How one pixel or texel is stored. Unsigned integer channels mean value / maximum, in [0, 1]. */
typedef enum shd_format {
    SHD_FORMAT_NONE = 0,
    SHD_FORMAT_R8 = 1,         /**< 8-bit unorm, one channel, linear */
    SHD_FORMAT_RGBA8 = 2,      /**< 8-bit unorm, linear */
    SHD_FORMAT_RGBA8_SRGB = 3, /**< 8-bit; r, g, b sRGB-encoded (IEC 61966-2-1), a linear */
    SHD_FORMAT_RGBA16F = 4,    /**< IEEE 754 binary16, linear */
    SHD_FORMAT_RGBA32F = 5,    /**< IEEE 754 binary32, linear */
    SHD_FORMAT_RGBA16 = 6,     /**< 16-bit unorm; images only, not textures */
    SHD_FORMAT_MAX_ENUM = 0x7fffffff
} shd_format;

/** Bytes of one pixel; 0 for an unknown format. Any thread. @since 0.1 */
SHD_API size_t shd_format_size(shd_format format);

/** An image in the caller's memory. */
typedef struct shd_image {
    uint32_t struct_size; /**< set by shd_image_default() */
    shd_format format;    /**< how `pixels` is stored */
    uint32_t width;       /**< pixels, 1..65536 */
    uint32_t height;      /**< pixels, 1..65536 */
    void *pixels;         /**< [height][width], row 0 on top; borrowed for the call */
    size_t row_stride;    /**< bytes between rows, at least width * pixel size; 0 = packed */
    /* ---- end of 0.1; append below ---- */
} shd_image;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_image shd_image_default(void)
{
    shd_image image = SHD_ZERO_INIT;
    image.struct_size = (uint32_t)sizeof image;
    return image;
}

SHD_END_DECLS

#endif /* SHD_IMAGE_H */
