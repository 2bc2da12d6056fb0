/* SPDX-License-Identifier: MIT */
/* shd_color_render(): the bytes of shd_render() and shd_color_apply_display() one after the other, for every format,
 * precision, kind of frame and number of workers; refusals; failed allocations; steady frames. */
#define _POSIX_C_SOURCE 200809L
#include "support/color.h"
#include "support/fault_allocator.h"
#include "support/pool.h"
#include "support/scene.h"

enum { WIDTH = 130, HEIGHT = 91, ROW = 16 * WIDTH + 48, BYTES = ROW * HEIGHT };

static const shd_format k_formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA16F,
                                       SHD_FORMAT_RGBA32F};
enum { FORMATS = sizeof k_formats / sizeof k_formats[0] };
static unsigned char g_want[BYTES], g_got[BYTES];

/* A scene, its framebuffer and the colour of its context. */
struct stage {
    shd_pool pool;
    shd_context *context;
    shd_scene scene;
    shd_framebuffer *framebuffer;
    shd_color *color;
};

static shd_color *make_color(shd_context *context, shd_display_precision precision)
{
    shd_color_desc desc = shd_color_desc_default();
    shd_color *color = NULL;
    desc.config_text = shd_color_default_config();
    desc.display_precision = precision;
    shd_assert_ok(shd_color_create(context, &desc, &color));
    return color;
}

static shd_framebuffer *make_framebuffer(shd_context *context, uint32_t samples, shd_format color_format)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.sample_count = samples;
    desc.color_format = color_format;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &framebuffer));
    return framebuffer;
}

static void open_stage(struct stage *s, uint32_t workers, shd_simd simd, shd_display_precision precision)
{
    shd_context_desc desc;
    memset(s, 0, sizeof *s);
    s->pool.worker_count = workers;
    s->pool.order = SHD_POOL_RANDOM;
    desc = shd_pool_context_desc(&s->pool);
    desc.simd = simd;
    shd_assert_ok(shd_context_create(&desc, &s->context));
    shd_scene_open(&s->scene, SHD_SCENE_SMALL, s->context);
    s->framebuffer = make_framebuffer(s->context, 1, SHD_FORMAT_RGBA32F);
    s->scene.desc.framebuffer = s->framebuffer;
    s->color = make_color(s->context, precision);
}

static void close_stage(struct stage *s)
{
    shd_color_release(s->color);
    shd_framebuffer_release(s->framebuffer);
    shd_scene_close(&s->scene);
    shd_context_release(s->context);
}

/* An image whose rows have 48 bytes to spare, filled with 0xa5. */
static shd_image make_image(shd_format format, unsigned char *pixels)
{
    shd_image image = shd_test_image(format, WIDTH, HEIGHT, pixels);
    image.row_stride = shd_format_size(format) * WIDTH + 48;
    memset(pixels, 0xa5, BYTES);
    return image;
}

/* ---- the bytes ---- */

static const shd_region k_scissor = {60, 31, 40, 50};

static void edit_nothing(shd_render_desc *d) { (void)d; }
static void edit_empty(shd_render_desc *d) { d->draw_count = 0; }
static void edit_supersampling(shd_render_desc *d) { d->supersampling = 3; }
static void edit_passes(shd_render_desc *d) { d->pass_triangles = 1024; }
static void edit_crop(shd_render_desc *d)
{
    d->picture_width = 300, d->picture_height = 200;
    d->crop_x = 71, d->crop_y = 53;
}
static void edit_clear(shd_render_desc *d)
{
    d->clear_color[0] = 2.0f, d->clear_color[1] = -0.25f;
    d->clear_color[3] = 0.5f;
}
static void edit_scissor_load(shd_render_desc *d)
{
    d->scissor = &k_scissor;
    d->flags = SHD_RENDER_LOAD;
}

struct frame_case {
    const char *name;
    uint32_t samples;
    shd_format color_format;
    void (*edit)(shd_render_desc *desc);
};
static const struct frame_case k_frames[] = {
    {"bytes/plain", 1, SHD_FORMAT_RGBA32F, edit_nothing},
    {"bytes/no_draws", 1, SHD_FORMAT_RGBA8, edit_empty},
    {"bytes/rgba8", 1, SHD_FORMAT_RGBA8, edit_nothing},
    {"bytes/rgba16f", 1, SHD_FORMAT_RGBA16F, edit_nothing},
    {"bytes/samples", 4, SHD_FORMAT_RGBA32F, edit_nothing},
    {"bytes/samples_rgba8", 8, SHD_FORMAT_RGBA8_SRGB, edit_clear},
    {"bytes/supersampling", 1, SHD_FORMAT_RGBA32F, edit_supersampling},
    {"bytes/supersampling_rgba8", 2, SHD_FORMAT_RGBA8, edit_supersampling},
    {"bytes/passes_rgba8", 4, SHD_FORMAT_RGBA8, edit_passes},
    {"bytes/crop", 1, SHD_FORMAT_RGBA8, edit_crop},
    {"bytes/alpha", 2, SHD_FORMAT_RGBA32F, edit_clear},
    {"bytes/scissor_load", 4, SHD_FORMAT_RGBA32F, edit_scissor_load},
};

