/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Whole frames: one call takes everything that a frame needs.
 *
 * Triangles cover the samples that they contain, with 8 subpixel bits and the top-left rule: the centre of a pixel, or
 * 2, 4, 8 or 16 samples at the standard sample locations of the Vulkan 1.3 specification ("Multisampling") and of
 * Direct3D 11, in their order; shd_sample_position() returns them. Before that, raster positions, computed in binary32,
 * are rounded to the nearest multiple of 1/256 pixel. Ties go to the even multiple. Vertices that clipping makes or
 * moves are an exception: their ties go to the larger multiple. The top left corner of the picture is (0, 0), y grows
 * downwards.
 *
 * The depth of a vertex is z / w, rounded to binary32. The depth z of a sample at (x, y) is linear in x and y between
 * the depths of the rounded vertices. It is computed in binary32 from the first vertex (x0, y0, z0), with an error of
 * at most 2^-22 (z0 + |dz/dx| (|x - x0| + 1) + |dz/dy| (|y - y0| + 1)), and clamped to the range of the vertices.
 *
 * Attributes are perspective-correct with analytic derivatives. Draws take effect in their order, with two exceptions:
 * order-independent blends come last, and the painter's algorithm orders triangles from far to near. The frame has the
 * same bits for any executor, worker count and SIMD target.
 *
 * Thread safety: exclusive use of the framebuffer; meshes, materials, lights and textures may be shared
 *                between concurrent renders.
 *
 * @code
 * const shd_light *const lights[2] = {sun, lamp};
 * const shd_camera camera = shd_camera_default();
 * shd_render_desc desc = shd_render_desc_default();
 * shd_draw draw = shd_draw_default();
 * draw.mesh = mesh, draw.material = material;
 * desc.framebuffer = framebuffer;
 * desc.camera = &camera;
 * desc.draws = &draw, desc.draw_count = 1;
 * desc.lights = lights, desc.light_count = 2;
 * result = shd_render(context, &desc);
 * @endcode
 */
#ifndef SHD_RENDER_H
#define SHD_RENDER_H

#include <shd/draw.h>
#include <shd/environment.h>
#include <shd/framebuffer.h>
#include <shd/light.h>
#include <shd/present.h>
#include <shd/shadow.h>
#include <shd/view.h>
#include <shd/volume.h>

SHD_BEGIN_DECLS

/** Options of a frame; combine with |. */
typedef enum shd_render_flag {
    SHD_RENDER_NONE = 0,
    SHD_RENDER_COUNT_HIDDEN = 1, /**< fill shd_render_stats.hidden_sample_count: coverage is computed at least twice */
    /** Keep the planes instead of clearing them: each sample starts with the values of its pixel. */
    SHD_RENDER_LOAD = 2,
    SHD_RENDER_FLAG_MAX_ENUM = 0x7fffffff
} shd_render_flag;
typedef uint32_t shd_render_flags; /**< shd_render_flag bits */

/**
 * Method that decides which triangle is visible at a sample.
 *
 * PAINTER and NEWELL order the triangles of all draws and paint each over the previous ones. Depths are not compared,
 * as with SHD_COMPARE_ALWAYS; the final depth is that of the triangle painted last. Depth decreases with the distance
 * in draws that compare GREATER or GREATER_EQUAL and increases in all others; biases apply. shd_draw_flag works as
 * usual. Opaque draws are shaded after all of them are painted. PREMULTIPLIED, STRAIGHT, ADD and MULTIPLY take effect
 * in the order of painting. WEIGHTED and SORTED come last and test the painted depths. A draw without a material writes
 * its depth and hides nothing.
 */
