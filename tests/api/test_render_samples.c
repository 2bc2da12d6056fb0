/* SPDX-License-Identifier: MIT */
/* Several samples per pixel: each belongs to one triangle of a fan; colours resolve to their plain average; a pixel
 * is shaded once for every visible triangle, at a position inside this triangle. */
#include <math.h>

#include "support/frame.h"
#include "support/noise.h"

enum { EDGE = 70, SPOKES = 24 };

static const uint32_t k_samples[] = {1, 2, 4, 8, 16};

/* Positions of samples [1/16 pixel] (Vulkan 1.3 specification, "Multisampling"). */
static const int k_places[5][16][2] = {{{8, 8}},
                                       {{12, 12}, {4, 4}},
                                       {{6, 2}, {14, 6}, {2, 10}, {10, 14}},
                                       {{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}},
                                       {{9, 9},
                                        {7, 5},
                                        {5, 10},
                                        {12, 7},
                                        {3, 6},
                                        {10, 13},
                                        {13, 11},
                                        {11, 3},
                                        {6, 14},
                                        {8, 1},
                                        {4, 2},
                                        {2, 12},
                                        {0, 8},
                                        {15, 4},
                                        {14, 15},
                                        {1, 0}}};

/* In [low, high): Knuth's generator (TAOCP 2, 3.3.4). */
static float random_in(uint32_t *state, float low, float high)
{
    shd_noise(state);
    return low + (high - low) * (float)(*state >> 8) * 0x1p-24f;
}

/* A fan of triangles around a point that covers the whole frame. */
static void make_fan(uint32_t *random, float out[24 * SPOKES])
{
    const float cx = random_in(random, -0.9f, 0.9f), cy = random_in(random, -0.9f, 0.9f);
    float angle[SPOKES];
    int i;
    for (i = 0; i < SPOKES; ++i) angle[i] = 6.2831853f * ((float)i + random_in(random, 0.0f, 0.8f)) / SPOKES;
    for (i = 0; i < SPOKES; ++i) {
        const float a = angle[i], b = angle[(i + 1) % SPOKES];
        const float corner[3][8] = {{cx, cy, 0.5f, 0, 0, 1, 0, 0},
                                    {cx + 4 * cosf(a), cy + 4 * sinf(a), 0.5f, 0, 0, 1, 0, 0},
                                    {cx + 4 * cosf(b), cy + 4 * sinf(b), 0.5f, 0, 0, 1, 0, 0}};
        memcpy(out + 24 * i, corner, sizeof corner);
    }
}

/* With additive blending, fans of colour 1 count the hits of each sample. */
static void test_each_sample_once(void **state)
{
    const uint32_t samples = *(const uint32_t *)*state;
    shd_material_desc one = shd_frame_plain(1, 1, 1);
    uint32_t random = samples;
    int round;
    one.blend = SHD_BLEND_ADD;
    for (round = 0; round < 12; ++round) {
        float fan[24 * SPOKES];
        size_t i;
        shd_frame f;
        shd_frame_open_samples(&f, EDGE, EDGE, samples);
        make_fan(&random, fan);
        shd_frame_draw(&f, fan, 3 * SPOKES, &one)->flags = SHD_DRAW_KEEP_DEPTH;
        shd_frame_ambient(&f);
        shd_frame_render(&f);
        for (i = 0; i < EDGE * EDGE; ++i) assert_true(f.plane[SHD_PLANE_R][i] == 1.0f);
        shd_frame_close(&f);
    }
}

/* Number of samples of a pixel to the left of x = edge [pixels]. */
static int samples_left_of(uint32_t count, uint32_t pixel, double edge)
{
    int row = 0, n = 0;
    uint32_t s;
    while (k_samples[row] != count) ++row;
    for (s = 0; s < count; ++s) n += pixel + k_places[row][s][0] / 16.0 < edge;
    return n;
}

