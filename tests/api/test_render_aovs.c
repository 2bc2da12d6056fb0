/* SPDX-License-Identifier: MIT */
/* Auxiliary planes against interpolation in double, and the optional statistics of a frame. */
#include <math.h>

#include "support/frame.h"
#include "support/noise.h"

enum { WIDTH = 90, HEIGHT = 70, TRIANGLES = 9, ALL_AOVS = 2 * SHD_AOV_OVERDRAW - 1 };

struct frame_case {
    const char *name;
    uint32_t samples;
    double x, y; /* position of the first sample [1/16 pixel] (Vulkan 1.3 specification, "Multisampling") */
    uint32_t flags;
};
static const struct frame_case k_frames[] = {
    {"truth/1", 1, 8, 8, 0},
    {"truth/2", 2, 12, 12, SHD_DRAW_SAMPLE_SHADING},
    {"truth/4", 4, 6, 2, SHD_DRAW_SAMPLE_SHADING},
    {"truth/8", 8, 9, 5, SHD_DRAW_SAMPLE_SHADING},
    {"truth/16", 16, 9, 9, SHD_DRAW_SAMPLE_SHADING},
    {"truth/2_pixel_shading", 2, 12, 12, 0},
    {"truth/4_pixel_shading", 4, 6, 2, 0},
};

/* In [low, high): Knuth's generator (TAOCP 2, 3.3.4). */
static float random_in(uint32_t *state, float low, float high)
{
    shd_noise(state);
    return low + (high - low) * (float)(*state >> 8) * 0x1p-24f;
}

/* Triangles in front of an eye at the origin that looks along -z. */
static void make_triangles(uint32_t *random, float out[24 * TRIANGLES])
{
    int i;
    for (i = 0; i < 3 * TRIANGLES; ++i) {
        float *v = out + 8 * i;
        const float z = random_in(random, 1.2f, 6.0f);
        v[0] = random_in(random, -1.0f, 1.0f) * z;
        v[1] = random_in(random, -1.0f, 1.0f) * z;
        v[2] = -z;
        v[3] = v[4] = 0;
        v[5] = 1;
        v[6] = random_in(random, -2.0f, 2.0f);
        v[7] = random_in(random, -2.0f, 2.0f);
    }
}

/* A triangle at one point of the screen. */
struct hit {
    double bary[3], dx[3], dy[3]; /* weights and their change per pixel */
    double depth;
    double edge; /* the smallest weight on the screen, below 0 outside */
};

