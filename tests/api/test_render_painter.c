/* SPDX-License-Identifier: MIT */
/* The painter's algorithm and Newell's method against the depth buffer. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>

#include "support/fault_allocator.h"
#include "support/frame.h"
#include "support/noise.h"
#include "support/pool.h"
#include "support/scene.h"

enum { SIZE = 131, PIXELS = SIZE * SIZE, MOST = 64 };

/* Triangles of one draw, eight floats a vertex. */
struct triangles {
    float vertex[24 * MOST];
    uint32_t count;
};

static void add_triangle(struct triangles *t, double corner[3][3])
{
    int k;
    assert_true(t->count < MOST);
    for (k = 0; k < 3; ++k) {
        float *v = t->vertex + 24 * t->count + 8 * k;
        v[0] = (float)corner[k][0];
        v[1] = (float)corner[k][1];
        v[2] = (float)corner[k][2];
        v[3] = v[4] = 0;
        v[5] = 1;
        v[6] = (float)k / 2;
        v[7] = (float)t->count / MOST;
    }
    ++t->count;
}

/* In [low, high): Knuth's generator (TAOCP 2, 3.3.4). */
static double random_in(uint32_t *state, double low, double high)
{
    shd_noise(state);
    return low + (high - low) * (double)(*state >> 8) * 0x1p-24;
}

/* Triangles that overlap cyclically without touching: each lies over the next, and the last over the first. */
static void make_circle(struct triangles *t, int count)
{
    int i;
    for (i = 0; i < count; ++i) {
        const double angle = 0.2 + 6.283185307179586 * i / count, c = cos(angle), s = sin(angle);
        double corner[3][3] = {{-0.8 * c - 0.3 * s, -0.8 * s + 0.3 * c, 0.2},
                               {0.8 * c - 0.1 * s, 0.8 * s + 0.1 * c, 0.8},
                               {0.8 * c - 0.5 * s, 0.8 * s + 0.5 * c, 0.8}};
        add_triangle(t, corner);
    }
}
static void make_circle_of_3(struct triangles *t) { make_circle(t, 3); }
static void make_circle_of_5(struct triangles *t) { make_circle(t, 5); }

static void make_crossing(struct triangles *t)
{
    double a[3][3] = {{-0.9, -0.7, 0.1}, {0.9, -0.5, 0.9}, {0.1, 0.9, 0.6}};
    double b[3][3] = {{0.9, -0.8, 0.2}, {-0.9, -0.3, 0.8}, {0.2, 0.8, 0.4}};
    add_triangle(t, a);
    add_triangle(t, b);
}

static void make_tangle(struct triangles *t)
{
    uint32_t random = 11;
    int i, k;
    for (i = 0; i < 40; ++i) {
        double corner[3][3];
        const double x = random_in(&random, -0.8, 0.8), y = random_in(&random, -0.8, 0.8);
        for (k = 0; k < 3; ++k) {
            corner[k][0] = x + random_in(&random, -0.6, 0.6);
            corner[k][1] = y + random_in(&random, -0.6, 0.6);
            corner[k][2] = random_in(&random, 0.05, 0.95);
        }
        add_triangle(t, corner);
    }
}

/* Parallel sheets one behind another, submitted in any order. */
static void make_layers(struct triangles *t)
{
    uint32_t random = 12;
    int i, k;
    for (i = 0; i < 40; ++i) {
        const double near = (i * 17 % 40) / 40.0;
        double corner[3][3];
        for (k = 0; k < 3; ++k) {
            corner[k][0] = random_in(&random, -1.5, 1.5);
            corner[k][1] = random_in(&random, -1.5, 1.5);
            corner[k][2] = near + random_in(&random, 0.0, 0.02);
        }
        add_triangle(t, corner);
    }
}

