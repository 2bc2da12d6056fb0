/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Model files: meshes, materials, textures, lights, cameras and instances, ready to render (libshd_scene).
 *
 * A shd_scene holds the contents of a file as ordinary handles, which the caller may use with or without the scene. The
 * library reads glTF 2.0, OBJ, PLY and STL. A build with assimp reads others (Collada, FBX, glTF 1.0 ...). World space
 * is the space of the file; glTF uses the same conventions as shd.
 *
 * First calls: shd_scene_load(), shd_scene_get_warning(), shd_scene_fill_render(), shd_scene_pose() for animations, and
 * shd_scene_release().
 *
 * Files are untrusted. Sizes, counts and time have budgets. The load drops triangles with indices out of range or
 * positions that are not finite, instances whose matrices are not finite, and slots whose textures cannot be read, and
 * adds a warning to the scene for each. The model names other files: its materials, buffers and textures. They are read
 * if they are regular files in its folder or below it; SHD_SCENE_ANY_FOLDER allows others.
 *
 * The readers run in a fresh child of shd-io-worker (shd/io.h), which opens no file, and whose memory and time are
 * limited. A crash in it is SHD_ERROR_CORRUPT. Every value that it sends is checked. With SHD_SCENE_IN_PROCESS they run
 * in this process, and a hostile file can crash or hang it, or change its memory.
 *
 * Nothing is printed. Two readers of assimp 5 print, and have no switch for it: skeletons of Ogre (.skeleton.xml) are
 * not read, which skins alone need, and OpenGEX (.ogex) is SHD_ERROR_UNSUPPORTED.
 *
 * Memory:        assimp and the tables of a scene use malloc; handles use the context's allocator.
 * Lifetime:      reference counted; load returns an owned reference.
 * Thread safety: any thread; a scene never changes, so concurrent use is free.
 *
 * @code
 * shd_render_desc frame = shd_render_desc_default();
 * result = shd_scene_load(context, "robot.glb", NULL, &scene);
 * result = shd_scene_fill_render(scene, &frame); // then the framebuffer, the camera, and lights if the file has none
 * @endcode
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
    SHD_SCENE_HOST_FILTERS = 2,     /**< textures have the filters of shd_scene_desc.sampler, not those of the file */
    SHD_SCENE_IN_PROCESS = 4,       /**< reads the model in this process: faster start, and the file must be trusted */
    SHD_SCENE_ANY_FOLDER = 8,       /**< names of the model may leave its folder: by `..`, absolute paths and links */
    SHD_SCENE_FLAG_MAX_ENUM = 0x7fffffff
} shd_scene_flag;
typedef uint32_t shd_scene_flags; /**< shd_scene_flag bits */

/** Options and budgets of a load. A budget that would be exceeded is SHD_ERROR_LIMIT. */
typedef struct shd_scene_desc {
    uint32_t struct_size;  /**< set by shd_scene_desc_default() */
    shd_scene_flags flags; /**< default none */
    /** Flags of all meshes; meshes with uv have tangents, unless a normal map reads uv1; default none. */
    shd_mesh_flags mesh_flags;
    /**
     * Coordinates of meshes without uv; see shd/uv_projection.h. The longest side of the model's bounds fills the cube
     * from -1 to 1; the axes are those of the world. A mesh that is placed several times uses its first place, and a
     * mesh with a skin or morph targets the pose of the file: its uv do not change when it moves. Default none.
     */
    shd_uv_projection uv_projection;
    /**
     * Sampler of all textures; its wraps are replaced by those of the file, and its filter and magnification where the
     * file has nearest texels or levels. Borrowed for the call; NULL = trilinear.
     */
    const shd_sampler_desc *sampler;
    /**
     * Formats, flags, tables and budgets of each texture file; its `encoding` is ignored; worker_path is that of the
     * model, too. Borrowed for the call; NULL = defaults.
     */
    const shd_load_desc *texture;
    uint64_t max_file_bytes;    /**< sum of the model and the files that are read with it; at least 1; default 2^30 */
    uint64_t max_vertices;      /**< sum over all meshes; at least 1; default 2^26 */
    uint64_t max_triangles;     /**< sum over all meshes; at least 1; default 2^26 */
    uint64_t max_nodes;         /**< at least 1; always at most 512 deep; default 2^18 */
    uint64_t max_instances;     /**< 1..2^20, the maximum of a frame; default 2^18 */
    uint64_t max_texture_bytes; /**< all textures with their mip levels; at least 1; default 2^32 */
    /**
     * [s], above 0; default 60. Ends the process that reads; SHD_SCENE_IN_PROCESS: checked between steps of a reader.
     */
    double time_limit;
    uint64_t max_reader_bytes; /**< memory of the process that reads, and of what it sends; at least 1; default 2^32 */
    /**
     * Answers the names of the model's files, in place of its folder: for archives and memory. The bytes are borrowed
     * until the load returns. SHD_ERROR_NOT_FOUND = no such file; any other result than SHD_OK ends the load. Runs on
     * the thread of the load; must not throw or longjmp. NULL = the folder of the model, or no file for a model in
     * memory.
     */
    shd_result (*find)(const char *name, const void **out_bytes, size_t *out_size, void *user_data);
    void *user_data; /**< passed to `find`; borrowed for the load */
    /* ---- end of 0.1; append below ---- */
} shd_scene_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_scene_desc shd_scene_desc_default(void)
{
    shd_scene_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    desc.max_file_bytes = (uint64_t)1 << 30;
    desc.max_vertices = desc.max_triangles = (uint64_t)1 << 26;
    desc.max_nodes = desc.max_instances = (uint64_t)1 << 18;
    desc.max_texture_bytes = desc.max_reader_bytes = (uint64_t)1 << 32;
    desc.time_limit = 60.0;
    return desc;
}

