/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief libshd_io: image files to bitmaps and textures, framebuffers and images to files, by OpenImageIO.
 *
 * First calls: shd_texture_load(), shd_framebuffer_save(); shd_bitmap_load(), shd_bitmap_get_image() and
 * shd_image_save() for pixels without a texture.
 *
 * Files are untrusted:
 *  - The content decides the format, never the name. The format must be on an allow list.
 *  - Pixels, bytes, ratio and time have budgets, which are checked before memory is allocated. A progressive JPEG is
 *    decoded in one step, during which a load in process does not check the time; it may have 256 scans.
 *  - Metadata that a decoder would parse (EXIF, XMP, ICC, IPTC, text) is removed from PNG, JPEG, TIFF, WebP and TGA
 *    before decoding.
 *  - OpenImageIO and its codecs can crash on a hostile file, loop, or return leftover memory as pixels. A load
 *    therefore decodes outside this process, in a fresh child of the program shd-io-worker. A crash is
 *    SHD_ERROR_CORRUPT. The child is killed at the deadline, its memory is limited by the budgets, and its answer is
 *    checked. It holds nothing of this process except the file, and nothing of other files, so that a file gives the
 *    same pixels each time. SHD_LOAD_IN_PROCESS decodes trusted files in this process.
 *
 * The worker: the first load of a process starts it (about 0.3 s), later loads use it again, and each thread's load has
 * a child of its own. A worker that fails is replaced by the next load. It ends when this process ends, when libshd_io
 * is unloaded, and when a load names another worker_path; until then it keeps one descriptor of this process and uses
 * no processor time. If the host closes this descriptor between two loads, the next load starts another worker. It is
 * not a child of this process; only while it starts, this process has a child, and SIGCHLD is sent once. A forked child
 * of this process starts a worker of its own. The worker gets only the environment variables whose names begin with
 * LD_, and the options of sanitizers. Its working directory is /. It needs Linux. The environment variable
 * SHD_IO_WORKER, if set, is the default of shd_load_desc.worker_path; it must be an absolute path. Otherwise the worker
 * is found by the folder that libshd_io was loaded from, and a later change of the working directory has no effect. The
 * child has the rights of this process: it contains accidents of decoders, but is no sandbox for a file that takes over
 * its code.
 *
 * Paths: a load opens regular files only. A folder, a FIFO, a device or a socket is SHD_ERROR_IO, also behind a
 * symbolic link, and the load neither waits for it nor opens it.
 *
 * OpenImageIO in this process: a shared libshd_io opens it at the first save or load with SHD_LOAD_IN_PROCESS, by the
 * module libshd_io_oiio in the folder shd beside it. A host that only loads in the default setting never opens it; a
 * static libshd_io links it. Libraries under OpenImageIO start threads when they are loaded and keep them; on Debian
 * 12, exit() of a child that is forked afterwards does not return (_exit() does). OpenEXR keeps decoding threads after
 * its first file: in a child that is forked afterwards, saves of .exr and loads of it with SHD_LOAD_IN_PROCESS fail
 * with SHD_ERROR_UNSUPPORTED. libpng writes a line to stderr about damaged compressed data whose checksums are right,
 * and about any damage with SHD_LOAD_PARTIAL; a load by the worker is silent.
 *
 * A build without OpenImageIO (SHD_WITH_OIIO=OFF) reads PNG, JPEG, Radiance HDR, KTX2 and DDS, and writes PNG, Radiance
 * HDR and KTX2, with the same pixels. Other formats are SHD_ERROR_UNSUPPORTED. It starts no threads.
 *
 * Lifetime:      bitmaps are reference counted; load returns an owned reference.
 * Thread safety: every function may be called from any thread; concurrent reads of one bitmap.
 *
 * @code
 * shd_load_desc desc = shd_load_desc_default();
 * desc.max_pixels = 4096 * 4096;
 * result = shd_texture_load(context, "bricks.png", &desc, &texture);
 * result = shd_framebuffer_save(framebuffer, "frame.exr", NULL);
 * @endcode
 */
#ifndef SHD_IO_H
#define SHD_IO_H

