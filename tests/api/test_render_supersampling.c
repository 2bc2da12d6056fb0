/* SPDX-License-Identifier: MIT */
/* Supersampling: frames have the bits of a larger frame that the test averages, for any block, worker count and SIMD
 * target.
 */
#define _POSIX_C_SOURCE 200809L
#include "support/fault_allocator.h"
#include "support/frame.h"
#include "support/pool.h"
#include "support/scene.h"
#include "support/watcher.h"

enum { PLANES = SHD_PLANE_TARGET3_A + 1, ALL_AOVS = 2 * SHD_AOV_TARGET3 - 1 };

/* A frame: the position of a framebuffer in a picture, and the settings of the draws. */
struct frame_case {
    const char *name;
    shd_scene_kind kind;
    uint32_t n, samples;
    uint32_t width, height;
    uint32_t picture_width, picture_height; /* 0 = as the framebuffer */
    uint32_t crop_x, crop_y;
    shd_region viewport, scissor; /* empty = the whole picture */
    uint32_t load;
};
static const struct frame_case k_frames[] = {
    {"one", SHD_SCENE_SMALL, 1, 2, 51, 37, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"two", SHD_SCENE_MIXED, 2, 1, 203, 151, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"two/blocks", SHD_SCENE_SMALL, 2, 2, 515, 21, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"three", SHD_SCENE_GLASS, 3, 1, 101, 77, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"three/samples", SHD_SCENE_GLASS, 3, 4, 101, 77, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"three/blocks", SHD_SCENE_FLOOR, 3, 1, 350, 7, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"three/crop", SHD_SCENE_GLASS, 3, 2, 45, 33, 203, 151, 77, 59, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"seven/load", SHD_SCENE_SMALL, 7, 1, 61, 43, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 1},
    {"sixteen", SHD_SCENE_SMALL, 16, 1, 77, 69, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"sixteen/samples", SHD_SCENE_SMALL, 16, 4, 33, 21, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"sixteen/load", SHD_SCENE_SMALL, 16, 2, 70, 9, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 1},
    {"sixteen/one_pixel", SHD_SCENE_GLASS, 16, 1, 1, 1, 203, 151, 100, 90, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
    {"five/viewport", SHD_SCENE_GLASS, 5, 1, 90, 60, 0, 0, 0, 0, {13, 7, 61, 50}, {0, 0, 0, 0}, 0},
    {"five/scissor", SHD_SCENE_GLASS, 5, 1, 90, 60, 0, 0, 0, 0, {0, 0, 0, 0}, {21, 11, 33, 29}, 0},
    {"five/scissor_load", SHD_SCENE_SMALL, 5, 4, 90, 60, 0, 0, 0, 0, {0, 0, 0, 0}, {21, 11, 33, 29}, 1},
    {"five/all_regions", SHD_SCENE_GLASS, 5, 2, 90, 60, 203, 151, 40, 30, {20, 10, 160, 130}, {50, 20, 60, 50}, 0},
    {"five/nothing_left", SHD_SCENE_SMALL, 5, 1, 40, 30, 203, 151, 40, 30, {0, 0, 0, 0}, {190, 140, 5, 5}, 0},
};
enum { FRAMES = sizeof k_frames / sizeof k_frames[0] };

static shd_framebuffer *make_framebuffer(shd_context *context, uint32_t width, uint32_t height, uint32_t samples)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    desc.width = width;
    desc.height = height;
    desc.sample_count = samples;
    desc.aovs = ALL_AOVS;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &framebuffer));
    return framebuffer;
}

/* Element (x, y) of a plane as bits. The framebuffer is the test's own, so that it may write there. */
static uint32_t *element(const shd_framebuffer *framebuffer, int plane, uint32_t x, uint32_t y)
{
    shd_plane_view view = shd_plane_view_default();
    shd_assert_ok(shd_framebuffer_view_plane(framebuffer, (shd_plane)plane, &view));
    return (uint32_t *)(uintptr_t)((view.f32 ? (const char *)view.f32 : (const char *)view.u32) + y * view.row_stride) +
           x;
}

