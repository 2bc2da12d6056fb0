/* SPDX-License-Identifier: MIT */
/* A fragment program and ambient occlusion, baked into two textures of a torus, which then shade the torus:
 *   cc bake.c $(pkg-config --cflags --libs shd) -lm */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { WIDTH = 512, HEIGHT = 256, TEXELS = WIDTH * HEIGHT };

/* Bands around the axis, from the position in world space. */
static void bands(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        const float band = 0.5f + 0.5f * sinf(25.0f * in->py[i] + 6.0f * in->px[i]);
        out->r[i] = 0.15f + 0.6f * band, out->g[i] = 0.3f + 0.2f * band, out->b[i] = 0.5f - 0.3f * band;
    }
}

struct scene {
    shd_context *context;
    shd_mesh *mesh;
    shd_material *program, *textured;
    shd_framebuffer *atlas, *picture;
    shd_texture *color, *occlusion;
};

static shd_result make_texture(struct scene *s, shd_format format, const void *texels, shd_texture **out)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = format;
    desc.width = WIDTH, desc.height = HEIGHT;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    return shd_texture_create(s->context, &desc, out);
}

/* Colours of the program: one call, as a frame. */
static shd_result bake_color(struct scene *s, const shd_draw *draw, float *memory)
{
    shd_framebuffer_desc target = shd_framebuffer_desc_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_bake_desc bake = shd_bake_desc_default();
    shd_image image = shd_image_default();
    shd_result result;
    target.width = WIDTH, target.height = HEIGHT;
    if ((result = shd_framebuffer_create(s->context, &target, &s->atlas)) != SHD_OK) return result;
    frame.framebuffer = s->atlas;
    frame.draws = draw, frame.draw_count = 1;
    bake.dilation = 4;
    if ((result = shd_bake(s->context, &frame, &bake)) != SHD_OK) return result;
    image.format = SHD_FORMAT_RGBA32F;
    image.width = WIDTH, image.height = HEIGHT;
    image.pixels = memory;
    if ((result = shd_framebuffer_read_color(s->atlas, &image)) != SHD_OK) return result;
    return make_texture(s, SHD_FORMAT_RGBA32F, memory, &s->color);
}

/* Occlusion of the torus by itself, with depth maps. */
static shd_result bake_occlusion(struct scene *s, const shd_draw *draw, float *memory)
{
    const shd_f32_out out = shd_f32_out_column(memory, 0);
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_atlas atlas = shd_occlusion_atlas_default();
    shd_result result;
    atlas.width = WIDTH, atlas.height = HEIGHT;
    atlas.dilation = 4;
    desc.draws = atlas.draws = draw, desc.draw_count = atlas.draw_count = 1;
    if ((result = shd_occlusion_bake(s->context, &desc, &atlas, &out)) != SHD_OK) return result;
    return make_texture(s, SHD_FORMAT_R32F, memory, &s->occlusion);
}

static shd_result render(struct scene *s, shd_draw draw)
{
    shd_framebuffer_desc target = shd_framebuffer_desc_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_material_desc material = shd_material_desc_default();
    shd_light_desc sky = shd_light_desc_default();
    shd_light *light = NULL;
    shd_camera camera = shd_camera_default();
    shd_slot slots[2];
    shd_result result;
    slots[0] = shd_slot_texture(SHD_SLOT_DIFFUSE, s->color, NULL);
    slots[1] = shd_slot_texture(SHD_SLOT_OCCLUSION, s->occlusion, NULL);
    material.slots = slots, material.slot_count = 2;
    material.ambient_share = 1.0f;
    sky.kind = SHD_LIGHT_KIND_AMBIENT;
    target.width = 480, target.height = 320;
    if ((result = shd_material_create(s->context, &material, &s->textured)) != SHD_OK) return result;
    if ((result = shd_framebuffer_create(s->context, &target, &s->picture)) != SHD_OK) return result;
    if ((result = shd_light_create(s->context, &sky, &light)) != SHD_OK) return result;
    draw.material = s->textured;
    camera.eye[1] = 2.0f, camera.eye[2] = 3.2f;
    frame.framebuffer = s->picture;
    frame.camera = &camera;
    frame.draws = &draw, frame.draw_count = 1;
    frame.lights = (const shd_light *const *)&light, frame.light_count = 1;
    result = shd_render(s->context, &frame);
    shd_light_release(light);
    return result;
}

/* The outside of a torus is open and its hole is not. */
static int check(const float *occlusion)
{
    const float outside = occlusion[WIDTH / 2], inside = occlusion[HEIGHT / 2 * WIDTH + WIDTH / 2];
    return fabsf(outside - inside) > 0.15f && fmaxf(outside, inside) > 0.9f;
}

int main(void)
{
    struct scene s = {NULL};
    shd_shape_desc torus = shd_shape_desc_default();
    shd_material_desc desc = shd_material_desc_default();
    shd_draw draw = shd_draw_default();
    float *memory = (float *)malloc(4 * TEXELS * sizeof *memory);
    int good;
    torus.kind = SHD_SHAPE_TORUS;
    torus.tube_radius = 0.45f;
    desc.model = SHD_MODEL_PROGRAM;
    desc.program.fragment = bands;
    good = memory && shd_context_create(NULL, &s.context) == SHD_OK &&
           shd_mesh_create_shape(s.context, &torus, SHD_MESH_NONE, &s.mesh) == SHD_OK &&
           shd_material_create(s.context, &desc, &s.program) == SHD_OK;
    draw.mesh = s.mesh, draw.material = s.program;
    good = good && bake_color(&s, &draw, memory) == SHD_OK && bake_occlusion(&s, &draw, memory) == SHD_OK &&
           check(memory) && render(&s, draw) == SHD_OK;
#ifdef EXAMPLE_HAS_IO
    good = good && shd_framebuffer_save(s.picture, "bake.png", NULL) == SHD_OK && puts("bake.png written") >= 0;
#endif
    if (!good) fprintf(stderr, "bake: wrong occlusion or error: %s\n", shd_last_error());
    shd_texture_release(s.color), shd_texture_release(s.occlusion);
    shd_framebuffer_release(s.atlas), shd_framebuffer_release(s.picture);
    shd_material_release(s.program), shd_material_release(s.textured);
    shd_mesh_release(s.mesh);
    shd_context_release(s.context);
    free(memory);
    return good ? 0 : 1;
}
