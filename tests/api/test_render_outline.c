/* SPDX-License-Identifier: MIT */
/* Wireframes and points in whole frames: coverage and shading, and equal bits for windows, workers and SIMD targets. */
#include "support/frame.h"
#include "support/scene.h"

enum { EDGE = 64 };

/* Signed distance of a point to the border of the rectangle around the line from a to b [pixels]; > 0 inside. */
static double inside_line(const double *a, const double *b, double width, double x, double y)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = sqrt(dx * dx + dy * dy);
    const double along = ((x - a[0]) * dx + (y - a[1]) * dy) / length;
    const double across = fabs((x - a[0]) * dy - (y - a[1]) * dx) / length;
    return fmin(fmin(along, length - along), width / 2 - across);
}

/* Largest such distance over the five edges of a quad from (x0, y0) to (x1, y1). */
static double inside_quad(const double box[4], double width, double x, double y)
{
    const double corner[4][2] = {{box[0], box[3]}, {box[2], box[3]}, {box[2], box[1]}, {box[0], box[1]}};
    double maximum = inside_line(corner[0], corner[2], width, x, y);
    int i;
    for (i = 0; i < 4; ++i) maximum = fmax(maximum, inside_line(corner[i], corner[(i + 1) % 4], width, x, y));
    return maximum;
}

/* A red quad over pixels [x0, x1] x [y0, y1] at a depth from left to right. */
static shd_draw *add_quad(shd_frame *f, const double box[4], float z0, float z1, const shd_material_desc *material)
{
    float quad[48];
    shd_frame_quad((float)(box[0] / 32 - 1), (float)(1 - box[3] / 32), (float)(box[2] / 32 - 1),
                   (float)(1 - box[1] / 32), z0, z1, quad);
    return shd_frame_draw(f, quad, 6, material);
}

struct border_case {
    const char *name;
    uint32_t samples;
    float width;
    double box[4];
};
static const struct border_case k_borders[] = {
    {"border/width_1", 1, 1, {16, 8, 48, 56}},
    {"border/width_2", 1, 2, {16, 8, 48, 56}},
    {"border/on_centres", 1, 1, {16.5, 8.5, 48.5, 56.5}},
    {"border/width_7", 1, 7, {20, 20, 44, 44}},
    {"border/off_screen", 1, 64, {-20, -60, 90, 120}},
    {"border/samples_4", 4, 1.5f, {16.25, 8.75, 48.5, 55}},
    {"border/samples_16", 16, 3, {10, 8, 61, 50}},
    {"border/thin_samples_16", 16, 0.0625f, {10, 8, 61, 50}},
};

/* A wireframe covers only the border and the diagonal of a quad, and the colour of a pixel is its share of covered
 * samples. Pixels away from the border are fully covered or not covered at all. */
static void test_border(void **state)
{
    const struct border_case *c = (const struct border_case *)*state;
    const double width = (double)c->width, slack = 0.02;
    const shd_material_desc red = shd_frame_plain(1, 0, 0);
    uint32_t x, y, lit = 0, partial = 0;
    shd_draw *draw;
    shd_frame f;
    shd_frame_open_samples(&f, EDGE, EDGE, c->samples);
    draw = add_quad(&f, c->box, 0.25f, 0.75f, &red);
    draw->fill = SHD_FILL_WIREFRAME;
    draw->fill_width = c->width;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    for (y = 0; y < EDGE; ++y) {
        for (x = 0; x < EDGE; ++x) {
            const double reach = c->samples == 1 ? slack : 0.75; /* largest distance of a sample from the centre */
            const double inside = inside_quad(c->box, width, x + 0.5, y + 0.5);
            const double got = (double)f.plane[SHD_PLANE_R][y * EDGE + x];
            if ((inside > reach && got != 1) || (inside < -reach && got != 0)) {
                fail_msg("%s: pixel %u, %u is %g, but %g inside", c->name, x, y, got, inside);
            }
            assert_true(got * c->samples == floor(got * c->samples));
            lit += got > 0;
            partial += got > 0 && got < 1;
        }
    }
    assert_true(lit > 0);
    assert_true((partial > 0) == (c->samples > 1));
    assert_int_equal(f.stats.rasterized_triangle_count, 2);
    shd_frame_close(&f);
}

