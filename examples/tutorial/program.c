/* SPDX-License-Identifier: MIT */
/* A teapot whose colours come from a function of this program: program.png. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <shd/io.h>
#include <shd/shd.h>

struct stripes {
    float per_unit; /* stripes in a unit of length */
    float dark[3], bright[3];
};

static void require(shd_result result)
{
    if (result == SHD_OK) return;
    fprintf(stderr, "program: %s\n", shd_last_error());
    exit(EXIT_FAILURE);
}

/* Colours of many fragments. Several threads may call the function concurrently, so it changes nothing but `out`. */
static void shade(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const struct stripes *stripes = (const struct stripes *)user_data;
    size_t i;
    for (i = 0; i < in->count; ++i) {
        float height = in->py[i] * stripes->per_unit;          /* p: the point in the world */
        float mix = fabsf(height - floorf(height) - 0.5f) * 2; /* 0..1 and back in each stripe */
        float facing = in->nx[i] * in->ox[i] + in->ny[i] * in->oy[i] + in->nz[i] * in->oz[i]; /* n . wo */
        float light = 0.25f + 0.75f * fmaxf(facing, 0);
        mix = mix * mix * (3 - 2 * mix);
        out->r[i] = light * (stripes->dark[0] + mix * (stripes->bright[0] - stripes->dark[0]));
        out->g[i] = light * (stripes->dark[1] + mix * (stripes->bright[1] - stripes->dark[1]));
        out->b[i] = light * (stripes->dark[2] + mix * (stripes->bright[2] - stripes->dark[2]));
    }
}

int main(void)
{
    struct stripes stripes = {4, {0.02f, 0.1f, 0.3f}, {0.9f, 0.7f, 0.3f}};
    shd_shape_desc shape = shd_shape_desc_default();
    shd_material_desc material_desc = shd_material_desc_default();
    shd_framebuffer_desc picture_desc = shd_framebuffer_desc_default();
    shd_camera camera = shd_camera_default();
    shd_draw draw = shd_draw_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_context *context = NULL;
    shd_mesh *teapot = NULL;
    shd_material *material = NULL;
    shd_framebuffer *picture = NULL;

    require(shd_context_create(NULL, &context));
    shape.kind = SHD_SHAPE_TEAPOT;
    require(shd_mesh_create_shape(context, &shape, SHD_MESH_NONE, &teapot));
    material_desc.model = SHD_MODEL_PROGRAM;
    material_desc.program.fragment = shade;
    material_desc.program.user_data = &stripes; /* must live as long as the material */
    require(shd_material_create(context, &material_desc, &material));
    picture_desc.width = 480, picture_desc.height = 360;
    picture_desc.sample_count = 8;
    require(shd_framebuffer_create(context, &picture_desc, &picture));

    camera.eye[0] = 2, camera.eye[1] = 3.5f, camera.eye[2] = 7;
    camera.target[1] = 1.4f;
    draw.mesh = teapot, draw.material = material;
    frame.framebuffer = picture, frame.camera = &camera;
    frame.draws = &draw, frame.draw_count = 1;
    require(shd_render(context, &frame));
    require(shd_framebuffer_save(picture, "program.png", NULL));

    shd_framebuffer_release(picture);
    shd_material_release(material);
    shd_mesh_release(teapot);
    shd_context_release(context);
    return EXIT_SUCCESS;
}
