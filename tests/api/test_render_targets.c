/* SPDX-License-Identifier: MIT */
/* Colour targets: additional colours that programs write; they are blended and averaged like colour. */
#include <math.h>

#include "support/frame.h"

enum { SIZE = 67, PIXELS = SIZE * SIZE };

static const uint32_t k_aov[4] = {0, SHD_AOV_TARGET1, SHD_AOV_TARGET2, SHD_AOV_TARGET3};
static const int k_plane[4] = {SHD_PLANE_R, SHD_PLANE_TARGET1_R, SHD_PLANE_TARGET2_R, SHD_PLANE_TARGET3_R};

/* Values that a program writes to its targets, and whether a column was missing, unexpected or not 0 at first. */
typedef struct job {
    float value[4][4];
    uint32_t aovs;
    int wrong;
    int by_uv; /* r and g of every target are u and v */
} job;

static void write_targets(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    job *j = (job *)user_data;
    int t, c;
    size_t i;
    for (t = 0; t < 4; ++t) {
        for (c = 0; c < 4; ++c) {
            float *const colors[4] = {out->r, out->g, out->b, out->a};
            float *column = t == 0 ? colors[c] : out->target[t - 1][c];
            if ((t == 0 || (j->aovs & k_aov[t])) != (column != NULL)) j->wrong = 1;
            if (!column) continue;
            for (i = 0; i < in->count; ++i) {
                if (t > 0 && column[i] != 0.0f) j->wrong = 1;
                column[i] = j->by_uv && c < 2 ? (c ? in->v[i] : in->u[i]) : j->value[t][c];
            }
        }
    }
}

static shd_material_desc program_desc(job *j, shd_blend blend)
{
    shd_material_desc desc = shd_material_desc_default();
    desc.model = SHD_MODEL_PROGRAM;
    desc.program.fragment = write_targets;
    desc.program.user_data = j;
    desc.blend = blend;
    return desc;
}

static job make_job(uint32_t aovs, float scale)
{
    job j;
    int t, c;
    memset(&j, 0, sizeof j);
    j.aovs = aovs;
    for (t = 0; t < 4; ++t) {
        for (c = 0; c < 4; ++c) j.value[t][c] = scale * (float)(1 + t) / 4 * (c == 3 ? 0.5f : (float)(1 + c) / 4);
    }
    return j;
}

static void check_planes(const shd_frame *f, int target, const double want[4], double tolerance)
{
    size_t i;
    int c;
    for (c = 0; c < 4; ++c) {
        const float *plane = f->plane[k_plane[target] + c];
        for (i = 0; i < PIXELS; ++i) shd_assert_close("target", i, (double)plane[i], want[c], tolerance, 0.0);
    }
}

/* Every combination of targets: existing targets have exactly the bits that the program wrote. */
static void test_combinations(void **state)
{
    uint32_t bits, samples;
    (void)state;
    for (bits = 0; bits < 8; ++bits) {
        for (samples = 1; samples <= 16; samples *= 4) {
            job j = make_job(bits * SHD_AOV_TARGET1, 1);
            shd_frame f;
            shd_material_desc desc = program_desc(&j, SHD_BLEND_OPAQUE);
            float quad[48];
            int t, c;
            shd_frame_open_aovs(&f, SIZE, SIZE, samples, j.aovs);
            shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
            shd_frame_draw(&f, quad, 6, &desc);
            shd_frame_render(&f);
            assert_false(j.wrong);
            for (t = 0; t < 4; ++t) {
                double want[4];
                for (c = 0; c < 4; ++c) want[c] = (double)j.value[t][c];
                assert_true(!f.plane[k_plane[t]] == (t > 0 && !(j.aovs & k_aov[t])));
                if (f.plane[k_plane[t]]) check_planes(&f, t, want, 0);
            }
            shd_frame_close(&f);
        }
    }
}

static const shd_blend k_blends[] = {SHD_BLEND_PREMULTIPLIED, SHD_BLEND_STRAIGHT, SHD_BLEND_ADD,
                                     SHD_BLEND_MULTIPLY,      SHD_BLEND_WEIGHTED, SHD_BLEND_SORTED};

/* A blended layer over an opaque one: each target is blended by its own a; order-independent blends do not change
 * targets. */
