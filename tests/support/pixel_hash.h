/* SPDX-License-Identifier: MIT */
/* Interleaved colour of a frame as a number, which is equal for every SIMD target and worker count. */
#ifndef SHD_TESTS_SUPPORT_PIXEL_HASH_H
#define SHD_TESTS_SUPPORT_PIXEL_HASH_H

#include "support/scene.h"

/* Hash of interleaved colour of every format: a scene with blends and four samples a pixel. */
static inline uint64_t shd_pixel_hash(const shd_context_desc *context_desc)
{
    static const shd_format k_colors[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F};
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    shd_scene scene;
    size_t f, y;
    shd_assert_ok(shd_context_create(context_desc, &context));
    shd_scene_open(&scene, SHD_SCENE_GLASS, context);
    for (f = 0; f < sizeof k_colors / sizeof k_colors[0]; ++f) {
        shd_framebuffer_desc desc = shd_framebuffer_desc_default();
        shd_framebuffer *framebuffer = NULL;
        shd_image view = shd_image_default();
        desc.width = 203;
        desc.height = 151;
        desc.samples = 4;
        desc.color_format = k_colors[f];
        shd_assert_ok(shd_framebuffer_create(context, &desc, &framebuffer));
        scene.desc.framebuffer = framebuffer;
        shd_assert_ok(shd_render(context, &scene.desc));
        shd_assert_ok(shd_framebuffer_view_color(framebuffer, &view));
        for (y = 0; y < view.height; ++y) {
            hash = shd_hash(hash, (const char *)view.pixels + y * view.row_stride,
                            view.width * shd_format_size(view.format));
        }
        shd_framebuffer_release(framebuffer);
    }
    shd_scene_close(&scene);
    shd_context_release(context);
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_PIXEL_HASH_H */
