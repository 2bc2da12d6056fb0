/* SPDX-License-Identifier: MIT */
/* A teapot carved from a block of stone: a 3D texture in a slot, looked up at the places of the pixels. */
#include <math.h>
#include <stdio.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { EDGE = 96, CELLS = 6, WIDTH = 640, HEIGHT = 400 };

static uint8_t block[EDGE][EDGE][EDGE][4], pixels[HEIGHT][WIDTH][4];

/* A different number in 0..1 at each call. */
static float next(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (float)(*state >> 8) / 16777216.0f;
}

/* The distances from a texel to the two nearest stones, in texels. Each cell of a grid that repeats has one stone. */
static int find_stones(float stone[CELLS * CELLS * CELLS][3], const int texel[3], float distance[2])
{
    const int size = EDGE / CELLS;
    int nearest = 0, i, k;
    distance[0] = distance[1] = (float)EDGE;
    for (i = 0; i < 27; ++i) {
        const int cell[3] = {texel[0] / size + i % 3 - 1, texel[1] / size + i / 3 % 3 - 1, texel[2] / size + i / 9 - 1};
        int index = 0;
        float square = 0, length;
        for (k = 0; k < 3; ++k) index = index * CELLS + (cell[k] + CELLS) % CELLS;
        for (k = 0; k < 3; ++k) {
            const float difference = (float)(cell[k] * size) + stone[index][k] - (float)texel[k];
            square += difference * difference;
        }
        length = sqrtf(square);
        if (length < distance[0]) {
            distance[1] = distance[0], distance[0] = length, nearest = index;
        } else if (length < distance[1]) {
            distance[1] = length;
        }
    }
    return nearest;
}

/* Breccia: each texel has the colour of its nearest stone; light cement fills the gaps. */
static void fill_block(void)
{
    static const float k_colors[5][3] = {{96, 40, 30}, {170, 100, 60}, {58, 54, 60}, {150, 135, 110}, {70, 84, 72}};
    static float stone[CELLS * CELLS * CELLS][3];
    uint32_t seed = 5;
    int at[3], k, c;
    for (k = 0; k < CELLS * CELLS * CELLS; ++k) {
        for (c = 0; c < 3; ++c) stone[k][c] = (float)(EDGE / CELLS) * next(&seed);
    }
    for (at[2] = 0; at[2] < EDGE; ++at[2]) {
        for (at[1] = 0; at[1] < EDGE; ++at[1]) {
            for (at[0] = 0; at[0] < EDGE; ++at[0]) {
                float distance[2], gap;
                uint8_t *const out = block[at[2]][at[1]][at[0]];
                k = find_stones(stone, at, distance);
                gap = fminf(fmaxf(distance[1] - distance[0] - 0.5f, 0.0f), 1.0f); /* 0 in cement, 1 in a stone */
                for (c = 0; c < 3; ++c) {
                    const float grain = 0.85f + 0.3f * next(&seed);
                    out[c] = (uint8_t)(225.0f + gap * (k_colors[k % 5][c] * grain - 225.0f));
                }
                out[3] = 255;
            }
        }
    }
}

/* The block, whose faces are at -2 and 2 in object space. */
static shd_result create_material(shd_context *context, shd_texture **texture, shd_material **out)
{
    shd_texture_desc td = shd_texture_desc_default();
    shd_material_desc md = shd_material_desc_default();
    shd_slot slot;
    shd_result result;
    int c;
    td.format = SHD_FORMAT_RGBA8_SRGB;
    td.kind = SHD_TEXTURE_KIND_3D;
    td.width = td.height = td.depth = EDGE;
    td.texels = block;
    td.tables = SHD_TABLE_MIPMAP;
    result = shd_texture_create(context, &td, texture);
    if (result != SHD_OK) return result;
    slot = shd_slot_texture(SHD_SLOT_DIFFUSE, *texture, NULL); /* NULL: the default sampler repeats the block */
    for (c = 0; c < 3; ++c) slot.place_transform[5 * c] = 0.25f, slot.place_transform[12 + c] = 0.5f;
    md.model = SHD_MODEL_BLINN_PHONG;
    for (c = 0; c < 3; ++c) md.diffuse[c] = 1.0f, md.specular[c] = 0.2f;
    md.exponent = 80.0f;
    md.slots = &slot;
    md.slot_count = 1;
    return shd_material_create(context, &md, out);
}