static void cross(const double a[3], const double b[3], double out[3])
{
    int c;
    for (c = 0; c < 3; ++c) out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

/* Weights solve [X Y W] weights ~ (x, y, 1) in homogeneous coordinates (Olano and Greer, "Triangle Scan Conversion
   using 2D Homogeneous Coordinates", 1997). */
static struct hit find_hit(const float *triangle, double x, double y)
{
    const double nx = 2 * x / WIDTH - 1, ny = 1 - 2 * y / HEIGHT;
    double p[3][3], sum = 0, sum_dx = 0, sum_dy = 0, weight[3], wx[3], wy[3], w = 0, screen = 0;
    struct hit hit;
    int k;
    for (k = 0; k < 3; ++k) {
        p[k][0] = (double)triangle[8 * k];
        p[k][1] = (double)triangle[8 * k + 1];
        p[k][2] = -(double)triangle[8 * k + 2];
    }
    for (k = 0; k < 3; ++k) {
        double n[3];
        cross(p[(k + 1) % 3], p[(k + 2) % 3], n);
        weight[k] = n[0] * nx + n[1] * ny + n[2];
        wx[k] = n[0] * 2 / WIDTH;
        wy[k] = -n[1] * 2 / HEIGHT;
        sum += weight[k];
        sum_dx += wx[k];
        sum_dy += wy[k];
    }
    for (k = 0; k < 3; ++k) {
        hit.bary[k] = weight[k] / sum;
        hit.dx[k] = (wx[k] - hit.bary[k] * sum_dx) / sum;
        hit.dy[k] = (wy[k] - hit.bary[k] * sum_dy) / sum;
        w += hit.bary[k] * p[k][2];
        screen += hit.bary[k] * p[k][2];
    }
    hit.edge = 1;
    for (k = 0; k < 3; ++k) hit.edge = fmin(hit.edge, hit.bary[k] * p[k][2] / screen);
    hit.depth = 1 - 1 / w;
    return hit;
}

static double mix(const double weight[3], const float *triangle, int field)
{
    return weight[0] * (double)triangle[field] + weight[1] * (double)triangle[8 + field] +
           weight[2] * (double)triangle[16 + field];
}

/* Expected triangle at the first sample of a pixel; -1 if rounding could change it. */
static int expect_pixel(const float *triangles, double x, double y, uint32_t *overdraw)
{
    double nearest = 1;
    int i, shown = 2 * TRIANGLES;
    *overdraw = 0;
    for (i = 0; i < 2 * TRIANGLES; ++i) {
        const struct hit hit = find_hit(triangles + 24 * i, x, y);
        if (fabs(hit.edge) < 2e-3) return -1;
        if (hit.edge < 0) continue;
        if (fabs(hit.depth - nearest) < 1e-3) return -1;
        if (hit.depth > nearest) continue;
        nearest = hit.depth;
        shown = i;
        ++*overdraw;
    }
    return shown;
}

static void expect_values(const shd_frame *f, size_t at, const float *triangle, const struct hit *hit)
{
    static const struct {
        const char *name;
        shd_plane plane;
        int derivative, field;
    } k_mixed[] = {{"px", SHD_PLANE_PX, 0, 0},     {"py", SHD_PLANE_PY, 0, 1},     {"pz", SHD_PLANE_PZ, 0, 2},
                   {"u", SHD_PLANE_U, 0, 6},       {"v", SHD_PLANE_V, 0, 7},       {"dudx", SHD_PLANE_DUDX, 1, 6},
                   {"dvdx", SHD_PLANE_DVDX, 1, 7}, {"dudy", SHD_PLANE_DUDY, 2, 6}, {"dvdy", SHD_PLANE_DVDY, 2, 7}};
    size_t i;
    int k;
    for (i = 0; i < sizeof k_mixed / sizeof k_mixed[0]; ++i) {
        const double *weight = k_mixed[i].derivative == 0 ? hit->bary : k_mixed[i].derivative == 1 ? hit->dx : hit->dy;
        const double want = mix(weight, triangle, k_mixed[i].field);
        shd_assert_close(k_mixed[i].name, at, (double)f->plane[k_mixed[i].plane][at], want, 2e-4, 1e-4);
    }
    for (k = 0; k < 3; ++k) {
        shd_assert_close("b", at, (double)f->plane[SHD_PLANE_B0 + k][at], hit->bary[k], 2e-5, 0.0);
    }
}

static void set_perspective(shd_frame *f)
{
    float *m = f->desc.view.view_to_clip;
    m[10] = m[11] = m[14] = -1.0f; /* depth 1 - 1 / w, w = -z */
    m[15] = 0.0f;
}

/* Random triangles of two draws, in every plane. */
static void test_truth(void **state)
{
    const struct frame_case *c = (const struct frame_case *)*state;
    const shd_material_desc plain = shd_frame_plain(1, 1, 1);
    uint32_t random = c->samples, round, x, y;
    size_t seen = 0, empty = 0, deep = 0;
    for (round = 0; round < 6; ++round) {
        static float triangles[2 * 24 * TRIANGLES];
        int i;
        shd_frame f;
        shd_frame_open_aovs(&f, WIDTH, HEIGHT, c->samples, ALL_AOVS);
        set_perspective(&f);
        for (i = 0; i < 2; ++i) {
            make_triangles(&random, triangles + 24 * TRIANGLES * i);
            shd_frame_draw(&f, triangles + 24 * TRIANGLES * i, 3 * TRIANGLES, &plain)->flags = c->flags;
        }
        shd_frame_render(&f);
        for (y = 0; y < HEIGHT; ++y) {
            for (x = 0; x < WIDTH; ++x) {
                const size_t at = (size_t)y * WIDTH + x;
                const int at_sample = c->flags & SHD_DRAW_SAMPLE_SHADING;
                const double sx = x + c->x / 16, sy = y + c->y / 16;
                uint32_t overdraw;
                const int shown = expect_pixel(triangles, sx, sy, &overdraw);
                struct hit hit;
                if (shown < 0) continue;
                assert_int_equal(f.u32[SHD_PLANE_OVERDRAW][at], overdraw);
                if (shown == 2 * TRIANGLES) {
                    assert_int_equal(f.u32[SHD_PLANE_DRAW][at], 0xffffffffu);
                    assert_int_equal(f.triangle[at], 0xffffffffu);
                    assert_true(f.plane[SHD_PLANE_PZ][at] == 0.0f && f.plane[SHD_PLANE_B0][at] == 0.0f);
                    ++empty;
                    continue;
                }
                assert_int_equal(f.u32[SHD_PLANE_DRAW][at], shown / TRIANGLES);
                assert_int_equal(f.triangle[at], shown % TRIANGLES);
                assert_true(f.plane[SHD_PLANE_LOD][at] == 0.0f && f.u32[SHD_PLANE_LEVEL][at] == 0);
                hit = at_sample ? find_hit(triangles + 24 * shown, sx, sy)
                                : find_hit(triangles + 24 * shown, x + 0.5, y + 0.5);
                if (hit.edge < 2e-3) continue; /* shaded somewhere else in the pixel */
                expect_values(&f, at, triangles + 24 * shown, &hit);
                ++seen;
                deep += overdraw > 1;
            }
        }
        shd_frame_close(&f);
    }
    if (seen < 5000 || empty < 100 || deep < 500) {
        fail_msg("%d pixels seen, %d empty, %d drawn twice", (int)seen, (int)empty, (int)deep);
    }
}

/* A material with a texture of 64 x 64 and mip levels. */
static shd_material_desc make_textured(shd_frame *f, shd_slot *slot)
{
    static unsigned char texels[64 * 64];
    shd_texture_desc texture = shd_texture_desc_default();
    shd_sampler_desc sampler = shd_sampler_desc_default();
    shd_material_desc material = shd_frame_plain(1, 1, 1);
    texture.format = SHD_FORMAT_R8;
    texture.width = texture.height = 64;
    texture.texels = texels;
    texture.tables = SHD_TABLE_MIPMAP;
    *slot = shd_slot_texture(SHD_SLOT_DIFFUSE, NULL, NULL);
    material.slots = slot;
    material.slot_count = 1;
    shd_assert_ok(shd_texture_create(f->context, &texture, &slot->texture));
    sampler.filter = SHD_FILTER_TRILINEAR;
    sampler.wrap_u = sampler.wrap_v = SHD_WRAP_REPEAT;
    sampler.lod_bias = 0.25f;
    sampler.profile = SHD_PROFILE_EXACT; /* log2 of the longer axis */
    shd_assert_ok(shd_sampler_create(f->context, &sampler, &slot->sampler));
    return material;
}

/* Levels in perspective: they have the bits of shd_texture_query_levels(), and the logarithm of the footprint lies
 * between its bounds. */
static void test_levels(void **state)
{
    static float triangles[24 * TRIANGLES], lod[WIDTH * HEIGHT];
    static uint32_t level[WIDTH * HEIGHT];
    const uint32_t samples = *(const uint32_t *)*state;
    uint32_t random = 7;
    size_t i, different = 0, kinds[7] = {0};
    shd_lookups lookups = shd_lookups_default();
    shd_levels levels = shd_levels_default();
    shd_material_desc material;
    shd_slot slot;
    shd_frame f;
    shd_frame_open_aovs(&f, WIDTH, HEIGHT, samples, ALL_AOVS);
    set_perspective(&f);
    levels.lod = shd_f32_out_column(lod, 0);
    levels.level = shd_u32_out_column(level, 0);
    material = make_textured(&f, &slot);
    make_triangles(&random, triangles);
    shd_frame_draw(&f, triangles, 3 * TRIANGLES, &material);
    shd_frame_render(&f);
    lookups.count = WIDTH * HEIGHT;
    lookups.u.data = f.plane[SHD_PLANE_U];
    lookups.v.data = f.plane[SHD_PLANE_V];
    lookups.dudx.data = f.plane[SHD_PLANE_DUDX];
    lookups.dvdx.data = f.plane[SHD_PLANE_DVDX];
    lookups.dudy.data = f.plane[SHD_PLANE_DUDY];
    lookups.dvdy.data = f.plane[SHD_PLANE_DVDY];
    shd_assert_ok(shd_texture_query_levels(slot.texture, slot.sampler, &lookups, &levels));
    for (i = 0; i < WIDTH * HEIGHT; ++i) {
        const double xx = hypot((double)lookups.dudx.data[i], (double)lookups.dvdx.data[i]);
        const double yy = hypot((double)lookups.dudy.data[i], (double)lookups.dvdy.data[i]);
        const double least = log2(64 * fmax(xx, yy)) + 0.25; /* the ellipse's longer axis is up to sqrt(2) times this
                                                                length */
        const double got = (double)f.plane[SHD_PLANE_LOD][i];
        if (f.triangle[i] == 0xffffffffu) {
            assert_true(got == 0 && f.u32[SHD_PLANE_LEVEL][i] == 0);
            continue;
        }
        assert_memory_equal(&f.plane[SHD_PLANE_LOD][i], &lod[i], sizeof lod[i]);
        assert_int_equal(f.u32[SHD_PLANE_LEVEL][i], level[i]);
        assert_true(got >= fmin(fmax(least, 0), 6) - 1e-4 && got <= fmin(fmax(least + 0.5, 0), 6) + 1e-4);
        ++kinds[level[i]];
    }
    for (i = 0; i < 7; ++i) different += kinds[i] > 0;
    assert_true(different >= 4);
    shd_texture_release(slot.texture);
    shd_sampler_release(slot.sampler);
    shd_frame_close(&f);
}

/* Draws three quads: one over the whole frame, `second` in front of it, and a third one over half of the frame,
 * hidden. */
static void open_layers(shd_frame *f, uint32_t samples, const shd_material_desc *second)
{
    const shd_material_desc plain = shd_frame_plain(1, 1, 1);
    float quad[48];
    shd_frame_open_aovs(f, WIDTH, HEIGHT, samples, ALL_AOVS);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(f, quad, 6, &plain);
    shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.25f, quad);
    shd_frame_draw(f, quad, 6, second);
    shd_frame_quad(-1, -1, 0, 1, 0.75f, 0.75f, quad); /* hidden */
    shd_frame_draw(f, quad, 6, &plain);
    shd_frame_ambient(f);
}

