/* SPDX-License-Identifier: MIT */
/* Slots of materials in frames: every source, uv sets and transforms, channels; normals and sides. */
#include "support/frame.h"
#include "support/slots.h"

enum { k_size = 16, k_pixels = k_size * k_size };

/* A frame covered by one quad, which has all data that slots read. */
typedef struct scene {
    shd_frame f;
    shd_material_desc material;
    shd_slot_list slots;
    shd_texture *texture;
    shd_sampler *nearest;
    float quad[48], uv1[2][6], attribute[4][6], tangent[4][6];
    int has_attributes, has_uv1, flips;
} scene;

static void open_scene(scene *s)
{
    static float texels[4 * 4 * 4];
    shd_texture_desc texture = shd_texture_desc_default();
    shd_sampler_desc sampler = shd_sampler_desc_default();
    int i, c;
    memset(s, 0, sizeof *s);
    shd_frame_open(&s->f, k_size, k_size);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, s->quad);
    for (i = 0; i < 6; ++i) {
        s->uv1[0][i] = 0.5f * s->quad[8 * i + 6] + 0.25f;
        s->uv1[1][i] = 1.0f - s->quad[8 * i + 7];
        for (c = 0; c < 4; ++c) s->attribute[c][i] = (float)(c + 1) * 0.25f * s->quad[8 * i + (c % 2 ? 6 : 7)];
    }
    for (i = 0; i < 16; ++i) {
        texels[4 * i + 0] = (float)(i % 4) / 4;
        texels[4 * i + 1] = (float)(i / 4) / 4;
        texels[4 * i + 2] = (float)i / 16;
        texels[4 * i + 3] = 1.0f - (float)i / 32;
    }
    texture.width = texture.height = 4;
    texture.format = SHD_FORMAT_RGBA32F;
    texture.texels = texels;
    shd_assert_ok(shd_texture_create(s->f.context, &texture, &s->texture));
    sampler.filter = SHD_FILTER_NEAREST;
    shd_assert_ok(shd_sampler_create(s->f.context, &sampler, &s->nearest));
    s->material = shd_material_desc_default();
    s->material.model = SHD_MODEL_UNLIT;
    for (c = 0; c < 3; ++c) s->material.diffuse[c] = 1.0f;
    s->has_attributes = s->has_uv1 = 1;
}

static void close_scene(scene *s)
{
    shd_texture_release(s->texture);
    shd_sampler_release(s->nearest);
    shd_frame_close(&s->f);
}

static void render(scene *s)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_f32_in attributes[6] = {{NULL, 0}};
    shd_draw *draw = &s->f.draw[0];
    int c;
    desc.vertex_count = 6;
    for (c = 0; c < 8; ++c) {
        shd_f32_in *column = c < 3 ? &desc.position[c] : c < 6 ? &desc.normal[c - 3] : &desc.uv[c - 6];
        *column = shd_f32_column(s->quad + c, 8 * sizeof(float));
    }
    for (c = 0; c < 2 && s->has_uv1; ++c) desc.uv1[c].data = s->uv1[c];
    for (c = 0; c < 4 && s->has_attributes; ++c) attributes[2 + c] = shd_f32_column(s->attribute[c], 0);
    desc.attributes = attributes;
    desc.attribute_count = s->has_attributes ? 6 : 0;
    shd_assert_ok(shd_mesh_create(s->f.context, &desc, &s->f.mesh[0]));
    shd_assert_ok(shd_material_create(s->f.context, &s->material, &s->f.material[0]));
    *draw = shd_draw_default();
    draw->mesh = s->f.mesh[0];
    draw->material = s->f.material[0];
    if (s->flips) draw->object_to_world[0] = -1.0f;
    s->f.desc.draw_count = 1;
    shd_frame_render(&s->f);
}

static double u_of(size_t at) { return ((double)(at % k_size) + 0.5) / k_size; }
static double v_of(size_t at) { return ((double)(at / k_size) + 0.5) / k_size; }

/* Texel channel c at (u, v), repeated. */
static double texel(double u, double v, int c)
{
    const int x = (int)floor((u - floor(u)) * 4), y = (int)floor((v - floor(v)) * 4), i = 4 * y + x;
    return c == 0 ? x / 4.0 : c == 1 ? y / 4.0 : c == 2 ? i / 16.0 : 1 - i / 32.0;
}

