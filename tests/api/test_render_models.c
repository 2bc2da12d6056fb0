/* SPDX-License-Identifier: MIT */
/* Every model at every frequency: a triangle under a lamp against the formulas in double. */
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
static const double k_pi = 3.14159265358979323846;
enum { k_width = 48, k_height = 40 };

/* The directions at a point. */
struct directions {
    vec3 n;
    double e, n_l, n_h, v_r, n_v, v_h;
};

static struct directions directions(vec3 p, vec3 n, int c)
{
    const vec3 to_light = add(make(k_lamp), scale(-1, p)), v = unit(add(make(k_eye), scale(-1, p)));
    const vec3 l = unit(to_light), h = unit(add(v, l));
    struct directions d;
    d.n = n;
    d.e = (double)k_intensity[c] / dot(to_light, to_light);
    d.n_l = dot(n, l);
    d.n_h = fmax(0, dot(n, h));
    d.v_r = fmax(0, 2 * d.n_l * dot(n, v) - dot(v, l));
    d.n_v = dot(n, v);
    d.v_h = dot(v, h);
    return d;
}

/* Reflection of one light by glTF 2.0, appendix B. */
static double metallic_roughness(const shd_material_desc *m, const struct directions *d, int c)
{
    const double alpha = fmax((double)(m->roughness * m->roughness), 1e-3), a2 = alpha * alpha;
    const double metal = (double)m->metallic, base = (double)m->diffuse[c];
    const double f = pow(((double)m->ior - 1) / ((double)m->ior + 1), 2), edge = pow(1 - d->v_h, 5);
    const double t = d->n_h * d->n_h * (a2 - 1) + 1, distribution = a2 / (k_pi * t * t);
    const double shadow_v = sqrt(d->n_v * d->n_v * (1 - a2) + a2), shadow_l = sqrt(d->n_l * d->n_l * (1 - a2) + a2);
    const double visibility = 0.5 / (d->n_l * shadow_v + d->n_v * shadow_l), lobe = distribution * visibility;
    const double plain = base / k_pi * (1 - (f + (1 - f) * edge)) + (f + (1 - f) * edge) * lobe;
    const double mirror = (base + (1 - base) * edge) * lobe;
    if (d->n_l <= 0) return 0;
    return d->e * d->n_l * ((1 - metal) * plain + metal * mirror);
}

