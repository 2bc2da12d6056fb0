/* SPDX-License-Identifier: MIT */
/* Blinn-Phong with one colour: a built-in model of shd, written as a program. */
#include "course.h"

static void shade(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const struct course *course = (const struct course *)user_data;
    size_t i;
    for (i = 0; i < in->count; ++i) {
        const float point[3] = {in->px[i], in->py[i], in->pz[i]};
        const float normal[3] = {in->nx[i], in->ny[i], in->nz[i]};
        float color[3];
        blinn_phong(&course->options.shading, k_color, point, normal, color);
        out->r[i] = color[0], out->g[i] = color[1], out->b[i] = color[2];
    }
}

/* The built-in Blinn-Phong model in the textbook form gives the same picture. The lamps of the assignment show
   the model: its mean is above a fifth. */
static int check(struct course *course, const shd_framebuffer *frame)
{
    const struct shading *s = &course->options.shading;
    shd_material_desc model = shd_material_desc_default();
    shd_framebuffer *expected = NULL;
    double difference = 1e9;
    int c;
    model.model = SHD_MODEL_BLINN_PHONG;
    model.flags = SHD_MATERIAL_SPECULAR_UNGATED | SHD_MATERIAL_AMBIENT_PER_LIGHT;
    model.exponent = s->exponent;
    for (c = 0; c < 3; ++c) {
        model.ambient[c] = s->ambient, model.diffuse[c] = k_color[c], model.specular[c] = s->specular;
    }
    if (course->options.is_default && course_brightness(frame) < 0.2) return 0;
    if (course_render(course, &model, 1, &expected) == SHD_OK) difference = course_difference(frame, expected);
    shd_framebuffer_release(expected);
    return difference < 1e-3;
}

int main(int argc, char **argv)
{
    const struct course_program program = {"phong", 0, shade, check};
    return course_main(argc, argv, &program);
}
