/* SPDX-License-Identifier: MIT */
/* The ambient term added once or for each light, and the input of a program at each frequency. */
#include "support/frame.h"

static const float k_eye[3] = {0.2f, 0.1f, 2.0f};
enum { k_width = 48, k_height = 40 };

/* The ambient term once, or once for each point or directional light. */
static void test_ambient_per_light(void **state)
{
    int lamps, per_light;
    (void)state;
    for (per_light = 0; per_light < 2; ++per_light) {
        for (lamps = 0; lamps < 3; ++lamps) {
            shd_material_desc m = shd_frame_plain(0.25f, 0.5f, 1.0f);
            shd_light_desc away = shd_light_desc_default();
            const double times = per_light ? lamps : 1;
            float quad[48];
            shd_frame f;
            int i;
            m.flags = per_light ? SHD_MATERIAL_AMBIENT_PER_LIGHT : 0;
            shd_frame_open(&f, 9, 9);
            shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
            shd_frame_draw(&f, quad, 6, &m);
            shd_frame_ambient(&f);
            away.kind = SHD_LIGHT_KIND_DIRECTIONAL;
            away.direction[1] = 0.0f;
            away.direction[2] = 1.0f; /* from behind: no diffuse light */
            for (i = 0; i < lamps; ++i) shd_frame_light(&f, &away);
            shd_frame_render(&f);
            shd_assert_close("r", 0, (double)f.plane[SHD_PLANE_R][40], 0.25 * times, 1e-6, 0.0);
            shd_assert_close("b", 0, (double)f.plane[SHD_PLANE_B][40], 1.0 * times, 1e-6, 0.0);
            shd_frame_close(&f);
        }
    }
}

/* Input that a program got, by pixel. */
struct record {
    uint32_t calls, rows, mistakes, draw;
    float x[k_width * k_height], u[k_width * k_height], px[k_width * k_height], dudx[k_width * k_height],
        dvdy[k_width * k_height], depth[k_width * k_height];
    int nan_at; /* row of the first call that gets NaN, or -1 */
};

static void watch(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    struct record *r = (struct record *)user_data;
    size_t i;
    ++r->calls;
    r->rows += (uint32_t)in->count;
    r->mistakes += in->struct_size != sizeof *in || out->struct_size != sizeof *out || in->count == 0;
    r->draw = in->draw;
    for (i = 0; i < in->count; ++i) {
        const double o2 = (double)(in->ox[i] * in->ox[i] + in->oy[i] * in->oy[i] + in->oz[i] * in->oz[i]);
        const double n2 = (double)(in->nx[i] * in->nx[i] + in->ny[i] * in->ny[i] + in->nz[i] * in->nz[i]);
        const int x = (int)in->x[i], y = (int)in->y[i];
        r->mistakes += !shd_is_close(o2, 1, 1e-5, 0) || !shd_is_close(n2, 1, 1e-5, 0);
        r->mistakes += out->r[i] != 0 || out->g[i] != 0 || out->b[i] != 0 || out->a[i] != 1;
        if (x < 0 || x >= k_width || y < 0 || y >= k_height) {
            ++r->mistakes;
            continue;
        }
        r->x[y * k_width + x] = in->x[i];
        r->u[y * k_width + x] = in->u[i];
        r->px[y * k_width + x] = in->px[i];
        r->dudx[y * k_width + x] = in->dudx[i];
        r->dvdy[y * k_width + x] = in->dvdy[i];
        r->depth[y * k_width + x] = in->depth[i];
        out->r[i] = in->x[i];
        out->g[i] = in->y[i];
        out->b[i] = in->depth[i];
        out->a[i] = 0.5f;
    }
    if (r->nan_at >= 0 && r->calls == 1) {
        out->r[r->nan_at] = (float)NAN;
        out->g[r->nan_at + 1] = (float)INFINITY;
        out->a[r->nan_at + 2] = -(float)INFINITY;
    }
}

static void open_program(shd_frame *f, struct record *record, shd_frequency frequency)
{
    shd_context_desc one = shd_context_desc_default();
    shd_material_desc m = shd_material_desc_default();
    float quad[48];
    memset(record, 0, sizeof *record);
    record->nan_at = -1;
    m.model = SHD_MODEL_PROGRAM;
    m.program.fragment = watch;
    m.program.user_data = record;
    shd_frame_open(f, k_width, k_height);
    shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.75f, quad);
    shd_frame_draw(f, quad, 6, &m)->frequency = frequency;
    memcpy(f->desc.view.eye, k_eye, sizeof k_eye);
    /* One worker, so that the record needs no lock. The objects may come from another context. */
    shd_context_release(f->context);
    one.worker_count = 1;
    shd_assert_ok(shd_context_create(&one, &f->context));
}

