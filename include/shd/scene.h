/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Model files: meshes, materials, textures, lights, cameras and instances, ready to render (libshd_scene, over
 *        assimp).
 *
 * A shd_scene holds the contents of a file of any format that assimp reads (glTF, OBJ, Collada, FBX, PLY, STL ...), as
 * ordinary handles that the caller may use with or without the scene. World space is the space of the file; glTF uses
 * the same conventions as shd.
 *
 * Files are untrusted. Sizes, counts and time have budgets. The load drops triangles with indices out of range or
 * positions that are not finite, instances whose matrices are not finite, and slots whose textures cannot be read, and
 * adds a warning to the scene for each. The model may name other files by any path: its materials, buffers and
 * textures. They are read if they are regular files. assimp itself can still crash, run out of stack, hang, change the
 * memory of the process or return parts of it as vertices on a hostile file: load untrusted models in a separate
 * process.
 *
 * Nothing is printed. Two readers of assimp 5 print, and have no switch for it: skeletons of Ogre (.skeleton.xml) are
 * not read, which skins alone need, and OpenGEX (.ogex) is SHD_ERROR_UNSUPPORTED.
 *
 * Memory:        assimp and the tables of a scene use malloc; handles use the context's allocator.
 * Lifetime:      reference counted; load returns an owned reference.
 * Thread safety: any thread; a scene never changes, so concurrent use is free.
 */
#ifndef SHD_SCENE_H
#define SHD_SCENE_H

#include <shd/io.h>
#include <shd/render.h>

SHD_BEGIN_DECLS

/** A model file in memory. */
typedef struct shd_scene shd_scene;

/** Options of a load; combine with |. */
typedef enum shd_scene_flag {
    SHD_SCENE_NONE = 0,
    SHD_SCENE_REQUIRE_TEXTURES = 1, /**< a texture that cannot be read makes the load fail */
    SHD_SCENE_FLAG_MAX_ENUM = 0x7fffffff
} shd_scene_flag;
typedef uint32_t shd_scene_flags; /**< shd_scene_flag bits */

