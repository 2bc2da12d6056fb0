/* SPDX-License-Identifier: MIT */
/* Rounding and precision as the headers state them: raster positions, depth, viewports, addresses of texels, borders,
   read-outs, and the default magnification of each filter. */
#include "support/frame.h"
#include "support/noise.h"

static uint32_t g_random = 1;
static double unit(void)
{
    shd_noise(&g_random);
    return (double)(g_random >> 8) / 16777216.0;
}

/* ---- raster positions: ties ---- */

struct tie_case {
    const char *name;
    float edge;  /* x of the edge of a rectangle [pixels]; the sample lies at 0.5 */
    int is_left; /* the rectangle goes from there to the right, else to the left */
    int clipped; /* both ends of the edge are made by clipping */
    int covered;
};
static const struct tie_case k_ties[] = {
    {"ties/left_at_128.5_to_128", 128.5f / 256, 1, 0, 1},
    {"ties/left_at_127.5_to_128", 127.5f / 256, 1, 0, 1},
    {"ties/left_at_129.5_to_130", 129.5f / 256, 1, 0, 0},
    {"ties/left_above_128.5_to_129", 128.53125f / 256, 1, 0, 0},
    {"ties/right_at_128.5_to_128", 128.5f / 256, 0, 0, 0},
    {"ties/right_at_129.5_to_130", 129.5f / 256, 0, 0, 1},
    {"ties/right_above_128.5_to_129", 128.53125f / 256, 0, 0, 1},
    {"ties/clipped_left_at_128.5_to_129", 128.5f / 256, 1, 1, 0},
    {"ties/clipped_left_at_127.5_to_128", 127.5f / 256, 1, 1, 1},
    {"ties/clipped_right_at_128.5_to_129", 128.5f / 256, 0, 1, 1},
    {"ties/clipped_right_at_127.5_to_128", 127.5f / 256, 0, 1, 0},
};

static void test_tie(void **state)
{
    const struct tie_case *c = (const struct tie_case *)*state;
    const float edge = c->edge - 1.0f, other = c->is_left ? 1.0f : -1.0f; /* the picture is two pixels wide */
    const float left = c->is_left ? edge : other, right = c->is_left ? other : edge;
    const float low = c->clipped ? -0.5f : 0.25f, high = c->clipped ? 1.5f : 0.75f;
    const shd_material_desc m = shd_frame_plain(1, 1, 1);
    float quad[48];
    shd_frame f;
    size_t i;
    shd_frame_open(&f, 2, 2);
    shd_frame_quad(left, -2.0f, right, 2.0f, 0, 0, quad);
    for (i = 0; i < 6; ++i) quad[8 * i + 2] = quad[8 * i + 1] < 0 ? low : high;
    shd_frame_draw(&f, quad, 6, &m);
    shd_frame_render(&f);
    assert_int_equal(f.stats.clipped_triangle_count > 0, c->clipped);
    for (i = 0; i < 4; i += 2) assert_int_equal(f.triangle[i] != 0xffffffffu, c->covered);
    shd_frame_close(&f);
}

/* ---- depth ---- */

enum { DEPTH_SIZE = 64 };

/* Triangles on the grid, so that rounding moves no vertex; those of odd numbers reach far beyond the picture. */
static void test_depth(void **state)
{
    const shd_material_desc m = shd_frame_plain(1, 1, 1);
    int number, tested = 0;
    (void)state;
    for (number = 0; number < 40; ++number) {
        const double reach = number % 2 ? 2000 : DEPTH_SIZE;
        double x[3], y[3], z[3], area, dzdx, dzdy;
        float vertices[3][8] = {{0}};
        shd_frame f;
        int i;
        for (i = 0; i < 3; ++i) {
            x[i] = floor(256 * (32 + reach * (unit() - 0.5))) / 256,
            y[i] = floor(256 * (32 + reach * (unit() - 0.5))) / 256;
            vertices[i][0] = (float)(x[i] / 32 - 1), vertices[i][1] = (float)(1 - y[i] / 32);
            vertices[i][2] = (float)unit(), vertices[i][5] = 1;
            z[i] = (double)vertices[i][2];
        }
        area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (fabs(area) < 1) continue;
        dzdx = ((z[1] - z[0]) * (y[2] - y[0]) - (z[2] - z[0]) * (y[1] - y[0])) / area;
        dzdy = ((z[2] - z[0]) * (x[1] - x[0]) - (z[1] - z[0]) * (x[2] - x[0])) / area;
        shd_frame_open(&f, DEPTH_SIZE, DEPTH_SIZE);
        shd_frame_draw(&f, vertices[0], 3, &m);
        shd_frame_render(&f);
        for (i = 0; i < DEPTH_SIZE * DEPTH_SIZE; ++i) {
            const double dx = i % DEPTH_SIZE + 0.5 - x[0], dy = (double)(i / DEPTH_SIZE) + 0.5 - y[0];
            const double bound = z[0] + fabs(dzdx) * (fabs(dx) + 1) + fabs(dzdy) * (fabs(dy) + 1);
            if (f.triangle[i] == 0xffffffffu) continue;
            shd_assert_close("depth", (size_t)i, (double)f.plane[SHD_PLANE_DEPTH][i], z[0] + dzdx * dx + dzdy * dy,
                             ldexp(bound, -22), 0);
            ++tested;
        }
        shd_frame_close(&f);
    }
    assert_true(tested > 5000);
}

