/* SPDX-License-Identifier: MIT */
/* Windows of a picture have the bits of the whole picture; viewports and scissors. */
#include "support/scene.h"

enum { PLANES = SHD_PLANE_TRIANGLE + 1, WIDTH = 203, HEIGHT = 151 };

/* Every plane of a picture as bits. */
struct picture {
    uint32_t bits[PLANES][HEIGHT][WIDTH];
};
static struct picture g_whole, g_parts;

static void read_into(const shd_framebuffer *framebuffer, uint32_t left, uint32_t top, struct picture *out)
{
    shd_framebuffer_info info = shd_framebuffer_info_default();
    uint32_t y;
    int plane;
    shd_assert_ok(shd_framebuffer_get_info(framebuffer, &info));
    for (plane = 0; plane < PLANES; ++plane) {
        shd_plane_view view = shd_plane_view_default();
        shd_assert_ok(shd_framebuffer_view_plane(framebuffer, (shd_plane)plane, &view));
        for (y = 0; y < info.height; ++y) {
            const char *row = (view.f32 ? (const char *)view.f32 : (const char *)view.u32) + y * view.row_stride;
            memcpy(&out->bits[plane][top + y][left], row, info.width * sizeof(uint32_t));
        }
    }
}

static void make_framebuffer(shd_scene *s, uint32_t width, uint32_t height, uint32_t samples)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer_release(s->framebuffer);
    desc.width = width;
    desc.height = height;
    desc.sample_count = samples;
    desc.aovs = SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE;
    shd_assert_ok(shd_framebuffer_create(s->context, &desc, &s->framebuffer));
    s->desc.framebuffer = s->framebuffer;
}

struct window_case {
    char name[64];
    shd_scene_kind kind;
    uint32_t samples;
    uint32_t width, height; /* size of a window */
    shd_visibility visibility;
    int outlined;
};

/* Lines and points of one pixel and much wider. */
static void outline_scene(shd_scene *s)
{
    size_t i;
    for (i = 0; i < s->desc.draw_count; ++i) {
        s->draw[i].fill = i % 3 == 2 ? SHD_FILL_POINTS : SHD_FILL_WIREFRAME;
        s->draw[i].fill_width = i == 4 ? 40.0f : 0.5f * (float)(i + 1);
    }
}

static void expect_same(const char *what)
{
    uint32_t x, y;
    int plane;
    if (memcmp(&g_parts, &g_whole, sizeof g_whole) == 0) return;
    for (plane = 0; plane < PLANES; ++plane) {
        for (y = 0; y < HEIGHT; ++y) {
            for (x = 0; x < WIDTH; ++x) {
                const uint32_t got = g_parts.bits[plane][y][x], want = g_whole.bits[plane][y][x];
                if (got != want) fail_msg("%s: plane %d at %u, %u: %08x, not %08x", what, plane, x, y, got, want);
            }
        }
    }
}

/* First into cleared planes, then over the previous contents. */
static void render_twice(shd_scene *s)
{
    s->desc.flags &= ~(uint32_t)SHD_RENDER_LOAD;
    shd_assert_ok(shd_render(s->context, &s->desc));
    s->desc.flags |= SHD_RENDER_LOAD;
    shd_assert_ok(shd_render(s->context, &s->desc));
}

/* Adjacent windows, drawn twice: into cleared planes, and over their previous contents. */
static void render_windows(shd_scene *s, const struct window_case *c)
{
    uint32_t x, y;
    s->desc.picture_width = WIDTH;
    s->desc.picture_height = HEIGHT;
    for (y = 0; y < HEIGHT; y += c->height) {
        for (x = 0; x < WIDTH; x += c->width) {
            const uint32_t width = WIDTH - x < c->width ? WIDTH - x : c->width;
            const uint32_t height = HEIGHT - y < c->height ? HEIGHT - y : c->height;
            make_framebuffer(s, width, height, c->samples);
            s->desc.crop_x = x;
            s->desc.crop_y = y;
            render_twice(s);
            read_into(s->framebuffer, x, y, &g_parts);
        }
    }
    s->desc.picture_width = s->desc.picture_height = s->desc.crop_x = s->desc.crop_y = 0;
}

static void render_whole(shd_scene *s, uint32_t samples)
{
    make_framebuffer(s, WIDTH, HEIGHT, samples);
    render_twice(s);
    read_into(s->framebuffer, 0, 0, &g_whole);
}

