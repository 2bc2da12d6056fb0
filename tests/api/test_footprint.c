/* SPDX-License-Identifier: MIT */
/* Derivatives for ray tracers, against the hits of neighbouring rays with a plane; refusals and degenerate input. */
#include "support/check.h"
#include "support/context.h"

#include <shd/shd.h>

enum { RAYS = 64 };

/** Rays of one pixel step from an eye through an image plane onto a tilted, sheared surface. */
struct scene {
    float dpdu[3][RAYS], dpdv[3][RAYS];
    float direction[3][RAYS], direction_dx[3][RAYS], direction_dy[3][RAYS];
    float origin_dx[3][RAYS], origin_dy[3][RAYS], distance[RAYS], width[RAYS];
    float out[4][RAYS];
};
static struct scene g;

static const double k_u[3] = {1.5, 0.25, -0.5}, k_v[3] = {-0.5, 0.75, 2.0}, k_origin[3] = {0.0, -1.5, -0.5};

static void cross(const double *a, const double *b, double *out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}
static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/** Surface coordinates and distance of the hit of a ray with the plane. */
static void hit(const double *eye, const double *direction, double *uv, double *distance)
{
    double normal[3], offset[3], point[3], n2, a[3], b[3];
    int c;
    cross(k_u, k_v, normal);
    for (c = 0; c < 3; ++c) offset[c] = k_origin[c] - eye[c];
    *distance = dot(offset, normal) / dot(direction, normal);
    for (c = 0; c < 3; ++c) point[c] = *distance * direction[c] - offset[c];
    n2 = dot(normal, normal);
    cross(point, k_v, a);
    cross(k_u, point, b);
    uv[0] = dot(a, normal) / n2;
    uv[1] = dot(b, normal) / n2;
}

/** The ray of pixel position (x, y). The eye moves with x too, as with a sheared lens. */
static void ray(double x, double y, double *eye, double *direction)
{
    eye[0] = 0.01 * x;
    eye[1] = 2.0;
    eye[2] = 4.0 - 0.02 * y;
    direction[0] = -0.8 + 0.2 * x;
    direction[1] = -1.6 + 0.1 * y;
    direction[2] = -1.0 - 0.05 * x;
}

static void make_rays(void)
{
    int i, c;
    for (i = 0; i < RAYS; ++i) {
        double eye[3], direction[3], uv[2], distance;
        const double dx[3] = {0.2, 0.0, -0.05}, dy[3] = {0.0, 0.1, 0.0};
        const double ox[3] = {0.01, 0.0, 0.0}, oy[3] = {0.0, 0.0, -0.02};
        ray(i % 8, i / 8, eye, direction);
        hit(eye, direction, uv, &distance);
        g.distance[i] = (float)distance;
        g.width[i] = 0.25f;
        for (c = 0; c < 3; ++c) {
            g.dpdu[c][i] = (float)k_u[c];
            g.dpdv[c][i] = (float)k_v[c];
            g.direction[c][i] = (float)direction[c];
            g.direction_dx[c][i] = (float)dx[c];
            g.direction_dy[c][i] = (float)dy[c];
            g.origin_dx[c][i] = (float)ox[c];
            g.origin_dy[c][i] = (float)oy[c];
        }
    }
}

static shd_ray_differentials differentials(size_t count)
{
    shd_ray_differentials rays = shd_ray_differentials_default();
    int c;
    rays.count = count;
    rays.distance.data = g.distance;
    for (c = 0; c < 3; ++c) {
        rays.dpdu[c].data = g.dpdu[c];
        rays.dpdv[c].data = g.dpdv[c];
        rays.direction[c].data = g.direction[c];
        rays.direction_dx[c].data = g.direction_dx[c];
        rays.direction_dy[c].data = g.direction_dy[c];
        rays.origin_dx[c].data = g.origin_dx[c];
        rays.origin_dy[c].data = g.origin_dy[c];
    }
    return rays;
}