typedef enum shd_visibility {
    SHD_VISIBILITY_DEPTH = 0, /**< the depth of the sample, by the draw's comparison (Catmull 1974) */
    /**
     * The painter's algorithm: triangles by their farthest vertex, far ones first, equal ones in the order of draws and
     * triangles. The picture is wrong where two triangles overlap and the one painted first is nearer in the overlap;
     * shd_render_stats.order_conflict_count counts these pairs. O(n log n).
     */
    SHD_VISIBILITY_PAINTER = 1,
    /**
     * The painter's algorithm with the tests, reordering and cuts of Newell, Newell and Sancha, "A Solution to the
     * Hidden Surface Problem" (1972). Correct, except where depths differ by less than the effect of a shift by 1/256
     * pixel, or by less than 2^-23.
     *
     * Triangles that overlap cyclically or pass through each other are cut along the plane of one of them. New vertices
     * lie on the grid of 1/256 pixel. A sample within 1/256 pixel of a cut, or of an edge that was cut, may lie on
     * either side, and windows of a picture may differ there. Pieces keep the attributes and ids of their triangle.
     * A triangle is not cut if a piece would have no area on the grid.
     *
     * For n triangles there are at most n + 1024 cuts and 1024 n + 2^22 comparisons; order_conflicts counts the
     * remaining errors. Runs on one thread and takes up to 1000 bytes a triangle.
     */
    SHD_VISIBILITY_NEWELL = 2,
    SHD_VISIBILITY_MAX_ENUM = 0x7fffffff
} shd_visibility;

/** Colour of the samples that no draw covers. */
typedef enum shd_background {
    SHD_BACKGROUND_CLEAR = 0, /**< clear_color */
    /**
     * Radiance of the environment along the line of sight through the centre of the pixel, averaged over the pixel;
     * a = 1. No effect with SHD_RENDER_LOAD.
     */
    SHD_BACKGROUND_ENVIRONMENT = 1,
    SHD_BACKGROUND_MAX_ENUM = 0x7fffffff
} shd_background;

/** Statistics of a frame: the counts from nonfinite to rasterised add up to `triangles`. */
typedef struct shd_render_stats {
    uint32_t struct_size;              /**< set by shd_render_stats_default() */
    uint64_t triangle_count;           /**< in all draws */
    uint64_t nonfinite_triangle_count; /**< dropped: a vertex is NaN or infinite after transformation */
    uint64_t outside_triangle_count;   /**< dropped: outside the view volume */
    /**
     * Dropped: facing the culled way, without area on the pixel grid, or (SHD_FILL_LINES) without a visible edge that
     * belongs to the triangle.
     */
    uint64_t culled_triangle_count;
    uint64_t empty_triangle_count;      /**< dropped: between pixel centres */
    uint64_t rasterized_triangle_count; /**< drawn, hidden or not */
    uint64_t clipped_triangle_count;    /**< cut by a clip plane, among outside, culled, empty and rasterised */
    /**
     * Shaded; opaque draws count a pixel once for every triangle that is visible in it, in each pass
     * (shd_render_desc.pass_triangles).
     */
    uint64_t fragment_count;
    uint64_t nonfinite_fragment_count; /**< fragments whose r, g, b or a was NaN or infinite (kept as written) */
    /**
     * Covered, but failed the depth test before shading; 0 without SHD_RENDER_COUNT_HIDDEN. Draws that blend or drop
     * fragments may be tested against stale depth, so their count is approximate.
     */
    uint64_t hidden_sample_count;
    /**
     * PAINTER and NEWELL: pairs of triangles or pieces that overlap on the screen where the one painted first is nearer
     * somewhere in the overlap, by more than the tolerance of NEWELL. A lower bound where triangles are dense: pairs
     * are searched in the cells of a grid, and in a cell of n triangles up to 64 n + 1024 pairs are compared.
     */
    uint64_t order_conflict_count;
    uint64_t split_count; /**< cuts of NEWELL */
    /**
     * Draws that cannot have a colour: without a material, or with one that reflects light in a frame without lights
     * and environment. The log has the reasons.
     */
    uint64_t black_draw_count;
    /** Peak of working memory, with what the context keeps from earlier calls; depends on the number of workers. */
    uint64_t scratch_bytes;
    double vertex_seconds;   /**< wall-clock time of transforming vertices */
    double assembly_seconds; /**< wall-clock time of finding visible triangles and clipping them */
    double binning_seconds;  /**< wall-clock time of sorting triangles by distance (if at all) and into tiles */
    double tile_seconds;     /**< wall-clock time of coverage, shading and blending */
    /* ---- end of 0.1; append below ---- */
} shd_render_stats;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_render_stats shd_render_stats_default(void)
{
    shd_render_stats stats = SHD_ZERO_INIT;
    stats.struct_size = (uint32_t)sizeof stats;
    return stats;
}