static void check_bytes(struct stage *s, const struct frame_case *c, shd_format format, const char *view)
{
    shd_framebuffer *const planes = make_framebuffer(s->context, c->samples, SHD_FORMAT_RGBA32F);
    shd_framebuffer *const other = make_framebuffer(s->context, c->samples, c->color_format);
    const shd_image want = make_image(format, g_want), got = make_image(format, g_got);
    shd_render_desc desc = s->scene.desc;
    shd_render_stats first = shd_render_stats_default(), second = shd_render_stats_default();
    desc.framebuffer = planes;
    shd_assert_ok(shd_render(s->context, &desc));
    c->edit(&desc);
    desc.stats = &first;
    shd_assert_ok(shd_render(s->context, &desc));
    shd_assert_ok(shd_color_apply_display(s->color, planes, "sRGB", view, &want));
    desc = s->scene.desc;
    desc.framebuffer = other;
    shd_assert_ok(shd_render(s->context, &desc));
    c->edit(&desc);
    desc.stats = &second;
    shd_assert_ok(shd_color_render(s->color, &desc, "sRGB", view, &got));
    if (memcmp(g_want, g_got, BYTES) != 0) fail_msg("%s, format %d, view %s: bytes differ", c->name, (int)format, view);
    assert_true(shd_hash_stats(SHD_HASH_START, &first) == shd_hash_stats(SHD_HASH_START, &second));
    if (c->color_format == SHD_FORMAT_RGBA32F) {
        assert_true(shd_hash_framebuffer(planes) == shd_hash_framebuffer(other));
    }
    shd_framebuffer_release(planes);
    shd_framebuffer_release(other);
}

/* One worker finds no error of memory that four do not find, and instrumented code is slow. */
#if defined(__SANITIZE_ADDRESS__)
enum { FEWEST_WORKERS = 4 };
#else
enum { FEWEST_WORKERS = 1 };
#endif

static void test_bytes(void **state)
{
    static const char *const k_views[] = {"Plain", SHD_ACES_VIEW};
    const struct frame_case *c = (const struct frame_case *)*state;
    uint32_t workers;
    int precision;
    size_t f;
    for (workers = FEWEST_WORKERS; workers <= 4; workers += 3) {
        for (precision = SHD_DISPLAY_PRECISION_BAKED; precision <= SHD_DISPLAY_PRECISION_EXACT; ++precision) {
            struct stage s;
            open_stage(&s, workers, SHD_SIMD_BEST, (shd_display_precision)precision);
            for (f = 0; f < 2 * FORMATS; ++f) check_bytes(&s, c, k_formats[f / 2], k_views[f % 2]);
            close_stage(&s);
        }
    }
}

/* The bytes of every SIMD target. */
static void test_targets(void **state)
{
    static const struct frame_case k_case = {"bytes/targets", 4, SHD_FORMAT_RGBA8, edit_nothing};
    int simd, count = 0;
    uint64_t first = 0;
    (void)state;
    for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = NULL;
        struct stage s;
        uint64_t hash;
        desc.simd = (shd_simd)simd;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        shd_context_release(context);
        open_stage(&s, 2, (shd_simd)simd, SHD_DISPLAY_PRECISION_BAKED);
        check_bytes(&s, &k_case, SHD_FORMAT_RGBA8, SHD_ACES_VIEW);
        hash = shd_hash(SHD_HASH_START, g_got, BYTES);
        if (count++ == 0) first = hash;
        assert_true(hash == first);
        close_stage(&s);
    }
    assert_true(count > 0);
}

/* ---- refusals ---- */

/* The arguments of a call. */
struct arguments {
    const struct stage *stage;
    const shd_color *color;
    const shd_render_desc *render;
    const char *display, *view;
    const shd_image *out;
    shd_render_desc desc; /* target of render */
    shd_image image;      /* target of out */
};

