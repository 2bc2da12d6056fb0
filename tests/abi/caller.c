/* SPDX-License-Identifier: MIT */
/* A program that passes every sized struct, in and out, to the library. It is compiled three times: with the current
 * headers, with headers of an older version (SHD_TEST_OLDER: fewer fields at the end of every struct) and with headers
 * of a newer version (SHD_TEST_NEWER: another field, `added`). Each struct has its own memory, with canaries behind
 * it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <shd/color.h>
#include <shd/scene.h>
#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/tile_file.h>
#include <shd/volume_file.h>

#include "../../src/core/sized_structs.h"

enum { CANARY = 96, BLOCKS = 256, EDGE = 16 };

static struct block {
    unsigned char *memory;
    size_t size;
    const char *name;
} g_blocks[BLOCKS];
static size_t g_count;
static int g_failures;

static void expect(int is_true, const char *what)
{
    if (is_true) return;
    printf("%s: %s\n", what, shd_last_error());
    ++g_failures;
}

/* Memory of exactly `size` bytes with canaries behind. */
static void *guarded(const char *name, size_t size)
{
    struct block *block = &g_blocks[g_count++];
    if (g_count > BLOCKS || !(block->memory = (unsigned char *)malloc(size + CANARY))) exit(1);
    memset(block->memory, 0xa5, size + CANARY);
    block->size = size;
    block->name = name;
    return block->memory;
}

static void check_canaries(void)
{
    size_t i, k;
    for (i = 0; i < g_count; ++i) {
        for (k = 0; k < CANARY && g_blocks[i].memory[g_blocks[i].size + k] == 0xa5; ++k) {
        }
        if (k < CANARY) printf("%s: byte %zu behind it was written\n", g_blocks[i].name, k), ++g_failures;
        free(g_blocks[i].memory);
    }
}

