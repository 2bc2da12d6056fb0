/* SPDX-License-Identifier: MIT */
/* Bump mapping: shows the normal that results from a height map as a colour; negative components are black. */
#include "course.h"

static void shade(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const struct course *course = (const struct course *)user_data;
    struct course_texels here, next_u, next_v;
    size_t first, count, k;
    for (first = 0; first < in->count; first += count) {
        count = course_rows(in, first);
        course_look_up(course, in, first, count, 0.0f, 0.0f, &here);
        course_look_up(course, in, first, count, 1.0f / course->texels_u, 0.0f, &next_u);
        course_look_up(course, in, first, count, 0.0f, -1.0f / course->texels_v, &next_v); /* the course's v is up */
        for (k = 0; k < count; ++k) {
            const size_t i = first + k;
            float normal[3] = {in->nx[i], in->ny[i], in->nz[i]};
            tilt(&course->options.shading, height_of(here.r[k], here.g[k], here.b[k]),
                 height_of(next_u.r[k], next_u.g[k], next_u.b[k]), height_of(next_v.r[k], next_v.g[k], next_v.b[k]),
                 normal);
            out->r[i] = normal[0], out->g[i] = normal[1], out->b[i] = normal[2];
        }
    }
}

static void plain_normal(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) out->r[i] = in->nx[i], out->g[i] = in->ny[i], out->b[i] = in->nz[i];
}

/* The relief tilts normals; without it they equal the model's normals. */
static int check(struct course *course, const shd_framebuffer *frame)
{
    shd_material_desc plain = course_material(course, plain_normal), bumpy = course_material(course, shade);
    shd_framebuffer *expected = NULL, *flat = NULL;
    int good = course_render(course, &plain, 1, &expected) == SHD_OK && course_flatten(course) == SHD_OK &&
               course_render(course, &bumpy, 1, &flat) == SHD_OK;
    good = good && course_difference(flat, expected) < 1e-5 && course_difference(frame, expected) > 0.1;
    shd_framebuffer_release(expected);
    shd_framebuffer_release(flat);
    return good;
}

int main(int argc, char **argv)
{
    const struct course_program program = {"bump", 1, shade, check};
    return course_main(argc, argv, &program);
}
