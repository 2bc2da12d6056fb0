/* SPDX-License-Identifier: MIT */
/* Wrong handles for mesh reads, tessellation, lights, shadows, queries, updates and contexts. */
#include "support/handles.h"

/* ---- textures and samplers ---- */

static shd_lookups three_lookups(const struct fixture *f)
{
    shd_lookups lookups = shd_lookups_default();
    lookups.count = 3;
    lookups.u.data = lookups.v.data = f->column;
    return lookups;
}
static shd_result explain(struct fixture *f, void *texture, void *sampler)
{
    const shd_lookups lookups = three_lookups(f);
    shd_explanation explanation = shd_explanation_default();
    return shd_texture_explain((const shd_texture *)texture, (const shd_sampler *)sampler, &lookups, 0, &explanation);
}
static shd_result explain_texture(struct fixture *f, void *handle) { return explain(f, handle, f->live[k_sampler]); }
static shd_result explain_sampler(struct fixture *f, void *handle) { return explain(f, f->live[k_texture], handle); }
static shd_result bounds(struct fixture *f, void *texture, void *sampler)
{
    const shd_lookups lookups = three_lookups(f);
    shd_texels lower = shd_texels_default(), upper = shd_texels_default();
    lower.channel[0].data = f->column + 8;
    return shd_texture_bounds((const shd_texture *)texture, (const shd_sampler *)sampler, &lookups, NULL, &lower,
                              &upper);
}
static shd_result bounds_texture(struct fixture *f, void *handle) { return bounds(f, handle, f->live[k_sampler]); }
static shd_result bounds_sampler(struct fixture *f, void *handle) { return bounds(f, f->live[k_texture], handle); }
static shd_result levels(struct fixture *f, void *texture, void *sampler)
{
    const shd_lookups lookups = three_lookups(f);
    shd_levels out = shd_levels_default();
    out.lod.data = f->column + 8;
    return shd_texture_query_levels((const shd_texture *)texture, (const shd_sampler *)sampler, &lookups, &out);
}
static shd_result levels_texture(struct fixture *f, void *handle) { return levels(f, handle, f->live[k_sampler]); }
static shd_result levels_sampler(struct fixture *f, void *handle) { return levels(f, f->live[k_texture], handle); }

/* Writes one texel of the first texture of the scene over itself. */
static shd_result update(struct fixture *f, void *handle)
{
    static unsigned char texels[4 * 61 * 37];
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = 61;
    image.height = 37;
    image.pixels = texels;
    shd_assert_ok(shd_texture_read_level((const shd_texture *)f->live[k_texture], 0, 0, &image));
    image.width = image.height = 1;
    image.row_stride = 0;
    return shd_texture_update((shd_texture *)handle, 0, 0, 0, &image);
}

/* ---- meshes ---- */

static void make_columns(struct fixture *f, shd_f32_out out[4])
{
    memset(out, 0, 4 * sizeof *out);
    out[0].data = f->column;
}
#define READER(what)                                                \
    static shd_result mesh_##what(struct fixture *f, void *handle)  \
    {                                                               \
        shd_f32_out out[4];                                         \
        make_columns(f, out);                                       \
        return shd_mesh_read_##what((const shd_mesh *)handle, out); \
    }
READER(positions)
READER(tangents)
READER(uv)
READER(uv1)
static shd_result mesh_attribute(struct fixture *f, void *handle)
{
    shd_f32_out out[4];
    make_columns(f, out);
    return shd_mesh_read_attribute((const shd_mesh *)handle, 0, out);
}
static shd_result mesh_indices(struct fixture *f, void *handle)
{
    static uint32_t indices[100000];
    const shd_u32_out out = {indices, 0};
    (void)f;
    return shd_mesh_read_indices((const shd_mesh *)handle, &out);
}
/* The mesh of the scene has no adjacency, so another mesh replaces it as the right handle. */
static shd_result mesh_edges(struct fixture *f, void *handle)
{
    const shd_edges_desc desc = shd_edges_desc_default();
    shd_mesh *own = NULL;
    shd_result result;
    size_t count = 0;
    shd_assert_ok(shd_mesh_create_shape(f->context, NULL, SHD_MESH_ADJACENCY, &own));
    if (handle == f->live[k_mesh]) handle = own;
    result = shd_mesh_find_edges((const shd_mesh *)handle, &desc, 0, NULL, &count);
    shd_mesh_release(own);
    return result;
}
static shd_result tessellate(struct fixture *f, void *context, void *mesh, void *displacement, void *sampler)
{
    shd_tessellation_desc desc = shd_tessellation_desc_default();
    shd_mesh *out = NULL;
    shd_result result;
    (void)f;
    desc.displacement = (shd_texture *)displacement;
    desc.sampler = (shd_sampler *)sampler;
    result = shd_mesh_tessellate((shd_context *)context, (const shd_mesh *)mesh, &desc, &out);
    assert_int_equal(out != NULL, result == SHD_OK);
    shd_mesh_release(out);
    return result;
}
static shd_result tessellate_context(struct fixture *f, void *handle)
{
    return tessellate(f, handle, f->live[k_mesh], NULL, NULL);
}
static shd_result tessellate_mesh(struct fixture *f, void *handle)
{
    return tessellate(f, f->context, handle, NULL, NULL);
}
static shd_result tessellate_texture(struct fixture *f, void *handle)
{
    return tessellate(f, f->context, f->live[k_mesh], handle, NULL);
}
static shd_result tessellate_sampler(struct fixture *f, void *handle)
{
    return tessellate(f, f->context, f->live[k_mesh], f->live[k_texture], handle);
}

