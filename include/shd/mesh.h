/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Triangle meshes made from the caller's columns.
 *
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a mesh never changes, so concurrent use is free.
 */
#ifndef SHD_MESH_H
#define SHD_MESH_H

#include <shd/column.h>
#include <shd/context.h>

SHD_BEGIN_DECLS

/** Vertices and triangles, in object space. */
typedef struct shd_mesh shd_mesh;

/** Limits of a mesh. */
enum {
    SHD_MAX_ATTRIBUTES = 8 /**< columns of the caller's besides positions, normals, uv and tangents */
};

/** How vertex normals are made when the caller gives none. Degenerate faces contribute nothing. */
typedef enum shd_normal_weight {
    SHD_NORMAL_WEIGHT_AREA = 0,    /**< sum of face normals times face area (the cross products) */
    SHD_NORMAL_WEIGHT_UNIFORM = 1, /**< plain average of unit face normals */
    SHD_NORMAL_WEIGHT_ANGLE = 2,   /**< weighted by the corner angle (Thuermer and Wuethrich 1998) */
    SHD_NORMAL_WEIGHT_MAX_ENUM = 0x7fffffff
} shd_normal_weight;

/** Column of 16-bit unsigned integers that shd reads; borrowed for the call. */
typedef struct shd_u16_in {
    const uint16_t *data; /**< first element; NULL = the column is absent */
    size_t stride;        /**< bytes between elements; 0 = packed */
} shd_u16_in;

/** How indices make triangles. A triangle whose vertices coincide counts as one, though it covers nothing. */
typedef enum shd_topology {
    SHD_TOPOLOGY_TRIANGLES = 0, /**< three for each: (0, 1, 2), (3, 4, 5), ... */
    SHD_TOPOLOGY_STRIP = 1,     /**< one more for each: (0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 5, 4), ... */
    SHD_TOPOLOGY_FAN = 2,       /**< one more for each around the first: (0, 1, 2), (0, 2, 3), ... */
    SHD_TOPOLOGY_MAX_ENUM = 0x7fffffff
} shd_topology;

/** Switches of a mesh; combine with |. */
typedef enum shd_mesh_flag {
    SHD_MESH_NONE = 0,
    /** Accept NaN and infinite positions; rendering drops and counts the triangles that use them. */
    SHD_MESH_KEEP_NONFINITE = 1,
    /**
     * Compute tangents when none are given; see @ref tangents. Vertices may be added after the caller's, so that
     * shd_mesh_info.vertex_count is vertex_count + split_count.
     */
    SHD_MESH_TANGENTS = 2,
    /**
     * Find which triangles share each edge, for shd_mesh_find_edges and SHD_FILL_LINES. 12 bytes a triangle, and while
     * the mesh is made as much again and 12 bytes a vertex; takes time in proportion to both.
     */
    SHD_MESH_ADJACENCY = 4,
    SHD_MESH_FLAG_MAX_ENUM = 0x7fffffff
} shd_mesh_flag;

