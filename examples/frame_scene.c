/* SPDX-License-Identifier: MIT */
#include "frame_scene.h"

#include <math.h>

enum { TILE = 64, AROUND = 64, DOWN = 32, BALL_VERTICES = (AROUND + 1) * (DOWN + 1) };

/* One vertex as an interleaved record: columns are its members with a stride. */
struct vertex {
    float position[3], normal[3], uv[2];
};

static shd_result create_mesh(shd_context *context, const struct vertex *vertices, uint32_t vertex_count,
                              const uint32_t *indices, size_t index_count, shd_mesh **out_mesh)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    int c;
    desc.vertex_count = vertex_count;
    for (c = 0; c < 3; ++c) {
        desc.position[c] = shd_f32_column(&vertices->position[c], sizeof *vertices);
        desc.normal[c] = shd_f32_column(&vertices->normal[c], sizeof *vertices);
    }
    for (c = 0; c < 2; ++c) desc.uv[c] = shd_f32_column(&vertices->uv[c], sizeof *vertices);
    desc.indices = shd_u32_column(indices, 0);
    desc.index_count = index_count;
    return shd_mesh_create(context, &desc, out_mesh);
}

static shd_result create_floor(shd_context *context, shd_mesh **out_mesh)
{
    static const struct vertex corners[4] = {{{-8, 0, 8}, {0, 1, 0}, {0, 16}},
                                             {{8, 0, 8}, {0, 1, 0}, {16, 16}},
                                             {{8, 0, -8}, {0, 1, 0}, {16, 0}},
                                             {{-8, 0, -8}, {0, 1, 0}, {0, 0}}};
    static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    return create_mesh(context, corners, 4, indices, 6, out_mesh);
}

/* Radius 0.9, standing on the floor; counter-clockwise as seen from outside. */
static shd_result create_ball(shd_context *context, shd_mesh **out_mesh)
{
    static struct vertex vertices[BALL_VERTICES];
    static uint32_t indices[AROUND * DOWN * 6];
    const float pi = 3.14159265f;
    uint32_t i, j, n = 0;
    for (j = 0; j <= DOWN; ++j) {
        for (i = 0; i <= AROUND; ++i) {
            struct vertex *p = &vertices[j * (AROUND + 1) + i];
            float across = 2.0f * pi * (float)i / AROUND, down = pi * (float)j / DOWN;
            p->normal[0] = sinf(down) * sinf(across);
            p->normal[1] = cosf(down);
            p->normal[2] = sinf(down) * cosf(across);
            p->position[0] = 0.9f * p->normal[0];
            p->position[1] = 0.9f * p->normal[1] + 0.9f;
            p->position[2] = 0.9f * p->normal[2];
            p->uv[0] = (float)i / AROUND, p->uv[1] = (float)j / DOWN;
        }
    }
    for (j = 0; j < DOWN; ++j) {
        for (i = 0; i < AROUND; ++i) {
            uint32_t a = j * (AROUND + 1) + i, b = a + AROUND + 1;
            indices[n++] = a, indices[n++] = b, indices[n++] = b + 1;
            indices[n++] = a, indices[n++] = b + 1, indices[n++] = a + 1;
        }
    }
    return create_mesh(context, vertices, BALL_VERTICES, indices, n, out_mesh);
}

/* A light tile with a dark joint around it. */
static shd_result create_tiles(shd_context *context, shd_texture **out_texture)
{
    static uint8_t pixels[TILE][TILE][4];
    shd_texture_desc desc = shd_texture_desc_default();
    int x, y;
    for (y = 0; y < TILE; ++y) {
        for (x = 0; x < TILE; ++x) {
            int joint = x < 3 || y < 3, odd = (x < TILE / 2) != (y < TILE / 2);
            pixels[y][x][0] = (uint8_t)(joint ? 40 : odd ? 214 : 168);
            pixels[y][x][1] = (uint8_t)(joint ? 38 : odd ? 205 : 96);
            pixels[y][x][2] = (uint8_t)(joint ? 36 : odd ? 188 : 72);
            pixels[y][x][3] = 255;
        }
    }
    desc.format = SHD_FORMAT_RGBA8_SRGB;
    desc.width = desc.height = TILE;
    desc.texels = pixels;
    desc.tables = SHD_TABLE_MIPMAP;
    return shd_texture_create(context, &desc, out_texture);
}

static shd_result create_materials(shd_context *context, struct scene *scene)
{
    const shd_slot tiles = shd_slot_texture(SHD_SLOT_DIFFUSE, scene->tiles, NULL);
    shd_material_desc floor = shd_material_desc_default(), ball = shd_material_desc_default();
    shd_result result;
    floor.slots = &tiles, floor.slot_count = 1;
    ball.model = SHD_MODEL_BLINN_PHONG;
    ball.ambient[0] = 0.02f, ball.ambient[1] = 0.05f, ball.ambient[2] = 0.06f;
    ball.diffuse[0] = 0.05f, ball.diffuse[1] = 0.3f, ball.diffuse[2] = 0.4f;
    result = shd_material_create(context, &floor, &scene->materials[0]);
    return result == SHD_OK ? shd_material_create(context, &ball, &scene->materials[1]) : result;
}

static shd_result create_lights(shd_context *context, struct scene *scene)
{
    shd_light_desc desc[SCENE_LIGHTS];
    shd_result result = SHD_OK;
    int i, c;
    for (i = 0; i < SCENE_LIGHTS; ++i) desc[i] = shd_light_desc_default();
    desc[0].kind = SHD_LIGHT_KIND_AMBIENT;
    desc[1].kind = SHD_LIGHT_KIND_DIRECTIONAL;
    desc[1].direction[0] = 1.0f, desc[1].direction[1] = -1.5f, desc[1].direction[2] = -0.8f;
    for (c = 0; c < 3; ++c) desc[2].intensity[c] = 6.0f; /* at distance r it gives 6 / r^2 */
    desc[2].position[0] = 2.5f, desc[2].position[1] = 3.0f, desc[2].position[2] = 1.5f;
    for (i = 0; i < SCENE_LIGHTS && result == SHD_OK; ++i) {
        result = shd_light_create(context, &desc[i], &scene->lights[i]);
    }
    return result;
}

shd_result scene_create(shd_context *context, struct scene *scene)
{
    shd_result result = create_tiles(context, &scene->tiles);
    int i;
    if (result == SHD_OK) result = create_floor(context, &scene->meshes[0]);
    if (result == SHD_OK) result = create_ball(context, &scene->meshes[1]);
    if (result == SHD_OK) result = create_materials(context, scene);
    if (result == SHD_OK) result = create_lights(context, scene);
    for (i = 0; i < SCENE_DRAWS; ++i) {
        scene->draws[i] = shd_draw_default();
        scene->draws[i].mesh = scene->meshes[i];
        scene->draws[i].material = scene->materials[i];
    }
    return result;
}

void scene_release(struct scene *scene)
{
    int i;
    for (i = 0; i < SCENE_LIGHTS; ++i) shd_light_release(scene->lights[i]);
    for (i = 0; i < SCENE_DRAWS; ++i) shd_material_release(scene->materials[i]), shd_mesh_release(scene->meshes[i]);
    shd_texture_release(scene->tiles);
}