/* ---- lights and shadows ---- */

static shd_result make_light(struct fixture *f, void *texture, void *sampler)
{
    shd_light_desc desc = shd_light_desc_default();
    shd_light *light = NULL;
    shd_result result;
    desc.kind = SHD_LIGHT_KIND_SPOT;
    desc.texture = (shd_texture *)texture;
    desc.sampler = (shd_sampler *)sampler;
    result = shd_light_create(f->context, &desc, &light);
    assert_int_equal(light != NULL, result == SHD_OK);
    shd_light_release(light);
    return result;
}
static shd_result light_texture(struct fixture *f, void *handle) { return make_light(f, handle, NULL); }
static shd_result light_sampler(struct fixture *f, void *handle) { return make_light(f, f->live[k_texture], handle); }
static shd_result shadow_render(struct fixture *f, void *context, void *shadow, void *light, void *mesh)
{
    shd_shadow_render_desc desc = shd_shadow_render_desc_default();
    shd_light_desc light_desc = shd_light_desc_default();
    shd_light *own = NULL;
    shd_draw draw = shd_draw_default();
    shd_result result;
    shd_assert_ok(shd_light_create(f->context, &light_desc, &own));
    draw.mesh = (const shd_mesh *)mesh;
    desc.light = light == f->live[k_light] ? own : (const shd_light *)light;
    desc.draws = &draw;
    desc.draw_count = 1;
    result = shd_shadow_render((shd_context *)context, (shd_shadow *)shadow, &desc);
    shd_light_release(own);
    return result;
}
static shd_result shadow_context(struct fixture *f, void *handle)
{
    return shadow_render(f, handle, f->live[k_shadow], f->live[k_light], f->live[k_mesh]);
}
static shd_result shadow_shadow(struct fixture *f, void *handle)
{
    return shadow_render(f, f->context, handle, f->live[k_light], f->live[k_mesh]);
}
static shd_result shadow_light(struct fixture *f, void *handle)
{
    return shadow_render(f, f->context, f->live[k_shadow], handle, f->live[k_mesh]);
}
static shd_result shadow_mesh(struct fixture *f, void *handle)
{
    return shadow_render(f, f->context, f->live[k_shadow], f->live[k_light], handle);
}
static shd_result shadow_sample(struct fixture *f, void *handle)
{
    shd_shadow_lookups lookups = shd_shadow_lookups_default();
    shd_shadow_values out = {sizeof out, {f->column + 8, 0}, 0};
    int c;
    shd_assert_ok(shadow_shadow(f, f->live[k_shadow]));
    lookups.count = 3;
    for (c = 0; c < 3; ++c) lookups.position[c].data = f->column;
    return shd_shadow_sample((const shd_shadow *)handle, &lookups, &out);
}
/* A shadow for the first light of a frame. */
static shd_result render_shadow(struct fixture *f, void *handle)
{
    shd_render_desc desc = f->scene.desc;
    shd_light_desc light_desc = shd_light_desc_default();
    shd_light *light = NULL;
    const shd_light *lights[1];
    const shd_shadow *shadow = (const shd_shadow *)handle;
    shd_result result;
    shd_assert_ok(shadow_shadow(f, f->live[k_shadow]));
    shd_assert_ok(shd_light_create(f->context, &light_desc, &light));
    lights[0] = light;
    desc.lights = lights;
    desc.light_count = 1;
    desc.shadows = &shadow;
    result = shd_render(f->context, &desc);
    shd_light_release(light);
    return result;
}

/* ---- contexts ---- */