/* ---- viewports ---- */

static const shd_fill k_fills[] = {SHD_FILL_SOLID, SHD_FILL_WIREFRAME, SHD_FILL_POINTS};

/* The corners lie on the edge of the viewport, so that wide lines and points would reach over it. */
static void test_viewport(void **state)
{
    static const shd_region k_viewport = {8, 8, 16, 16};
    const shd_material_desc m = shd_frame_plain(1, 1, 1);
    float quad[48];
    shd_frame f;
    size_t i, inside = 0;
    shd_frame_open(&f, 32, 32);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &m);
    f.draw[0].fill = *(const shd_fill *)*state;
    f.draw[0].fill_width = 6;
    f.desc.viewport = &k_viewport;
    shd_frame_render(&f);
    for (i = 0; i < 32 * 32; ++i) {
        const int is_inside = i % 32 >= 8 && i % 32 < 24 && i / 32 >= 8 && i / 32 < 24;
        if (f.triangle[i] == 0xffffffffu) continue;
        if (!is_inside) fail_msg("pixel %zu is outside the viewport", i);
        ++inside;
    }
    assert_true(inside >= 4 * 9);
    shd_frame_close(&f);
}

/* ---- addresses ---- */

struct objects {
    shd_context *context;
    shd_texture *texture;
    shd_sampler *sampler;
};

static void open_objects(struct objects *o, const shd_texture_desc *texture, const shd_sampler_desc *sampler)
{
    shd_assert_ok(shd_context_create(NULL, &o->context));
    shd_assert_ok(shd_texture_create(o->context, texture, &o->texture));
    shd_assert_ok(shd_sampler_create(o->context, sampler, &o->sampler));
}

static void close_objects(struct objects *o)
{
    shd_sampler_release(o->sampler);
    shd_texture_release(o->texture);
    shd_context_release(o->context);
}

static void look_up(const struct objects *o, const float *u, size_t count, float *r, float *g, float *b, float *a)
{
    float v[4096];
    shd_lookups where = shd_lookups_default();
    shd_texels out = shd_texels_default();
    size_t i;
    assert_true(count <= 4096);
    for (i = 0; i < count; ++i) v[i] = 0.5f;
    where.count = count;
    where.u = shd_f32_column(u, 0), where.v = shd_f32_column(v, 0);
    out.channel[0] = shd_f32_out_column(r, 0), out.channel[1] = shd_f32_out_column(g, 0);
    out.channel[2] = shd_f32_out_column(b, 0), out.channel[3] = shd_f32_out_column(a, 0);
    shd_assert_ok(shd_texture_sample(o->texture, o->sampler, &where, &out));
}

enum { RAMP = 4096 };
struct wrap_case {
    const char *name;
    shd_wrap wrap;
    double low, high; /* range of u */
};
static const struct wrap_case k_wraps[] = {
    {"address/repeat", SHD_WRAP_REPEAT, -1, 2},
    {"address/repeat_far", SHD_WRAP_REPEAT, -3000, 3000},
    {"address/repeat_small", SHD_WRAP_REPEAT, -0.01, 0.01},
    {"address/mirror", SHD_WRAP_MIRROR, -2, 3},
    {"address/mirror_far", SHD_WRAP_MIRROR, -3000, 3000},
    {"address/clamp", SHD_WRAP_CLAMP, 0, 1},
    {"address/mirror_once", SHD_WRAP_MIRROR_ONCE, -1, 1},
    {"address/border", SHD_WRAP_BORDER, 0, 1},
};

