/* SPDX-License-Identifier: MIT */
/* Directions to points and back through the C API: columns of any stride, batch splits, and bad inputs. */
#include "support/check.h"

#include <shd/shd.h>

enum { COUNT = 40000 };
static float g_n[3][COUNT], g_u[COUNT], g_v[COUNT], g_part_u[COUNT], g_part_v[COUNT], g_back[3][COUNT];
static uint32_t g_face[COUNT];
static shd_context *g_context;

static int set_up(void **state)
{
    uint32_t bits = 1;
    size_t i;
    int c;
    (void)state;
    for (i = 0; i < COUNT; ++i) {
        for (c = 0; c < 3; ++c) {
            bits = bits * 1664525u + 1013904223u;
            g_n[c][i] = (float)(bits >> 8) / 8388608.0f - 1.0f;
        }
    }
    return shd_context_create(NULL, &g_context) == SHD_OK ? 0 : -1;
}
static int tear_down(void **state)
{
    (void)state;
    shd_context_release(g_context);
    return 0;
}

static shd_directions directions_at(size_t first, size_t count, shd_projection projection)
{
    shd_directions in = shd_directions_default();
    int c;
    in.projection = projection;
    in.count = count;
    for (c = 0; c < 3; ++c) in.direction[c] = shd_f32_column(g_n[c] + first, 0);
    return in;
}

/** Points of one batch have the bits of points in parts, and lead back to the directions. */
static void test_batches(void **state)
{
    int projection;
    (void)state;
    for (projection = SHD_PROJECTION_LAT_LONG; projection <= SHD_PROJECTION_OCTAHEDRAL; ++projection) {
        shd_directions in = directions_at(0, COUNT, (shd_projection)projection);
        shd_projected_points out = shd_projected_points_default();
        shd_image_points points = shd_image_points_default();
        shd_point_directions back = shd_point_directions_default();
        size_t i;
        int c;
        out.u = shd_f32_out_column(g_u, 0), out.v = shd_f32_out_column(g_v, 0);
        out.face = shd_u32_out_column(g_face, 0);
        shd_assert_ok(shd_projection_project(g_context, &in, &out));
        assert_int_equal(0, out.nonfinite_count);
        for (i = 0; i < COUNT; i += 777) {
            const size_t part = COUNT - i < 777 ? COUNT - i : 777;
            shd_directions some = directions_at(i, part, (shd_projection)projection);
            out.u = shd_f32_out_column(g_part_u + i, 0), out.v = shd_f32_out_column(g_part_v + i, 0);
            out.face = shd_u32_out_column(NULL, 0);
            shd_assert_ok(shd_projection_project(g_context, &some, &out));
        }
        assert_memory_equal(g_u, g_part_u, sizeof g_u);
        assert_memory_equal(g_v, g_part_v, sizeof g_v);
        points.projection = (shd_projection)projection;
        points.count = COUNT;
        points.u = shd_f32_column(g_u, 0), points.v = shd_f32_column(g_v, 0);
        points.face = shd_u32_column(g_face, 0);
        for (c = 0; c < 3; ++c) back.direction[c] = shd_f32_out_column(g_back[c], 0);
        shd_assert_ok(shd_projection_unproject(g_context, &points, &back));
        for (i = 0; i < COUNT; ++i) {
            const double length = sqrt((double)g_n[0][i] * (double)g_n[0][i] + (double)g_n[1][i] * (double)g_n[1][i] +
                                       (double)g_n[2][i] * (double)g_n[2][i]);
            for (c = 0; c < 3; ++c) {
                shd_assert_close("back", i, (double)g_back[c][i], (double)g_n[c][i] / length, 1e-4, 0.0);
            }
        }
    }
}