#include <shd/framebuffer.h>
#include <shd/image.h>
#include <shd/texture.h>
#include <shd/texture_file.h>
#include <shd/view.h>
#include <shd/volume_file.h>

SHD_BEGIN_DECLS

/** File formats that a load may accept; combine with |. */
typedef enum shd_file_format {
    SHD_FILE_FORMAT_NONE = 0,
    SHD_FILE_FORMAT_PNG = 1 << 0,
    SHD_FILE_FORMAT_JPEG = 1 << 1,
    SHD_FILE_FORMAT_EXR = 1 << 2,
    SHD_FILE_FORMAT_TIFF = 1 << 3,
    SHD_FILE_FORMAT_HDR = 1 << 4, /**< Radiance RGBE */
    /**
     * Recognised by a plausible header, after all others: it has no signature; no palettes whose first index is not 0.
     */
    SHD_FILE_FORMAT_TGA = 1 << 5,
    SHD_FILE_FORMAT_BMP = 1 << 6, /**< uncompressed */
    SHD_FILE_FORMAT_DDS = 1 << 7, /**< blocks and pixels (shd/texture_file.h) */
    SHD_FILE_FORMAT_WEBP = 1 << 8,
    SHD_FILE_FORMAT_PNM = 1 << 9, /**< PBM, PGM, PPM and PFM */
    SHD_FILE_FORMAT_PSD = 1 << 10,
    SHD_FILE_FORMAT_DPX = 1 << 11,
    SHD_FILE_FORMAT_GIF = 1 << 12,
    SHD_FILE_FORMAT_KTX2 = 1 << 13, /**< blocks and pixels (shd/texture_file.h) */
    SHD_FILE_FORMAT_VDB = 1 << 14,  /**< grids of OpenVDB, textures alone (shd/volume_file.h) */
    /** PNG, JPEG, EXR, TIFF, HDR, TGA, BMP, DDS, WEBP, PNM, KTX2 and VDB; default of shd_load_desc.formats. */
    SHD_FILE_FORMAT_DEFAULT = 0x63ff,
    /** Also every other format of the OpenImageIO build. For trusted files. */
    SHD_FILE_FORMAT_ANY = 0x40000000,
    SHD_FILE_FORMAT_MAX_ENUM = 0x7fffffff
} shd_file_format;
typedef uint32_t shd_file_format_flags; /**< shd_file_format bits */

/** Encoding of the numbers of a file. */
typedef enum shd_color_encoding {
    SHD_COLOR_ENCODING_AUTO =
        0, /**< load: as declared by the file, see shd_bitmap_get_color_space(); save: by format */
    SHD_COLOR_ENCODING_SRGB = 1,   /**< r, g, b encoded with the sRGB curve (IEC 61966-2-1) */
    SHD_COLOR_ENCODING_LINEAR = 2, /**< light, Rec. 709 primaries */
    SHD_COLOR_ENCODING_DATA = 3,   /**< no colour: normals, roughness, masks */
    SHD_COLOR_ENCODING_MAX_ENUM = 0x7fffffff
} shd_color_encoding;

