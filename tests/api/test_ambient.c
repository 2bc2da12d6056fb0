/* SPDX-License-Identifier: MIT */
/* The ambient coefficient: a share of the diffuse colour and its slot by default, what the caller sets otherwise. */
#include "support/frame.h"
#include "support/slots.h"

enum { k_size = 8, k_pixels = k_size * k_size };
static const float k_diffuse[3] = {0.8f, 0.5f, 0.125f}, k_ambient[3] = {0.25f, 0.0f, 2.0f};
static const float k_light[3] = {1.0f, 2.0f, 3.0f}; /* I_a */

/* Slots of the material: their values are functions of u and v. */
enum { NO_SLOT = 0, DIFFUSE_SLOT = 1, AMBIENT_SLOT = 2 };

static void diffuse_slot(const shd_fragments *in, float *const out[4], void *user_data)
{
    size_t i, c;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        for (c = 0; c < 3; ++c) out[c][i] = in->u[i];
    }
}

static void ambient_slot(const shd_fragments *in, float *const out[4], void *user_data)
{
    size_t i, c;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        for (c = 0; c < 3; ++c) out[c][i] = in->v[i];
    }
}

struct ambient_case {
    const char *name;
    shd_model model;
    shd_frequency frequency;
    int slots;
    int is_set;  /* k_a is k_ambient */
    float share; /* negative: the default, 1/16 */
};

#define MODEL_CASES(name, model)                                                               \
    {name "/follows", model, SHD_FREQUENCY_PHONG, NO_SLOT, 0, -1},                             \
        {name "/follows_slot", model, SHD_FREQUENCY_PHONG, DIFFUSE_SLOT, 0, -1},               \
        {name "/share_1", model, SHD_FREQUENCY_GOURAUD, DIFFUSE_SLOT, 0, 1},                   \
        {name "/share_0", model, SHD_FREQUENCY_FLAT, DIFFUSE_SLOT, 0, 0},                      \
        {name "/own_slot", model, SHD_FREQUENCY_PHONG, AMBIENT_SLOT, 0, 0.5f},                 \
        {name "/both_slots", model, SHD_FREQUENCY_FLAT, DIFFUSE_SLOT | AMBIENT_SLOT, 0, 0.5f}, \
        {name "/set", model, SHD_FREQUENCY_PHONG, DIFFUSE_SLOT, 1, -1},                        \
    {                                                                                          \
        name "/set_with_slot", model, SHD_FREQUENCY_GOURAUD, DIFFUSE_SLOT | AMBIENT_SLOT, 1, 1 \
    }