static shd_ray_cones cones(size_t count)
{
    shd_ray_cones in = shd_ray_cones_default();
    int c;
    in.count = count;
    in.width.data = g.width;
    for (c = 0; c < 3; ++c) {
        in.dpdu[c].data = g.dpdu[c];
        in.dpdv[c].data = g.dpdv[c];
        in.direction[c].data = g.direction[c];
    }
    return in;
}

static shd_derivatives outputs(void)
{
    shd_derivatives out = shd_derivatives_default();
    out.dudx.data = g.out[0];
    out.dvdx.data = g.out[1];
    out.dudy.data = g.out[2];
    out.dvdy.data = g.out[3];
    return out;
}

/** The derivative of the hit point, by central differences in double. */
static void test_differentials(void **state)
{
    const double h = 1e-5;
    int i, c;
    (void)state;
    make_rays();
    {
        const shd_ray_differentials rays = differentials(RAYS);
        shd_derivatives out = outputs();
        shd_assert_ok(shd_derivatives_from_differentials(g_context, &rays, &out));
    }
    for (i = 0; i < RAYS; ++i) {
        for (c = 0; c < 4; ++c) {
            const double x = i % 8, y = i / 8, dx = c < 2 ? h : 0, dy = c < 2 ? 0 : h;
            double eye[3], direction[3], before[2], after[2], distance;
            ray(x - dx, y - dy, eye, direction);
            hit(eye, direction, before, &distance);
            ray(x + dx, y + dy, eye, direction);
            hit(eye, direction, after, &distance);
            shd_assert_close("derivative", (size_t)(4 * i + c), (double)g.out[c][i],
                             (after[c % 2] - before[c % 2]) / (2 * h), 1e-6, 1e-5);
        }
    }
}

/** The ellipse of a cone has the length width / cosine along the ray and the width of the cone across it. */
static void test_cones(void **state)
{
    double normal[3];
    int i, c;
    (void)state;
    make_rays();
    cross(k_u, k_v, normal);
    {
        const shd_ray_cones in = cones(RAYS);
        shd_derivatives out = outputs();
        shd_assert_ok(shd_derivatives_from_cones(g_context, &in, &out));
    }
    for (i = 0; i < RAYS; ++i) {
        double along[3], across[3], direction[3], cosine, projected;
        for (c = 0; c < 3; ++c) {
            along[c] = (double)g.out[0][i] * k_u[c] + (double)g.out[1][i] * k_v[c];
            across[c] = (double)g.out[2][i] * k_u[c] + (double)g.out[3][i] * k_v[c];
            direction[c] = (double)g.direction[c][i];
        }
        cosine = fabs(dot(direction, normal)) / sqrt(dot(direction, direction) * dot(normal, normal));
        projected = dot(along, direction) / sqrt(dot(along, along) * dot(direction, direction));
        shd_assert_close("along", (size_t)i, sqrt(dot(along, along)), 0.25 / cosine, 0, 1e-5);
        shd_assert_close("across", (size_t)i, sqrt(dot(across, across)), 0.25, 0, 1e-5);
        shd_assert_close("perpendicular", (size_t)i, dot(along, across), 0, 1e-6, 0);
        shd_assert_close("projection", (size_t)i, projected, sqrt(1 - cosine * cosine), 1e-5, 0);
    }
}

/**
 * For a perpendicular ray the ellipse is a circle; for a nearly parallel ray it has the length of the smallest angle.
 */
static void test_cone_limits(void **state)
{
    static const float k_directions[3][3] = {{0, 0, -1}, {1, 0, 0}, {0, 0, 3}};
    static const double k_along[3] = {0.5, 512, 0.5};
    int i, c;
    (void)state;
    for (i = 0; i < 3; ++i) {
        for (c = 0; c < 3; ++c) {
            g.dpdu[c][i] = c == 0 ? 2.0f : 0.0f;
            g.dpdv[c][i] = c == 1 ? 4.0f : 0.0f;
            g.direction[c][i] = k_directions[i][c];
        }
        g.width[i] = 0.5f;
    }
    {
        const shd_ray_cones in = cones(3);
        shd_derivatives out = outputs();
        shd_assert_ok(shd_derivatives_from_cones(g_context, &in, &out));
    }
    for (i = 0; i < 3; ++i) {
        shd_assert_close("dudx", (size_t)i, fabs((double)g.out[0][i]), k_along[i] / 2, 0, 1e-6);
        shd_assert_close("dvdx", (size_t)i, (double)g.out[1][i], 0, 1e-6, 0);
        shd_assert_close("dudy", (size_t)i, (double)g.out[2][i], 0, 1e-6, 0);
        shd_assert_close("dvdy", (size_t)i, fabs((double)g.out[3][i]), 0.125, 0, 1e-6);
    }
}