/* A vertical line along x = 32, 1.5 wide, from -0.75 to +0.75: four samples at x = 2, 6, 10 and 14 sixteenths. */
static void test_average(void **state)
{
    static const float k_want[4] = {0.0f, 0.75f, 0.75f, 0.0f}; /* colours of pixels 30..33 */
    const float line[24] = {0, -2, 0.5f, 0, 0, 1, 0, 0, 0, 2, 0.5f, 0, 0, 1, 0, 0, 0, 2, 0.5f, 0, 0, 1, 0, 0};
    const shd_material_desc red = shd_frame_plain(1, 0, 0);
    uint32_t x, y;
    shd_draw *draw;
    shd_frame f;
    (void)state;
    shd_frame_open_samples(&f, EDGE, EDGE, 4);
    draw = shd_frame_draw(&f, line, 3, &red);
    draw->fill = SHD_FILL_WIREFRAME;
    draw->fill_width = 1.5f;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    for (y = 0; y < EDGE; ++y) {
        for (x = 0; x < 4; ++x) {
            const size_t at = y * EDGE + 30 + x;
            assert_true(f.plane[SHD_PLANE_R][at] == k_want[x] && f.plane[SHD_PLANE_A][at] == k_want[x]);
        }
    }
    shd_frame_close(&f);
}

/* Lines over their own surface: with a bias all lines are visible, and the other pixels show the solid surface. */
static void test_on_top(void **state)
{
    static const double k_box[4] = {9.3, 7.1, 57.9, 51.2};
    const shd_material_desc red = shd_frame_plain(1, 0, 0), green = shd_frame_plain(0, 1, 0);
    uint32_t i, on_line = 0;
    shd_frame f;
    (void)state;
    shd_frame_open(&f, EDGE, EDGE);
    add_quad(&f, k_box, 0.125f, 0.875f, &green);
    add_quad(&f, k_box, 0.125f, 0.875f, &red);
    f.draw[1].fill = SHD_FILL_WIREFRAME;
    f.draw[1].fill_width = 2;
    f.draw[1].depth_bias = -0.03125f; /* more than the change of the surface's depth over half the width */
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    for (i = 0; i < EDGE * EDGE; ++i) {
        const double x = i % EDGE + 0.5, y = i / EDGE + 0.5, inside = inside_quad(k_box, 2, x, y);
        const int solid = x > k_box[0] + 0.02 && x < k_box[2] - 0.02 && y > k_box[1] + 0.02 && y < k_box[3] - 0.02;
        if (inside > 0.02) assert_true(f.plane[SHD_PLANE_R][i] == 1 && f.plane[SHD_PLANE_G][i] == 0);
        if (inside < -0.02) assert_true(f.plane[SHD_PLANE_R][i] == 0);
        if (inside < -0.02 && solid) assert_true(f.plane[SHD_PLANE_G][i] == 1);
        on_line += inside > 0.02;
    }
    assert_true(on_line > 300);
    shd_frame_close(&f);
}

