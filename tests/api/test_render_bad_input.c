/* SPDX-License-Identifier: MIT */
/* Geometry that reaches far beyond the picture or behind the eye, and degenerate geometry: each sample is still hit
 * once, and every plane stays finite, with one or many samples per pixel. */
#include "support/fault_allocator.h"
#include "support/frame.h"
#include "support/scene.h"

enum { EDGE = 96, SPOKES = 17 };

static float random_in(uint32_t *state, float low, float high) { return low + (high - low) * shd_scene_random(state); }

/* A fan around `middle` with spokes of up to `reach` in the plane of axes a and b. */
static void make_fan(uint32_t *random, const float middle[3], int a, int b, float reach, float out[24 * SPOKES])
{
    float spoke[SPOKES + 1][8];
    int i;
    for (i = 0; i < SPOKES; ++i) {
        const float angle = 6.2831853f * ((float)i + random_in(random, 0, 0.8f)) / SPOKES;
        const float length = reach * random_in(random, 0.3f, 1);
        memset(spoke[i], 0, sizeof spoke[i]);
        memcpy(spoke[i], middle, 3 * sizeof(float));
        spoke[i][a] += length * cosf(angle);
        spoke[i][b] += length * sinf(angle);
        spoke[i][5] = 1;
    }
    memcpy(spoke[SPOKES], spoke[0], sizeof spoke[0]);
    for (i = 0; i < SPOKES; ++i) {
        memset(out + 24 * i, 0, 8 * sizeof(float));
        memcpy(out + 24 * i, middle, 3 * sizeof(float));
        memcpy(out + 24 * i + 8, spoke[i], sizeof spoke[i]);
        memcpy(out + 24 * i + 16, spoke[i + 1], sizeof spoke[i]);
    }
}

/* Opens a frame whose red channel counts the hits of each sample. */
static void open_count(shd_frame *f, const float *fan, uint32_t samples)
{
    shd_material_desc one = shd_frame_plain(1, 0, 0);
    one.blend = SHD_BLEND_ADD;
    shd_frame_open_samples(f, EDGE, EDGE, samples);
    shd_frame_draw(f, fan, 3 * SPOKES, &one)->flags = SHD_DRAW_KEEP_DEPTH;
    shd_frame_ambient(f);
}

static const float k_reaches[] = {3, 1e3f, 2.1e4f, 2.2e4f, 1e6f, 1e12f, 1e20f, 1e30f, 2e36f};
static const uint32_t k_samples[] = {1, 4, 16};

/* Around a point of the picture; the guard band is at 21845 times the half picture. */
static void test_huge_fan(void **state)
{
    const float reach = *(const float *)*state;
    uint32_t random = 5, round;
    for (round = 0; round < 12; ++round) {
        const float middle[3] = {random_in(&random, -0.9f, 0.9f), random_in(&random, -0.9f, 0.9f), 0.5f};
        const uint32_t samples = k_samples[round % 3];
        float fan[24 * SPOKES];
        size_t i;
        shd_frame f;
        make_fan(&random, middle, 0, 1, reach < 10 ? 12 : reach, fan);
        open_count(&f, fan, samples);
        shd_frame_render(&f);
        for (i = 0; i < EDGE * EDGE; ++i) {
            if (f.plane[SHD_PLANE_R][i] != 1) {
                fail_msg("reach %g, %u samples: pixel %zu hit %g times", (double)reach, samples, i,
                         (double)f.plane[SHD_PLANE_R][i]);
            }
        }
        assert_int_equal(f.stats.rasterized_triangle_count + f.stats.outside_triangle_count +
                             f.stats.empty_triangle_count + f.stats.culled_triangle_count,
                         SPOKES);
        shd_frame_close(&f);
    }
}

