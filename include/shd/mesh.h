/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Triangle meshes made from the caller's columns.
 *
 * First calls: shd_mesh_create_shape() or shd_mesh_create(), shd_mesh_get_info() and shd_mesh_release().
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a mesh never changes, so concurrent use is free.
 *
 * @code
 * const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}; // x, y, z
 * shd_mesh_desc desc = shd_mesh_desc_default();
 * desc.vertex_count = 3;
 * for (i = 0; i < 3; ++i) desc.position[i] = shd_f32_column(&triangle[0][i], sizeof triangle[0]);
 * result = shd_mesh_create(context, &desc, &mesh);
 * @endcode
 */
#ifndef SHD_MESH_H
#define SHD_MESH_H

#include <shd/column.h>
#include <shd/context.h>
#include <shd/shapes.h>
#include <shd/uv_projection.h>

SHD_BEGIN_DECLS

/** Vertices and triangles, in object space. */
typedef struct shd_mesh shd_mesh;

/** Largest number of the caller's own columns besides positions, normals, tangents and uv. */
#define SHD_MAX_ATTRIBUTES 8

/** Weights of face normals in computed vertex normals. Degenerate faces contribute nothing. */
typedef enum shd_normal_weight {
    SHD_NORMAL_WEIGHT_AREA = 0,    /**< sum of face normals times face area (the cross products) */
    SHD_NORMAL_WEIGHT_UNIFORM = 1, /**< plain average of unit face normals */
    SHD_NORMAL_WEIGHT_ANGLE = 2,   /**< weighted by the corner angle (Thuermer and Wuethrich 1998) */
    SHD_NORMAL_WEIGHT_MAX_ENUM = 0x7fffffff
} shd_normal_weight;

/**
 * Assembly of triangles from indices. A triangle of coincident vertices counts as a triangle, but covers nothing.
 * There is no topology of lines or points: shd_draw.fill draws the edges or the vertices of triangles.
 */
typedef enum shd_topology {
    SHD_TOPOLOGY_TRIANGLES = 0, /**< three indices each: (0, 1, 2), (3, 4, 5), ... */
    SHD_TOPOLOGY_STRIP = 1,     /**< each further index adds a triangle: (0, 1, 2), (1, 3, 2), (2, 3, 4), ... */
    SHD_TOPOLOGY_FAN = 2,       /**< each further index adds a triangle around vertex 0: (0, 1, 2), (0, 2, 3), ... */
    SHD_TOPOLOGY_MAX_ENUM = 0x7fffffff
} shd_topology;

/** Options of a mesh; combine with |. */
typedef enum shd_mesh_flag {
    SHD_MESH_NONE = 0,
    /** Accept NaN and infinite positions; rendering drops and counts the triangles that use them. */
    SHD_MESH_KEEP_NONFINITE = 1,
    /**
     * Compute tangents when none are given; see @ref tangents. Vertices may be appended to the caller's vertices:
     * shd_mesh_info.vertex_count is vertex_count + split_count.
     */
    SHD_MESH_TANGENTS = 2,
    /**
     * Find the triangles that share each edge, for shd_mesh_find_edges() and SHD_FILL_LINES. The mesh takes 12 more
     * bytes per triangle. Its creation temporarily takes another 12 bytes per triangle and 12 per vertex, and linear
     * time.
     */
    SHD_MESH_ADJACENCY = 4,
    SHD_MESH_FLAG_MAX_ENUM = 0x7fffffff
} shd_mesh_flag;
typedef uint32_t shd_mesh_flags; /**< shd_mesh_flag bits */

