/* SPDX-License-Identifier: MIT */
/* Shading of known triangles against double: three frequencies, both models, ambient terms; and what a program gets. */
#include "support/frame.h"

typedef struct vec3 {
    double x, y, z;
} vec3;
static vec3 make(const float v[3])
{
    const vec3 r = {(double)v[0], (double)v[1], (double)v[2]};
    return r;
}
static vec3 add(vec3 a, vec3 b)
{
    const vec3 r = {a.x + b.x, a.y + b.y, a.z + b.z};
    return r;
}
static vec3 scale(double s, vec3 a)
{
    const vec3 r = {s * a.x, s * a.y, s * a.z};
    return r;
}
static double dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec3 unit(vec3 a) { return scale(1.0 / sqrt(dot(a, a)), a); }
static vec3 cross(vec3 a, vec3 b)
{
    const vec3 r = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return r;
}

/* A triangle with three different normals, in front of an eye and a light. */
static const float k_vertices[3][8] = {{-0.9f, -0.8f, 0.5f, -0.3f, -0.2f, 0.9f, 0, 0},
                                       {0.9f, -0.7f, 0.4f, 0.4f, 0.0f, 0.8f, 1, 0},
                                       {0.1f, 0.9f, 0.6f, 0.0f, 0.5f, 1.0f, 0, 1}};
static const float k_eye[3] = {0.2f, 0.1f, 2.0f}, k_lamp[3] = {0.5f, 0.3f, 1.2f};
static const float k_intensity[3] = {2.0f, 1.0f, 0.5f};
enum { k_width = 48, k_height = 40 };

/* L of a point in channel c: k_a I_a + k_d E max(0, n.l) + k_s E max(0, n.h)^p. */
static double reflect(const shd_material_desc *m, vec3 p, vec3 n, double ambient, int c)
{
    const vec3 to_light = add(make(k_lamp), scale(-1, p)), v = unit(add(make(k_eye), scale(-1, p)));
    const double squared = dot(to_light, to_light), e = (double)k_intensity[c] / squared;
    const vec3 l = unit(to_light), h = unit(add(v, l));
    double sum = (double)m->ambient[c] * ambient + (double)m->diffuse[c] * e * fmax(0, dot(n, l));
    const int gated = !(m->flags & SHD_SPECULAR_UNGATED) && dot(n, l) <= 0;
    if (m->model == SHD_MODEL_BLINN_PHONG && !gated) {
        sum += (double)m->specular[c] * e * pow(fmax(0, dot(n, h)), (double)m->exponent);
    }
    return sum;
}

/* Barycentric coordinates of the centre of pixel (x, y); positions are device coordinates. */
static void weights(uint32_t x, uint32_t y, double out[3])
{
    const double px = 2 * (x + 0.5) / k_width - 1, py = 1 - 2 * (y + 0.5) / k_height;
    double e[3], sum = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        const float *a = k_vertices[(k + 1) % 3], *b = k_vertices[(k + 2) % 3];
        e[k] =
            ((double)b[0] - (double)a[0]) * (py - (double)a[1]) - ((double)b[1] - (double)a[1]) * (px - (double)a[0]);
        sum += e[k];
    }
    for (k = 0; k < 3; ++k) out[k] = e[k] / sum;
}

static vec3 position(const double b[3])
{
    vec3 sum = {0, 0, 0};
    int k;
    for (k = 0; k < 3; ++k) sum = add(sum, scale(b[k], make(k_vertices[k])));
    return sum;
}
static vec3 normal(const double b[3])
{
    vec3 sum = {0, 0, 0};
    int k;
    for (k = 0; k < 3; ++k) sum = add(sum, scale(b[k], unit(make(k_vertices[k] + 3))));
    return unit(sum);
}

static double expected(const shd_material_desc *m, shd_frequency frequency, double ambient, const double b[3], int c)
{
    static const double k_third[3] = {1.0 / 3, 1.0 / 3, 1.0 / 3};
    double sum = 0;
    int k;
    if (frequency == SHD_FREQUENCY_PHONG) return reflect(m, position(b), normal(b), ambient, c);
    if (frequency == SHD_FREQUENCY_FLAT) {
        const vec3 p0 = make(k_vertices[0]), p1 = make(k_vertices[1]), p2 = make(k_vertices[2]);
        const vec3 n = unit(cross(add(p1, scale(-1, p0)), add(p2, scale(-1, p0))));
        return reflect(m, position(k_third), n, ambient, c);
    }
    for (k = 0; k < 3; ++k) {
        sum += b[k] * reflect(m, make(k_vertices[k]), unit(make(k_vertices[k] + 3)), ambient, c);
    }
    return sum;
}

