/* SPDX-License-Identifier: MIT */
/* Finished tiles: each pixel is passed once, with the bits that the framebuffer holds, in every kind of frame, colour
 * format and number of workers; callbacks that fail; steady frames. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>

#include "support/fault_allocator.h"
#include "support/pool.h"
#include "support/scene.h"

enum { MAX_WIDTH = 203, MAX_HEIGHT = 151, MAX_PIXELS = MAX_WIDTH * MAX_HEIGHT, WORKERS = 4 };
enum { FEWEST = SHD_IS_SANITIZED ? WORKERS : 1 }; /* workers */

/* The tiles that a callback received. */
struct receiver {
    pthread_mutex_t mutex;
    uint32_t width, height;
    float rgba[4 * MAX_PIXELS];
    uint8_t times[MAX_PIXELS]; /* number of times that each pixel was passed */
    int inside[WORKERS];       /* calls of a worker that run */
    int calls, mistakes;
    int fail_at; /* 0 = never */
    shd_result fail_with;
};

static shd_result receive(const shd_present_tile *tile, void *user_data)
{
    struct receiver *r = (struct receiver *)user_data;
    uint32_t x, y, c;
    int call;
    pthread_mutex_lock(&r->mutex);
    call = ++r->calls;
    r->mistakes += tile->struct_size != sizeof *tile || tile->worker >= WORKERS || tile->area.width - 1 > 63 ||
                   tile->area.height - 1 > 63 || tile->area.x + tile->area.width > r->width ||
                   tile->area.y + tile->area.height > r->height;
    r->mistakes += r->inside[tile->worker % WORKERS]++ != 0;
    pthread_mutex_unlock(&r->mutex);
    for (y = 0; y < tile->area.height; ++y) {
        for (x = 0; x < tile->area.width; ++x) {
            const size_t at = (size_t)(tile->area.y + y) * r->width + tile->area.x + x;
            ++r->times[at];
            for (c = 0; c < 4; ++c) {
                memcpy(&r->rgba[4 * at + c], (const char *)(tile->channel[c] + x) + y * tile->row_stride, 4);
            }
        }
    }
    pthread_mutex_lock(&r->mutex);
    --r->inside[tile->worker % WORKERS];
    pthread_mutex_unlock(&r->mutex);
    if (call != r->fail_at) return SHD_OK;
    return r->fail_with == SHD_ERROR_IO ? shd_report_error(SHD_ERROR_IO, "no more ink") : r->fail_with;
}

static void start(struct receiver *r, const shd_framebuffer *framebuffer)
{
    shd_framebuffer_info info = shd_framebuffer_info_default();
    shd_assert_ok(shd_framebuffer_get_info(framebuffer, &info));
    memset(r, 0, sizeof *r);
    pthread_mutex_init(&r->mutex, NULL);
    r->width = info.width;
    r->height = info.height;
    assert_true((size_t)info.width * info.height <= MAX_PIXELS);
}

/* Whether each pixel was passed once, with these colours. NaN may have any bits. */
static void expect(const char *name, const struct receiver *r, const float *rgba)
{
    size_t i;
    assert_int_equal(r->mistakes, 0);
    for (i = 0; i < 4 * (size_t)r->width * r->height; ++i) {
        if (r->times[i / 4] != 1) fail_msg("%s: pixel %zu was passed %d times", name, i / 4, r->times[i / 4]);
        if (memcmp(&r->rgba[i], &rgba[i], 4) == 0 || (isnan(r->rgba[i]) && isnan(rgba[i]))) continue;
        fail_msg("%s: channel %zu is %.9g, want %.9g", name, i, (double)r->rgba[i], (double)rgba[i]);
    }
}

static void read_color(const shd_framebuffer *framebuffer, const struct receiver *r, float *rgba)
{
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA32F;
    image.width = r->width;
    image.height = r->height;
    image.pixels = rgba;
    shd_assert_ok(shd_framebuffer_read_color(framebuffer, &image));
}