static void test_windows(void **state)
{
    static const shd_region k_viewport = {21, 13, 160, 111}, k_scissor = {40, 7, 130, 100};
    const struct window_case *c = (const struct window_case *)*state;
    shd_context *context = NULL;
    shd_scene s;
    int i;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, c->kind, context);
    s.desc.visibility = c->visibility;
    if (c->outlined) outline_scene(&s);
    s.desc.clear_color[0] = 0.1f; /* not a sum of eight, rounded */
    for (i = 0; i < 2; ++i) {
        s.desc.viewport = i ? &k_viewport : NULL;
        s.desc.scissor = i ? &k_scissor : NULL;
        memset(&g_parts, 0, sizeof g_parts);
        render_whole(&s, c->samples);
        render_windows(&s, c);
        expect_same(c->name);
    }
    shd_scene_close(&s);
    shd_context_release(context);
}

/* A viewport is a smaller picture in a larger one, equal to a framebuffer of the viewport's size. Its pixels have
 * other coordinates, so shading rounds differently. Coverage and depth of a scene with powers of two are equal. */
static void test_viewport(void **state)
{
    static const float k_x[3] = {-0.75f, 3.0f, -0.75f}, k_y[3] = {-3.0f, 0.75f, 0.75f};
    static const float k_z[3] = {0.25f, 0.25f, 0.25f};
    const shd_region viewport = {64, 32, 64, 64};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_context *context = NULL;
    shd_mesh *mesh = NULL;
    shd_draw draw = shd_draw_default();
    shd_scene s;
    uint32_t x, y;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    desc.vertex_count = 3;
    desc.position[0].data = k_x;
    desc.position[1].data = k_y;
    desc.position[2].data = k_z;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    draw.mesh = mesh;
    s.desc.view = shd_render_desc_default().view;
    s.desc.draws = &draw;
    s.desc.draw_count = 1;
    memset(&g_whole, 0, sizeof g_whole);
    memset(&g_parts, 0, sizeof g_parts);
    make_framebuffer(&s, 64, 64, 1);
    shd_assert_ok(shd_render(context, &s.desc));
    read_into(s.framebuffer, viewport.x, viewport.y, &g_whole);
    make_framebuffer(&s, WIDTH, HEIGHT, 1);
    s.desc.viewport = &viewport;
    shd_assert_ok(shd_render(context, &s.desc));
    read_into(s.framebuffer, 0, 0, &g_parts);
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            const uint32_t one = 0x3f800000u;
            const int inside = x >= 64 && x < 128 && y >= 32 && y < 96;
            const uint32_t want = inside ? g_whole.bits[SHD_PLANE_DEPTH][y][x] : one;
            if (g_parts.bits[SHD_PLANE_DEPTH][y][x] != want) fail_msg("depth at %u, %u", x, y);
        }
    }
    assert_true(g_parts.bits[SHD_PLANE_DEPTH][32 + 8][64 + 8] != 0x3f800000u);
    assert_true(g_parts.bits[SHD_PLANE_DEPTH][32 + 7][64 + 9] == 0x3f800000u);
    shd_mesh_release(mesh);
    shd_scene_close(&s);
    shd_context_release(context);
}

/* Pixels inside the scissor have the bits of the frame without a scissor; the others keep their previous bits. */
static void test_scissor(void **state)
{
    static const shd_region k_scissors[] = {{0, 0, WIDTH, HEIGHT},
                                            {0, 0, 0, 0},
                                            {WIDTH, HEIGHT, 0, 0},
                                            {50, 60, 0, 20},
                                            {50, 60, 20, 0},
                                            {0, 0, 1, 1},
                                            {WIDTH - 1, HEIGHT - 1, 1, 1},
                                            {63, 63, 2, 2},
                                            {64, 64, 64, 64},
                                            {5, 0, 3, HEIGHT},
                                            {0, 77, WIDTH, 1},
                                            {31, 20, 100, 90}};
    const uint32_t samples = *(const uint32_t *)*state;
    static struct picture before;
    shd_context *context = NULL;
    shd_scene s;
    size_t draw_count, i;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_GLASS, context);
    draw_count = s.desc.draw_count;
    make_framebuffer(&s, WIDTH, HEIGHT, samples);
    shd_assert_ok(shd_render(context, &s.desc));
    read_into(s.framebuffer, 0, 0, &g_whole);
    for (i = 0; i < sizeof k_scissors / sizeof k_scissors[0]; ++i) {
        const shd_region *r = &k_scissors[i];
        uint32_t x, y;
        int plane;
        s.desc.draw_count = 4; /* different previous contents */
        s.desc.scissor = NULL;
        s.desc.clear_color[1] = 0.7f;
        s.desc.clear_depth = 0.97f;
        shd_assert_ok(shd_render(context, &s.desc));
        read_into(s.framebuffer, 0, 0, &before);
        s.desc.draw_count = draw_count;
        s.desc.scissor = r;
        s.desc.clear_color[1] = 0.0f;
        s.desc.clear_depth = 1.0f;
        shd_assert_ok(shd_render(context, &s.desc));
        read_into(s.framebuffer, 0, 0, &g_parts);
        for (plane = 0; plane < PLANES; ++plane) {
            for (y = 0; y < HEIGHT; ++y) {
                for (x = 0; x < WIDTH; ++x) {
                    const int inside = x >= r->x && x - r->x < r->width && y >= r->y && y - r->y < r->height;
                    const uint32_t want = (inside ? &g_whole : &before)->bits[plane][y][x];
                    if (g_parts.bits[plane][y][x] != want) {
                        fail_msg("scissor %zu: plane %d at %u, %u", i, plane, x, y);
                    }
                }
            }
        }
    }
    shd_scene_close(&s);
    shd_context_release(context);
}

