/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "scene.h"

/* Levels of at most 512 x 512 texels take 24 tiles, 1.5 MiB. */
enum { COARSE = 10 };

static shd_result create_surface(struct scene *scene, uint64_t budget, shd_missing_tiles missing)
{
    shd_tile_cache_desc cd = shd_tile_cache_desc_default();
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_material_desc md = shd_material_desc_default();
    shd_slot slot;
    shd_result result;
    int c;
    cd.budget_bytes = budget;
    sd.filter = SHD_FILTER_ANISOTROPIC;
    sd.wrap_v = SHD_WRAP_CLAMP;
    sd.missing_tiles = missing;
    result = shd_tile_cache_create(scene->context, &cd, &scene->cache);
    if (result == SHD_OK) result = planet_create_texture(scene->context, scene->cache, &scene->planet);
    if (result == SHD_OK) result = planet_pin_coarse_levels(scene->planet, COARSE);
    if (result == SHD_OK) result = shd_sampler_create(scene->context, &sd, &scene->sampler);
    slot = shd_slot_texture(SHD_SLOT_DIFFUSE, scene->planet, scene->sampler);
    for (c = 0; c < 3; ++c) md.diffuse[c] = 1.0f;
    md.slots = &slot;
    md.slot_count = 1;
    if (result == SHD_OK) result = shd_material_create(scene->context, &md, &scene->material);
    return result;
}

/* A globe whose facets are at most 120 m below the sphere, on Earth. */
static shd_result create_globe(struct scene *scene)
{
    shd_shape_desc desc = shd_shape_desc_default();
    desc.kind = SHD_SHAPE_SPHERE;
    desc.segments[0] = 512;
    desc.segments[1] = 256;
    return shd_mesh_create_shape(scene->context, &desc, SHD_MESH_NONE, &scene->globe);
}

static shd_result create_lights(struct scene *scene)
{
    shd_light_desc sun = shd_light_desc_default(), sky = shd_light_desc_default();
    shd_result result;
    int c;
    sun.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    sky.kind = SHD_LIGHT_KIND_AMBIENT;
    for (c = 0; c < 3; ++c) {
        sun.direction[c] = -k_planet_sun[c];
        sun.intensity[c] = 1.3f;
        sky.intensity[c] = 0.6f;
    }
    result = shd_light_create(scene->context, &sun, &scene->lights[0]);
    return result == SHD_OK ? shd_light_create(scene->context, &sky, &scene->lights[1]) : result;
}

shd_result scene_create(struct scene *scene, uint32_t width, uint32_t height, uint64_t budget,
                        shd_missing_tiles missing)
{
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_result result;
    memset(scene, 0, sizeof *scene);
    fd.width = scene->width = width;
    fd.height = scene->height = height;
    fd.sample_count = 4;
    result = shd_context_create(NULL, &scene->context);
    if (result == SHD_OK) result = create_surface(scene, budget, missing);
    if (result == SHD_OK) result = create_globe(scene);
    if (result == SHD_OK) result = create_lights(scene);
    if (result == SHD_OK) result = shd_framebuffer_create(scene->context, &fd, &scene->framebuffer);
    return result;
}

void scene_release(struct scene *scene)
{
    shd_framebuffer_release(scene->framebuffer);
    shd_light_release(scene->lights[0]);
    shd_light_release(scene->lights[1]);
    shd_mesh_release(scene->globe);
    shd_material_release(scene->material);
    shd_sampler_release(scene->sampler);
    shd_texture_release(scene->planet);
    shd_tile_cache_release(scene->cache);
    shd_context_release(scene->context);
}

shd_result scene_render(const struct scene *scene, const struct flight *flight, uint8_t *pixels)
{
    const float air = expf(-60.0f * flight->altitude); /* the sky is black in space */
    shd_draw draw = shd_draw_default();
    shd_render_desc desc = shd_render_desc_default();
    shd_image image = shd_image_default();
    shd_result result;
    draw.mesh = scene->globe;
    draw.material = scene->material;
    draw.cull = SHD_CULL_BACK;
    desc.framebuffer = scene->framebuffer;
    desc.camera = &flight->camera;
    desc.draws = &draw, desc.draw_count = 1;
    desc.lights = (const shd_light *const *)scene->lights, desc.light_count = 2;
    desc.clear_color[0] = 0.30f * air, desc.clear_color[1] = 0.50f * air;
    desc.clear_color[2] = 0.80f * air, desc.clear_color[3] = 1.0f;
    result = shd_render(scene->context, &desc);
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = scene->width, image.height = scene->height;
    image.pixels = pixels;
    return result == SHD_OK ? shd_framebuffer_read_color(scene->framebuffer, &image) : result;
}
