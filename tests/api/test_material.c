/* SPDX-License-Identifier: MIT */
/* Materials: every field of the desc, programs, and the texture and sampler they hold. */
#include "support/check.h"
#include "support/fault_allocator.h"

#include <shd/shd.h>

static shd_context *g_context;
static shd_light *g_light;
static shd_texture *g_texture;

static void program(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    (void)in;
    (void)out;
    (void)user_data;
}

static void edit_nothing(shd_material_desc *d) { (void)d; }
static void edit_size(shd_material_desc *d) { d->struct_size = 16; }
static void edit_blinn_phong(shd_material_desc *d) { d->model = SHD_MODEL_BLINN_PHONG; }
static void edit_program(shd_material_desc *d)
{
    d->model = SHD_MODEL_PROGRAM;
    d->program.fragment = program;
}
static void edit_program_missing(shd_material_desc *d) { d->model = SHD_MODEL_PROGRAM; }
static void edit_program_unused(shd_material_desc *d) { d->program.fragment = program; }
static void edit_unlit(shd_material_desc *d) { d->model = SHD_MODEL_UNLIT; }
static void edit_model(shd_material_desc *d) { d->model = (shd_model)15; }
static void edit_model_negative(shd_material_desc *d) { d->model = (shd_model)-1; }
static void edit_flags(shd_material_desc *d) { d->flags = SHD_SPECULAR_UNGATED | SHD_AMBIENT_PER_LIGHT; }
static void edit_flags_unknown(shd_material_desc *d) { d->flags = SHD_SPECULAR_UNGATED | 64; }
static void edit_black(shd_material_desc *d)
{
    memset(d->ambient, 0, sizeof d->ambient);
    memset(d->diffuse, 0, sizeof d->diffuse);
    memset(d->specular, 0, sizeof d->specular);
    d->exponent = 0;
}
static void edit_largest(shd_material_desc *d) { d->ambient[0] = d->diffuse[1] = d->specular[2] = d->exponent = 1e6f; }
static void edit_ambient_negative(shd_material_desc *d) { d->ambient[0] = -1; }
static void edit_ambient_nan(shd_material_desc *d) { d->ambient[2] = (float)NAN; }
static void edit_diffuse_above(shd_material_desc *d) { d->diffuse[1] = 1.5e6f; }
static void edit_diffuse_inf(shd_material_desc *d) { d->diffuse[2] = INFINITY; }
static void edit_specular_nan(shd_material_desc *d) { d->specular[0] = (float)NAN; }
static void edit_specular_minus_inf(shd_material_desc *d) { d->specular[1] = -INFINITY; }
static void edit_exponent_negative(shd_material_desc *d) { d->exponent = -0.5f; }
static void edit_exponent_nan(shd_material_desc *d) { d->exponent = (float)NAN; }
static void edit_exponent_above(shd_material_desc *d) { d->exponent = 2e6f; }
static void edit_opacity(shd_material_desc *d) { d->opacity = 1.5f; }
static void edit_opacity_nan(shd_material_desc *d) { d->opacity = NAN; }
static void edit_blend(shd_material_desc *d) { d->blend = (shd_blend_mode)7; }
static void edit_blends(shd_material_desc *d)
{
    d->blend = SHD_BLEND_SORTED;
    d->opacity = 0;
    d->alpha_cutoff = 1;
    d->flags = SHD_ALPHA_TO_COVERAGE;
}
static void edit_cutoff(shd_material_desc *d) { d->alpha_cutoff = -0.5f; }
static void edit_discards(shd_material_desc *d) { d->flags = SHD_MATERIAL_DISCARDS; }
static void vertex(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    (void)in;
    (void)out;
    (void)user_data;
}
static void edit_vertex(shd_material_desc *d) { d->program.vertex = vertex; }
static void edit_varyings(shd_material_desc *d)
{
    edit_vertex(d);
    d->varying_count = 16;
    d->interpolation[0] = SHD_INTERPOLATION_AFFINE;
    d->interpolation[15] = SHD_INTERPOLATION_FLAT;
}
static void edit_varyings_and_program(shd_material_desc *d)
{
    edit_varyings(d);
    edit_program(d);
}
static void edit_varyings_17(shd_material_desc *d)
{
    edit_vertex(d);
    d->varying_count = 17;
}
static void edit_varyings_without_vertex(shd_material_desc *d)
{
    edit_program(d);
    d->varying_count = 3;
}
static void edit_interpolation(shd_material_desc *d)
{
    edit_vertex(d);
    d->interpolation[15] = (shd_interpolation)3;
}
static void edit_interpolation_negative(shd_material_desc *d)
{
    edit_varyings(d);
    d->interpolation[2] = (shd_interpolation)-1;
}
static void edit_reserved(shd_material_desc *d) { d->reserved = 1; }
static void edit_light_as_texture(shd_material_desc *d)
{
    d->slot[SHD_SLOT_DIFFUSE].source = SHD_SOURCE_TEXTURE;
    d->slot[SHD_SLOT_DIFFUSE].texture = (shd_texture *)(void *)g_light;
}
static void edit_light_as_sampler(shd_material_desc *d)
{
    d->slot[SHD_SLOT_DIFFUSE].source = SHD_SOURCE_TEXTURE;
    d->slot[SHD_SLOT_DIFFUSE].texture = g_texture;
    d->slot[SHD_SLOT_DIFFUSE].sampler = (shd_sampler *)(void *)g_light;
}

