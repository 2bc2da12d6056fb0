/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Framebuffers: linear colour, depth and auxiliary planes of a frame.
 *
 * First calls: shd_framebuffer_create(), shd_framebuffer_read_color(), shd_framebuffer_view_plane() and
 * shd_framebuffer_release().
 *
 * Colour is scene-linear and premultiplied by alpha. Row 0 is the top row. With several samples a pixel, planes hold
 * one value for each pixel: the plain average of the samples for colour and targets, the value of the first sample for
 * the other planes.
 *
 * The default colour format, SHD_FORMAT_RGBA32F, is four planes of floats: for colour transforms, sums over frames and
 * exact comparisons. The other formats are interleaved pixels, for hosts that show or send a frame as it is: four or
 * eight bytes a pixel instead of 16. Frames are drawn, blended and averaged in linear floats in any format. The result
 * is rounded once, when a tile is finished, to the bits that shd_framebuffer_read_color() gives for four planes.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; concurrent reads; shd_render needs the framebuffer for
 *                itself (exclusive use of the object).
 *
 * @code
 * shd_framebuffer_desc desc = shd_framebuffer_desc_default();
 * shd_plane_view depth = shd_plane_view_default();
 * desc.width = 640, desc.height = 480, desc.sample_count = 4;
 * result = shd_framebuffer_create(context, &desc, &framebuffer);
 * // after shd_render():
 * result = shd_framebuffer_view_plane(framebuffer, SHD_PLANE_DEPTH, &depth);
 * @endcode
 */
#ifndef SHD_FRAMEBUFFER_H
#define SHD_FRAMEBUFFER_H

#include <shd/column.h>
#include <shd/context.h>
#include <shd/image.h>

SHD_BEGIN_DECLS

/** A set of planes with the same width and height. */
typedef struct shd_framebuffer shd_framebuffer;

/** Optional planes; combine with |. */
typedef enum shd_aov {
    SHD_AOV_NONE = 0,
    SHD_AOV_UV = 1,            /**< SHD_PLANE_U, _V */
    SHD_AOV_NORMAL = 2,        /**< SHD_PLANE_NX, _NY, _NZ: shading normal, world space */
    SHD_AOV_TRIANGLE = 4,      /**< SHD_PLANE_TRIANGLE */
    SHD_AOV_POSITION = 8,      /**< SHD_PLANE_PX, _PY, _PZ: world space */
    SHD_AOV_DERIVATIVES = 16,  /**< SHD_PLANE_DUDX, _DVDX, _DUDY, _DVDY: of uv, per pixel to the right and down */
    SHD_AOV_BARYCENTRICS = 32, /**< SHD_PLANE_B0, _B1, _B2: perspective-correct weights of the triangle's corners */
    SHD_AOV_LEVEL = 64,        /**< SHD_PLANE_LOD, _LEVEL: shd_texture_query_levels() of the diffuse texture */
    SHD_AOV_DRAW = 128,        /**< SHD_PLANE_DRAW */
    SHD_AOV_OVERDRAW = 256,    /**< SHD_PLANE_OVERDRAW */
    SHD_AOV_TARGET1 = 512,     /**< SHD_PLANE_TARGET1_R, _G, _B, _A: a colour target besides R, G, B, A */
    SHD_AOV_TARGET2 = 1024,    /**< SHD_PLANE_TARGET2_R, _G, _B, _A */
    SHD_AOV_TARGET3 = 2048,    /**< SHD_PLANE_TARGET3_R, _G, _B, _A */
    SHD_AOV_MAX_ENUM = 0x7fffffff
} shd_aov;
typedef uint32_t shd_aov_flags; /**< shd_aov bits */

/**
 * One plane of a framebuffer: width * height elements, row by row from the top.
 *
 * Planes after SHD_PLANE_DEPTH, except overdraw and targets, hold the values of the last opaque fragment visible at the
 * first sample of a pixel. Blended draws and draws of depth alone do not change them.
 *
 * Targets are additional colours of the same samples. Programs write them as shd_radiance.target; other materials write
 * 0 to all four channels. They start as 0. Each target is blended with the material's blend and its own a, except that
 * WEIGHTED and SORTED leave targets unchanged. The alpha test uses the alpha of the main colour target.
 */