/* A struct of the caller with its defaults. */
#define MAKE(type, name)                                     \
    const type name##_value = type##_default();              \
    type *const name = (type *)guarded(#type, sizeof *name); \
    *name = name##_value

/* The added field is refused in structs that the library reads, and cleared in structs that it writes. */
#ifdef SHD_TEST_NEWER
static const uint32_t k_zero[4];
#define LAST(desc) (&(desc)->added[sizeof(desc)->added / sizeof(desc)->added[0] - 1])
#define EXPECT_READ(desc, call)                                                              \
    do {                                                                                     \
        *LAST(desc) = 1;                                                                     \
        expect((call) == SHD_ERROR_UNSUPPORTED && strstr(shd_last_error(), "byte "), #call); \
        *LAST(desc) = 0;                                                                     \
    } while (0)
#define SPOIL(desc) memset((desc)->added, 0x77, sizeof(desc)->added)
#define EXPECT_CLEARED(desc) expect(!memcmp((desc)->added, k_zero, sizeof(desc)->added), #desc " is cleared")
#else
#define EXPECT_READ(desc, call) (void)0
#define SPOIL(desc) (void)0
#define EXPECT_CLEARED(desc) (void)0
#endif
#define EXPECT_WRITTEN(desc, is_right)                                                    \
    do {                                                                                  \
        expect((desc)->struct_size == sizeof *(desc) && (is_right), #desc " is written"); \
        EXPECT_CLEARED(desc);                                                             \
    } while (0)

/* The defaults that the library writes into the structs of these headers. */
static void use_kinds(void)
{
#define USE_KIND(kind, type, required, last, size)                                                       \
    do {                                                                                                 \
        type *const desc = (type *)guarded(#type " of shd_desc_init()", sizeof *desc);                   \
        expect(shd_desc_init(SHD_DESC_KIND_##kind, desc, sizeof *desc) == SHD_OK, "defaults of " #type); \
        EXPECT_WRITTEN(desc, 1);                                                                         \
    } while (0);
    SHD_SIZED_STRUCTS(USE_KIND)
}

static shd_context *g_context;
static shd_texture *g_texture;
static shd_sampler *g_sampler;
static shd_mesh *g_mesh;
static shd_framebuffer *g_framebuffer;

static void use_context(void)
{
    MAKE(shd_context_desc, desc);
    desc->worker_count = 1;
    EXPECT_READ(desc, shd_context_create(desc, &g_context));
    expect(shd_context_create(desc, &g_context) == SHD_OK, "context");
}

static void use_texture(void)
{
    static const unsigned char texels[4 * 4] = {128, 128, 128, 128, 128, 128, 128, 128,
                                                128, 128, 128, 128, 128, 128, 128, 128};
    unsigned char pixels[2 * 2];
    MAKE(shd_texture_desc, desc);
    MAKE(shd_texture_info, info);
    MAKE(shd_image, image);
    MAKE(shd_sampler_desc, sampler);
    desc->format = SHD_FORMAT_R8;
    desc->width = desc->height = 4;
    desc->texels = texels;
    desc->tables = SHD_TABLE_MIPMAP;
    desc->swizzle[1] = desc->swizzle[2] = SHD_CHANNEL_R;
    EXPECT_READ(desc, shd_texture_create(g_context, desc, &g_texture));
    expect(shd_texture_create(g_context, desc, &g_texture) == SHD_OK, "texture");
    SPOIL(info);
    expect(shd_texture_get_info(g_texture, info) == SHD_OK, "texture info");
    EXPECT_WRITTEN(info, info->width == 4 && info->height == 4 && info->format == SHD_FORMAT_R8);
    expect(shd_texture_get_info(NULL, info) != SHD_OK, "no texture");
    EXPECT_WRITTEN(info, info->width == 0 && info->format == SHD_FORMAT_NONE);
    image->format = SHD_FORMAT_R8;
    image->width = image->height = 2;
    image->pixels = pixels;
    EXPECT_READ(image, shd_texture_read_level(g_texture, 0, 1, image));
    expect(shd_texture_read_level(g_texture, 0, 1, image) == SHD_OK && pixels[3] == 128, "level");
    EXPECT_READ(sampler, shd_sampler_create(g_context, sampler, &g_sampler));
    expect(shd_sampler_create(g_context, sampler, &g_sampler) == SHD_OK, "sampler");
}

static void use_table(void)
{
    float red[4 * 4];
    shd_f32_out out[4];
    MAKE(shd_table_desc, desc);
    MAKE(shd_table_info, info);
    memset(out, 0, sizeof out);
    out[0] = shd_f32_out_column(red, 0);
    desc->table = SHD_TABLE_MIPMAP;
    SPOIL(info);
    EXPECT_READ(desc, shd_texture_get_table_info(g_texture, desc, info));
    expect(shd_texture_get_table_info(g_texture, desc, info) == SHD_OK, "table info");
    EXPECT_WRITTEN(info, info->width == 4 && info->height == 4);
    EXPECT_READ(desc, shd_texture_read_table(g_texture, desc, out));
    expect(shd_texture_read_table(g_texture, desc, out) == SHD_OK && red[15] > 0.5f, "table");
}

static void use_normals(const shd_image *heights)
{
    unsigned char pixels[4 * 4 * 3];
    MAKE(shd_image, image);
    MAKE(shd_normals_desc, desc);
    image->format = SHD_FORMAT_RGB8;
    image->width = image->height = 4;
    image->pixels = pixels;
    EXPECT_READ(desc, shd_mip_build_normals(g_context, heights, desc, image));
    expect(shd_mip_build_normals(g_context, heights, desc, image) == SHD_OK && pixels[2] == 255, "normals of heights");
}

/* Two images in an array, which lie struct_size apart. */
static void use_mip(void)
{
    static const unsigned char base[4 * 4] = {8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8};
    unsigned char pixels[5];
    shd_image *const levels = (shd_image *)guarded("shd_image[2]", 2 * sizeof *levels);
    MAKE(shd_image, image);
    MAKE(shd_mip_desc, desc);
    int l;
    image->format = SHD_FORMAT_R8;
    image->width = image->height = 4;
    image->pixels = (void *)base;
    for (l = 0; l < 2; ++l) {
        levels[l] = *image;
        levels[l].width = levels[l].height = l ? 1 : 2;
        levels[l].pixels = l ? pixels + 4 : pixels;
    }
    EXPECT_READ(desc, shd_mip_build(g_context, image, desc, 2, levels));
    EXPECT_READ(levels + 1, shd_mip_build(g_context, image, desc, 2, levels));
    expect(shd_mip_build(g_context, image, desc, 2, levels) == SHD_OK && pixels[4] == 8, "mip levels");
    use_normals(image);
}

static void use_lookups(void)
{
    static const float u[3] = {0.1f, 0.5f, 0.9f}, bad[3] = {0, INFINITY, 0};
    float red[3], lod[3];
    shd_tap *const taps = (shd_tap *)guarded("shd_tap[2]", 2 * sizeof *taps);
    shd_blend_step *const blends = (shd_blend_step *)guarded("shd_blend_step[2]", 2 * sizeof *blends);
    MAKE(shd_lookups, lookups);
    MAKE(shd_texels, texels);
    MAKE(shd_levels, levels);
    MAKE(shd_explanation, explanation);
    lookups->count = 3;
    lookups->u = lookups->v = shd_f32_column(u, 0);
    lookups->dudx = shd_f32_column(bad, 0);
    texels->channel[0] = shd_f32_out_column(red, 0);
    EXPECT_READ(lookups, shd_texture_sample(g_texture, g_sampler, lookups, texels));
    EXPECT_READ(texels, shd_texture_sample(g_texture, g_sampler, lookups, texels));
    expect(shd_texture_sample(g_texture, g_sampler, lookups, texels) == SHD_OK, "sample");
    expect(fabsf(red[0] - 128 / 255.0f) < 1e-6f, "texel");
#ifndef SHD_TEST_OLDER
    expect(texels->nonfinite_count == 1, "count of lookups that are not finite");
#endif
    levels->lod = shd_f32_out_column(lod, 0);
    EXPECT_READ(levels, shd_texture_query_levels(g_texture, g_sampler, lookups, levels));
    expect(shd_texture_query_levels(g_texture, g_sampler, lookups, levels) == SHD_OK && lod[1] == 2, "levels");
    explanation->taps = taps;
    explanation->blends = blends;
    explanation->tap_capacity = explanation->blend_capacity = 2;
    EXPECT_READ(explanation, shd_texture_explain(g_texture, g_sampler, lookups, 0, explanation));
    expect(shd_texture_explain(g_texture, g_sampler, lookups, 0, explanation) == SHD_OK, "explain");
    EXPECT_WRITTEN(explanation, explanation->tap_count == 4 && explanation->blend_count == 3);
    expect(taps[1].value[0] == 128 && blends[1].a < 7, "second elements of the explanation");
}

static void use_footprint(void)
{
    static const float one[1] = {1}, zero[1] = {0};
    float dudx[1] = {7};
    int c;
    MAKE(shd_ray_differentials, rays);
    MAKE(shd_ray_cones, cones);
    MAKE(shd_derivatives, derivatives);
    rays->count = cones->count = 1;
    for (c = 0; c < 3; ++c) {
        rays->dpdu[c] = cones->dpdu[c] = shd_f32_column(c == 0 ? one : zero, 0);
        rays->dpdv[c] = cones->dpdv[c] = shd_f32_column(c == 1 ? one : zero, 0);
        rays->direction[c] = cones->direction[c] = shd_f32_column(c == 2 ? one : zero, 0);
    }
    rays->origin_dx[0] = cones->width = shd_f32_column(one, 0);
    derivatives->dudx = shd_f32_out_column(dudx, 0);
    EXPECT_READ(rays, shd_derivatives_from_differentials(g_context, rays, derivatives));
    EXPECT_READ(derivatives, shd_derivatives_from_differentials(g_context, rays, derivatives));
    expect(shd_derivatives_from_differentials(g_context, rays, derivatives) == SHD_OK && dudx[0] == 1,
           "ray differentials");
    EXPECT_READ(cones, shd_derivatives_from_cones(g_context, cones, derivatives));
    expect(shd_derivatives_from_cones(g_context, cones, derivatives) == SHD_OK, "ray cones");
}

static void use_polygon(void)
{
    static const float x[3] = {0, 1, 0}, y[3] = {0, 0, 1}, quarter[1] = {0.25f};
    float value[3] = {7, 7, 7};
    shd_f32_out columns[3];
    int i;
    MAKE(shd_polygon_desc, desc);
    MAKE(shd_polygon_points, points);
    MAKE(shd_polygon_weights, weights);
    desc->vertex[0] = shd_f32_column(x, 0);
    desc->vertex[1] = shd_f32_column(y, 0);
    desc->vertex_count = 3;
    points->count = 1;
    points->position[0] = points->position[1] = shd_f32_column(quarter, 0);
    for (i = 0; i < 3; ++i) columns[i] = shd_f32_out_column(value + i, 0);
    weights->weight = columns;
    weights->weight_count = 3;
    EXPECT_READ(desc, shd_polygon_evaluate(g_context, desc, points, weights));
    EXPECT_READ(points, shd_polygon_evaluate(g_context, desc, points, weights));
    EXPECT_READ(weights, shd_polygon_evaluate(g_context, desc, points, weights));
    expect(shd_polygon_evaluate(g_context, desc, points, weights) == SHD_OK, "polygon");
    expect(value[0] == 0.5f && value[1] == 0.25f && value[2] == 0.25f, "weights of a triangle");
}

static void use_polyhedron(void)
{
    static const float x[4] = {0, 1, 0, 0}, y[4] = {0, 0, 1, 0}, z[4] = {0, 0, 0, 1}, eighth[1] = {0.125f};
    static const uint32_t indices[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    float value[4] = {7, 7, 7, 7}, sum[1] = {7};
    shd_f32_out columns[4];
    shd_f32_in vertex_value;
    shd_f32_out sums;
    shd_polyhedron *polyhedron = NULL;
    int i;
    MAKE(shd_polyhedron_desc, desc);
    MAKE(shd_polyhedron_points, points);
    MAKE(shd_polyhedron_weights, weights);
    MAKE(shd_polyhedron_values, values);
    desc->vertex_count = 4;
    desc->index_count = 12;
    desc->position[0] = shd_f32_column(x, 0);
    desc->position[1] = shd_f32_column(y, 0);
    desc->position[2] = shd_f32_column(z, 0);
    desc->indices = shd_u32_column(indices, 0);
    points->count = 1;
    points->position[0] = points->position[1] = points->position[2] = shd_f32_column(eighth, 0);
    for (i = 0; i < 4; ++i) columns[i] = shd_f32_out_column(value + i, 0);
    weights->weight = columns;
    weights->weight_count = 4;
    vertex_value = shd_f32_column(x, 0);
    sums = shd_f32_out_column(sum, 0);
    values->value_count = 1;
    values->vertex_value = &vertex_value;
    values->value = &sums;
    EXPECT_READ(desc, shd_polyhedron_create(g_context, desc, &polyhedron));
    expect(shd_polyhedron_create(g_context, desc, &polyhedron) == SHD_OK, "polyhedron");
    EXPECT_READ(points, shd_polyhedron_evaluate(polyhedron, points, weights));
    EXPECT_READ(weights, shd_polyhedron_evaluate(polyhedron, points, weights));
    EXPECT_READ(values, shd_polyhedron_interpolate(polyhedron, points, values));
    expect(shd_polyhedron_evaluate(polyhedron, points, weights) == SHD_OK, "weights of a polyhedron");
    expect(fabsf(value[0] - 0.625f) < 1e-6f && fabsf(value[1] - 0.125f) < 1e-6f, "weights of a tetrahedron");
    expect(shd_polyhedron_interpolate(polyhedron, points, values) == SHD_OK, "values of a polyhedron");
    expect(fabsf(sum[0] - 0.125f) < 1e-6f, "values of a tetrahedron");
    shd_polyhedron_release(polyhedron);
}

static void use_solid(void)
{
    static const float x[2] = {0.5f, 1.5f};
    float value[2] = {7, 7};
    int c;
    MAKE(shd_solid_desc, desc);
    MAKE(shd_solid_points, points);
    MAKE(shd_solid_values, values);
    points->count = 2;
    for (c = 0; c < 3; ++c) points->position[c] = shd_f32_column(x, 0);
    values->value = shd_f32_out_column(value, 0);
    EXPECT_READ(desc, shd_solid_evaluate(g_context, desc, points, values));
    EXPECT_READ(points, shd_solid_evaluate(g_context, desc, points, values));
    EXPECT_READ(values, shd_solid_evaluate(g_context, desc, points, values));
    expect(shd_solid_evaluate(g_context, desc, points, values) == SHD_OK, "solid texture");
    expect(value[0] == 0 && value[1] == 1, "stripes");
}

static void use_shapes(void)
{
    float x[4] = {0};
    size_t vertices = 0, indices = 0;
    MAKE(shd_shape_desc, desc);
    MAKE(shd_shape_columns, columns);
    desc->kind = SHD_SHAPE_PLANE;
    EXPECT_READ(desc, shd_shape_count(desc, &vertices, &indices));
    expect(shd_shape_count(desc, &vertices, &indices) == SHD_OK && vertices == 4 && indices == 6, "shape");
    columns->vertex_count = vertices;
    columns->position[0] = shd_f32_out_column(x, 0);
    EXPECT_READ(desc, shd_shape_fill(desc, columns));
    EXPECT_READ(columns, shd_shape_fill(desc, columns));
    expect(shd_shape_fill(desc, columns) == SHD_OK && fabsf(x[3]) == 1, "columns of a shape");
}

static void use_mesh(void)
{
    static const float vertices[6][5] = {{-1, -1, 0, 0, 1}, {1, -1, 0, 1, 1}, {1, 1, 0, 1, 0},
                                         {-1, -1, 0, 0, 1}, {1, 1, 0, 1, 0},  {-1, 1, 0, 0, 0}};
    uint32_t ends[8];
    size_t count = 0;
    int c;
    shd_mesh *fine = NULL;
    MAKE(shd_mesh_desc, desc);
    MAKE(shd_mesh_info, info);
    MAKE(shd_edges_desc, edges_desc);
    MAKE(shd_edges, edges);
    MAKE(shd_tessellation_desc, tessellation);
    desc->vertex_count = 6;
    desc->flags = SHD_MESH_ADJACENCY;
    for (c = 0; c < 3; ++c) desc->position[c] = shd_f32_column(&vertices[0][c], sizeof vertices[0]);
    for (c = 0; c < 2; ++c) desc->uv[c] = shd_f32_column(&vertices[0][3 + c], sizeof vertices[0]);
    EXPECT_READ(desc, shd_mesh_create(g_context, desc, &g_mesh));
    expect(shd_mesh_create(g_context, desc, &g_mesh) == SHD_OK, "mesh");
    SPOIL(info);
    expect(shd_mesh_get_info(g_mesh, info) == SHD_OK, "mesh info");
    EXPECT_WRITTEN(info, info->triangle_count == 2 && info->bounds_max[0] == 1);
    edges->vertex[0] = shd_u32_out_column(ends, 0);
    EXPECT_READ(edges_desc, shd_mesh_find_edges(g_mesh, edges_desc, 8, edges, &count));
    EXPECT_READ(edges, shd_mesh_find_edges(g_mesh, edges_desc, 8, edges, &count));
    expect(shd_mesh_find_edges(g_mesh, edges_desc, 8, edges, &count) == SHD_OK && count == 4, "edges");
    tessellation->segments = 2;
    EXPECT_READ(tessellation, shd_mesh_tessellate(g_context, g_mesh, tessellation, &fine));
    expect(shd_mesh_tessellate(g_context, g_mesh, tessellation, &fine) == SHD_OK, "tessellation");
    expect(shd_mesh_get_info(fine, info) == SHD_OK && info->triangle_count == 8, "tessellated mesh");
    shd_mesh_release(fine);
}

static void glow(const shd_fragments *in, float *const out[4], void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) out[0][i] = 0.25f;
}

/* Two slots and two draws in arrays. */
static shd_material *make_material(void)
{
    shd_slot *const slots = (shd_slot *)guarded("shd_slot[2]", 2 * sizeof *slots);
    shd_material *material = NULL;
    MAKE(shd_material_desc, desc);
    slots[0] = shd_slot_procedure(SHD_SLOT_EMISSION, glow, NULL);
    slots[1] = shd_slot_texture(SHD_SLOT_DIFFUSE, g_texture, g_sampler);
    desc->model = SHD_MODEL_UNLIT;
    desc->diffuse[0] = desc->emission[0] = 1;
    desc->slots = slots;
    desc->slot_count = 2;
    EXPECT_READ(desc, shd_material_create(g_context, desc, &material));
    EXPECT_READ(slots + 1, shd_material_create(g_context, desc, &material));
    expect(shd_material_create(g_context, desc, &material) == SHD_OK, "material");
    return material;
}

static shd_light *make_light(void)
{
    shd_light *light = NULL;
    MAKE(shd_light_desc, desc);
    desc->kind = SHD_LIGHT_KIND_DIRECTIONAL;
    desc->direction[2] = -1;
    EXPECT_READ(desc, shd_light_create(g_context, desc, &light));
    expect(shd_light_create(g_context, desc, &light) == SHD_OK, "light");
    return light;
}

static void use_shadow(const shd_light *light, const shd_draw *draws)
{
    static const float zero[1] = {0};
    float visible[1] = {7};
    shd_shadow *shadow = NULL;
    int c;
    MAKE(shd_shadow_desc, desc);
    MAKE(shd_shadow_render_desc, render);
    MAKE(shd_shadow_lookups, lookups);
    MAKE(shd_shadow_values, values);
    MAKE(shd_shadow_info, info);
    EXPECT_READ(desc, shd_shadow_create(g_context, desc, &shadow));
    expect(shd_shadow_create(g_context, desc, &shadow) == SHD_OK, "shadow");
    render->light = light;
    render->draws = draws;
    render->draw_count = 2;
    EXPECT_READ(render, shd_shadow_render(g_context, shadow, render));
    expect(shd_shadow_render(g_context, shadow, render) == SHD_OK, "shadow map");
    SPOIL(info);
    expect(shd_shadow_get_info(shadow, info) == SHD_OK, "shadow info");
    EXPECT_WRITTEN(info, info->width == 1024 && info->height == 1024);
    lookups->count = 1;
    for (c = 0; c < 3; ++c) lookups->position[c] = shd_f32_column(zero, 0);
    values->visibility = shd_f32_out_column(visible, 0);
    EXPECT_READ(lookups, shd_shadow_sample(shadow, lookups, values));
    EXPECT_READ(values, shd_shadow_sample(shadow, lookups, values));
    expect(shd_shadow_sample(shadow, lookups, values) == SHD_OK && visible[0] <= 1, "shadow lookups");
    shd_shadow_release(shadow);
}

static void make_framebuffer(void)
{
    MAKE(shd_framebuffer_desc, desc);
    MAKE(shd_framebuffer_info, info);
    desc->width = desc->height = EDGE;
    EXPECT_READ(desc, shd_framebuffer_create(g_context, desc, &g_framebuffer));
    expect(shd_framebuffer_create(g_context, desc, &g_framebuffer) == SHD_OK, "framebuffer");
    SPOIL(info);
    expect(shd_framebuffer_get_info(g_framebuffer, info) == SHD_OK, "framebuffer info");
    EXPECT_WRITTEN(info, info->width == EDGE && info->sample_count == 1);
}

static void use_render(void)
{
    shd_material *const material = make_material();
    shd_light *light = make_light();
    shd_draw *const draws = (shd_draw *)guarded("shd_draw[2]", 2 * sizeof *draws);
    MAKE(shd_camera, camera);
    MAKE(shd_render_desc, desc);
    MAKE(shd_render_stats, stats);
    MAKE(shd_plane_view, view);
    int i;
    make_framebuffer();
    for (i = 0; i < 2; ++i) {
        draws[i] = shd_draw_default();
        draws[i].mesh = g_mesh;
        draws[i].material = material;
        draws[i].object_to_world[12] = i ? 0.0f : 50.0f;
    }
    EXPECT_READ(camera, shd_view_from_camera(camera, &desc->view));
    expect(shd_view_from_camera(camera, &desc->view) == SHD_OK, "camera");
    desc->framebuffer = g_framebuffer;
    desc->draws = draws;
    desc->draw_count = 2;
    desc->lights = (const shd_light *const *)&light;
    desc->light_count = 1;
    desc->stats = stats;
    EXPECT_READ(desc, shd_render(g_context, desc));
    EXPECT_READ(draws + 1, shd_render(g_context, desc));
    SPOIL(stats);
    expect(shd_render(g_context, desc) == SHD_OK, "frame");
    EXPECT_WRITTEN(stats, stats->triangle_count == 4 && stats->outside_triangle_count == 2 &&
                              stats->rasterized_triangle_count == 2);
    SPOIL(view);
    expect(shd_framebuffer_view_plane(g_framebuffer, SHD_PLANE_R, view) == SHD_OK, "view of a plane");
    EXPECT_WRITTEN(view, view->f32 && !view->u32);
    {
        float red[EDGE * EDGE];
        const shd_f32_out out = shd_f32_out_column(red, 0);
        expect(shd_framebuffer_read_plane(g_framebuffer, SHD_PLANE_R, &out) == SHD_OK, "plane");
        expect(fabsf(red[EDGE * EDGE / 2 + EDGE / 2] - (0.25f + 128 / 255.0f)) < 1e-5f, "both slots are read");
    }
    desc->camera = camera;
    EXPECT_READ(camera, shd_render(g_context, desc));
    expect(shd_render(g_context, desc) == SHD_OK, "frame of a camera");
    EXPECT_WRITTEN(stats, stats->rasterized_triangle_count == 2);
    use_shadow(light, draws);
    shd_light_release(light);
    shd_material_release(material);
}

#ifndef SHD_TEST_OLDER /* the first layout of shd_texture_desc has no tiles */
static shd_result load_black(const shd_tile *tiles, size_t count, void *user_data)
{
    (void)user_data;
    (void)count;
    memset(tiles->texels, 0, tiles->row_stride * tiles->area.height);
    return SHD_OK;
}

/* A texture of one texel. */
static void use_tiled_texture(shd_tile_cache *cache)
{
    shd_texture *texture = NULL;
    MAKE(shd_texture_desc, desc);
    MAKE(shd_tile_region, region);
    desc->format = SHD_FORMAT_RGBA8;
    desc->width = desc->height = 1;
    desc->tiles.cache = cache;
    desc->tiles.load = load_black;
    expect(shd_texture_create(g_context, desc, &texture) == SHD_OK, "texture in tiles");
    region->area.width = region->area.height = 1;
    EXPECT_READ(region, shd_texture_pin_tiles(texture, region));
    expect(shd_texture_load_tiles(texture, region) == SHD_OK, "tiles");
    shd_texture_release(texture);
}
#endif

static void use_tiles(void)
{
    shd_tile_cache *cache = NULL;
    MAKE(shd_tile_cache_desc, desc);
    MAKE(shd_tile_cache_stats, stats);
    EXPECT_READ(desc, shd_tile_cache_create(g_context, desc, &cache));
    expect(shd_tile_cache_create(g_context, desc, &cache) == SHD_OK, "tile cache");
#ifndef SHD_TEST_OLDER
    use_tiled_texture(cache);
#endif
    SPOIL(stats);
    expect(shd_tile_cache_get_stats(cache, stats) == SHD_OK, "tile cache stats");
    EXPECT_WRITTEN(stats, stats->resident_tile_count == 0);
    shd_tile_cache_release(cache);
}

static void use_color(void)
{
#ifdef SHD_TEST_COLOR
    shd_color *color = NULL;
    MAKE(shd_color_desc, desc);
    EXPECT_READ(desc, shd_color_create(g_context, desc, &color));
    expect(shd_color_create(g_context, desc, &color) == SHD_OK && shd_color_get_display_count(color) > 0, "color");
    shd_color_release(color);
#endif
}

#ifdef SHD_TEST_IO
/* The picture as a stack of one slice, and then a file of 30 voxels. */
static void use_volume_files(const char *path)
{
    shd_texture *texture = NULL;
    FILE *file;
    MAKE(shd_stack_desc, stack);
    MAKE(shd_raw_desc, raw);
    MAKE(shd_vdb_desc, vdb);
    MAKE(shd_vdb_info, info);
    MAKE(shd_load_desc, load);
    stack->paths = &path;
    stack->path_count = 1;
    load->stack = stack;
    EXPECT_READ(stack, shd_texture_load(g_context, NULL, load, &texture));
    expect(shd_texture_load(g_context, NULL, load, &texture) == SHD_OK, "stack");
    load->stack = NULL;
    shd_texture_release(texture);
    file = fopen(path, "wb");
    expect(file && fwrite("abcdefghijklmnopqrstuvwxyz1234", 1, 30, file) == 30 && fclose(file) == 0, "voxels");
    raw->width = 2, raw->height = 3, raw->depth = 5;
    load->raw = raw;
    EXPECT_READ(raw, shd_texture_load(g_context, path, load, &texture));
    expect(shd_texture_load(g_context, path, load, &texture) == SHD_OK, "raw");
    load->raw = NULL;
    shd_texture_release(texture);
    load->vdb = vdb;
    EXPECT_READ(vdb, shd_texture_load(g_context, path, load, &texture));
    SPOIL(info);
#ifndef SHD_TEST_OLDER /* whose shd_load_desc lacks the last field */
    load->vdb_info = info;
#else
    memset(&info->grid_class, 0, sizeof *info - offsetof(shd_vdb_info, grid_class));
#endif
    expect(shd_texture_load(g_context, path, load, &texture) == SHD_ERROR_UNSUPPORTED, "vdb"); /* it is no such file */
    EXPECT_WRITTEN(info, info->active_voxel_count == 0);
}

/* The file is not tiled. */
static void use_tile_files(const char *path)
{
    shd_tile_cache *cache = NULL;
    shd_texture *texture = NULL;
    MAKE(shd_tile_file_desc, desc);
    MAKE(shd_tile_file_info, info);
    expect(shd_tile_cache_create(g_context, NULL, &cache) == SHD_OK, "cache of tiles of a file");
    desc->cache = cache;
    EXPECT_READ(desc, shd_texture_open(g_context, path, desc, &texture, info));
    SPOIL(info);
    expect(shd_texture_open(g_context, path, desc, &texture, info) == SHD_ERROR_UNSUPPORTED, "tiles of a file");
    EXPECT_WRITTEN(info, info->file_count == 0);
    shd_tile_cache_release(cache);
}

/* A texture of one pixel as KTX2 file. */
static void use_texture_files(const char *path)
{
    static const unsigned char k_pixel[4] = {1, 2, 3, 4};
    shd_texture *texture = NULL, *loaded = NULL;
    MAKE(shd_texture_desc, desc);
    MAKE(shd_ktx2_desc, ktx2);
    MAKE(shd_texture_file_info, info);
    MAKE(shd_load_desc, load);
    desc->format = SHD_FORMAT_RGBA8;
    desc->width = desc->height = 1;
    desc->texels = k_pixel;
    expect(shd_texture_create(g_context, desc, &texture) == SHD_OK, "texture of a file");
    EXPECT_READ(ktx2, shd_texture_save_ktx2(texture, path, ktx2));
    expect(shd_texture_save_ktx2(texture, path, ktx2) == SHD_OK, "ktx2");
    SPOIL(info);
    load->info = info;
    expect(shd_texture_load(g_context, path, load, &loaded) == SHD_OK, "texture file");
    EXPECT_WRITTEN(info, info->level_count == 1);
    shd_texture_release(loaded);
    shd_texture_release(texture);
}
#endif

static void use_io(const char *path)
{
#ifdef SHD_TEST_IO
    unsigned char pixels[4] = {1, 2, 3, 4};
    shd_bitmap *bitmap = NULL;
    MAKE(shd_image, image);
    MAKE(shd_image, loaded);
    MAKE(shd_save_desc, save);
    MAKE(shd_load_desc, load);
    MAKE(shd_bitmap_info, info);
    image->format = SHD_FORMAT_R8;
    image->width = image->height = 2;
    image->pixels = pixels;
    EXPECT_READ(image, shd_image_save(image, path, save));
    EXPECT_READ(save, shd_image_save(image, path, save));
    expect(shd_image_save(image, path, save) == SHD_OK, "save");
    EXPECT_READ(load, shd_bitmap_load(g_context, path, load, &bitmap));
    expect(shd_bitmap_load(g_context, path, load, &bitmap) == SHD_OK, "load");
    SPOIL(info);
    expect(shd_bitmap_get_info(bitmap, info) == SHD_OK, "bitmap info");
    EXPECT_WRITTEN(info, info->file_format == SHD_FILE_FORMAT_PNG);
    SPOIL(loaded);
    expect(shd_bitmap_get_image(bitmap, loaded) == SHD_OK, "bitmap");
    EXPECT_WRITTEN(loaded, loaded->width == 2 && loaded->pixels);
    shd_bitmap_release(bitmap);
    use_tile_files(path);
    use_volume_files(path);
    use_texture_files(path);
    remove(path);
#else
    (void)path;
#endif
}

static void use_scene(void)
{
#ifdef SHD_TEST_SCENE
    FILE *file;
    char path[64];
    shd_scene *scene = NULL;
    MAKE(shd_scene_desc, desc);
    MAKE(shd_scene_info, info);
    MAKE(shd_scene_instance, instance);
    MAKE(shd_material_desc, material);
    MAKE(shd_render_desc, render);
    (void)snprintf(path, sizeof path, "caller_%zu_%zu.obj", sizeof *desc, sizeof *info);
    file = fopen(path, "w");
    if (!file) exit(1);
    (void)fputs("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", file);
    (void)fclose(file);
    EXPECT_READ(desc, shd_scene_load(g_context, path, desc, &scene));
    expect(shd_scene_load(g_context, path, desc, &scene) == SHD_OK, "scene");
    remove(path);
    SPOIL(info);
    expect(shd_scene_get_info(scene, info) == SHD_OK, "scene info");
    EXPECT_WRITTEN(info, info->mesh_count == 1 && info->instance_count == 1);
    SPOIL(instance);
    expect(shd_scene_get_instance(scene, 0, instance) == SHD_OK, "instance");
    EXPECT_WRITTEN(instance, instance->mesh == 0 && instance->object_to_world[0] == 1);
    SPOIL(material);
    expect(shd_scene_get_material_desc(scene, 0, material) == SHD_OK, "material of a scene");
    EXPECT_WRITTEN(material, material->model == SHD_MODEL_BLINN_PHONG);
    expect(shd_scene_fill_render(scene, render) == SHD_OK && render->draw_count == 1, "draws of a scene");
    shd_scene_release(scene);
#endif
}

int main(int argc, char **argv)
{
    use_kinds();
    use_context();
    use_texture();
    use_table();
    use_mip();
    use_lookups();
    use_footprint();
    use_solid();
    use_polygon();
    use_polyhedron();
    use_shapes();
    use_mesh();
    use_render();
    use_tiles();
    use_color();
    use_io(argc > 1 ? argv[1] : "caller.png");
    use_scene();
    shd_framebuffer_release(g_framebuffer);
    shd_mesh_release(g_mesh);
    shd_sampler_release(g_sampler);
    shd_texture_release(g_texture);
    shd_context_release(g_context);
    printf("%zu structs and arrays, %d failures\n", g_count, g_failures);
    check_canaries();
    return g_failures != 0;
}