static shd_slot *add_slot(scene *s, shd_slot slot) { return shd_slot_list_add(&s->slots, &s->material, slot); }
static shd_slot *textured(scene *s, shd_slot_target target)
{
    return add_slot(s, shd_slot_texture(target, s->texture, s->nearest));
}

static void test_texture(void **state)
{
    scene s;
    size_t i;
    int c;
    (void)state;
    open_scene(&s);
    textured(&s, SHD_SLOT_DIFFUSE);
    render(&s);
    for (i = 0; i < k_pixels; ++i) {
        for (c = 0; c < 3; ++c) {
            shd_assert_close("texel", i, (double)s.f.plane[c][i], texel(u_of(i), v_of(i), c), 1e-6, 0);
        }
        assert_true(s.f.plane[SHD_PLANE_A][i] == 1.0f);
    }
    close_scene(&s);
}

static void test_uv_transform(void **state)
{
    /* A quarter turn, and a scale with an offset. */
    static const float k_transforms[2][6] = {{0, 1, 0.125f, -1, 0, 0.0625f}, {2, 0, 0.5f, 0, 0.5f, -0.25f}};
    size_t i;
    int k, c;
    (void)state;
    for (k = 0; k < 2; ++k) {
        const float *t = k_transforms[k];
        scene s;
        open_scene(&s);
        memcpy(textured(&s, SHD_SLOT_DIFFUSE)->uv_transform, t, sizeof k_transforms[k]);
        render(&s);
        for (i = 0; i < k_pixels; ++i) {
            const double u = u_of(i), v = v_of(i);
            for (c = 0; c < 3; ++c) {
                const double want = texel((double)t[0] * u + (double)t[1] * v + (double)t[2],
                                          (double)t[3] * u + (double)t[4] * v + (double)t[5], c);
                shd_assert_close("texel", i, (double)s.f.plane[c][i], want, 1e-6, 0);
            }
        }
        close_scene(&s);
    }
}

/* The second uv set; 0 if the mesh has none. */
static void test_uv_set(void **state)
{
    size_t i;
    int has, c;
    (void)state;
    for (has = 0; has < 2; ++has) {
        scene s;
        open_scene(&s);
        s.has_uv1 = has;
        textured(&s, SHD_SLOT_DIFFUSE)->uv_set = 1;
        render(&s);
        for (i = 0; i < k_pixels; ++i) {
            const double u = has ? 0.5 * u_of(i) + 0.25 : 0, v = has ? 1 - v_of(i) : 0;
            for (c = 0; c < 3; ++c) shd_assert_close("texel", i, (double)s.f.plane[c][i], texel(u, v, c), 1e-6, 0);
        }
        close_scene(&s);
    }
}

/* The tint multiplies the diffuse slot and opacity, for all sources of both; absent channels count as 1. */
static void test_tint(void **state)
{
    static const struct {
        const char *name;
        int diffuse, tint, has_attributes; /* diffuse: 0 none, 1 texture, 2 vertex; tint: 1 texture, 2 vertex */
    } k_rows[] = {{"texture by vertex", 1, 2, 1}, {"vertex by texture", 2, 1, 1}, {"none by vertex", 0, 2, 1},
                  {"vertex by vertex", 2, 2, 1},  {"texture by absent", 1, 2, 0}, {"none by texture", 0, 1, 1}};
    size_t row, i;
    int c, k;
    (void)state;
    for (row = 0; row < sizeof k_rows / sizeof *k_rows; ++row) {
        const int sources[2] = {k_rows[row].diffuse, k_rows[row].tint};
        scene s;
        open_scene(&s);
        s.has_attributes = k_rows[row].has_attributes;
        s.material.blend = SHD_BLEND_STRAIGHT;
        s.material.opacity = 0.5f;
        s.material.diffuse[1] = 0.5f;
        for (k = 0; k < 2; ++k) {
            const shd_slot_target target = k ? SHD_SLOT_TINT : SHD_SLOT_DIFFUSE;
            if (sources[k] == 1) textured(&s, target);
            if (sources[k] == 2) add_slot(&s, shd_slot_vertex(target, 2));
        }
        render(&s);
        for (i = 0; i < k_pixels; ++i) {
            double want[4] = {1, 0.5, 1, 0.5};
            for (c = 0; c < 4; ++c) {
                for (k = 0; k < 2; ++k) {
                    const double attribute = (c + 1) * 0.25 * (c % 2 ? u_of(i) : v_of(i));
                    if (sources[k] == 1) want[c] *= texel(u_of(i), v_of(i), c);
                    if (sources[k] == 2 && s.has_attributes) want[c] *= attribute;
                }
            }
            for (c = 0; c < 3; ++c) {
                shd_assert_close(k_rows[row].name, i, (double)s.f.plane[c][i], want[3] * want[c], 1e-6, 0);
            }
            shd_assert_close(k_rows[row].name, i, (double)s.f.plane[SHD_PLANE_A][i], want[3], 1e-6, 0);
        }
        close_scene(&s);
    }
}