static shd_framebuffer *make_framebuffer(shd_context *context, uint32_t samples, shd_format color)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    desc.width = 130;
    desc.height = 91;
    desc.sample_count = samples;
    desc.color_format = color;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &framebuffer));
    return framebuffer;
}

/* ---- the colours of every kind of frame ---- */

static const shd_region k_scissor = {90, 31, 40, 50}, k_empty = {5, 5, 0, 0}, k_viewport = {20, 10, 100, 70};

static void edit_nothing(shd_render_desc *d) { (void)d; }
static void edit_empty(shd_render_desc *d) { d->draw_count = 0; }
static void edit_passes(shd_render_desc *d) { d->pass_triangles = 1024; }
static void edit_supersampling(shd_render_desc *d) { d->supersampling = 3; }
static void edit_painter(shd_render_desc *d) { d->visibility = SHD_VISIBILITY_PAINTER; }
static void edit_crop(shd_render_desc *d)
{
    d->picture_width = 300, d->picture_height = 200;
    d->crop_x = 71, d->crop_y = 53;
}
static void edit_scissor(shd_render_desc *d) { d->scissor = &k_scissor; }
static void edit_no_scissor(shd_render_desc *d) { d->scissor = &k_empty; }
static void edit_viewport(shd_render_desc *d) { d->viewport = &k_viewport; }
static void edit_load(shd_render_desc *d) { d->flags = SHD_RENDER_LOAD; }
static void edit_all(shd_render_desc *d)
{
    edit_crop(d);
    d->scissor = &k_scissor;
    d->flags = SHD_RENDER_LOAD;
    d->pass_triangles = 1024;
}
static void edit_supersampled_scissor(shd_render_desc *d)
{
    d->supersampling = 2;
    d->scissor = &k_scissor;
    d->pass_triangles = 1024;
}

struct frame_case {
    const char *name;
    void (*edit)(shd_render_desc *desc);
    int keeps; /* some pixels keep their values, which interleaved formats have rounded */
};
static const struct frame_case k_frames[] = {
    {"frame/plain", edit_nothing, 0},
    {"frame/no_draws", edit_empty, 0},
    {"frame/passes", edit_passes, 0},
    {"frame/supersampling", edit_supersampling, 0},
    {"frame/painter", edit_painter, 0},
    {"frame/crop", edit_crop, 0},
    {"frame/viewport", edit_viewport, 0},
    {"frame/scissor", edit_scissor, 1},
    {"frame/empty_scissor", edit_no_scissor, 1},
    {"frame/load", edit_load, 1},
    {"frame/crop_scissor_load_passes", edit_all, 1},
    {"frame/supersampled_scissor_passes", edit_supersampled_scissor, 1},
};
static const shd_format k_colors[] = {SHD_FORMAT_RGBA32F, SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA8};
static const shd_scene_kind k_kinds[] = {SHD_SCENE_MIXED, SHD_SCENE_SMALL};

static struct receiver g_receiver;
static float g_want[4 * MAX_PIXELS];

/* The frame in four planes, without a callback, after a first frame that the second one may keep. */
static void make_reference(shd_scene *s, const struct frame_case *c, uint32_t samples)
{
    shd_framebuffer *framebuffer = make_framebuffer(s->context, samples, SHD_FORMAT_RGBA32F);
    start(&g_receiver, framebuffer);
    s->desc.framebuffer = framebuffer;
    shd_assert_ok(shd_render(s->context, &s->desc));
    c->edit(&s->desc);
    shd_assert_ok(shd_render(s->context, &s->desc));
    read_color(framebuffer, &g_receiver, g_want);
    shd_framebuffer_release(framebuffer);
}

