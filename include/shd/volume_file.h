/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief libshd_io: 3D textures from files of voxels, from stacks of images, and from OpenVDB grids.
 *
 * shd_texture_load() (shd/io.h) reads them: shd_load_desc.raw, .stack and .vdb have the descs of this header. The
 * slices of a file are those of the texture: x, the column of a texel, is the fastest index, then y, its row, then z,
 * its slice. Slice 0 lies at w = 0. The budgets of shd_load_desc count the voxels of the whole texture as pixels, and
 * are checked before memory is allocated. shd_load_desc.tables are the tables of the texture; volumes (shd/volume.h)
 * read the base level alone.
 *
 * Stacks and grids are decoded as the images of shd/io.h: in a child of shd-io-worker, unless SHD_LOAD_IN_PROCESS is
 * set. A file of voxels needs no decoder.
 *
 * Voxels (shd_raw_desc): the size of the file must be that of the header and all voxels. A shorter or longer file is
 * SHD_ERROR_CORRUPT, with a message that has both sizes. NaN and infinite numbers stay as they are. SHD_LOAD_FLIP_V
 * reverses the rows of each slice; other flags except SHD_LOAD_IN_PROCESS are errors.
 *
 * Stacks (shd_stack_desc): images of one size and format. Each of several files gives a slice, its part
 * shd_load_desc.subimage. A single file gives all its parts from `subimage` on: the pages of a TIFF (at most 1024), the
 * parts of a multi-part EXR, the frames of a GIF. A file with one channel becomes R8, R16, R16F or R32F; all others
 * become RGBA8, RGBA16, RGBA16F or RGBA32F, as the pixels of shd_bitmap_load(). shd_load_desc.encoding AUTO and
 * LINEAR keep the numbers, because most stacks hold densities; the file's declaration has no effect. With SRGB, 8-bit
 * files become R8_SRGB or RGBA8_SRGB, and all others are SHD_ERROR_UNSUPPORTED. A slice whose size or format differs
 * from slice 0 is SHD_ERROR_CORRUPT, and the message has its number. max_file_bytes, max_ratio and time_limit are
 * budgets of each file; max_pixels and max_bytes are budgets of the texture. SHD_LOAD_FILE_LEVELS is an error.
 *
 * OpenVDB (shd_vdb_desc, optional when libshd_io is built): a grid becomes a texture of format R32F. The voxels of a
 * box become the texels, a voxel each; tiles and the background are filled in. Texel (i, j, k) is the voxel
 * index_min + (i, j, k), and its centre lies at that place of index space. Doubles are rounded to floats.
 * SHD_ERROR_UNSUPPORTED: a libshd_io without OpenVDB; versions of the file format below 222; files written as a
 * stream, without offsets of grids; a grid of another type than float or double; a transform that is not affine; a
 * grid without active voxels, unless SHD_VDB_BOX is set. SHD_ERROR_NOT_FOUND: no grid of the name. SHD_ERROR_LIMIT: a
 * box above max_pixels or max_bytes, or a side above 65536. A file that is cut off is SHD_ERROR_CORRUPT. Flags except
 * SHD_LOAD_IN_PROCESS are errors. A shared libshd_io opens OpenVDB at the first load with SHD_LOAD_IN_PROCESS, by the
 * module libshd_io_vdb in the folder shd beside it.
 *
 * Thread safety: any thread.
 *
 * @code
 * shd_raw_desc raw = shd_raw_desc_default();
 * shd_load_desc load = shd_load_desc_default();
 * raw.width = 256, raw.height = 256, raw.depth = 113;
 * raw.sample = SHD_RAW_SAMPLE_U16, raw.byte_order = SHD_BYTE_ORDER_BIG;
 * load.raw = &raw;
 * result = shd_texture_load(context, "head.raw", &load, &texture);
 * @endcode
 */
#ifndef SHD_VOLUME_FILE_H
#define SHD_VOLUME_FILE_H

#include <shd/image.h>

SHD_BEGIN_DECLS

/** Numbers of a file of voxels. */
typedef enum shd_raw_sample {
    SHD_RAW_SAMPLE_U8 = 0,  /**< the format R8, RG8, RGB8 or RGBA8 */
    SHD_RAW_SAMPLE_U16 = 1, /**< the format R16, RG16, RGB16 or RGBA16 */
    SHD_RAW_SAMPLE_F16 = 2, /**< IEEE 754 binary16; the format R16F, RG16F, RGB16F or RGBA16F */
    SHD_RAW_SAMPLE_F32 = 3, /**< IEEE 754 binary32; the format R32F, RG32F, RGB32F or RGBA32F */
    SHD_RAW_SAMPLE_I8 = 4,  /**< as F32: the numbers -128..127 themselves */
    SHD_RAW_SAMPLE_I16 = 5, /**< as F32: the numbers themselves, such as Hounsfield units */
    SHD_RAW_SAMPLE_U32 = 6, /**< as F32: the numbers themselves, rounded to the nearest binary32 */
    SHD_RAW_SAMPLE_I32 = 7, /**< as F32: the numbers themselves, rounded to the nearest binary32 */
    SHD_RAW_SAMPLE_MAX_ENUM = 0x7fffffff
} shd_raw_sample;

