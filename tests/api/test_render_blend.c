/* SPDX-License-Identifier: MIT */
/* Blends, alpha tests, discards, comparisons and order: frames whose pixels are known. */
#include <math.h>

#include "support/frame.h"
#include "support/noise.h"

enum { SIZE = 67, PIXELS = SIZE * SIZE };

typedef struct layer {
    float color[3], opacity, depth;
    shd_blend blend;
} layer;

/* Quads over the whole frame, one draw each, over a clear colour of (0.1, 0.2, 0.3, 0.4). */
static void render_layers(shd_frame *f, const layer *layers, size_t count, uint32_t samples)
{
    size_t i;
    shd_frame_open_samples(f, SIZE, SIZE, samples);
    for (i = 0; i < count; ++i) {
        shd_material_desc desc = shd_frame_plain(layers[i].color[0], layers[i].color[1], layers[i].color[2]);
        float quad[48];
        desc.blend = layers[i].blend;
        desc.opacity = layers[i].opacity;
        shd_frame_quad(-1, -1, 1, 1, layers[i].depth, layers[i].depth, quad);
        shd_frame_draw(f, quad, 6, &desc);
    }
    shd_frame_ambient(f);
    f->desc.clear_color[0] = 0.1f;
    f->desc.clear_color[1] = 0.2f;
    f->desc.clear_color[2] = 0.3f;
    f->desc.clear_color[3] = 0.4f;
    shd_frame_render(f);
}

static void check_color(const char *name, const shd_frame *f, const double want[4])
{
    size_t i;
    int c;
    for (i = 0; i < PIXELS; ++i) {
        for (c = 0; c < 4; ++c) shd_assert_close(name, i, (double)f->plane[c][i], want[c], 2e-6, 0.0);
    }
}

/* Expected colour of one layer over a colour, from the definition of each blend. */
static void blend_by_hand(const layer *l, double color[4])
{
    const double a = (double)l->opacity;
    double c[3];
    int i;
    for (i = 0; i < 3; ++i) c[i] = (double)l->color[i] * (l->blend == SHD_BLEND_OPAQUE ? 1 : a);
    for (i = 0; i < 3; ++i) {
        switch (l->blend) {
            case SHD_BLEND_OPAQUE: color[i] = c[i]; break;
            case SHD_BLEND_ADD: color[i] += c[i]; break;
            case SHD_BLEND_MULTIPLY: color[i] = c[i] * color[i] + (1 - a) * color[i]; break;
            default: color[i] = c[i] + (1 - a) * color[i]; break;
        }
    }
    if (l->blend == SHD_BLEND_OPAQUE) color[3] = 1;
    if (l->blend != SHD_BLEND_OPAQUE && l->blend != SHD_BLEND_ADD && l->blend != SHD_BLEND_MULTIPLY) {
        color[3] = a + (1 - a) * color[3];
    }
}

struct blend_case {
    const char *name;
    shd_blend blend;
};
static const struct blend_case k_blends[] = {
    {"blend/opaque", SHD_BLEND_OPAQUE},     {"blend/premultiplied", SHD_BLEND_PREMULTIPLIED},
    {"blend/straight", SHD_BLEND_STRAIGHT}, {"blend/add", SHD_BLEND_ADD},
    {"blend/multiply", SHD_BLEND_MULTIPLY}, {"blend/weighted", SHD_BLEND_WEIGHTED},
    {"blend/sorted", SHD_BLEND_SORTED},
};

/* One layer of every opacity over the clear colour, and over an opaque draw. */
static void test_blend(void **state)
{
    const struct blend_case *c = (const struct blend_case *)*state;
    const float opacities[] = {0.0f, 0.25f, 1.0f};
    size_t i, n;
    for (i = 0; i < 3; ++i) {
        const layer layers[2] = {{{0.5f, 0.25f, 1.0f}, 1, 0.75f, SHD_BLEND_OPAQUE},
                                 {{0.75f, 1.0f, 2.0f}, opacities[i], 0.5f, c->blend}};
        for (n = 1; n <= 2; ++n) {
            double want[4] = {0.1, 0.2, 0.3, 0.4};
            shd_frame f;
            if (n == 2) blend_by_hand(&layers[0], want);
            blend_by_hand(&layers[1], want);
            render_layers(&f, layers + 2 - n, n, i == 2 ? 4 : 1);
            check_color(c->name, &f, want);
            /* blends write depth, except order-independent blends */
            shd_assert_close("depth", n, (double)f.plane[SHD_PLANE_DEPTH][0],
                             c->blend >= SHD_BLEND_WEIGHTED ? (n == 2 ? 0.75 : 1) : 0.5, 0, 0);
            shd_frame_close(&f);
        }
    }
}