/**
 * Read a model file.
 *
 * Materials: unlit materials become SHD_MODEL_UNLIT, and those that transmit at least half of the light and are no
 * metals SHD_MODEL_GLASS, which needs an environment. Others with a roughness become SHD_MODEL_METALLIC_ROUGHNESS, and
 * the rest SHD_MODEL_BLINN_PHONG. All reflect ambient light with their diffuse colour (ambient_share = 1). Every slot
 * whose texture is in the file is set. Heights have no effect unless the file scales them. An opacity below 1, an
 * opacity map and glTF's BLEND become SHD_BLEND_SORTED; glTF's MASK becomes alpha_cutoff, and a cutoff above 1 makes
 * the opacity 0. The first two sets of texture coordinates are used. Colours of vertices are the attributes 0 to 3 of a
 * mesh, and multiply the diffuse colour and the opacity.
 *
 * Faces: the backs of surfaces that are not double-sided are culled; a node that mirrors turns the front around.
 *
 * Normals that the file has not, and normals of length 0 or not finite, are computed.
 *
 * Lights: points, spots, directional and ambient ones, with the file's numbers as intensities. If the light of the file
 * does not decrease with the square of the distance, its intensity is chosen so that both agree at the distance of half
 * the diagonal of the model.
 *
 * Skins and morph targets have the pose and the weights of the file; shd_scene_pose() samples animations. Points and
 * lines are left out.
 *
 * A model whose centre is more than 1024 radii away from 0 is moved to 0, because floats would lose its details:
 * shd_scene_info.origin.
 * @param context    retained
 * @param path       UTF-8 or any bytes the system accepts; a regular file; borrowed for the call
 * @param desc       borrowed for the call; NULL = all defaults
 * @param out_scene  owned; NULL on failure
 * @return SHD_ERROR_NOT_FOUND for a missing file, SHD_ERROR_CORRUPT for a damaged file,
 *         SHD_ERROR_UNSUPPORTED for an unknown format and for a file without triangles
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_load(shd_context *context, const char *path, const shd_scene_desc *desc,
                                                shd_scene **out_scene);

/**
 * Read a model file in memory. The files that it names come from shd_scene_desc.find.
 * @param bytes  [size]; borrowed for the call
 * @param name   name of the file, for formats without a mark of their own, such as "model.obj"; NULL = ""; borrowed for
 *               the call
 * @return as shd_scene_load()
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_load_memory(shd_context *context, const void *bytes, size_t size,
                                                       const char *name, const shd_scene_desc *desc,
                                                       shd_scene **out_scene);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_scene_retain(shd_scene *scene);

/** Drop a reference; NULL is ignored. Handles that the caller retained stay. Any thread. @since 0.1 */
SHD_API void shd_scene_release(shd_scene *scene);