static const struct ambient_case k_cases[] = {
    MODEL_CASES("lambert", SHD_MODEL_LAMBERT),   MODEL_CASES("blinn_phong", SHD_MODEL_BLINN_PHONG),
    MODEL_CASES("phong", SHD_MODEL_PHONG),       MODEL_CASES("normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED),
    MODEL_CASES("toon", SHD_MODEL_TOON),         MODEL_CASES("metallic_roughness", SHD_MODEL_METALLIC_ROUGHNESS),
    MODEL_CASES("combined", SHD_MODEL_COMBINED),
};

/* Renders a quad with the material under one ambient light. */
static void render(shd_frame *f, const struct ambient_case *c, const shd_material_desc *material)
{
    float quad[48];
    shd_light_desc light = shd_light_desc_default();
    shd_frame_open(f, k_size, k_size);
    light.kind = SHD_LIGHT_KIND_AMBIENT;
    memcpy(light.intensity, k_light, sizeof k_light);
    shd_frame_light(f, &light);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(f, quad, 6, material)->frequency = c->frequency;
    shd_frame_render(f);
}

static shd_material_desc material_of(const struct ambient_case *c, shd_slot_list *slots)
{
    shd_material_desc desc = shd_material_desc_default();
    desc.model = c->model;
    desc.ior = 1; /* METALLIC_ROUGHNESS: no reflection at normal incidence */
    memcpy(desc.diffuse, k_diffuse, sizeof k_diffuse);
    if (c->is_set) memcpy(desc.ambient, k_ambient, sizeof k_ambient);
    if (c->share >= 0) desc.ambient_share = c->share;
    slots->count = 0;
    if (c->slots & DIFFUSE_SLOT) {
        shd_slot_list_add(slots, &desc, shd_slot_procedure(SHD_SLOT_DIFFUSE, diffuse_slot, NULL));
    }
    if (c->slots & AMBIENT_SLOT) {
        shd_slot_list_add(slots, &desc, shd_slot_procedure(SHD_SLOT_AMBIENT, ambient_slot, NULL));
    }
    return desc;
}

/* The ambient term of the documentation. */
static double expected(const struct ambient_case *c, double u, double v, int channel)
{
    const double color = (double)k_diffuse[channel] * (c->slots & DIFFUSE_SLOT ? u : 1);
    const double own = c->slots & AMBIENT_SLOT ? v : 1, share = c->share < 0 ? 0.0625 : (double)c->share;
    const double set = (double)k_ambient[channel] * own;
    if (c->model == SHD_MODEL_COMBINED) return color;
    if (c->model == SHD_MODEL_METALLIC_ROUGHNESS) return color * (c->is_set ? set : share * own);
    if (c->is_set) return set;
    return share * (c->slots & AMBIENT_SLOT ? (double)k_diffuse[channel] * own : color);
}

static void test_ambient(void **state)
{
    const struct ambient_case *c = (const struct ambient_case *)*state;
    shd_slot_list slots;
    const shd_material_desc material = material_of(c, &slots);
    shd_frame f;
    size_t i;
    int k;
    render(&f, c, &material);
    for (i = 0; i < k_pixels; ++i) {
        const double u = ((double)(i % k_size) + 0.5) / k_size, v = ((double)(i / k_size) + 0.5) / k_size;
        for (k = 0; k < 3; ++k) {
            shd_assert_close("channel", i, (double)f.plane[k][i], expected(c, u, v, k) * (double)k_light[k], 1e-6, 0);
        }
    }
    shd_frame_close(&f);
}

/* The defaults are 0.05 of 0.8 in the same bits. */
static void test_default(void **state)
{
    static const struct ambient_case k_lambert = {"", SHD_MODEL_LAMBERT, SHD_FREQUENCY_PHONG, NO_SLOT, 0, -1};
    const shd_material_desc desc = shd_material_desc_default();
    shd_frame f;
    size_t i;
    (void)state;
    render(&f, &k_lambert, &desc);
    for (i = 0; i < k_pixels; ++i) assert_true(f.plane[0][i] == 0.05f);
    shd_frame_close(&f);
}

/* A texture under ambient light is the texture: a following k_a takes its texels, as a slot of its own would. */
static void test_texture(void **state)
{
    static const struct ambient_case k_lambert = {"", SHD_MODEL_LAMBERT, SHD_FREQUENCY_PHONG, NO_SLOT, 0, -1};
    static const uint8_t k_texels[16] = {255, 0, 9, 255, 30, 90, 160, 255, 8, 250, 0, 0, 77, 66, 55, 44};
    int own;
    float first[3][k_pixels];
    (void)state;
    for (own = 0; own < 2; ++own) {
        shd_texture_desc texture_desc = shd_texture_desc_default();
        shd_material_desc material = shd_material_desc_default();
        shd_context *context = NULL;
        shd_texture *texture = NULL;
        shd_slot_list slots;
        shd_frame f;
        int c;
        shd_assert_ok(shd_context_create(NULL, &context));
        texture_desc.width = texture_desc.height = 2;
        texture_desc.format = SHD_FORMAT_RGBA8_SRGB;
        texture_desc.texels = k_texels;
        shd_assert_ok(shd_texture_create(context, &texture_desc, &texture));
        slots.count = 0;
        shd_slot_list_add(&slots, &material, shd_slot_texture(SHD_SLOT_DIFFUSE, texture, NULL));
        if (own) {
            shd_slot_list_add(&slots, &material, shd_slot_texture(SHD_SLOT_AMBIENT, texture, NULL));
            for (c = 0; c < 3; ++c) material.ambient[c] = 0.8f / 16;
        }
        render(&f, &k_lambert, &material);
        /* inside the first texel, and inside the second */
        assert_true(f.plane[0][k_size + 1] > f.plane[0][k_size + 5]);
        assert_true(f.plane[2][k_size + 1] < f.plane[2][k_size + 5]);
        for (c = 0; c < 3; ++c) {
            if (own) assert_memory_equal(first[c], f.plane[c], sizeof first[c]);
            memcpy(first[c], f.plane[c], sizeof first[c]);
        }
        shd_frame_close(&f);
        shd_texture_release(texture);
        shd_context_release(context);
    }
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_cases / sizeof k_cases[0] + 2];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_cases / sizeof k_cases[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_cases[i].name, test_ambient, NULL, NULL, (void *)(uintptr_t)&k_cases[i]};
    }
    tests[n++] = (struct CMUnitTest){"default", test_default, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"texture", test_texture, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.ambient", tests, n, NULL, NULL);
}
