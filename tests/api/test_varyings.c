/* SPDX-License-Identifier: MIT */
/* Varyings: the values that a fragment program gets for values of a vertex program, against double, with every
 * interpolation. */
#include "ref/varying_ref.h"
#include "support/frame.h"
#include "support/noise.h"

enum { k_width = 96, k_height = 80, k_triangles = 24, k_max = SHD_MAX_VARYINGS };

/* Triangles in clip space, and the measurements of the fragment program. */
typedef struct scene {
    float clip[3 * k_triangles][4];
    float value[3 * k_triangles][k_max];
    double raster[3 * k_triangles][4];
    shd_interpolation mode[k_max];
    uint32_t count; /* number of varyings */
    shd_frequency frequency;
    int affine; /* the draw has SHD_DRAW_AFFINE: PERSPECTIVE is AFFINE */
    size_t rows, mistakes;
    double worst[3]; /* largest error of each interpolation */
    double rest;     /* largest expected |blend - value|, to check that the test is sensitive */
} scene;

static uint32_t g_seed;
static float uniform(float low, float high)
{
    shd_noise(&g_seed);
    return low + (high - low) * (float)(g_seed >> 8) * (1.0f / 16777216.0f);
}

/* Vertex `k` at device coordinates (x, y, z) and w. */
static void put(scene *s, size_t k, float x, float y, float z, float w)
{
    s->clip[k][0] = x * w;
    s->clip[k][1] = y * w;
    s->clip[k][2] = z * w;
    s->clip[k][3] = w;
}
static void scatter(scene *s, size_t t, float low, float high)
{
    int k;
    for (k = 0; k < 3; ++k) {
        put(s, 3 * t + (size_t)k, uniform(-1.2f, 1.2f), uniform(-1.2f, 1.2f), uniform(0.1f, 0.9f), uniform(low, high));
    }
}

static void make_ordinary(scene *s, size_t t) { scatter(s, t, 1.0f, 4.0f); }
static void make_wide(scene *s, size_t t) { scatter(s, t, 0.02f, 20.0f); }
static void make_same_w(scene *s, size_t t) { scatter(s, t, 2.0f, 2.0f); }
static void make_near(scene *s, size_t t)
{
    scatter(s, t, 0.5f, 4.0f);
    s->clip[3 * t + t % 3][2] = -0.5f * s->clip[3 * t + t % 3][3];
}
static void make_far(scene *s, size_t t)
{
    scatter(s, t, 0.5f, 4.0f);
    s->clip[3 * t + t % 3][2] = 1.75f * s->clip[3 * t + t % 3][3];
}
static void make_behind(scene *s, size_t t)
{
    size_t k;
    scatter(s, t, 0.5f, 2.0f);
    for (k = 0; k < 1 + t % 2; ++k) s->clip[3 * t + k][3] = uniform(-2.0f, -0.1f);
}
static void make_w_0(scene *s, size_t t)
{
    scatter(s, t, 0.5f, 2.0f);
    s->clip[3 * t + t % 3][3] = t % 2 ? 0.0f : -0.0f;
}
static void make_beyond_guard(scene *s, size_t t)
{
    scatter(s, t, 0.5f, 2.0f);
    s->clip[3 * t + t % 3][0] = t % 2 ? 1e5f : -2e5f;
}

typedef struct varying_case {
    const char *name;
    void (*make)(scene *s, size_t t);
    double perspective, affine; /* largest allowed error for values in -10..10, from measured errors */
    uint32_t samples;
    int at_samples;
    int affine_draw;
} varying_case;

static void fill(scene *s, const varying_case *c, uint32_t count)
{
    size_t t, i;
    memset(s, 0, sizeof *s);
    g_seed = 11;
    s->count = count;
    s->affine = c->affine_draw;
    for (i = 0; i < k_max; ++i) s->mode[i] = (shd_interpolation)(i % 3);
    for (t = 0; t < k_triangles; ++t) c->make(s, t);
    for (t = 0; t < 3 * k_triangles; ++t) {
        const float *p = s->clip[t];
        const double x = (double)p[0], y = (double)p[1], w = (double)p[3];
        for (i = 0; i < k_max; ++i) s->value[t][i] = uniform(-10.0f, 10.0f);
        s->raster[t][0] = 0.5 * k_width * (w + x);
        s->raster[t][1] = 0.5 * k_height * (w - y);
        s->raster[t][3] = w;
    }
}

