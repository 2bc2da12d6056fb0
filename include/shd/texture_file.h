/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief libshd_io: textures in KTX 2.0 and DDS files as they are stored, with all levels, faces and layers.
 *
 * shd_texture_load() (shd/io.h) reads them. Blocks stay compressed and pixels keep their numbers; docs/compressed.md
 * lists the formats. shd_bitmap_load() decodes one image to RGBA.
 *
 * Levels: with SHD_TABLE_MIPMAP in shd_load_desc.tables, the texture has the levels of the file, and its mipmap ends
 * with the last one. If the file has one level, shd builds the others; a texture of blocks then has no mipmap. Without
 * SHD_TABLE_MIPMAP the texture has the base level. SHD_LOAD_FILE_LEVELS has no effect.
 *
 * Kinds: 1D, 2D and 3D textures, arrays, and cube maps (SHD_PROJECTION_CUBE). shd_load_desc.subimage chooses one
 * cube map of an array of cube maps. 3D textures of blocks are SHD_ERROR_UNSUPPORTED.
 *
 * Colour: SHD_COLOR_ENCODING_AUTO takes what the file declares. DDS files without a DXGI_FORMAT declare nothing: BC1 to
 * BC3 and channels of 8 bits are then sRGB. SRGB takes the _SRGB format of the same storage; LINEAR and DATA take the
 * other one. A format without an _SRGB format is SHD_ERROR_UNSUPPORTED with SRGB, and if the file declares the sRGB
 * curve for it.
 *
 * Swizzles: KTXswizzle of KTX2, and the channels of luminance and alpha of DDS, become shd_texture_desc.swizzle and
 * `fill`. BGRA becomes RGBA.
 *
 * ASTC blocks (2D, LDR and HDR) become RGBA8, RGBA8_SRGB or RGBA16F by libastcenc. Blocks of reserved modes get the
 * error colour of ASTC: magenta, or NaN in HDR.
 *
 * DDS files that writers got wrong are read as they mean it: dwFourCC counts only with DDPF_FOURCC; the size of
 * DDS_PIXELFORMAT may be 24 or 0; of the second header, resourceDimension 0 is a 2D texture, and arraySize 0 is 1;
 * arraySize of cube maps may count faces, if the file has no more bytes; levels below 1 x 1 are left out.
 *
 * Files are untrusted. Without SHD_LOAD_IN_PROCESS they are parsed and decompressed in a child of shd-io-worker. shd's
 * own parser checks all offsets, counts and sizes before memory is allocated. max_pixels counts the texels of the base
 * level in all layers. max_ratio compares the bytes of the texture with those of the file. SHD_LOAD_FLIP_V reverses the
 * rows of pixels; with blocks it is SHD_ERROR_UNSUPPORTED. SHD_LOAD_PARTIAL: a DDS file of one image that is cut off
 * has the levels before the end; texels of the base behind the end are 0.
 *
 * SHD_ERROR_CORRUPT: a file that is cut off, or that contradicts itself. SHD_ERROR_UNSUPPORTED: Basis Universal
 * (BasisLZ and UASTC), other formats, and what this libshd_io was built without; the message has its name.
 * SHD_ERROR_LIMIT: a budget, or a size above those of shd_texture_desc.
 *
 * Sources: Khronos, "KTX File Format Specification 2.0" (2021); Khronos, "Data Format Specification 1.3" (2020);
 * Microsoft, "Programming Guide for DDS" and "DDS_HEADER structure".
 *
 * Thread safety: every function may be called from any thread.
 *
 * @code
 * shd_load_desc load = shd_load_desc_default();
 * shd_texture_file_info info = shd_texture_file_info_default();
 * load.info = &info;
 * result = shd_texture_load(context, "bricks.ktx2", &load, &texture);
 * @endcode
 */
#ifndef SHD_TEXTURE_FILE_H
#define SHD_TEXTURE_FILE_H

#include <shd/texture.h>

SHD_BEGIN_DECLS

/** File formats of textures. */
typedef enum shd_texture_file_kind {
    SHD_TEXTURE_FILE_KIND_NONE = 0,
    SHD_TEXTURE_FILE_KIND_KTX2 = 1,
    SHD_TEXTURE_FILE_KIND_DDS = 2,
    SHD_TEXTURE_FILE_KIND_MAX_ENUM = 0x7fffffff
} shd_texture_file_kind;

