/* SPDX-License-Identifier: MIT */
/* All types of handle behind one signature, for tests that run one script over all of them. A new type is a row of
   k_types. Call open_rest before using any row, and close_rest at the end. */
#ifndef SHD_TESTS_SUPPORT_HANDLE_TYPES_H
#define SHD_TESTS_SUPPORT_HANDLE_TYPES_H

#include "support/check.h"

#include <shd/shd.h>

/* Other objects that the use of a handle needs. They belong to another context, because any context is allowed. */
static struct {
    shd_context *context;
    shd_framebuffer *framebuffer;
    shd_mesh *mesh;
    shd_texture *texture;
    shd_sampler *sampler;
    shd_light *light;
} g_rest;

/* The types behind one signature. `use` passes the handle to a call that must refuse a bad one. */
struct type_row {
    const char *name;
    const char *type;
    shd_result (*create)(shd_context *context, void **out);
    void (*retain)(void *handle);
    void (*release)(void *handle);
    shd_result (*use)(void *handle);
    const char *refusal;
};

static shd_result create_mesh(shd_context *context, void **out)
{
    static const float k_position[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const uint32_t k_indices[6] = {0, 1, 2, 0, 2, 3};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = (shd_mesh *)&desc;
    shd_result result;
    int c;
    desc.vertex_count = 4;
    for (c = 0; c < 3; ++c) {
        desc.position[c].data = k_position + c;
        desc.position[c].stride = 3 * sizeof(float);
    }
    for (c = 0; c < 4; ++c) desc.tangent[c].data = k_position;
    desc.indices.data = k_indices;
    desc.index_count = 6;
    desc.normal_weight = SHD_NORMAL_WEIGHT_ANGLE;
    result = shd_mesh_create(context, &desc, &mesh);
    *out = mesh;
    return result;
}
static void retain_mesh(void *handle) { shd_mesh_retain((shd_mesh *)handle); }
static void release_mesh(void *handle) { shd_mesh_release((shd_mesh *)handle); }
static shd_result use_mesh(void *handle)
{
    shd_mesh_info info = shd_mesh_info_default();
    return shd_mesh_get_info((const shd_mesh *)handle, &info);
}

static shd_result create_light(shd_context *context, void **out)
{
    shd_light *light = (shd_light *)out;
    const shd_result result = shd_light_create(context, NULL, &light);
    *out = light;
    return result;
}
static void retain_light(void *handle) { shd_light_retain((shd_light *)handle); }
static void release_light(void *handle) { shd_light_release((shd_light *)handle); }
static shd_result use_light(void *handle)
{
    const shd_light *light = (const shd_light *)handle;
    shd_render_desc desc = shd_render_desc_default();
    desc.framebuffer = g_rest.framebuffer;
    desc.lights = &light;
    desc.light_count = 1;
    return shd_render(g_rest.context, &desc);
}

static shd_result create_material(shd_context *context, void **out)
{
    shd_material *material = (shd_material *)out;
    const shd_result result = shd_material_create(context, NULL, &material);
    *out = material;
    return result;
}
static void retain_material(void *handle) { shd_material_retain((shd_material *)handle); }
static void release_material(void *handle) { shd_material_release((shd_material *)handle); }
static shd_result use_material(void *handle)
{
    shd_draw draw = shd_draw_default();
    shd_render_desc desc = shd_render_desc_default();
    draw.mesh = g_rest.mesh;
    draw.material = (const shd_material *)handle;
    desc.framebuffer = g_rest.framebuffer;
    desc.draws = &draw;
    desc.draw_count = 1;
    return shd_render(g_rest.context, &desc);
}

static shd_result create_framebuffer(shd_context *context, void **out)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = (shd_framebuffer *)&desc;
    shd_result result;
    desc.width = 5;
    desc.height = 3;
    desc.aovs = SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE;
    result = shd_framebuffer_create(context, &desc, &framebuffer);
    *out = framebuffer;
    return result;
}
static void retain_framebuffer(void *handle) { shd_framebuffer_retain((shd_framebuffer *)handle); }
static void release_framebuffer(void *handle) { shd_framebuffer_release((shd_framebuffer *)handle); }
static shd_result use_framebuffer(void *handle)
{
    shd_framebuffer_info info = shd_framebuffer_info_default();
    return shd_framebuffer_get_info((const shd_framebuffer *)handle, &info);
}