/** Host progress callback. Frozen. */
typedef struct shd_progress {
    /**
     * Called after each piece of the frame, with the finished fraction of the frame, (0, 1]. Runs on any worker; calls
     * are never concurrent. Must not throw, longjmp or call shd. A result other than SHD_OK, such as
     * SHD_ERROR_CANCELLED, ends the frame and becomes the result of the render; the framebuffer holds a part of the
     * frame.
     */
    shd_result (*report)(float fraction, void *user_data);
    void *user_data; /**< borrowed for the call */
} shd_progress;

/**
 * A whole frame, or a window of it. All pointers are borrowed for the call. Required: framebuffer.
 *
 * Draws are projected to the picture. The framebuffer holds the window of the picture that begins at pixel (crop_x,
 * crop_y). Its pixels have the same bits as in the whole picture.
 */
typedef struct shd_render_desc {
    uint32_t struct_size;         /**< set by shd_render_desc_default() */
    shd_framebuffer *framebuffer; /**< required */
    /**
     * Replaces `view`. An aspect of 0, the default, means the aspect of the viewport, or of the picture if there is no
     * viewport. NULL = `view`.
     */
    const shd_camera *camera;
    shd_view view; /**< default: identity matrices, eye at 0 */
    /** [draw_count], all with the same struct_size, in order; NULL if draw_count is 0. */
    const shd_draw *draws;
    size_t draw_count;              /**< up to 2^20 */
    const shd_light *const *lights; /**< [light_count]; NULL if light_count is 0 */
    /**
     * [light_count], each NULL or a shadow of shd/shadow.h that was rendered for a light of the same kind. The light
     * that reaches a fragment is multiplied by the visibility at its position, with its shading normal. NULL = none.
     */
    const shd_shadow *const *shadows;
    size_t light_count; /**< up to 2^20 */
    /**
     * Light from all directions, in addition to the lights; NULL = none. Every model with lights reflects it, except
     * GOOCH. It casts no shadows; SHD_SLOT_OCCLUSION multiplies all of its reflected light. It must
     * have been created with the tables of the models of the draws (shd_environment_desc.tables).
     */
    const shd_environment *environment;
    float environment_intensity; /**< factor of its radiance, 0..1e12; default 1 */
    /**
     * Rotation or reflection of its directions, column-major, with orthonormal columns within 1e-3; default identity.
     */
    float environment_to_world[9];
    shd_background background; /**< default SHD_BACKGROUND_CLEAR */
    /**
     * Roughness of the GGX lobe that blurs the environment behind the picture, 0..1; values above 0 need
     * SHD_ENVIRONMENT_TABLE_GGX; default 0 = sharp.
     */
    float background_roughness;
    float clear_color[4]; /**< linear, premultiplied RGBA; default 0 */
    float clear_depth;    /**< 0..1; default 1 */
    /**
     * [volume_count], all with the same struct_size. They are blended over the finished draws in this order, so the
     * caller sorts volumes from far to near. A ray of a pixel ends at the depth of a sample, with one march for all
     * samples of equal depth. Depth decreases with the distance if clear_depth is below 1/2, and increases otherwise.
     * Depth and planes other than colour keep their values. NULL if volume_count is 0.
     */
    const shd_volume_draw *volumes;
    size_t volume_count;       /**< up to 1024; default 0 */
    shd_visibility visibility; /**< default SHD_VISIBILITY_DEPTH */
    shd_render_flags flags;    /**< default none */
    uint32_t picture_width;    /**< pixels, framebuffer size..65536; default 0 = framebuffer size */
    uint32_t picture_height;   /**< pixels, framebuffer size..65536; default 0 = framebuffer size */
    /** Column of the picture at which the framebuffer begins; the framebuffer lies inside the picture; default 0. */
    uint32_t crop_x;
    uint32_t crop_y; /**< row of the picture at which the framebuffer begins; default 0 */
    /**
     * Target of NDC -1..1 in the picture, not empty; cuts triangles, lines and points at its edge; NULL = the whole
     * picture.
     */
    const shd_region *viewport;
    const shd_region *scissor; /**< pixels of the picture that may change; NULL = all */
    /**
     * n, 1..16; default 1 = off. The frame is drawn as a picture n times as large, up to 65536 pixels a side, with the
     * framebuffer's number of samples in each pixel; crop, viewport and scissor are scaled by n. Colour and targets of
     * a pixel are the plain average of its n x n pixels; depth and the other planes have the values of the top left
     * one. Derivatives (and so footprints of textures) and raster positions in programs refer to the large picture;
     * lines and points are n times as wide in it. With SHD_RENDER_LOAD each of the n x n pixels starts with the pixel's
     * values. The large picture is drawn in blocks of up to 1024 x 1024 pixels; only one block is in memory. Statistics
     * are sums over blocks, so a triangle counts in each block.
     */
    uint32_t supersampling;
    /**
     * Largest number of triangles that are processed together, 1024..2^31-1; default 2^21. A larger frame is drawn in
     * passes. A pass has several whole draws, each of which counts as at least 16 triangles, or a part of one draw. The
     * framebuffer has the same bits for any number. Draws of SHD_BLEND_WEIGHTED and SHD_BLEND_SORTED form the last pass
     * together. Only with SHD_VISIBILITY_DEPTH: the other methods order all triangles together.
     *
     * Working memory is at most 512 bytes for each of these triangles, 256 for each draw or instance, 24 for each
     * sample of the framebuffer and 16 more for each of its targets, and 8 MiB for each worker. Additional memory: 4
     * bytes for each tile of 64 x 64 pixels that a triangle touches beyond dozens, 48 for each piece of a clipped
     * triangle, 4 for each varying of up to three vertices a triangle, and the triangles of the last pass. A frame in
     * several passes or with supersampling takes 16 bytes for each pixel of a framebuffer with interleaved colour.
     */
    uint32_t pass_triangles;
    /**
     * Statistics; its struct_size is read; NULL = not wanted. All zero on failure, except where the struct_size or the
     * unknown end of this desc is refused.
     */
    shd_render_stats *stats;
    shd_progress progress; /**< default none */
    shd_present present;   /**< receives the finished tiles; default none */
    /* ---- end of 0.1; append below ---- */
} shd_render_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_render_desc shd_render_desc_default(void)
{
    shd_render_desc desc = SHD_ZERO_INIT;
    int i;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.clear_depth = 1.0f;
    for (i = 0; i < 16; i += 5) desc.view.world_to_view[i] = desc.view.view_to_clip[i] = 1.0f;
    desc.supersampling = 1;
    desc.pass_triangles = (uint32_t)1 << 21;
    desc.environment_intensity = 1.0f;
    for (i = 0; i < 9; i += 4) desc.environment_to_world[i] = 1.0f;
    return desc;
}

/**
 * Render a frame.
 *
 * On SHD_ERROR_OUT_OF_MEMORY, SHD_ERROR_CALLBACK or SHD_ERROR_CANCELLED the framebuffer may hold a part of
 * the frame; all other objects are unchanged, and the next render works.
 *
 * The log of the context gets reasons for black draws, one line a frame with SHD_LOG_LEVEL_INFO for each: they have no
 * material, or their materials reflect light in a frame without lights and environment
 * (shd_render_stats.black_draw_count).
 * @param context  its executor, allocator and SIMD target do the work; the objects may come from any context
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_render(shd_context *context, const shd_render_desc *desc);

SHD_END_DECLS

#endif /* SHD_RENDER_H */