struct layer_case {
    const char *name;
    shd_blend blend;
    float alpha, cutoff;
    int is_depth_alone;
    uint32_t draw, overdraw; /* expected values */
};
static const struct layer_case k_layers[] = {
    {"layers/opaque", SHD_BLEND_OPAQUE, 1, 0, 0, 1, 2},
    {"layers/alpha_kept", SHD_BLEND_OPAQUE, 1, 0.5f, 0, 1, 2},
    {"layers/alpha_dropped", SHD_BLEND_OPAQUE, 0.25f, 0.5f, 0, 0, 1},
    {"layers/depth_alone", SHD_BLEND_OPAQUE, 1, 0, 1, 0xffffffffu, 1},
    {"layers/premultiplied", SHD_BLEND_PREMULTIPLIED, 0.5f, 0, 0, 0, 1},
    {"layers/add", SHD_BLEND_ADD, 0.5f, 0, 0, 0, 1},
    {"layers/weighted", SHD_BLEND_WEIGHTED, 0.5f, 0, 0, 0, 1},
    {"layers/sorted", SHD_BLEND_SORTED, 0.5f, 0, 0, 0, 1},
};

/* Blended draws and dropped fragments do not change the planes; the third draw is always hidden. */
static void test_layers(void **state)
{
    const struct layer_case *c = (const struct layer_case *)*state;
    static const uint32_t k_samples[] = {1, 4};
    size_t i, k;
    for (k = 0; k < 2; ++k) {
        shd_material_desc second = shd_frame_plain(1, 1, 1);
        shd_frame f;
        second.blend = c->blend;
        second.opacity = c->alpha;
        second.alpha_cutoff = c->cutoff;
        open_layers(&f, k_samples[k], &second);
        if (c->is_depth_alone) f.draw[1].material = NULL;
        f.desc.flags = SHD_RENDER_COUNT_HIDDEN;
        shd_frame_render(&f);
        for (i = 0; i < WIDTH * HEIGHT; ++i) {
            assert_int_equal(f.u32[SHD_PLANE_OVERDRAW][i], c->overdraw);
            if (!c->is_depth_alone) assert_int_equal(f.u32[SHD_PLANE_DRAW][i], c->draw);
        }
        assert_int_equal(f.stats.hidden_sample_count, (uint64_t)WIDTH * HEIGHT * k_samples[k] / 2);
        shd_frame_close(&f);
    }
}