struct create_case {
    const char *name;
    void (*edit)(shd_material_desc *desc);
    shd_result expected;
    const char *message;
};

#define BAD SHD_ERROR_INVALID_ARGUMENT
static const struct create_case k_create[] = {
    {"create/defaults", edit_nothing, SHD_OK, ""},
    {"create/blinn_phong", edit_blinn_phong, SHD_OK, ""},
    {"create/program", edit_program, SHD_OK, ""},
    {"create/all_flags", edit_flags, SHD_OK, ""},
    {"create/all_0", edit_black, SHD_OK, ""},
    {"create/all_1e6", edit_largest, SHD_OK, ""},
    {"create/struct_size_16", edit_size, BAD, "material.struct_size: 16"},
    {"create/unlit", edit_unlit, SHD_OK, ""},
    {"create/model_15", edit_model, BAD, "material.model: 15 is not in 0..14"},
    {"create/model_negative", edit_model_negative, BAD, "material.model: "},
    {"create/program_without_fragment", edit_program_missing, BAD,
     "material.program.fragment: NULL, but the model is SHD_MODEL_PROGRAM"},
    {"create/fragment_without_program", edit_program_unused, BAD,
     "material.program.fragment: set, but the model is not SHD_MODEL_PROGRAM"},
    {"create/flags_unknown", edit_flags_unknown, SHD_ERROR_UNSUPPORTED, "material.flags: bits 0x40 "},
    {"create/ambient_negative", edit_ambient_negative, BAD, "material.ambient[0]: -1 is not in 0..1e+06"},
    {"create/ambient_nan", edit_ambient_nan, BAD, "material.ambient[2]: "},
    {"create/diffuse_1.5e6", edit_diffuse_above, BAD, "material.diffuse[1]: 1.5e+06"},
    {"create/diffuse_inf", edit_diffuse_inf, BAD, "material.diffuse[2]: inf"},
    {"create/specular_nan", edit_specular_nan, BAD, "material.specular[0]: "},
    {"create/specular_minus_inf", edit_specular_minus_inf, BAD, "material.specular[1]: -inf"},
    {"create/exponent_negative", edit_exponent_negative, BAD, "material.exponent: -0.5"},
    {"create/exponent_nan", edit_exponent_nan, BAD, "material.exponent: "},
    {"create/exponent_2e6", edit_exponent_above, BAD, "material.exponent: 2e+06 is not in 0..1e+06"},
    {"create/opacity_1.5", edit_opacity, BAD, "material.opacity: 1.5 is not in 0..1"},
    {"create/opacity_nan", edit_opacity_nan, BAD, "material.opacity: nan"},
    {"create/blend_7", edit_blend, BAD, "material.blend: 7 is not in 0..6"},
    {"create/sorted", edit_blends, SHD_OK, ""},
    {"create/alpha_cutoff_negative", edit_cutoff, BAD, "material.alpha_cutoff: -0.5"},
    {"create/discards_without_program", edit_discards, BAD, "material.flags: SHD_MATERIAL_DISCARDS, but"},
    {"create/vertex", edit_vertex, SHD_OK, ""},
    {"create/varyings", edit_varyings, SHD_OK, ""},
    {"create/varyings_and_program", edit_varyings_and_program, SHD_OK, ""},
    {"create/varyings_17", edit_varyings_17, BAD, "material.varying_count: 17 is not in 0..16"},
    {"create/varyings_without_vertex", edit_varyings_without_vertex, BAD,
     "material.varying_count: 3, but material.program.vertex is NULL"},
    {"create/interpolation_3", edit_interpolation, BAD, "material.interpolation[15]: 3 is not in 0..2"},
    {"create/interpolation_negative", edit_interpolation_negative, BAD, "material.interpolation[2]: "},
    {"create/reserved", edit_reserved, BAD, "material.reserved: 1 is not 0"},
    {"create/light_as_texture", edit_light_as_texture, BAD, "material.slot[0].texture: not a live handle of its type"},
    {"create/light_as_sampler", edit_light_as_sampler, BAD, "material.slot[0].sampler: not a live handle of its type"},
};

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = (shd_material *)&desc;
    c->edit(&desc);
    shd_assert_result(c->name, shd_material_create(g_context, &desc, &material), c->expected, c->message);
    if (c->expected == SHD_OK) {
        assert_non_null(material);
    } else {
        assert_null(material);
    }
    shd_material_release(material);
}

static void test_null_desc(void **state)
{
    shd_material *material = NULL;
    (void)state;
    shd_assert_ok(shd_material_create(g_context, NULL, &material));
    assert_non_null(material);
    shd_material_release(material);
}