/* Layers take effect in the order of draws, except sorted layers, which come last and in the order of depth. */
static void test_order(void **state)
{
    const layer layers[4] = {{{1, 0, 0}, 0.5f, 0.4f, SHD_BLEND_SORTED},
                             {{0, 1, 0}, 0.5f, 0.8f, SHD_BLEND_PREMULTIPLIED},
                             {{0, 0, 1}, 0.25f, 0.2f, SHD_BLEND_SORTED},
                             {{1, 1, 0}, 0.5f, 0.6f, SHD_BLEND_STRAIGHT}};
    const int order[4] = {1, 3, 0, 2};
    double want[4] = {0.1, 0.2, 0.3, 0.4};
    shd_frame f;
    int i;
    (void)state;
    for (i = 0; i < 4; ++i) blend_by_hand(&layers[order[i]], want);
    for (i = 1; i <= 16; i *= 2) {
        render_layers(&f, layers, 4, (uint32_t)i);
        check_color("order", &f, want);
        shd_frame_close(&f);
    }
}

/* An opaque draw hides sorted layers behind it, for any order of draws. */
static void test_hidden(void **state)
{
    const layer layers[4] = {{{1, 0, 0}, 0.5f, 0.9f, SHD_BLEND_SORTED},
                             {{1, 0, 0}, 0.5f, 0.7f, SHD_BLEND_WEIGHTED},
                             {{0.25f, 0.5f, 0.75f}, 1, 0.5f, SHD_BLEND_OPAQUE},
                             {{1, 0, 0}, 0.5f, 0.6f, SHD_BLEND_PREMULTIPLIED}};
    const double want[4] = {0.25, 0.5, 0.75, 1};
    shd_frame f;
    (void)state;
    render_layers(&f, layers, 4, 1);
    check_color("hidden", &f, want);
    shd_frame_close(&f);
}

/* Weighted layers of one colour give this colour with alpha 1 - the product of 1 - a, for any number, order and
 * depth. */
static void test_weighted(void **state)
{
    const layer layers[3] = {{{0.25f, 0.5f, 1}, 0.5f, 0.9f, SHD_BLEND_WEIGHTED},
                             {{0.25f, 0.5f, 1}, 0.75f, 0.1f, SHD_BLEND_WEIGHTED},
                             {{0.25f, 0.5f, 1}, 0.125f, 0.5f, SHD_BLEND_WEIGHTED}};
    const double rest = 0.5 * 0.25 * 0.875;
    const double want[4] = {0.25 * (1 - rest) + 0.1 * rest, 0.5 * (1 - rest) + 0.2 * rest, 1 - rest + 0.3 * rest,
                            1 - rest + 0.4 * rest};
    shd_frame f;
    (void)state;
    render_layers(&f, layers, 3, 1);
    check_color("weighted", &f, want);
    shd_frame_close(&f);
}

/* Expected colour of weighted layers, from the formula of SHD_BLEND_WEIGHTED. */
static void weigh_by_hand(const layer *layers, size_t count, double color[4])
{
    double sum[4] = {0, 0, 0, 0}, rest = 1;
    size_t i;
    int c;
    for (i = 0; i < count; ++i) {
        const double a = (double)layers[i].opacity, weight = fmax(0.01, 3000 * pow(1 - (double)layers[i].depth, 3));
        for (c = 0; c < 3; ++c) sum[c] += weight * a * (double)layers[i].color[c];
        sum[3] += weight * a;
        rest *= 1 - a;
    }
    for (c = 0; c < 3; ++c) color[c] = sum[c] / sum[3] * (1 - rest) + rest * color[c];
    color[3] = 1 - rest + rest * color[3];
}