/* Previous contents of a framebuffer: a different value in every pixel of the frame, repeated n x n times. */
static void fill(const shd_framebuffer *framebuffer, uint32_t n)
{
    shd_framebuffer_info info = shd_framebuffer_info_default();
    uint32_t x, y;
    int plane;
    shd_assert_ok(shd_framebuffer_get_info(framebuffer, &info));
    for (plane = 0; plane < PLANES; ++plane) {
        for (y = 0; y < info.height; ++y) {
            uint32_t *row = element(framebuffer, plane, 0, y);
            for (x = 0; x < info.width; ++x) {
                const uint32_t number = (x / n * 7u + y / n * 13u + (uint32_t)plane) % 97u;
                const float value = (float)number / 97.0f;
                memcpy(row + x, &value, sizeof value);
            }
        }
    }
}

static shd_region times(const shd_region *r, uint32_t n)
{
    const shd_region large = {r->x * n, r->y * n, r->width * n, r->height * n};
    return large;
}

/* Width of lines and points, in pixels of the case; 0 = solid. */
static float g_fill_width;

static void outline_scene(shd_scene *s, float scale)
{
    size_t i;
    for (i = 0; i < s->desc.draw_count && g_fill_width > 0; ++i) {
        s->draw[i].fill = i % 2 ? SHD_FILL_POINTS : SHD_FILL_WIREFRAME;
        s->draw[i].fill_width = g_fill_width * scale;
    }
}

/* Lines of the scene keep their width in pixels of the case. */
static void scale_lines(shd_scene *s, float factor)
{
    size_t i;
    for (i = 0; i < s->desc.draw_count && g_fill_width == 0; ++i) {
        if (s->draw[i].fill == SHD_FILL_LINES) s->draw[i].fill_width *= factor;
    }
}

/* Draws a case into a framebuffer with `size` pixels for each pixel of the case, with or without supersampling. */
static void draw(shd_scene *s, const struct frame_case *c, shd_framebuffer *framebuffer, uint32_t size, uint32_t n)
{
    const shd_region viewport = times(&c->viewport, size), scissor = times(&c->scissor, size);
    s->desc.framebuffer = framebuffer;
    s->desc.picture_width = c->picture_width * size;
    s->desc.picture_height = c->picture_height * size;
    s->desc.crop_x = c->crop_x * size;
    s->desc.crop_y = c->crop_y * size;
    s->desc.viewport = c->viewport.width ? &viewport : NULL;
    s->desc.scissor = c->scissor.width ? &scissor : NULL;
    s->desc.flags = SHD_RENDER_COUNT_HIDDEN | (uint32_t)(c->load ? SHD_RENDER_LOAD : SHD_RENDER_NONE);
    s->desc.supersampling = n;
    outline_scene(s, (float)size);
    scale_lines(s, (float)size);
    fill(framebuffer, size);
    memset(&s->stats, 0xee, sizeof s->stats);
    s->stats.struct_size = sizeof s->stats;
    shd_assert_ok(shd_render(s->context, &s->desc));
    scale_lines(s, 1.0f / (float)size);
    s->desc.viewport = s->desc.scissor = NULL;
}

static int is_in_scissor(const struct frame_case *c, uint32_t x, uint32_t y)
{
    const shd_region *r = &c->scissor;
    const uint32_t at_x = c->crop_x + x, at_y = c->crop_y + y;
    if (!r->width) return 1;
    return at_x >= r->x && at_x - r->x < r->width && at_y >= r->y && at_y - r->y < r->height;
}