/** Options of a load; combine with |. */
typedef enum shd_load_flag {
    SHD_LOAD_NONE = 0,
    /**
     * Decode in this process, for files that are as trusted as this program. Needs no worker; saves its start, about 2
     * ms a file and one copy of the pixels. A hostile file can end or take over this process, and time_limit is checked
     * between bands of rows only.
     */
    SHD_LOAD_IN_PROCESS = 1,
    SHD_LOAD_PARTIAL = 2, /**< a damaged file loads: rows above the damage, zero below, and SHD_BITMAP_PARTIAL is set */
    SHD_LOAD_FLIP_V = 4,  /**< bottom row first */
    /**
     * Textures: take the mip levels of an image file, unchanged, instead of averages of its base. OpenEXR, and TIFF as
     * written by maketx (`.tx`), can have levels; KTX2 and DDS give theirs without the flag. If they end before 1 x 1,
     * the mipmap of the texture ends there, too. If the file has none, shd builds all of them. Level l must be max(1,
     * size >> l) wide and high: OpenEXR files of rounding mode ROUND_UP whose sizes differ are SHD_ERROR_UNSUPPORTED,
     * and so are levels of a file whose data window is not its display window. A damaged level is SHD_ERROR_CORRUPT;
     * with SHD_LOAD_PARTIAL it and all smaller levels count as absent. Needs SHD_TABLE_MIPMAP in `tables`. Bitmaps have
     * no levels.
     */
    SHD_LOAD_FILE_LEVELS = 8,
    /**
     * Bitmaps: colour becomes linear light by its colour space, as an image that is a light needs it. RGBA8_SRGB, whose
     * format has the curve, linear 8-bit, half and float pixels stay as they are; all others become RGBA32F, and
     * shd_bitmap_get_color_space() is "Linear Rec.709". Primaries are not converted. An unknown colour space is
     * SHD_ERROR_UNSUPPORTED. Textures are always linear.
     */
    SHD_LOAD_LINEAR = 16,
    /**
     * Textures of images with alpha: invisible texels give no fringes. r, g and b of the mip levels are averages
     * weighted by alpha (SHD_TEXEL_CONTENT_ALPHA_WEIGHTED). Texels of alpha 0, in all levels, take the mean colour of
     * their visible neighbours, or of the next coarser level if no neighbour is visible; so lookups between a visible
     * and an invisible texel have the colour of the visible one. For straight alpha. No effect on other textures, on
     * KTX2 and DDS, and with SHD_LOAD_FILE_LEVELS if the file has levels.
     */
    SHD_LOAD_ALPHA_WEIGHTED = 32,
    /**
     * Textures of images with alpha: r, g and b are multiplied by alpha, so that lookups and mip levels are averages
     * weighted by alpha, without fringes (Porter and Duff, "Compositing Digital Images", 1984). The texture is
     * SHD_TEXTURE_PREMULTIPLIED; 8-bit texels become RGBA16F. No effect on files that are premultiplied or opaque, and
     * on KTX2 and DDS. Not with SHD_LOAD_ALPHA_WEIGHTED.
     */
    SHD_LOAD_PREMULTIPLY = 64,
    SHD_LOAD_FLAG_MAX_ENUM = 0x7fffffff
} shd_load_flag;
typedef uint32_t shd_load_flags; /**< shd_load_flag bits */

/** Options and budgets of a load. A budget that would be exceeded is SHD_ERROR_LIMIT. */
typedef struct shd_load_desc {
    uint32_t struct_size;          /**< set by shd_load_desc_default() */
    shd_file_format_flags formats; /**< formats to accept; at least one; default SHD_FILE_FORMAT_DEFAULT */
    shd_load_flags flags;          /**< default none */
    shd_color_encoding encoding;   /**< default AUTO; other values override the file's declaration */
    shd_table_flags tables;        /**< tables of textures; default SHD_TABLE_MIPMAP */
    uint32_t subimage;             /**< part of a multi-part EXR, page of a TIFF, frame of a GIF; default 0 */
    uint64_t max_file_bytes;       /**< size of the file; at least 1; default 2^30 */
    /**
     * width * height, of the data and of the display window, and the pixels of all levels with
     * SHD_LOAD_FILE_LEVELS; at least 1; default 2^28.
     */
    uint64_t max_pixels;
    uint64_t max_bytes; /**< decoded, as RGBA, all levels; at least 1; default 2^32 */
    double max_ratio;   /**< decoded bytes per file byte, for more than 2^24 decoded; above 0; default 4000 */
    /**
     * [s], above 0; default 60; kills the child that decodes. With SHD_LOAD_IN_PROCESS it is checked between bands of
     * rows. A worker that is stopped (SIGSTOP, a debugger) costs a load all of its time; when it has been silent for
     * two seconds, the next load starts another one.
     */
    double time_limit;
    /**
     * Program that decodes, relative to the working directory at the call; NULL = shd-io-worker beside libshd_io or in
     * its installed place; borrowed for the call.
     */
    const char *worker_path;
    /** Textures: the file is voxels of this layout; borrowed for the call; default NULL. */
    const shd_raw_desc *raw;
    /**
     * Textures: slices of a 3D texture from the files of the desc, without a path; borrowed for the call; default NULL.
     */
    const shd_stack_desc *stack;
    /**
     * Textures: grid and box of an OpenVDB file; borrowed for the call; default NULL = the first grid of float or
     * double, if the content is OpenVDB.
     */
    const shd_vdb_desc *vdb;
    /**
     * Textures: gets the contents of a KTX2 or DDS file; all zero on failure and for other files, and its struct_size
     * is read; default NULL.
     */
    shd_texture_file_info *info;
    /**
     * Textures: gets the properties of an OpenVDB grid; all zero on failure and for other files, and its struct_size is
     * read; default NULL.
     */
    shd_vdb_info *vdb_info;
    /* ---- end of 0.1; append below ---- */
} shd_load_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_load_desc shd_load_desc_default(void)
{
    shd_load_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.formats = SHD_FILE_FORMAT_DEFAULT;
    desc.tables = SHD_TABLE_MIPMAP;
    desc.max_file_bytes = (uint64_t)1 << 30;
    desc.max_pixels = (uint64_t)1 << 28;
    desc.max_bytes = (uint64_t)1 << 32;
    desc.max_ratio = 4000.0;
    desc.time_limit = 60.0;
    return desc;
}