/* A floor around the point directly below the eye, with vertices in front of it, behind it and at W = 0. */
static void test_fan_through_the_eye(void **state)
{
    static const float k_middle[3] = {0, -0.5f, 0};
    const float reach = *(const float *)*state;
    uint32_t random = 6, round;
    for (round = 0; round < 12; ++round) {
        const uint32_t samples = k_samples[round % 3];
        shd_camera camera = shd_camera_default();
        float fan[24 * SPOKES];
        uint32_t x, y;
        shd_frame f;
        make_fan(&random, k_middle, 0, 2, reach, fan);
        open_count(&f, fan, samples);
        camera.eye[2] = 0;
        camera.target[2] = -1;
        shd_assert_ok(shd_view_from_camera(&camera, &f.desc.view));
        shd_frame_render(&f);
        for (y = 0; y < EDGE; ++y) {
            for (x = 0; x < EDGE; ++x) {
                /* The far plane ends the floor 0.6 rows below the horizon. */
                const int is_sky = y<EDGE / 2, is_floor = y> EDGE / 2 + 1 && reach >= 1e3f;
                const float hits = f.plane[SHD_PLANE_R][y * EDGE + x];
                const int is_wrong = (is_sky && hits != 0) || (is_floor && hits != 1) || !(hits >= 0 && hits <= 1);
                if (is_wrong) {
                    fail_msg("reach %g, %u samples: pixel %u %u hit %g times", (double)reach, samples, x, y,
                             (double)hits);
                }
            }
        }
        assert_true(f.stats.clipped_triangle_count > 0);
        shd_frame_close(&f);
    }
}

/* Triangles of every size, including slivers and points. */
static void make_soup(uint32_t *random, float reach, size_t triangles, float *out)
{
    size_t i, k, c;
    for (i = 0; i < triangles; ++i) {
        const float size = reach * shd_scene_random(random), shape = shd_scene_random(random);
        for (k = 0; k < 3; ++k) {
            float *v = out + 24 * i + 8 * k;
            v[0] = random_in(random, -1, 1) * size;
            v[1] = random_in(random, -1, 1) * size;
            v[2] = random_in(random, -0.1f, 1.1f);
            for (c = 3; c < 8; ++c) v[c] = random_in(random, -1, 1) * (i % 7 ? 1 : 1e30f);
            if (shape < 0.2f) v[1] = 1e-6f * v[1] + v[0]; /* nearly a line */
            if (shape > 0.9f && k == 2) memcpy(v, v - 8, 8 * sizeof(float));
        }
    }
}

struct soup_case {
    const char *name;
    float reach;
};
static const struct soup_case k_soups[] = {
    {"planes/subpixel", 0.01f}, {"planes/small", 0.2f}, {"planes/large", 30},
    {"planes/huge", 1e9f},      {"planes/1e36", 1e36f},
};

/* Every plane is finite for any input. */
static void test_planes(void **state)
{
    enum { TRIANGLES = 150 };
    static const unsigned char k_texels[64] = {10, 200, 90, 255};
    static float soup[24 * TRIANGLES];
    const struct soup_case *c = (const struct soup_case *)*state;
    uint32_t random = 9, round;
    uint64_t fragments = 0;
    for (round = 0; round < 9; ++round) {
        shd_texture_desc texture_desc = shd_texture_desc_default();
        shd_material_desc material = shd_material_desc_default();
        shd_texture *texture = NULL;
        shd_slot slot;
        shd_frame f;
        int plane;
        size_t i;
        make_soup(&random, c->reach, TRIANGLES, soup);
        shd_frame_open_aovs(&f, EDGE, EDGE, k_samples[round % 3], SHD_AOV_OVERDRAW * 2 - 1);
        texture_desc.format = SHD_FORMAT_R8;
        texture_desc.width = texture_desc.height = 8;
        texture_desc.texels = k_texels;
        texture_desc.tables = SHD_TABLE_MIPMAP;
        shd_assert_ok(shd_texture_create(f.context, &texture_desc, &texture));
        material.model = SHD_MODEL_BLINN_PHONG;
        slot = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, NULL);
        material.slots = &slot;
        material.slot_count = 1;
        shd_frame_draw(&f, soup, 3 * TRIANGLES, &material);
        f.draw[0].fill = (shd_fill)(round / 3);
        f.draw[0].fill_width = 2.5f;
        f.draw[0].flags = round % 2 ? SHD_DRAW_SAMPLE_SHADING : SHD_DRAW_NONE;
        shd_frame_ambient(&f);
        shd_frame_render(&f);
        for (plane = 0; plane < SHD_FRAME_PLANES; ++plane) {
            for (i = 0; f.plane[plane] && i < EDGE * EDGE; ++i) {
                if (isfinite(f.plane[plane][i])) continue;
                fail_msg("%s, round %u: plane %d is %g at pixel %zu", c->name, round, plane, (double)f.plane[plane][i],
                         i);
            }
        }
        assert_int_equal(f.stats.nonfinite_fragment_count, 0);
        fragments += f.stats.fragment_count;
        shd_texture_release(texture);
        shd_frame_close(&f);
    }
    assert_true(fragments > 0);
}

