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
    static const float x[3] = {-1, 1, 0}, y[3] = {-1, -1, 1}, z[3] = {0, 0, 0}; /* counter-clockwise */
    static const float u[3] = {0, 4, 2}, v[3] = {4, 4, 0};                      /* the texture repeats four times */
    static const uint8_t texels[4][4] = {
        {230, 90, 30, 255}, {250, 240, 220, 255}, {250, 240, 220, 255}, {30, 90, 160, 255}};
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_material *material = NULL;
    shd_mesh *mesh = NULL;
    shd_framebuffer *framebuffer = NULL;
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_material_desc material_desc = shd_material_desc_default();
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    shd_framebuffer_desc framebuffer_desc = shd_framebuffer_desc_default();
    shd_camera camera = shd_camera_default(); /* at (0, 0, 3), looks at the origin */
    shd_draw draw = shd_draw_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_render_stats stats = shd_render_stats_default();
    shd_slot diffuse;

    require(shd_context_create(NULL, &context));
    texture_desc.format = SHD_FORMAT_RGBA8_SRGB;
    texture_desc.width = texture_desc.height = 2;
    texture_desc.texels = texels;
    require(shd_texture_create(context, &texture_desc, &texture));

    material_desc.model = SHD_MODEL_UNLIT;                       /* the colour of the texture, without lights */
    diffuse = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, NULL); /* NULL: the default sampler */
    material_desc.slots = &diffuse;
    material_desc.slot_count = 1;
    require(shd_material_create(context, &material_desc, &material));

    mesh_desc.vertex_count = 3;
    mesh_desc.position[0].data = x;
    mesh_desc.position[1].data = y;
    mesh_desc.position[2].data = z;
    mesh_desc.uv[0].data = u;
    mesh_desc.uv[1].data = v;
    require(shd_mesh_create(context, &mesh_desc, &mesh));

    framebuffer_desc.width = framebuffer_desc.height = 480;
    framebuffer_desc.samples = 8; /* smooth edges */
    require(shd_framebuffer_create(context, &framebuffer_desc, &framebuffer));

    draw.mesh = mesh;
    draw.material = material;
    frame.framebuffer = framebuffer;
    frame.draws = &draw;
    frame.draw_count = 1;
    frame.stats = &stats;
    require(shd_view_from_camera(&camera, &frame.view));
    require(shd_render(context, &frame));
    require(shd_framebuffer_save(framebuffer, "triangle.png", NULL));
    printf("triangle.png: %d pixels of the triangle\n", (int)stats.fragments);

    shd_framebuffer_release(framebuffer);
    shd_mesh_release(mesh);
    shd_material_release(material);
    shd_texture_release(texture);
    shd_context_release(context);
    return stats.fragments > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