/* Expected value of a pixel, computed from the large frame. */
static uint32_t expected(const shd_framebuffer *large, const struct frame_case *c, int plane, uint32_t x, uint32_t y)
{
    double sum = 0.0;
    float mean;
    uint32_t i, j, bits;
    const int is_color = plane < SHD_PLANE_DEPTH || plane >= SHD_PLANE_TARGET1_R;
    if (!is_color || !is_in_scissor(c, x, y)) return *element(large, plane, c->n * x, c->n * y);
    for (j = 0; j < c->n; ++j) {
        const uint32_t *row = element(large, plane, c->n * x, c->n * y + j);
        for (i = 0; i < c->n; ++i) {
            float value;
            memcpy(&value, row + i, sizeof value);
            sum = i + j ? sum + (double)value : (double)value;
        }
    }
    mean = (float)(sum / (c->n * c->n));
    memcpy(&bits, &mean, sizeof bits);
    return bits;
}

static int is_nan(uint32_t bits) { return (bits & 0x7fffffffu) > 0x7f800000u; }

static void test_truth(void **state)
{
    const struct frame_case *c = (const struct frame_case *)*state;
    shd_context *context = NULL;
    shd_framebuffer *large, *small;
    shd_render_stats stats;
    shd_scene s;
    uint32_t x, y;
    int plane;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, c->kind, context);
    s.desc.clear_color[0] = 0.1f;
    large = make_framebuffer(context, c->width * c->n, c->height * c->n, c->samples);
    small = make_framebuffer(context, c->width, c->height, c->samples);
    draw(&s, c, large, c->n, 1);
    stats = s.stats;
    draw(&s, c, small, 1, c->n);
    if (!c->scissor.width) { /* a scissor moves the tiles, and blended draws are tested against stale depth by tile */
        assert_true(s.stats.fragment_count == stats.fragment_count);
        assert_true(s.stats.nonfinite_fragment_count == stats.nonfinite_fragment_count);
        assert_true(s.stats.hidden_sample_count == stats.hidden_sample_count);
    }
    for (plane = 0; plane < PLANES; ++plane) {
        for (y = 0; y < c->height; ++y) {
            for (x = 0; x < c->width; ++x) {
                const uint32_t got = *element(small, plane, x, y), want = expected(large, c, plane, x, y);
                if (got != want && !(is_nan(got) && is_nan(want))) {
                    fail_msg("plane %d at %u, %u: %08x, not %08x", plane, x, y, got, want);
                }
            }
        }
    }
    shd_framebuffer_release(large);
    shd_framebuffer_release(small);
    shd_scene_close(&s);
    shd_context_release(context);
}

/* Lines and points keep their width in the picture. */
static void test_outlines(void **state)
{
    static struct frame_case k_cases[2] = {
        {"", SHD_SCENE_SMALL, 2, 1, 97, 61, 97, 61, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0},
        {"", SHD_SCENE_SMALL, 5, 4, 33, 29, 33, 29, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0}};
    size_t i;
    (void)state;
    g_fill_width = 1.5f;
    for (i = 0; i < 2; ++i) {
        void *one = &k_cases[i];
        test_truth(&one);
    }
    g_fill_width = 0;
}

/* Windows of a picture have other block borders, but the same bits as the whole picture. */
static void test_windows(void **state)
{
    static const uint32_t k_sizes[][2] = {{64, 64}, {65, 63}, {141, 9}, {33, 101}};
    static struct frame_case c = {"", SHD_SCENE_SMALL, 8, 2, 141, 101, 141, 101, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0};
    shd_context *context = NULL;
    shd_framebuffer *whole;
    shd_scene s;
    size_t i;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, c.kind, context);
    whole = make_framebuffer(context, c.width, c.height, c.samples);
    draw(&s, &c, whole, 1, c.n);
    for (i = 0; i < sizeof k_sizes / sizeof k_sizes[0]; ++i) {
        struct frame_case part = c;
        for (part.crop_y = 0; part.crop_y < c.height; part.crop_y += k_sizes[i][1]) {
            for (part.crop_x = 0; part.crop_x < c.width; part.crop_x += k_sizes[i][0]) {
                const uint32_t right = c.width - part.crop_x, down = c.height - part.crop_y;
                shd_framebuffer *window;
                uint32_t y;
                int plane;
                part.width = right < k_sizes[i][0] ? right : k_sizes[i][0];
                part.height = down < k_sizes[i][1] ? down : k_sizes[i][1];
                window = make_framebuffer(context, part.width, part.height, c.samples);
                draw(&s, &part, window, 1, c.n);
                for (plane = 0; plane < PLANES; ++plane) {
                    for (y = 0; y < part.height; ++y) {
                        assert_memory_equal(element(window, plane, 0, y),
                                            element(whole, plane, part.crop_x, part.crop_y + y), 4 * part.width);
                    }
                }
                shd_framebuffer_release(window);
            }
        }
    }
    shd_framebuffer_release(whole);
    shd_scene_close(&s);
    shd_context_release(context);
}