/** Compression of the levels of a KTX2 file, around its blocks or pixels. The values are those of the file format. */
typedef enum shd_supercompression {
    SHD_SUPERCOMPRESSION_NONE = 0,
    SHD_SUPERCOMPRESSION_BASIS_LZ = 1, /**< SHD_ERROR_UNSUPPORTED */
    SHD_SUPERCOMPRESSION_ZSTD = 2,     /**< Zstandard (RFC 8878); optional when libshd_io is built */
    SHD_SUPERCOMPRESSION_ZLIB = 3,     /**< zlib (RFC 1950); optional when libshd_io is built */
    SHD_SUPERCOMPRESSION_MAX_ENUM = 0x7fffffff
} shd_supercompression;

/** Properties of a texture file; combine with |. */
typedef enum shd_texture_file_flag {
    SHD_TEXTURE_FILE_NONE = 0,
    SHD_TEXTURE_FILE_PREMULTIPLIED = 1, /**< r, g, b are multiplied by alpha */
    SHD_TEXTURE_FILE_ARRAY = 2,         /**< declared as an array, even of one layer */
    /**
     * The first row is the bottom one (KTXorientation of KTX2). The texture has the rows in the order of the
     * file, so the picture is upside down, unless SHD_LOAD_FLIP_V reverses it.
     */
    SHD_TEXTURE_FILE_BOTTOM_UP = 4,
    SHD_TEXTURE_FILE_RIGHT_TO_LEFT = 8, /**< the first column is the right one (KTXorientation) */
    SHD_TEXTURE_FILE_FLAG_MAX_ENUM = 0x7fffffff
} shd_texture_file_flag;
typedef uint32_t shd_texture_file_flags; /**< shd_texture_file_flag bits */

/** Contents of a texture file. */
typedef struct shd_texture_file_info {
    uint32_t struct_size;       /**< set by shd_texture_file_info_default() */
    shd_texture_file_kind kind; /**< file format */
    uint32_t file_code; /**< storage in the file: VkFormat of KTX2; DXGI_FORMAT of DDS, 0 without such a number */
    shd_supercompression supercompression; /**< compression around the levels; NONE for DDS */
    shd_texture_file_flags flags;          /**< properties */
    shd_format format;                     /**< storage in the texture */
    uint32_t width;                        /**< texels of level 0 */
    uint32_t height;                       /**< texels of level 0; 1 for a 1D texture */
    uint32_t depth;                        /**< slices of level 0; 0 = not a 3D texture */
    size_t layer_count;                    /**< images of the array, or cube maps of an array of cube maps */
    size_t face_count;                     /**< 6 for cube maps, otherwise 1 */
    size_t level_count;                    /**< levels in the file */
    /* ---- end of 0.1; append below ---- */
} shd_texture_file_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_texture_file_info shd_texture_file_info_default(void)
{
    shd_texture_file_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/** Options of a KTX2 file that is written. */
typedef struct shd_ktx2_desc {
    uint32_t struct_size;                  /**< set by shd_ktx2_desc_default() */
    shd_supercompression supercompression; /**< NONE, ZSTD or ZLIB; default NONE */
    int32_t effort;                        /**< 1..19 for ZSTD, 1..9 for ZLIB; default 0 = that of the library */
    /**
     * 3 = write r, g and b of a texture of four channels. Textures that are made of three channels have four, and the
     * fourth is 0. Default 0 = all channels.
     */
    size_t channel_count;
    /* ---- end of 0.1; append below ---- */
} shd_ktx2_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_ktx2_desc shd_ktx2_desc_default(void)
{
    shd_ktx2_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/**
 * Write a texture to a KTX 2.0 file: all levels, layers, slices and faces, as stored. Blocks stay compressed. The
 * swizzle of the texture is not written.
 *
 * The file appears whole or not at all, as described for shd_framebuffer_save().
 * @param texture  any format; projections other than NONE and CUBE are SHD_ERROR_UNSUPPORTED
 * @param path     used literally; borrowed for the call
 * @param desc     borrowed for the call; NULL = all defaults
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_save_ktx2(const shd_texture *texture, const char *path,
                                                       const shd_ktx2_desc *desc);

SHD_END_DECLS

#endif /* SHD_TEXTURE_FILE_H */