/* A second frame that keeps the planes adds to the overdraw; a cleared frame starts at 0. */
static void test_load(void **state)
{
    const shd_material_desc plain = shd_frame_plain(1, 1, 1);
    shd_frame f;
    (void)state;
    open_layers(&f, 2, &plain);
    shd_frame_render(&f);
    assert_int_equal(f.u32[SHD_PLANE_OVERDRAW][77], 2);
    f.desc.flags |= SHD_RENDER_LOAD;
    f.draw[1].compare = SHD_COMPARE_LESS_EQUAL;
    shd_frame_render(&f);
    assert_int_equal(f.u32[SHD_PLANE_OVERDRAW][77], 3);
    f.desc.draw_count = 0;
    shd_frame_render(&f);
    assert_int_equal(f.u32[SHD_PLANE_OVERDRAW][77], 3);
    assert_int_equal(f.u32[SHD_PLANE_DRAW][77], 1);
    f.desc.flags &= ~(uint32_t)SHD_RENDER_LOAD;
    shd_frame_render(&f);
    assert_int_equal(f.u32[SHD_PLANE_OVERDRAW][77], 0);
    assert_int_equal(f.u32[SHD_PLANE_DRAW][77], 0xffffffffu);
    assert_true(f.plane[SHD_PLANE_B1][77] == 0.0f && f.plane[SHD_PLANE_PZ][77] == 0.0f);
    shd_frame_close(&f);
}