/* Hash of a frame in several blocks. */
static uint64_t hash_on(const shd_context_desc *desc)
{
    shd_context *context = NULL;
    shd_scene s;
    uint64_t hash;
    shd_assert_ok(shd_context_create(desc, &context));
    shd_scene_open(&s, SHD_SCENE_GLASS, context);
    s.desc.supersampling = 6;
    s.desc.flags = SHD_RENDER_COUNT_HIDDEN;
    hash = shd_scene_render(&s);
    shd_scene_close(&s);
    shd_context_release(context);
    return hash;
}

static void test_workers_and_targets(void **state)
{
    const uint64_t want = hash_on(NULL);
    shd_pool pool = {4, SHD_POOL_RANDOM, 5};
    shd_context_desc desc = shd_pool_context_desc(&pool);
    int simd;
    (void)state;
    assert_true(hash_on(&desc) == want);
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context *context = NULL;
        desc = shd_context_desc_default();
        desc.simd = (shd_simd)simd;
        desc.worker_count = 1 + (uint32_t)simd % 2;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        shd_context_release(context);
        assert_true(hash_on(&desc) == want);
    }
}

/* The counts of the blocks of a frame add up: the second of two quads fails at every sample. */
static void test_hidden(void **state)
{
    static const uint32_t k_sizes[2][3] = {{64, 64, 2}, {530, 40, 2}}; /* width, height, n: one block, two blocks */
    size_t i;
    (void)state;
    for (i = 0; i < 2; ++i) {
        const uint32_t width = k_sizes[i][0], height = k_sizes[i][1], n = k_sizes[i][2];
        const shd_material_desc grey = shd_frame_plain(0.5f, 0.5f, 0.5f);
        float quad[48];
        shd_frame f;
        shd_frame_open(&f, width, height);
        shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.25f, quad);
        shd_frame_draw(&f, quad, 6, &grey);
        shd_frame_quad(-1, -1, 1, 1, 0.75f, 0.75f, quad);
        shd_frame_draw(&f, quad, 6, &grey);
        f.desc.supersampling = n;
        f.desc.flags = SHD_RENDER_COUNT_HIDDEN;
        shd_frame_render(&f);
        assert_int_equal(f.stats.hidden_sample_count, (uint64_t)width * height * n * n);
        assert_int_equal(f.stats.fragment_count, (uint64_t)width * height * n * n);
        shd_frame_close(&f);
    }
}

/* Footprints become smaller with the pixels: levels are log2 n finer, derivatives n times smaller. */
static void test_footprints(void **state)
{
    const struct frame_case plain = {"", SHD_SCENE_FLOOR, 1, 1, 64, 64, 0, 0, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}, 0};
    shd_context *context = NULL;
    shd_framebuffer *once, *often;
    shd_scene s;
    uint32_t x, y, found = 0;
    double sum = 0;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_FLOOR, context);
    once = make_framebuffer(context, 64, 64, 1);
    often = make_framebuffer(context, 64, 64, 1);
    draw(&s, &plain, once, 1, 1);
    draw(&s, &plain, often, 1, 4);
    for (y = 33; y < 64; ++y) {
        for (x = 0; x < 64; ++x) {
            float coarse, fine;
            memcpy(&coarse, element(once, SHD_PLANE_LOD, x, y), sizeof coarse);
            memcpy(&fine, element(often, SHD_PLANE_LOD, x, y), sizeof fine);
            if (coarse < 2.5f || coarse > 3.75f) continue; /* within the levels */
            ++found;
            /* single pixels differ by the curvature of perspective; their mean does not */
            shd_assert_close("levels", x, (double)(coarse - fine), 2.0, 0.5, 0.0);
            sum += (double)(coarse - fine);
        }
    }
    assert_true(found > 64);
    shd_assert_close("mean level", found, sum / (double)found, 2.0, 0.1, 0.0);
    shd_framebuffer_release(once);
    shd_framebuffer_release(often);
    shd_scene_close(&s);
    shd_context_release(context);
}