static void write_varyings(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    const scene *s = (const scene *)in->uniforms;
    size_t i, c;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        const size_t k = in->first + i;
        out->x[i] = s->clip[k][0];
        out->y[i] = s->clip[k][1];
        out->z[i] = s->clip[k][2];
        out->w[i] = s->clip[k][3];
        out->px[i] = (float)k; /* distinguishes Gouraud rows */
        for (c = 0; c < out->varying_count; ++c) out->varying[c][i] = s->value[k][c];
    }
}

static void compare(scene *s, const shd_fragments *in, size_t i, size_t c)
{
    const size_t first = 3 * (size_t)in->triangle[i];
    const float a[3] = {s->value[first][c], s->value[first + 1][c], s->value[first + 2][c]};
    const double got = (double)in->varying[c][i];
    double error;
    if (s->frequency == SHD_FREQUENCY_PHONG) {
        const int projects = s->affine && s->mode[c] == SHD_INTERPOLATION_PERSPECTIVE;
        error = got - shd_ref_varying(s->raster[first], a, (double)in->x[i], (double)in->y[i],
                                      projects ? SHD_INTERPOLATION_AFFINE : s->mode[c]);
    } else if (s->mode[c] == SHD_INTERPOLATION_FLAT) {
        error = got - (double)a[0];
    } else if (s->frequency == SHD_FREQUENCY_GOURAUD) {
        error = got - (double)a[(size_t)in->px[i] - first];
    } else {
        error = got - ((double)a[0] + (double)a[1] + (double)a[2]) / 3;
    }
    if (!(fabs(error) <= s->worst[s->mode[c]])) s->worst[s->mode[c]] = fabs(error);
    s->mistakes += !isfinite(got);
    if (fabs(got - (double)a[0]) > s->rest) s->rest = fabs(got - (double)a[0]);
}

/* Compares every varying and writes the first four as colour. */
static void check_varyings(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const uint32_t count = *(const uint32_t *)user_data;
    scene *s = (scene *)in->uniforms;
    size_t i, c;
    s->mistakes += in->varying_count != count;
    for (c = 0; c < count; ++c) s->mistakes += !in->varying[c];
    for (i = 0; i < in->count && !s->mistakes; ++i) {
        for (c = 0; c < count; ++c) compare(s, in, i, c);
        if (count > 0) out->r[i] = in->varying[0][i];
        if (count > 1) out->g[i] = in->varying[1][i];
        if (count > 2) out->b[i] = in->varying[2][i];
        if (count > 4) out->a[i] = in->varying[4][i];
    }
    s->rows += in->count;
}

/* A frame with the scene in a draw of `count` varyings; one worker, so that the scene needs no lock. */
static void open_scene(shd_frame *f, scene *s, uint32_t width, uint32_t height, uint32_t samples)
{
    static float vertices[3 * k_triangles * 8];
    shd_context_desc one = shd_context_desc_default();
    shd_material_desc m = shd_material_desc_default();
    m.model = SHD_MODEL_PROGRAM;
    m.program.fragment = check_varyings;
    m.program.vertex = write_varyings;
    m.program.user_data = &s->count;
    m.varying_count = s->count;
    m.interpolation = s->mode;
    shd_frame_open_samples(f, width, height, samples);
    shd_frame_draw(f, vertices, 3 * k_triangles, &m)->uniforms = s;
    f->draw[0].frequency = s->frequency;
    f->draw[0].flags = s->affine ? SHD_DRAW_AFFINE : SHD_DRAW_NONE;
    one.worker_count = 1;
    shd_context_release(f->context);
    shd_assert_ok(shd_context_create(&one, &f->context));
}

