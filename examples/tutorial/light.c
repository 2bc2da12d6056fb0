/* SPDX-License-Identifier: MIT */
/* A torus on a floor, in the light of a low sun with a shadow: light.png. */
#include <stdio.h>
#include <stdlib.h>

#include <shd/io.h>
#include <shd/shd.h>

static void require(shd_result result)
{
    if (result == SHD_OK) return;
    fprintf(stderr, "light: %s\n", shd_last_error());
    exit(EXIT_FAILURE);
}

static shd_light *make_light(shd_context *context, shd_light_kind kind, float r, float g, float b)
{
    shd_light_desc desc = shd_light_desc_default();
    shd_light *light = NULL;
    desc.kind = kind;
    desc.intensity[0] = r, desc.intensity[1] = g, desc.intensity[2] = b;
    desc.direction[0] = 0.6f, desc.direction[1] = -0.5f, desc.direction[2] = 0.25f; /* where the rays go */
    require(shd_light_create(context, &desc, &light));
    return light;
}

static shd_material *make_material(shd_context *context, float r, float g, float b, float roughness)
{
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    desc.model = SHD_MODEL_METALLIC_ROUGHNESS;
    desc.diffuse[0] = r, desc.diffuse[1] = g, desc.diffuse[2] = b;
    desc.roughness = roughness;
    require(shd_material_create(context, &desc, &material));
    return material;
}

/* The map of depths from the light, which the frame compares with the depth of each point. */
static shd_shadow *make_shadow(shd_context *context, const shd_light *light, const shd_draw *draws, size_t count)
{
    shd_shadow_desc desc = shd_shadow_desc_default();
    shd_shadow_render_desc map = shd_shadow_render_desc_default();
    shd_shadow *shadow = NULL;
    desc.filter = SHD_SHADOW_FILTER_PCF; /* soft edges of one width */
    desc.taps = 7;
    require(shd_shadow_create(context, &desc, &shadow));
    map.light = light;
    map.draws = draws, map.draw_count = count; /* the casters */
    require(shd_shadow_render(context, shadow, &map));
    return shadow;
}

int main(void)
{
    shd_shape_desc shape = shd_shape_desc_default();
    shd_framebuffer_desc picture_desc = shd_framebuffer_desc_default();
    shd_camera camera = shd_camera_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_draw draws[2];
    shd_context *context = NULL;
    shd_mesh *torus = NULL, *floor = NULL;
    shd_material *clay, *stone;
    shd_light *lights[2];
    shd_shadow *shadows[2] = {NULL};
    shd_framebuffer *picture = NULL;
    int i;

    require(shd_context_create(NULL, &context));
    shape.kind = SHD_SHAPE_TORUS;
    shape.tube_radius = 0.4f;
    require(shd_mesh_create_shape(context, &shape, SHD_MESH_NONE, &torus));
    shape.kind = SHD_SHAPE_PLANE;
    shape.size[0] = shape.size[2] = 1000;
    require(shd_mesh_create_shape(context, &shape, SHD_MESH_NONE, &floor));
    clay = make_material(context, 0.8f, 0.25f, 0.1f, 0.4f);
    stone = make_material(context, 0.6f, 0.6f, 0.6f, 0.9f);
    draws[0] = draws[1] = shd_draw_default();
    draws[0].mesh = torus, draws[0].material = clay;
    draws[0].object_to_world[13] = 0.4f; /* up by the radius of the tube */
    draws[1].mesh = floor, draws[1].material = stone;

    lights[0] = make_light(context, SHD_LIGHT_KIND_AMBIENT, 1.2f, 1.5f, 2.0f); /* the sky */
    lights[1] = make_light(context, SHD_LIGHT_KIND_DIRECTIONAL, 2.4f, 2.1f, 1.7f);
    shadows[1] = make_shadow(context, lights[1], draws, 1); /* shadows[0] stays NULL: the sky casts none */

    picture_desc.width = 480, picture_desc.height = 360;
    picture_desc.sample_count = 8;
    require(shd_framebuffer_create(context, &picture_desc, &picture));
    camera.eye[0] = 1.2f, camera.eye[1] = 1.9f, camera.eye[2] = 4.2f;
    camera.target[1] = 0.2f;
    frame.framebuffer = picture, frame.camera = &camera;
    frame.draws = draws, frame.draw_count = 2;
    frame.lights = (const shd_light *const *)lights, frame.light_count = 2;
    frame.shadows = (const shd_shadow *const *)shadows; /* one for each light */
    frame.clear_color[0] = 0.35f, frame.clear_color[1] = 0.5f, frame.clear_color[2] = 0.75f, frame.clear_color[3] = 1;
    require(shd_render(context, &frame));
    require(shd_framebuffer_save(picture, "light.png", NULL));

    shd_framebuffer_release(picture);
    for (i = 0; i < 2; ++i) shd_light_release(lights[i]), shd_shadow_release(shadows[i]);
    shd_material_release(clay), shd_material_release(stone);
    shd_mesh_release(torus), shd_mesh_release(floor);
    shd_context_release(context);
    return EXIT_SUCCESS;
}