/* Weighted layers of different colours: near layers count more, down to the smallest weight. */
static void test_weights(void **state)
{
    static const float k_depths[][3] = {{0.375f, 0.75f, 0.5f},
                                        {0.75f, 0.375f, 0.0f},
                                        {0.96875f, 0.9990234375f, 0.984375f},
                                        {0.998046875f, 0.9375f, 0.25f}};
    size_t i, k;
    (void)state;
    for (i = 0; i < sizeof k_depths / sizeof k_depths[0]; ++i) {
        layer layers[3] = {{{1, 0, 0.5f}, 0.5f, 0, SHD_BLEND_WEIGHTED},
                           {{0, 1, 0.25f}, 0.75f, 0, SHD_BLEND_WEIGHTED},
                           {{0.5f, 0.5f, 1}, 0.25f, 0, SHD_BLEND_WEIGHTED}};
        double want[4] = {0.1, 0.2, 0.3, 0.4};
        shd_frame f;
        for (k = 0; k < 3; ++k) layers[k].depth = k_depths[i][k];
        weigh_by_hand(layers, 3, want);
        render_layers(&f, layers, 3, i % 2 ? 4 : 1);
        check_color("weights", &f, want);
        shd_frame_close(&f);
    }
}

/* Sorted layers of equal depth take effect in the order of draws. */
static void test_sorted_ties(void **state)
{
    const layer layers[4] = {{{1, 0, 0}, 0.5f, 0.5f, SHD_BLEND_SORTED},
                             {{0, 1, 0}, 0.25f, 0.5f, SHD_BLEND_SORTED},
                             {{0, 0, 1}, 0.5f, 0.5f, SHD_BLEND_SORTED},
                             {{1, 1, 0}, 0.25f, 0.75f, SHD_BLEND_SORTED}};
    const int order[4] = {3, 0, 1, 2};
    double want[4] = {0.1, 0.2, 0.3, 0.4};
    shd_frame f;
    int i;
    (void)state;
    for (i = 0; i < 4; ++i) blend_by_hand(&layers[order[i]], want);
    for (i = 1; i <= 16; i *= 4) {
        render_layers(&f, layers, 4, (uint32_t)i);
        check_color("sorted/ties", &f, want);
        shd_frame_close(&f);
    }
}

enum { DEEP = 600 };

/* 600 sorted layers at random depths in one draw: more than a worker's table can hold for a tile. */
static void test_deep(void **state)
{
    static float vertices[DEEP * 24];
    static int order[DEEP];
    shd_material_desc material = shd_material_desc_default();
    uint32_t random = 3;
    double value = 0.1, alpha = 0.4;
    int i, k, n;
    shd_frame f;
    (void)state;
    for (i = 0; i < DEEP; ++i) {
        const float corner[3][2] = {{-1, -1}, {7, -1}, {-1, 7}};
        shd_noise(&random);
        for (k = 0; k < 3; ++k) {
            const float vertex[8] = {corner[k][0], corner[k][1], (float)(random >> 20) / 4096, 0, 0, 1, 0, 0};
            memcpy(vertices + 24 * i + 8 * k, vertex, sizeof vertex);
        }
        for (n = i; n > 0 && vertices[24 * order[n - 1] + 2] < vertices[24 * i + 2]; --n) order[n] = order[n - 1];
        order[n] = i;
    }
    material.ambient[0] = 0.5f;
    material.ambient[1] = material.ambient[2] = 0;
    material.opacity = 1.0f / 64;
    material.blend = SHD_BLEND_SORTED;
    shd_frame_open_samples(&f, SIZE, SIZE, 1);
    shd_frame_draw(&f, vertices, 3 * DEEP, &material);
    shd_frame_ambient(&f);
    f.desc.clear_color[0] = 0.1f;
    f.desc.clear_color[3] = 0.4f;
    shd_frame_render(&f);
    for (i = 0; i < DEEP; ++i) {
        value = 0.5 / 64 + value * 63 / 64;
        alpha = 1.0 / 64 + alpha * 63 / 64;
    }
    for (i = 0; i < PIXELS; ++i) {
        shd_assert_close("r", (size_t)i, (double)f.plane[0][i], value, 2e-5, 0.0);
        shd_assert_close("a", (size_t)i, (double)f.plane[3][i], alpha, 2e-5, 0.0);
    }
    shd_frame_close(&f);
}