/* Separate points: each covers w * w pixels at any position, with the colour and depth of its vertex. */
static void test_points(void **state)
{
    enum { ACROSS = 5, COUNT = ACROSS * ACROSS };
    static const float k_widths[] = {1, 2, 3, 6};
    const shd_material_desc white = shd_frame_plain(1, 1, 1);
    uint32_t seed = 3, i, w;
    float vertices[COUNT][3][8];
    memset(vertices, 0, sizeof vertices);
    for (i = 0; i < COUNT; ++i) { /* degenerate triangles with one vertex */
        vertices[i][0][0] = ((float)(i % ACROSS) * 12 + 7 + shd_scene_random(&seed)) / 32 - 1;
        vertices[i][0][1] = ((float)(i / ACROSS) * 12 + 7 + shd_scene_random(&seed)) / 32 - 1;
        vertices[i][0][2] = (float)(i + 1) / 32;
        vertices[i][0][5] = 1;
        memcpy(vertices[i][1], vertices[i][0], sizeof vertices[i][0]);
        memcpy(vertices[i][2], vertices[i][0], sizeof vertices[i][0]);
    }
    (void)state;
    for (w = 0; w < sizeof k_widths / sizeof k_widths[0]; ++w) {
        const uint32_t side = (uint32_t)k_widths[w];
        uint32_t of_triangle[COUNT] = {0}, lit = 0;
        shd_draw *draw;
        shd_frame f;
        shd_frame_open(&f, EDGE, EDGE);
        draw = shd_frame_draw(&f, vertices[0][0], 3 * COUNT, &white);
        draw->fill = SHD_FILL_POINTS;
        draw->fill_width = k_widths[w];
        shd_frame_ambient(&f);
        shd_frame_render(&f);
        for (i = 0; i < EDGE * EDGE; ++i) {
            if (f.plane[SHD_PLANE_R][i] == 0) continue;
            ++lit;
            ++of_triangle[f.triangle[i]];
            assert_true(f.plane[SHD_PLANE_DEPTH][i] == (float)(f.triangle[i] + 1) / 32);
        }
        assert_int_equal(lit, COUNT * side * side);
        for (i = 0; i < COUNT; ++i) assert_int_equal(of_triangle[i], side * side);
        assert_int_equal(f.stats.rasterized_triangle_count, COUNT);
        shd_frame_close(&f);
    }
}

/* A shared edge: with a depth test it is drawn once; with SHD_DRAW_KEEP_DEPTH blending adds it twice. */
static void test_shared_edge(void **state)
{
    static const double k_box[4] = {8, 8, 56, 56};
    const int keeps = *(const int *)*state;
    shd_material_desc add = shd_frame_plain(0.25f, 0, 0);
    uint32_t i, once = 0, twice = 0;
    shd_draw *draw;
    shd_frame f;
    add.blend = SHD_BLEND_ADD;
    shd_frame_open(&f, EDGE, EDGE);
    draw = add_quad(&f, k_box, 0.5f, 0.5f, &add);
    draw->fill = SHD_FILL_WIREFRAME;
    draw->flags = keeps ? SHD_DRAW_KEEP_DEPTH : SHD_DRAW_NONE;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    for (i = 0; i < 40; ++i) { /* along the diagonal, away from its ends, and along the top */
        const float on_diagonal = f.plane[SHD_PLANE_R][(51 - i) * EDGE + 12 + i];
        const float on_top = f.plane[SHD_PLANE_R][7 * EDGE + 12 + i];
        assert_true(on_top == 0.25f);
        once += on_diagonal == 0.25f;
        twice += on_diagonal == 0.5f;
    }
    assert_int_equal(once, keeps ? 0 : 40);
    assert_int_equal(twice, keeps ? 40 : 0);
    shd_frame_close(&f);
}

/* Counts the rows of a program, and writes uv and nz as colour. */
static void shade_by_uv(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    *(size_t *)user_data += in->count;
    for (i = 0; i < in->count; ++i) {
        out->r[i] = in->u[i];
        out->g[i] = in->v[i];
        out->b[i] = in->nz[i];
    }
}

struct shading_case {
    const char *name;
    shd_frequency frequency;
    int program;
};
static const struct shading_case k_shadings[] = {
    {"shading/phong", SHD_FREQUENCY_PHONG, 0},
    {"shading/gouraud", SHD_FREQUENCY_GOURAUD, 0},
    {"shading/flat", SHD_FREQUENCY_FLAT, 0},
    {"shading/program", SHD_FREQUENCY_PHONG, 1},
};