typedef enum shd_plane {
    SHD_PLANE_R = 0, /**< R, G, B and A are in memory only with color_format SHD_FORMAT_RGBA32F */
    SHD_PLANE_G = 1,
    SHD_PLANE_B = 2,
    SHD_PLANE_A = 3,
    SHD_PLANE_DEPTH = 4, /**< D32F, 0 near .. 1 far */
    SHD_PLANE_U = 5,
    SHD_PLANE_V = 6,
    SHD_PLANE_NX = 7,
    SHD_PLANE_NY = 8,
    SHD_PLANE_NZ = 9,
    SHD_PLANE_TRIANGLE = 10, /**< uint32_t: triangle index in its mesh, 0xffffffff where nothing was drawn */
    SHD_PLANE_PX = 11,
    SHD_PLANE_PY = 12,
    SHD_PLANE_PZ = 13,
    SHD_PLANE_DUDX = 14,
    SHD_PLANE_DVDX = 15,
    SHD_PLANE_DUDY = 16,
    SHD_PLANE_DVDY = 17,
    SHD_PLANE_B0 = 18,
    SHD_PLANE_B1 = 19,
    SHD_PLANE_B2 = 20,
    SHD_PLANE_LOD = 21,      /**< continuous level of detail; 0 without texture */
    SHD_PLANE_LEVEL = 22,    /**< uint32_t: the mip level nearest to it */
    SHD_PLANE_DRAW = 23,     /**< uint32_t: index into shd_render_desc.draws, 0xffffffff where nothing was drawn */
    SHD_PLANE_OVERDRAW = 24, /**< uint32_t: number of times that the first sample was drawn, hidden later or not */
    SHD_PLANE_TARGET1_R = 25,
    SHD_PLANE_TARGET1_G = 26,
    SHD_PLANE_TARGET1_B = 27,
    SHD_PLANE_TARGET1_A = 28,
    SHD_PLANE_TARGET2_R = 29,
    SHD_PLANE_TARGET2_G = 30,
    SHD_PLANE_TARGET2_B = 31,
    SHD_PLANE_TARGET2_A = 32,
    SHD_PLANE_TARGET3_R = 33,
    SHD_PLANE_TARGET3_G = 34,
    SHD_PLANE_TARGET3_B = 35,
    SHD_PLANE_TARGET3_A = 36,
    SHD_PLANE_MAX_ENUM = 0x7fffffff
} shd_plane;

/** Size and planes of a framebuffer. Required: width, height. */
typedef struct shd_framebuffer_desc {
    uint32_t struct_size; /**< set by shd_framebuffer_desc_default() */
    uint32_t width;       /**< pixels, 1..16384 */
    uint32_t height;      /**< pixels, 1..16384 */
    /**
     * Storage of colour: SHD_FORMAT_RGBA32F, four planes; or interleaved SHD_FORMAT_RGBA16F, _RGBA8_SRGB or _RGBA8.
     * Default SHD_FORMAT_RGBA32F. Targets are planes in any case. shd_render with SHD_RENDER_LOAD reads colour as it
     * was rounded.
     */
    shd_format color_format;
    shd_aov_flags aovs;  /**< optional planes; default none */
    size_t sample_count; /**< per pixel: 1, 2, 4, 8 or 16, at shd_sample_position(); default 1 */
    /* ---- end of 0.1; append below ---- */
} shd_framebuffer_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_framebuffer_desc shd_framebuffer_desc_default(void)
{
    shd_framebuffer_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.sample_count = 1;
    desc.color_format = SHD_FORMAT_RGBA32F;
    return desc;
}

