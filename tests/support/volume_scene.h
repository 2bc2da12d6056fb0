/* SPDX-License-Identifier: MIT */
/* 3D textures and volumes as numbers, which are equal for every SIMD target and worker count. */
#ifndef SHD_TESTS_SUPPORT_VOLUME_SCENE_H
#define SHD_TESTS_SUPPORT_VOLUME_SCENE_H

#include <stdlib.h>

#include <shd/shd.h>

#include "support/check.h"

/* Odd sizes, so that levels and blocks end in the middle. */
enum { k_solid_width = 21, k_solid_height = 18, k_solid_depth = 13, k_solid_lookups = 1501 };

/* The quick generator of Numerical Recipes. */
static inline uint32_t shd_solid_bits(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state ^ *state >> 16;
}
static inline float shd_solid_in(uint32_t *state, float low, float high)
{
    return low + (high - low) * (float)(shd_solid_bits(state) >> 8) * 5.9604645e-8f;
}

/* A 3D texture of random texels with a mipmap. */
static inline shd_texture *shd_solid_texture(shd_context *context, shd_format format)
{
    static unsigned char texels[k_solid_width * k_solid_height * k_solid_depth * 16];
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    uint32_t seed = 7;
    size_t i;
    for (i = 0; i + 4 <= sizeof texels; i += 4) {
        const float value = shd_solid_in(&seed, -4, 4);
        const uint32_t bits = shd_solid_bits(&seed) & 0xbbffbbffu; /* as halves finite */
        if (format == SHD_FORMAT_RGBA32F) {
            memcpy(texels + i, &value, 4);
        } else {
            memcpy(texels + i, &bits, 4);
        }
    }
    desc.format = format;
    desc.width = k_solid_width;
    desc.height = k_solid_height;
    desc.kind = SHD_TEXTURE_KIND_3D;
    desc.depth = k_solid_depth;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

/* Lookups of every filter of 3D textures with derivatives, on formats of every kind. */
static inline uint64_t shd_texture3d_hash(const shd_context_desc *context_desc)
{
    static const shd_format k_solid_formats[] = {SHD_FORMAT_R8,  SHD_FORMAT_RGBA8,   SHD_FORMAT_RGBA8_SRGB,
                                                 SHD_FORMAT_R16, SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA32F};
    static const shd_filter k_solid_filters[] = {SHD_FILTER_NEAREST,      SHD_FILTER_BILINEAR,  SHD_FILTER_NEAREST_MIP,
                                                 SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC};
    static float in[9][k_solid_lookups], out[16][k_solid_lookups];
    shd_context *context = NULL;
    uint64_t hash = SHD_HASH_START;
    uint32_t seed = 1;
    size_t t, f, c, i;
    shd_assert_ok(shd_context_create(context_desc, &context));
    for (i = 0; i < k_solid_lookups; ++i) {
        const float scale = ldexpf(1, (int)(shd_solid_bits(&seed) >> 29) - 7);
        for (c = 0; c < 9; ++c) in[c][i] = (c < 3 ? 2.0f : scale) * shd_solid_in(&seed, -1, 1);
    }
    in[2][7] = NAN;
    in[5][8] = INFINITY;
    for (t = 0; t < sizeof k_solid_formats / sizeof k_solid_formats[0]; ++t) {
        shd_texture *texture = shd_solid_texture(context, k_solid_formats[t]);
        for (f = 0; f < sizeof k_solid_filters / sizeof k_solid_filters[0]; ++f) {
            const int smooth = k_solid_filters[f] != SHD_FILTER_NEAREST && k_solid_filters[f] != SHD_FILTER_NEAREST_MIP;
            shd_sampler_desc desc = shd_sampler_desc_default();
            shd_lookups lookups = shd_lookups_default();
            shd_texels texels = shd_texels_default();
            shd_f32_in *const column[9] = {&lookups.u,    &lookups.v,    &lookups.w,    &lookups.dudx, &lookups.dvdx,
                                           &lookups.dwdx, &lookups.dudy, &lookups.dvdy, &lookups.dwdy};
            shd_sampler *sampler = NULL;
            desc.filter = k_solid_filters[f];
            desc.wrap_u = (shd_wrap)(f % 5);
            desc.wrap_v = (shd_wrap)((f + t) % 5);
            desc.wrap_w = (shd_wrap)((2 * f + t) % 5);
            desc.border[1] = 0.75f;
            shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
            lookups.count = k_solid_lookups;
            for (c = 0; c < 9; ++c) column[c]->data = in[c];
            memset(out, 0, sizeof out);
            for (c = 0; c < 4; ++c) {
                texels.channel[c].data = out[c];
                if (smooth) texels.du[c].data = out[4 + c];
                if (smooth) texels.dv[c].data = out[8 + c];
                if (smooth) texels.dw[c].data = out[12 + c];
            }
            shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
            hash = shd_hash(hash, out, sizeof out);
            shd_sampler_release(sampler);
        }
        shd_texture_release(texture);
    }
    shd_context_release(context);
    return hash;
}

/* Densities of a soft ball around the middle of an n^3 texture, in a shell of 0. */
static inline void shd_ball_texels(unsigned char *texels, uint32_t n)
{
    uint32_t x, y, z;
    for (z = 0; z < n; ++z) {
        for (y = 0; y < n; ++y) {
            for (x = 0; x < n; ++x) {
                const float half = 0.5f * (float)n, u = ((float)x + 0.5f - half) / half;
                const float v = ((float)y + 0.5f - half) / half, w = ((float)z + 0.5f - half) / half;
                const float value = 1.2f - 1.6f * (u * u + v * v + w * w);
                texels[(z * n + y) * n + x] = (unsigned char)(value < 0 ? 0 : value > 1 ? 255 : value * 255);
            }
        }
    }
}

/* A frame with a cube inside a shaded ball of density, behind a glowing one. */
enum { k_ball = 24, k_ball_width = 97, k_ball_height = 70 };
typedef struct shd_ball_scene {
    shd_context *context;
    shd_texture *texture;
    shd_material *material;
    shd_light *light;
    shd_volume *volume[2];
    shd_mesh *mesh;
    shd_framebuffer *framebuffer;
    shd_volume_draw placed[2];
    shd_draw draw;
    shd_camera camera;
    shd_render_desc desc;
} shd_ball_scene;

static inline shd_mesh *shd_ball_cube(shd_context *context)
{
    shd_shape_desc shape = shd_shape_desc_default();
    shd_mesh *mesh = NULL;
    shape.kind = SHD_SHAPE_BOX;
    shape.size[0] = shape.size[1] = shape.size[2] = 0.7f;
    shd_assert_ok(shd_mesh_create_shape(context, &shape, SHD_MESH_NONE, &mesh));
    return mesh;
}

static inline void shd_ball_open(shd_ball_scene *s, const shd_context_desc *context_desc, uint32_t samples)
{
    static const float k_density[3] = {0.05f, 0.4f, 1.0f}, k_extinction[3] = {0.0f, 2.0f, 12.0f};
    static const float k_red[3] = {1.0f, 0.9f, 0.8f}, k_blue[3] = {0.1f, 0.4f, 0.9f};
    static unsigned char texels[k_ball * k_ball * k_ball];
    shd_texture_desc texture = shd_texture_desc_default();
    shd_material_desc material = shd_material_desc_default();
    shd_light_desc light = shd_light_desc_default();
    shd_volume_desc volume = shd_volume_desc_default();
    shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
    int c;
    memset(s, 0, sizeof *s);
    shd_assert_ok(shd_context_create(context_desc, &s->context));
    shd_ball_texels(texels, k_ball);
    texture.format = SHD_FORMAT_R8;
    texture.kind = SHD_TEXTURE_KIND_3D;
    texture.width = texture.height = texture.depth = k_ball;
    texture.texels = texels;
    shd_assert_ok(shd_texture_create(s->context, &texture, &s->texture));
    material.model = SHD_MODEL_BLINN_PHONG;
    material.exponent = 20.0f;
    material.specular[0] = material.specular[1] = material.specular[2] = 0.4f;
    shd_assert_ok(shd_material_create(s->context, &material, &s->material));
    light.position[0] = 3.0f;
    light.position[1] = 4.0f;
    light.position[2] = 5.0f;
    light.intensity[0] = light.intensity[1] = light.intensity[2] = 60.0f;
    shd_assert_ok(shd_light_create(s->context, &light, &s->light));
    volume.texture = s->texture;
    volume.point_count = 3;
    volume.density = shd_f32_column(k_density, 0);
    volume.extinction = shd_f32_column(k_extinction, 0);
    volume.color[0] = shd_f32_column(k_red, 0);
    volume.color[2] = shd_f32_column(k_blue, 0);
    for (c = 0; c < 3; ++c) volume.bounds_min[c] = -1.0f;
    volume.step = 0.04f;
    shd_assert_ok(shd_volume_create(s->context, &volume, &s->volume[1]));
    volume.material = s->material;
    volume.jitter = 1.0f;
    volume.seed = 3;
    shd_assert_ok(shd_volume_create(s->context, &volume, &s->volume[0]));
    s->mesh = shd_ball_cube(s->context);
    framebuffer.width = k_ball_width;
    framebuffer.height = k_ball_height;
    framebuffer.sample_count = samples;
    shd_assert_ok(shd_framebuffer_create(s->context, &framebuffer, &s->framebuffer));
    s->camera = shd_camera_default();
    s->camera.eye[0] = 1.5f;
    s->camera.eye[1] = 1.0f;
    s->camera.eye[2] = 3.2f;
    for (c = 0; c < 2; ++c) {
        s->placed[c] = shd_volume_draw_default();
        s->placed[c].volume = s->volume[c];
    }
    s->placed[1].object_to_world[0] = 0.3f;
    s->placed[1].object_to_world[5] = 0.5f;
    s->placed[1].object_to_world[10] = 0.4f;
    s->placed[1].object_to_world[4] = 0.1f; /* sheared */
    s->placed[1].object_to_world[13] = -0.3f;
    s->placed[1].object_to_world[14] = 1.7f;
    s->draw = shd_draw_default();
    s->draw.mesh = s->mesh;
    s->draw.material = s->material;
    s->desc = shd_render_desc_default();
    s->desc.framebuffer = s->framebuffer;
    s->desc.camera = &s->camera;
    s->desc.draws = &s->draw;
    s->desc.draw_count = 1;
    s->desc.lights = (const shd_light *const *)&s->light;
    s->desc.light_count = 1;
    s->desc.volumes = s->placed;
    s->desc.volume_count = 2;
    s->desc.clear_color[2] = 0.25f;
}

static inline void shd_ball_close(shd_ball_scene *s)
{
    shd_framebuffer_release(s->framebuffer);
    shd_mesh_release(s->mesh);
    shd_volume_release(s->volume[0]);
    shd_volume_release(s->volume[1]);
    shd_light_release(s->light);
    shd_material_release(s->material);
    shd_texture_release(s->texture);
    shd_context_release(s->context);
}

/* Renders the scene, and returns the hash of its colour. The planes have k_ball_width x k_ball_height pixels. */
static inline uint64_t shd_ball_render(shd_ball_scene *s, float (*plane)[k_ball_width * k_ball_height])
{
    uint64_t hash = SHD_HASH_START;
    size_t c;
    shd_assert_ok(shd_render(s->context, &s->desc));
    for (c = 0; c < 5; ++c) {
        const shd_f32_out column = {plane[c], 0};
        shd_assert_ok(shd_framebuffer_read_plane(s->framebuffer, (shd_plane)c, &column));
        hash = shd_hash(hash, plane[c], sizeof plane[c]);
    }
    return hash;
}

/* Frames of the scene with one and with four samples a pixel. */
static inline uint64_t shd_volume_hash(const shd_context_desc *context_desc)
{
    static float planes[5][k_ball_width * k_ball_height];
    uint64_t hash = SHD_HASH_START;
    uint32_t samples;
    for (samples = 1; samples <= 4; samples += 3) {
        shd_ball_scene scene;
        uint64_t frame;
        shd_ball_open(&scene, context_desc, samples);
        frame = shd_ball_render(&scene, planes);
        hash = shd_hash(hash, &frame, sizeof frame);
        shd_ball_close(&scene);
    }
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_VOLUME_SCENE_H */
