/* SPDX-License-Identifier: MIT */
/* Wrong handles for textures, materials, framebuffers and frames; references of wrong types. */
#include "support/handles.h"

static shd_result texture_info(struct fixture *f, void *handle)
{
    shd_texture_info info = shd_texture_info_default();
    (void)f;
    return shd_texture_get_info((const shd_texture *)handle, &info);
}
static shd_result texture_level(struct fixture *f, void *handle)
{
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = 61;
    image.height = 37;
    image.pixels = f->column;
    return shd_texture_read_level((const shd_texture *)handle, 0, 0, &image);
}
static shd_result texture_table(struct fixture *f, void *handle)
{
    shd_table_desc desc = shd_table_desc_default();
    shd_f32_out out[4];
    memset(out, 0, sizeof out);
    out[0].data = f->column;
    desc.table = SHD_TABLE_MIPMAP;
    desc.level_u = desc.level_v = 5; /* one texel */
    return shd_texture_read_table((const shd_texture *)handle, &desc, out);
}
static shd_result sample(struct fixture *f, void *texture, void *sampler)
{
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels;
    memset(&texels, 0, sizeof texels);
    lookups.count = 3;
    lookups.u.data = lookups.v.data = f->column;
    texels.channel[0].data = f->column + 8;
    return shd_texture_sample((const shd_texture *)texture, (const shd_sampler *)sampler, &lookups, &texels);
}
static shd_result sample_texture(struct fixture *f, void *handle) { return sample(f, handle, f->live[k_sampler]); }
static shd_result sample_sampler(struct fixture *f, void *handle) { return sample(f, f->live[k_texture], handle); }
static shd_result mesh_info(struct fixture *f, void *handle)
{
    shd_mesh_info info = shd_mesh_info_default();
    (void)f;
    return shd_mesh_get_info((const shd_mesh *)handle, &info);
}
static shd_result mesh_normals(struct fixture *f, void *handle)
{
    shd_f32_out out[3];
    memset(out, 0, sizeof out);
    out[0].data = f->column;
    return shd_mesh_read_normals((const shd_mesh *)handle, out);
}
static shd_result framebuffer_info(struct fixture *f, void *handle)
{
    shd_framebuffer_info info = shd_framebuffer_info_default();
    (void)f;
    return shd_framebuffer_get_info((const shd_framebuffer *)handle, &info);
}
static shd_result framebuffer_view(struct fixture *f, void *handle)
{
    shd_plane_view view = shd_plane_view_default();
    (void)f;
    return shd_framebuffer_view_plane((const shd_framebuffer *)handle, SHD_PLANE_R, &view);
}
static shd_result framebuffer_plane(struct fixture *f, void *handle)
{
    static float plane[100 * 70];
    shd_f32_out out;
    (void)f;
    out.data = plane;
    out.stride = 0;
    return shd_framebuffer_read_plane((const shd_framebuffer *)handle, SHD_PLANE_R, &out);
}
static shd_result framebuffer_u32_plane(struct fixture *f, void *handle)
{
    static uint32_t plane[100 * 70];
    shd_u32_out out;
    (void)f;
    out.data = plane;
    out.stride = 0;
    return shd_framebuffer_read_u32_plane((const shd_framebuffer *)handle, SHD_PLANE_TRIANGLE, &out);
}
static shd_result framebuffer_color(struct fixture *f, void *handle)
{
    static unsigned char pixels[4 * 100 * 70];
    shd_image image = shd_image_default();
    (void)f;
    image.format = SHD_FORMAT_RGBA8;
    image.width = 100;
    image.height = 70;
    image.pixels = pixels;
    return shd_framebuffer_read_color((const shd_framebuffer *)handle, &image);
}
static shd_result make_material(struct fixture *f, void *texture, void *sampler)
{
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    shd_result result;
    shd_slot slot;
    slot = shd_slot_texture(SHD_SLOT_DIFFUSE, (shd_texture *)texture, (shd_sampler *)sampler);
    if (!texture) slot.source = SHD_SLOT_SOURCE_CONSTANT;
    desc.slots = &slot;
    desc.slot_count = 1;
    result = shd_material_create(f->context, &desc, &material);
    assert_int_equal(material != NULL, result == SHD_OK);
    shd_material_release(material);
    return result;
}
static shd_result material_texture(struct fixture *f, void *handle) { return make_material(f, handle, NULL); }
static shd_result material_sampler(struct fixture *f, void *handle)
{
    return make_material(f, f->live[k_texture], handle);
}
static shd_result render_framebuffer(struct fixture *f, void *handle)
{
    shd_render_desc desc = f->scene.desc;
    desc.framebuffer = (shd_framebuffer *)handle;
    return shd_render(f->context, &desc);
}
static shd_result render_draw(struct fixture *f, void *mesh, void *material)
{
    shd_render_desc desc = f->scene.desc;
    shd_draw draw = f->scene.draw[0];
    draw.mesh = (const shd_mesh *)mesh;
    draw.material = (const shd_material *)material;
    desc.draws = &draw;
    desc.draw_count = 1;
    return shd_render(f->context, &desc);
}
static shd_result render_mesh(struct fixture *f, void *handle) { return render_draw(f, handle, f->live[k_material]); }
static shd_result render_material(struct fixture *f, void *handle) { return render_draw(f, f->live[k_mesh], handle); }
static shd_result render_light(struct fixture *f, void *handle)
{
    shd_render_desc desc = f->scene.desc;
    const shd_light *light = (const shd_light *)handle;
    desc.lights = &light;
    desc.light_count = 1;
    return shd_render(f->context, &desc);
}
static shd_result object_body(struct fixture *f, void *handle)
{
    (void)f;
    return shd_object_get_body((const shd_object *)handle, 0x54455354) ? SHD_OK : SHD_ERROR_INVALID_ARGUMENT;
}
static shd_result framebuffer_context(struct fixture *f, void *handle)
{
    return shd_framebuffer_get_context((const shd_framebuffer *)handle) == f->context ? SHD_OK
                                                                                      : SHD_ERROR_INVALID_ARGUMENT;
}

