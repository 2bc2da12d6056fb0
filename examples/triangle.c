/* SPDX-License-Identifier: MIT */
/* A textured triangle, from nothing to triangle.png. */
#include <stdio.h>
#include <stdlib.h>

#include <shd/io.h>
#include <shd/shd.h>

static void require(shd_result result)
{
    if (result == SHD_OK) return;
    fprintf(stderr, "triangle: %s\n", shd_last_error());
    exit(EXIT_FAILURE);
}

int main(void)
{
    static const float vertices[3][5] = {{-1, -1, 0, 0, 4}, {1, -1, 0, 4, 4}, {0, 1, 0, 2, 0}}; /* x, y, z, u, v */
    static const uint8_t texels[4][3] = {{230, 90, 30}, {250, 240, 220}, {250, 240, 220}, {30, 90, 160}};
    const shd_camera camera = shd_camera_default(); /* at (0, 0, 3), looks at the origin */
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_material_desc material_desc = shd_material_desc_default();
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    shd_framebuffer_desc picture_desc = shd_framebuffer_desc_default();
    shd_draw draw = shd_draw_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_render_stats stats = shd_render_stats_default();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_material *material = NULL;
    shd_mesh *mesh = NULL;
    shd_framebuffer *picture = NULL;
    shd_slot diffuse;
    int c;

    require(shd_context_create(NULL, &context)); /* NULL: all defaults */
    texture_desc.format = SHD_FORMAT_RGB8_SRGB;
    texture_desc.width = texture_desc.height = 2;
    texture_desc.texels = texels;
    require(shd_texture_create(context, &texture_desc, &texture));
    diffuse = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, NULL); /* NULL: the default sampler */
    material_desc.model = SHD_MODEL_UNLIT;                       /* the colour of the texture, without lights */
    material_desc.slots = &diffuse, material_desc.slot_count = 1;
    require(shd_material_create(context, &material_desc, &material));
    mesh_desc.vertex_count = 3;
    for (c = 0; c < 5; ++c) {
        *(c < 3 ? &mesh_desc.position[c] : &mesh_desc.uv[c - 3]) = shd_f32_column(&vertices[0][c], sizeof vertices[0]);
    }
    require(shd_mesh_create(context, &mesh_desc, &mesh));
    picture_desc.width = picture_desc.height = 480;
    picture_desc.sample_count = 8; /* smooth edges */
    require(shd_framebuffer_create(context, &picture_desc, &picture));

    draw.mesh = mesh, draw.material = material;
    frame.framebuffer = picture, frame.camera = &camera;
    frame.draws = &draw, frame.draw_count = 1;
    frame.stats = &stats;
    require(shd_render(context, &frame));
    require(shd_framebuffer_save(picture, "triangle.png", NULL));

    shd_framebuffer_release(picture);
    shd_mesh_release(mesh);
    shd_material_release(material);
    shd_texture_release(texture);
    shd_context_release(context);
    return stats.fragment_count > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