/* Columns of the mesh; 1 if the mesh has none. */
static void test_vertex(void **state)
{
    size_t i;
    int has, c;
    (void)state;
    for (has = 0; has < 2; ++has) {
        scene s;
        open_scene(&s);
        s.has_attributes = has;
        s.material.blend = SHD_BLEND_STRAIGHT;
        add_slot(&s, shd_slot_vertex(SHD_SLOT_DIFFUSE, 2));
        render(&s);
        for (i = 0; i < k_pixels; ++i) {
            const double a = has ? u_of(i) : 1; /* the fourth column */
            for (c = 0; c < 3; ++c) {
                const double value = has ? (c + 1) * 0.25 * (c % 2 ? u_of(i) : v_of(i)) : 1;
                shd_assert_close("value", i, (double)s.f.plane[c][i], a * value, 1e-6, 0);
            }
            shd_assert_close("a", i, (double)s.f.plane[SHD_PLANE_A][i], a, 1e-6, 0);
        }
        close_scene(&s);
    }
}

/* A colour that begins at the last attribute of a mesh: the missing attributes read 1. */
static void test_vertex_end(void **state)
{
    scene s;
    size_t i;
    (void)state;
    open_scene(&s);
    add_slot(&s, shd_slot_vertex(SHD_SLOT_DIFFUSE, 5));
    render(&s);
    for (i = 0; i < k_pixels; ++i) {
        shd_assert_close("r", i, (double)s.f.plane[0][i], u_of(i), 1e-6, 0);
        assert_true(s.f.plane[1][i] == 1.0f && s.f.plane[2][i] == 1.0f);
    }
    close_scene(&s);
}

static void stripes(const shd_fragments *in, float *const out[4], void *user_data)
{
    const float *times = (const float *)user_data;
    size_t i;
    for (i = 0; i < in->count; ++i) {
        out[0][i] = *times * in->u[i];
        out[1][i] = in->attribute[3] ? in->attribute[3][i] : -1.0f;
        /* out[2] stays 1 */
    }
    if (out[3]) out[0][0] = -1.0f; /* an emission has three columns */
}

static void test_procedure(void **state)
{
    float times = 3.0f;
    scene s;
    size_t i;
    int c;
    (void)state;
    open_scene(&s);
    for (c = 0; c < 3; ++c) {
        s.material.diffuse[c] = 0.0f;
        s.material.emission[c] = 2.0f;
    }
    add_slot(&s, shd_slot_procedure(SHD_SLOT_EMISSION, stripes, &times));
    render(&s);
    for (i = 0; i < k_pixels; ++i) {
        shd_assert_close("r", i, (double)s.f.plane[0][i], 6 * u_of(i), 1e-5, 0);
        shd_assert_close("g", i, (double)s.f.plane[1][i], 2 * 0.5 * u_of(i), 1e-5, 0);
        assert_true(s.f.plane[2][i] == 2.0f);
    }
    close_scene(&s);
}