/* A vertical edge at every sixteenth of a pixel, with every blend: the colour is the share of covered samples. */
static void test_edge(void **state)
{
    const uint32_t samples = *(const uint32_t *)*state;
    int sixteenth, blend;
    for (sixteenth = 0; sixteenth < 16; ++sixteenth) {
        for (blend = SHD_BLEND_OPAQUE; blend <= SHD_BLEND_SORTED; ++blend) {
            const double edge = 20 + sixteenth / 16.0;
            shd_material_desc red = shd_frame_plain(1, 0, 0);
            float quad[48];
            uint32_t x;
            shd_frame f;
            if (blend == SHD_BLEND_ADD || blend == SHD_BLEND_MULTIPLY) continue;
            red.blend = (shd_blend)blend;
            shd_frame_open_samples(&f, 64, 8, samples);
            shd_frame_quad(-1, -1, (float)(edge / 32 - 1), 1, 0.5f, 0.5f, quad);
            shd_frame_draw(&f, quad, 6, &red);
            shd_frame_ambient(&f);
            f.desc.clear_color[2] = 1.0f;
            shd_frame_render(&f);
            for (x = 0; x < 64; ++x) {
                const double want = samples_left_of(samples, x, edge) / (double)samples;
                shd_assert_close("r", x, (double)f.plane[SHD_PLANE_R][3 * 64 + x], want, 1e-6, 0.0);
                shd_assert_close("b", x, (double)f.plane[SHD_PLANE_B][3 * 64 + x], 1 - want, 1e-6, 0.0);
                shd_assert_close("a", x, (double)f.plane[SHD_PLANE_A][3 * 64 + x], want, 1e-6, 0.0);
            }
            shd_frame_close(&f);
        }
    }
}

/* Samples that differ in one channel alone, alpha among them, are averaged in it. */
static void test_one_channel(void **state)
{
    const uint32_t samples = *(const uint32_t *)*state;
    int channel, c;
    for (channel = 0; channel < 4; ++channel) {
        const shd_material_desc grey = shd_frame_plain(0.5f, 0.5f, 0.5f);
        float quad[48];
        uint32_t x;
        shd_frame f;
        shd_frame_open_samples(&f, 16, 8, samples);
        shd_frame_quad(-1, -1, 5.5f / 8 - 1, 1, 0.5f, 0.5f, quad);
        shd_frame_draw(&f, quad, 6, &grey);
        shd_frame_ambient(&f);
        for (c = 0; c < 3; ++c) f.desc.clear_color[c] = 0.5f;
        f.desc.clear_color[3] = 1.0f;
        f.desc.clear_color[channel] = 0.25f;
        shd_frame_render(&f);
        for (x = 0; x < 16; ++x) {
            const double share = samples_left_of(samples, x, 5.5) / (double)samples;
            for (c = 0; c < 4; ++c) {
                const double full = c == 3 ? 1.0 : 0.5, want = c == channel ? full * share + 0.25 * (1 - share) : full;
                shd_assert_close("mean", x, (double)f.plane[c][3 * 16 + x], want, 1e-6, 0.0);
            }
        }
        shd_frame_close(&f);
    }
}

/* Rows that a program was called with. */
struct rows {
    size_t count;
    float x[4096], y[4096];
    uint32_t triangle[4096];
};

static void keep_rows(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    struct rows *rows = (struct rows *)user_data;
    size_t i;
    assert_null(out->discard);
    for (i = 0; i < in->count; ++i) {
        assert_true(rows->count < 4096);
        rows->x[rows->count] = in->x[i];
        rows->y[rows->count] = in->y[i];
        rows->triangle[rows->count++] = in->triangle[i];
    }
}

static void render_rows(uint32_t samples, uint32_t flags, float edge, struct rows *rows)
{
    shd_material_desc program = shd_material_desc_default();
    shd_context_desc one = shd_context_desc_default();
    shd_context *context = NULL;
    float quad[48];
    shd_frame f;
    one.worker_count = 1;
    shd_assert_ok(shd_context_create(&one, &context));
    rows->count = 0;
    program.model = SHD_MODEL_PROGRAM;
    program.program.fragment = keep_rows;
    program.program.user_data = rows;
    shd_frame_open_samples(&f, 16, 16, samples);
    shd_frame_quad(-1, -1, edge / 8 - 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &program)->flags = flags;
    shd_assert_ok(shd_render(context, &f.desc));
    shd_frame_close(&f);
    shd_context_release(context);
}

/* A row is shaded at the centre of the pixel if the triangle covers it, else at the mean of the covered samples. */
static void test_places(void **state)
{
    const uint32_t samples = *(const uint32_t *)*state;
    static struct rows rows;
    int sixteenth;
    for (sixteenth = 0; sixteenth < 16; ++sixteenth) {
        const double edge = 9 + sixteenth / 16.0;
        size_t i, inside = 0;
        render_rows(samples, 0, (float)edge, &rows);
        for (i = 0; i < rows.count; ++i) {
            const double x = (double)rows.x[i], y = (double)rows.y[i];
            assert_true(x < edge && x >= 0 && y >= 0 && y < 16);
            inside += x == floor(x) + 0.5 && y == floor(y) + 0.5;
        }
        /* a pixel on the diagonal has two triangles, of which one covers the centre */
        assert_true(inside >= 16 * (size_t)(edge - 0.5));
        assert_true(rows.count >= inside && rows.count <= 16 * 10 + 16 + 16);
    }
}