/** Options and budgets of a load. A budget that would be exceeded is SHD_ERROR_LIMIT. */
typedef struct shd_scene_desc {
    uint32_t struct_size;            /**< set by shd_scene_desc_default() */
    shd_scene_flags flags;           /**< default none */
    shd_mesh_flags mesh_flags;       /**< flags of all meshes; meshes with uv always have tangents; default none */
    const shd_sampler_desc *sampler; /**< sampler of all textures; its wraps are replaced by those of the file.
                                           Borrowed for the call; NULL = trilinear */
    const shd_load_desc *texture;    /**< formats, flags, tables and budgets of each texture file; its color_space is
                                          ignored. Borrowed for the call; NULL = defaults */
    uint64_t max_file_bytes;         /**< sum of the model and the files that assimp reads with it; 0 = 2^30 */
    uint64_t max_vertices;           /**< sum over all meshes; 0 = 2^26 */
    uint64_t max_triangles;          /**< sum over all meshes; 0 = 2^26 */
    uint64_t max_nodes;              /**< 0 = 2^18; always at most 512 deep */
    uint64_t max_instances;          /**< up to 2^20, the maximum of a frame; 0 = 2^18 */
    uint64_t max_texture_bytes;      /**< all textures with their mip levels; 0 = 2^32 */
    double time_limit;               /**< [s] 0 = 60. Checked between the steps of assimp, meshes and textures */
    /* ---- end of 0.1; append below ---- */
} shd_scene_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_scene_desc shd_scene_desc_default(void)
{
    shd_scene_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/**
 * Read a model file.
 *
 * Materials: materials with a roughness become SHD_MODEL_METALLIC_ROUGHNESS, all others SHD_MODEL_BLINN_PHONG. All
 * reflect ambient light with their diffuse colour (ambient_share = 1). Every slot whose texture is in the file is set.
 * Heights are in their slot, but have no effect until a material enables bump, parallax or displacement. An opacity
 * below 1, an opacity map and glTF's BLEND become SHD_BLEND_SORTED; glTF's MASK becomes alpha_cutoff. The first two
 * sets of texture coordinates are used.
 *
 * Lights: points, spots, directional and ambient ones, with the file's numbers as intensities. If the light of the file
 * does not decrease with the square of the distance, its intensity is chosen so that both agree at the distance of half
 * the diagonal of the model.
 *
 * Points and lines, animations, skins and morph targets are left out.
 * @param context    retained
 * @param path       UTF-8 or any bytes the system accepts; a regular file; borrowed for the call
 * @param desc       borrowed for the call; NULL = all defaults
 * @param out_scene  owned; NULL on failure
 * @return SHD_ERROR_NOT_FOUND for a missing file, SHD_ERROR_CORRUPT for a file that assimp refuses,
 *         SHD_ERROR_UNSUPPORTED for an unknown format and for a file without triangles
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_load(shd_context *context, const char *path, const shd_scene_desc *desc,
                                                shd_scene **out_scene);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_scene_retain(shd_scene *scene);

/** Drop a reference; NULL is ignored. Handles that the caller retained stay. Any thread. @since 0.1 */
SHD_API void shd_scene_release(shd_scene *scene);

/** Contents of a file. */
typedef struct shd_scene_info {
    uint32_t struct_size;    /**< set by shd_scene_info_default() */
    uint32_t mesh_count;     /**< with triangles */
    uint32_t material_count; /**< at least 1 */
    uint32_t texture_count;  /**< that could be read */
    uint32_t light_count;    /**< 0 where the file has none */
    uint32_t camera_count;   /**< 0 where the file has none */
    uint32_t instance_count; /**< at least 1; as many as draws */
    uint32_t warning_count;  /**< parts of the file that were left out or changed */
    uint64_t vertex_count;   /**< sum over all meshes, each counted once */
    uint64_t triangle_count; /**< sum over all meshes, each counted once */
    float bounds_min[3];     /**< lowest x, y, z of all instances, world space */
    float bounds_max[3];     /**< highest x, y, z of all instances, world space */
    /* ---- end of 0.1; append below ---- */
} shd_scene_info;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_scene_info shd_scene_info_default(void)
{
    shd_scene_info info = SHD_ZERO_INIT;
    info.struct_size = (uint32_t)sizeof info;
    return info;
}

/**
 * Counts and bounds of a scene.
 * @param out_info  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_info(const shd_scene *scene, shd_scene_info *out_info);

/**
 * A problem with a part of the file, as one line of UTF-8. All warnings are also written to the log of the context.
 * @return borrowed until release of the scene; NULL if there is none
 * @since 0.1
 */
SHD_API const char *shd_scene_warning(const shd_scene *scene, uint32_t index);

/** Kinds of parts that have names. */
typedef enum shd_scene_part {
    SHD_SCENE_PART_MESH = 0,
    SHD_SCENE_PART_MATERIAL = 1,
    SHD_SCENE_PART_TEXTURE = 2, /**< the path of its file */
    SHD_SCENE_PART_LIGHT = 3,
    SHD_SCENE_PART_CAMERA = 4,
    SHD_SCENE_PART_MAX_ENUM = 0x7fffffff
} shd_scene_part;

/**
 * Name of a part in the file, made printable, at most 400 bytes; may be "".
 * @return borrowed until release of the scene; NULL if there is no such part
 * @since 0.1
 */
SHD_API const char *shd_scene_name(const shd_scene *scene, shd_scene_part part, uint32_t index);

/** A mesh; borrowed until release of the scene (retain it to keep it longer); NULL if there is none. @since 0.1 */
SHD_API shd_mesh *shd_scene_mesh(const shd_scene *scene, uint32_t index);

/** A material; borrowed until release of the scene; NULL if there is none. @since 0.1 */
SHD_API shd_material *shd_scene_material(const shd_scene *scene, uint32_t index);

/** A texture; borrowed until release of the scene; NULL if there is none. @since 0.1 */
SHD_API shd_texture *shd_scene_texture(const shd_scene *scene, uint32_t index);

/** A light; borrowed until release of the scene; NULL if there is none. @since 0.1 */
SHD_API shd_light *shd_scene_light(const shd_scene *scene, uint32_t index);

/**
 * The desc of a material, as a starting point for variants of it.
 * @param out_desc  its struct_size is read; the rest is written, all zero on failure. Slots, textures and samplers are
 *                  borrowed until release of the scene
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_material_desc(const shd_scene *scene, uint32_t index,
                                                             shd_material_desc *out_desc);

/**
 * The desc of a light.
 * @param out_desc  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_light_desc(const shd_scene *scene, uint32_t index,
                                                          shd_light_desc *out_desc);

/**
 * A camera of the file. If the file has no aspect, it is 0, which means the aspect of the picture. If the file has no
 * near and far plane, they enclose the whole model.
 * @param out_camera  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_camera(const shd_scene *scene, uint32_t index, shd_camera *out_camera);

/** A mesh placed in the world with a material. */
typedef struct shd_scene_instance {
    uint32_t struct_size;      /**< set by shd_scene_instance_default() */
    uint32_t mesh;             /**< index for shd_scene_mesh() */
    uint32_t material;         /**< index for shd_scene_material() */
    float object_to_world[16]; /**< affine, finite */
    /* ---- end of 0.1; append below ---- */
} shd_scene_instance;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_scene_instance shd_scene_instance_default(void)
{
    shd_scene_instance instance = SHD_ZERO_INIT;
    instance.struct_size = (uint32_t)sizeof instance;
    return instance;
}

/**
 * An instance of the scene.
 * @param out_instance  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_instance(const shd_scene *scene, uint32_t index,
                                                        shd_scene_instance *out_instance);

/**
 * Set draws, draw_count, lights and light_count of a frame: one draw for each instance, in their order, and the lights
 * of the file. All other fields stay as they are. The caller sets the camera and the framebuffer, and adds lights if
 * the file has none.
 * @param in_out_render  borrowed for the call; afterwards its draws and lights are borrowed until release of the scene
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_fill_render(const shd_scene *scene, shd_render_desc *in_out_render);

SHD_END_DECLS

#endif /* SHD_SCENE_H */