/** Order of the bytes of a number. */
typedef enum shd_byte_order {
    SHD_BYTE_ORDER_LITTLE = 0, /**< lowest byte first */
    SHD_BYTE_ORDER_BIG = 1,    /**< highest byte first */
    SHD_BYTE_ORDER_MAX_ENUM = 0x7fffffff
} shd_byte_order;

/** Value of shd_raw_desc.header_bytes: the voxels are the last bytes of the file. */
#define SHD_RAW_HEADER_REST 0xffffffffffffffffull

/** Layout of a file of voxels. Required: width, height, depth. */
typedef struct shd_raw_desc {
    uint32_t struct_size;      /**< set by shd_raw_desc_default() */
    uint32_t width;            /**< voxels along x, 1..65536; width * height * depth at most 2^28 */
    uint32_t height;           /**< voxels along y, 1..65536 */
    uint32_t depth;            /**< voxels along z, 1..65536 */
    shd_raw_sample sample;     /**< default SHD_RAW_SAMPLE_U8 */
    size_t channel_count;      /**< numbers of a voxel, one behind the other, 1..4; default 1 */
    shd_byte_order byte_order; /**< default SHD_BYTE_ORDER_LITTLE */
    uint64_t header_bytes;     /**< bytes before the first voxel, or SHD_RAW_HEADER_REST; default 0 */
    /* ---- end of 0.1; append below ---- */
} shd_raw_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_raw_desc shd_raw_desc_default(void)
{
    shd_raw_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.channel_count = 1;
    return desc;
}

/** Files of a stack. Required: either paths and path_count, or pattern. */
typedef struct shd_stack_desc {
    uint32_t struct_size;     /**< set by shd_stack_desc_default() */
    size_t path_count;        /**< number of `paths`, 0..65536 */
    const char *const *paths; /**< [path_count] files, slice 0 first; of a single file all pages are slices */
    /**
     * A path with one place for a number, instead of `paths`: %d, %5d (padded by spaces to five characters) or %05d
     * (by zeros); %% is a percent sign. Slice k is the file of the number first + k.
     */
    const char *pattern;
    uint32_t first; /**< number of slice 0 of `pattern`; default 0 */
    uint32_t last;  /**< number of the last slice, first..first + 65535; default 0 */
    /* ---- end of 0.1; append below ---- */
} shd_stack_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_stack_desc shd_stack_desc_default(void)
{
    shd_stack_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/** Options of an OpenVDB load; combine with |. */
typedef enum shd_vdb_flag {
    SHD_VDB_NONE = 0,
    SHD_VDB_BOX = 1, /**< sample the box of the desc instead of the bounds of the active voxels */
    SHD_VDB_FLAG_MAX_ENUM = 0x7fffffff
} shd_vdb_flag;
typedef uint32_t shd_vdb_flags; /**< shd_vdb_flag bits */

/** Grid and box of an OpenVDB load. */
typedef struct shd_vdb_desc {
    uint32_t struct_size;  /**< set by shd_vdb_desc_default() */
    shd_vdb_flags flags;   /**< default none */
    const char *grid;      /**< name, at most 255 bytes; default NULL = the first grid of float or double */
    int32_t bounds_min[3]; /**< first voxel of the box, in index space, -2^30..2^30; read with SHD_VDB_BOX */
    int32_t bounds_max[3]; /**< last voxel of the box, at least bounds_min on each axis; read with SHD_VDB_BOX */
    /* ---- end of 0.1; append below ---- */
} shd_vdb_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_vdb_desc shd_vdb_desc_default(void)
{
    shd_vdb_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/** Meaning of the numbers of a grid. */
typedef enum shd_vdb_class {
    SHD_VDB_CLASS_UNKNOWN = 0,
    SHD_VDB_CLASS_LEVEL_SET = 1,  /**< signed distances to a surface [world units], negative inside */
    SHD_VDB_CLASS_FOG_VOLUME = 2, /**< densities, 0 outside */
    SHD_VDB_CLASS_MAX_ENUM = 0x7fffffff
} shd_vdb_class;

/** Properties of a loaded grid. */
typedef struct shd_vdb_info {
    uint32_t struct_size;        /**< set by shd_vdb_info_default() */
    shd_vdb_class grid_class;    /**< as declared by the file */
    int32_t index_min[3];        /**< voxel of texel (0, 0, 0), in index space */
    float background;            /**< value of all voxels that the file does not store */
    uint64_t active_voxel_count; /**< in the whole grid */
    /**
     * From texture coordinates (u, v, w) to the world of the file, column-major: for shd_volume_draw, if the box of the
     * volume is the default box.
     */
    float object_to_world[16];
    char grid[64]; /**< name of the grid; its first 63 bytes, control characters replaced */
    /* ---- end of 0.1; append below ---- */
} shd_vdb_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_vdb_info shd_vdb_info_default(void)
{
    shd_vdb_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

SHD_END_DECLS

#endif /* SHD_VOLUME_FILE_H */