/** The axes have the points that the header states. */
static void test_axes(void **state)
{
    static const struct {
        shd_projection projection;
        float n[3], u, v;
        uint32_t face;
    } rows[] = {
        {SHD_PROJECTION_LAT_LONG, {0, 0, 1}, 0.5f, 0.5f, 0},
        {SHD_PROJECTION_LAT_LONG, {-1, 0, 0}, 0.75f, 0.5f, 0},
        {SHD_PROJECTION_LAT_LONG, {1, 0, 0}, 0.25f, 0.5f, 0},
        {SHD_PROJECTION_LAT_LONG, {0, 1, 0}, 0.5f, 0.0f, 0},
        {SHD_PROJECTION_LAT_LONG, {0, -1, 0}, 0.5f, 1.0f, 0},
        {SHD_PROJECTION_LAT_LONG, {0, 0, -1}, 1.0f, 0.5f, 0},
        {SHD_PROJECTION_MIRROR_BALL, {0, 0, 1}, 0.5f, 0.5f, 0},
        {SHD_PROJECTION_MIRROR_BALL, {0, 0, -1}, 1.0f, 0.5f, 0},
        {SHD_PROJECTION_MIRROR_BALL, {1, 0, 0}, 0.853553391f, 0.5f, 0},
        {SHD_PROJECTION_MIRROR_BALL, {0, 1, 0}, 0.5f, 0.146446609f, 0},
        {SHD_PROJECTION_ANGULAR, {0, 0, 1}, 0.5f, 0.5f, 0},
        {SHD_PROJECTION_ANGULAR, {1, 0, 0}, 0.75f, 0.5f, 0},
        {SHD_PROJECTION_ANGULAR, {0, 1, 0}, 0.5f, 0.25f, 0},
        {SHD_PROJECTION_CUBE, {1, 0, 0}, 0.5f, 0.5f, 0},
        {SHD_PROJECTION_CUBE, {-1, 0, 0}, 0.5f, 0.5f, 1},
        {SHD_PROJECTION_CUBE, {0, 1, 0}, 0.5f, 0.5f, 2},
        {SHD_PROJECTION_CUBE, {0, -1, 0}, 0.5f, 0.5f, 3},
        {SHD_PROJECTION_CUBE, {0, 0, -1}, 0.5f, 0.5f, 5},
        {SHD_PROJECTION_CUBE, {1, 1, 1}, 1.0f, 0.0f, 4},
        {SHD_PROJECTION_CUBE, {1, 1, 0}, 1.0f, 0.5f, 2},
        {SHD_PROJECTION_CUBE, {4, 2, 1}, 0.375f, 0.25f, 0},
        {SHD_PROJECTION_OCTAHEDRAL, {0, 0, 1}, 0.5f, 0.5f, 0},
        {SHD_PROJECTION_OCTAHEDRAL, {1, 0, 0}, 1.0f, 0.5f, 0},
        {SHD_PROJECTION_OCTAHEDRAL, {0, 1, 0}, 0.5f, 0.0f, 0},
        {SHD_PROJECTION_OCTAHEDRAL, {0, 0, -1}, 1.0f, 0.0f, 0},
        {SHD_PROJECTION_OCTAHEDRAL, {1, 1, 2}, 0.625f, 0.375f, 0},
    };
    size_t i;
    (void)state;
    for (i = 0; i < sizeof rows / sizeof *rows; ++i) {
        shd_directions in = shd_directions_default();
        shd_projected_points out = shd_projected_points_default();
        float u, v;
        uint32_t face;
        int c;
        in.projection = rows[i].projection;
        in.count = 1;
        for (c = 0; c < 3; ++c) in.direction[c] = shd_f32_column(rows[i].n + c, 0);
        out.u = shd_f32_out_column(&u, 0), out.v = shd_f32_out_column(&v, 0), out.face = shd_u32_out_column(&face, 0);
        shd_assert_ok(shd_projection_project(g_context, &in, &out));
        shd_assert_close("u", i, (double)u, (double)rows[i].u, 1.2e-7, 0.0);
        shd_assert_close("v", i, (double)v, (double)rows[i].v, 1.2e-7, 0.0);
        assert_int_equal(rows[i].face, face);
    }
}