/* Distributes the triangles over four draws with different materials. */
static void render(shd_frame *f, const struct triangles *t, shd_visibility visibility, uint32_t samples, int reversed)
{
    uint32_t i;
    shd_frame_open_samples(f, SIZE, SIZE, samples);
    for (i = 0; i < SHD_FRAME_DRAWS; ++i) {
        const uint32_t begin = t->count * i / SHD_FRAME_DRAWS, end = t->count * (i + 1) / SHD_FRAME_DRAWS;
        const shd_material_desc desc = shd_frame_plain(0.25f * (float)i, 1.0f - 0.25f * (float)i, 0.5f);
        shd_draw *draw = shd_frame_draw(f, t->vertex + 24 * begin, 3 * (end - begin), &desc);
        draw->compare = reversed ? SHD_COMPARE_GREATER : SHD_COMPARE_LESS;
    }
    shd_frame_ambient(f);
    f->desc.visibility = visibility;
    f->desc.clear_depth = reversed ? 0.0f : 1.0f;
    shd_frame_render(f);
}

/* Pixels where two frames show different triangles or colours. */
static size_t count_differences(const shd_frame *a, const shd_frame *b)
{
    size_t count = 0, i;
    int c;
    for (i = 0; i < PIXELS; ++i) {
        int differs = a->triangle[i] != b->triangle[i];
        for (c = 0; c < 4; ++c) differs |= fabsf(a->plane[c][i] - b->plane[c][i]) > 1e-3f;
        count += (size_t)differs;
    }
    return count;
}

static void expect_same_planes(const char *what, const shd_frame *a, const shd_frame *b)
{
    int plane;
    for (plane = 0; plane < SHD_FRAME_PLANES; ++plane) {
        const void *got = a->plane[plane] ? (const void *)a->plane[plane] : (const void *)a->u32[plane];
        const void *want = b->plane[plane] ? (const void *)b->plane[plane] : (const void *)b->u32[plane];
        if (got && memcmp(got, want, PIXELS * 4) != 0) fail_msg("%s: plane %d differs", what, plane);
    }
}

struct hard_case {
    const char *name;
    void (*make)(struct triangles *t);
    int reversed;
};
static const struct hard_case k_hard[] = {
    {"circle_of_3", make_circle_of_3, 0},    {"circle_of_3/reversed", make_circle_of_3, 1},
    {"circle_of_5", make_circle_of_5, 0},    {"crossing", make_crossing, 0},
    {"crossing/reversed", make_crossing, 1}, {"tangle", make_tangle, 0},
    {"tangle/reversed", make_tangle, 1},
};

/* No order of whole triangles is correct: the painter's algorithm counts conflicts, and Newell's method cuts
 * triangles. */
static void test_hard(void **state)
{
    const struct hard_case *c = (const struct hard_case *)*state;
    static struct triangles triangles;
    uint32_t samples;
    triangles.count = 0;
    c->make(&triangles);
    for (samples = 1; samples <= 16; samples *= 2) {
        shd_frame depth, painter, newell;
        size_t wrong, seam;
        render(&depth, &triangles, SHD_VISIBILITY_DEPTH, samples, c->reversed);
        render(&painter, &triangles, SHD_VISIBILITY_PAINTER, samples, c->reversed);
        render(&newell, &triangles, SHD_VISIBILITY_NEWELL, samples, c->reversed);
        assert_true(depth.stats.order_conflict_count == 0 && depth.stats.split_count == 0);
        assert_true(painter.stats.order_conflict_count > 0 && painter.stats.split_count == 0);
        assert_true(newell.stats.order_conflict_count == 0 && newell.stats.split_count > 0);
        assert_true(newell.stats.rasterized_triangle_count == depth.stats.rasterized_triangle_count);
        wrong = count_differences(&painter, &depth);
        seam = count_differences(&newell, &depth);
        if (samples == 1 || samples == 16) {
            print_message("%s, %u samples: painter %llu conflicts, %zu pixels; newell %llu cuts, %zu pixels\n", c->name,
                          samples, (unsigned long long)painter.stats.order_conflict_count, wrong,
                          (unsigned long long)newell.stats.split_count, seam);
        }
        if (wrong < 20) fail_msg("%s, %u samples: painter wrong at only %zu pixels", c->name, samples, wrong);
        if (seam > PIXELS / 1000) fail_msg("%s, %u samples: %zu pixels at seams", c->name, samples, seam);
        shd_frame_close(&depth);
        shd_frame_close(&painter);
        shd_frame_close(&newell);
    }
}