/* With sample shading there is a row for each sample, at the position of the sample. */
static void test_sample_shading(void **state)
{
    const uint32_t samples = *(const uint32_t *)*state;
    static struct rows rows;
    size_t i;
    int row = 0;
    while (k_samples[row] != samples) ++row;
    render_rows(samples, SHD_DRAW_SAMPLE_SHADING, 16, &rows);
    assert_int_equal(rows.count, 256 * samples);
    for (i = 0; i < rows.count; ++i) {
        const double x = (double)rows.x[i] - floor((double)rows.x[i]), y = (double)rows.y[i] - floor((double)rows.y[i]);
        uint32_t s = 0;
        while (s < samples && (x * 16 != k_places[row][s][0] || y * 16 != k_places[row][s][1])) ++s;
        assert_true(s < samples);
    }
}

/* A scene of many random triangles, resolved, against a picture of 8 x 8 times the pixels: the difference is within
 * the error of the samples. */
static void test_against_supersampling(void **state)
{
    const uint32_t samples = *(const uint32_t *)*state;
    static float large[3][256 * 256];
    uint32_t random = 5;
    float triangles[24 * 40];
    double error = 0;
    int i, c, scale;
    for (i = 0; i < 24 * 40; i += 8) {
        const float z = i % 24 ? triangles[i - 6] : random_in(&random, 0.0f, 0.99f);
        const float vertex[8] = {random_in(&random, -1.2f, 1.2f), random_in(&random, -1.2f, 1.2f), z, 0, 0, 1, 0, 0};
        memcpy(triangles + i, vertex, sizeof vertex);
    }
    for (scale = 8; scale >= 1; scale -= 7) {
        shd_frame f;
        shd_frame_open_samples(&f, 32 * (uint32_t)scale, 32 * (uint32_t)scale, scale == 8 ? 1 : samples);
        for (i = 0; i < 4; ++i) {
            const shd_material_desc plain = shd_frame_plain((float)(i & 1), (float)(i >> 1), 0.5f);
            shd_frame_draw(&f, triangles + 240 * i, 30, &plain);
        }
        shd_frame_ambient(&f);
        shd_frame_render(&f);
        for (c = 0; c < 3 && scale == 8; ++c) memcpy(large[c], f.plane[c], sizeof large[c]);
        for (c = 0; c < 3 && scale == 1; ++c) {
            for (i = 0; i < 32 * 32; ++i) {
                double mean = 0;
                int k;
                for (k = 0; k < 64; ++k) {
                    mean += (double)large[c][(i / 32 * 8 + k / 8) * 256 + i % 32 * 8 + k % 8] / 64;
                }
                error += (mean - (double)f.plane[c][i]) * (mean - (double)f.plane[c][i]) / (3 * 32 * 32);
            }
        }
        shd_frame_close(&f);
    }
    /* the error of the mean of n samples at an edge is at most that of n random samples, 1/2 / sqrt(n) */
    assert_true(sqrt(error) < 0.25 / sqrt((double)samples));
}

int main(void)
{
    static const struct {
        const char *name;
        CMUnitTestFunction test;
    } k_tests[] = {{"each_sample_once", test_each_sample_once}, {"edge", test_edge},
                   {"one_channel", test_one_channel},           {"places", test_places},
                   {"sample_shading", test_sample_shading},     {"against_supersampling", test_against_supersampling}};
    static struct CMUnitTest tests[30];
    static char names[30][48];
    size_t n = 0, i, k;
    for (i = 0; i < sizeof k_tests / sizeof k_tests[0]; ++i) {
        for (k = 0; k < 5; ++k, ++n) {
            snprintf(names[n], sizeof names[n], "%s/%u", k_tests[i].name, k_samples[k]);
            tests[n] = (struct CMUnitTest){names[n], k_tests[i].test, NULL, NULL, (void *)&k_samples[k]};
        }
    }
    return _cmocka_run_group_tests("api.render_samples", tests, n, NULL, NULL);
}