/** Points outside of the image, and without finite coordinates. */
static void test_bad_points(void **state)
{
    const float u[] = {NAN, INFINITY, -INFINITY, -3.0f, 7.25f, 0.5f, 1e30f, 0.25f};
    const float v[] = {0.5f, 0.5f, NAN, 0.5f, 0.5f, 1e30f, -1e30f, -INFINITY};
    const uint32_t face[] = {0, 1, 2, 3, 4, 5, 6, 0xffffffffu};
    int projection;
    (void)state;
    for (projection = SHD_PROJECTION_LAT_LONG; projection <= SHD_PROJECTION_OCTAHEDRAL; ++projection) {
        shd_image_points in = shd_image_points_default();
        shd_point_directions out = shd_point_directions_default();
        float n[3][8], solid_angle[8];
        size_t i;
        int c;
        in.projection = (shd_projection)projection;
        in.count = 8;
        in.u = shd_f32_column(u, 0), in.v = shd_f32_column(v, 0), in.face = shd_u32_column(face, 0);
        for (c = 0; c < 3; ++c) out.direction[c] = shd_f32_out_column(n[c], 0);
        out.solid_angle = shd_f32_out_column(solid_angle, 0);
        shd_assert_ok(shd_projection_unproject(g_context, &in, &out));
        assert_int_equal(4, out.nonfinite_count);
        for (i = 0; i < 8; ++i) {
            const double square = (double)n[0][i] * (double)n[0][i] + (double)n[1][i] * (double)n[1][i] +
                                  (double)n[2][i] * (double)n[2][i];
            shd_assert_close("length", i, square, 1.0, 1e-6, 0.0);
            assert_true(isfinite(solid_angle[i]) && solid_angle[i] >= 0.0f);
        }
    }
}

static void test_errors(void **state)
{
    shd_directions in = directions_at(0, 4, SHD_PROJECTION_CUBE);
    shd_projected_points out = shd_projected_points_default();
    shd_image_points points = shd_image_points_default();
    shd_point_directions back = shd_point_directions_default();
    const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
    (void)state;
    out.u = shd_f32_out_column(g_u, 0);
    shd_assert_result("context", shd_projection_project(NULL, &in, &out), bad, "context: NULL");
    shd_assert_result("in", shd_projection_project(g_context, NULL, &out), bad, "directions: NULL");
    shd_assert_result("out", shd_projection_project(g_context, &in, NULL), bad, "points: NULL");
    in.projection = SHD_PROJECTION_NONE;
    shd_assert_result("none", shd_projection_project(g_context, &in, &out), bad,
                      "directions.projection: 0 is not in 1..5");
    in.projection = (shd_projection)6;
    shd_assert_result("six", shd_projection_project(g_context, &in, &out), bad,
                      "directions.projection: 6 is not in 1..5");
    in.projection = SHD_PROJECTION_CUBE;
    in.direction[2].data = NULL;
    shd_assert_result("column", shd_projection_project(g_context, &in, &out), bad, "directions.direction[2]");
    in.direction[2] = shd_f32_column(g_u, 0);
    shd_assert_result("overlap", shd_projection_project(g_context, &in, &out), bad, "overlap");
    points.projection = SHD_PROJECTION_CUBE;
    points.count = 4;
    points.u = shd_f32_column(g_u, 0);
    back.solid_angle = shd_f32_out_column(g_v, 0);
    shd_assert_result("v", shd_projection_unproject(g_context, &points, &back), bad, "points.v");
    points.v = shd_f32_column(g_u, 0);
    points.projection = SHD_PROJECTION_NONE;
    shd_assert_result("none", shd_projection_unproject(g_context, &points, &back), bad,
                      "points.projection: 0 is not in 1..5");
    shd_assert_result("context", shd_projection_unproject(NULL, &points, &back), bad, "context: NULL");
    points.projection = SHD_PROJECTION_LAT_LONG;
    points.count = 0;
    points.u.data = points.v.data = NULL;
    shd_assert_ok(shd_projection_unproject(g_context, &points, &back));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        {"batches", test_batches, NULL, NULL, NULL},
        {"axes", test_axes, NULL, NULL, NULL},
        {"bad_points", test_bad_points, NULL, NULL, NULL},
        {"errors", test_errors, NULL, NULL, NULL},
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