/** The pixels of a file, without conversion. */
typedef struct shd_bitmap shd_bitmap;

/**
 * Read an image file.
 *
 * The result has channels R, G, B, A: the channels with these names, or the first ones if no channel has such a name. A
 * single channel (with or without alpha) is grey, r = g = b. If there is no alpha, it is 1. 8-bit integers become
 * RGBA8_SRGB or RGBA8, 16-bit integers RGBA16, half floats RGBA16F, all others RGBA32F. No transfer curve is applied.
 * An EXR data window is placed into its display window: pixels outside the data window are zero, and parts outside the
 * display window are cropped. EXIF orientation is not applied. Deep images, subsampled channels and volumes are
 * SHD_ERROR_UNSUPPORTED.
 * @param context     retained
 * @param path        UTF-8 or any bytes the system accepts; a regular file; used literally (no UDIM, no format
 *                    directives); borrowed for the call
 * @param desc        borrowed for the call; NULL = all defaults
 * @param out_bitmap  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_bitmap_load(shd_context *context, const char *path, const shd_load_desc *desc,
                                                 shd_bitmap **out_bitmap);

/**
 * Read an image file that is in memory, as shd_bitmap_load() does.
 * @param bytes  [size]; borrowed for the call
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_bitmap_load_memory(shd_context *context, const void *bytes, size_t size,
                                                        const shd_load_desc *desc, shd_bitmap **out_bitmap);

/** Add a reference; NULL is ignored. @since 0.1 */
SHD_API void shd_bitmap_retain(shd_bitmap *bitmap);

/** Drop a reference; NULL is ignored. @since 0.1 */
SHD_API void shd_bitmap_release(shd_bitmap *bitmap);

/**
 * Get the pixels without copying.
 * @param out_image  its struct_size is read; the rest is written, all zero on failure. Borrowed until release of the
 *                   bitmap; read only
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_bitmap_get_image(const shd_bitmap *bitmap, shd_image *out_image);

/**
 * Colour space of the pixels: "sRGB", "Linear Rec.709", "ACEScg", "ACES2065-1", "Rec709", "Gamma2.2" (any
 * number), "data", or the name in the file (printable ASCII, at most 63 characters).
 *
 * A file without a declared colour space is sRGB if its channels are integers and Linear Rec.709 if they are floats;
 * PNM of integers is Rec709, as its specification requires.
 * @return borrowed until release of the bitmap; "" for a bad handle
 * @since 0.1
 */
SHD_API const char *shd_bitmap_get_color_space(const shd_bitmap *bitmap);

/** Properties of a loaded file; combine with |. */
typedef enum shd_bitmap_flag {
    SHD_BITMAP_NONE = 0,
    SHD_BITMAP_PARTIAL = 1,       /**< damaged, rows are missing (SHD_LOAD_PARTIAL) */
    SHD_BITMAP_PREMULTIPLIED = 2, /**< r, g, b are multiplied by alpha (EXR, some TIFF); otherwise straight */
    SHD_BITMAP_FLAG_MAX_ENUM = 0x7fffffff
} shd_bitmap_flag;
typedef uint32_t shd_bitmap_flags; /**< shd_bitmap_flag bits */

