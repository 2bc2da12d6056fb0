/* SPDX-License-Identifier: MIT */
/*
 * Displacement per fragment: Blinn-Phong with the normal of the bumps, at a point moved along the model's normal. The
 * outline does not change; changing it requires moving vertices.
 *
 * The assignment moves the point by kn times a height of up to 255 sqrt(3), so that some points lie behind the lights.
 * The lecture does not move it. --move chooses; "small" moves it by heights in 0..1. The slopes are the same.
 */
#include "course.h"

static void shade(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const struct course *course = (const struct course *)user_data;
    const float kn = course->options.shading.kn;
    const float factor = course->options.move == COURSE_MOVE_HOMEWORK ? kn
                         : course->options.move == COURSE_MOVE_NOTES  ? 0.0f
                                                                      : kn / 255.0f;
    struct course_texels here, next_u, next_v;
    size_t first, count, k;
    for (first = 0; first < in->count; first += count) {
        count = course_rows(in, first);
        course_look_up(course, in, first, count, 0.0f, 0.0f, &here);
        course_look_up(course, in, first, count, 1.0f / course->texels_u, 0.0f, &next_u);
        course_look_up(course, in, first, count, 0.0f, -1.0f / course->texels_v, &next_v); /* the course's v is up */
        for (k = 0; k < count; ++k) {
            const size_t i = first + k;
            const float height = height_of(here.r[k], here.g[k], here.b[k]);
            const float move = factor * height;
            float normal[3] = {in->nx[i], in->ny[i], in->nz[i]}, point[3], color[3];
            point[0] = in->px[i] + move * normal[0];
            point[1] = in->py[i] + move * normal[1];
            point[2] = in->pz[i] + move * normal[2];
            tilt(&course->options.shading, height, height_of(next_u.r[k], next_u.g[k], next_u.b[k]),
                 height_of(next_v.r[k], next_v.g[k], next_v.b[k]), normal);
            blinn_phong(&course->options.shading, k_color, point, normal, color);
            out->r[i] = color[0], out->g[i] = color[1], out->b[i] = color[2];
        }
    }
}

static void plain(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const struct course *course = (const struct course *)user_data;
    size_t i;
    for (i = 0; i < in->count; ++i) {
        const float point[3] = {in->px[i], in->py[i], in->pz[i]}, normal[3] = {in->nx[i], in->ny[i], in->nz[i]};
        float color[3];
        blinn_phong(&course->options.shading, k_color, point, normal, color);
        out->r[i] = color[0], out->g[i] = color[1], out->b[i] = color[2];
    }
}

/* The relief changes the picture. Without the relief the result is plain Blinn-Phong. */
static int check(struct course *course, const shd_framebuffer *frame)
{
    shd_material_desc smooth = course_material(course, plain), displaced = course_material(course, shade);
    shd_framebuffer *expected = NULL, *flat = NULL;
    int good = course_render(course, &smooth, 1, &expected) == SHD_OK && course_flatten(course) == SHD_OK &&
               course_render(course, &displaced, 1, &flat) == SHD_OK;
    good = good && course_difference(flat, expected) < 1e-4 && course_difference(frame, expected) > 0.1;
    shd_framebuffer_release(expected);
    shd_framebuffer_release(flat);
    return good;
}

int main(int argc, char **argv)
{
    const struct course_program program = {"displacement", 1, shade, check};
    return course_main(argc, argv, &program);
}
