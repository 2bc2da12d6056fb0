/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Sized structs: how callers and libraries of different versions work together, and defaults through FFI.
 *
 * A struct that may grow begins with `uint32_t struct_size`, the size that the caller's header gives it. Fields are
 * only ever appended.
 *  - In C and C++ call the inline `shd_<noun>_default()`, which uses the size in the caller's headers. Bindings that
 *    cannot call inline functions call shd_desc_init().
 *  - Structs that the library reads: fields missing from a smaller struct have their defaults. Bytes of a larger struct
 *    beyond the library's own must be zero, else the call fails with SHD_ERROR_UNSUPPORTED.
 *  - Structs that the library writes: it never writes beyond struct_size. It clears the bytes of a larger struct beyond
 *    its own, and does not change struct_size.
 *  - A struct_size that does not reach the last required field of the struct is refused, and one that is not a multiple
 *    of the alignment of the struct, because no header has such a struct.
 *  - All elements of an array of sized structs have one struct_size, which is the distance between them.
 *  - Padding is never given to a field. No sized struct ends with padding, and appended fields bring none.
 *
 * Structs without struct_size are frozen. Structs are passed by pointer. Only inline functions return structs.
 *
 * Thread safety: any thread.
 *
 * @code
 * shd_sampler_desc desc; // what shd_sampler_desc_default() returns
 * shd_result result = shd_desc_init(SHD_DESC_KIND_SAMPLER_DESC, &desc, sizeof desc);
 * @endcode
 */
#ifndef SHD_DESC_H
#define SHD_DESC_H

#include <shd/result.h>

SHD_BEGIN_DECLS