/* With a host limit of 64 MiB the largest framebuffer does not fit, and the failed call leaks nothing. */
struct budget {
    shd_fault_allocator allocator;
    size_t refused;
};
static void *budget_allocate(size_t size, size_t alignment, void *user_data)
{
    struct budget *self = (struct budget *)user_data;
    if (size > ((size_t)64 << 20) - self->allocator.live_bytes) {
        ++self->refused;
        return NULL;
    }
    return shd_fault_allocate(size, alignment, &self->allocator);
}
static void budget_free(void *memory, size_t size, size_t alignment, void *user_data)
{
    shd_fault_free(memory, size, alignment, &((struct budget *)user_data)->allocator);
}

static void test_budget(void **state)
{
    struct budget budget;
    shd_context_desc context_desc = shd_context_desc_default();
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_context *context = NULL;
    size_t before;
    (void)state;
    memset(&budget, 0, sizeof budget);
    context_desc.worker_count = 1;
    context_desc.allocator.allocate = budget_allocate;
    context_desc.allocator.free = budget_free;
    context_desc.allocator.user_data = &budget;
    shd_assert_ok(shd_context_create(&context_desc, &context));
    before = budget.allocator.live_bytes;
    desc.width = desc.height = 16384;
    shd_assert_result("largest", shd_framebuffer_create(context, &desc, &framebuffer), SHD_ERROR_OUT_OF_MEMORY,
                      "out of memory");
    assert_null(framebuffer);
    assert_true(budget.refused > 0 && budget.allocator.live_bytes == before);
    desc.width = desc.height = 256;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &framebuffer));
    shd_framebuffer_release(framebuffer);
    shd_context_release(context);
    assert_true(budget.allocator.live_bytes == 0 && budget.allocator.mistakes == 0);
}

int main(void)
{
    enum { REACHES = sizeof k_reaches / sizeof k_reaches[0], SOUPS = sizeof k_soups / sizeof k_soups[0] };
    static struct CMUnitTest tests[2 * REACHES + SOUPS + 1];
    static char names[2 * REACHES][40];
    size_t n = 0, i;
    for (i = 0; i < 2 * REACHES; ++i) {
        const float *reach = &k_reaches[i % REACHES];
        snprintf(names[i], sizeof names[i], "fan_%s/%g", i < REACHES ? "around_a_pixel" : "through_the_eye",
                 (double)*reach);
        tests[n++] = (struct CMUnitTest){names[i], i < REACHES ? test_huge_fan : test_fan_through_the_eye, NULL, NULL,
                                         (void *)reach};
    }
    for (i = 0; i < SOUPS; ++i) {
        tests[n++] = (struct CMUnitTest){k_soups[i].name, test_planes, NULL, NULL, (void *)&k_soups[i]};
    }
    tests[n++] = (struct CMUnitTest){"budget", test_budget, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_bad_input", tests, n, NULL, NULL);
}