/* A pixel of a line that the solid triangle also covers has the colour and coordinates of the solid triangle. */
static void test_shading(void **state)
{
    static const double k_box[4] = {5.5, 9.25, 58.1, 60.3};
    static float solid[5][EDGE * EDGE];
    static uint32_t solid_triangle[EDGE * EDGE];
    static const shd_plane k_planes[5] = {SHD_PLANE_R, SHD_PLANE_G, SHD_PLANE_B, SHD_PLANE_U, SHD_PLANE_V};
    const struct shading_case *c = (const struct shading_case *)*state;
    shd_material_desc material = shd_frame_plain(0.2f, 0.3f, 0.4f);
    shd_light_desc light = shd_light_desc_default();
    size_t rows = 0, i, plane, same = 0;
    shd_draw *draw;
    shd_frame f;
    material.diffuse[0] = material.diffuse[1] = 0.75f;
    if (c->program) {
        material.model = SHD_MODEL_PROGRAM;
        material.program.fragment = shade_by_uv;
        material.program.user_data = &rows;
    }
    light.kind = SHD_LIGHT_KIND_POINT;
    light.position[0] = 0.5f;
    light.position[2] = 2.0f;
    shd_frame_open(&f, EDGE, EDGE);
    f.desc.view.eye[2] = 3.0f;
    draw = add_quad(&f, k_box, 0.25f, 0.75f, &material);
    draw->frequency = c->frequency;
    shd_frame_light(&f, &light);
    shd_frame_render(&f);
    for (plane = 0; plane < 5; ++plane) memcpy(solid[plane], f.plane[k_planes[plane]], sizeof solid[0]);
    memcpy(solid_triangle, f.triangle, sizeof solid_triangle);
    draw->fill = SHD_FILL_WIREFRAME;
    draw->fill_width = 3;
    rows = 0;
    if (c->program) { /* one thread, because the program counts without a lock */
        shd_context_desc one = shd_context_desc_default();
        one.worker_count = 1;
        shd_context_release(f.context);
        shd_assert_ok(shd_context_create(&one, &f.context));
    }
    shd_frame_render(&f);
    for (i = 0; i < EDGE * EDGE; ++i) {
        const int both = f.triangle[i] == solid_triangle[i] && f.triangle[i] != 0xffffffffu;
        for (plane = 0; plane < 5; ++plane) {
            assert_true(f.plane[k_planes[plane]][i] - f.plane[k_planes[plane]][i] == 0);
            if (!both) continue;
            shd_assert_close("plane", plane, (double)f.plane[k_planes[plane]][i], (double)solid[plane][i], 1e-6, 0);
        }
        same += (size_t)both;
    }
    assert_true(same > 200 && same < 1200);
    if (c->program) assert_int_equal(rows, f.stats.fragment_count);
    shd_frame_close(&f);
}

/* Draws of a scene as lines and points of different widths. */
static void outline_scene(shd_scene *s)
{
    size_t i;
    for (i = 0; i < s->desc.draw_count; ++i) {
        s->draw[i].fill = i % 3 == 2 ? SHD_FILL_POINTS : SHD_FILL_WIREFRAME;
        s->draw[i].fill_width = 0.5f * (float)(i + 1);
    }
}

static uint64_t render_scene(shd_simd simd, uint32_t workers)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    uint64_t hash;
    shd_scene s;
    desc.simd = simd;
    desc.worker_count = workers;
    if (shd_context_create(&desc, &context) != SHD_OK) return 0; /* not a target of this machine */
    shd_scene_open(&s, SHD_SCENE_GLASS, context);
    outline_scene(&s);
    hash = shd_scene_render(&s);
    assert_int_equal(s.stats.nonfinite_triangle_count + s.stats.outside_triangle_count + s.stats.culled_triangle_count +
                         s.stats.empty_triangle_count + s.stats.rasterized_triangle_count,
                     s.stats.triangle_count);
    assert_true(s.stats.clipped_triangle_count > 0 && s.stats.culled_triangle_count > 0 &&
                s.stats.nonfinite_triangle_count > 0 && s.stats.fragment_count > 10000);
    shd_scene_close(&s);
    shd_context_release(context);
    return hash;
}