static void columns_of_alpha(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    for (i = 0; i < in->count; ++i) {
        out->r[i] = 1;
        out->a[i] = in->u[i];
        if (user_data) out->discard[i] = in->u[i] < 0.55f;
    }
}

static void render_columns(shd_frame *f, uint32_t flags, float cutoff, void *discards, uint32_t samples)
{
    static const float triangle[24] = {-1, -1, 0.5f, 0, 0,  1, 0,    1, 3, -1, 0.5f, 0,
                                       0,  1,  2,    1, -1, 3, 0.5f, 0, 0, 1,  0,    -1};
    shd_material_desc desc = shd_material_desc_default();
    desc.model = SHD_MODEL_PROGRAM;
    desc.program.fragment = columns_of_alpha;
    desc.program.user_data = discards;
    desc.flags = flags;
    desc.alpha_cutoff = cutoff;
    shd_frame_open_samples(f, SIZE, SIZE, samples);
    shd_frame_draw(f, triangle, 3, &desc);
    shd_frame_render(f);
}

/* Fragments below the cutoff, and fragments that a program discards, write no colour, depth or ids. */
static void test_cutoff(void **state)
{
    int discard, i;
    (void)state;
    for (discard = 0; discard < 2; ++discard) {
        shd_frame f;
        render_columns(&f, discard ? SHD_MATERIAL_DISCARDS : 0, discard ? 0.0f : 0.55f, discard ? &f : NULL, 1);
        for (i = 0; i < PIXELS; ++i) {
            const int kept = (i % SIZE + 0.5) / SIZE >= 0.55;
            assert_true(f.plane[SHD_PLANE_R][i] == (kept ? 1.0f : 0.0f));
            assert_true(f.plane[SHD_PLANE_DEPTH][i] == (kept ? 0.5f : 1.0f));
            assert_int_equal(f.triangle[i] != 0xffffffffu, kept);
        }
        shd_frame_close(&f);
    }
}

/* An alpha equal to the cutoff is kept. */
static void test_cutoff_tie(void **state)
{
    static const float k_opacities[3] = {0.49999997f, 0.5f, 0.50000006f};
    size_t i;
    int k;
    (void)state;
    for (k = 0; k < 3; ++k) {
        shd_material_desc red = shd_frame_plain(1, 0, 0);
        float quad[48];
        shd_frame f;
        red.opacity = k_opacities[k];
        red.alpha_cutoff = 0.5f;
        shd_frame_open(&f, SIZE, SIZE);
        shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
        shd_frame_draw(&f, quad, 6, &red);
        shd_frame_ambient(&f);
        shd_frame_render(&f);
        for (i = 0; i < PIXELS; ++i) assert_true(f.plane[SHD_PLANE_R][i] == (k >= 1 ? 1.0f : 0.0f));
        shd_frame_close(&f);
    }
}

static void test_alpha_to_coverage(void **state)
{
    uint32_t samples;
    int i;
    (void)state;
    for (samples = 1; samples <= 16; samples *= 2) {
        shd_frame f;
        render_columns(&f, SHD_MATERIAL_ALPHA_TO_COVERAGE, 0.0f, NULL, samples);
        for (i = 0; i < PIXELS; ++i) {
            const double want = floor((i % SIZE + 0.5) / SIZE * samples + 0.5) / samples;
            shd_assert_close("r", (size_t)i, (double)f.plane[SHD_PLANE_R][i], want, 1e-6, 0.0);
        }
        shd_frame_close(&f);
    }
}