/* A ramp whose values are the numbers of its texels gives back the point of the lookup. */
static void test_address(void **state)
{
    const struct wrap_case *c = (const struct wrap_case *)*state;
    static float ramp[RAMP], u[4096], value[4096];
    shd_texture_desc td = shd_texture_desc_default();
    shd_sampler_desc sd = shd_sampler_desc_default();
    struct objects o;
    size_t i, tested = 0;
    for (i = 0; i < RAMP; ++i) ramp[i] = (float)i;
    for (i = 0; i < 4096; ++i) u[i] = (float)(c->low + (c->high - c->low) * unit());
    td.format = SHD_FORMAT_R32F, td.width = RAMP, td.height = 1, td.texels = ramp;
    sd.filter = SHD_FILTER_BILINEAR, sd.wrap_u = c->wrap;
    open_objects(&o, &td, &sd);
    look_up(&o, u, 4096, value, NULL, NULL, NULL);
    for (i = 0; i < 4096; ++i) {
        double at = (double)u[i];
        if (c->wrap == SHD_WRAP_REPEAT) at -= floor(at);
        if (c->wrap == SHD_WRAP_MIRROR) at = fabs(at - 2 * floor(0.5 * at + 0.5));
        if (c->wrap == SHD_WRAP_MIRROR_ONCE) at = fabs(at);
        at = at * RAMP - 0.5;
        if (at < 0 || at > RAMP - 1) continue; /* between the ends of the ramp */
        /* 4e-7 n texels, and the rounding of a value of up to n */
        shd_assert_close(c->name, i, (double)value[i], at, (4e-7 + 1.2e-7) * RAMP, 0);
        ++tested;
    }
    assert_true(tested > 1000);
    close_objects(&o);
}

/* ---- borders and read-outs ---- */

static void test_border(void **state)
{
    static const uint8_t k_texels[2] = {51, 102};
    const float u[2] = {0.5f, 9.0f};
    float r[2], g[2], b[2], a[2];
    shd_texture_desc td = shd_texture_desc_default();
    shd_sampler_desc sd = shd_sampler_desc_default();
    struct objects o;
    int i;
    (void)state;
    td.format = SHD_FORMAT_RG8, td.width = td.height = 1, td.texels = k_texels;
    td.swizzle[0] = SHD_CHANNEL_G, td.swizzle[1] = SHD_CHANNEL_R, td.swizzle[2] = SHD_CHANNEL_FILL;
    td.fill[2] = 0.75f, td.fill[3] = 0.5f;
    sd.filter = SHD_FILTER_NEAREST, sd.wrap_u = SHD_WRAP_BORDER;
    for (i = 0; i < 4; ++i) sd.border[i] = (float)(i + 1);
    open_objects(&o, &td, &sd);
    look_up(&o, u, 2, r, g, b, a);
    shd_assert_close("inside r", 0, (double)r[0], 0.4, 1e-7, 0);
    shd_assert_close("inside g", 0, (double)g[0], 0.2, 1e-7, 0);
    assert_true(r[1] == 2 && g[1] == 1); /* the stored channels of the border, swizzled */
    for (i = 0; i < 2; ++i) assert_true(b[i] == 0.75f && a[i] == 0.5f);
    close_objects(&o);
}

static void test_read_level(void **state)
{
    static const uint8_t k_texels[4][3] = {{10, 20, 30}, {10, 20, 30}, {10, 20, 30}, {10, 20, 30}};
    uint32_t level;
    shd_texture_desc td = shd_texture_desc_default();
    shd_texture_info info = shd_texture_info_default();
    struct objects o;
    const float u = 0.5f;
    float a = 0;
    (void)state;
    td.format = SHD_FORMAT_RGB8, td.width = td.height = 2, td.texels = k_texels, td.tables = SHD_TABLE_MIPMAP;
    td.swizzle[0] = SHD_CHANNEL_B, td.swizzle[1] = SHD_CHANNEL_FILL;
    open_objects(&o, &td, NULL);
    shd_assert_ok(shd_texture_get_info(o.texture, &info));
    assert_int_equal(info.format, SHD_FORMAT_RGBA8);
    for (level = 0; level < 2; ++level) {
        uint8_t pixels[16];
        shd_image image = shd_image_default();
        size_t i;
        memset(pixels, 0xcc, sizeof pixels);
        image.format = info.format, image.width = image.height = 2u >> level, image.pixels = pixels;
        shd_assert_ok(shd_texture_read_level(o.texture, 0, level, &image));
        for (i = 0; i < (level ? 1 : 4); ++i) {
            assert_true(pixels[4 * i] == 10 && pixels[4 * i + 1] == 20 && pixels[4 * i + 2] == 30);
            assert_int_equal(pixels[4 * i + 3], 0);
        }
    }
    look_up(&o, &u, 1, NULL, NULL, NULL, &a);
    assert_true(a == 1.0f);
    close_objects(&o);
}