static shd_result take_nothing(const shd_present_tile *tile, void *user_data)
{
    (void)user_data;
    (void)tile;
    return SHD_OK;
}

static const float *plane_of(const struct arguments *a, shd_plane plane)
{
    shd_plane_view view = shd_plane_view_default();
    shd_assert_ok(shd_framebuffer_view_plane(a->stage->framebuffer, plane, &view));
    return view.f32;
}

static void bad_color(struct arguments *a) { a->color = NULL; }
static void bad_color_type(struct arguments *a) { a->color = (const shd_color *)a->stage->framebuffer; }
static void bad_render(struct arguments *a) { a->render = NULL; }
static void bad_render_size(struct arguments *a) { a->desc.struct_size = 8; }
static void bad_render_field(struct arguments *a) { a->desc.supersampling = 17; }
static void bad_draw(struct arguments *a) { a->desc.draws = NULL; }
static void bad_framebuffer(struct arguments *a) { a->desc.framebuffer = NULL; }
static void bad_framebuffer_type(struct arguments *a) { a->desc.framebuffer = (shd_framebuffer *)(uintptr_t)a->color; }
static void bad_present(struct arguments *a) { a->desc.present.tile = take_nothing; }
static void bad_display(struct arguments *a) { a->display = "no screen"; }
static void bad_view(struct arguments *a) { a->view = "no view"; }
static void bad_out(struct arguments *a) { a->out = NULL; }
static void bad_width(struct arguments *a) { a->image.width = WIDTH - 1; }
static void bad_height(struct arguments *a) { a->image.height = HEIGHT + 1; }
static void bad_format(struct arguments *a) { a->image.format = SHD_FORMAT_R8; }
static void bad_stride(struct arguments *a) { a->image.row_stride = 4; }
static void bad_pixels(struct arguments *a) { a->image.pixels = NULL; }
static void on_red(struct arguments *a) { a->image.pixels = (void *)(uintptr_t)plane_of(a, SHD_PLANE_R); }
static void on_alpha(struct arguments *a) { a->image.pixels = (void *)(uintptr_t)(plane_of(a, SHD_PLANE_A) + 1); }
static void on_depth(struct arguments *a)
{
    a->image.pixels = (void *)((uintptr_t)plane_of(a, SHD_PLANE_DEPTH) - a->image.row_stride * HEIGHT + 64);
}

struct refuse_case {
    const char *name;
    void (*edit)(struct arguments *a);
    shd_result expected;
    const char *message;
};
static const struct refuse_case k_refused[] = {
    {"refused/color_null", bad_color, SHD_ERROR_INVALID_ARGUMENT, "color: NULL"},
    {"refused/color_type", bad_color_type, SHD_ERROR_INVALID_ARGUMENT, "color: not a live handle"},
    {"refused/render_null", bad_render, SHD_ERROR_INVALID_ARGUMENT, "render: NULL"},
    {"refused/render_size", bad_render_size, SHD_ERROR_INVALID_ARGUMENT, "render.struct_size: 8 is below"},
    {"refused/render_field", bad_render_field, SHD_ERROR_INVALID_ARGUMENT, "render.supersampling: 17 is not in 1..16"},
    {"refused/render_draws", bad_draw, SHD_ERROR_INVALID_ARGUMENT, "render.draws: NULL"},
    {"refused/framebuffer_null", bad_framebuffer, SHD_ERROR_INVALID_ARGUMENT, "render.framebuffer: NULL"},
    {"refused/framebuffer_type", bad_framebuffer_type, SHD_ERROR_INVALID_ARGUMENT, "render.framebuffer: "},
    {"refused/present", bad_present, SHD_ERROR_INVALID_ARGUMENT, "render.present.tile: set"},
    {"refused/display", bad_display, SHD_ERROR_NOT_FOUND, "display: no 'no screen'; there are 'sRGB'"},
    {"refused/view", bad_view, SHD_ERROR_NOT_FOUND, "view: no 'no view' on display 'sRGB'"},
    {"refused/out_null", bad_out, SHD_ERROR_INVALID_ARGUMENT, "out: NULL"},
    {"refused/width", bad_width, SHD_ERROR_INVALID_ARGUMENT, "out: 129 x 91 is not the input's 130 x 91"},
    {"refused/height", bad_height, SHD_ERROR_INVALID_ARGUMENT, "out: 130 x 92 is not the input's 130 x 91"},
    {"refused/format", bad_format, SHD_ERROR_INVALID_ARGUMENT, "out.format: "},
    {"refused/stride", bad_stride, SHD_ERROR_INVALID_ARGUMENT, "out.row_stride: 4 is below"},
    {"refused/pixels", bad_pixels, SHD_ERROR_INVALID_ARGUMENT, "out.pixels: NULL"},
    {"refused/overlaps_red", on_red, SHD_ERROR_INVALID_ARGUMENT, "out.pixels: overlaps render.framebuffer"},
    {"refused/overlaps_alpha", on_alpha, SHD_ERROR_INVALID_ARGUMENT, "out.pixels: overlaps render.framebuffer"},
    {"refused/overlaps_depth", on_depth, SHD_ERROR_INVALID_ARGUMENT, "out.pixels: overlaps render.framebuffer"},
};