/** Vertices and triangles of a mesh; copied. Required: vertex_count, position. */
typedef struct shd_mesh_desc {
    uint32_t struct_size;            /**< set by shd_mesh_desc_default() */
    size_t vertex_count;             /**< 0..2^28; 0 makes an empty mesh */
    shd_f32_in position[3];          /**< x, y, z, object space; required unless vertex_count is 0 */
    shd_f32_in normal[3];            /**< x, y, z, object space, any length; all three or none; computed if absent */
    shd_normal_weight normal_weight; /**< used when `normal` is absent; default SHD_NORMAL_WEIGHT_AREA */
    shd_mesh_flags flags;            /**< default none */
    /** x, y, z, object space, and handedness, +1 or -1; see @ref tangents. All four or none; stored unchanged. */
    shd_f32_in tangent[4];
    shd_f32_in uv[2];  /**< u, v; both or none; 0 if absent, unless uv_projection computes them */
    shd_f32_in uv1[2]; /**< u, v of a second set; both or none; 0 if absent */
    /** [attribute_count] columns for materials and programs, such as colours; any may be absent. */
    const shd_f32_in *attributes;
    size_t attribute_count; /**< 0..SHD_MAX_ATTRIBUTES; default 0 */
    shd_topology topology;  /**< default SHD_TOPOLOGY_TRIANGLES */
    /**
     * Computes uv in place of the columns `uv`, which must be absent; see shd/uv_projection.h. Vertices may be appended
     * to the caller's, as by SHD_MESH_TANGENTS. Default none.
     */
    shd_uv_projection uv_projection;
    /** From object space to the space of uv_projection; column-major, affine, last row 0, 0, 0, 1; default identity */
    float object_to_projection[16];
    /**
     * Vertex numbers of the triangles in the order of `topology`; counter-clockwise = front. NULL = indices16; if that
     * is NULL too, 0, 1, 2, ... In strips and fans the largest number (0xffffffff, or 0xffff in indices16) starts a new
     * strip or fan.
     */
    shd_u32_in indices;
    shd_u16_in indices16; /**< 16-bit vertex numbers; at most one of indices and indices16 is set */
    /** A multiple of 3 up to 3 * 2^28 for triangles, else up to 2^28 + 2. Without indices: 0 = vertex_count. */
    size_t index_count;
    /* ---- end of 0.1; append below ---- */
} shd_mesh_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_mesh_desc shd_mesh_desc_default(void)
{
    shd_mesh_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.object_to_projection[0] = desc.object_to_projection[5] = desc.object_to_projection[10] = 1.0f;
    desc.object_to_projection[15] = 1.0f;
    return desc;
}