static shd_result create_texture(shd_context *context, void **out)
{
    static const unsigned char k_texels[4 * 5 * 3] = {255, 0, 0, 255, 0, 255, 0, 255};
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = (shd_texture *)&desc;
    shd_result result;
    desc.format = SHD_FORMAT_RGBA8_SRGB;
    desc.width = 5;
    desc.height = 3;
    desc.texels = k_texels;
    desc.tables = SHD_TABLE_MIPMAP;
    result = shd_texture_create(context, &desc, &texture);
    *out = texture;
    return result;
}
static void retain_texture(void *handle) { shd_texture_retain((shd_texture *)handle); }
static void release_texture(void *handle) { shd_texture_release((shd_texture *)handle); }
static shd_result use_texture(void *handle)
{
    shd_texture_info info = shd_texture_info_default();
    return shd_texture_get_info((const shd_texture *)handle, &info);
}

static shd_result create_sampler(shd_context *context, void **out)
{
    shd_sampler *sampler = (shd_sampler *)out;
    const shd_result result = shd_sampler_create(context, NULL, &sampler);
    *out = sampler;
    return result;
}
static void retain_sampler(void *handle) { shd_sampler_retain((shd_sampler *)handle); }
static void release_sampler(void *handle) { shd_sampler_release((shd_sampler *)handle); }
static shd_result use_sampler(void *handle)
{
    const float half = 0.5f;
    float red;
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels;
    memset(&texels, 0, sizeof texels);
    lookups.count = 1;
    lookups.u.data = lookups.v.data = &half;
    texels.channel[0].data = &red;
    return shd_texture_sample(g_rest.texture, (const shd_sampler *)handle, &lookups, &texels);
}

static shd_result create_shadow(shd_context *context, void **out)
{
    shd_shadow_desc desc = shd_shadow_desc_default();
    shd_shadow *shadow = (shd_shadow *)out;
    shd_result result;
    desc.size = 16;
    result = shd_shadow_create(context, &desc, &shadow);
    *out = shadow;
    return result;
}
static void retain_shadow(void *handle) { shd_shadow_retain((shd_shadow *)handle); }
static void release_shadow(void *handle) { shd_shadow_release((shd_shadow *)handle); }
static shd_result use_shadow(void *handle)
{
    shd_shadow_render_desc desc = shd_shadow_render_desc_default();
    desc.light = g_rest.light;
    return shd_shadow_render(g_rest.context, (shd_shadow *)handle, &desc);
}

/* A volume that holds the only references to a texture and a material. */
static shd_result create_volume(shd_context *context, void **out)
{
    static const unsigned char k_texels[8] = {0, 10, 20, 30, 40, 50, 60, 255};
    static const float k_density[2] = {0.0f, 1.0f};
    shd_texture_desc texture = shd_texture_desc_default();
    shd_volume_desc desc = shd_volume_desc_default();
    shd_volume *volume = NULL;
    void *material = NULL;
    shd_result result;
    texture.format = SHD_FORMAT_R8;
    texture.kind = SHD_TEXTURE_KIND_3D;
    texture.width = texture.height = texture.depth = 2;
    texture.texels = k_texels;
    result = shd_texture_create(context, &texture, &desc.texture);
    if (result == SHD_OK) result = create_material(context, &material);
    desc.material = (shd_material *)material;
    desc.point_count = 2;
    desc.density.data = desc.extinction.data = k_density;
    if (result == SHD_OK) result = shd_volume_create(context, &desc, &volume);
    release_material(material);
    shd_texture_release(desc.texture);
    *out = volume;
    return result;
}
static void retain_volume(void *handle) { shd_volume_retain((shd_volume *)handle); }
static void release_volume(void *handle) { shd_volume_release((shd_volume *)handle); }
static shd_result use_volume(void *handle)
{
    shd_volume_draw draw = shd_volume_draw_default();
    shd_render_desc desc = shd_render_desc_default();
    draw.volume = (const shd_volume *)handle;
    desc.framebuffer = g_rest.framebuffer;
    desc.volumes = &draw;
    desc.volume_count = 1;
    return shd_render(g_rest.context, &desc);
}