/* Handles of a texture and a sampler on a counting allocator. */
struct parts {
    shd_fault_allocator memory;
    shd_context *context;
    shd_texture *texture;
    shd_sampler *sampler;
};

static void open_parts(struct parts *p)
{
    static const float k_texel[4] = {1, 1, 1, 1};
    shd_context_desc context;
    shd_texture_desc texture = shd_texture_desc_default();
    memset(p, 0, sizeof *p);
    context = shd_fault_context_desc(&p->memory);
    shd_assert_ok(shd_context_create(&context, &p->context));
    texture.format = SHD_FORMAT_RGBA32F;
    texture.width = texture.height = 1;
    texture.texels = k_texel;
    shd_assert_ok(shd_texture_create(p->context, &texture, &p->texture));
    shd_assert_ok(shd_sampler_create(p->context, NULL, &p->sampler));
}

static shd_result look_up(const struct parts *p)
{
    const float half = 0.5f;
    float red;
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels;
    memset(&texels, 0, sizeof texels);
    lookups.count = 1;
    lookups.u.data = lookups.v.data = &half;
    texels.channel[0].data = &red;
    return shd_texture_sample(p->texture, p->sampler, &lookups, &texels);
}

/* The material keeps both alive, and lets both go with its own last reference. */
static void test_parts_retained(void **state)
{
    struct parts p;
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    (void)state;
    open_parts(&p);
    desc.slot[SHD_SLOT_DIFFUSE].source = SHD_SOURCE_TEXTURE;
    desc.slot[SHD_SLOT_DIFFUSE].texture = p.texture;
    desc.slot[SHD_SLOT_DIFFUSE].sampler = p.sampler;
    shd_assert_ok(shd_material_create(p.context, &desc, &material));
    shd_texture_release(p.texture);
    shd_sampler_release(p.sampler);
    shd_context_release(p.context);
    shd_material_retain(material);
    shd_material_release(material);
    shd_assert_ok(look_up(&p));
    shd_material_release(material);
    shd_assert_all_freed("parts_retained", &p.memory);
}

/* A texture that is fine goes back to one reference when the sampler is refused. */
static void test_parts_after_refusal(void **state)
{
    struct parts p;
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = (shd_material *)&p;
    size_t before;
    (void)state;
    open_parts(&p);
    before = p.memory.live_bytes;
    desc.slot[SHD_SLOT_DIFFUSE].source = SHD_SOURCE_TEXTURE;
    desc.slot[SHD_SLOT_DIFFUSE].texture = p.texture;
    desc.slot[SHD_SLOT_DIFFUSE].sampler = (shd_sampler *)(void *)p.texture;
    shd_assert_result("sampler", shd_material_create(p.context, &desc, &material), BAD,
                      "material.slot[0].sampler: not a live handle of its type");
    assert_null(material);
    assert_int_equal(p.memory.live_bytes, before);
    shd_assert_ok(look_up(&p));
    shd_texture_release(p.texture);
    shd_assert_result("texture", look_up(&p), BAD, "texture: not a live handle of its type");
    desc.slot[SHD_SLOT_DIFFUSE].sampler = p.sampler;
    shd_assert_result("released", shd_material_create(p.context, &desc, &material), BAD,
                      "material.slot[0].texture: not a live handle of its type");
    shd_sampler_release(p.sampler);
    shd_context_release(p.context);
    shd_assert_all_freed("parts_after_refusal", &p.memory);
}

/* A texture without sampler is fine. */
static void test_one_part(void **state)
{
    struct parts p;
    shd_material_desc textured = shd_material_desc_default();
    shd_material *a = NULL;
    (void)state;
    open_parts(&p);
    textured.slot[SHD_SLOT_DIFFUSE].source = SHD_SOURCE_TEXTURE;
    textured.slot[SHD_SLOT_DIFFUSE].texture = p.texture;
    shd_assert_ok(shd_material_create(p.context, &textured, &a));
    shd_context_release(p.context);
    shd_texture_release(p.texture);
    shd_assert_ok(look_up(&p));
    shd_sampler_release(p.sampler);
    shd_material_release(a);
    shd_assert_all_freed("one_part", &p.memory);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static shd_result make_texture(shd_texture **out)
{
    static const unsigned char texel[4] = {1, 2, 3, 4};
    shd_texture_desc desc = shd_texture_desc_default();
    desc.width = desc.height = 1;
    desc.format = SHD_FORMAT_RGBA8;
    desc.texels = texel;
    return shd_texture_create(g_context, &desc, out);
}

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_create) + 8];
    size_t n = 0, i;
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    if (shd_light_create(g_context, NULL, &g_light) != SHD_OK) return 1;
    if (make_texture(&g_texture) != SHD_OK) return 1;
    for (i = 0; i < COUNT(k_create); ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    tests[n++] = (struct CMUnitTest){"create/null_desc", test_null_desc, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"parts/retained", test_parts_retained, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"parts/after_refusal", test_parts_after_refusal, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"parts/one_of_two", test_one_part, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.material", tests, n, NULL, NULL);
    shd_texture_release(g_texture);
    shd_light_release(g_light);
    shd_context_release(g_context);
    return failed;
}