static void test_blends(void **state)
{
    const uint32_t aovs = SHD_AOV_TARGET1 | SHD_AOV_TARGET3;
    size_t k;
    (void)state;
    for (k = 0; k < sizeof k_blends / sizeof k_blends[0]; ++k) {
        uint32_t samples;
        for (samples = 1; samples <= 4; samples *= 4) {
            const shd_blend mode = k_blends[k];
            job below = make_job(aovs, 0.5f), above = make_job(aovs, 0.75f);
            shd_material_desc desc = program_desc(&below, SHD_BLEND_OPAQUE);
            float quad[2][48];
            shd_frame f;
            int t, c;
            shd_frame_open_aovs(&f, SIZE, SIZE, samples, aovs);
            shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad[0]);
            shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.25f, quad[1]);
            shd_frame_draw(&f, quad[0], 6, &desc);
            desc = program_desc(&above, mode);
            shd_frame_draw(&f, quad[1], 6, &desc);
            shd_frame_render(&f);
            for (t = 1; t < 4; t += 2) {
                const double a = (double)above.value[t][3];
                double want[4];
                for (c = 0; c < 4; ++c) {
                    const double s = (double)above.value[t][c], d = (double)below.value[t][c];
                    const int is_alpha = c == 3;
                    switch (mode) {
                        case SHD_BLEND_PREMULTIPLIED: want[c] = s + (1 - a) * d; break;
                        case SHD_BLEND_STRAIGHT: want[c] = (is_alpha ? s : a * s) + (1 - a) * d; break;
                        case SHD_BLEND_ADD: want[c] = is_alpha ? d : s + d; break;
                        case SHD_BLEND_MULTIPLY: want[c] = is_alpha ? d : s * d + (1 - a) * d; break;
                        default: want[c] = d; break;
                    }
                }
                check_planes(&f, t, want, 1e-6);
            }
            shd_frame_close(&f);
        }
    }
}

/* A built-in model over a program writes 0; cleared frames contain 0; kept frames keep their values. */
static void test_models_and_keep(void **state)
{
    static const double k_zero[4] = {0, 0, 0, 0};
    job j = make_job(SHD_AOV_TARGET2, 1);
    shd_material_desc program = program_desc(&j, SHD_BLEND_OPAQUE), plain = shd_frame_plain(1, 1, 1);
    shd_frame f;
    float back[48], front[48];
    size_t x, y;
    double want[4];
    int c;
    (void)state;
    shd_frame_open_aovs(&f, SIZE, SIZE, 4, SHD_AOV_TARGET2);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, back);
    shd_frame_quad(-1, -1, 0, 1, 0.25f, 0.25f, front); /* its edge is at 33.5 pixels */
    shd_frame_draw(&f, back, 6, &program);
    shd_frame_draw(&f, front, 6, &plain);
    shd_frame_render(&f);
    for (c = 0; c < 4; ++c) want[c] = (double)j.value[2][c];
    for (y = 0; y < SIZE; ++y) {
        for (x = 0; x < SIZE; ++x) {
            for (c = 0; c < 4; ++c) {
                const double share = x < 33 ? 0.0 : x == 33 ? 0.5 : 1.0;
                shd_assert_close("edge", x, (double)f.plane[SHD_PLANE_TARGET2_R + c][y * SIZE + x], share * want[c],
                                 1e-7, 0);
            }
        }
    }
    f.desc.draw_count = 1;
    f.draw[0].depth_bias = -0.5f; /* in front of the kept picture */
    f.desc.flags |= SHD_RENDER_LOAD;
    shd_frame_render(&f);
    check_planes(&f, 2, want, 0);
    f.desc.draw_count = 0;
    shd_frame_render(&f);
    check_planes(&f, 2, want, 0);
    f.desc.flags &= ~(uint32_t)SHD_RENDER_LOAD;
    shd_frame_render(&f);
    check_planes(&f, 2, k_zero, 0);
    f.desc.draw_count = 2;
    shd_frame_close(&f);
}

/* Targets of coarser frequencies are interpolated like colour. */
static void test_frequencies(void **state)
{
    static const shd_frequency k_frequency[3] = {SHD_FREQUENCY_PHONG, SHD_FREQUENCY_GOURAUD, SHD_FREQUENCY_FLAT};
    int k;
    (void)state;
    for (k = 0; k < 3; ++k) {
        job j = make_job(SHD_AOV_TARGET1, 1);
        shd_material_desc desc = program_desc(&j, SHD_BLEND_OPAQUE);
        shd_frame f;
        float quad[48];
        size_t i;
        int c;
        j.by_uv = 1;
        shd_frame_open_aovs(&f, SIZE, SIZE, 1, SHD_AOV_TARGET1);
        shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
        shd_frame_draw(&f, quad, 6, &desc);
        f.draw[0].frequency = k_frequency[k];
        shd_frame_render(&f);
        assert_false(j.wrong);
        for (c = 0; c < 2; ++c) {
            for (i = 0; i < PIXELS; ++i) {
                assert_true(f.plane[SHD_PLANE_TARGET1_R + c][i] == f.plane[c][i]);
            }
        }
        assert_true(k == 2 || f.plane[SHD_PLANE_TARGET1_R][0] < f.plane[SHD_PLANE_TARGET1_R][SIZE - 1]);
        shd_frame_close(&f);
    }
}

