/* SPDX-License-Identifier: MIT */
#include "support/frame.h"

void shd_frame_open_aovs(shd_frame *f, uint32_t width, uint32_t height, uint32_t samples, uint32_t aovs)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    int plane;
    memset(f, 0, sizeof *f);
    shd_assert_ok(shd_context_create(NULL, &f->context));
    f->width = desc.width = width;
    f->height = desc.height = height;
    desc.sample_count = samples;
    desc.aovs = aovs;
    shd_assert_ok(shd_framebuffer_create(f->context, &desc, &f->framebuffer));
    for (plane = 0; plane < SHD_FRAME_PLANES; ++plane) {
        shd_plane_view view = shd_plane_view_default();
        void *memory;
        if (shd_framebuffer_view_plane(f->framebuffer, (shd_plane)plane, &view) != SHD_OK) continue;
        memory = malloc((size_t)width * height * 4);
        assert_non_null(memory);
        if (view.u32) {
            f->u32[plane] = (uint32_t *)memory;
        } else {
            f->plane[plane] = (float *)memory;
        }
    }
    f->triangle = f->u32[SHD_PLANE_TRIANGLE];
    f->desc = shd_render_desc_default();
    f->desc.framebuffer = f->framebuffer;
    f->desc.draws = f->draw;
    f->desc.lights = (const shd_light *const *)f->light;
    f->stats = shd_render_stats_default();
    f->desc.stats = &f->stats;
}

void shd_frame_open_samples(shd_frame *f, uint32_t width, uint32_t height, uint32_t samples)
{
    shd_frame_open_aovs(f, width, height, samples, SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE);
}

void shd_frame_open(shd_frame *f, uint32_t width, uint32_t height) { shd_frame_open_samples(f, width, height, 1); }

void shd_frame_close(shd_frame *f)
{
    int i;
    for (i = 0; i < SHD_FRAME_DRAWS; ++i) shd_mesh_release(f->mesh[i]);
    for (i = 0; i < SHD_FRAME_DRAWS; ++i) shd_material_release(f->material[i]);
    for (i = 0; i < SHD_FRAME_LIGHTS; ++i) shd_light_release(f->light[i]);
    for (i = 0; i < SHD_FRAME_PLANES; ++i) free(f->plane[i]);
    for (i = 0; i < SHD_FRAME_PLANES; ++i) free(f->u32[i]);
    shd_framebuffer_release(f->framebuffer);
    shd_context_release(f->context);
}

shd_draw *shd_frame_draw(shd_frame *f, const float *vertices, uint32_t count, const shd_material_desc *material)
{
    const size_t which = f->desc.draw_count++;
    shd_mesh_desc desc = shd_mesh_desc_default();
    int c;
    desc.vertex_count = count;
    for (c = 0; c < 8; ++c) {
        shd_f32_in *column = c < 3 ? &desc.position[c] : c < 6 ? &desc.normal[c - 3] : &desc.uv[c - 6];
        *column = shd_f32_column(vertices + c, 8 * sizeof(float));
    }
    shd_assert_ok(shd_mesh_create(f->context, &desc, &f->mesh[which]));
    shd_assert_ok(shd_material_create(f->context, material, &f->material[which]));
    f->draw[which] = shd_draw_default();
    f->draw[which].mesh = f->mesh[which];
    f->draw[which].material = f->material[which];
    return &f->draw[which];
}

void shd_frame_light(shd_frame *f, const shd_light_desc *desc)
{
    shd_assert_ok(shd_light_create(f->context, desc, &f->light[f->desc.light_count]));
    ++f->desc.light_count;
}

void shd_frame_render(shd_frame *f)
{
    int plane;
    shd_assert_ok(shd_render(f->context, &f->desc));
    for (plane = 0; plane < SHD_FRAME_PLANES; ++plane) {
        const shd_f32_out floats = {f->plane[plane], 0};
        const shd_u32_out integers = {f->u32[plane], 0};
        if (floats.data) shd_assert_ok(shd_framebuffer_read_plane(f->framebuffer, (shd_plane)plane, &floats));
        if (integers.data) shd_assert_ok(shd_framebuffer_read_u32_plane(f->framebuffer, (shd_plane)plane, &integers));
    }
}

void shd_frame_quad(float x0, float y0, float x1, float y1, float z0, float z1, float out[48])
{
    const float corner[4][8] = {{x0, y0, z0, 0, 0, 1, 0, 1},
                                {x1, y0, z1, 0, 0, 1, 1, 1},
                                {x1, y1, z1, 0, 0, 1, 1, 0},
                                {x0, y1, z0, 0, 0, 1, 0, 0}};
    static const int k_order[6] = {0, 1, 2, 0, 2, 3};
    int i;
    for (i = 0; i < 6; ++i) memcpy(out + 8 * i, corner[k_order[i]], sizeof corner[0]);
}

shd_material_desc shd_frame_plain(float r, float g, float b)
{
    shd_material_desc desc = shd_material_desc_default();
    desc.ambient[0] = r;
    desc.ambient[1] = g;
    desc.ambient[2] = b;
    return desc;
}

void shd_frame_ambient(shd_frame *f)
{
    shd_light_desc desc = shd_light_desc_default();
    desc.kind = SHD_LIGHT_KIND_AMBIENT;
    shd_frame_light(f, &desc);
}