/* Optional counts and planes do not change other results; times and memory are always written. */
static void test_statistics(void **state)
{
    static float plain_color[WIDTH * HEIGHT];
    const shd_material_desc plain = shd_frame_plain(1, 0.5f, 1);
    uint64_t fragments;
    shd_frame f;
    (void)state;
    open_layers(&f, 4, &plain);
    shd_frame_render(&f);
    memcpy(plain_color, f.plane[SHD_PLANE_G], sizeof plain_color);
    assert_int_equal(f.stats.hidden_sample_count, 0);
    fragments = f.stats.fragment_count;
    assert_true(f.stats.scratch_bytes > 64 * 64 * 4 * 8 && f.stats.scratch_bytes < 1 << 26);
    assert_true(f.stats.vertex_seconds >= 0 && f.stats.assembly_seconds >= 0);
    assert_true(f.stats.binning_seconds >= 0 && f.stats.tile_seconds > 0);
    f.desc.flags = SHD_RENDER_COUNT_HIDDEN;
    shd_frame_render(&f);
    assert_int_equal(f.stats.hidden_sample_count, WIDTH * HEIGHT * 4 / 2);
    assert_int_equal(f.stats.fragment_count, fragments);
    assert_memory_equal(plain_color, f.plane[SHD_PLANE_G], sizeof plain_color);
    shd_frame_close(&f);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static const uint32_t k_one = 1, k_four = 4;
    static struct CMUnitTest tests[COUNT(k_frames) + COUNT(k_layers) + 4];
    size_t n = 0, i;
    for (i = 0; i < COUNT(k_frames); ++i) {
        tests[n++] = (struct CMUnitTest){k_frames[i].name, test_truth, NULL, NULL, (void *)&k_frames[i]};
    }
    for (i = 0; i < COUNT(k_layers); ++i) {
        tests[n++] = (struct CMUnitTest){k_layers[i].name, test_layers, NULL, NULL, (void *)&k_layers[i]};
    }
    tests[n++] = (struct CMUnitTest){"levels/1", test_levels, NULL, NULL, (void *)&k_one};
    tests[n++] = (struct CMUnitTest){"levels/4", test_levels, NULL, NULL, (void *)&k_four};
    tests[n++] = (struct CMUnitTest){"load", test_load, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"statistics", test_statistics, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_aovs", tests, n, NULL, NULL);
}