/* The interleaved pixels of a framebuffer are the passed colours, rounded. */
static void expect_rounded(const char *name, const shd_framebuffer *framebuffer, const struct receiver *r)
{
    static unsigned char want[8 * MAX_PIXELS];
    shd_framebuffer *planes = make_framebuffer(shd_framebuffer_get_context(framebuffer), 1, SHD_FORMAT_RGBA32F);
    shd_image view = shd_image_default(), image = shd_image_default();
    uint32_t x, y, c;
    for (c = 0; c < 4; ++c) {
        shd_plane_view plane = shd_plane_view_default();
        shd_assert_ok(shd_framebuffer_view_plane(planes, (shd_plane)(SHD_PLANE_R + (int)c), &plane));
        for (y = 0; y < r->height; ++y) {
            float *row = (float *)((uintptr_t)plane.f32 + y * plane.row_stride);
            for (x = 0; x < r->width; ++x) row[x] = r->rgba[4 * ((size_t)y * r->width + x) + c];
        }
    }
    shd_assert_ok(shd_framebuffer_view_color(framebuffer, &view));
    image = view;
    image.pixels = want;
    image.row_stride = 0;
    shd_assert_ok(shd_framebuffer_read_color(planes, &image));
    for (y = 0; y < r->height; ++y) {
        const size_t row = r->width * shd_format_size(view.format);
        if (memcmp((const char *)view.pixels + y * view.row_stride, want + y * row, row) != 0) {
            fail_msg("%s, format %d: row %u differs", name, (int)view.format, y);
        }
    }
    shd_framebuffer_release(planes);
}

static void check_format(shd_scene *s, const struct frame_case *c, uint32_t samples, shd_format color)
{
    static float after[4 * MAX_PIXELS];
    shd_framebuffer *framebuffer = make_framebuffer(s->context, samples, color);
    start(&g_receiver, framebuffer);
    shd_scene_compose(s);
    s->desc.framebuffer = framebuffer;
    shd_assert_ok(shd_render(s->context, &s->desc));
    c->edit(&s->desc);
    s->desc.present.tile = receive;
    s->desc.present.user_data = &g_receiver;
    shd_assert_ok(shd_render(s->context, &s->desc));
    read_color(framebuffer, &g_receiver, after);
    if (color == SHD_FORMAT_RGBA32F) {
        expect(c->name, &g_receiver, after);
    } else {
        expect_rounded(c->name, framebuffer, &g_receiver);
    }
    if (color == SHD_FORMAT_RGBA32F || !c->keeps) expect(c->name, &g_receiver, g_want);
    shd_framebuffer_release(framebuffer);
}

static void test_frame(void **state)
{
    const struct frame_case *c = (const struct frame_case *)*state;
    size_t workers, kind, f;
    for (workers = FEWEST; workers <= WORKERS; workers += 3) {
        shd_pool pool;
        shd_context_desc desc;
        shd_context *context = NULL;
        pool.worker_count = (uint32_t)workers;
        pool.order = SHD_POOL_RANDOM;
        pool.seed = 5;
        desc = shd_pool_context_desc(&pool);
        shd_assert_ok(shd_context_create(&desc, &context));
        for (kind = 0; kind < 2; ++kind) {
            const uint32_t samples = kind ? 4 : 1;
            shd_scene s;
            shd_scene_open(&s, k_kinds[kind], context);
            make_reference(&s, c, samples);
            for (f = 0; f < sizeof k_colors / sizeof k_colors[0]; ++f) check_format(&s, c, samples, k_colors[f]);
            s.desc.framebuffer = s.framebuffer;
            shd_scene_close(&s);
        }
        shd_context_release(context);
    }
}

/* ---- failures ---- */

struct fail_case {
    const char *name;
    shd_result result, expected;
    const char *message;
};
static const struct fail_case k_fails[] = {
    {"fail/io", SHD_ERROR_IO, SHD_ERROR_IO, "no more ink"},
    {"fail/cancelled", SHD_ERROR_CANCELLED, SHD_ERROR_CANCELLED, ""},
    {"fail/unknown", (shd_result)77, SHD_ERROR_CALLBACK, "render.present.tile returned SHD_RESULT_UNKNOWN"},
    {"fail/unknown_large", (shd_result)0x7ffffff0, SHD_ERROR_CALLBACK,
     "render.present.tile returned SHD_RESULT_UNKNOWN"},
};

