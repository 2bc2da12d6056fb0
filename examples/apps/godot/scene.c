/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <math.h>
#include <string.h>

enum { FLOOR, TORUS, SIZE = 64, CELL = 16 };

static shd_result create_texture(struct scene *scene)
{
    static const uint8_t colors[2][4] = {{238, 228, 206, 255}, {52, 104, 160, 255}};
    uint8_t texels[SIZE][SIZE][4];
    shd_texture_desc desc = shd_texture_desc_default();
    int x, y;
    for (y = 0; y < SIZE; ++y) {
        for (x = 0; x < SIZE; ++x) memcpy(texels[y][x], colors[(x / CELL + y / CELL) % 2], 4);
    }
    desc.width = desc.height = SIZE;
    desc.format = SHD_FORMAT_RGBA8_SRGB;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    return shd_texture_create(scene->context, &desc, &scene->texture);
}

static shd_result create_material(const struct scene *scene, float repeats, shd_material **out)
{
    shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, scene->texture, scene->sampler);
    shd_material_desc desc = shd_material_desc_default();
    slot.uv_transform[0] = slot.uv_transform[4] = repeats;
    desc.model = SHD_MODEL_BLINN_PHONG;
    desc.specular[0] = desc.specular[1] = desc.specular[2] = 0.3f;
    desc.exponent = 50.0f;
    desc.ambient_share = 0.3f;
    desc.slots = &slot, desc.slot_count = 1;
    return shd_material_create(scene->context, &desc, out);
}

static shd_result create_meshes(struct scene *scene)
{
    shd_shape_desc floor_desc = shd_shape_desc_default(), torus_desc = shd_shape_desc_default();
    shd_result result;
    floor_desc.kind = SHD_SHAPE_PLANE;
    floor_desc.size[0] = floor_desc.size[2] = 80.0f;
    torus_desc.kind = SHD_SHAPE_TORUS;
    torus_desc.tube_radius = 0.4f;
    result = shd_mesh_create_shape(scene->context, &floor_desc, 0, &scene->meshes[FLOOR]);
    if (result != SHD_OK) return result;
    return shd_mesh_create_shape(scene->context, &torus_desc, 0, &scene->meshes[TORUS]);
}

static shd_result create_lights(struct scene *scene)
{
    static const float intensities[2][3] = {{1.5f, 1.45f, 1.35f}, {0.5f, 0.55f, 0.65f}};
    shd_light_desc desc = shd_light_desc_default();
    shd_result result;
    desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    desc.direction[0] = -0.5f, desc.direction[1] = -1.0f, desc.direction[2] = -0.25f;
    memcpy(desc.intensity, intensities[0], sizeof desc.intensity);
    result = shd_light_create(scene->context, &desc, &scene->lights[0]);
    if (result != SHD_OK) return result;
    desc = shd_light_desc_default();
    desc.kind = SHD_LIGHT_KIND_AMBIENT;
    memcpy(desc.intensity, intensities[1], sizeof desc.intensity);
    return shd_light_create(scene->context, &desc, &scene->lights[1]);
}

static shd_result create_objects(struct scene *scene)
{
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    shd_framebuffer_desc framebuffer_desc = shd_framebuffer_desc_default();
    shd_result result = shd_context_create(NULL, &scene->context);
    sampler_desc.filter = SHD_FILTER_ANISOTROPIC;
    sampler_desc.max_anisotropy = 16.0f;
    framebuffer_desc.width = scene->width, framebuffer_desc.height = scene->height;
    framebuffer_desc.sample_count = 4;
    framebuffer_desc.color_format = SHD_FORMAT_RGBA8_SRGB;
    if (result == SHD_OK) result = shd_framebuffer_create(scene->context, &framebuffer_desc, &scene->framebuffer);
    if (result == SHD_OK) result = create_texture(scene);
    if (result == SHD_OK) result = shd_sampler_create(scene->context, &sampler_desc, &scene->sampler);
    if (result == SHD_OK) result = create_material(scene, 20.0f, &scene->materials[FLOOR]);
    if (result == SHD_OK) result = create_material(scene, 4.0f, &scene->materials[TORUS]);
    if (result == SHD_OK) result = create_meshes(scene);
    if (result == SHD_OK) result = create_lights(scene);
    return result;
}

shd_result scene_open(struct scene *scene, uint32_t width, uint32_t height)
{
    shd_result result;
    memset(scene, 0, sizeof *scene);
    scene->width = width, scene->height = height;
    result = create_objects(scene);
    if (result != SHD_OK) scene_close(scene); /* releases do not change the text of the error */
    return result;
}

/* The torus stands upright, turns around the axis Y, and touches the floor. */
static shd_result place_torus(int frame, float *out_matrix)
{
    const float half = 0.5f * (float)frame * 0.35f;
    const float turn[4] = {0.0f, sinf(half), 0.0f, cosf(half)};
    const float upright[4] = {0.70710678f, 0.0f, 0.0f, 0.70710678f};
    const float place[3] = {0.0f, 1.4f, 0.0f};
    float turned[16], raised[16];
    shd_result result = shd_matrix_from_trs(place, turn, NULL, turned);
    if (result == SHD_OK) result = shd_matrix_from_trs(NULL, upright, NULL, raised);
    return result == SHD_OK ? shd_matrix_multiply(turned, raised, out_matrix) : result;
}

shd_result scene_draw(const struct scene *scene, int frame, uint8_t *pixels)
{
    shd_draw draws[2] = {shd_draw_default(), shd_draw_default()};
    shd_camera camera = shd_camera_default();
    shd_render_desc desc = shd_render_desc_default();
    shd_image image = shd_image_default();
    shd_result result = place_torus(frame, draws[TORUS].object_to_world);
    int i;
    for (i = 0; i < 2; ++i) draws[i].mesh = scene->meshes[i], draws[i].material = scene->materials[i];
    camera.eye[0] = 1.0f, camera.eye[1] = 2.2f, camera.eye[2] = 4.5f;
    camera.target[1] = 1.0f;
    desc.framebuffer = scene->framebuffer;
    desc.camera = &camera;
    desc.draws = draws, desc.draw_count = 2;
    desc.lights = (const shd_light *const *)scene->lights, desc.light_count = 2;
    desc.clear_color[0] = 0.35f, desc.clear_color[1] = 0.5f, desc.clear_color[2] = 0.75f, desc.clear_color[3] = 1.0f;
    image.width = scene->width, image.height = scene->height;
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.pixels = pixels;
    if (result == SHD_OK) result = shd_render(scene->context, &desc);
    return result == SHD_OK ? shd_framebuffer_read_color(scene->framebuffer, &image) : result;
}

void scene_close(struct scene *scene)
{
    int i;
    for (i = 0; i < 2; ++i) {
        shd_light_release(scene->lights[i]);
        shd_mesh_release(scene->meshes[i]);
        shd_material_release(scene->materials[i]);
    }
    shd_framebuffer_release(scene->framebuffer);
    shd_sampler_release(scene->sampler);
    shd_texture_release(scene->texture);
    shd_context_release(scene->context);
    memset(scene, 0, sizeof *scene);
}