/** Each column of ray 0 in turn gets every bad value: the result is finite, and the result of ray 1 does not change. */
static void test_degenerate(void **state)
{
    static const float k_values[] = {NAN, INFINITY, -INFINITY, 0.0f, 1e-45f, 3e38f, -3e38f};
    float *const columns[] = {g.dpdu[0],      g.dpdv[1],         g.direction[1],    g.distance,
                              g.origin_dx[0], g.direction_dx[0], g.direction_dy[1], g.width};
    size_t column, value, c;
    float want[2][4];
    shd_derivatives out = outputs();
    const shd_ray_differentials rays = differentials(2);
    const shd_ray_cones in = cones(2);
    (void)state;
    make_rays();
    shd_assert_ok(shd_derivatives_from_differentials(g_context, &rays, &out));
    for (c = 0; c < 4; ++c) want[0][c] = g.out[c][1];
    shd_assert_ok(shd_derivatives_from_cones(g_context, &in, &out));
    for (c = 0; c < 4; ++c) want[1][c] = g.out[c][1];
    for (column = 0; column < sizeof columns / sizeof columns[0]; ++column) {
        for (value = 0; value < sizeof k_values / sizeof k_values[0]; ++value) {
            make_rays();
            columns[column][0] = k_values[value];
            shd_assert_ok(shd_derivatives_from_differentials(g_context, &rays, &out));
            for (c = 0; c < 4; ++c) {
                assert_true(isfinite(g.out[c][0]));
                assert_true(g.out[c][1] == want[0][c]);
            }
            shd_assert_ok(shd_derivatives_from_cones(g_context, &in, &out));
            for (c = 0; c < 4; ++c) {
                assert_true(isfinite(g.out[c][0]));
                assert_true(g.out[c][1] == want[1][c]);
            }
        }
    }
}

/** A surface without area, or no surface at all, has no derivatives. */
static void test_no_area(void **state)
{
    int i, c;
    (void)state;
    make_rays();
    for (i = 0; i < 2; ++i) {
        for (c = 0; c < 3; ++c) {
            g.dpdu[c][i] = i == 0 ? (float)(c + 1) : 0.0f;
            g.dpdv[c][i] = i == 0 ? 2.0f * (float)(c + 1) : 0.0f;
        }
    }
    {
        const shd_ray_differentials rays = differentials(2);
        const shd_ray_cones in = cones(2);
        shd_derivatives out = outputs();
        shd_assert_ok(shd_derivatives_from_differentials(g_context, &rays, &out));
        for (c = 0; c < 4; ++c) assert_true(g.out[c][0] == 0 && g.out[c][1] == 0);
        shd_assert_ok(shd_derivatives_from_cones(g_context, &in, &out));
        for (c = 0; c < 4; ++c) assert_true(g.out[c][0] == 0 && g.out[c][1] == 0);
    }
}

