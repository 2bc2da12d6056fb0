/* SPDX-License-Identifier: MIT */
/* A picture of a model file: model MODEL.glb writes model.png. */
#include <stdio.h>
#include <stdlib.h>

#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shd.h>

static void require(shd_result result)
{
    if (result == SHD_OK) return;
    fprintf(stderr, "model: %s\n", shd_last_error());
    exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    shd_scene_info info = shd_scene_info_default();
    shd_camera camera = shd_camera_default();
    shd_light_desc light_desc = shd_light_desc_default();
    shd_framebuffer_desc picture_desc = shd_framebuffer_desc_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_context *context = NULL;
    shd_scene *scene = NULL;
    shd_light *lights[2] = {NULL};
    shd_framebuffer *picture = NULL;
    size_t i;

    if (argc != 2) {
        fprintf(stderr, "usage: model FILE\n");
        return EXIT_FAILURE;
    }
    require(shd_context_create(NULL, &context));
    require(shd_scene_load(context, argv[1], NULL, &scene));
    require(shd_scene_get_info(scene, &info));
    printf("%zu triangles, %zu materials, %zu textures\n", info.triangle_count, info.material_count,
           info.texture_count);
    for (i = 0; i < info.warning_count; ++i) printf("warning: %s\n", shd_scene_get_warning(scene, i));
    camera.eye[0] = 0.48f, camera.eye[1] = 0.36f, camera.eye[2] = 0.8f; /* from the right, above and in front */
    camera.aspect = 480.0f / 400.0f;
    require(shd_camera_frame_box(&camera, info.bounds_min, info.bounds_max));

    light_desc.kind = SHD_LIGHT_KIND_AMBIENT;
    light_desc.intensity[0] = light_desc.intensity[1] = light_desc.intensity[2] = 0.3f;
    require(shd_light_create(context, &light_desc, &lights[0]));
    light_desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    light_desc.intensity[0] = light_desc.intensity[1] = light_desc.intensity[2] = 0.8f;
    for (i = 0; i < 3; ++i) light_desc.direction[i] = camera.target[i] - camera.eye[i]; /* from the eye */
    require(shd_light_create(context, &light_desc, &lights[1]));

    picture_desc.width = 480, picture_desc.height = 400;
    picture_desc.sample_count = 8;
    require(shd_framebuffer_create(context, &picture_desc, &picture));

    require(shd_scene_fill_render(scene, &frame)); /* the draws, and the lights of the file */
    frame.lights = (const shd_light *const *)lights, frame.light_count = 2;
    frame.framebuffer = picture, frame.camera = &camera;
    for (i = 0; i < 3; ++i) frame.clear_color[i] = 0.5f;
    frame.clear_color[3] = 1;
    require(shd_render(context, &frame));
    require(shd_framebuffer_save(picture, "model.png", NULL));

    shd_framebuffer_release(picture);
    for (i = 0; i < 2; ++i) shd_light_release(lights[i]);
    shd_scene_release(scene);
    shd_context_release(context);
    return EXIT_SUCCESS;
}
