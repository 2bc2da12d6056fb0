/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Vertices and triangles of common shapes, in the caller's columns.
 *
 * shd_mesh_create_shape() (shd/mesh.h) makes the mesh of a shape in one call. shd_shape_count() returns the numbers of
 * vertices and indices of a shape; shd_shape_fill() writes the shape, for programs that change or keep the columns. The
 * columns have the conventions of shd_mesh_desc: object space, right-handed, +Y up, triangles counter-clockwise seen
 * from outside, uv with v down.
 *
 * | shape   | where                                                   | uv                                            |
 * |---------|---------------------------------------------------------|-----------------------------------------------|
 * | sphere  | centre at 0                                             | globe: u from west to east, v from the north  |
 * |         |                                                         | pole down; (0.5, 0.5) on +Z                   |
 * | box     | centre at 0                                             | (0, 0)..(1, 1) on each side                   |
 * | plane   | y = 0, centre at 0, normal +Y                           | u along +X, v along +Z                        |
 * | torus   | centre at 0, axis Y                                     | u around the axis, v around the tube from the |
 * |         |                                                         | inside over the top; (0.5, 0.5) on +Z         |
 * | teapot  | on y = 0, 3.15 high, spout towards +X                   | each part its own chart; u and v repeat       |
 *
 * Shapes have no gaps: vertices at the same position have the same bits, so seams of uv and creases do not open. No
 * triangle is degenerate; at a pole each triangle has a vertex of its own, with u in the middle of it. The sphere, box
 * and torus have no open edges. The bits are the same on every machine.
 *
 * Thread safety: any thread. Nothing is allocated.
 *
 * @code
 * shd_shape_desc desc = shd_shape_desc_default();
 * desc.kind = SHD_SHAPE_TORUS;
 * result = shd_shape_count(&desc, &vertex_count, &index_count); // the sizes of the columns for shd_shape_fill()
 * @endcode
 */
#ifndef SHD_SHAPES_H
#define SHD_SHAPES_H

#include <shd/column.h>
#include <shd/result.h>

SHD_BEGIN_DECLS

/** Kinds of shapes. */
typedef enum shd_shape {
    SHD_SHAPE_SPHERE = 0, /**< uses `radius` */
    SHD_SHAPE_BOX = 1,    /**< uses `size` */
    SHD_SHAPE_PLANE = 2,  /**< a rectangle, size[0] by size[2] */
    SHD_SHAPE_TORUS = 3,  /**< `radius` of the circle in the middle of the tube, `tube_radius` */
    /**
     * The Utah teapot: 32 bicubic Bezier patches by Martin Newell (1975), with the bottom that Frank Crow added ("The
     * Origins of the Teapot", IEEE Computer Graphics and Applications 7(1), 1987). The body with its bottom, the lid,
     * the handle and the spout are separate open surfaces that meet or intersect.
     */
    SHD_SHAPE_TEAPOT = 4,
    SHD_SHAPE_MAX_ENUM = 0x7fffffff
} shd_shape;

/** Largest number of parts in one direction of a shape. */
#define SHD_MAX_SHAPE_SEGMENTS 4096

/** Largest number of parts per side of a patch of the teapot. */
#define SHD_MAX_TEAPOT_SEGMENTS 256

/** A shape and its subdivision. */
typedef struct shd_shape_desc {
    uint32_t struct_size; /**< set by shd_shape_desc_default() */
    shd_shape kind;       /**< default sphere */
    float radius;         /**< spheres and tori: 1e-30..1e30; default 1 */
    float tube_radius;    /**< tori: 1e-30..1e30, below `radius`; default 0.25 */
    float size[3];        /**< boxes and planes: length along x, y, z, 1e-30..1e30; default 2 */
    /**
     * Parts; 0 = the number in brackets. Sphere: around, 3..4096 [32], and from pole to pole, 2..4096 [16]. Box: along
     * x, y and z, 1..4096 [1]. Plane: [0] along x and [2] along z, as of `size`, 1..4096 [1]. Torus: around the axis,
     * 3..4096 [48], and around the tube, 3..4096 [24]. Teapot: along each side of a patch, 2..256 [8]. Unused numbers
     * are ignored, as size[1] and segments[1] of a plane.
     */
    uint32_t segments[3];
    /* ---- end of 0.1; append below ---- */
} shd_shape_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_shape_desc shd_shape_desc_default(void)
{
    shd_shape_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.radius = 1.0f;
    desc.tube_radius = 0.25f;
    desc.size[0] = desc.size[1] = desc.size[2] = 2.0f;
    return desc;
}

/** Output columns of a shape. They do not overlap; each may be absent. */
typedef struct shd_shape_columns {
    uint32_t struct_size; /**< set by shd_shape_columns_default() */
    size_t vertex_count;  /**< elements in each column of vertices, at least the number from shd_shape_count() */
    /** Elements in `indices`, at least the number from shd_shape_count() unless `indices` is absent. */
    size_t index_count;
    shd_f32_out position[3]; /**< x, y, z, object space */
    shd_f32_out normal[3];   /**< x, y, z, unit, outwards */
    shd_f32_out uv[2];       /**< u, v */
    shd_u32_out indices;     /**< three for each triangle */
    /* ---- end of 0.1; append below ---- */
} shd_shape_columns;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_shape_columns shd_shape_columns_default(void)
{
    shd_shape_columns columns = SHD_ZERO_INIT;
    columns.struct_size = (uint32_t)sizeof columns;
    return columns;
}

/**
 * Compute the numbers of vertices and indices of a shape.
 * @param desc              borrowed for the call; NULL = all defaults
 * @param out_vertex_count  0 on failure
 * @param out_index_count   three for each triangle; 0 on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shape_count(const shd_shape_desc *desc, size_t *out_vertex_count,
                                                 size_t *out_index_count);

/**
 * Write a shape. Elements beyond the numbers from shd_shape_count() do not change.
 * @param desc     borrowed for the call; NULL = all defaults
 * @param columns  borrowed for the call
 * @return SHD_ERROR_INVALID_ARGUMENT also when a column is too short; nothing is written then
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_shape_fill(const shd_shape_desc *desc, const shd_shape_columns *columns);

SHD_END_DECLS

#endif /* SHD_SHAPES_H */
