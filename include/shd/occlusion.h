/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Ambient occlusion: the part of the sky that is open above each point of a surface, at vertices or in a
 *        texture.
 *
 * The value o of a point is the cosine-weighted part of the directions above its surface along which no occluder lies
 * within a radius: 1 = open, 0 = enclosed (Landis, "Production-Ready Global Illumination", SIGGRAPH 2002 course 16,
 * with the radius of Zhukov, Iones and Kronin, "An Ambient Light Illumination Model", 1998). It is the value that
 * SHD_SLOT_OCCLUSION takes: from a column of the mesh (shd_slot_vertex) or a texture (shd_slot_texture).
 *
 * A tracer of the host answers which rays are blocked; libshd_embree has one (shd/embree.h). Each point has `ray_count`
 * directions in a cosine-weighted hemisphere (Malley's method) from the Hammersley set, shifted at each point by a hash
 * of the bits of its position, its normal and the seed (Cranley and Patterson, 1976). The expected value is exact; the
 * standard error is at most 1 / (2 sqrt(ray_count)) and usually far below.
 *
 * Without a tracer, 2 ray_count directions of a spherical Fibonacci set (Keinert et al. 2015), turned by the seed, get
 * a depth map each, drawn by the rasteriser as in shd/shadow.h. All points share these directions, so values vary
 * smoothly, but a sharp edge casts faint steps. A map has texels of about 1 / map_size of the bounds of the draws;
 * cracks and contacts smaller than a few texels are lost. A map stores the occluder that is farthest from the point: if
 * it lies beyond the radius, it hides nearer ones, and the direction counts as open. docs/occlusion.md has errors.
 *
 * The value of a point is 1 if its position or normal is not finite, if the normal is 0, or if there is no occluder.
 * The bits of a point depend neither on the other points nor on workers and SIMD targets, provided that the bits of the
 * tracer do not.
 *
 * Thread safety: any thread; meshes and materials may be shared between concurrent calls.
 *
 * @code
 * shd_occlusion_desc desc = shd_occlusion_desc_default();
 * desc.draws = &draw, desc.draw_count = 1;
 * desc.ray_count = 256;
 * out = shd_f32_out_column(column, 0); // one value for each vertex
 * result = shd_occlusion_compute_vertices(context, &desc, &draw, &out);
 * mesh_desc.attributes = &occlusion; // of a second mesh, with the column as attribute 0
 * slot = shd_slot_vertex(SHD_SLOT_OCCLUSION, 0);
 * @endcode
 */
#ifndef SHD_OCCLUSION_H
#define SHD_OCCLUSION_H

#include <float.h>
#include <shd/bake.h>

SHD_BEGIN_DECLS

/**
 * Rays as packed columns of `count` elements, borrowed for the call. They start a little above the surfaces.
 * struct_size goes from the library to the tracer, as in shd/fragments.h.
 */
typedef struct shd_rays {
    uint32_t struct_size;      /**< size of the library's struct */
    size_t count;              /**< number of rays, at least 1 */
    const float *ox, *oy, *oz; /**< origins, world space */
    const float *dx, *dy, *dz; /**< directions, world space, unit */
    const float *length;       /**< length of each ray, world length, > 0; FLT_MAX or infinity = unlimited */
    /* ---- end of 0.1; append below ---- */
} shd_rays;

/**
 * A tracer of the host: sets blocked[i] to a value other than 0 if ray i meets an occluder. All start as 0.
 *
 * Runs on any worker of the executor, and calls may be concurrent. It must not throw, longjmp or call shd.
 */
typedef void (*shd_trace_fn)(const shd_rays *rays, uint32_t *blocked, void *user_data);

/** A tracer and its data. Frozen. */
typedef struct shd_tracer {
    shd_trace_fn trace; /**< NULL = none: depth maps */
    void *user_data;    /**< passed to `trace`; borrowed for the call */
} shd_tracer;

/** Occluders and rays; borrowed for the call. Required: nothing. */
typedef struct shd_occlusion_desc {
    uint32_t struct_size; /**< set by shd_occlusion_desc_default() */
    size_t ray_count;     /**< per point, 1..65536; default 64 */
    uint32_t seed;        /**< any value; default 0 */
    float radius;         /**< world length over which occluders count, > 0; default FLT_MAX = unlimited */
    /**
     * World length by which rays start above the surface, 0..1e9, besides 2^-18 of the largest coordinate of the point.
     * Depth maps: shd_shadow_desc.bias. Default 0.
     */
    float bias;
    uint32_t map_size; /**< depth maps: edge length [texels], 16..8192; default 1024 */
    shd_tracer tracer; /**< default none */
    /**
     * [draw_count] occluders of the depth maps, as in shd_shadow_render_desc; NULL if draw_count is 0. Not read if
     * there is a tracer, which has occluders of its own.
     */
    const shd_draw *draws;
    size_t draw_count; /**< up to 2^20 */
    /* ---- end of 0.1; append below ---- */
} shd_occlusion_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_occlusion_desc shd_occlusion_desc_default(void)
{
    shd_occlusion_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.ray_count = 64;
    desc.radius = FLT_MAX;
    desc.map_size = 1024;
    return desc;
}

/** Points on surfaces; borrowed for the call. */
typedef struct shd_occlusion_points {
    uint32_t struct_size;   /**< set by shd_occlusion_points_default() */
    size_t count;           /**< number of points; 0 is allowed */
    shd_f32_in position[3]; /**< x, y, z, world space; required unless count is 0 */
    shd_f32_in normal[3];   /**< x, y, z, world space, any length; required unless count is 0 */
    /* ---- end of 0.1; append below ---- */
} shd_occlusion_points;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_occlusion_points shd_occlusion_points_default(void)
{
    shd_occlusion_points points = SHD_ZERO_INIT;
    points.struct_size = (uint32_t)sizeof points;
    return points;
}

/** Columns for the occlusion of points. */
typedef struct shd_occlusion_values {
    uint32_t struct_size;   /**< set by shd_occlusion_values_default() */
    shd_f32_out visibility; /**< 1 = open, 0 = enclosed; required unless count is 0 */
    size_t nonfinite_count; /**< written: points with a number that is not finite */
    /* ---- end of 0.1; append below ---- */
} shd_occlusion_values;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_occlusion_values shd_occlusion_values_default(void)
{
    shd_occlusion_values values = SHD_ZERO_INIT;
    values.struct_size = (uint32_t)sizeof values;
    return values;
}

/**
 * Compute the occlusion of points.
 * @param context  its executor, allocator and SIMD target do the work; the objects may come from any context
 * @param desc     borrowed for the call
 * @param points   columns, borrowed for the call
 * @param out      columns, borrowed for the call; must not overlap any input (checked)
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_occlusion_compute(shd_context *context, const shd_occlusion_desc *desc,
                                                       const shd_occlusion_points *points, shd_occlusion_values *out);

/**
 * Compute the occlusion of the vertices of a draw, with their vertex normals. Its mesh and object_to_world are read.
 * @param context  as in shd_occlusion_compute()
 * @param desc     borrowed for the call; the draw occludes only if it is among the occluders
 * @param draw     borrowed for the call; without instances
 * @param out      column of shd_mesh_info.vertex_count elements
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_occlusion_compute_vertices(shd_context *context, const shd_occlusion_desc *desc,
                                                                const shd_draw *draw, const shd_f32_out *out);

/** A texture of occlusion, with the coverage of shd/bake.h. Required: width, height. */
typedef struct shd_occlusion_atlas {
    uint32_t struct_size; /**< set by shd_occlusion_atlas_default() */
    uint32_t width;       /**< texels, 1..16384 */
    uint32_t height;      /**< texels, 1..16384 */
    uint32_t uv_set;      /**< as shd_bake_desc.uv_set: 0 or 1; default 0 */
    uint32_t dilation;    /**< as shd_bake_desc.dilation, 0..1024 texels; default 0 */
    float empty;          /**< value of texels that stay empty, finite; default 1 */
    /** [draw_count] surfaces; mesh, object_to_world and instances are read; NULL if draw_count is 0. */
    const shd_draw *draws;
    size_t draw_count;     /**< up to 2^20 */
    shd_u32_out states;    /**< shd_texel_state of width * height texels; default not wanted */
    shd_bake_stats *stats; /**< statistics; its struct_size is read; NULL = not wanted; all zero on failure */
    /* ---- end of 0.1; append below ---- */
} shd_occlusion_atlas;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_occlusion_atlas shd_occlusion_atlas_default(void)
{
    shd_occlusion_atlas atlas = SHD_ZERO_INIT;
    atlas.struct_size = (uint32_t)sizeof atlas;
    atlas.empty = 1.0f;
    return atlas;
}

/**
 * Compute the occlusion of the texels of a texture, each at the point where shd_bake() shades it.
 *
 * Takes about 100 bytes of working memory for each texel.
 * @param context  as in shd_occlusion_compute()
 * @param desc     borrowed for the call
 * @param atlas    borrowed for the call
 * @param out      column of width * height elements, row by row from the top: packed, an image of SHD_FORMAT_R32F
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_occlusion_bake(shd_context *context, const shd_occlusion_desc *desc,
                                                    const shd_occlusion_atlas *atlas, const shd_f32_out *out);

SHD_END_DECLS

#endif /* SHD_OCCLUSION_H */