struct shade_case {
    const char *name;
    shd_model model;
    shd_frequency frequency;
    uint32_t flags;
    float exponent;
    int ambient_lights;
};
#define CASES_OF(name, frequency)                                                     \
    {name "/lambert", SHD_MODEL_LAMBERT, frequency, 0, 1, 1},                         \
        {name "/lambert_no_ambient", SHD_MODEL_LAMBERT, frequency, 0, 1, 0},          \
        {name "/blinn_phong", SHD_MODEL_BLINN_PHONG, frequency, 0, 8, 1},             \
        {name "/blinn_phong_sharp", SHD_MODEL_BLINN_PHONG, frequency, 0, 200, 1},     \
        {name "/blinn_phong_exponent_0", SHD_MODEL_BLINN_PHONG, frequency, 0, 0, 1},  \
        {name "/two_ambient_lights", SHD_MODEL_BLINN_PHONG, frequency, 0, 8, 2},      \
    {                                                                                 \
        name "/ungated", SHD_MODEL_BLINN_PHONG, frequency, SHD_SPECULAR_UNGATED, 8, 1 \
    }
static const struct shade_case k_shades[] = {CASES_OF("phong", SHD_FREQUENCY_PHONG),
                                             CASES_OF("gouraud", SHD_FREQUENCY_GOURAUD),
                                             CASES_OF("flat", SHD_FREQUENCY_FLAT)};

static shd_material_desc material_of(const struct shade_case *c)
{
    shd_material_desc m = shd_material_desc_default();
    m.model = c->model;
    m.flags = c->flags;
    m.exponent = c->exponent;
    m.ambient[1] = 0.2f;
    m.diffuse[2] = 0.4f;
    m.specular[0] = 0.9f;
    return m;
}

static void add_lamp(shd_frame *f)
{
    shd_light_desc lamp = shd_light_desc_default();
    memcpy(lamp.position, k_lamp, sizeof lamp.position);
    memcpy(lamp.intensity, k_intensity, sizeof lamp.intensity);
    shd_frame_light(f, &lamp);
}

static void test_shade(void **state)
{
    const struct shade_case *c = (const struct shade_case *)*state;
    const shd_material_desc m = material_of(c);
    shd_frame f;
    uint32_t x, y, seen = 0;
    int i;
    shd_frame_open(&f, k_width, k_height);
    shd_frame_draw(&f, k_vertices[0], 3, &m)->frequency = c->frequency;
    add_lamp(&f);
    for (i = 0; i < c->ambient_lights; ++i) shd_frame_ambient(&f);
    memcpy(f.desc.view.eye, k_eye, sizeof k_eye);
    shd_frame_render(&f);
    for (y = 0; y < k_height; ++y) {
        for (x = 0; x < k_width; ++x) {
            const size_t at = (size_t)y * k_width + x;
            double b[3];
            if (f.triangle[at] == 0xffffffffu) continue;
            ++seen;
            weights(x, y, b);
            for (i = 0; i < 3; ++i) {
                const double want = expected(&m, c->frequency, c->ambient_lights, b, i);
                shd_assert_close(c->name, 4 * at + (size_t)i, (double)f.plane[i][at], want, 2e-5, 4e-4);
            }
        }
    }
    assert_true(seen > 500);
    shd_frame_close(&f);
}

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
            m.flags = per_light ? SHD_AMBIENT_PER_LIGHT : 0;
            shd_frame_open(&f, 9, 9);
            shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
            shd_frame_draw(&f, quad, 6, &m);
            shd_frame_ambient(&f);
            away.kind = SHD_LIGHT_DIRECTIONAL;
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

/* What a program saw, by pixel. */
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
    /* One worker, so that the record needs no lock: the objects may come from another context. */
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
    assert_true(record.calls < 10); /* hundreds at a time */
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
    assert_int_equal(f.stats.nonfinite_fragments, 3);
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

/* At Gouraud and flat frequency a program sees corners and centroids, with no place on the screen. */
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
    static struct CMUnitTest tests[sizeof k_shades / sizeof k_shades[0] + 4];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_shades / sizeof k_shades[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_shades[i].name, test_shade, NULL, NULL, (void *)&k_shades[i]};
    }
    tests[n++] = (struct CMUnitTest){"ambient_per_light", test_ambient_per_light, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"program/columns", test_program_columns, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"program/nonfinite", test_program_nonfinite, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"program/rows", test_program_rows, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_shade", tests, n, NULL, NULL);
}
