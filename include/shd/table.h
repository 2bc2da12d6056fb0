/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief The tables of textures as columns of floats: a level, sums, or a whole table as one picture.
 *
 * For people who look at tables or check them; lookups do not need this header. shd_texture_read_level() copies mip
 * levels as they are stored.
 *
 * Columns have the channels r, g, b and a of lookups: linear, after swizzle and fill, premultiplied if the texels are.
 * Elements are row by row from the top.
 *
 * Thread safety: concurrent reads.
 *
 * @code
 * shd_table_desc desc = shd_table_desc_default();
 * shd_table_info info = shd_table_info_default();
 * desc.table = SHD_TABLE_RIPMAP;
 * desc.view = SHD_TABLE_VIEW_PICTURE;
 * result = shd_texture_get_table_info(texture, &desc, &info);
 * // four columns of info.width * info.height floats in `out`
 * result = shd_texture_read_table(texture, &desc, out);
 * @endcode
 */
#ifndef SHD_TABLE_H
#define SHD_TABLE_H

#include <shd/column.h>
#include <shd/texture.h>

SHD_BEGIN_DECLS

/** Part of a table that is read, and its form. */
typedef enum shd_table_view {
    /**
     * MIPMAP and RIPMAP: the texels of one level. An element has the bits that SHD_FILTER_NEAREST gives for that texel.
     * SUMMED_AREA: (width + 1) x (height + 1) sums. Element (x, y) is the sum of the values of all texels left of
     * column x and above row y (Crow 1984). Sums are not normalised: the mean of a rectangle is the sum of its four
     * corners, with signs, over its number of texels. Texels that are not finite count as 0. Each sum is rounded to a
     * float once, so differences of large sums lose bits that lookups keep; sums beyond floats are infinite.
     */
    SHD_TABLE_VIEW_LEVEL = 0,
    /**
     * MIPMAP: level 0 at the left, and the other levels under each other at its right (as Williams 1983, without his
     * separation of r, g and b). RIPMAP: all levels, level_u to the right and level_v down. Elements beside the levels
     * are 0 in all four columns. SUMMED_AREA: element (x, y) is the mean of columns 0..x and rows 0..y, over texels
     * that are finite; NaN if there is none.
     */
    SHD_TABLE_VIEW_PICTURE = 1,
    SHD_TABLE_VIEW_MAX_ENUM = 0x7fffffff
} shd_table_view;

/** The part of a texture that is read. Required: table. */
typedef struct shd_table_desc {
    uint32_t struct_size; /**< set by shd_table_desc_default() */
    shd_table table;      /**< SHD_TABLE_MIPMAP, _RIPMAP or _SUMMED_AREA; the texture must have it */
    shd_table_view view;  /**< default SHD_TABLE_VIEW_LEVEL */
    /**
     * Layer or face, 0..layer_count - 1; of a 3D texture the slice, 0..max(1, depth >> level_u) - 1. The picture of a
     * 3D texture shows slice min(layer >> l, last one) of level l; `layer` is then 0..depth - 1. Default 0.
     */
    uint32_t layer;
    uint32_t level_u; /**< number of times the width was halved, below shd_table_info.level_count_u; default 0 */
    /** Number of times the height was halved, below shd_table_info.level_count_v; MIPMAP: level_u. Default 0. */
    uint32_t level_v;
    /* ---- end of 0.1; append below ---- */
} shd_table_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_table_desc shd_table_desc_default(void)
{
    shd_table_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/** Size of the part that a shd_table_desc names, and the levels of the table. */
typedef struct shd_table_info {
    uint32_t struct_size;   /**< set by shd_table_info_default() */
    uint32_t width;         /**< elements of a row */
    uint32_t height;        /**< rows */
    uint32_t level_count_u; /**< MIPMAP: levels; RIPMAP: levels across, floor(log2(width)) + 1; SUMMED_AREA: 1 */
    uint32_t level_count_v; /**< MIPMAP: levels; RIPMAP: levels down, floor(log2(height)) + 1; SUMMED_AREA: 1 */
    uint32_t x;             /**< PICTURE: column of the first texel of level (level_u, level_v); else 0 */
    uint32_t y;             /**< PICTURE: its row; else 0 */
    /* ---- end of 0.1; append below ---- */
} shd_table_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_table_info shd_table_info_default(void)
{
    shd_table_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Get the size of a level, of sums or of a picture.
 * @param desc      borrowed for the call. SHD_ERROR_INVALID_ARGUMENT if the texture does not have the table
 * @param out_info  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_get_table_info(const shd_texture *texture, const shd_table_desc *desc,
                                                            shd_table_info *out_info);

/**
 * Copy a level, sums or a picture into columns, on the executor of the texture's context.
 *
 * Levels of compressed blocks and of tiles are decoded into temporary memory, one level after the other; tiles are
 * loaded.
 * @param desc  borrowed for the call
 * @param out   [4] columns r, g, b, a of shd_table_info.width * height elements; NULL data = not wanted. They must not
 *              overlap (checked). They are unspecified if memory runs out, a tile does not load or the executor fails
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_read_table(const shd_texture *texture, const shd_table_desc *desc,
                                                        const shd_f32_out *out);

SHD_END_DECLS

#endif /* SHD_TABLE_H */
