/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief libshd_color: scene-linear colour to display pixels, and conversions between colour spaces.
 *
 * First calls: shd_color_create(), shd_color_render() for a frame in display pixels, shd_color_apply_display() for a
 * framebuffer, shd_color_convert() for an image, and shd_color_release().
 *
 * The library uses OpenColorIO 2.1 or later. All results of libshd are scene-linear. A shd_color holds one OpenColorIO
 * config, which names colour spaces, displays and views (transforms of scene light for a display). The built-in config
 * has:
 *
 * | colour space      | use                                                                    |
 * |-------------------|------------------------------------------------------------------------|
 * | Linear Rec.709    | linear light, Rec.709 primaries; the scene_linear role                 |
 * | ACEScg            | linear light, AP1 primaries                                            |
 * | ACES2065-1        | linear light, AP0 primaries; the reference space                       |
 * | sRGB - Texture    | sRGB-encoded (IEC 61966-2-1), mirrored for negative values             |
 * | Raw               | numbers that are not colour; never changed                             |
 *
 * | display | view                | use                                                            |
 * |---------|---------------------|----------------------------------------------------------------|
 * | sRGB    | ACES 1.0 SDR-video  | ACES 1.0 output transform, sRGB curve; the default             |
 * | sRGB    | Plain               | the display's encoding alone: piecewise sRGB curve             |
 * | sRGB    | Raw                 | the numbers as they are                                        |
 * | Rec.709 | the same three      | with the curve of BT.1886 (exponent 1/2.4, negative light to 0) |
 *
 * A config is trusted input: it names other files that OpenColorIO reads.
 *
 * Numbers:  NaN in colour is read as 0 and values are clamped to +-1e12 before a transform. The output
 *           is always finite: NaN becomes 0, and values are clamped to the range of the output format
 *           (0..1 for RGBA8, RGBA8_SRGB and RGBA16; +-65504 for RGBA16F; +-FLT_MAX for RGBA32F). Integer
 *           formats round to nearest. Output as RGBA8_SRGB has the same bytes as RGBA8: the display transform
 *           has already encoded them.
 * Bits:     outside shd's promise of the same bits everywhere, since OpenColorIO's own kernels run here. On
 *           one machine and build the output does not depend on the number of workers. A baked display
 *           (SHD_DISPLAY_PRECISION_BAKED) has the same bits on every SIMD target; only its tables come from
 *           OpenColorIO.
 * Memory:   OpenColorIO and the bake's working memory use malloc; tables of baked displays use the context's
 *           allocator: about 64 KiB for plain sRGB or ACES, plus 16 bytes for each entry of a 3D lookup table.
 * Globals:  while a config is read or a transform is built, OpenColorIO's process-wide logging level is NONE;
 *           it is restored afterwards. The environment variables OCIO_LOGGING_LEVEL and OCIO_OPTIMIZATION_FLAGS
 *           act as OpenColorIO documents. The locale of the host has no effect, except that a global locale of C++
 *           (std::locale::global) with a decimal comma is replaced for the same short time.
 *
 * Lifetime:      reference counted; create returns an owned reference; the context is retained.
 * Thread safety: retain/release from any thread; functions taking `const shd_color *` may run concurrently
 *                on one handle.
 *
 * @code
 * shd_color *color = NULL;
 * result = shd_color_create(context, NULL, &color);
 * result = shd_color_apply_display(color, framebuffer, "sRGB", "ACES 1.0 SDR-video", &image);
 * shd_color_release(color);
 * @endcode
 */
#ifndef SHD_COLOR_H
#define SHD_COLOR_H

#include <shd/framebuffer.h>
#include <shd/render.h>

SHD_BEGIN_DECLS

/** An OpenColorIO config and the transforms built from it so far. */
typedef struct shd_color shd_color;

