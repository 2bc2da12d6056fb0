/* SPDX-License-Identifier: MIT */
/* Program the fragment stage: your own shading code, thousands of fragments per call, as columns. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>

enum { WIDTH = 320, HEIGHT = 200 };

/* Two triangles that fill the view; here clip space equals object space. */
static const float k_x[4] = {-1, 1, 1, -1}, k_y[4] = {-1, -1, 1, 1}, k_z[4] = {0.5f, 0.5f, 0.5f, 0.5f};
static const float k_u[4] = {0, 1, 1, 0}, k_v[4] = {1, 1, 0, 0}; /* v grows downwards */
static const uint32_t k_indices[6] = {0, 1, 2, 0, 2, 3};

static void uv_as_colour(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const float *blue = (const float *)user_data;
    size_t i;
    for (i = 0; i < in->count; ++i) {
        out->r[i] = in->u[i];
        out->g[i] = in->v[i];
        out->b[i] = *blue;
    }
}

/* Pixel (x, y) must show the texture coordinates of its centre. */
static int check(const shd_framebuffer *framebuffer)
{
    shd_plane_view r = shd_plane_view_default(), g = shd_plane_view_default(), b = shd_plane_view_default();
    int x, y;
    if (shd_framebuffer_view_plane(framebuffer, SHD_PLANE_R, &r) != SHD_OK ||
        shd_framebuffer_view_plane(framebuffer, SHD_PLANE_G, &g) != SHD_OK ||
        shd_framebuffer_view_plane(framebuffer, SHD_PLANE_B, &b) != SHD_OK) {
        return 0;
    }
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            size_t i = (size_t)y * (r.row_stride / sizeof(float)) + (size_t)x;
            if (!(fabsf(r.f32[i] - ((float)x + 0.5f) / WIDTH) < 1e-5f)) return 0;
            if (!(fabsf(g.f32[i] - ((float)y + 0.5f) / HEIGHT) < 1e-5f)) return 0;
            if (b.f32[i] != 0.25f) return 0;
        }
    }
    return 1;
}

int main(void)
{
    float blue = 0.25f;
    int good = 0;
    shd_context *context = NULL;
    shd_mesh *mesh = NULL;
    shd_material *material = NULL;
    shd_framebuffer *framebuffer = NULL;
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    shd_material_desc material_desc = shd_material_desc_default();
    shd_framebuffer_desc framebuffer_desc = shd_framebuffer_desc_default();
    shd_render_desc frame = shd_render_desc_default(); /* identity view */
    shd_draw draw = shd_draw_default();

    mesh_desc.vertex_count = 4;
    mesh_desc.position[0].data = k_x, mesh_desc.position[1].data = k_y, mesh_desc.position[2].data = k_z;
    mesh_desc.uv[0].data = k_u, mesh_desc.uv[1].data = k_v;
    mesh_desc.indices.data = k_indices;
    mesh_desc.index_count = 6;
    material_desc.model = SHD_MODEL_PROGRAM;
    material_desc.program.fragment = uv_as_colour; /* runs concurrently on the executor's workers */
    material_desc.program.user_data = &blue;
    framebuffer_desc.width = WIDTH, framebuffer_desc.height = HEIGHT;

    if (shd_context_create(NULL, &context) == SHD_OK && shd_mesh_create(context, &mesh_desc, &mesh) == SHD_OK &&
        shd_material_create(context, &material_desc, &material) == SHD_OK &&
        shd_framebuffer_create(context, &framebuffer_desc, &framebuffer) == SHD_OK) {
        draw.mesh = mesh, draw.material = material;
        frame.framebuffer = framebuffer;
        frame.draws = &draw, frame.draw_count = 1;
        if (shd_render(context, &frame) == SHD_OK) good = check(framebuffer);
    }
    if (good) {
        printf("%d fragments carry their texture coordinates\n", WIDTH * HEIGHT);
    } else {
        fprintf(stderr, "program: wrong picture or error: %s\n", shd_last_error());
    }
    shd_framebuffer_release(framebuffer);
    shd_material_release(material);
    shd_mesh_release(mesh);
    shd_context_release(context);
    return good ? 0 : 1;
}