/* Samples that alpha drops from colour are dropped from targets too; they keep their previous values. */
static void test_alpha_drops(void **state)
{
    job below = make_job(SHD_AOV_TARGET1, 1), above = make_job(SHD_AOV_TARGET1, 0.5f);
    shd_material_desc desc = program_desc(&below, SHD_BLEND_OPAQUE);
    shd_frame f;
    float quad[2][48];
    double want[4];
    int c;
    (void)state;
    above.value[0][3] = 0.5f; /* two of four samples */
    above.value[1][3] = 0.0f; /* has no effect */
    shd_frame_open_aovs(&f, SIZE, SIZE, 4, SHD_AOV_TARGET1);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad[0]);
    shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.25f, quad[1]);
    shd_frame_draw(&f, quad[0], 6, &desc);
    desc = program_desc(&above, SHD_BLEND_OPAQUE);
    desc.flags = SHD_MATERIAL_ALPHA_TO_COVERAGE;
    shd_frame_draw(&f, quad[1], 6, &desc);
    shd_frame_render(&f);
    for (c = 0; c < 4; ++c) want[c] = 0.5 * (double)below.value[1][c] + 0.5 * (double)above.value[1][c];
    check_planes(&f, 1, want, 1e-7);
    shd_frame_close(&f);
}

/* Renders a triangle that leaves parts of its tiles bare, over the planes of a frame that was cleared to `old`. */
static void render_over(shd_frame *f, float old, float *out)
{
    int c;
    for (c = 0; c < 4; ++c) f->desc.clear_color[c] = old;
    shd_frame_render(f);
    for (c = 0; c < 4; ++c) f->desc.clear_color[c] = (float)(1 + c) / 4;
    shd_frame_render(f);
    for (c = 0; c < 4; ++c) memcpy(out + c * PIXELS, f->plane[SHD_PLANE_R + c], PIXELS * sizeof *out);
}

/* No colour of an earlier frame is left or averaged where triangles cover a part of a tile or of a pixel. */
static void test_earlier_frames(void **state)
{
    static const float k_triangle[24] = {-0.9f, -0.8f, 0.5f, 0, 0,    1,    0,    0, 0.7f, -0.3f, 0.5f, 0,
                                         0,     1,     1,    0, 0.1f, 0.9f, 0.5f, 0, 0,    1,     0,    1};
    static float colors[2][4 * PIXELS];
    uint32_t samples, targets;
    (void)state;
    for (samples = 1; samples <= 4; samples *= 4) {
        for (targets = 0; targets < 2; ++targets) {
            job j = make_job(targets * SHD_AOV_TARGET1, 1);
            const shd_material_desc desc = program_desc(&j, SHD_BLEND_OPAQUE);
            shd_frame f;
            size_t i, bare = 0;
            int c;
            shd_frame_open_aovs(&f, SIZE, SIZE, samples, j.aovs);
            shd_frame_draw(&f, k_triangle, 3, &desc);
            render_over(&f, 9.0f, colors[0]);
            render_over(&f, -5.0f, colors[1]);
            assert_memory_equal(colors[0], colors[1], sizeof colors[0]);
            for (i = 0; i < PIXELS; ++i) {
                int same = 1;
                for (c = 0; c < 4; ++c) {
                    const float color = colors[0][(size_t)c * PIXELS + i];
                    assert_true(color > 0.0f && color <= 1.0f);
                    same &= color == (float)(1 + c) / 4;
                }
                bare += (size_t)same;
            }
            assert_true(bare > PIXELS / 2 && bare < PIXELS * 3 / 4);
            shd_frame_close(&f);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_combinations), cmocka_unit_test(test_blends),      cmocka_unit_test(test_models_and_keep),
        cmocka_unit_test(test_frequencies),  cmocka_unit_test(test_alpha_drops), cmocka_unit_test(test_earlier_frames),
    };
    return cmocka_run_group_tests_name("api.render_targets", tests, NULL, NULL);
}
