/* SPDX-License-Identifier: MIT */
/* Blinn-Phong with k_d from a texture, which the program looks up: filtered over the footprint of each fragment. */
#include "course.h"

static void shade(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const struct course *course = (const struct course *)user_data;
    struct course_texels texels;
    size_t first, count, k;
    for (first = 0; first < in->count; first += count) {
        count = course_rows(in, first);
        course_look_up(course, in, first, count, 0.0f, 0.0f, &texels);
        for (k = 0; k < count; ++k) {
            const size_t i = first + k;
            const float kd[3] = {texels.r[k], texels.g[k], texels.b[k]};
            const float point[3] = {in->px[i], in->py[i], in->pz[i]};
            const float normal[3] = {in->nx[i], in->ny[i], in->nz[i]};
            float color[3];
            blinn_phong(&course->options.shading, kd, point, normal, color);
            out->r[i] = color[0], out->g[i] = color[1], out->b[i] = color[2];
        }
    }
}

/* The built-in Blinn-Phong model with the texture in its diffuse slot gives the same picture. */
static int check(struct course *course, const shd_framebuffer *frame)
{
    const struct shading *s = &course->options.shading;
    const shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, course->texture, course->sampler);
    shd_material_desc model = shd_material_desc_default();
    shd_framebuffer *expected = NULL;
    double difference = 1e9;
    int c;
    model.model = SHD_MODEL_BLINN_PHONG;
    model.flags = SHD_MATERIAL_SPECULAR_UNGATED | SHD_MATERIAL_AMBIENT_PER_LIGHT;
    model.exponent = s->exponent;
    model.slots = &slot, model.slot_count = 1;
    for (c = 0; c < 3; ++c) model.ambient[c] = s->ambient, model.diffuse[c] = 1.0f, model.specular[c] = s->specular;
    if (course_render(course, &model, 1, &expected) == SHD_OK) difference = course_difference(frame, expected);
    shd_framebuffer_release(expected);
    return difference < 1e-3;
}

int main(int argc, char **argv)
{
    const struct course_program program = {"texture", 0, shade, check};
    return course_main(argc, argv, &program);
}