/**
 * Copy and check vertices and indices; compute normals if there are none.
 *
 * The call refuses these inputs, and the error text names the element: an index >= vertex_count, an index count that is
 * not a multiple of 3 (SHD_TOPOLOGY_TRIANGLES), a position that is not finite (unless SHD_MESH_KEEP_NONFINITE).
 * Normals, uv, tangents and attributes that are not finite count as 0.
 *
 * @anchor tangents
 * Tangents: the tangent t points towards increasing u, in the plane of the normal n. The bitangent is handedness *
 * cross(n, t) and points towards decreasing v, up in the picture, as in glTF 2.0.
 *
 * SHD_MESH_TANGENTS computes them to the MikkTSpace convention (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited",
 * 2008) for (u, 1 - v). Vertices of equal position, normal and uv count as one. The directions of the triangles around
 * it are weighted by angle, and triangles with mirrored uv stay apart. A vertex is split where mirrored and other
 * triangles meet, and where it belongs to several fans that share no edge. The first part keeps the caller's vertex
 * number. The copies have the other tangents; they follow the caller's vertices in the order of their originals. One
 * rule differs from Mikkelsen's generator: at its threshold of 180 degrees it leaves a triangle out of a corner's sum
 * if their directions are exactly opposite after rounding. Here each triangle of a fan counts for all its corners, so
 * that folded or stretched uv do not split vertices.
 *
 * Triangles without area in uv, or with two corners at the same position, use the tangent of their neighbours at each
 * vertex. A vertex without any tangent gets a unit vector perpendicular to n: the x axis projected into the plane of n,
 * or the y axis where |n.x| > 0.9. Such a vertex has degenerate or missing uv, has no triangles, or has directions that
 * cancel. Its handedness is 1, or -1 where all its triangles are mirrored.
 * @param context   retained
 * @param desc      borrowed for the call
 * @param out_mesh  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_create(shd_context *context, const shd_mesh_desc *desc, shd_mesh **out_mesh);

/**
 * Make the mesh of a shape: shd_shape_fill() and shd_mesh_create() in one call.
 * @param context   retained
 * @param desc      borrowed for the call; NULL = all defaults, a sphere of radius 1
 * @param flags     as shd_mesh_desc.flags
 * @param out_mesh  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_create_shape(shd_context *context, const shd_shape_desc *desc,
                                                       shd_mesh_flags flags, shd_mesh **out_mesh);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_mesh_retain(shd_mesh *mesh);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_mesh_release(shd_mesh *mesh);

/** Counts and bounds of a mesh. */
typedef struct shd_mesh_info {
    uint32_t struct_size;    /**< set by shd_mesh_info_default() */
    size_t vertex_count;     /**< including the vertices that uv_projection and SHD_MESH_TANGENTS added */
    size_t triangle_count;   /**< number of separate triangles, also for strips and fans */
    float bounds_min[3];     /**< bound of the finite positions; 0 if there are none */
    float bounds_max[3];     /**< bound of the finite positions; 0 if there are none */
    size_t nonfinite_count;  /**< vertices with a position that is not finite */
    size_t normalless_count; /**< vertices whose faces have no area or whose normal was 0; they get (0, 0, 1) */
    /** SHD_MESH_TANGENTS: vertices without a tangent from uv; they get a perpendicular one. */
    size_t tangentless_count;
    size_t split_count; /**< vertices that uv_projection and SHD_MESH_TANGENTS added */
    /* ---- end of 0.1; append below ---- */
} shd_mesh_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_mesh_info shd_mesh_info_default(void)
{
    shd_mesh_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Get counts and bounds of a mesh.
 * @param out_info  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_get_info(const shd_mesh *mesh, shd_mesh_info *out_info);

/**
 * Copy the positions out, object space.
 * @param out  [3] columns x, y, z of shd_mesh_info.vertex_count elements; NULL data = not wanted
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_positions(const shd_mesh *mesh, const shd_f32_out *out);

/**
 * Copy the unit vertex normals out, given or computed.
 * @param out  [3] columns x, y, z of shd_mesh_info.vertex_count elements; NULL data = not wanted
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_normals(const shd_mesh *mesh, const shd_f32_out *out);

/**
 * Copy the tangents out, given or computed; 0 if the mesh has none.
 * @param out  [4] columns x, y, z and handedness of shd_mesh_info.vertex_count elements; NULL data = not wanted
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_tangents(const shd_mesh *mesh, const shd_f32_out *out);

/**
 * Copy the texture coordinates out; 0 if the mesh has none.
 * @param out  [2] columns u, v of shd_mesh_info.vertex_count elements; NULL data = not wanted
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_uv(const shd_mesh *mesh, const shd_f32_out *out);

/**
 * Copy the second set of texture coordinates out; 0 if the mesh has none.
 * @param out  [2] columns u, v of shd_mesh_info.vertex_count elements; NULL data = not wanted
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_uv1(const shd_mesh *mesh, const shd_f32_out *out);

/**
 * Copy one of the caller's own columns out; 0 if it was absent.
 * @param index  0..SHD_MAX_ATTRIBUTES - 1
 * @param out    column of shd_mesh_info.vertex_count elements
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_attribute(const shd_mesh *mesh, uint32_t index, const shd_f32_out *out);

/**
 * Copy the indices out as separate triangles, also for strips and fans.
 * @param out  column of 3 * shd_mesh_info.triangle_count elements, each below shd_mesh_info.vertex_count
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_indices(const shd_mesh *mesh, const shd_u32_out *out);

SHD_END_DECLS

#endif /* SHD_MESH_H */