/* Intersecting alpha-tested quads: the nearest one that passes the test is visible, for any order of draws. */
static void test_cutoff_order(void **state)
{
    int order, i, k;
    (void)state;
    for (order = 0; order < 2; ++order) {
        shd_frame f;
        shd_frame_open(&f, SIZE, SIZE);
        for (k = 0; k < 2; ++k) {
            const int near = k == order;
            shd_material_desc desc = shd_material_desc_default();
            float quad[48];
            desc.model = SHD_MODEL_PROGRAM;
            desc.program.fragment = columns_of_alpha;
            desc.alpha_cutoff = near ? 0.75f : 0.25f;
            shd_frame_quad(-1, -1, 1, 1, near ? 0.25f : 0.75f, near ? 0.25f : 0.75f, quad);
            shd_frame_draw(&f, quad, 6, &desc);
        }
        shd_frame_render(&f);
        for (i = 0; i < PIXELS; ++i) {
            const double a = (i % SIZE + 0.5) / SIZE;
            const double want = a >= 0.75 ? 0.25 : a >= 0.25 ? 0.75 : 1;
            shd_assert_close("depth", (size_t)i, (double)f.plane[SHD_PLANE_DEPTH][i], want, 0.0, 0.0);
        }
        shd_frame_close(&f);
    }
}

/* A draw without a material writes only depth, which hides surfaces behind it. */
static void test_depth_only(void **state)
{
    const shd_material_desc red = shd_frame_plain(1, 0, 0);
    float quad[48];
    int i;
    shd_frame f;
    (void)state;
    shd_frame_open(&f, SIZE, SIZE);
    shd_frame_quad(-1, -1, 0, 1, 0.25f, 0.25f, quad);
    shd_frame_draw(&f, quad, 6, &red)->material = NULL;
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &red);
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    for (i = 0; i < PIXELS; ++i) {
        const int hidden = i % SIZE < SIZE / 2;
        assert_true(f.plane[SHD_PLANE_R][i] == (hidden ? 0.0f : 1.0f));
        assert_true(f.plane[SHD_PLANE_DEPTH][i] == (hidden ? 0.25f : 0.5f));
        assert_int_equal(f.triangle[i] == 0xffffffffu, hidden);
    }
    shd_frame_close(&f);
}

/* Depth that decreases with the distance, depth that is tested but not written, and equal depths. */
static void test_compare(void **state)
{
    static const struct {
        const char *name;
        float clear, first, second, bias;
        shd_compare compare;
        uint32_t flags;
        int shows;
        double depth;
    } cases[] = {
        {"greater/nearer", 0.0f, 0.25f, 0.5f, 0, SHD_COMPARE_GREATER, 0, 1, 0.5},
        {"greater/farther", 0.0f, 0.5f, 0.25f, 0, SHD_COMPARE_GREATER, 0, 0, 0.5},
        {"keep_depth", 1.0f, 0.5f, 0.25f, 0, SHD_COMPARE_LESS, SHD_DRAW_KEEP_DEPTH, 1, 0.5},
        {"equal", 1.0f, 0.5f, 0.5f, 0, SHD_COMPARE_LESS_EQUAL, 0, 1, 0.5},
        {"equal/biased_away", 1.0f, 0.5f, 0.5f, 0.125f, SHD_COMPARE_LESS_EQUAL, 0, 0, 0.5},
        {"equal/biased_near", 1.0f, 0.5f, 0.5f, -0.125f, SHD_COMPARE_LESS, 0, 1, 0.375},
        {"always", 1.0f, 0.25f, 0.5f, 0, SHD_COMPARE_ALWAYS, 0, 1, 0.5},
        {"never/nearer", 1.0f, 0.5f, 0.25f, 0, SHD_COMPARE_NEVER, 0, 0, 0.5},
        {"never/equal", 1.0f, 0.5f, 0.5f, 0, SHD_COMPARE_NEVER, 0, 0, 0.5},
        {"not_equal/equal", 1.0f, 0.5f, 0.5f, 0, SHD_COMPARE_NOT_EQUAL, 0, 0, 0.5},
        {"not_equal/nearer", 1.0f, 0.5f, 0.25f, 0, SHD_COMPARE_NOT_EQUAL, 0, 1, 0.25},
        {"not_equal/farther", 1.0f, 0.5f, 0.75f, 0, SHD_COMPARE_NOT_EQUAL, 0, 1, 0.75},
        {"equal/equal", 1.0f, 0.5f, 0.5f, 0, SHD_COMPARE_EQUAL, 0, 1, 0.5},
        {"equal/nearer", 1.0f, 0.5f, 0.25f, 0, SHD_COMPARE_EQUAL, 0, 0, 0.5},
        {"equal/farther", 1.0f, 0.5f, 0.75f, 0, SHD_COMPARE_EQUAL, 0, 0, 0.5},
        {"greater_equal/equal", 1.0f, 0.5f, 0.5f, 0, SHD_COMPARE_GREATER_EQUAL, 0, 1, 0.5},
        {"greater_equal/nearer", 1.0f, 0.5f, 0.25f, 0, SHD_COMPARE_GREATER_EQUAL, 0, 0, 0.5},
        {"greater_equal/farther", 1.0f, 0.5f, 0.75f, 0, SHD_COMPARE_GREATER_EQUAL, 0, 1, 0.75},
    };
    size_t i, k;
    int blended;
    (void)state;
    for (k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        for (blended = 0; blended < 2; ++blended) {
            shd_material_desc red = shd_frame_plain(1, 0, 0), green = shd_frame_plain(0, 1, 0);
            float quad[48];
            shd_draw *draw;
            shd_frame f;
            green.blend = blended ? SHD_BLEND_PREMULTIPLIED : SHD_BLEND_OPAQUE;
            shd_frame_open(&f, SIZE, SIZE);
            shd_frame_quad(-1, -1, 1, 1, cases[k].first, cases[k].first, quad);
            shd_frame_draw(&f, quad, 6, &red)->compare = SHD_COMPARE_ALWAYS;
            shd_frame_quad(-1, -1, 1, 1, cases[k].second, cases[k].second, quad);
            draw = shd_frame_draw(&f, quad, 6, &green);
            draw->compare = cases[k].compare;
            draw->flags = cases[k].flags;
            draw->depth_bias = cases[k].bias;
            shd_frame_ambient(&f);
            f.desc.clear_depth = cases[k].clear;
            shd_frame_render(&f);
            for (i = 0; i < PIXELS; ++i) {
                shd_assert_close(cases[k].name, i, (double)f.plane[SHD_PLANE_G][i], cases[k].shows, 0.0, 0.0);
                shd_assert_close(cases[k].name, i, (double)f.plane[SHD_PLANE_DEPTH][i], cases[k].depth, 0.0, 0.0);
            }
            shd_frame_close(&f);
        }
    }
}