/* Opacity from one channel times the diffuse texture's alpha; occlusion of ambient light. */
static void test_scalars(void **state)
{
    scene s;
    size_t i;
    int c;
    (void)state;
    open_scene(&s);
    s.material.model = SHD_MODEL_LAMBERT;
    s.material.blend = SHD_BLEND_PREMULTIPLIED;
    s.material.opacity = 0.75f;
    s.material.occlusion_strength = 0.5f;
    for (c = 0; c < 3; ++c) s.material.ambient[c] = 0.8f;
    textured(&s, SHD_SLOT_DIFFUSE);
    textured(&s, SHD_SLOT_OPACITY)->channel = 2;
    textured(&s, SHD_SLOT_OCCLUSION)->channel = 1;
    shd_frame_ambient(&s.f);
    render(&s);
    for (i = 0; i < k_pixels; ++i) {
        const double u = u_of(i), v = v_of(i), a = 0.75 * texel(u, v, 2) * texel(u, v, 3);
        shd_assert_close("a", i, (double)s.f.plane[SHD_PLANE_A][i], a, 1e-6, 0);
        shd_assert_close("r", i, (double)s.f.plane[0][i], a * 0.8 * (1 + 0.5 * (texel(u, v, 1) - 1)), 1e-6, 0);
    }
    close_scene(&s);
}

/* A texture of one normal over the quad, with u to the right and v down: y of the normal is up or down in the image. */
static void test_normal(void **state)
{
    /* Bytes contain (n + 1) / 2, floats n. */
    static const float k_texel[4] = {0.48f, 0.6f, 0.64f, 1.0f};
    static const uint16_t k_codes[4] = {48496, 52428, 53738, 65535};
    int down, flips;
    (void)state;
    for (down = 0; down < 2; ++down) {
        for (flips = 0; flips < 2; ++flips) {
            shd_texture_desc desc = shd_texture_desc_default();
            shd_texture *normals = NULL;
            scene s;
            size_t i;
            open_scene(&s);
            desc.width = desc.height = 1;
            desc.format = down ? SHD_FORMAT_RGBA16 : SHD_FORMAT_RGBA32F;
            desc.texels = down ? (const void *)k_codes : (const void *)k_texel;
            shd_assert_ok(shd_texture_create(s.f.context, &desc, &normals));
            s.material.debug_view = SHD_DEBUG_VIEW_NORMAL;
            s.material.flags = down ? SHD_MATERIAL_NORMAL_Y_DOWN : 0;
            add_slot(&s, shd_slot_texture(SHD_SLOT_NORMAL, normals, NULL));
            s.flips = flips;
            render(&s);
            shd_texture_release(normals);
            for (i = 0; i < k_pixels; ++i) {
                const double x = flips ? -0.48 : 0.48, y = down ? -0.6 : 0.6;
                shd_assert_close("x", i, (double)s.f.plane[0][i], 0.5 + 0.5 * x, 1e-5, 0);
                shd_assert_close("y", i, (double)s.f.plane[1][i], 0.5 + 0.5 * y, 1e-5, 0);
                shd_assert_close("z", i, (double)s.f.plane[2][i], 0.5 + 0.5 * 0.64, 1e-5, 0);
            }
            close_scene(&s);
        }
    }
}

/* Heights that increase to the right: the gradient depends on the size of the quad, differences over a texel do not. */
static void test_bump(void **state)
{
    static const float k_ramp[8] = {0, 0.125f, 0.25f, 0.375f, 0.5f, 0.625f, 0.75f, 0.875f};
    int bump;
    (void)state;
    for (bump = SHD_BUMP_NONE; bump <= SHD_BUMP_TEXEL; ++bump) {
        shd_texture_desc desc = shd_texture_desc_default();
        shd_texture *heights = NULL;
        double slope = 0;
        scene s;
        open_scene(&s);
        desc.width = 8;
        desc.height = 1;
        desc.format = SHD_FORMAT_R32F;
        desc.texels = k_ramp;
        shd_assert_ok(shd_texture_create(s.f.context, &desc, &heights));
        s.material.debug_view = SHD_DEBUG_VIEW_NORMAL;
        add_slot(&s, shd_slot_texture(SHD_SLOT_HEIGHT, heights, NULL));
        s.material.bump = (shd_bump)bump;
        s.material.bump_scale = 3.0f;
        render(&s);
        shd_texture_release(heights);
        if (bump == SHD_BUMP_GRADIENT) slope = 3.0 * 1.0 / 2; /* from 0 to 1 over a quad of width 2 */
        if (bump == SHD_BUMP_TEXEL) slope = 3.0 * 0.125;
        /* in the middle, where no lookup wraps */
        shd_assert_close("x", 7, (double)s.f.plane[0][7 * k_size + 7], 0.5 - 0.5 * slope / sqrt(1 + slope * slope),
                         1e-6, 0);
        shd_assert_close("y", 7, (double)s.f.plane[1][7 * k_size + 7], 0.5, 1e-6, 0);
        close_scene(&s);
    }
}

