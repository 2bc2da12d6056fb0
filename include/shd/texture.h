/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Textures: images prepared for filtering. Only shd_texture_update() changes them.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; functions taking `const shd_texture *` may run concurrently on one
 *                texture. shd_texture_update() needs the texture for itself: no other call may use the texture
 *                concurrently. This includes renders that use it.
 *
 * @code
 * shd_texture_desc desc = shd_texture_desc_default();
 * desc.format = SHD_FORMAT_RGBA8_SRGB;
 * desc.width = width, desc.height = height;
 * desc.texels = pixels; // copied
 * desc.tables = SHD_TABLE_MIPMAP;
 * result = shd_texture_create(context, &desc, &texture);
 * @endcode
 */
#ifndef SHD_TEXTURE_H
#define SHD_TEXTURE_H

#include <shd/context.h>
#include <shd/image.h>
#include <shd/projection.h>
#include <shd/tile_cache.h>

SHD_BEGIN_DECLS

/** A two-dimensional texture, an array of them, a 3D texture or a texture of directions, with its tables. */
typedef struct shd_texture shd_texture;

/** Prefiltered tables of a texture; combine with |. */
typedef enum shd_table {
    SHD_TABLE_NONE = 0,   /**< the base level alone */
    SHD_TABLE_MIPMAP = 1, /**< levels max(1, floor(size / 2^l)) down to 1 x 1 (Williams 1983); 4/3 of the memory */
    /**
     * Levels max(1, floor(width / 2^i)) x max(1, floor(height / 2^j)) for every i and j. Takes at most 4 times the
     * memory, including the mipmap, whose levels are shared. For textures of up to 2^26 texels.
     */
    SHD_TABLE_RIPMAP = 2,
    /**
     * Sums over all rectangles at the origin (Crow 1984): (width + 1) x (height + 1) sums for every stored channel and
     * layer. A sum takes 4 bytes for 8-bit unorm of up to 2^24 texels a layer, else 8, and 4 more where a binary16 or
     * binary32 texel is not finite. Sums are exact for unorm. For sRGB and floats of magnitude up to m they are within
     * 2^-51 width height m.
     */
    SHD_TABLE_SUMMED_AREA = 4,
    SHD_TABLE_MAX_ENUM = 0x7fffffff
} shd_table;
typedef uint32_t shd_table_flags; /**< shd_table bits */

/** Source of an output channel. */
typedef enum shd_channel {
    SHD_CHANNEL_DEFAULT = 0, /**< the channel at the same position; `fill` if the format lacks it */
    SHD_CHANNEL_R = 1,
    SHD_CHANNEL_G = 2,
    SHD_CHANNEL_B = 3,
    SHD_CHANNEL_A = 4,
    SHD_CHANNEL_FILL = 5, /**< the element of `fill` at the same position */
    SHD_CHANNEL_MAX_ENUM = 0x7fffffff
} shd_channel;

/** Meaning of the coordinates of a lookup. */
typedef enum shd_texture_kind {
    SHD_TEXTURE_KIND_2D = 0, /**< (u, v) on an image, or on one layer of an array of images */
    SHD_TEXTURE_KIND_3D = 1, /**< (u, v, w) in a stack of `depth` slices; w = 0 is the outer face of slice 0 */
    /** (u, v, w) is a direction of any length, which `projection` maps to the image, or to the six faces of CUBE. */
    SHD_TEXTURE_KIND_DIRECTIONS = 2,
    SHD_TEXTURE_KIND_MAX_ENUM = 0x7fffffff
} shd_texture_kind;

/** Options of a texture; combine with |. */
typedef enum shd_texture_flag {
    SHD_TEXTURE_NONE = 0,
    /**
     * Borrow `texels` until release instead of copying them. Only shd_texture_update() may change them. Requires one
     * layer of packed rows, or packed slices of packed rows, a format without three channels or RGB9E5, and texels
     * aligned to min(size of a texel, 4) bytes. SHD_TEXTURE_PADDING bytes behind the last texel must be readable,
     * because lookups load whole vectors. Blocks need neither the alignment nor the padding, and must not change while
     * the texture lives, because decoded blocks are kept between calls. Lookups give the same bits as for copied
     * texels.
     */
    SHD_TEXTURE_BORROW = 1,
    /**
     * With SHD_TEXTURE_BORROW: borrow the mip levels as well. Levels 0, 1, 2 ... then follow one another without gaps
     * from `texels` on, as in a file that is mapped to memory; `level_images` has their addresses. Not for 3D textures,
     * and not for blocks. shd_texture_update() gives SHD_ERROR_UNSUPPORTED.
     */
    SHD_TEXTURE_BORROW_LEVELS = 2,
    /**
     * The texels are premultiplied: r, g and b are multiplied by a. Lookups give such numbers, too. The slots
     * SHD_SLOT_DIFFUSE and SHD_SLOT_TINT divide filtered r, g and b by filtered a (shd/slot.h).
     */
    SHD_TEXTURE_PREMULTIPLIED = 4,
    SHD_TEXTURE_FLAG_MAX_ENUM = 0x7fffffff
} shd_texture_flag;
typedef uint32_t shd_texture_flags; /**< shd_texture_flag bits */