static shd_result create_environment(shd_context *context, void **out)
{
    float texel[3] = {1.0f, 2.0f, 3.0f};
    shd_image image = shd_image_default();
    shd_environment_desc desc = shd_environment_desc_default();
    shd_environment *environment = (shd_environment *)out;
    shd_result result;
    image.format = SHD_FORMAT_RGB32F;
    image.width = image.height = 1;
    image.pixels = texel;
    desc.image = &image;
    desc.tables = SHD_ENVIRONMENT_TABLE_NONE;
    result = shd_environment_create(context, &desc, &environment);
    *out = environment;
    return result;
}
static void retain_environment(void *handle) { shd_environment_retain((shd_environment *)handle); }
static void release_environment(void *handle) { shd_environment_release((shd_environment *)handle); }
static shd_result use_environment(void *handle)
{
    const float half = 0.5f;
    float red;
    shd_environment_lookups lookups = shd_environment_lookups_default();
    shd_environment_values light = shd_environment_values_default();
    lookups.count = 1;
    lookups.direction[0].data = lookups.direction[1].data = lookups.direction[2].data = &half;
    light.channel[0].data = &red;
    return shd_environment_sample_irradiance((const shd_environment *)handle, &lookups, &light);
}

static shd_result create_polyhedron(shd_context *context, void **out)
{
    static const float k_position[3][4] = {{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    static const uint32_t k_indices[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    shd_polyhedron_desc desc = shd_polyhedron_desc_default();
    shd_polyhedron *polyhedron = (shd_polyhedron *)out;
    shd_result result;
    int c;
    desc.vertex_count = 4;
    desc.index_count = 12;
    for (c = 0; c < 3; ++c) desc.position[c].data = k_position[c];
    desc.indices.data = k_indices;
    result = shd_polyhedron_create(context, &desc, &polyhedron);
    *out = polyhedron;
    return result;
}
static void retain_polyhedron(void *handle) { shd_polyhedron_retain((shd_polyhedron *)handle); }
static void release_polyhedron(void *handle) { shd_polyhedron_release((shd_polyhedron *)handle); }
static shd_result use_polyhedron(void *handle)
{
    const float place = 0.125f, value[4] = {1, 2, 3, 4};
    float sum;
    const shd_f32_in vertex_value = {value, 0};
    const shd_f32_out sums = {&sum, 0};
    shd_polyhedron_points points = shd_polyhedron_points_default();
    shd_polyhedron_values values = shd_polyhedron_values_default();
    points.count = 1;
    points.position[0].data = points.position[1].data = points.position[2].data = &place;
    values.value_count = 1;
    values.vertex_value = &vertex_value;
    values.value = &sums;
    return shd_polyhedron_interpolate((const shd_polyhedron *)handle, &points, &values);
}

/* A material that holds the only references to a texture and a sampler. */
static shd_result create_textured_material(shd_context *context, void **out)
{
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    void *texture = NULL, *sampler = NULL;
    shd_result result = create_texture(context, &texture);
    if (result == SHD_OK) result = create_sampler(context, &sampler);
    if (result == SHD_OK) {
        const shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, (shd_texture *)texture, (shd_sampler *)sampler);
        desc.slots = &slot;
        desc.slot_count = 1;
        result = shd_material_create(context, &desc, &material);
    } else {
        assert_null(sampler);
    }
    release_sampler(sampler);
    release_texture(texture);
    *out = material;
    return result;
}

/* A light that holds the only references to a texture and a sampler. */
static shd_result create_textured_light(shd_context *context, void **out)
{
    shd_light_desc desc = shd_light_desc_default();
    shd_light *light = NULL;
    void *texture = NULL, *sampler = NULL;
    shd_result result = create_texture(context, &texture);
    if (result == SHD_OK) result = create_sampler(context, &sampler);
    if (result == SHD_OK) {
        desc.kind = SHD_LIGHT_KIND_SPOT;
        desc.texture = (shd_texture *)texture;
        desc.sampler = (shd_sampler *)sampler;
        result = shd_light_create(context, &desc, &light);
    } else {
        assert_null(sampler);
    }
    release_sampler(sampler);
    release_texture(texture);
    *out = light;
    return result;
}

static const struct type_row k_types[] = {
    {"mesh", "mesh", create_mesh, retain_mesh, release_mesh, use_mesh, "mesh: not a live handle of its type"},
    {"light", "light", create_light, retain_light, release_light, use_light,
     "render.lights[0]: light: not a live handle of its type"},
    {"material", "material", create_material, retain_material, release_material, use_material,
     "render.draws[0]: draw.material: not a live handle of its type"},
    {"framebuffer", "framebuffer", create_framebuffer, retain_framebuffer, release_framebuffer, use_framebuffer,
     "framebuffer: not a live handle of its type"},
    {"texture", "texture", create_texture, retain_texture, release_texture, use_texture,
     "texture: not a live handle of its type"},
    {"sampler", "sampler", create_sampler, retain_sampler, release_sampler, use_sampler,
     "sampler: not a live handle of its type"},
    {"shadow", "shadow", create_shadow, retain_shadow, release_shadow, use_shadow,
     "shadow: not a live handle of its type"},
    {"textured_volume", "volume", create_volume, retain_volume, release_volume, use_volume,
     "render.volumes[0]: volume.volume: not a live handle of its type"},
    {"environment", "environment", create_environment, retain_environment, release_environment, use_environment,
     "environment: not a live handle of its type"},
    {"polyhedron", "polyhedron", create_polyhedron, retain_polyhedron, release_polyhedron, use_polyhedron,
     "polyhedron: not a live handle of its type"},
    {"textured_material", "material", create_textured_material, retain_material, release_material, use_material,
     "render.draws[0]: draw.material: not a live handle of its type"},
    {"textured_light", "light", create_textured_light, retain_light, release_light, use_light,
     "render.lights[0]: light: not a live handle of its type"},
};
enum { k_type_count = sizeof k_types / sizeof k_types[0] };

static shd_result open_rest(void)
{
    void *framebuffer = NULL, *mesh = NULL, *texture = NULL, *sampler = NULL, *light = NULL;
    shd_result result = shd_context_create(NULL, &g_rest.context);
    if (result == SHD_OK) result = create_framebuffer(g_rest.context, &framebuffer);
    if (result == SHD_OK) result = create_mesh(g_rest.context, &mesh);
    if (result == SHD_OK) result = create_texture(g_rest.context, &texture);
    if (result == SHD_OK) result = create_sampler(g_rest.context, &sampler);
    if (result == SHD_OK) result = create_light(g_rest.context, &light);
    g_rest.framebuffer = (shd_framebuffer *)framebuffer;
    g_rest.mesh = (shd_mesh *)mesh;
    g_rest.texture = (shd_texture *)texture;
    g_rest.sampler = (shd_sampler *)sampler;
    g_rest.light = (shd_light *)light;
    return result;
}

static void close_rest(void)
{
    shd_framebuffer_release(g_rest.framebuffer);
    shd_mesh_release(g_rest.mesh);
    shd_texture_release(g_rest.texture);
    shd_sampler_release(g_rest.sampler);
    shd_light_release(g_rest.light);
    shd_context_release(g_rest.context);
}

#endif /* SHD_TESTS_SUPPORT_HANDLE_TYPES_H */