static void test_interpolation(void **state)
{
    static scene s;
    const varying_case *c = (const varying_case *)*state;
    shd_frame f;
    fill(&s, c, k_max);
    open_scene(&f, &s, k_width, k_height, c->samples);
    if (c->at_samples) f.draw[0].flags |= SHD_DRAW_SAMPLE_SHADING;
    shd_frame_render(&f);
    print_message("  %s: %zu rows, errors %.3g (perspective) %.3g (affine)\n", c->name, s.rows, s.worst[0], s.worst[1]);
    assert_int_equal(s.mistakes, 0);
    assert_int_equal(f.stats.nonfinite_fragment_count, 0);
    assert_true(s.rows > 2000 && s.rest > 10);
    assert_true(s.worst[SHD_INTERPOLATION_PERSPECTIVE] <= c->perspective);
    assert_true(s.worst[SHD_INTERPOLATION_AFFINE] <= c->affine);
    assert_true(s.worst[SHD_INTERPOLATION_FLAT] == 0);
    shd_frame_close(&f);
}

static const varying_case k_cases[] = {
    {"ordinary", make_ordinary, 1e-4, 1e-4, 1, 0, 0},
    {"ordinary/4_samples", make_ordinary, 2e-3, 2e-3, 4, 0, 0},
    {"ordinary/16_samples_shaded", make_ordinary, 2e-3, 2e-3, 16, 1, 0},
    {"w_ratio_1000", make_wide, 2e-4, 1e-4, 1, 0, 0},
    {"same_w", make_same_w, 1e-4, 1e-4, 1, 0, 0},
    {"clipped/near", make_near, 1e-3, 2e-3, 1, 0, 0},
    {"clipped/far", make_far, 1e-3, 2e-3, 1, 0, 0},
    {"clipped/behind_the_eye", make_behind, 2e-4, 1e-4, 1, 0, 0},
    {"clipped/behind_the_eye/8_samples", make_behind, 2e-4, 2e-4, 8, 0, 0},
    {"clipped/w_0", make_w_0, 1e-4, 1e-4, 1, 0, 0},
    {"clipped/guard_band", make_beyond_guard, 1e-4, 1e-4, 1, 0, 0},
    {"affine/ordinary", make_ordinary, 1e-4, 1e-4, 1, 0, 1},
    {"affine/16_samples_shaded", make_ordinary, 2e-3, 2e-3, 16, 1, 1},
    {"affine/w_ratio_1000", make_wide, 2e-4, 1e-4, 1, 0, 1},
    {"affine/near", make_near, 1e-3, 2e-3, 1, 0, 1},
    {"affine/behind_the_eye", make_behind, 2e-4, 1e-4, 1, 0, 1},
    {"affine/guard_band", make_beyond_guard, 1e-4, 1e-4, 4, 0, 1},
};

/* If all three w are equal, both interpolations have the same bits. */
static void test_affine_is_perspective(void **state)
{
    static scene s;
    shd_frame f;
    size_t i;
    (void)state;
    fill(&s, &k_cases[4], 2);
    for (i = 0; i < 3 * k_triangles; ++i) s.value[i][1] = s.value[i][0];
    open_scene(&f, &s, k_width, k_height, 1);
    shd_frame_render(&f);
    assert_true(s.rows > 2000);
    assert_memory_equal(f.plane[SHD_PLANE_R], f.plane[SHD_PLANE_G], sizeof(float) * k_width * k_height);
    shd_frame_close(&f);
}