/* Triangles without intersections in depth: every method gives the same bits. */
static void test_layers(void **state)
{
    static struct triangles triangles;
    uint32_t samples;
    int reversed;
    (void)state;
    triangles.count = 0;
    make_layers(&triangles);
    for (samples = 1; samples <= 16; samples *= 2) {
        for (reversed = 0; reversed < 2; ++reversed) {
            shd_frame depth, painter, newell;
            render(&depth, &triangles, SHD_VISIBILITY_DEPTH, samples, reversed);
            render(&painter, &triangles, SHD_VISIBILITY_PAINTER, samples, reversed);
            render(&newell, &triangles, SHD_VISIBILITY_NEWELL, samples, reversed);
            expect_same_planes("painter", &painter, &depth);
            expect_same_planes("newell", &newell, &depth);
            assert_int_equal(painter.stats.fragment_count, depth.stats.fragment_count);
            assert_int_equal(newell.stats.fragment_count, depth.stats.fragment_count);
            assert_int_equal(
                painter.stats.order_conflict_count + newell.stats.order_conflict_count + newell.stats.split_count, 0);
            shd_frame_close(&depth);
            shd_frame_close(&painter);
            shd_frame_close(&newell);
        }
    }
}

/* Quads over the whole frame, one draw each, all with the blend `blend`. */
static void render_stack(shd_frame *f, const float *depths, size_t count, shd_blend blend, shd_visibility visibility,
                         uint32_t samples)
{
    size_t i;
    shd_frame_open_samples(f, SIZE, SIZE, samples);
    for (i = 0; i < count; ++i) {
        shd_material_desc desc = shd_frame_plain(i == 0, i == 1, i > 1 ? 0.5f : 0.0f);
        float quad[48];
        desc.blend = blend;
        desc.opacity = blend == SHD_BLEND_OPAQUE ? 1.0f : 0.3f + 0.1f * (float)i;
        shd_frame_quad(-1, -1, 1, 1, depths[i], depths[i], quad);
        shd_frame_draw(f, quad, 6, &desc);
    }
    shd_frame_ambient(f);
    f->desc.visibility = visibility;
    f->desc.clear_color[1] = 0.125f;
    f->desc.clear_color[3] = 1.0f;
    shd_frame_render(f);
}

/* Layers blended in the order of painting have the bits of SHD_BLEND_SORTED. */
static void test_blended(void **state)
{
    const float depths[4] = {0.4f, 0.8f, 0.2f, 0.6f};
    uint32_t samples;
    int method, c;
    (void)state;
    for (samples = 1; samples <= 16; samples *= 2) {
        for (method = SHD_VISIBILITY_PAINTER; method <= SHD_VISIBILITY_NEWELL; ++method) {
            shd_frame sorted, painted;
            render_stack(&sorted, depths, 4, SHD_BLEND_SORTED, SHD_VISIBILITY_DEPTH, samples);
            render_stack(&painted, depths, 4, SHD_BLEND_PREMULTIPLIED, (shd_visibility)method, samples);
            for (c = 0; c < 4; ++c) assert_memory_equal(sorted.plane[c], painted.plane[c], PIXELS * 4);
            assert_true(painted.plane[SHD_PLANE_DEPTH][7] == 0.2f); /* the depth of the quad painted last */
            assert_true(sorted.plane[SHD_PLANE_DEPTH][7] == 1.0f);
            shd_frame_close(&painted);
            /* order-independent blends come last with every method */
            render_stack(&painted, depths, 4, SHD_BLEND_SORTED, (shd_visibility)method, samples);
            expect_same_planes("sorted", &painted, &sorted);
            shd_frame_close(&painted);
            shd_frame_close(&sorted);
        }
    }
}

/* With equal depths the quad submitted last is visible, unlike with a depth buffer that passes only nearer
 * fragments. */