/** Bytes behind the last texel of a borrowed base level that lookups may read; their values have no effect. */
#define SHD_TEXTURE_PADDING 128

/** Texels and tables of a texture. Required: format, width, height, texels. */
typedef struct shd_texture_desc {
    uint32_t struct_size;  /**< set by shd_texture_desc_default() */
    shd_texture_kind kind; /**< default SHD_TEXTURE_KIND_2D */
    /**
     * Any; no default. RGB8 to RGB32F are stored as RGBA. Blocks stay compressed, and lookups decode them
     * (docs/compressed.md): the caller gives its mip levels; other tables are kept decoded.
     */
    shd_format format;
    uint32_t width;  /**< texels, 1..65536; width * height * layer_count at most 2^28; see `tiles` for larger ones */
    uint32_t height; /**< texels, 1..65536 */
    /**
     * 3D: slices, 1..65536, required; other kinds: 0. width * height * depth is at most 2^28, and SHD_TABLE_MIPMAP is
     * the only table. Texels are [depth][height][width], and `layer_stride` is the distance of slices. A level halves
     * all three sizes.
     */
    uint32_t depth;
    size_t layer_count; /**< images of the array, 1..2048; 3D: 1; CUBE: 1 or 6 mean the six faces; default 1 */
    /**
     * DIRECTIONS: any but SHD_PROJECTION_NONE, required; other kinds: NONE. The six layers of CUBE are the faces +X,
     * -X, +Y, -Y, +Z, -Z. `width` and `height` are equal unless it is LAT_LONG; SHD_TABLE_MIPMAP is the only table. Mip
     * levels are averages of texels of one image, unweighted.
     */
    shd_projection projection;
    /**
     * [layer_count][height][width], row 0 on top, aligned to a channel; copied without SHD_TEXTURE_BORROW. Blocks:
     * [layer_count][ceil(height / 4)][ceil(width / 4)], at any address.
     */
    const void *texels;
    size_t row_stride;       /**< bytes between rows of texels or blocks, at least the bytes of a row; 0 = packed */
    size_t layer_stride;     /**< bytes between layers, at least the rows of a layer times the row stride; 0 = packed */
    shd_texture_flags flags; /**< default none */
    shd_table_flags tables;  /**< default none */
    /**
     * Number of `level_images` per layer; the mipmap ends with the last one, even if it is larger than 1 x 1; default 0
     * = the library builds the levels.
     */
    size_t level_count;
    /**
     * The caller's mip levels for SHD_TABLE_MIPMAP: [layer_count][level_count], all of one struct_size, of this format;
     * copied. Element l is level l + 1: max(1, width >> (l + 1)) by max(1, height >> (l + 1)). A ripmap of the same
     * texture uses them for the levels that it shares with the mipmap. A 3D texture has the max(1, depth >> 1) slices
     * of level 1 first, then the slices of level 2, and so on.
     */
    const shd_image *level_images;
    shd_channel swizzle[4]; /**< sources of r, g, b, a of lookups; default SHD_CHANNEL_DEFAULT */
    /**
     * Values of channels that the format does not have, in lookups inside and outside the image; finite; default 0, 0,
     * 0, 1.
     */
    float fill[4];
    /**
     * Default none. With a cache, the texture keeps no texels: `texels` is NULL, strides are not read, nothing is
     * borrowed, and the format has not three channels. `width` and `height` are 1..2^20, and the tiles of all levels
     * and layers at most 2^30. SHD_TABLE_RIPMAP and SHD_TABLE_SUMMED_AREA are built in memory, of all levels, when the
     * texture is made; dropped tiles do not change them. The callback writes the mip levels too. `level_count` is their
     * number, 0 = down to 1 x 1; `level_images` is NULL. Coordinates are binary32 floats: beyond 65536 texels, filters
     * have fewer than 8 bits for the fraction of a texel. SHD_PRECISION_FAST has no effect. SHD_FILTER_EXACT,
     * shd_texture_explain() and shd_texture_bounds() wait for the tiles that they read, also with
     * SHD_MISSING_TILES_COARSER.
     */
    shd_tile_source tiles;
    /* ---- end of 0.1; append below ---- */
} shd_texture_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_texture_desc shd_texture_desc_default(void)
{
    shd_texture_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.layer_count = 1;
    desc.fill[3] = 1.0f;
    return desc;
}