/** Contents of a file. */
typedef struct shd_scene_info {
    uint32_t struct_size;       /**< set by shd_scene_info_default() */
    size_t mesh_count;          /**< with triangles */
    size_t material_count;      /**< at least 1 */
    size_t texture_count;       /**< that could be read */
    size_t light_count;         /**< 0 where the file has none */
    size_t camera_count;        /**< 0 where the file has none */
    size_t instance_count;      /**< as many as draws */
    size_t animation_count;     /**< 0 where the file has none */
    size_t warning_count;       /**< parts of the file that were left out or changed */
    size_t vertex_count;        /**< sum over all meshes, each counted once */
    size_t triangle_count;      /**< sum over all meshes, each counted once */
    size_t deformed_mesh_count; /**< meshes with a skin or morph targets, which each pose makes anew */
    float bounds_min[3];        /**< lowest x, y, z of all instances, world space */
    float bounds_max[3];        /**< highest x, y, z of all instances, world space */
    /**
     * A place in the world of the file is origin + the place in world space; 0 unless the model is far away from 0.
     * Equal in all poses.
     */
    double origin[3];
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
SHD_API const char *shd_scene_get_warning(const shd_scene *scene, size_t index);

/** Kinds of parts that have names. */
typedef enum shd_scene_part {
    SHD_SCENE_PART_MESH = 0,
    SHD_SCENE_PART_MATERIAL = 1,
    SHD_SCENE_PART_TEXTURE = 2, /**< the path of its file */
    SHD_SCENE_PART_LIGHT = 3,
    SHD_SCENE_PART_CAMERA = 4,
    SHD_SCENE_PART_ANIMATION = 5,
    SHD_SCENE_PART_MAX_ENUM = 0x7fffffff
} shd_scene_part;

/**
 * Name of a part in the file, made printable, at most 400 bytes; may be "".
 * @return borrowed until release of the scene; NULL if there is no such part
 * @since 0.1
 */
SHD_API const char *shd_scene_get_name(const shd_scene *scene, shd_scene_part part, size_t index);

/** A mesh; borrowed until release of the scene (retain it to keep it longer); NULL if there is none. @since 0.1 */
SHD_API shd_mesh *shd_scene_get_mesh(const shd_scene *scene, size_t index);

/** A material; borrowed until release of the scene; NULL if there is none. @since 0.1 */
SHD_API shd_material *shd_scene_get_material(const shd_scene *scene, size_t index);

/** A texture; borrowed until release of the scene; NULL if there is none. @since 0.1 */
SHD_API shd_texture *shd_scene_get_texture(const shd_scene *scene, size_t index);

/** A light; borrowed until release of the scene; NULL if there is none. @since 0.1 */
SHD_API shd_light *shd_scene_get_light(const shd_scene *scene, size_t index);

/**
 * The desc of a material, as a starting point for variants of it.
 * @param out_desc  its struct_size is read; the rest is written, all zero on failure. Slots, textures and samplers are
 *                  borrowed until release of the scene
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_material_desc(const shd_scene *scene, size_t index,
                                                             shd_material_desc *out_desc);

/**
 * The desc of a light.
 * @param out_desc  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_light_desc(const shd_scene *scene, size_t index,
                                                          shd_light_desc *out_desc);

/**
 * A camera of the file. If the file has no aspect, it is 0, which means the aspect of the picture. If the file has no
 * near and far plane, they enclose the whole model.
 * @param out_camera  its struct_size is read; the rest is written, all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_camera(const shd_scene *scene, size_t index, shd_camera *out_camera);

/** A mesh placed in the world with a material. */
typedef struct shd_scene_instance {
    uint32_t struct_size;      /**< set by shd_scene_instance_default() */
    shd_cull cull;             /**< faces that its draw skips: SHD_CULL_NONE for surfaces that are double-sided */
    size_t mesh;               /**< index for shd_scene_get_mesh() */
    size_t material;           /**< index for shd_scene_get_material() */
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
SHD_NODISCARD SHD_API shd_result shd_scene_get_instance(const shd_scene *scene, size_t index,
                                                        shd_scene_instance *out_instance);

/**
 * Set draws, draw_count, lights and light_count of a frame: one draw for each instance, in their order, and the lights
 * of the file. All other fields stay as they are. The caller sets the camera and the framebuffer, and adds lights if
 * the file has none.
 * @param in_out_render  borrowed for the call; afterwards its draws and lights are borrowed until release of the scene
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_fill_render(const shd_scene *scene, shd_render_desc *in_out_render);

/**
 * The times of an animation [s]: its first key and its last one. Poses before and after are those of the keys. Its name
 * is that of SHD_SCENE_PART_ANIMATION.
 * @param index  below shd_scene_info.animation_count
 * @param out_first  written; 0 on failure
 * @param out_last   written; 0 on failure
 * @return SHD_ERROR_NOT_FOUND if there is no such animation
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_get_animation_times(const shd_scene *scene, size_t index, double *out_first,
                                                               double *out_last);

/**
 * Make a scene of the file at some second of an animation, with all that nodes move: instances, skins, morph targets,
 * lights and cameras. Interpolation is that of glTF 2.0, appendix C. The new scene does not depend on the pose of
 * `scene`. It shares materials, textures and all meshes without skins and morph targets with it; parts keep their
 * indices, except instances, lights and cameras whose numbers are out of range in the pose, which give a warning.
 * @param animation  index, below shd_scene_info.animation_count
 * @param seconds    finite; clamped to the times of each property
 * @param out_scene  owned; NULL on failure
 * @return SHD_ERROR_NOT_FOUND if there is no such animation
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_scene_pose(const shd_scene *scene, size_t animation, double seconds,
                                                shd_scene **out_scene);

SHD_END_DECLS

#endif /* SHD_SCENE_H */