static shd_result render(shd_context *context, const shd_mesh *mesh, const shd_material *material,
                         const shd_light *const *lights)
{
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_camera camera = shd_camera_default();
    shd_draw draw = shd_draw_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_image image = shd_image_default();
    shd_result result;
    fd.width = WIDTH, fd.height = HEIGHT, fd.sample_count = 8;
    result = shd_framebuffer_create(context, &fd, &framebuffer);
    camera.eye[0] = 1.5f, camera.eye[1] = 4.0f, camera.eye[2] = 7.0f;
    camera.target[1] = 1.0f;
    camera.fov_y = 0.6f;
    draw.mesh = mesh;
    draw.material = material;
    rd.framebuffer = framebuffer;
    rd.camera = &camera;
    rd.draws = &draw, rd.draw_count = 1;
    rd.lights = lights, rd.light_count = 2;
    rd.clear_color[0] = rd.clear_color[1] = rd.clear_color[2] = 0.3f, rd.clear_color[3] = 1.0f;
    if (result == SHD_OK) result = shd_render(context, &rd);
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = WIDTH, image.height = HEIGHT;
    image.pixels = pixels;
    if (result == SHD_OK) result = shd_framebuffer_read_color(framebuffer, &image);
    shd_framebuffer_release(framebuffer);
    return result;
}

/* The middle of the pot shows both cement and dark stones. */
static int is_carved(void)
{
    int low = 255, high = 0, x, y;
    for (y = 3 * HEIGHT / 8; y < 5 * HEIGHT / 8; ++y) {
        for (x = 3 * WIDTH / 8; x < 5 * WIDTH / 8; ++x) {
            if (pixels[y][x][2] < low) low = pixels[y][x][2];
            if (pixels[y][x][2] > high) high = pixels[y][x][2];
        }
    }
    return low < 60 && high > 120;
}

int main(void)
{
    shd_context *context = NULL;
    shd_mesh *mesh = NULL;
    shd_texture *texture = NULL;
    shd_material *material = NULL;
    shd_light *lights[2] = {NULL, NULL};
    shd_shape_desc pot = shd_shape_desc_default();
    shd_light_desc sun = shd_light_desc_default(), sky = shd_light_desc_default();
    int c, good;
    pot.kind = SHD_SHAPE_TEAPOT;
    sun.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    sun.direction[0] = -0.6f, sun.direction[1] = -0.8f, sun.direction[2] = -0.5f;
    sky.kind = SHD_LIGHT_KIND_AMBIENT;
    for (c = 0; c < 3; ++c) sun.intensity[c] = 0.9f, sky.intensity[c] = 0.25f;
    fill_block();
    good = shd_context_create(NULL, &context) == SHD_OK &&
           shd_mesh_create_shape(context, &pot, SHD_MESH_NONE, &mesh) == SHD_OK &&
           create_material(context, &texture, &material) == SHD_OK &&
           shd_light_create(context, &sun, &lights[0]) == SHD_OK &&
           shd_light_create(context, &sky, &lights[1]) == SHD_OK &&
           render(context, mesh, material, (const shd_light *const *)lights) == SHD_OK && is_carved();
#ifdef EXAMPLE_HAS_IO
    if (good) {
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGBA8_SRGB;
        image.width = WIDTH, image.height = HEIGHT;
        image.pixels = pixels;
        good = shd_image_save(&image, "carved.png", NULL) == SHD_OK && printf("carved.png written\n") > 0;
    }
#endif
    if (!good) fprintf(stderr, "carved: wrong picture or error: %s\n", shd_last_error());
    for (c = 0; c < 2; ++c) shd_light_release(lights[c]);
    shd_material_release(material);
    shd_texture_release(texture);
    shd_mesh_release(mesh);
    shd_context_release(context);
    return good ? 0 : 1;
}
