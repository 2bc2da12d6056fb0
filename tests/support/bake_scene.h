/* SPDX-License-Identifier: MIT */
/* Bakes and occlusion as numbers, which are equal for every SIMD target and worker count. */
#ifndef SHD_TESTS_SUPPORT_BAKE_SCENE_H
#define SHD_TESTS_SUPPORT_BAKE_SCENE_H

#include "support/check.h"
#include "support/noise.h"

#include <shd/shd.h>

enum { k_bake_width = 157, k_bake_height = 131, k_bake_texels = k_bake_width * k_bake_height };

static inline float shd_bake_random(uint32_t *seed)
{
    shd_noise(seed);
    return (float)(*seed >> 8) * 0x1p-24f;
}

/* Triangles with random corners and texture coordinates: some overlap, some lie outside 0..1, and every seventh has no
   area in texture coordinates. */
static inline shd_mesh *shd_bake_mesh(shd_context *context, uint32_t triangles, uint32_t seed)
{
    static float columns[10][3 * 300];
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    uint32_t i, c;
    assert_true(triangles <= 300);
    for (i = 0; i < 3 * triangles; ++i) {
        const float size = i % 5 == 0 ? 0.4f : 0.2f;
        for (c = 0; c < 6; ++c) columns[c][i] = 4 * shd_bake_random(&seed) - 2;
        for (c = 6; c < 10; ++c) {
            const float middle = i % 3 == 0 ? 1.1f * shd_bake_random(&seed) - 0.05f : columns[c][i / 3 * 3];
            columns[c][i] = middle + size * (shd_bake_random(&seed) - 0.5f);
        }
        if (i % 21 != 0 && i / 3 % 7 == 0) columns[6][i] = columns[6][i / 3 * 3], columns[8][i] = columns[8][i / 3 * 3];
    }
    desc.vertex_count = 3 * triangles;
    for (c = 0; c < 3; ++c) {
        desc.position[c].data = columns[c];
        desc.normal[c].data = columns[3 + c];
    }
    for (c = 0; c < 2; ++c) {
        desc.uv[c].data = columns[6 + c];
        desc.uv1[c].data = columns[8 + c];
    }
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    return mesh;
}

/* A program that shows what it reads. */
static inline void shd_bake_program(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        out->r[i] = in->u[i] + in->px[i];
        out->g[i] = in->v[i] + in->ny[i];
        out->b[i] = in->x[i] + in->dudx[i] + in->u1[i];
        out->a[i] = in->oz[i];
    }
}

/* Every plane of bakes of a program and of a lit material, with both uv sets and dilation. */
static inline uint64_t shd_bake_hash(const shd_context_desc *context_desc)
{
    static uint32_t states[k_bake_texels];
    const shd_aov_flags aovs = SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE | SHD_AOV_POSITION | SHD_AOV_BARYCENTRICS;
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    shd_framebuffer_desc target = shd_framebuffer_desc_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_draw draws[2];
    shd_light_desc light_desc = shd_light_desc_default();
    shd_light *light = NULL;
    shd_mesh *mesh[2];
    shd_material *material[2] = {NULL, NULL};
    uint32_t set, plane;
    shd_assert_ok(shd_context_create(context_desc, &context));
    target.width = k_bake_width;
    target.height = k_bake_height;
    target.aovs = aovs;
    shd_assert_ok(shd_framebuffer_create(context, &target, &frame.framebuffer));
    light_desc.kind = SHD_LIGHT_KIND_POINT;
    light_desc.position[2] = 5;
    shd_assert_ok(shd_light_create(context, &light_desc, &light));
    for (set = 0; set < 2; ++set) {
        shd_material_desc desc = shd_material_desc_default();
        desc.model = set ? SHD_MODEL_BLINN_PHONG : SHD_MODEL_PROGRAM;
        if (set == 0) desc.program.fragment = shd_bake_program;
        desc.flags = set ? SHD_MATERIAL_DOUBLE_SIDED : 0;
        shd_assert_ok(shd_material_create(context, &desc, &material[set]));
        mesh[set] = shd_bake_mesh(context, 40 + 100 * set, 7 + set);
        draws[set] = shd_draw_default();
        draws[set].mesh = mesh[set];
        draws[set].material = material[set];
        draws[set].object_to_world[4] = 0.25f;
    }
    frame.draws = draws;
    frame.draw_count = 2;
    frame.lights = (const shd_light *const *)&light;
    frame.light_count = 1;
    frame.view.eye[2] = 9;
    for (set = 0; set < 2; ++set) {
        shd_bake_desc bake = shd_bake_desc_default();
        shd_bake_stats stats = shd_bake_stats_default();
        bake.uv_set = set;
        bake.dilation = 3 * set;
        bake.states.data = states;
        bake.stats = &stats;
        shd_assert_ok(shd_bake(context, &frame, &bake));
        assert_true(stats.overlapping_texel_count > 100 && stats.outside_triangle_count > 3 &&
                    stats.zero_area_triangle_count > 3);
        hash = shd_hash(hash, states, sizeof states);
        for (plane = 0; plane <= SHD_PLANE_TARGET3_A; ++plane) {
            shd_plane_view view = shd_plane_view_default();
            uint32_t y;
            if (shd_framebuffer_view_plane(frame.framebuffer, (shd_plane)plane, &view) != SHD_OK) continue;
            for (y = 0; y < k_bake_height; ++y) {
                const char *row = (const char *)(view.f32 ? (const void *)view.f32 : view.u32) + y * view.row_stride;
                hash = shd_hash(hash, row, k_bake_width * sizeof(float));
            }
        }
    }
    for (set = 0; set < 2; ++set) {
        shd_material_release(material[set]);
        shd_mesh_release(mesh[set]);
    }
    shd_light_release(light);
    shd_framebuffer_release(frame.framebuffer);
    shd_context_release(context);
    return hash;
}