static void test_same_bits(void **state)
{
    static const uint32_t k_workers[] = {1, 2, 3, 16};
    const uint64_t want = render_scene(SHD_SIMD_BEST, 1);
    int simd, targets = 0;
    (void)state;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        const uint64_t got = render_scene((shd_simd)simd, 1 + (uint32_t)simd % 2);
        if (got == 0) continue;
        assert_true(got == want);
        ++targets;
    }
    for (simd = 0; simd < 4; ++simd) assert_true(render_scene(SHD_SIMD_BEST, k_workers[simd]) == want);
    assert_true(targets >= 1);
}

/* Instances are like separate draws, as outlines or solid; width 0 means 1. */
static void test_defaults(void **state)
{
    shd_context *context = NULL;
    uint64_t want;
    shd_scene s;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    want = shd_scene_render(&s);
    s.draw[1].fill_width = 17; /* solid: not used */
    assert_true(shd_scene_render(&s) == want);
    s.draw[1].fill = SHD_FILL_WIREFRAME;
    s.draw[1].fill_width = 1;
    assert_true(shd_draw_default().fill == SHD_FILL_SOLID && shd_draw_default().fill_width == 1);
    want = shd_scene_render(&s);
    s.draw[1].fill_width = 1;
    assert_true(shd_scene_render(&s) == want);
    s.draw[1].instances = s.draw[1].object_to_world;
    s.draw[1].instance_count = 1;
    assert_true(shd_scene_render(&s) == want);
    shd_scene_close(&s);
    shd_context_release(context);
}

static void test_refused(void **state)
{
    static const struct {
        float width;
        const char *message;
    } k_widths[] = {{0.0624f, "is not in 0.0625..64"},
                    {64.01f, "is not in 0.0625..64"},
                    {-1, "is not in 0.0625..64"},
                    {NAN, "is not in 0.0625..64"},
                    {INFINITY, "is not in 0.0625..64"}};
    const uint32_t bad = 4;
    shd_context *context = NULL;
    uint64_t before;
    shd_scene s;
    size_t i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    (void)shd_scene_render(&s);
    before = shd_hash_framebuffer(s.framebuffer);
    s.desc.clear_color[0] = 0.5f;
    for (i = 0; i < sizeof k_widths / sizeof k_widths[0]; ++i) {
        s.draw[1].fill_width = k_widths[i].width;
        shd_assert_result("width", shd_render(context, &s.desc), SHD_ERROR_INVALID_ARGUMENT,
                          "render.draws[1]: draw.fill_width: ");
        assert_non_null(strstr(shd_last_error(), k_widths[i].message));
    }
    s.draw[1].fill_width = 1;
    memcpy(&s.draw[1].fill, &bad, sizeof bad);
    shd_assert_result("fill", shd_render(context, &s.desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.draws[1]: draw.fill: 4 is not in 0..3");
    assert_true(shd_hash_framebuffer(s.framebuffer) == before);
    shd_scene_close(&s);
    shd_context_release(context);
}

int main(void)
{
    static const int k_keeps[2] = {0, 1};
    static struct CMUnitTest tests[40];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_borders / sizeof k_borders[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_borders[i].name, test_border, NULL, NULL, (void *)&k_borders[i]};
    }
    for (i = 0; i < sizeof k_shadings / sizeof k_shadings[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_shadings[i].name, test_shading, NULL, NULL, (void *)&k_shadings[i]};
    }
    tests[n++] = (struct CMUnitTest){"average_of_samples", test_average, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"on_top_of_the_surface", test_on_top, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"points", test_points, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"shared_edge/depth_written", test_shared_edge, NULL, NULL, (void *)&k_keeps[0]};
    tests[n++] = (struct CMUnitTest){"shared_edge/depth_kept", test_shared_edge, NULL, NULL, (void *)&k_keeps[1]};
    tests[n++] = (struct CMUnitTest){"same_bits", test_same_bits, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"defaults", test_defaults, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"refused", test_refused, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_outline", tests, n, NULL, NULL);
}
