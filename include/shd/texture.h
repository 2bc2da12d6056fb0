/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Immutable images prepared for filtering.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; functions taking `const shd_texture *` may run
 *                concurrently on one texture.
 */
#ifndef SHD_TEXTURE_H
#define SHD_TEXTURE_H

#include <shd/context.h>
#include <shd/image.h>

SHD_BEGIN_DECLS

/** A two-dimensional texture with its prefiltered tables. */
typedef struct shd_texture shd_texture;

/** Prefiltered tables a texture can carry; combine with |. */
typedef enum shd_table {
    SHD_TABLE_NONE = 0,   /**< the base level alone */
    SHD_TABLE_MIPMAP = 1, /**< levels max(1, floor(size / 2^l)) down to 1 x 1 (Williams 1983); memory 4/3 */
    SHD_TABLE_MAX_ENUM = 0x7fffffff
} shd_table;

/** What a texture is made from. */
typedef struct shd_texture_desc {
    uint32_t struct_size; /**< set by shd_texture_desc_default() */
    shd_format format;    /**< R8, RGBA8, RGBA8_SRGB, RGBA16F or RGBA32F; no default */
    uint32_t width;       /**< texels, 1..65536; width * height at most 2^28 */
    uint32_t height;      /**< texels, 1..65536 */
    const void *texels;   /**< [height][width], row 0 on top; aligned to a channel; copied */
    size_t row_stride;    /**< bytes between rows, at least width * texel size; 0 = packed */
    uint32_t tables;      /**< shd_table bits; default none */
    uint32_t reserved;    /**< 0 */
    /* ---- end of 0.1; append below ---- */
} shd_texture_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_texture_desc shd_texture_desc_default(void)
{
    shd_texture_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/**
 * Copy texels and build the tables. Mip levels are area averages of the base level, exact for any size,
 * taken in linear light; sRGB levels are stored encoded again, rounded to nearest.
 * @param context      retained
 * @param desc         borrowed for the call
 * @param out_texture  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_create(shd_context *context, const shd_texture_desc *desc,
                                                    shd_texture **out_texture);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_texture_retain(shd_texture *texture);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_texture_release(shd_texture *texture);

/** What a texture turned out to be. */
typedef struct shd_texture_info {
    shd_format format;    /**< of every level */
    uint32_t width;       /**< texels of level 0 */
    uint32_t height;      /**< texels of level 0 */
    uint32_t level_count; /**< 1, or floor(log2(max(width, height))) + 1 with SHD_TABLE_MIPMAP */
    size_t byte_size;     /**< of all tables */
} shd_texture_info;

/**
 * Size, format and memory of a texture.
 * @param out_info  all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_get_info(const shd_texture *texture, shd_texture_info *out_info);

/**
 * Copy one level out as stored (sRGB stays encoded).
 * @param level  0..level_count - 1; its size is max(1, width >> level) by max(1, height >> level)
 * @param out    image of that size and of the texture's format
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_read_level(const shd_texture *texture, uint32_t level,
                                                        const shd_image *out);

SHD_END_DECLS

#endif /* SHD_TEXTURE_H */