/* Occlusion by depth maps at vertices and in a texture, and rays that a counting tracer gets. */
static inline void shd_hash_rays(const shd_rays *rays, uint32_t *blocked, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < rays->count; ++i) {
        /* Bits of the directions decide, so that every bit of a ray counts. */
        const float value = rays->dx[i] * 3.7f + rays->dy[i] * 91.3f + rays->dz[i] * 17.9f + rays->ox[i] + rays->oz[i];
        uint32_t bits;
        memcpy(&bits, &value, sizeof bits);
        blocked[i] = bits & 1u;
    }
}

static inline uint64_t shd_occlusion_hash(const shd_context_desc *context_desc)
{
    static float values[k_bake_texels];
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    shd_shape_desc shape = shd_shape_desc_default();
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_atlas atlas = shd_occlusion_atlas_default();
    shd_draw draws[2];
    shd_mesh *mesh[2] = {NULL, NULL};
    shd_mesh_info info = shd_mesh_info_default();
    const shd_f32_out out = {values, 0};
    int pass;
    shd_assert_ok(shd_context_create(context_desc, &context));
    shape.kind = SHD_SHAPE_TORUS;
    shd_assert_ok(shd_mesh_create_shape(context, &shape, SHD_MESH_NONE, &mesh[0]));
    shape = shd_shape_desc_default();
    shape.kind = SHD_SHAPE_TEAPOT;
    shd_assert_ok(shd_mesh_create_shape(context, &shape, SHD_MESH_NONE, &mesh[1]));
    for (pass = 0; pass < 2; ++pass) {
        draws[pass] = shd_draw_default();
        draws[pass].mesh = mesh[pass];
        draws[pass].object_to_world[4] = 0.5f;
        draws[pass].object_to_world[13] = 0.5f * (float)pass;
    }
    shd_assert_ok(shd_mesh_get_info(mesh[1], &info));
    assert_true(info.vertex_count <= k_bake_texels);
    atlas.width = k_bake_width;
    atlas.height = k_bake_height;
    atlas.draws = draws;
    atlas.draw_count = 1;
    atlas.dilation = 2;
    desc.draws = draws;
    desc.draw_count = 2;
    desc.map_size = 150;
    for (pass = 0; pass < 3; ++pass) {
        desc.ray_count = pass == 2 ? 77 : 5;
        desc.seed = (uint32_t)pass;
        desc.radius = pass == 1 ? 0.75f : FLT_MAX;
        desc.tracer.trace = pass == 2 ? shd_hash_rays : NULL;
        shd_assert_ok(shd_occlusion_compute_vertices(context, &desc, &draws[1], &out));
        hash = shd_hash(hash, values, info.vertex_count * sizeof(float));
        shd_assert_ok(shd_occlusion_bake(context, &desc, &atlas, &out));
        hash = shd_hash(hash, values, sizeof values);
    }
    shd_mesh_release(mesh[0]);
    shd_mesh_release(mesh[1]);
    shd_context_release(context);
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_BAKE_SCENE_H */