/* SHD_DRAW_AFFINE changes neither coverage nor depth, and nothing where all w are equal. */
static void test_affine_draw(void **state)
{
    static scene s;
    static float depth[k_width * k_height], red[k_width * k_height];
    static uint32_t triangle[k_width * k_height];
    size_t k;
    int affine;
    (void)state;
    for (k = 0; k < 2; ++k) {
        for (affine = 0; affine < 2; ++affine) {
            shd_frame f;
            fill(&s, &k_cases[k ? 4 : 0], 1);
            s.affine = affine;
            open_scene(&f, &s, k_width, k_height, 1);
            shd_frame_render(&f);
            if (affine) {
                const int same = memcmp(red, f.plane[SHD_PLANE_R], sizeof red) == 0;
                assert_memory_equal(depth, f.plane[SHD_PLANE_DEPTH], sizeof depth);
                assert_memory_equal(triangle, f.triangle, sizeof triangle);
                assert_int_equal(same, (int)k);
            }
            memcpy(depth, f.plane[SHD_PLANE_DEPTH], sizeof depth);
            memcpy(red, f.plane[SHD_PLANE_R], sizeof red);
            memcpy(triangle, f.triangle, sizeof triangle);
            shd_frame_close(&f);
        }
    }
}

/* Rows of Gouraud and flat shading are vertices and centroids. */
static void test_rows(void **state)
{
    static scene s;
    int frequency;
    (void)state;
    for (frequency = SHD_FREQUENCY_GOURAUD; frequency <= SHD_FREQUENCY_FLAT; ++frequency) {
        shd_frame f;
        fill(&s, &k_cases[0], k_max);
        s.frequency = (shd_frequency)frequency;
        open_scene(&f, &s, k_width, k_height, 1);
        shd_frame_render(&f);
        assert_int_equal(s.mistakes, 0);
        assert_true(s.rows >= k_triangles / 2);
        assert_true(s.worst[SHD_INTERPOLATION_PERSPECTIVE] <= 1e-6 && s.worst[SHD_INTERPOLATION_AFFINE] <= 1e-6);
        assert_true(s.worst[SHD_INTERPOLATION_FLAT] == 0);
        shd_frame_close(&f);
    }
}

/* At Gouraud frequency the program turns varyings into colours at the vertices, and these colours are interpolated. */
static void test_gouraud_picture(void **state)
{
    static scene s;
    shd_frame f;
    size_t at, c;
    fill(&s, &k_cases[0], 3);
    s.frequency = SHD_FREQUENCY_GOURAUD;
    s.affine = *state != NULL;
    open_scene(&f, &s, k_width, k_height, 1);
    shd_frame_render(&f);
    for (at = 0; at < k_width * k_height; ++at) {
        const size_t first = 3 * (size_t)f.triangle[at];
        if (f.triangle[at] == 0xffffffffu) continue;
        for (c = 0; c < 3; ++c) {
            const float a[3] = {s.value[first][c], s.value[first + 1][c], s.value[first + 2][c]};
            const double x = (double)(at % k_width) + 0.5, y = (double)(at / k_width) + 0.5;
            const shd_interpolation smooth = s.affine ? SHD_INTERPOLATION_AFFINE : SHD_INTERPOLATION_PERSPECTIVE;
            const shd_interpolation mode = c == 2 ? SHD_INTERPOLATION_FLAT : smooth;
            shd_assert_close("colour", 3 * at + c, (double)f.plane[c][at],
                             shd_ref_varying(s.raster[first], a, x, y, mode), 1e-4, 0);
        }
    }
    shd_frame_close(&f);
}

/* Windows of a picture have the pixels of the whole picture. */
static void test_windows(void **state)
{
    static const uint32_t k_windows[][4] = {{0, 0, 96, 1}, {17, 9, 33, 41}, {64, 63, 32, 17}, {95, 79, 1, 1}};
    static scene s;
    uint32_t samples;
    (void)state;
    for (samples = 1; samples <= 4; samples *= 4) {
        shd_frame whole;
        size_t i, plane;
        fill(&s, &k_cases[7], k_max);
        open_scene(&whole, &s, k_width, k_height, samples);
        shd_frame_render(&whole);
        for (i = 0; i < sizeof k_windows / sizeof k_windows[0]; ++i) {
            const uint32_t left = k_windows[i][0], top = k_windows[i][1], width = k_windows[i][2];
            shd_frame f;
            uint32_t y;
            open_scene(&f, &s, width, k_windows[i][3], samples);
            f.desc.picture_width = k_width;
            f.desc.picture_height = k_height;
            f.desc.crop_x = left;
            f.desc.crop_y = top;
            shd_frame_render(&f);
            for (plane = SHD_PLANE_R; plane <= SHD_PLANE_A; ++plane) {
                for (y = 0; y < f.height; ++y) {
                    assert_memory_equal(f.plane[plane] + (size_t)y * width,
                                        whole.plane[plane] + (size_t)(top + y) * k_width + left, width * sizeof(float));
                }
            }
            shd_frame_close(&f);
        }
        shd_frame_close(&whole);
    }
}