/** What a mesh is made from. Everything is copied. */
typedef struct shd_mesh_desc {
    uint32_t struct_size;   /**< set by shd_mesh_desc_default() */
    uint32_t vertex_count;  /**< 0..2^28; 0 makes an empty mesh */
    shd_f32_in position[3]; /**< x, y, z, object space; required unless vertex_count is 0 */
    shd_f32_in normal[3];   /**< x, y, z, object space, any length; all three or none (then computed) */
    shd_f32_in uv[2];       /**< u, v; both or none (then 0) */
    /** x, y, z, object space, and handedness, +1 or -1; see @ref tangents. All four or none; kept as they are. */
    shd_f32_in tangent[4];
    /**
     * By topology, counter-clockwise = front; NULL = indices16, or 0, 1, 2, ... without either. In strips and fans the
     * largest number (0xffffffff, of indices16 0xffff) is no vertex: the next index starts anew.
     */
    shd_u32_in indices;
    /** Of triangles a multiple of 3 up to 3 * 2^28, else up to 2^28 + 2; without indices: 0 = vertex_count. */
    size_t index_count;
    shd_normal_weight normal_weight;          /**< default area; used when `normal` is absent */
    uint32_t flags;                           /**< shd_mesh_flag bits */
    shd_u16_in indices16;                     /**< instead of `indices` */
    shd_topology topology;                    /**< default triangles */
    uint32_t reserved;                        /**< 0 */
    shd_f32_in uv1[2];                        /**< u, v of a second set; both or none (then 0) */
    shd_f32_in attribute[SHD_MAX_ATTRIBUTES]; /**< colours, coefficients, whatever materials and programs read; each
                                                   may be absent */
    /* ---- end of 0.1; append below ---- */
} shd_mesh_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_mesh_desc shd_mesh_desc_default(void)
{
    shd_mesh_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/**
 * Copy and check vertices and indices; compute normals if there are none.
 * Refused with the place named: an index >= vertex_count, an index count of triangles that is not a multiple of 3, a
 * position that is not finite (unless SHD_MESH_KEEP_NONFINITE).
 * Normals, uv, tangents and attributes that are not finite count as 0.
 *
 * @anchor tangents
 * Tangents: the tangent t points to growing u, in the plane of the normal n; the bitangent is handedness * cross(n, t)
 * and points to falling v, up in the picture, as in glTF 2.0. SHD_MESH_TANGENTS computes them to the MikkTSpace
 * convention (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008) for (u, 1 - v): vertices of equal position,
 * normal and uv count as one, the directions of the triangles around it are weighted by angle, and those whose uv are
 * mirrored stay apart. A vertex at which triangles of both kinds meet, or fans that share no edge, becomes several: the
 * first keeps the caller's number, copies of it with the other tangents come after the caller's vertices, in order of
 * what they are copies of. Triangles without area in uv, or with two corners in one place, take over the tangent of
 * their neighbours at each vertex. A vertex without any (its uv degenerate or missing, no triangle, directions that
 * cancel) gets a unit vector perpendicular to n, of handedness 1 unless mirrored triangles alone meet there: the x axis
 * laid into the plane of n, or the y axis where |n.x| > 0.9.
 * @param context   retained
 * @param desc      borrowed for the call
 * @param out_mesh  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_create(shd_context *context, const shd_mesh_desc *desc, shd_mesh **out_mesh);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_mesh_retain(shd_mesh *mesh);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_mesh_release(shd_mesh *mesh);

/** What a mesh turned out to be. */
typedef struct shd_mesh_info {
    uint32_t vertex_count;     /**< with those of split_count */
    uint32_t triangle_count;   /**< degenerate ones included */
    uint32_t normalless_count; /**< vertices whose faces have no area or whose normal was 0: (0, 0, 1) stands in */
    uint32_t nonfinite_count;  /**< vertices with a position that is not finite */
    float bounds_min[3];       /**< of the finite positions; 0 if there are none */
    float bounds_max[3];       /**< of the finite positions; 0 if there are none */
    uint32_t
        tangentless_count; /**< of SHD_MESH_TANGENTS: vertices whose uv gave no tangent, so that another stands in */
    uint32_t split_count;  /**< of SHD_MESH_TANGENTS: vertices that were added */
} shd_mesh_info;

/**
 * Counts and bounds of a mesh.
 * @param out_info  all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_get_info(const shd_mesh *mesh, shd_mesh_info *out_info);

/**
 * Copy the unit vertex normals out, given or computed.
 * @param out  x, y, z columns of vertex_count elements; unwanted ones NULL
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_normals(const shd_mesh *mesh, const shd_f32_out out[3]);

/**
 * Copy the positions out, object space.
 * @param out  x, y, z columns of shd_mesh_info.vertex_count elements; unwanted ones NULL
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_positions(const shd_mesh *mesh, const shd_f32_out out[3]);

/**
 * Copy the texture coordinates out; 0 if there were none.
 * @param out  u, v columns of shd_mesh_info.vertex_count elements; unwanted ones NULL
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_uv(const shd_mesh *mesh, const shd_f32_out out[2]);

/**
 * Copy the second set of texture coordinates out; 0 if there were none.
 * @param out  u, v columns of shd_mesh_info.vertex_count elements; unwanted ones NULL
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_uv1(const shd_mesh *mesh, const shd_f32_out out[2]);

/**
 * Copy one of the caller's own columns out; 0 if it was absent.
 * @param index  0..SHD_MAX_ATTRIBUTES - 1
 * @param out    column of shd_mesh_info.vertex_count elements
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_attribute(const shd_mesh *mesh, uint32_t index, const shd_f32_out *out);

/**
 * Copy the tangents out, given or computed; 0 if the mesh has none.
 * @param out  x, y, z and handedness, columns of shd_mesh_info.vertex_count elements; unwanted ones NULL
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_tangents(const shd_mesh *mesh, const shd_f32_out out[4]);

/**
 * Copy the indices out, as triangles whatever the topology was.
 * @param out  column of 3 * shd_mesh_info.triangle_count elements, each below shd_mesh_info.vertex_count
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_mesh_read_indices(const shd_mesh *mesh, const shd_u32_out *out);

SHD_END_DECLS

#endif /* SHD_MESH_H */