static void do_nothing(size_t index, size_t worker, void *data)
{
    (void)data;
    (void)index;
    (void)worker;
}
static shd_result context_parallel_for(struct fixture *f, void *handle)
{
    (void)f;
    return shd_context_parallel_for((shd_context *)handle, 3, do_nothing, NULL);
}
static shd_result context_render(struct fixture *f, void *handle)
{
    return shd_render((shd_context *)handle, &f->scene.desc);
}
static shd_result context_mip(struct fixture *f, void *handle)
{
    shd_image base = shd_image_default(), level;
    shd_mip_desc desc = shd_mip_desc_default();
    base.format = SHD_FORMAT_R32F;
    base.width = base.height = 2;
    base.pixels = f->column;
    level = base;
    level.width = level.height = 1;
    level.pixels = f->column + 8;
    return shd_mip_build((shd_context *)handle, &base, &desc, 1, &level);
}
static shd_result context_shape(struct fixture *f, void *handle)
{
    shd_mesh *mesh = NULL;
    const shd_result result = shd_mesh_create_shape((shd_context *)handle, NULL, SHD_MESH_NONE, &mesh);
    (void)f;
    assert_int_equal(mesh != NULL, result == SHD_OK);
    shd_mesh_release(mesh);
    return result;
}
static void end_nothing(void *body) { (void)body; }
static shd_result context_object(struct fixture *f, void *handle)
{
    shd_object *object = NULL;
    static int body;
    const shd_result result = shd_object_create((shd_context *)handle, 0x54455354, &body, end_nothing, &object);
    (void)f;
    assert_int_equal(object != NULL, result == SHD_OK);
    shd_object_release(object, 0x54455354);
    return result;
}

static const struct entry k_entries[] = {
    {"shd_texture_bounds/texture", k_texture, bounds_texture, "texture: ", 0},
    {"shd_texture_bounds/sampler", k_sampler, bounds_sampler, "sampler: ", 0},
    {"shd_texture_explain/texture", k_texture, explain_texture, "texture: ", 0},
    {"shd_texture_explain/sampler", k_sampler, explain_sampler, "sampler: ", 0},
    {"shd_texture_query_levels/texture", k_texture, levels_texture, "texture: ", 0},
    {"shd_texture_query_levels/sampler", k_sampler, levels_sampler, "sampler: ", 0},
    {"shd_texture_update", k_texture, update, "texture: ", 0},
    {"shd_mesh_read_positions", k_mesh, mesh_positions, "mesh: ", 0},
    {"shd_mesh_read_tangents", k_mesh, mesh_tangents, "mesh: ", 0},
    {"shd_mesh_read_uv", k_mesh, mesh_uv, "mesh: ", 0},
    {"shd_mesh_read_uv1", k_mesh, mesh_uv1, "mesh: ", 0},
    {"shd_mesh_read_attribute", k_mesh, mesh_attribute, "mesh: ", 0},
    {"shd_mesh_read_indices", k_mesh, mesh_indices, "mesh: ", 0},
    {"shd_mesh_find_edges", k_mesh, mesh_edges, "mesh: ", 0},
    {"shd_mesh_tessellate/context", k_context, tessellate_context, "context: ", 0},
    {"shd_mesh_tessellate/mesh", k_mesh, tessellate_mesh, "mesh: ", 0},
    {"shd_mesh_tessellate/displacement", k_texture, tessellate_texture, "tessellation.displacement: ", 1},
    {"shd_mesh_tessellate/sampler", k_sampler, tessellate_sampler, "tessellation.sampler: ", 1},
    {"shd_light_create/texture", k_texture, light_texture, "light.texture: ", 1},
    {"shd_light_create/sampler", k_sampler, light_sampler, "light.sampler: ", 1},
    {"shd_shadow_render/context", k_context, shadow_context, "context: ", 0},
    {"shd_shadow_render/shadow", k_shadow, shadow_shadow, "shadow: ", 0},
    {"shd_shadow_render/light", k_light, shadow_light, "shadow_render.light: ", 0},
    {"shd_shadow_render/mesh", k_mesh, shadow_mesh, "shadow_render.draws[0]: draw.mesh: ", 0},
    {"shd_shadow_sample", k_shadow, shadow_sample, "shadow: ", 0},
    {"shd_render/shadow", k_shadow, render_shadow, "render.shadows[0]: ", 1},
    {"shd_render/context", k_context, context_render, "context: ", 0},
    {"shd_context_parallel_for", k_context, context_parallel_for, "context: ", 0},
    {"shd_mip_build", k_context, context_mip, "context: ", 0},
    {"shd_mesh_create_shape", k_context, context_shape, "context: ", 0},
    {"shd_object_create", k_context, context_object, "context: ", 0},
};

int main(void)
{
    static struct CMUnitTest tests[sizeof k_entries / sizeof k_entries[0]];
    size_t n = 0;
    for (; n < sizeof k_entries / sizeof k_entries[0]; ++n) {
        tests[n] = (struct CMUnitTest){k_entries[n].name, test_entry, NULL, NULL, (void *)&k_entries[n]};
    }
    return _cmocka_run_group_tests("api.host_handles_more", tests, n, NULL, NULL);
}
