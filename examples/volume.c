/* SPDX-License-Identifier: MIT */
/* Render volumes: a cloud that glows by itself, and the inside of a head, lit from the side. */
#include "density.h"

#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { WIDTH = 640, HEIGHT = 360, EDGE = 96, VOLUMES = 2 };

struct frame {
    shd_context *context;
    shd_texture *texture[VOLUMES];
    shd_material *material;
    shd_light *light;
    shd_volume *volume[VOLUMES];
    shd_framebuffer *framebuffer;
};

/* A 3D texture of density, and a volume with a transfer function of four points. */
static shd_result make_volume(struct frame *f, int which, float (*density)(float, float, float),
                              const float (*points)[5], shd_material *material)
{
    shd_texture_desc td = shd_texture_desc_default();
    shd_volume_desc vd = shd_volume_desc_default();
    unsigned char *texels = (unsigned char *)malloc((size_t)EDGE * EDGE * EDGE);
    shd_result result;
    size_t c;
    if (!texels) return SHD_ERROR_OUT_OF_MEMORY;
    fill_density(density, EDGE, texels);
    td.format = SHD_FORMAT_R8;
    td.kind = SHD_TEXTURE_KIND_3D;
    td.width = td.height = td.depth = EDGE;
    td.texels = texels;
    result = shd_texture_create(f->context, &td, &f->texture[which]);
    free(texels);
    if (result != SHD_OK) return result;
    vd.texture = f->texture[which];
    vd.material = material;
    vd.point_count = 4;
    vd.density = shd_f32_column(points[0], 5 * sizeof(float));
    vd.extinction = shd_f32_column(points[0] + 1, 5 * sizeof(float));
    for (c = 0; c < 3; ++c) {
        vd.color[c] = shd_f32_column(points[0] + 2 + c, 5 * sizeof(float));
        vd.bounds_min[c] = -1.0f;
    }
    vd.step = 1.0f / EDGE;
    vd.jitter = 1.0f; /* noise instead of rings */
    return shd_volume_create(f->context, &vd, &f->volume[which]);
}

/* The rear half of the head, which shows what is inside. */
static float open_head_density(float x, float y, float z)
{
    return y < 0 ? 0 : head_density(x, y, z);
}

static shd_result make(struct frame *f)
{
    /* density, extinction, r, g, b */
    static const float k_cloud[4][5] = {
        {0.02f, 0, 0.55f, 0.6f, 0.7f}, {0.2f, 5, 0.7f, 0.75f, 0.8f}, {0.5f, 18, 1, 0.95f, 0.9f}, {1, 40, 1, 1, 0.95f}};
    static const float k_head_points[4][5] = {{0.08f, 0, 0.7f, 0.3f, 0.3f},
                                              {0.18f, 25, 0.75f, 0.35f, 0.35f},
                                              {0.3f, 40, 0.8f, 0.05f, 0.05f},
                                              {0.6f, 40, 0.9f, 0.85f, 0.7f}};
    shd_material_desc md = shd_material_desc_default();
    shd_light_desc ld = shd_light_desc_default();
    shd_result result = shd_context_create(NULL, &f->context);
    md.model = SHD_MODEL_BLINN_PHONG;
    md.specular[0] = md.specular[1] = md.specular[2] = 0.3f;
    md.exponent = 30.0f;
    md.flags = SHD_MATERIAL_DOUBLE_SIDED;
    if (result == SHD_OK) result = shd_material_create(f->context, &md, &f->material);
    ld.position[0] = -3.0f, ld.position[1] = 5.0f, ld.position[2] = 5.0f;
    ld.intensity[0] = ld.intensity[1] = ld.intensity[2] = 75.0f;
    if (result == SHD_OK) result = shd_light_create(f->context, &ld, &f->light);
    if (result == SHD_OK) result = make_volume(f, 0, cloud_density, k_cloud, NULL);
    if (result == SHD_OK) result = make_volume(f, 1, open_head_density, k_head_points, f->material);
    return result;
}

static shd_result render(struct frame *f)
{
    shd_volume_draw draws[VOLUMES] = {shd_volume_draw_default(), shd_volume_draw_default()};
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_camera camera = shd_camera_default();
    shd_result result;
    fd.width = WIDTH, fd.height = HEIGHT;
    if ((result = shd_framebuffer_create(f->context, &fd, &f->framebuffer)) != SHD_OK) return result;
    draws[0].volume = f->volume[0], draws[1].volume = f->volume[1];
    draws[0].object_to_world[12] = -1.15f, draws[1].object_to_world[12] = 1.15f;
    draws[1].object_to_world[5] = draws[1].object_to_world[10] = 0.0f; /* z of the head points up */
    draws[1].object_to_world[6] = -1.0f, draws[1].object_to_world[9] = 1.0f;
    camera.eye[1] = 1.2f, camera.eye[2] = 4.2f;
    camera.fov_y = 0.6f;
    rd.framebuffer = f->framebuffer;
    rd.camera = &camera;
    rd.clear_color[0] = 0.05f, rd.clear_color[1] = 0.12f, rd.clear_color[2] = 0.3f, rd.clear_color[3] = 1.0f;
    rd.lights = (const shd_light *const *)&f->light;
    rd.light_count = 1;
    rd.volumes = draws;
    rd.volume_count = VOLUMES;
    return shd_render(f->context, &rd);
}

/* The middle of the cloud is bright; the corner of the picture is the sky. */
static int check(const shd_framebuffer *framebuffer)
{
    shd_plane_view red = shd_plane_view_default();
    size_t row;
    if (shd_framebuffer_view_plane(framebuffer, SHD_PLANE_R, &red) != SHD_OK) return 0;
    row = red.row_stride / sizeof(float);
    return red.f32[HEIGHT / 2 * row + WIDTH / 4] > 0.3f && red.f32[HEIGHT / 2 * row + 3 * WIDTH / 4] > 0.02f &&
           red.f32[0] == 0.05f;
}

int main(void)
{
    struct frame f = {NULL};
    int i, good = make(&f) == SHD_OK && render(&f) == SHD_OK && check(f.framebuffer);
#ifdef EXAMPLE_HAS_IO
    good = good && shd_framebuffer_save(f.framebuffer, "volume.png", NULL) == SHD_OK && puts("volume.png written") >= 0;
#endif
    if (!good) fprintf(stderr, "volume: wrong picture or error: %s\n", shd_last_error());
    shd_framebuffer_release(f.framebuffer);
    for (i = 0; i < VOLUMES; ++i) shd_volume_release(f.volume[i]), shd_texture_release(f.texture[i]);
    shd_light_release(f.light);
    shd_material_release(f.material);
    shd_context_release(f.context);
    return good ? 0 : 1;
}