/* Radiance L at a point in channel c. */
static double reflect(const shd_material_desc *m, vec3 p, vec3 n, double ambient, int c)
{
    const struct directions d = directions(p, n, c);
    const double kd = (double)m->diffuse[c], ks = (double)m->specular[c], exponent = (double)m->exponent;
    const double around = (double)m->ambient[c] * ambient, light = fmax(0, d.n_l), warmth = (1 + d.n_l) / 2;
    const double f = pow(((double)m->ior - 1) / ((double)m->ior + 1), 2), metal = (double)m->metallic;
    const int shines = m->flags & SHD_MATERIAL_SPECULAR_UNGATED || d.n_l > 0;
    const double shine = shines ? pow(d.n_h, exponent) : 0, steps = m->toon_steps;
    const double norm = (exponent + 2) * (exponent + 4) / (8 * k_pi * (pow(2, -exponent / 2) + exponent));
    if (m->debug_view == SHD_DEBUG_VIEW_NORMAL) return 0.5 + 0.5 * (c == 0 ? n.x : c == 1 ? n.y : n.z);
    switch (m->model) {
        case SHD_MODEL_LAMBERT: return around + kd * d.e * light;
        case SHD_MODEL_BLINN_PHONG: return around + kd * d.e * light + ks * d.e * shine;
        case SHD_MODEL_PHONG: return around + kd * d.e * light + ks * d.e * (shines ? pow(d.v_r, exponent) : 0);
        case SHD_MODEL_BLINN_PHONG_NORMALIZED: return around + (kd / k_pi + ks * norm * shine) * d.e * light;
        case SHD_MODEL_COMBINED: return kd * (ambient + d.e * light) + d.e * ks * shine;
        case SHD_MODEL_TOON: return around + kd * d.e * ceil(light * steps) / steps + ks * d.e * (shine >= 0.5);
        case SHD_MODEL_METALLIC_ROUGHNESS:
            return around * (kd * (1 - metal) + f * (1 - metal) + kd * metal) + metallic_roughness(m, &d, c);
        case SHD_MODEL_GOOCH:
            return warmth * ((double)m->warm[c] + (double)m->warm_mix * kd) +
                   (1 - warmth) * ((double)m->cool[c] + (double)m->cool_mix * kd);
        default: return kd; /* unlit; a matcap without texture */
    }
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
    if (m->debug_view == SHD_DEBUG_VIEW_BARYCENTRICS) return b[c];
    if (m->debug_view == SHD_DEBUG_VIEW_UV) return c < 2 ? b[1 + c] : 0;
    if (m->debug_view == SHD_DEBUG_VIEW_LEVEL) return c == 2;
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
    shd_debug_view view;
    shd_frequency frequency;
    uint32_t flags;
    float exponent;
    int ambient_lights;
};
#define CASES_OF(name, frequency)                                                                                      \
    {name "/lambert", SHD_MODEL_LAMBERT, SHD_DEBUG_VIEW_NONE, frequency, 0, 1, 1},                                     \
        {name "/lambert_no_ambient", SHD_MODEL_LAMBERT, SHD_DEBUG_VIEW_NONE, frequency, 0, 1, 0},                      \
        {name "/blinn_phong", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},                         \
        {name "/blinn_phong_sharp", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_NONE, frequency, 0, 200, 1},                 \
        {name "/blinn_phong_exponent_0", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_NONE, frequency, 0, 0, 1},              \
        {name "/two_ambient_lights", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 2},                  \
        {name "/ungated", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_NONE, frequency, SHD_MATERIAL_SPECULAR_UNGATED, 8, 1}, \
        {name "/phong", SHD_MODEL_PHONG, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},                                     \
        {name "/phong_sharp", SHD_MODEL_PHONG, SHD_DEBUG_VIEW_NONE, frequency, 0, 200, 1},                             \
        {name "/normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},               \
        {name "/normalized_exponent_0", SHD_MODEL_BLINN_PHONG_NORMALIZED, SHD_DEBUG_VIEW_NONE, frequency, 0, 0, 1},    \
        {name "/combined", SHD_MODEL_COMBINED, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},                               \
        {name "/gooch", SHD_MODEL_GOOCH, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},                                     \
        {name "/toon", SHD_MODEL_TOON, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},                                       \
        {name "/metallic_roughness", SHD_MODEL_METALLIC_ROUGHNESS, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},           \
        {name "/unlit", SHD_MODEL_UNLIT, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},                                     \
        {name "/matcap_without_texture", SHD_MODEL_MATCAP, SHD_DEBUG_VIEW_NONE, frequency, 0, 8, 1},                   \
        {name "/show_normal", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_NORMAL, frequency, 0, 8, 1},                       \
        {name "/show_uv", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_UV, frequency, 0, 8, 1},                               \
        {name "/show_level_without_texture", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_LEVEL, frequency, 0, 8, 1},         \
    {                                                                                                                  \
        name "/show_barycentrics", SHD_MODEL_BLINN_PHONG, SHD_DEBUG_VIEW_BARYCENTRICS, frequency, 0, 8, 1              \
    }
static const struct shade_case k_shades[] = {CASES_OF("phong", SHD_FREQUENCY_PHONG),
                                             CASES_OF("gouraud", SHD_FREQUENCY_GOURAUD),
                                             CASES_OF("flat", SHD_FREQUENCY_FLAT)};

static shd_material_desc material_of(const struct shade_case *c)
{
    shd_material_desc m = shd_material_desc_default();
    m.model = c->model;
    m.debug_view = c->view;
    m.flags = c->flags;
    m.exponent = c->exponent;
    m.ambient[0] = m.ambient[2] = 0.05f;
    m.ambient[1] = 0.2f;
    m.diffuse[2] = 0.4f;
    m.specular[0] = 0.9f;
    m.metallic = 0.4f;
    m.roughness = 0.6f;
    m.ior = 1.8f;
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
    const int steps = c->model == SHD_MODEL_TOON && c->frequency == SHD_FREQUENCY_PHONG;
    uint32_t x, y, seen = 0, steps_moved = 0;
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
                if (steps && fabs(want - (double)f.plane[i][at]) > 1e-4) {
                    ++steps_moved; /* rounding may select either side of a step */
                    continue;
                }
                shd_assert_close(c->name, 4 * at + (size_t)i, (double)f.plane[i][at], want, 2e-5, 4e-4);
            }
        }
    }
    assert_true(seen > 500);
    assert_true(steps_moved < 6);
    shd_frame_close(&f);
}