/* One draw of two quads, each of which changes the depth that the next is compared with. */
static void test_compare_own_depth(void **state)
{
    shd_material_desc quarter = shd_frame_plain(0.25f, 0, 0);
    float quads[96];
    size_t i;
    shd_frame f;
    (void)state;
    quarter.blend = SHD_BLEND_ADD;
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quads);
    shd_frame_quad(-1, -1, 1, 1, 0.75f, 0.75f, quads + 48);
    shd_frame_open(&f, SIZE, SIZE);
    shd_frame_draw(&f, quads, 12, &quarter)->compare = SHD_COMPARE_NOT_EQUAL;
    shd_frame_ambient(&f);
    f.desc.clear_depth = 0.75f;
    shd_frame_render(&f);
    for (i = 0; i < PIXELS; ++i) {
        assert_true(f.plane[SHD_PLANE_R][i] == 0.5f);
        assert_true(f.plane[SHD_PLANE_DEPTH][i] == 0.75f);
    }
    shd_frame_close(&f);
}

int main(void)
{
    static struct CMUnitTest tests[24];
    size_t n = 0;
    for (; n < sizeof k_blends / sizeof k_blends[0]; ++n) {
        tests[n] = (struct CMUnitTest){k_blends[n].name, test_blend, NULL, NULL, (void *)&k_blends[n]};
    }
    tests[n++] = (struct CMUnitTest){"order", test_order, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"sorted/hidden", test_hidden, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"sorted/deep", test_deep, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"sorted/ties", test_sorted_ties, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"weighted", test_weighted, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"weighted/weights", test_weights, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"cutoff", test_cutoff, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"cutoff/tie", test_cutoff_tie, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"cutoff/order", test_cutoff_order, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"alpha_to_coverage", test_alpha_to_coverage, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"depth_only", test_depth_only, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"compare", test_compare, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"compare/own_depth", test_compare_own_depth, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_blend", tests, n, NULL, NULL);
}