/* Draws with different numbers of varyings in one frame. */
static void test_counts(void **state)
{
    static const uint32_t k_counts[SHD_FRAME_DRAWS] = {3, 0, 16, 1};
    static scene s[SHD_FRAME_DRAWS];
    shd_frame f;
    size_t i;
    (void)state;
    fill(&s[0], &k_cases[0], k_counts[0]);
    open_scene(&f, &s[0], k_width, k_height, 2);
    for (i = 1; i < SHD_FRAME_DRAWS; ++i) {
        static float vertices[3 * k_triangles * 8];
        shd_material_desc m = shd_material_desc_default();
        fill(&s[i], &k_cases[i], k_counts[i]);
        m.model = SHD_MODEL_PROGRAM;
        m.program.fragment = check_varyings;
        m.program.vertex = write_varyings;
        m.program.user_data = &s[i].count;
        m.varying_count = k_counts[i];
        m.interpolation = s[i].mode;
        m.blend = SHD_BLEND_ADD; /* so that every draw is visible */
        shd_frame_draw(&f, vertices, 3 * k_triangles, &m)->uniforms = &s[i];
        f.draw[i].compare = SHD_COMPARE_ALWAYS;
    }
    shd_frame_render(&f);
    for (i = 0; i < SHD_FRAME_DRAWS; ++i) {
        assert_int_equal(s[i].mistakes, 0);
        assert_true(s[i].rows > 2000);
        assert_true(s[i].worst[0] < 0.01 && s[i].worst[1] < 0.01 && s[i].worst[2] == 0);
    }
    shd_frame_close(&f);
}

/* A constant keeps its bits; values near the largest float stay finite. */
static void test_extremes(void **state)
{
    static scene s;
    size_t i, c;
    shd_frame f;
    (void)state;
    fill(&s, &k_cases[7], 5);
    for (i = 0; i < 3 * k_triangles; ++i) {
        s.value[i][0] = s.value[i][1] = s.value[i][2] = 0.1f;
        s.value[i][3] = s.value[i][4] = i % 3 == 0 ? 3.4e38f : -3.4e38f;
    }
    open_scene(&f, &s, k_width, k_height, 1);
    shd_frame_render(&f);
    assert_int_equal(s.mistakes, 0);
    assert_int_equal(f.stats.nonfinite_fragment_count, 0);
    for (i = 0; i < k_width * k_height; ++i) {
        for (c = 0; c < 3; ++c) assert_true(f.triangle[i] == 0xffffffffu || f.plane[c][i] == 0.1f);
    }
    shd_frame_close(&f);
}

int main(void)
{
    static struct CMUnitTest tests[32];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_cases / sizeof k_cases[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_cases[i].name, test_interpolation, NULL, NULL, (void *)&k_cases[i]};
    }
    tests[n++] = (struct CMUnitTest){"affine_is_perspective", test_affine_is_perspective, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"rows", test_rows, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"affine_draw", test_affine_draw, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"gouraud_picture", test_gouraud_picture, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"gouraud_picture/affine", test_gouraud_picture, NULL, NULL, (void *)k_cases};
    tests[n++] = (struct CMUnitTest){"windows", test_windows, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"counts", test_counts, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"extremes", test_extremes, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.varyings", tests, n, NULL, NULL);
}