/* The factor pi of shd/light.h: the radiance of a white surface that faces the light and the eye. */
struct factor_case {
    const char *name;
    shd_model model;
    float ior;
    double intensity, want, tolerance;
};
static const struct factor_case k_factors[] = {
    {"factor/lambert", SHD_MODEL_LAMBERT, 1.5f, 1, 1, 1e-6},
    {"factor/phong", SHD_MODEL_PHONG, 1.5f, 1, 1, 1e-6},
    {"factor/blinn_phong", SHD_MODEL_BLINN_PHONG, 1.5f, 1, 1, 1e-6},
    {"factor/combined", SHD_MODEL_COMBINED, 1.5f, 1, 1, 1e-6},
    {"factor/toon", SHD_MODEL_TOON, 1.5f, 1, 1, 1e-6},
    {"factor/normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED, 1.5f, 1, 0.318309886, 1e-6},
    {"factor/normalized_times_pi", SHD_MODEL_BLINN_PHONG_NORMALIZED, 1.5f, 3.14159265, 1, 1e-6},
    {"factor/metallic", SHD_MODEL_METALLIC_ROUGHNESS, 1, 1, 0.318309886, 1e-5},
    {"factor/metallic_times_pi", SHD_MODEL_METALLIC_ROUGHNESS, 1, 3.14159265, 1, 1e-5},
    {"factor/dielectric", SHD_MODEL_METALLIC_ROUGHNESS, 1.5f, 1, 0.3, 0.02},
    {"factor/dielectric_times_pi", SHD_MODEL_METALLIC_ROUGHNESS, 1.5f, 3.14159265, 1, 0.05},
};

static void test_factor(void **state)
{
    const struct factor_case *c = (const struct factor_case *)*state;
    shd_material_desc material = shd_material_desc_default();
    shd_light_desc light = shd_light_desc_default();
    float vertices[48];
    shd_frame f;
    int i;
    shd_frame_open(&f, 1, 1);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, vertices);
    material.model = c->model;
    material.ior = c->ior;
    material.roughness = 1;
    material.metallic = 0;
    for (i = 0; i < 3; ++i) material.diffuse[i] = 1, material.specular[i] = 0, material.ambient[i] = 0;
    shd_frame_draw(&f, vertices, 6, &material);
    light.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    light.direction[1] = 0;
    light.direction[2] = -1;
    for (i = 0; i < 3; ++i) light.intensity[i] = (float)c->intensity;
    shd_frame_light(&f, &light);
    f.desc.view.eye[2] = 1e4f;
    shd_frame_render(&f);
    shd_assert_close(c->name, 0, (double)f.plane[SHD_PLANE_G][0], c->want, c->tolerance, 0);
    shd_frame_close(&f);
}

int main(void)
{
    enum { SHADES = sizeof k_shades / sizeof k_shades[0], FACTORS = sizeof k_factors / sizeof k_factors[0] };
    static struct CMUnitTest tests[SHADES + FACTORS];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_shades / sizeof k_shades[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_shades[i].name, test_shade, NULL, NULL, (void *)&k_shades[i]};
    }
    for (i = 0; i < FACTORS; ++i) {
        tests[n++] = (struct CMUnitTest){k_factors[i].name, test_factor, NULL, NULL, (void *)&k_factors[i]};
    }
    return _cmocka_run_group_tests("api.render_models", tests, n, NULL, NULL);
}