/** A sized struct, for shd_desc_init(). */
typedef enum shd_desc_kind {
    SHD_DESC_KIND_NONE = 0,
    SHD_DESC_KIND_CONTEXT_DESC = 1,         /**< shd_context_desc */
    SHD_DESC_KIND_IMAGE = 2,                /**< shd_image */
    SHD_DESC_KIND_TEXTURE_DESC = 3,         /**< shd_texture_desc */
    SHD_DESC_KIND_TEXTURE_INFO = 4,         /**< shd_texture_info */
    SHD_DESC_KIND_MIP_DESC = 5,             /**< shd_mip_desc */
    SHD_DESC_KIND_SAMPLER_DESC = 6,         /**< shd_sampler_desc */
    SHD_DESC_KIND_LOOKUPS = 7,              /**< shd_lookups */
    SHD_DESC_KIND_TEXELS = 8,               /**< shd_texels */
    SHD_DESC_KIND_LEVELS = 9,               /**< shd_levels */
    SHD_DESC_KIND_EXPLANATION = 10,         /**< shd_explanation */
    SHD_DESC_KIND_RAY_DIFFERENTIALS = 11,   /**< shd_ray_differentials */
    SHD_DESC_KIND_RAY_CONES = 12,           /**< shd_ray_cones */
    SHD_DESC_KIND_DERIVATIVES = 13,         /**< shd_derivatives */
    SHD_DESC_KIND_MESH_DESC = 14,           /**< shd_mesh_desc */
    SHD_DESC_KIND_MESH_INFO = 15,           /**< shd_mesh_info */
    SHD_DESC_KIND_EDGES_DESC = 16,          /**< shd_edges_desc */
    SHD_DESC_KIND_EDGES = 17,               /**< shd_edges */
    SHD_DESC_KIND_TESSELLATION_DESC = 18,   /**< shd_tessellation_desc */
    SHD_DESC_KIND_MATERIAL_DESC = 19,       /**< shd_material_desc */
    SHD_DESC_KIND_SLOT = 20,                /**< shd_slot */
    SHD_DESC_KIND_LIGHT_DESC = 21,          /**< shd_light_desc */
    SHD_DESC_KIND_SHADOW_DESC = 22,         /**< shd_shadow_desc */
    SHD_DESC_KIND_SHADOW_RENDER_DESC = 23,  /**< shd_shadow_render_desc */
    SHD_DESC_KIND_SHADOW_LOOKUPS = 24,      /**< shd_shadow_lookups */
    SHD_DESC_KIND_SHADOW_VALUES = 25,       /**< shd_shadow_values */
    SHD_DESC_KIND_FRAMEBUFFER_DESC = 26,    /**< shd_framebuffer_desc */
    SHD_DESC_KIND_FRAMEBUFFER_INFO = 27,    /**< shd_framebuffer_info */
    SHD_DESC_KIND_PLANE_VIEW = 28,          /**< shd_plane_view */
    SHD_DESC_KIND_CAMERA = 29,              /**< shd_camera */
    SHD_DESC_KIND_DRAW = 30,                /**< shd_draw */
    SHD_DESC_KIND_RENDER_DESC = 31,         /**< shd_render_desc */
    SHD_DESC_KIND_RENDER_STATS = 32,        /**< shd_render_stats */
    SHD_DESC_KIND_COLOR_DESC = 33,          /**< shd_color_desc, of shd/color.h */
    SHD_DESC_KIND_LOAD_DESC = 34,           /**< shd_load_desc, of shd/io.h */
    SHD_DESC_KIND_SAVE_DESC = 35,           /**< shd_save_desc, of shd/io.h */
    SHD_DESC_KIND_BITMAP_INFO = 36,         /**< shd_bitmap_info, of shd/io.h */
    SHD_DESC_KIND_SHAPE_DESC = 37,          /**< shd_shape_desc */
    SHD_DESC_KIND_SHAPE_COLUMNS = 38,       /**< shd_shape_columns */
    SHD_DESC_KIND_SCENE_DESC = 39,          /**< shd_scene_desc, of shd/scene.h */
    SHD_DESC_KIND_SCENE_INFO = 40,          /**< shd_scene_info, of shd/scene.h */
    SHD_DESC_KIND_SCENE_INSTANCE = 41,      /**< shd_scene_instance, of shd/scene.h */
    SHD_DESC_KIND_SOLID_DESC = 42,          /**< shd_solid_desc */
    SHD_DESC_KIND_SOLID_POINTS = 43,        /**< shd_solid_points */
    SHD_DESC_KIND_SOLID_VALUES = 44,        /**< shd_solid_values */
    SHD_DESC_KIND_DIRECTIONS = 45,          /**< shd_directions */
    SHD_DESC_KIND_PROJECTED_POINTS = 46,    /**< shd_projected_points */
    SHD_DESC_KIND_IMAGE_POINTS = 47,        /**< shd_image_points */
    SHD_DESC_KIND_POINT_DIRECTIONS = 48,    /**< shd_point_directions */
    SHD_DESC_KIND_VOLUME_DESC = 49,         /**< shd_volume_desc */
    SHD_DESC_KIND_VOLUME_DRAW = 50,         /**< shd_volume_draw */
    SHD_DESC_KIND_ENVIRONMENT_DESC = 51,    /**< shd_environment_desc */
    SHD_DESC_KIND_ENVIRONMENT_INFO = 52,    /**< shd_environment_info */
    SHD_DESC_KIND_ENVIRONMENT_LOOKUPS = 53, /**< shd_environment_lookups */
    SHD_DESC_KIND_ENVIRONMENT_VALUES = 54,  /**< shd_environment_values */
    SHD_DESC_KIND_DIRECTION_IMAGES = 55,    /**< shd_direction_images */
    SHD_DESC_KIND_POLYGON_DESC = 56,        /**< shd_polygon_desc */
    SHD_DESC_KIND_POLYGON_POINTS = 57,      /**< shd_polygon_points */
    SHD_DESC_KIND_POLYGON_WEIGHTS = 58,     /**< shd_polygon_weights */
    SHD_DESC_KIND_RAW_DESC = 59,            /**< shd_raw_desc, of shd/volume_file.h */
    SHD_DESC_KIND_STACK_DESC = 60,          /**< shd_stack_desc, of shd/volume_file.h */
    SHD_DESC_KIND_VDB_DESC = 61,            /**< shd_vdb_desc, of shd/volume_file.h */
    SHD_DESC_KIND_VDB_INFO = 62,            /**< shd_vdb_info, of shd/volume_file.h */
    SHD_DESC_KIND_BAKE_DESC = 63,           /**< shd_bake_desc */
    SHD_DESC_KIND_BAKE_STATS = 64,          /**< shd_bake_stats */
    SHD_DESC_KIND_OCCLUSION_DESC = 65,      /**< shd_occlusion_desc */
    SHD_DESC_KIND_OCCLUSION_POINTS = 66,    /**< shd_occlusion_points */
    SHD_DESC_KIND_OCCLUSION_VALUES = 67,    /**< shd_occlusion_values */
    SHD_DESC_KIND_OCCLUSION_ATLAS = 68,     /**< shd_occlusion_atlas */
    SHD_DESC_KIND_BOUNDS_DESC = 69,         /**< shd_bounds_desc */
    SHD_DESC_KIND_TEXTURE_FILE_INFO = 70,   /**< shd_texture_file_info, of shd/texture_file.h */
    SHD_DESC_KIND_KTX2_DESC = 71,           /**< shd_ktx2_desc, of shd/texture_file.h */
    SHD_DESC_KIND_TILE_REGION = 72,         /**< shd_tile_region */
    SHD_DESC_KIND_TILE_CACHE_DESC = 73,     /**< shd_tile_cache_desc */
    SHD_DESC_KIND_TILE_CACHE_STATS = 74,    /**< shd_tile_cache_stats */
    SHD_DESC_KIND_TILE_FILE_DESC = 75,      /**< shd_tile_file_desc, of shd/tile_file.h */
    SHD_DESC_KIND_TILE_FILE_INFO = 76,      /**< shd_tile_file_info, of shd/tile_file.h */
    SHD_DESC_KIND_NORMALS_DESC = 77,        /**< shd_normals_desc */
    SHD_DESC_KIND_POLYHEDRON_DESC = 78,     /**< shd_polyhedron_desc */
    SHD_DESC_KIND_POLYHEDRON_POINTS = 79,   /**< shd_polyhedron_points */
    SHD_DESC_KIND_POLYHEDRON_WEIGHTS = 80,  /**< shd_polyhedron_weights */
    SHD_DESC_KIND_POLYHEDRON_VALUES = 81,   /**< shd_polyhedron_values */
    SHD_DESC_KIND_TABLE_DESC = 82,          /**< shd_table_desc */
    SHD_DESC_KIND_TABLE_INFO = 83,          /**< shd_table_info */
    SHD_DESC_KIND_SHADOW_INFO = 84,         /**< shd_shadow_info */
    SHD_DESC_KIND_MAX_ENUM = 0x7fffffff
} shd_desc_kind;

/**
 * Write the defaults of a sized struct into the caller's memory and set its struct_size.
 * @param kind  the struct that `ptr` points at
 * @param ptr   the caller's struct, aligned for it
 * @param size  size in bytes of the caller's struct. If it is smaller than the library's struct, only the fields inside
 *              it are written; it must contain every required field. If it is larger, the remaining bytes become
 *              zero
 * @return SHD_ERROR_INVALID_ARGUMENT for an unknown kind, a NULL pointer, or a size that lacks required fields or is
 *         not a multiple of the alignment of the struct
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_desc_init(shd_desc_kind kind, void *ptr, size_t size);

SHD_END_DECLS

#endif /* SHD_DESC_H */