static void test_program_columns(void **state)
{
    static struct record record;
    shd_frame f;
    uint32_t x, y;
    (void)state;
    open_program(&f, &record, SHD_FREQUENCY_PHONG);
    shd_frame_render(&f);
    assert_int_equal(record.mistakes, 0);
    assert_int_equal(record.rows, k_width * k_height);
    assert_int_equal(record.draw, 0);
    assert_true(record.calls < 10); /* hundreds of rows in a call */
    for (y = 0; y < k_height; ++y) {
        for (x = 0; x < k_width; ++x) {
            const size_t at = (size_t)y * k_width + x;
            const double u = (x + 0.5) / k_width;
            shd_assert_close("x", at, (double)record.x[at], x + 0.5, 0, 0);
            shd_assert_close("u", at, (double)record.u[at], u, 1e-6, 0);
            shd_assert_close("px", at, (double)record.px[at], 2 * u - 1, 1e-6, 0);
            shd_assert_close("dudx", at, (double)record.dudx[at], 1.0 / k_width, 1e-7, 1e-5);
            shd_assert_close("dvdy", at, (double)record.dvdy[at], 1.0 / k_height, 1e-7, 1e-5);
            shd_assert_close("r", at, (double)f.plane[SHD_PLANE_R][at], x + 0.5, 0, 0);
            shd_assert_close("g", at, (double)f.plane[SHD_PLANE_G][at], y + 0.5, 0, 0);
            shd_assert_close("b", at, (double)f.plane[SHD_PLANE_B][at], 0.25 + 0.5 * u, 1e-6, 0);
            shd_assert_close("b = depth", at, (double)f.plane[SHD_PLANE_B][at], (double)f.plane[SHD_PLANE_DEPTH][at], 0,
                             0);
            shd_assert_close("a", at, (double)f.plane[SHD_PLANE_A][at], 0.5, 0, 0);
        }
    }
    shd_frame_close(&f);
}

static void test_program_nonfinite(void **state)
{
    static struct record record;
    shd_frame f;
    size_t i, nan = 0, inf = 0, minus = 0;
    (void)state;
    open_program(&f, &record, SHD_FREQUENCY_PHONG);
    record.nan_at = 7;
    shd_frame_render(&f);
    assert_int_equal(f.stats.nonfinite_fragment_count, 3);
    for (i = 0; i < k_width * k_height; ++i) {
        nan += (size_t)isnan(f.plane[SHD_PLANE_R][i]);
        inf += f.plane[SHD_PLANE_G][i] == (float)INFINITY;
        minus += f.plane[SHD_PLANE_A][i] == -(float)INFINITY;
    }
    assert_int_equal(nan, 1);
    assert_int_equal(inf, 1);
    assert_int_equal(minus, 1);
    shd_frame_close(&f);
}

/* At Gouraud and flat frequency a program gets corners and centroids, without a position on the screen. */
static void test_program_rows(void **state)
{
    static struct record record;
    shd_frame f;
    size_t i;
    (void)state;
    open_program(&f, &record, SHD_FREQUENCY_FLAT);
    shd_frame_render(&f);
    assert_int_equal(record.mistakes, 0);
    assert_true(record.rows >= 2 && record.rows <= 2 * record.calls);
    assert_true(record.x[0] == 0.0f && record.dudx[0] == 0.0f && record.depth[0] == 0.0f);
    for (i = 0; i < k_width * k_height; ++i) {
        shd_assert_close("r", i, (double)f.plane[SHD_PLANE_R][i], 0, 0, 0);
        shd_assert_close("a", i, (double)f.plane[SHD_PLANE_A][i], 0.5, 0, 0);
    }
    shd_frame_close(&f);
    open_program(&f, &record, SHD_FREQUENCY_GOURAUD);
    shd_frame_render(&f);
    assert_int_equal(record.mistakes, 0);
    assert_true(record.rows >= 6 && record.rows <= 6 * record.calls);
    shd_frame_close(&f);
}

int main(void)
{
    static struct CMUnitTest tests[4];
    size_t n = 0;
    tests[n++] = (struct CMUnitTest){"ambient_per_light", test_ambient_per_light, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"program/columns", test_program_columns, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"program/nonfinite", test_program_nonfinite, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"program/rows", test_program_rows, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_shade", tests, n, NULL, NULL);
}
