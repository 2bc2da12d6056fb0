/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief libshd_io: textures whose tiles stay in a file, of any size, until lookups need them.
 *
 * A file is a tiled TIFF (.tx, .tif) or OpenEXR with mip levels, as shd-maketx and maketx make it, or a KTX 2.0 or DDS
 * file. The content decides. Its header is read when the texture is opened. Lookups load tiles into a tile cache
 * (shd/tile_cache.h), and have the bits of a texture in memory that was made from the same levels. The levels of the
 * texture end with the last one of the file.
 *
 * Formats are those of the file: 8 bits, 16 bits, half or float, in one, two or four channels; three become four, and
 * the fourth is 1. 8-bit colour that is sRGB gets an _SRGB format. Numbers are not changed. Files whose colours are
 * multiplied by alpha give SHD_TEXTURE_PREMULTIPLIED textures.
 *
 * KTX2 and DDS files give the texture of shd_texture_load() (shd/texture_file.h): BC1 to BC7 and pixels, 2D, 3D, arrays
 * and cube maps, the first one of an array of cube maps. Tiles are rows of the file, read where they are: blocks are
 * not decoded before the cache has them. A file of one level gives a texture without SHD_TABLE_MIPMAP. Sides are up to
 * 2^20 texels. Files that must be converted first give SHD_ERROR_UNSUPPORTED: compressed levels, Basis Universal, ASTC,
 * channels in another order, bit fields.
 *
 * A set of files is one texture. The path of a UDIM set contains `<UDIM>` in place of the number of a file, which is
 * 1001 + column + 10 row; rows count from the bottom. All files have the same size, channels, levels and tiles. With
 * `columns` and `rows` of shd_tile_file_info, a point (U, V) of a UDIM layout, with V up, is u = U / columns, v = 1 - V
 * / rows. Files that do not exist have the colour `fill`. A set has the levels whose sizes halve evenly in each file.
 *
 * Files are trusted: OpenImageIO decodes all but KTX2 and DDS in this process. Damaged tiles give an error of the
 * lookup that names file, level and place, and the next lookup tries again. shd_texture_load() is for untrusted files.
 * Readers keep their descriptors: a host must not close descriptors that it did not open while such a texture exists.
 *
 * Thread safety: every function from any thread. Tiles are read by the threads that look up, concurrently: each uses a
 * reader of its own, and no lock is held while it reads.
 *
 * @code
 * shd_tile_file_desc desc = shd_tile_file_desc_default();
 * desc.cache = cache;
 * result = shd_texture_open(context, "earth.tx", &desc, &texture, NULL);
 * @endcode
 */
#ifndef SHD_TILE_FILE_H
#define SHD_TILE_FILE_H

#include <shd/io.h>

SHD_BEGIN_DECLS

/** Options of a texture in a file. Required: cache. */
typedef struct shd_tile_file_desc {
    uint32_t struct_size; /**< set by shd_tile_file_desc_default() */
    /**
     * Meaning of 8-bit numbers; default AUTO = as declared by the file, sRGB if it declares nothing. Other numbers must
     * be linear, or be declared so here.
     */
    shd_color_encoding encoding;
    shd_tile_cache *cache; /**< retained by the texture */
    /**
     * Open readers to keep, 1..4096; default 16. Each has a descriptor and some memory of OpenImageIO; more exist
     * while more threads read. A KTX2 or DDS file has one descriptor for all threads.
     */
    size_t max_readers;
    float fill[4]; /**< colour of absent files of a set, linear; finite; default 0, 0, 0, 1 */
    /* ---- end of 0.1; append below ---- */
} shd_tile_file_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_tile_file_desc shd_tile_file_desc_default(void)
{
    shd_tile_file_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.max_readers = 16;
    desc.fill[3] = 1.0f;
    return desc;
}

/** Files of a texture. */
typedef struct shd_tile_file_info {
    uint32_t struct_size; /**< set by shd_tile_file_info_default() */
    size_t column_count;  /**< files of a set side by side; 1 for a file */
    size_t row_count;     /**< files of a set one above the other; 1 for a file */
    size_t file_count;    /**< files that exist */
    /**
     * Texels of a tile of a file. Caches whose tiles are as large or larger read each tile of a file once. KTX2 and
     * DDS: 4 for blocks, 1 for pixels.
     */
    uint32_t tile_width;
    uint32_t tile_height; /**< texels of a tile of a file */
    /* ---- end of 0.1; append below ---- */
} shd_tile_file_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_tile_file_info shd_tile_file_info_default(void)
{
    shd_tile_file_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Open a tiled file, or a UDIM set, as a texture.
 *
 * Files that are not tiled, or lack mip levels although they are larger than a tile, give SHD_ERROR_UNSUPPORTED:
 * shd-maketx converts them. Files whose levels do not halve (rounded down), or differ in channels, give
 * SHD_ERROR_UNSUPPORTED or SHD_ERROR_CORRUPT. Tiles have at most 2^26 bytes. This does not apply to KTX2 and DDS files;
 * sets of them give SHD_ERROR_UNSUPPORTED.
 * @param path         a file, or a set by one `<UDIM>`; used literally otherwise; borrowed for the call
 * @param desc         borrowed for the call
 * @param out_texture  owned; NULL on failure
 * @param out_info     its struct_size is read; the rest is written, all zero on failure; may be NULL
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_open(shd_context *context, const char *path,
                                                  const shd_tile_file_desc *desc, shd_texture **out_texture,
                                                  shd_tile_file_info *out_info);

SHD_END_DECLS

#endif /* SHD_TILE_FILE_H */