static void test_progress(void **state)
{
    shd_watcher w = {0, 0, 0, 0.0f};
    shd_context *context = NULL;
    shd_scene s;
    int total, at;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    s.desc.supersampling = 12; /* 1200 x 840: two blocks */
    s.desc.progress.report = shd_watch;
    s.desc.progress.user_data = &w;
    shd_assert_ok(shd_render(context, &s.desc));
    assert_int_equal(w.mistakes, 0);
    assert_true(w.latest == 1.0f);
    total = w.reports;
    assert_true(total > 200);
    for (at = 1; at <= total; at += 37) {
        memset(&w, 0, sizeof w);
        w.cancel_at = at;
        shd_assert_result("cancel", shd_render(context, &s.desc), SHD_ERROR_CANCELLED, "render.progress");
        assert_int_equal(w.reports, at);
        assert_true(s.stats.triangle_count == 0 && s.stats.fragment_count == 0);
    }
    shd_scene_close(&s);
    shd_context_release(context);
}

/* Every allocation fails in turn; memory depends on the size of a block, not of the frame. */
static void test_memory(void **state)
{
    shd_fault_allocator memory;
    shd_context_desc desc = shd_fault_context_desc(&memory);
    shd_context *context = NULL;
    shd_scene s;
    uint64_t want;
    shd_framebuffer *whole;
    size_t n, before;
    (void)state;
    memset(&memory, 0, sizeof memory);
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    whole = s.framebuffer;
    s.framebuffer = s.desc.framebuffer = make_framebuffer(context, 70, 3, 1);
    s.desc.supersampling = 16; /* 1120 x 48: two blocks */
    want = shd_scene_render(&s);
    before = memory.live_bytes;
    for (n = 1;; n += SHD_IS_SANITIZED ? 3 : 1) {
        shd_result result;
        shd_fault_arm(&memory, n, n % 2 == 0);
        result = shd_render(context, &s.desc);
        shd_fault_arm(&memory, 0, 0);
        assert_int_equal(memory.live_bytes, before);
        if (result == SHD_OK) break;
        shd_assert_result("render", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
    }
    assert_true(n > 50);
    assert_true(shd_scene_render(&s) == want);
    shd_framebuffer_release(s.framebuffer);
    s.framebuffer = s.desc.framebuffer = whole; /* 1600 x 1120 */
    memory.peak_bytes = before = memory.live_bytes;
    shd_assert_ok(shd_render(context, &s.desc));
    assert_true(memory.peak_bytes - before == s.stats.scratch_bytes);
    assert_true(s.stats.scratch_bytes >= 1024 * 1024 * 25 * 4);
    assert_true(s.stats.scratch_bytes < 1024 * 1024 * 25 * 4 + (32u << 20));
    shd_scene_close(&s);
    shd_context_release(context);
    shd_assert_all_freed("memory", &memory);
}

int main(void)
{
    static struct CMUnitTest tests[FRAMES + 8];
    size_t n = 0, i;
    for (i = 0; i < FRAMES; ++i) {
        tests[n++] = (struct CMUnitTest){k_frames[i].name, test_truth, NULL, NULL, (void *)(uintptr_t)&k_frames[i]};
    }
    tests[n++] = (struct CMUnitTest){"outlines", test_outlines, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"windows", test_windows, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"workers_and_targets", test_workers_and_targets, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"hidden", test_hidden, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"footprints", test_footprints, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"progress", test_progress, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"memory", test_memory, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_supersampling", tests, n, NULL, NULL);
}
