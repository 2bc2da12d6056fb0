/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Images prepared for filtering, which change only by shd_texture_update().
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; functions taking `const shd_texture *` may run
 *                concurrently on one texture, shd_texture_update() one thread at a time per object and
 *                not while any other call uses the texture, not even one that renders with it.
 */
#ifndef SHD_TEXTURE_H
#define SHD_TEXTURE_H

#include <shd/context.h>
#include <shd/image.h>

SHD_BEGIN_DECLS

/** A two-dimensional texture, or an array of them, with its prefiltered tables. */
typedef struct shd_texture shd_texture;

/** Prefiltered tables a texture can carry; combine with |. */
typedef enum shd_table {
    SHD_TABLE_NONE = 0,   /**< the base level alone */
    SHD_TABLE_MIPMAP = 1, /**< levels max(1, floor(size / 2^l)) down to 1 x 1 (Williams 1983); memory 4/3 */
    /**
     * Levels max(1, floor(width / 2^i)) x max(1, floor(height / 2^j)) for every i and j; memory at most 4, with a
     * mipmap too, whose levels are among them. Textures of up to 2^26 texels.
     */
    SHD_TABLE_RIPMAP = 2,
    /**
     * Sums over all rectangles at the origin (Crow 1984), (width + 1) x (height + 1) of them for every stored channel
     * and layer: 4 bytes each for 8-bit unorm of up to 2^24 texels a layer, else 8; 4 more where a binary16 or
     * binary32 texel is not finite. Exact for unorm; for sRGB and floats with magnitudes up to m, within
     * 2^-51 width height m.
     */
    SHD_TABLE_SUMMED_AREA = 4,
    SHD_TABLE_MAX_ENUM = 0x7fffffff
} shd_table;

/** Where an output channel comes from. */
typedef enum shd_channel {
    SHD_CHANNEL_DEFAULT = 0, /**< the channel of its own place; `fill` where the format lacks it */
    SHD_CHANNEL_R = 1,
    SHD_CHANNEL_G = 2,
    SHD_CHANNEL_B = 3,
    SHD_CHANNEL_A = 4,
    SHD_CHANNEL_FILL = 5, /**< the constant `fill` of its place */
    SHD_CHANNEL_MAX_ENUM = 0x7fffffff
} shd_channel;

/** Bytes behind the last texel of a borrowed base level that lookups may read; what they hold does not matter. */
#define SHD_TEXTURE_PADDING 128

/** What a texture is made from. */
typedef struct shd_texture_desc {
    uint32_t struct_size; /**< set by shd_texture_desc_default() */
    shd_format format;    /**< any; no default. Three channels are stored as four */
    uint32_t width;       /**< texels, 1..65536; width * height * layers at most 2^28 */
    uint32_t height;      /**< texels, 1..65536 */
    const void *texels;   /**< [layers][height][width], row 0 on top; aligned to a channel; copied, but see `borrow` */
    size_t row_stride;    /**< bytes between rows, at least width * texel size; 0 = packed */
    size_t layer_stride;  /**< bytes between layers, at least height * row stride; 0 = packed */
    uint32_t layers;      /**< images of the array, 1..2048; default 1 */
    uint32_t tables;      /**< shd_table bits; default none */
    shd_channel swizzle[4]; /**< sources of r, g, b, a; default SHD_CHANNEL_DEFAULT. A missing channel reads `fill` */
    float fill[4];          /**< what missing channels read, finite; default 0, 0, 0, 1 */
    /**
     * Mip levels of the caller's, used with SHD_TABLE_MIPMAP: [layers][level_count], all of one struct_size, of
     * this format; element l is level l + 1, max(1, width >> (l + 1)) by max(1, height >> (l + 1)). Copied. A ripmap
     * of the same texture reads them where it has a level of the mipmap
     */
    const shd_image *levels;
    uint32_t level_count; /**< 0 = build them; fewer than down to 1 x 1 make a texture that ends there; default 0 */
    /**
     * 1 = do not copy `texels`: they are borrowed until release and change only as shd_texture_update() says. For
     * one layer of packed rows, not of three channels, aligned to a texel but at most 4 bytes.
     * SHD_TEXTURE_PADDING bytes behind the last texel must be readable: lookups load whole vectors. Lookups give the
     * bits of copied texels; default 0
     */
    uint32_t borrow;
    /* ---- end of 0.1; append below ---- */
} shd_texture_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_texture_desc shd_texture_desc_default(void)
{
    shd_texture_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.layers = 1;
    desc.fill[3] = 1.0f;
    return desc;
}

/**
 * Copy texels, or borrow them, and build the tables. Mip levels that are not given are area averages of the base
 * level, exact for any size, taken in linear light; sRGB levels are stored encoded again, rounded to nearest.
 * @param context      retained
 * @param desc         borrowed for the call, its texels until release where it says so
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
    shd_format format;    /**< of every level; RGBA for a format of three channels */
    uint32_t width;       /**< texels of level 0 */
    uint32_t height;      /**< texels of level 0 */
    uint32_t layers;      /**< images of the array */
    uint32_t level_count; /**< 1; with SHD_TABLE_MIPMAP all down to 1 x 1, or 1 more than levels were given */
    uint32_t tables;      /**< shd_table bits */
    size_t byte_size;     /**< of all tables but a borrowed base level, and of what shd_texture_update() keeps */
} shd_texture_info;

/**
 * Size, format and memory of a texture.
 * @param out_info  all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_get_info(const shd_texture *texture, shd_texture_info *out_info);

/**
 * Copy one mip level out as stored (sRGB stays encoded).
 * @param layer  0..layers - 1
 * @param level  0..level_count - 1; its size is max(1, width >> level) by max(1, height >> level)
 * @param out    image of that size and of the format that shd_texture_get_info tells
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_read_level(const shd_texture *texture, uint32_t layer, uint32_t level,
                                                        const shd_image *out);

/**
 * Write a rectangle of the base level of one layer, and rebuild what depends on it: the texture is then, bit for bit,
 * what shd_texture_create() makes of the changed base. Only mip levels that the caller gave stay as they are.
 *
 * The first update of a layer whose size halves evenly several times rebuilds all its mip levels, to keep unrounded
 * averages of every 16 x 16 texels (of 32 x 32 of floats), 1/32 of the memory of RGBA8 texels; other updates touch the
 * texels over their rectangle. Levels that follow an odd width or height, and ripmap levels, read all of the base that
 * these cover, ripmap levels in whole rows; a summed-area table is summed anew for the layer.
 *
 * Texels of a borrowed base level are the caller's to write, before this call and while no other uses the texture; its
 * `texels` then have the size of the rectangle and NULL for pixels.
 *
 * Nothing is written if anything is refused or memory runs out. After SHD_ERROR_CALLBACK, when the executor fails,
 * the rectangle and what depends on it are undefined until the same update succeeds.
 * @param texture  used by no other call meanwhile
 * @param layer    0..layers - 1
 * @param x,y      first column and row of the rectangle
 * @param texels   its size and texels, of the format that the texture was made from or that shd_texture_get_info()
 *                 tells; borrowed for the call
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_update(shd_texture *texture, uint32_t layer, uint32_t x, uint32_t y,
                                                    const shd_image *texels);

SHD_END_DECLS

#endif /* SHD_TEXTURE_H */