/* A window at the corner of the largest picture: the last pixels of a quad over the whole picture. */
static void test_far_corner(void **state)
{
    static const float k_x[4] = {-1, 1, 1, -1}, k_y[4] = {-1, -1, 1, 1}, k_z[4] = {0, 0, 0, 0};
    static const uint32_t k_fan[4] = {0, 1, 2, 3};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_context *context = NULL;
    shd_mesh *mesh = NULL;
    shd_draw draw = shd_draw_default();
    shd_plane_view view = shd_plane_view_default();
    shd_scene s;
    uint32_t x, y;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_SMALL, context);
    desc.vertex_count = 4;
    desc.position[0].data = k_x;
    desc.position[1].data = k_y;
    desc.position[2].data = k_z;
    desc.topology = SHD_TOPOLOGY_FAN;
    desc.indices.data = k_fan;
    desc.index_count = 4;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    draw.mesh = mesh;
    s.desc.view = shd_render_desc_default().view;
    s.desc.draws = &draw;
    s.desc.draw_count = 1;
    make_framebuffer(&s, 20, 10, 16);
    s.desc.picture_width = s.desc.picture_height = 65536;
    s.desc.crop_x = 65536 - 20;
    s.desc.crop_y = 65536 - 10;
    shd_assert_ok(shd_render(context, &s.desc));
    shd_assert_ok(shd_framebuffer_view_plane(s.framebuffer, SHD_PLANE_DEPTH, &view));
    for (y = 0; y < 10; ++y) {
        for (x = 0; x < 20; ++x) assert_true(view.f32[y * (view.row_stride / sizeof(float)) + x] == 0.0f);
    }
    assert_int_equal(s.stats.rasterized_triangle_count, 2);
    shd_mesh_release(mesh);
    shd_scene_close(&s);
    shd_context_release(context);
}

static const uint32_t k_samples[] = {1, 2, 4, 8, 16};

int main(void)
{
    static const uint32_t k_sizes[][2] = {{64, 64}, {65, 63}, {50, 151}, {203, 17}, {101, 76}, {33, 40}};
    static struct window_case cases[24];
    static struct CMUnitTest tests[34];
    static char names[5][24];
    size_t n = 0, i, made = 0;
    for (i = 0; i < 24; ++i) {
        struct window_case *c = &cases[made++];
        c->outlined = i >= 19 && i < 22;
        c->kind = i >= 22                            ? SHD_SCENE_LINES
                  : i < 11 || i == 16 || c->outlined ? SHD_SCENE_GLASS
                  : i < 13 || i > 16                 ? SHD_SCENE_MIXED
                  : i < 15                           ? SHD_SCENE_LIT
                                                     : SHD_SCENE_FLOOR;
        c->visibility = (i >= 16 && i < 20) || i == 23 ? SHD_VISIBILITY_PAINTER : SHD_VISIBILITY_DEPTH;
        c->samples = i < 6 ? 4 : i < 11 ? k_samples[i - 6] : i == 20 || i == 22 ? 4 : 1;
        c->width = k_sizes[i % 6][0];
        c->height = k_sizes[i % 6][1];
        snprintf(c->name, sizeof c->name, "windows/scene_%d%s/%ux%u/samples_%u%s", (int)c->kind,
                 c->outlined ? "_outlined" : "", c->width, c->height, c->samples, c->visibility ? "/painter" : "");
        tests[n++] = (struct CMUnitTest){c->name, test_windows, NULL, NULL, c};
    }
    for (i = 0; i < 5; ++i) {
        snprintf(names[i], sizeof names[i], "scissor/samples_%u", k_samples[i]);
        tests[n++] = (struct CMUnitTest){names[i], test_scissor, NULL, NULL, (void *)&k_samples[i]};
    }
    tests[n++] = (struct CMUnitTest){"viewport", test_viewport, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"far_corner", test_far_corner, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_window", tests, n, NULL, NULL);
}