static const struct entry k_entries[] = {
    {"shd_texture_get_info", k_texture, texture_info, "texture: ", 0},
    {"shd_texture_read_level", k_texture, texture_level, "texture: ", 0},
    {"shd_texture_read_table", k_texture, texture_table, "texture: ", 0},
    {"shd_texture_sample/texture", k_texture, sample_texture, "texture: ", 0},
    {"shd_texture_sample/sampler", k_sampler, sample_sampler, "sampler: ", 0},
    {"shd_mesh_get_info", k_mesh, mesh_info, "mesh: ", 0},
    {"shd_mesh_read_normals", k_mesh, mesh_normals, "mesh: ", 0},
    {"shd_framebuffer_get_info", k_framebuffer, framebuffer_info, "framebuffer: ", 0},
    {"shd_framebuffer_view_plane", k_framebuffer, framebuffer_view, "framebuffer: ", 0},
    {"shd_framebuffer_read_plane", k_framebuffer, framebuffer_plane, "framebuffer: ", 0},
    {"shd_framebuffer_read_u32_plane", k_framebuffer, framebuffer_u32_plane, "framebuffer: ", 0},
    {"shd_framebuffer_read_color", k_framebuffer, framebuffer_color, "framebuffer: ", 0},
    {"shd_material_create/texture", k_texture, material_texture, "material.slots[0].texture: ", 1},
    {"shd_material_create/sampler", k_sampler, material_sampler, "material.slots[0].sampler: ", 1},
    {"shd_render/framebuffer", k_framebuffer, render_framebuffer, "render.framebuffer: ", 0},
    {"shd_render/mesh", k_mesh, render_mesh, "render.draws[0]: draw.mesh: ", 0},
    {"shd_render/material", k_material, render_material, "render.draws[0]: draw.material: ", 1},
    {"shd_render/light", k_light, render_light, "render.lights[0]: light: ", 0},
    {"shd_object_get_body", k_object, object_body, "object: ", 0},
    {"shd_framebuffer_get_context", k_framebuffer, framebuffer_context, "", 0},
};

/* Retain and release of every type do nothing for handles of other types. */
static void test_references(void **state)
{
    struct fixture f;
    uint64_t want;
    int type, round;
    (void)state;
    open_fixture(&f);
    want = shd_scene_render(&f.scene);
    for (round = 0; round < 3; ++round) {
        for (type = 0; type < k_types + 3; ++type) {
            void *handle = type < k_types ? f.live[type] : type == k_context ? (void *)f.context : f.zeros;
            if (type != k_texture) shd_texture_release((shd_texture *)handle);
            if (type != k_sampler) shd_sampler_release((shd_sampler *)handle);
            if (type != k_mesh) shd_mesh_release((shd_mesh *)handle);
            if (type != k_material) shd_material_release((shd_material *)handle);
            if (type != k_light) shd_light_release((shd_light *)handle);
            if (type != k_framebuffer) shd_framebuffer_release((shd_framebuffer *)handle);
            if (type != k_shadow) shd_shadow_release((shd_shadow *)handle);
            if (type != k_object) shd_object_release((shd_object *)handle, 0x54455354);
            if (type != k_context) shd_context_release((shd_context *)handle);
            if (type < k_types) {
                shd_texture_retain((shd_texture *)f.dead[type]);
                shd_mesh_release((shd_mesh *)f.dead[type]);
                shd_light_release((shd_light *)f.dead[type]);
                shd_framebuffer_retain((shd_framebuffer *)f.dead[type]);
                shd_shadow_release((shd_shadow *)f.dead[type]);
            }
        }
    }
    assert_true(shd_scene_render(&f.scene) == want);
    assert_int_equal(f.ends, 0);
    close_fixture(&f);
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_entries / sizeof k_entries[0] + 1];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_entries / sizeof k_entries[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_entries[i].name, test_entry, NULL, NULL, (void *)&k_entries[i]};
    }
    tests[n++] = (struct CMUnitTest){"references", test_references, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.host_handles", tests, n, NULL, NULL);
}