/** Precision of displays for 8-bit images. Images of other formats are always exact. */
typedef enum shd_display_precision {
    /**
     * A view is baked once into tables, which SIMD kernels apply. Codes differ from the exact ones by at most 1 in
     * 99.9 % of the channels and by at most 3 in the others. The bake measures this on 65,536 colours, in gamut,
     * saturated and negative, of 2^-14 to 2^6. A view outside this bound is applied exactly, and a line of the
     * context's log (SHD_LOG_LEVEL_WARNING) reports it once.
     */
    SHD_DISPLAY_PRECISION_BAKED = 0,
    SHD_DISPLAY_PRECISION_EXACT = 1, /**< OpenColorIO's processor for each pixel */
    SHD_DISPLAY_PRECISION_MAX_ENUM = 0x7fffffff
} shd_display_precision;

/** Source of the config. Zero is the default of each field. Strings are borrowed for the call. */
typedef struct shd_color_desc {
    uint32_t struct_size;                    /**< set by shd_color_desc_default() */
    shd_display_precision display_precision; /**< precision of 8-bit images; default SHD_DISPLAY_PRECISION_BAKED */
    /**
     * Path of a config file, at most 64 MiB; NULL = the file named by the environment variable OCIO if it is set and
     * not empty, else the built-in config. The config and the tables that it names must be regular files.
     */
    const char *config_path;
    const char *config_text;   /**< a config in memory (YAML); then config_path must be NULL and OCIO is not read */
    const char *working_space; /**< colour space or role of framebuffers; NULL = the role scene_linear */
    /* ---- end of 0.1; append below ---- */
} shd_color_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_color_desc shd_color_desc_default(void)
{
    shd_color_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/** Text of the built-in config, as a starting point for other configs. Static. Any thread. @since 0.1 */
SHD_API const char *shd_color_default_config(void);

/**
 * Read a config.
 * @param context    retained; its executor runs the transforms
 * @param desc       borrowed for the call; NULL = all defaults
 * @param out_color  owned; NULL on failure
 * @return SHD_ERROR_NOT_FOUND for a missing file or working space, SHD_ERROR_CORRUPT for a malformed config
 *         or one whose colour spaces are defined cyclically, SHD_ERROR_UNSUPPORTED for one of a newer version,
 *         SHD_ERROR_LIMIT for a file above 64 MiB or colour spaces nested more than 64 deep
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_color_create(shd_context *context, const shd_color_desc *desc,
                                                  shd_color **out_color);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_color_retain(shd_color *color);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_color_release(shd_color *color);

/**
 * Transform a framebuffer for a display.
 *
 * The framebuffer is premultiplied by alpha. Its colour is divided by alpha, transformed, and written with
 * straight (not premultiplied) alpha, as in PNG. Alpha is clamped to 0..1 (NaN to 0) and never encoded; a pixel of
 * alpha 0 becomes 0, 0, 0, 0.
 *
 * The first call for a display and view builds the transform (about 10 ms), and the first one to an 8-bit image bakes
 * it (6 ms for plain sRGB, 25 ms for ACES); later calls find it in a cache.
 * @param color        concurrent reads
 * @param framebuffer  a framebuffer of the same context; colour in the working space; concurrent reads
 * @param display      name of a display; NULL = the config's default
 * @param view         name of one of its views; NULL = the display's default
 * @param out          RGBA8, RGBA8_SRGB, RGBA16, RGBA16F or RGBA32F image of the framebuffer's size
 * @return SHD_ERROR_NOT_FOUND for an unknown display or view; the error text lists the valid names. Pixels are
 *         untouched on failure, unless the executor or OpenColorIO fails half-way.
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_color_apply_display(const shd_color *color, const shd_framebuffer *framebuffer,
                                                         const char *display, const char *view, const shd_image *out);

/**
 * Render a frame and transform it for a display, tile by tile.
 *
 * The pixels are those of shd_render() with a framebuffer of color_format SHD_FORMAT_RGBA32F, followed by
 * shd_color_apply_display(). The worker that drew a tile transforms it as soon as it is finished, so that its colours
 * are still in the caches. The framebuffer holds the frame as after shd_render(). A framebuffer of color_format
 * SHD_FORMAT_RGBA8 saves memory traffic; its rounding has no effect on `out`, except for pixels that the frame leaves
 * unchanged (shd/present.h).
 * @param color    concurrent reads; its context renders
 * @param render   a frame with a framebuffer of the same context; colour in the working space; render->present must be
 *                 unset. All pixels of the framebuffer are written to `out`, also those outside the scissor
 * @param display  name of a display; NULL = the config's default
 * @param view     name of one of its views; NULL = the display's default
 * @param out      RGBA8, RGBA8_SRGB, RGBA16, RGBA16F or RGBA32F image of the framebuffer's size; must not overlap the
 *                 framebuffer
 * @return the failures of shd_render() and shd_color_apply_display(). If the frame fails half-way, framebuffer and
 *         pixels may hold a part of it; otherwise a failed call changes neither.
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_color_render(const shd_color *color, const shd_render_desc *render,
                                                  const char *display, const char *view, const shd_image *out);

/** A display and one of its views: user_data of a shd_display whose callback is shd_color_apply_view(). Frozen. */
typedef struct shd_color_view {
    const shd_color *color; /**< required; borrowed for the call that takes the shd_display */
    const char *display;    /**< NULL = the config's default */
    const char *view;       /**< NULL = the display's default */
} shd_color_view;

/**
 * Callback for shd_display.apply that calls shd_color_apply_display(), so that one call saves a display image:
 * `save.display.apply = shd_color_apply_view, save.display.user_data = &view`.
 * @param color_view  a shd_color_view
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_color_apply_view(const shd_framebuffer *framebuffer, const shd_image *out,
                                                      void *color_view);

/**
 * Transform an image for a display, as shd_color_apply_display() does with a framebuffer.
 * @param in          RGBA16F or RGBA32F image, premultiplied by alpha
 * @param from_space  colour space or role of `in`; NULL = the working space
 * @param display     name of a display; NULL = the config's default
 * @param view        name of one of its views; NULL = the display's default
 * @param out         image of the same size: either the memory of `in` with the same format and row stride, or memory
 *                    that does not overlap it (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_color_apply_display_image(const shd_color *color, const shd_image *in,
                                                               const char *from_space, const char *display,
                                                               const char *view, const shd_image *out);

/**
 * Convert an image from one colour space to another in place.
 *
 * For example, convert a texture from "ACEScg" to the working space before shd_texture_create(). Alpha is
 * unchanged and not multiplied in.
 * @param in_out      RGBA16F or RGBA32F image
 * @param from_space  colour space or role of the pixels; never NULL
 * @param to_space    colour space or role of the result; NULL = the working space
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_color_convert(const shd_color *color, const shd_image *in_out,
                                                   const char *from_space, const char *to_space);

/** Number of displays; 0 for a bad handle. @since 0.1 */
SHD_API size_t shd_color_get_display_count(const shd_color *color);

/** Name of a display; borrowed until release; NULL if there is none. Index 0 is not always the default. @since 0.1 */
SHD_API const char *shd_color_get_display_name(const shd_color *color, size_t index);

/** Name of the default display; borrowed until release; NULL for a bad handle. @since 0.1 */
SHD_API const char *shd_color_get_default_display(const shd_color *color);

/** Number of views of a display, NULL = the default one; 0 for an unknown display. @since 0.1 */
SHD_API size_t shd_color_get_view_count(const shd_color *color, const char *display);

/** Name of a view of a display, NULL = the default one; borrowed until release; NULL if there is none. @since 0.1 */
SHD_API const char *shd_color_get_view_name(const shd_color *color, const char *display, size_t index);

/** Default view of a display, NULL = the default one; borrowed until release; NULL if there is none. @since 0.1 */
SHD_API const char *shd_color_get_default_view(const shd_color *color, const char *display);

/** Number of colour spaces, including those of the displays. @since 0.1 */
SHD_API size_t shd_color_get_space_count(const shd_color *color);

/** Name of a colour space; borrowed until release; NULL if there is none. @since 0.1 */
SHD_API const char *shd_color_get_space_name(const shd_color *color, size_t index);

/** Name of the working space; borrowed until release; NULL for a bad handle. @since 0.1 */
SHD_API const char *shd_color_get_working_space(const shd_color *color);

SHD_END_DECLS

#endif /* SHD_COLOR_H */