/**
 * Make a framebuffer: colour 0, depth 1, AOVs 0, triangle and draw 0xffffffff.
 * @param context          retained
 * @param desc             borrowed for the call
 * @param out_framebuffer  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_framebuffer_create(shd_context *context, const shd_framebuffer_desc *desc,
                                                        shd_framebuffer **out_framebuffer);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_framebuffer_retain(shd_framebuffer *framebuffer);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_framebuffer_release(shd_framebuffer *framebuffer);

/** Size and planes of a framebuffer. */
typedef struct shd_framebuffer_info {
    uint32_t struct_size;    /**< set by shd_framebuffer_info_default() */
    uint32_t width;          /**< pixels */
    uint32_t height;         /**< pixels */
    shd_format color_format; /**< storage of colour */
    shd_aov_flags aovs;      /**< optional planes */
    size_t sample_count;     /**< per pixel */
    size_t byte_size;        /**< bytes of all planes and pixels */
    /* ---- end of 0.1; append below ---- */
} shd_framebuffer_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_framebuffer_info shd_framebuffer_info_default(void)
{
    shd_framebuffer_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Get size and planes of a framebuffer.
 * @param out_info  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_framebuffer_get_info(const shd_framebuffer *framebuffer,
                                                          shd_framebuffer_info *out_info);

/**
 * Get the position of a sample in its pixel. Positions and order are the standard sample locations of the Vulkan 1.3
 * specification ("Multisampling"), which are those of Direct3D 11's standard pattern. They are multiples of 1/16 pixel.
 * @param sample_count  samples of a pixel: 1, 2, 4, 8 or 16
 * @param index         number of the sample, 0..sample_count - 1
 * @param out_x         pixels from the left edge of the pixel; 0 on failure
 * @param out_y         pixels from the top edge of the pixel; 0 on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_sample_position(size_t sample_count, size_t index, float *out_x, float *out_y);

/** A plane in place: no copy. */
typedef struct shd_plane_view {
    uint32_t struct_size; /**< set by shd_plane_view_default() */
    const float *f32;     /**< [height][row_stride / 4]; NULL for planes of uint32_t */
    const uint32_t *u32;  /**< [height][row_stride / 4]; NULL for planes of floats */
    size_t row_stride;    /**< bytes between rows */
    /* ---- end of 0.1; append below ---- */
} shd_plane_view;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_plane_view shd_plane_view_default(void)
{
    shd_plane_view view = SHD_ZERO_INIT;
    view.struct_size = (uint32_t)sizeof view;
    return view;
}

/**
 * Get a plane without copying.
 * @param out_view  its struct_size is read; the rest is written. Borrowed until release of the framebuffer; the next
 *                  shd_render changes its contents. All zero on failure; a plane that the framebuffer does not have is
 *                  SHD_ERROR_NOT_FOUND
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_framebuffer_view_plane(const shd_framebuffer *framebuffer, shd_plane plane,
                                                            shd_plane_view *out_view);

/**
 * Get interleaved colour without copying.
 * @param out_view  its struct_size is read; the rest is written: an image of the framebuffer's size and color_format.
 *                  Its pixels must not be written. They are borrowed until release of the framebuffer; the next
 *                  shd_render changes them. All zero on failure; SHD_ERROR_NOT_FOUND for color_format
 *                  SHD_FORMAT_RGBA32F, whose colour is planes
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_framebuffer_view_color(const shd_framebuffer *framebuffer, shd_image *out_view);

/**
 * Copy a float plane into a column. R, G, B and A are decoded to linear floats if colour is interleaved.
 * @param out  column of width * height elements, row by row from the top. A stride writes one channel of an interleaved
 *             image
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_framebuffer_read_plane(const shd_framebuffer *framebuffer, shd_plane plane,
                                                            const shd_f32_out *out);

/**
 * Copy a plane of uint32_t into a column.
 * @param out  column of width * height elements, row by row from the top
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_framebuffer_read_u32_plane(const shd_framebuffer *framebuffer, shd_plane plane,
                                                                const shd_u32_out *out);

/**
 * Copy colour as interleaved RGBA. Pixels of the framebuffer's own color_format are copied bit by bit.
 *
 * Colour stays linear, except that SHD_FORMAT_RGBA8_SRGB is encoded. Integer formats clamp to 0..1 (NaN to 0) and round
 * to nearest; sRGB codes are the correctly rounded ones of IEC 61966-2-1.
 * @param out  RGBA8, RGBA8_SRGB, RGBA16, RGBA16F or RGBA32F image of the framebuffer's size
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_framebuffer_read_color(const shd_framebuffer *framebuffer, const shd_image *out);

/** Conversion of linear colour for a display: a transform of libshd_color, or a function of the caller. Frozen. */
typedef struct shd_display {
    /**
     * Fills every pixel of `out`, a packed RGBA32F image of the framebuffer's size, with display colour: encoded,
     * straight alpha, 0..1. Runs on the thread of the call that takes the shd_display; must not throw or longjmp. A
     * result other than SHD_OK, with its text from shd_report_error(), becomes the result of the call. NULL = none.
     */
    shd_result (*apply)(const shd_framebuffer *framebuffer, const shd_image *out, void *user_data);
    void *user_data; /**< borrowed for the call */
} shd_display;

SHD_END_DECLS

#endif /* SHD_FRAMEBUFFER_H */