/* Seen from behind, normals are flipped if the material is two-sided; a matrix that mirrors does not turn a front
 * into a back. */
static void test_double_sided(void **state)
{
    int both, flips, behind;
    (void)state;
    for (both = 0; both < 2; ++both) {
        for (flips = 0; flips < 2; ++flips) {
            for (behind = 0; behind < 2; ++behind) {
                scene s;
                int i;
                open_scene(&s);
                s.material.debug_view = SHD_DEBUG_VIEW_NORMAL;
                s.material.flags = both ? SHD_MATERIAL_DOUBLE_SIDED : 0;
                s.flips = flips;
                for (i = 0; i < 6 && behind; ++i) {
                    s.quad[8 * i] = -s.quad[8 * i]; /* the other winding */
                    s.quad[8 * i + 5] = -1.0f;
                }
                render(&s);
                for (i = 0; i < k_pixels; ++i) {
                    const float z = behind && !both ? 0.0f : 1.0f;
                    assert_true(s.f.plane[2][i] == z);
                }
                close_scene(&s);
            }
        }
    }
}

/* Values outside their range, on a surface under a light: they have the documented effect. */
static const struct wild_case {
    const char *name;
    shd_slot_target slot;
    shd_model model;
    float value;
    float like;    /* value that gives the same picture; NaN = none */
    int nonfinite; /* the picture has NaN or infinity, and the statistics count it */
} k_wild[] = {
    {"wild/diffuse_nan", SHD_SLOT_DIFFUSE, SHD_MODEL_LAMBERT, NAN, NAN, 1},
    {"wild/diffuse_inf", SHD_SLOT_DIFFUSE, SHD_MODEL_METALLIC_ROUGHNESS, INFINITY, NAN, 1},
    {"wild/diffuse_negative", SHD_SLOT_DIFFUSE, SHD_MODEL_UNLIT, -2, NAN, 0},
    {"wild/emission_nan", SHD_SLOT_EMISSION, SHD_MODEL_GOOCH, NAN, NAN, 1},
    {"wild/metallic_nan", SHD_SLOT_METALLIC, SHD_MODEL_METALLIC_ROUGHNESS, NAN, NAN, 1},
    {"wild/exponent_nan", SHD_SLOT_EXPONENT, SHD_MODEL_BLINN_PHONG, NAN, 0, 0},
    {"wild/exponent_negative", SHD_SLOT_EXPONENT, SHD_MODEL_PHONG, -3, 0, 0},
    {"wild/exponent_1e30", SHD_SLOT_EXPONENT, SHD_MODEL_BLINN_PHONG_NORMALIZED, 1e30f, 1e6f, 0},
    {"wild/roughness_nan", SHD_SLOT_ROUGHNESS, SHD_MODEL_METALLIC_ROUGHNESS, NAN, 2, 0},
    {"wild/roughness_negative", SHD_SLOT_ROUGHNESS, SHD_MODEL_METALLIC_ROUGHNESS, -1, 0, 0},
    {"wild/roughness_inf", SHD_SLOT_ROUGHNESS, SHD_MODEL_METALLIC_ROUGHNESS, INFINITY, 2, 0},
    {"wild/normal_nan", SHD_SLOT_NORMAL, SHD_MODEL_LAMBERT, NAN, 0, 0},
    {"wild/height_nan", SHD_SLOT_HEIGHT, SHD_MODEL_LAMBERT, NAN, 1, 0},
    {"wild/height_inf", SHD_SLOT_HEIGHT, SHD_MODEL_LAMBERT, INFINITY, 1, 0},
};

