/* SPDX-License-Identifier: MIT */
/* Colour of frames as a number, which is equal for every SIMD target and worker count. */
#ifndef SHD_TESTS_SUPPORT_PIXEL_HASH_H
#define SHD_TESTS_SUPPORT_PIXEL_HASH_H

#include "support/scene.h"

/* Hash of the colour of a scene in a framebuffer without further planes. */
static inline uint64_t shd_frame_hash(uint64_t hash, const shd_scene *scene, shd_format format, uint32_t samples)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_render_desc frame = scene->desc;
    shd_image image = shd_image_default();
    unsigned char *const pixels = (unsigned char *)shd_scene_memory(203 * 151 * 16);
    desc.width = 203;
    desc.height = 151;
    desc.sample_count = samples;
    desc.color_format = format;
    shd_assert_ok(shd_framebuffer_create(scene->context, &desc, &framebuffer));
    frame.framebuffer = framebuffer;
    shd_assert_ok(shd_render(scene->context, &frame));
    image.format = format;
    image.width = desc.width;
    image.height = desc.height;
    image.pixels = pixels;
    shd_assert_ok(shd_framebuffer_read_color(framebuffer, &image));
    hash = shd_hash(hash, pixels, 203 * 151 * shd_format_size(format));
    free(pixels);
    shd_framebuffer_release(framebuffer);
    return hash;
}

/* Hash of interleaved colour of every format: a scene with blends and four samples a pixel. */
static inline uint64_t shd_pixel_hash(const shd_context_desc *context_desc)
{
    static const shd_format k_colors[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F};
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    shd_scene scene;
    size_t f;
    shd_assert_ok(shd_context_create(context_desc, &context));
    shd_scene_open(&scene, SHD_SCENE_GLASS, context);
    for (f = 0; f < sizeof k_colors / sizeof k_colors[0]; ++f) hash = shd_frame_hash(hash, &scene, k_colors[f], 4);
    shd_scene_close(&scene);
    shd_context_release(context);
    return hash;
}

/* Gives a scene a camera without perspective. */
static inline void shd_scene_look_parallel(shd_scene *scene)
{
    static const float k_rectangle[4] = {-3.1f, 3.3f, -2.2f, 2.4f};
    shd_assert_ok(
        shd_matrix_orthographic(k_rectangle, 0.125f, 40.0f, SHD_DEPTH_ORDER_FORWARD, scene->desc.view.view_to_clip));
}

/* Hash of colour alone, of the materials of a scene if it is seen without perspective, and of materials that are one
   texture, in pixels and planes. */
static inline uint64_t shd_textured_hash_seen(const shd_context_desc *context_desc, int is_parallel)
{
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    shd_material *material[2];
    shd_scene scene;
    size_t i;
    shd_assert_ok(shd_context_create(context_desc, &context));
    shd_scene_open(&scene, SHD_SCENE_MIXED, context);
    if (is_parallel) {
        shd_scene_look_parallel(&scene);
        hash = shd_frame_hash(hash, &scene, SHD_FORMAT_RGBA32F, 1);
    }
    for (i = 0; i < 2; ++i) {
        shd_material_desc desc = shd_material_desc_default();
        shd_slot_list slots;
        slots.count = 0;
        desc.model = SHD_MODEL_UNLIT;
        desc.diffuse[0] = i ? 0.375f : 1.0f;
        desc.diffuse[1] = desc.diffuse[2] = 1.0f;
        shd_scene_slot(&scene, &slots, &desc, SHD_SLOT_DIFFUSE, i);
        shd_assert_ok(shd_material_create(context, &desc, &material[i]));
    }
    for (i = 0; i < scene.desc.draw_count; ++i) scene.draw[i].material = material[i % 2];
    hash = shd_frame_hash(hash, &scene, SHD_FORMAT_RGBA8, 1);
    hash = shd_frame_hash(hash, &scene, SHD_FORMAT_RGBA32F, 1);
    hash = shd_frame_hash(hash, &scene, SHD_FORMAT_RGBA8_SRGB, 4);
    for (i = 0; i < 2; ++i) shd_material_release(material[i]);
    shd_scene_close(&scene);
    shd_context_release(context);
    return hash;
}

static inline uint64_t shd_textured_hash(const shd_context_desc *context_desc)
{
    return shd_textured_hash_seen(context_desc, 0);
}

static inline uint64_t shd_parallel_hash(const shd_context_desc *context_desc)
{
    return shd_textured_hash_seen(context_desc, 1);
}

#endif /* SHD_TESTS_SUPPORT_PIXEL_HASH_H */