/** Format and properties of a loaded file. */
typedef struct shd_bitmap_info {
    uint32_t struct_size;        /**< set by shd_bitmap_info_default() */
    shd_file_format file_format; /**< SHD_FILE_FORMAT_ANY for a format without a bit of its own */
    shd_bitmap_flags flags;      /**< properties */
    size_t channel_count;        /**< in the file */
    /* ---- end of 0.1; append below ---- */
} shd_bitmap_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_bitmap_info shd_bitmap_info_default(void)
{
    shd_bitmap_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Get format and properties of a loaded file.
 * @param out_info  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_bitmap_get_info(const shd_bitmap *bitmap, shd_bitmap_info *out_info);

/**
 * Make a texture from a file. The content decides its kind:
 *
 *  - Images (2D). sRGB and linear 8-bit files become RGBA8_SRGB and RGBA8, linear half files RGBA16F and linear float
 *    files RGBA32F with the same numbers. All others (16-bit integers, other transfer curves) are linearised to
 *    RGBA32F. Primaries are not converted; callers who need this use shd_bitmap_load(). Premultiplied files
 *    (SHD_BITMAP_PREMULTIPLIED) give SHD_TEXTURE_PREMULTIPLIED textures. A colour space that
 * shd_bitmap_get_color_space()
 *    does not list is SHD_ERROR_UNSUPPORTED unless desc.color_space overrides it. The mip levels are those of
 *    shd_texture_create(): exact averages of the base in linear light. Levels in the file are ignored unless
 *    SHD_LOAD_FILE_LEVELS is set; then they are converted like the base.
 *  - KTX 2.0 and DDS (2D, 3D, arrays, cube maps), as they are stored, with all levels; see shd/texture_file.h.
 *  - OpenVDB (3D), and with desc.raw or desc.stack voxels and stacks of images; see shd/volume_file.h.
 *
 * Textures whose tiles stay in a file are opened by shd_texture_open().
 * @param path         as for shd_bitmap_load(); NULL with desc.stack
 * @param desc         borrowed for the call; NULL = all defaults
 * @param out_texture  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_load(shd_context *context, const char *path, const shd_load_desc *desc,
                                                  shd_texture **out_texture);

/**
 * Make a texture from a file that is in memory, as shd_texture_load() does. desc.stack is SHD_ERROR_INVALID_ARGUMENT.
 * @param bytes  [size], at any address; borrowed for the call
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_texture_load_memory(shd_context *context, const void *bytes, size_t size,
                                                         const shd_load_desc *desc, shd_texture **out_texture);

/** Rounding of colour to the codes of an integer format. */
typedef enum shd_dither {
    SHD_DITHER_NONE = 0, /**< to the nearest */
    /**
     * Up or down by a fixed pattern of the pixel's position, so that areas keep their mean and gradients show no bands.
     * Values that equal a code do not change. r, g and b of a pixel share a threshold; alpha is rounded to the nearest.
     */
    SHD_DITHER_ORDERED = 1,
    SHD_DITHER_MAX_ENUM = 0x7fffffff
} shd_dither;

/** A text in the header of an OpenEXR file. Frozen. */
typedef struct shd_file_attribute {
    const char *name; /**< 1..255 printable bytes; no attribute that every OpenEXR file has, such as "channels" */
    const char *text; /**< UTF-8 */
} shd_file_attribute;

/** A channel of floats of an OpenEXR file, besides the planes of a framebuffer. Frozen. */
typedef struct shd_file_channel {
    const char *name;  /**< 1..255 printable bytes, such as "matte.R"; no name of another channel or plane */
    shd_f32_in column; /**< width * height elements, row by row from the top */
} shd_file_channel;

/** Options of a save. */
typedef struct shd_save_desc {
    uint32_t struct_size; /**< set by shd_save_desc_default() */
    /**
     * A framebuffer's colour: PNG 8 or 16, JPEG 8, EXR 16 or 32, TIFF 8, 16 or 32; default 0 = 8 for PNG and JPEG, 16
     * for EXR, 32 for TIFF. For images always 0.
     */
    uint32_t bit_depth;
    /**
     * Framebuffers in 8 and 16 bits: AUTO and SRGB apply the sRGB curve, LINEAR and DATA do not. Images: the tag of PNG
     * and EXR; AUTO = by pixel format.
     */
    shd_color_encoding encoding;
    shd_dither dither; /**< a framebuffer's colour in 8 and 16 bits; default none */
    /**
     * Replaces the sRGB curve of a framebuffer in 8 and 16 bits; see shd_color_apply_view() in shd/color.h. Default
     * none.
     */
    shd_display display;
    /**
     * Framebuffers in OpenEXR: the view of the frame. The header gets worldToCamera and worldToNDC, as
     * ImfStandardAttributes.h of OpenEXR 3.1 defines them and RenderMan has them: camera space is left-handed, +Z in
     * front; (0, 0) of NDC is the upper left corner of the picture and (1, 1) the lower right one; a matrix acts on row
     * vectors. Z becomes the distance from the eye along the viewing direction [world units], also for orthographic
     * views; where nothing was drawn, the distance of the far plane. Borrowed for the call; default NULL.
     */
    const shd_view *view;
    /** Framebuffers in OpenEXR: [channel_count] further channels; borrowed for the call; default NULL. */
    const shd_file_channel *channels;
    size_t channel_count; /**< 0..1024 */
    /** OpenEXR: [attribute_count] texts of the header; other formats have none; borrowed for the call; default NULL. */
    const shd_file_attribute *attributes;
    size_t attribute_count; /**< 0..1024 */
    /**
     * OpenEXR: "none", "rle", "zips", "zip" (the default), "piz", "b44", "b44a", "dwaa" or "dwab". TIFF: "none", "lzw",
     * "zip" or "packbits". JPEG: a quality from "1" to "100"; the default is "95". Other formats: NULL. Borrowed for
     * the call; default NULL.
     */
    const char *compression;
    /* ---- end of 0.1; append below ---- */
} shd_save_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_save_desc shd_save_desc_default(void)
{
    shd_save_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/**
 * Write a framebuffer. The extension of `path` decides the format:
 *
 * `.exr`          R, G, B, A as half or float, linear, premultiplied, and every other plane under its usual
 *                 name: Z (0 near .. 1 far, or a distance with `view`), uv.u, uv.v, uv.dudx, uv.dvdx, uv.dudy, uv.dvdy,
 *                 N.x, N.y, N.z, P.x, P.y,
 *                 P.z, bary.0, bary.1, bary.2, lod (float), triangle, level, draw, overdraw (uint);
 * `.hdr`          r, g, b, linear, premultiplied (negative numbers become 0);
 * `.png`          straight alpha; colour clamped to 0..1, NaN to 0, sRGB-encoded, rounded to nearest;
 *                 `display` and `dither` replace the last two steps;
 * `.jpg` `.jpeg`  as PNG, over black, because JPEG has no alpha: the codes of PNG, times alpha;
 * `.tif` `.tiff`  8 and 16 bits as PNG, 32 bits float as EXR.
 *
 * The file appears whole or not at all: it is written to a temporary file beside it, flushed to the disk and renamed. A
 * failure does not change the previous file, and readers that have it open keep the old contents. A symbolic link is
 * followed; a path that names something other than a regular file is refused.
 * @param path  used literally; borrowed for the call
 * @param desc  borrowed for the call; NULL = all defaults
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_framebuffer_save(const shd_framebuffer *framebuffer, const char *path,
                                                      const shd_save_desc *desc);

/**
 * Write an image without conversion. Paths and files are handled as by shd_framebuffer_save().
 *
 * PNG accepts R8, RGBA8, RGBA8_SRGB and RGBA16; EXR accepts RGBA16F and RGBA32F; HDR accepts RGBA32F; TIFF accepts all
 * except RGBA16F; TGA and BMP accept R8, RGBA8 and RGBA8_SRGB. Alpha is tagged as straight, except in EXR.
 * @param image  borrowed for the call
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_image_save(const shd_image *image, const char *path, const shd_save_desc *desc);

SHD_END_DECLS

#endif /* SHD_IO_H */