/* Neither the framebuffer nor the image changes, and the call with right arguments works afterwards. */
static void test_refused(void **state)
{
    const struct refuse_case *c = (const struct refuse_case *)*state;
    static unsigned char untouched[BYTES];
    struct arguments a;
    struct stage s;
    uint64_t before;
    open_stage(&s, 1, SHD_SIMD_BEST, SHD_DISPLAY_PRECISION_BAKED);
    before = shd_hash_framebuffer(s.framebuffer);
    a.stage = &s;
    a.color = s.color;
    a.desc = s.scene.desc;
    a.render = &a.desc;
    a.display = a.view = NULL;
    a.image = make_image(SHD_FORMAT_RGBA8, g_got);
    a.out = &a.image;
    memcpy(untouched, g_got, BYTES);
    c->edit(&a);
    shd_assert_result(c->name, shd_color_render(a.color, a.render, a.display, a.view, a.out), c->expected, c->message);
    assert_true(shd_hash_framebuffer(s.framebuffer) == before);
    assert_memory_equal(g_got, untouched, BYTES);
    a.image = make_image(SHD_FORMAT_RGBA8, g_got);
    shd_assert_ok(shd_color_render(s.color, &s.scene.desc, NULL, NULL, &a.image));
    assert_true(shd_hash_framebuffer(s.framebuffer) != before);
    close_stage(&s);
}

/* A framebuffer with interleaved colour is checked for overlaps too, and so is its context. */
static void test_other_framebuffers(void **state)
{
    struct stage s, other;
    shd_framebuffer *framebuffer;
    shd_image image, view = shd_image_default();
    (void)state;
    open_stage(&s, 1, SHD_SIMD_BEST, SHD_DISPLAY_PRECISION_BAKED);
    open_stage(&other, 1, SHD_SIMD_BEST, SHD_DISPLAY_PRECISION_BAKED);
    framebuffer = make_framebuffer(s.context, 1, SHD_FORMAT_RGBA8);
    s.scene.desc.framebuffer = framebuffer;
    shd_assert_ok(shd_framebuffer_view_color(framebuffer, &view));
    image = view;
    shd_assert_result("overlap", shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image),
                      SHD_ERROR_INVALID_ARGUMENT, "out.pixels: overlaps render.framebuffer");
    image = make_image(SHD_FORMAT_RGBA8, g_got);
    shd_assert_result("context", shd_color_render(other.color, &s.scene.desc, NULL, NULL, &image),
                      SHD_ERROR_INVALID_ARGUMENT, "render.framebuffer: of another context than color");
    shd_assert_ok(shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image));
    shd_framebuffer_release(framebuffer);
    close_stage(&other);
    close_stage(&s);
}

/* A desc of older headers, which have no callback, is completed with the defaults. */
static void test_older_desc(void **state)
{
    struct stage s;
    shd_render_desc older;
    shd_image image;
    (void)state;
    open_stage(&s, 1, SHD_SIMD_BEST, SHD_DISPLAY_PRECISION_BAKED);
    image = make_image(SHD_FORMAT_RGBA8, g_want);
    shd_assert_ok(shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image));
    older = s.scene.desc;
    older.struct_size = offsetof(shd_render_desc, present);
    memset(&older.present, 0xee, sizeof older.present);
    image = make_image(SHD_FORMAT_RGBA8, g_got);
    shd_assert_ok(shd_color_render(s.color, &older, NULL, NULL, &image));
    assert_memory_equal(g_got, g_want, BYTES);
    close_stage(&s);
}

static shd_result cancel(float fraction, void *user_data)
{
    (void)user_data;
    return fraction > 0.4f ? SHD_ERROR_CANCELLED : SHD_OK;
}