/* ---- magnification ---- */

struct magnification_case {
    const char *name;
    shd_filter filter;
    shd_magnification own;
};
static const struct magnification_case k_magnifications[] = {
    {"magnification/nearest", SHD_FILTER_NEAREST, SHD_MAGNIFICATION_NEAREST},
    {"magnification/nearest_mip", SHD_FILTER_NEAREST_MIP, SHD_MAGNIFICATION_NEAREST},
    {"magnification/bicubic", SHD_FILTER_BICUBIC, SHD_MAGNIFICATION_BICUBIC},
    {"magnification/hermite", SHD_FILTER_HERMITE, SHD_MAGNIFICATION_HERMITE},
    {"magnification/bilinear", SHD_FILTER_BILINEAR, SHD_MAGNIFICATION_BILINEAR},
    {"magnification/bilinear_mip", SHD_FILTER_BILINEAR_MIP, SHD_MAGNIFICATION_BILINEAR},
    {"magnification/trilinear", SHD_FILTER_TRILINEAR, SHD_MAGNIFICATION_BILINEAR},
    {"magnification/ripmap", SHD_FILTER_RIPMAP, SHD_MAGNIFICATION_BILINEAR},
    {"magnification/summed_area", SHD_FILTER_SUMMED_AREA, SHD_MAGNIFICATION_BILINEAR},
    {"magnification/anisotropic", SHD_FILTER_ANISOTROPIC, SHD_MAGNIFICATION_BILINEAR},
    {"magnification/ewa", SHD_FILTER_EWA, SHD_MAGNIFICATION_BILINEAR},
    {"magnification/exact", SHD_FILTER_EXACT, SHD_MAGNIFICATION_BILINEAR},
};

static void test_magnification(void **state)
{
    const struct magnification_case *c = (const struct magnification_case *)*state;
    static const float k_texels[4] = {0.25f, 1.0f, 0.125f, 0.75f};
    static float u[512], value[2][512];
    shd_texture_desc td = shd_texture_desc_default();
    size_t i;
    int own;
    for (i = 0; i < 512; ++i) u[i] = (float)unit();
    td.format = SHD_FORMAT_R32F, td.width = 4, td.height = 1, td.texels = k_texels;
    td.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
    for (own = 0; own < 2; ++own) {
        shd_sampler_desc sd = shd_sampler_desc_default();
        struct objects o;
        sd.filter = c->filter;
        if (own) sd.magnification = c->own;
        open_objects(&o, &td, &sd);
        look_up(&o, u, 512, value[own], NULL, NULL, NULL);
        close_objects(&o);
    }
    for (i = 0; i < 512; ++i) shd_assert_close(c->name, i, (double)value[0][i], (double)value[1][i], 5e-6, 0);
}

int main(void)
{
    enum { TIES = sizeof k_ties / sizeof k_ties[0], WRAPS = sizeof k_wraps / sizeof k_wraps[0] };
    enum { MAGNIFICATIONS = sizeof k_magnifications / sizeof k_magnifications[0] };
    static const char *const k_names[] = {"viewport/solid", "viewport/wireframe", "viewport/points"};
    static struct CMUnitTest tests[TIES + WRAPS + MAGNIFICATIONS + 6];
    size_t n = 0, i;
    for (i = 0; i < TIES; ++i)
        tests[n++] = (struct CMUnitTest){k_ties[i].name, test_tie, NULL, NULL, (void *)&k_ties[i]};
    tests[n++] = (struct CMUnitTest){"depth", test_depth, NULL, NULL, NULL};
    for (i = 0; i < 3; ++i) {
        tests[n++] = (struct CMUnitTest){k_names[i], test_viewport, NULL, NULL, (void *)&k_fills[i]};
    }
    for (i = 0; i < WRAPS; ++i) {
        tests[n++] = (struct CMUnitTest){k_wraps[i].name, test_address, NULL, NULL, (void *)&k_wraps[i]};
    }
    tests[n++] = (struct CMUnitTest){"border", test_border, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"read_level", test_read_level, NULL, NULL, NULL};
    for (i = 0; i < MAGNIFICATIONS; ++i) {
        tests[n++] =
            (struct CMUnitTest){k_magnifications[i].name, test_magnification, NULL, NULL, (void *)&k_magnifications[i]};
    }
    return _cmocka_run_group_tests("api.precision", tests, n, NULL, NULL);
}
