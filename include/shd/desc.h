/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Defaults for desc structs, for languages that cannot call C inline functions.
 *
 * Every desc begins with `struct_size`. In C and C++ take the inline `shd_<noun>_default()`, which compiles
 * the caller's own size in; through FFI call shd_desc_init. A desc from a newer header is accepted as long as
 * the bytes the library does not know are zero; one from an older header gets defaults for what it lacks.
 *
 * Thread safety: any thread.
 */
#ifndef SHD_DESC_H
#define SHD_DESC_H

#include <shd/result.h>

SHD_BEGIN_DECLS

/** Which desc shd_desc_init fills. */
typedef enum shd_desc_kind {
    SHD_DESC_NONE = 0,
    SHD_DESC_CONTEXT = 1,            /**< shd_context_desc */
    SHD_DESC_TEXTURE = 2,            /**< shd_texture_desc */
    SHD_DESC_SAMPLER = 3,            /**< shd_sampler_desc */
    SHD_DESC_LOOKUPS = 4,            /**< shd_lookups */
    SHD_DESC_MESH = 5,               /**< shd_mesh_desc */
    SHD_DESC_MATERIAL = 6,           /**< shd_material_desc */
    SHD_DESC_LIGHT = 7,              /**< shd_light_desc */
    SHD_DESC_FRAMEBUFFER = 8,        /**< shd_framebuffer_desc */
    SHD_DESC_DRAW = 9,               /**< shd_draw */
    SHD_DESC_RENDER = 10,            /**< shd_render_desc */
    SHD_DESC_IMAGE = 11,             /**< shd_image */
    SHD_DESC_CAMERA = 12,            /**< shd_camera */
    SHD_DESC_COLOR = 13,             /**< shd_color_desc, of shd/color.h */
    SHD_DESC_LOAD = 14,              /**< shd_load_desc, of shd/io.h */
    SHD_DESC_SAVE = 15,              /**< shd_save_desc, of shd/io.h */
    SHD_DESC_RAY_DIFFERENTIALS = 16, /**< shd_ray_differentials */
    SHD_DESC_RAY_CONES = 17,         /**< shd_ray_cones */
    SHD_DESC_EXPLANATION = 18,       /**< shd_explanation */
    SHD_DESC_MIP = 19,               /**< shd_mip_desc */
    SHD_DESC_EDGES = 20,             /**< shd_edges_desc */
    SHD_DESC_SHADOW = 21,            /**< shd_shadow_desc */
    SHD_DESC_SHADOW_RENDER = 22,     /**< shd_shadow_render_desc */
    SHD_DESC_SHADOW_LOOKUPS = 23,    /**< shd_shadow_lookups */
    SHD_DESC_TESSELLATION = 24,      /**< shd_tessellation_desc */
    SHD_DESC_SHAPE = 25,             /**< shd_shape_desc */
    SHD_DESC_SHAPE_COLUMNS = 26,     /**< shd_shape_columns */
    SHD_DESC_SCENE = 27,             /**< shd_scene_desc, of shd/scene.h */
    SHD_DESC_SCENE_INFO = 28,        /**< shd_scene_info, of shd/scene.h */
    SHD_DESC_SCENE_INSTANCE = 29,    /**< shd_scene_instance, of shd/scene.h */
    SHD_DESC_KIND_MAX_ENUM = 0x7fffffff
} shd_desc_kind;

/**
 * Write the defaults of a desc into the caller's memory and set its struct_size.
 * @param kind  which desc `ptr` points at
 * @param ptr   the caller's struct, aligned for it
 * @param size  size in bytes of the caller's struct; smaller than the library's is allowed down to the 0.1
 *              layout, larger gets its tail zeroed
 * @return SHD_ERROR_INVALID_ARGUMENT for an unknown kind, a NULL pointer or a size below the 0.1 layout
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_desc_init(shd_desc_kind kind, void *ptr, size_t size);

SHD_END_DECLS

#endif /* SHD_DESC_H */