/* A frame that is cancelled half-way; the next one is whole. */
static void test_cancelled(void **state)
{
    struct stage s;
    shd_image image;
    (void)state;
    open_stage(&s, 4, SHD_SIMD_BEST, SHD_DISPLAY_PRECISION_BAKED);
    image = make_image(SHD_FORMAT_RGBA8, g_want);
    shd_assert_ok(shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image));
    image = make_image(SHD_FORMAT_RGBA8, g_got);
    s.scene.desc.progress.report = cancel;
    shd_assert_result("cancel", shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image), SHD_ERROR_CANCELLED,
                      "render.progress.report returned SHD_ERROR_CANCELLED");
    s.scene.desc.progress.report = NULL;
    shd_assert_ok(shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image));
    assert_memory_equal(g_got, g_want, BYTES);
    close_stage(&s);
}

/* ---- memory ---- */

/* A context on a counting allocator, with a scene and colour. */
static void open_counted(struct stage *s, shd_fault_allocator *memory, uint32_t flags)
{
    shd_context_desc desc;
    memset(s, 0, sizeof *s);
    memset(memory, 0, sizeof *memory);
    desc = shd_fault_context_desc(memory);
    desc.flags = flags;
    shd_assert_ok(shd_context_create(&desc, &s->context));
    shd_scene_open(&s->scene, SHD_SCENE_SMALL, s->context);
    s->framebuffer = make_framebuffer(s->context, 2, SHD_FORMAT_RGBA8);
    s->scene.desc.framebuffer = s->framebuffer;
    s->color = make_color(s->context, SHD_DISPLAY_PRECISION_BAKED);
}

/* Each allocation fails in turn, alone and with all later ones, from the first bake on. */
static void test_faults(void **state)
{
    int persistent;
    (void)state;
    for (persistent = 0; persistent < 2; ++persistent) {
        shd_fault_allocator memory;
        struct stage s;
        shd_image image = make_image(SHD_FORMAT_RGBA8, g_got);
        size_t n, before, in_frame = 0;
        open_counted(&s, &memory, SHD_CONTEXT_RETURN_MEMORY);
        before = memory.live_bytes;
        for (n = 1;; ++n) {
            shd_result result;
            shd_fault_arm(&memory, n, persistent);
            result = shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image);
            shd_fault_arm(&memory, 0, 0);
            if (result == SHD_OK) break;
            shd_assert_result("fault", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
            if (memory.live_bytes != before) { /* the tables that were baked stay */
                assert_int_equal(in_frame, 0);
                before = memory.live_bytes;
                in_frame = n;
            }
        }
        assert_true(in_frame > 2 && n > in_frame + 20);
        close_stage(&s);
        shd_assert_all_freed("faults", &memory);
    }
}

/* Equal frames allocate nothing after the first one. */
static void test_steady(void **state)
{
    shd_fault_allocator memory;
    struct stage s;
    shd_image image = make_image(SHD_FORMAT_RGBA8, g_got);
    int i;
    (void)state;
    open_counted(&s, &memory, SHD_CONTEXT_NONE);
    shd_assert_ok(shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image));
    memory.calls = 0;
    for (i = 0; i < 4; ++i) shd_assert_ok(shd_color_render(s.color, &s.scene.desc, NULL, NULL, &image));
    assert_int_equal(memory.calls, 0);
    close_stage(&s);
    shd_assert_all_freed("steady", &memory);
}

int main(void)
{
    enum { FRAMES = sizeof k_frames / sizeof k_frames[0], REFUSED = sizeof k_refused / sizeof k_refused[0] };
    static struct CMUnitTest tests[FRAMES + REFUSED + 6];
    size_t n = 0, i;
    for (i = 0; i < FRAMES; ++i) {
        tests[n++] = (struct CMUnitTest){k_frames[i].name, test_bytes, NULL, NULL, (void *)(uintptr_t)&k_frames[i]};
    }
    tests[n++] = (struct CMUnitTest){"bytes/targets", test_targets, NULL, NULL, NULL};
    for (i = 0; i < REFUSED; ++i) {
        tests[n++] = (struct CMUnitTest){k_refused[i].name, test_refused, NULL, NULL, (void *)(uintptr_t)&k_refused[i]};
    }
    tests[n++] = (struct CMUnitTest){"refused/other_framebuffers", test_other_framebuffers, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"older_desc", test_older_desc, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"cancelled", test_cancelled, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"memory/faults", test_faults, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"memory/steady", test_steady, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.color_present", tests, n, NULL, NULL);
}