static void test_equal(void **state)
{
    const float depths[3] = {0.5f, 0.5f, 0.5f};
    int method;
    (void)state;
    for (method = SHD_VISIBILITY_DEPTH; method <= SHD_VISIBILITY_NEWELL; ++method) {
        shd_frame f;
        int i;
        render_stack(&f, depths, 3, SHD_BLEND_OPAQUE, (shd_visibility)method, 1);
        for (i = 0; i < PIXELS; ++i) {
            assert_true(f.plane[SHD_PLANE_R][i] == (method == SHD_VISIBILITY_DEPTH ? 1.0f : 0.0f));
            assert_true(f.plane[SHD_PLANE_B][i] == (method == SHD_VISIBILITY_DEPTH ? 0.0f : 0.5f));
        }
        assert_int_equal(f.stats.order_conflict_count + f.stats.split_count, 0);
        assert_int_equal(f.stats.fragment_count, PIXELS);
        shd_frame_close(&f);
    }
}

/* Draws paint over the previous contents of the framebuffer at any depth; SHD_DRAW_KEEP_DEPTH keeps the depth; a
 * bias changes the place of a draw in the order; draws without a material hide only order-independent blends. */
static void test_states(void **state)
{
    int method;
    (void)state;
    for (method = SHD_VISIBILITY_PAINTER; method <= SHD_VISIBILITY_NEWELL; ++method) {
        const float depths[2] = {0.25f, 0.5f};
        shd_frame f;
        render_stack(&f, depths, 2, SHD_BLEND_OPAQUE, (shd_visibility)method, 1);
        assert_true(f.plane[SHD_PLANE_R][0] == 1.0f && f.plane[SHD_PLANE_DEPTH][0] == 0.25f);
        f.desc.flags |= SHD_RENDER_LOAD;
        f.desc.draws = f.draw + 1;
        f.desc.draw_count = 1;
        f.draw[1].compare = SHD_COMPARE_NEVER;
        f.draw[1].flags = SHD_DRAW_KEEP_DEPTH;
        shd_frame_render(&f);
        assert_true(f.plane[SHD_PLANE_G][0] == 1.0f && f.plane[SHD_PLANE_DEPTH][0] == 0.25f);
        f.desc.flags &= ~(uint32_t)SHD_RENDER_LOAD;
        f.desc.draws = f.draw;
        f.desc.draw_count = 2;
        f.draw[1].flags = SHD_DRAW_NONE;
        f.draw[1].depth_bias = -0.375f;
        shd_frame_render(&f);
        assert_true(f.plane[SHD_PLANE_G][0] == 1.0f && f.plane[SHD_PLANE_DEPTH][0] == 0.125f);
        f.draw[1].material = NULL;
        shd_frame_render(&f);
        assert_true(f.plane[SHD_PLANE_R][0] == 1.0f && f.plane[SHD_PLANE_DEPTH][0] == 0.125f);
        shd_frame_close(&f);
    }
}

static void test_empty(void **state)
{
    static struct triangles triangles;
    double behind[3][3] = {{-1, -1, 1.5}, {1, -1, 1.5}, {0, 1, 1.5}};
    int method, i;
    (void)state;
    triangles.count = 0;
    for (i = 0; i < 4; ++i) add_triangle(&triangles, behind);
    for (method = SHD_VISIBILITY_PAINTER; method <= SHD_VISIBILITY_NEWELL; ++method) {
        const shd_region nothing = {0, 0, 0, 0};
        shd_frame f;
        render(&f, &triangles, (shd_visibility)method, 1, 0);
        assert_int_equal(f.stats.outside_triangle_count, 4);
        f.desc.draw_count = 0;
        shd_frame_render(&f);
        for (i = 0; i < PIXELS; ++i) assert_true(f.plane[SHD_PLANE_DEPTH][i] == 1.0f);
        f.desc.draw_count = 4;
        f.desc.scissor = &nothing;
        f.desc.stats = NULL;
        shd_frame_render(&f);
        shd_frame_close(&f);
    }
}