/**
 * Make a texture: copy or borrow texels, and build the tables.
 *
 * Mip levels that are not given are area averages of the base level, exact for any size, computed in linear light.
 * Levels of sRGB formats are stored sRGB-encoded and rounded to nearest.
 * @param context      retained
 * @param desc         borrowed for the call; its texels until release with SHD_TEXTURE_BORROW
 * @param out_texture  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_create(shd_context *context, const shd_texture_desc *desc,
                                                    shd_texture **out_texture);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_texture_retain(shd_texture *texture);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_texture_release(shd_texture *texture);

/** Size, format and memory of a texture. */
typedef struct shd_texture_info {
    uint32_t struct_size;  /**< set by shd_texture_info_default() */
    shd_texture_kind kind; /**< as in its desc */
    shd_format format;     /**< format of every level; RGBA for RGB8 to RGB32F, with _SRGB */
    uint32_t width;        /**< texels of level 0 */
    uint32_t height;       /**< texels of level 0 */
    uint32_t depth;        /**< 3D: slices of level 0; else 0 */
    size_t layer_count;    /**< images: of the array, 6 for CUBE */
    /** 1; with SHD_TABLE_MIPMAP the number of levels down to 1 x 1, or the number of given levels + 1. */
    size_t level_count;
    shd_projection projection; /**< DIRECTIONS: as in its desc; else SHD_PROJECTION_NONE */
    shd_table_flags tables;    /**< tables of the texture */
    shd_texture_flags flags;   /**< as in its desc */
    /** Bytes of all tables and of the data that shd_texture_update() keeps, without a borrowed base level. */
    size_t byte_size;
    /* ---- end of 0.1; append below ---- */
} shd_texture_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_texture_info shd_texture_info_default(void)
{
    shd_texture_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Get size, format and memory of a texture.
 * @param out_info  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_get_info(const shd_texture *texture, shd_texture_info *out_info);

/**
 * Copy one mip level of a layer, or a slice of it in 3D, out as stored: sRGB stays encoded, and the swizzle does not
 * apply. The fourth channel of a format of three is 0 here, while lookups give `fill`. Tiles of blocks are read again.
 * shd_texture_read_table() gives linear values of all tables.
 * @param layer  0..layer_count - 1; of a 3D texture the slice, 0..max(1, depth >> level) - 1
 * @param level  0..level_count - 1; its size is max(1, width >> level) by max(1, height >> level)
 * @param out    image of that size, and of the format in shd_texture_info; blocks are copied as they are
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_read_level(const shd_texture *texture, uint32_t layer, uint32_t level,
                                                        const shd_image *out);

/**
 * Write a rectangle of the base level of one layer or slice, and rebuild the tables that depend on it. Textures of
 * compressed blocks give SHD_ERROR_UNSUPPORTED.
 *
 * The texture then has the bits that shd_texture_create() gives for the changed base. Mip levels that the caller gave
 * stay as they are.
 *
 * Cost: the first update of a layer whose size halves evenly several times rebuilds all its mip levels and keeps
 * unrounded averages of every 16 x 16 texels (32 x 32 of floats), 1/32 of the memory of RGBA8 texels. Other updates
 * compute only the texels that cover the rectangle. Levels below an odd width or height read all base texels under
 * these texels; ripmap levels do so in whole rows. A summed-area table is recomputed for the whole layer. Levels of 3D
 * textures read 16 slices under the rectangle, or all base texels below an odd size.
 *
 * If the base level is borrowed, the caller writes its texels before this call, while no other call uses the texture.
 * `texels` then has the size of the rectangle, and its pixels are NULL.
 *
 * Nothing is written if an argument is refused or memory runs out. After SHD_ERROR_CALLBACK, when the executor fails,
 * the rectangle and the table entries that cover it are undefined until the same update succeeds.
 * @param texture  used by no other call concurrently
 * @param layer    0..layer_count - 1; of a 3D texture the slice, 0..depth - 1
 * @param x,y      first column and row of the rectangle
 * @param texels   size and texels of the rectangle, in the format of shd_texture_desc or of shd_texture_info; borrowed
 *                 for the call
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_update(shd_texture *texture, uint32_t layer, uint32_t x, uint32_t y,
                                                    const shd_image *texels);

SHD_END_DECLS

#endif /* SHD_TEXTURE_H */