/* Renders with one value in every channel of a slot. */
static void render_wild(const struct wild_case *c, float value, float *out, uint64_t *nonfinite)
{
    const float texel[4] = {value, value, value, value};
    shd_texture_desc desc = shd_texture_desc_default();
    shd_light_desc light = shd_light_desc_default();
    shd_texture *texture = NULL;
    scene s;
    int k;
    open_scene(&s);
    desc.width = desc.height = 1;
    desc.format = SHD_FORMAT_RGBA32F;
    desc.texels = texel;
    shd_assert_ok(shd_texture_create(s.f.context, &desc, &texture));
    s.material.model = c->model;
    s.material.bump = SHD_BUMP_GRADIENT;
    s.material.exponent = s.material.roughness = s.material.metallic = 1;
    for (k = 0; k < 3; ++k) s.material.emission[k] = 1;
    add_slot(&s, shd_slot_texture(c->slot, texture, NULL));
    light.position[2] = 2;
    shd_frame_light(&s.f, &light);
    s.f.desc.view.eye[2] = 3;
    render(&s);
    shd_texture_release(texture);
    *nonfinite = s.f.stats.nonfinite_fragment_count;
    for (k = 0; k < 3; ++k) memcpy(out + k * k_pixels, s.f.plane[k], k_pixels * sizeof(float));
    close_scene(&s);
}

static void test_wild(void **state)
{
    static float got[3 * k_pixels], want[3 * k_pixels];
    const struct wild_case *c = (const struct wild_case *)*state;
    uint64_t nonfinite, none;
    size_t i;
    render_wild(c, c->value, got, &nonfinite);
    assert_int_equal(nonfinite, c->nonfinite ? k_pixels : 0);
    for (i = 0; i < 3 * k_pixels; ++i) assert_int_equal(!isfinite(got[i]), c->nonfinite);
    if (isnan(c->like)) return;
    render_wild(c, c->like, want, &none);
    assert_memory_equal(got, want, sizeof got);
}

/* Other inputs of a program: tangents of triangles, the second uv set, attributes. */
static void look(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    int *mistakes = (int *)user_data;
    size_t i;
    *mistakes += !in->attribute[2] || !in->attribute[5] || in->attribute[0] || in->attribute[7];
    for (i = 0; i < in->count; ++i) {
        *mistakes += !shd_is_close((double)in->tx[i], 1, 1e-6, 0) || in->tw[i] != 1.0f;
        *mistakes += !shd_is_close((double)in->u1[i], 0.5 * (double)in->u[i] + 0.25, 1e-6, 0);
        *mistakes += !shd_is_close((double)in->attribute[3][i], 0.5 * (double)in->u[i], 1e-6, 0);
        out->r[i] = 1.0f;
    }
}

static void test_program(void **state)
{
    static const shd_frequency k_frequencies[3] = {SHD_FREQUENCY_PHONG, SHD_FREQUENCY_GOURAUD, SHD_FREQUENCY_FLAT};
    int mistakes = 0;
    scene s;
    int k;
    (void)state;
    open_scene(&s);
    s.material.model = SHD_MODEL_PROGRAM;
    s.material.program.fragment = look;
    s.material.program.user_data = &mistakes;
    render(&s);
    for (k = 0; k < 3; ++k) {
        s.f.draw[0].frequency = k_frequencies[k];
        shd_frame_render(&s.f);
        assert_true(s.f.plane[0][0] == 1.0f);
    }
    assert_int_equal(mistakes, 0);
    close_scene(&s);
}

int main(void)
{
    static struct CMUnitTest tests[32] = {
        {"texture", test_texture, NULL, NULL, NULL},
        {"uv_transform", test_uv_transform, NULL, NULL, NULL},
        {"uv_set", test_uv_set, NULL, NULL, NULL},
        {"vertex", test_vertex, NULL, NULL, NULL},
        {"vertex/end", test_vertex_end, NULL, NULL, NULL},
        {"procedure", test_procedure, NULL, NULL, NULL},
        {"scalars", test_scalars, NULL, NULL, NULL},
        {"normal", test_normal, NULL, NULL, NULL},
        {"bump", test_bump, NULL, NULL, NULL},
        {"double_sided", test_double_sided, NULL, NULL, NULL},
        {"tint", test_tint, NULL, NULL, NULL},
        {"program", test_program, NULL, NULL, NULL},
    };
    size_t n = 12, i;
    for (i = 0; i < sizeof k_wild / sizeof k_wild[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_wild[i].name, test_wild, NULL, NULL, (void *)&k_wild[i]};
    }
    return _cmocka_run_group_tests("api.slots", tests, n, NULL, NULL);
}