/* Renders a scene with a method; returns the hash of all results. */
static uint64_t render_scene(const shd_context_desc *desc, shd_scene_kind kind, shd_visibility visibility)
{
    shd_context *context = NULL;
    shd_scene scene;
    uint64_t hash;
    shd_assert_ok(shd_context_create(desc, &context));
    shd_scene_open(&scene, kind, context);
    scene.desc.visibility = visibility;
    hash = shd_scene_render(&scene);
    hash = shd_hash(hash, &scene.stats.order_conflict_count, sizeof scene.stats.order_conflict_count);
    hash = shd_hash(hash, &scene.stats.split_count, sizeof scene.stats.split_count);
    assert_true((visibility == SHD_VISIBILITY_PAINTER ? scene.stats.order_conflict_count : scene.stats.split_count) >
                0);
    shd_scene_close(&scene);
    shd_context_release(context);
    return hash;
}

static void test_same_bits(void **state)
{
    const shd_scene_kind kinds[] = {SHD_SCENE_MIXED, SHD_SCENE_GLASS};
    int method, simd;
    size_t k;
    (void)state;
    for (method = SHD_VISIBILITY_PAINTER; method <= SHD_VISIBILITY_NEWELL; ++method) {
        for (k = 0; k < 2; ++k) {
            shd_context_desc desc = shd_context_desc_default();
            uint64_t want;
            shd_pool pool = {8, SHD_POOL_RANDOM, 5};
            desc.worker_count = 1;
            want = render_scene(&desc, kinds[k], (shd_visibility)method);
            for (desc.worker_count = 2; desc.worker_count <= 8; ++desc.worker_count) {
                assert_true(render_scene(&desc, kinds[k], (shd_visibility)method) == want);
            }
            desc = shd_pool_context_desc(&pool);
            assert_true(render_scene(&desc, kinds[k], (shd_visibility)method) == want);
            for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
                shd_context *context = NULL;
                desc = shd_context_desc_default();
                desc.simd = (shd_simd)simd;
                if (shd_context_create(&desc, &context) != SHD_OK) continue;
                shd_context_release(context);
                assert_true(render_scene(&desc, kinds[k], (shd_visibility)method) == want);
            }
        }
    }
}

/* Each allocation of a frame fails in turn; the next render gives the reference picture. */
static void test_faults(void **state)
{
    int method, persistent;
    (void)state;
    for (method = SHD_VISIBILITY_PAINTER; method <= SHD_VISIBILITY_NEWELL; ++method) {
        for (persistent = 0; persistent < 2; ++persistent) {
            shd_fault_allocator memory;
            shd_context_desc desc;
            shd_context *context = NULL;
            shd_scene scene;
            uint64_t want;
            size_t n, live;
            shd_result result = SHD_ERROR_OUT_OF_MEMORY;
            memset(&memory, 0, sizeof memory);
            desc = shd_fault_context_desc(&memory);
            shd_assert_ok(shd_context_create(&desc, &context));
            shd_scene_open(&scene, SHD_SCENE_SMALL, context);
            scene.desc.visibility = (shd_visibility)method;
            want = shd_scene_render(&scene);
            live = memory.live_bytes;
            for (n = 1; result != SHD_OK; ++n) {
                shd_fault_arm(&memory, n, persistent);
                result = shd_render(context, &scene.desc);
                if (result != SHD_OK) shd_assert_result("render", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
                shd_fault_arm(&memory, 0, 0);
                assert_int_equal(memory.live_bytes, live);
                assert_true(shd_scene_render(&scene) == want);
            }
            print_message("method %d: %zu allocations\n", method, n - 2);
            assert_true(n > 20);
            shd_scene_close(&scene);
            shd_context_release(context);
            shd_assert_all_freed("frame", &memory);
        }
    }
}

int main(void)
{
    static struct CMUnitTest tests[20];
    size_t n = 0;
    for (; n < sizeof k_hard / sizeof k_hard[0]; ++n) {
        tests[n] = (struct CMUnitTest){k_hard[n].name, test_hard, NULL, NULL, (void *)&k_hard[n]};
    }
    tests[n++] = (struct CMUnitTest){"layers", test_layers, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"blended", test_blended, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"equal_depths", test_equal, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"states", test_states, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"empty", test_empty, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"same_bits", test_same_bits, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"faults", test_faults, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_painter", tests, n, NULL, NULL);
}