static void test_fail(void **state)
{
    const struct fail_case *c = (const struct fail_case *)*state;
    const uint64_t want = shd_scene_reference(SHD_SCENE_SMALL);
    uint32_t workers, supersampling;
    for (workers = FEWEST; workers <= WORKERS; workers += 3) {
        shd_pool pool;
        shd_context_desc desc;
        shd_context *context = NULL;
        shd_scene s;
        int at;
        pool.worker_count = workers;
        pool.order = SHD_POOL_FORWARD;
        pool.seed = 1;
        desc = shd_pool_context_desc(&pool);
        shd_assert_ok(shd_context_create(&desc, &context));
        shd_scene_open(&s, SHD_SCENE_SMALL, context);
        s.desc.present.tile = receive;
        s.desc.present.user_data = &g_receiver;
        for (supersampling = 1; supersampling <= 2; ++supersampling) {
            for (at = 1; at <= 4; ++at) { /* tiles of 100 x 70 */
                start(&g_receiver, s.framebuffer);
                g_receiver.fail_at = at;
                g_receiver.fail_with = c->result;
                memset(&s.stats, 0xee, sizeof s.stats);
                s.stats.struct_size = sizeof s.stats;
                s.desc.supersampling = supersampling;
                shd_assert_result(c->name, shd_render(context, &s.desc), c->expected, c->message);
                assert_true(s.stats.triangle_count == 0 && s.stats.fragment_count == 0);
                assert_int_equal(g_receiver.mistakes, 0);
                if (workers == 1) assert_int_equal(g_receiver.calls, at); /* no call after the failure */
                s.desc.supersampling = 1;
                start(&g_receiver, s.framebuffer);
                assert_true(shd_scene_render(&s) == want);
                assert_int_equal(g_receiver.calls, 4);
            }
        }
        shd_scene_close(&s);
        shd_context_release(context);
    }
}

/* ---- memory ---- */

/* A callback costs a frame no allocation, and a loop of frames makes none. */
static void test_steady(void **state)
{
    static const shd_format k_formats[] = {SHD_FORMAT_RGBA32F, SHD_FORMAT_RGBA8};
    shd_fault_allocator memory;
    shd_context_desc desc;
    shd_context *context = NULL;
    shd_scene s;
    size_t f, i;
    (void)state;
    memset(&memory, 0, sizeof memory);
    desc = shd_fault_context_desc(&memory);
    desc.flags = SHD_CONTEXT_NONE;
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    for (f = 0; f < 2; ++f) {
        shd_framebuffer *framebuffer = make_framebuffer(context, 2, k_formats[f]);
        s.desc.framebuffer = framebuffer;
        s.desc.present.tile = NULL;
        shd_assert_ok(shd_render(context, &s.desc));
        memory.calls = 0;
        s.desc.present.tile = receive;
        s.desc.present.user_data = &g_receiver;
        for (i = 0; i < 4; ++i) {
            start(&g_receiver, framebuffer);
            shd_assert_ok(shd_render(context, &s.desc));
            assert_int_equal(g_receiver.calls, 6);
        }
        assert_int_equal(memory.calls, 0);
        shd_framebuffer_release(framebuffer);
    }
    shd_scene_close(&s);
    shd_context_release(context);
    shd_assert_all_freed("steady", &memory);
}

int main(void)
{
    enum { FRAMES = sizeof k_frames / sizeof k_frames[0], FAILS = sizeof k_fails / sizeof k_fails[0] };
    static struct CMUnitTest tests[FRAMES + FAILS + 1];
    size_t n = 0, i;
    for (i = 0; i < FRAMES; ++i) {
        tests[n++] = (struct CMUnitTest){k_frames[i].name, test_frame, NULL, NULL, (void *)(uintptr_t)&k_frames[i]};
    }
    for (i = 0; i < FAILS; ++i) {
        tests[n++] = (struct CMUnitTest){k_fails[i].name, test_fail, NULL, NULL, (void *)(uintptr_t)&k_fails[i]};
    }
    tests[n++] = (struct CMUnitTest){"steady", test_steady, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.present", tests, n, NULL, NULL);
}