struct argument_case {
    const char *name;
    void (*edit)(shd_ray_differentials *rays, shd_ray_cones *in, shd_derivatives *out);
    const char *rays_message, *cones_message; /**< "" = accepted */
};
static void edit_nothing(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o) { (void)r, (void)i, (void)o; }
static void edit_empty(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    *r = shd_ray_differentials_default();
    *i = shd_ray_cones_default();
    *o = shd_derivatives_default();
}
static void edit_size(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    r->struct_size = i->struct_size = 4;
    (void)o;
}
static void edit_no_dpdu(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    r->dpdu[2].data = i->dpdu[2].data = NULL;
    (void)o;
}
static void edit_no_direction(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    r->direction[0].data = i->direction[0].data = NULL;
    (void)o;
}
static void edit_stride(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    r->dpdv[1].stride = i->dpdv[1].stride = 6;
    (void)o;
}
static void edit_overflow(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    r->count = i->count = SIZE_MAX / 2;
    (void)o;
}
static void edit_optional(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    memset(r->origin_dx, 0, sizeof r->origin_dx);
    memset(&r->distance, 0, sizeof r->distance);
    o->dvdx.data = NULL;
    (void)i;
}
static void edit_out_is_in(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    r->dpdv[2].data = i->dpdv[2].data = o->dudy.data;
    r->dpdv[2].stride = i->dpdv[2].stride = o->dudy.stride;
}
static void edit_outs_overlap(shd_ray_differentials *r, shd_ray_cones *i, shd_derivatives *o)
{
    o->dvdy = o->dvdx;
    (void)r, (void)i;
}

static const struct argument_case k_arguments[] = {
    {"arguments/all", edit_nothing, "", ""},
    {"arguments/empty", edit_empty, "", ""},
    {"arguments/optional_absent", edit_optional, "", ""},
    {"arguments/struct_size", edit_size, "rays.struct_size: 4", "cones.struct_size: 4"},
    {"arguments/no_dpdu", edit_no_dpdu, "rays.dpdu[2].data: NULL", "cones.dpdu[2].data: NULL"},
    {"arguments/no_direction", edit_no_direction, "rays.direction[0].data: NULL", "cones.direction[0].data: NULL"},
    {"arguments/stride", edit_stride, "rays.dpdv[1].stride: 6", "cones.dpdv[1].stride: 6"},
    {"arguments/overflow", edit_overflow, "exceed the address space", "exceed the address space"},
    {"arguments/out_is_in", edit_out_is_in, "derivatives.dudy: overlaps rays.dpdv[2]",
     "derivatives.dudy: overlaps cones.dpdv[2]"},
    {"arguments/outs_overlap", edit_outs_overlap, "derivatives.dvdy: overlaps derivatives.dvdx",
     "derivatives.dvdy: overlaps derivatives.dvdx"},
};

static void test_arguments(void **state)
{
    const struct argument_case *c = (const struct argument_case *)*state;
    shd_ray_differentials rays = differentials(RAYS);
    shd_ray_cones in = cones(RAYS);
    shd_derivatives out = outputs();
    make_rays();
    c->edit(&rays, &in, &out);
    shd_assert_result(c->name, shd_derivatives_from_differentials(g_context, &rays, &out),
                      c->rays_message[0] ? SHD_ERROR_INVALID_ARGUMENT : SHD_OK, c->rays_message);
    shd_assert_result(c->name, shd_derivatives_from_cones(g_context, &in, &out),
                      c->cones_message[0] ? SHD_ERROR_INVALID_ARGUMENT : SHD_OK, c->cones_message);
}

static void test_null(void **state)
{
    const shd_ray_differentials rays = differentials(1);
    const shd_ray_cones in = cones(1);
    shd_derivatives out = outputs();
    (void)state;
    shd_assert_result("rays", shd_derivatives_from_differentials(g_context, NULL, &out), SHD_ERROR_INVALID_ARGUMENT,
                      "rays: NULL");
    shd_assert_result("out", shd_derivatives_from_differentials(g_context, &rays, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "derivatives: NULL");
    shd_assert_result("cones", shd_derivatives_from_cones(g_context, NULL, &out), SHD_ERROR_INVALID_ARGUMENT,
                      "cones: NULL");
    shd_assert_result("out", shd_derivatives_from_cones(g_context, &in, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "derivatives: NULL");
}

int main(void)
{
    struct CMUnitTest tests[24];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_arguments / sizeof k_arguments[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_arguments[i].name, test_arguments, NULL, NULL, (void *)&k_arguments[i]};
    }
    tests[n++] = (struct CMUnitTest){"null", test_null, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"differentials", test_differentials, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"cones", test_cones, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"cone_limits", test_cone_limits, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"degenerate", test_degenerate, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"no_area", test_no_area, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.footprint", tests, n, set_up, tear_down);
}
