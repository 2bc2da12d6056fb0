/* SPDX-License-Identifier: MIT */
/* Materials: every field of the desc, programs, and the texture and sampler that a material retains. */
#include "support/check.h"
#include "support/fault_allocator.h"
#include "support/slots.h"

#include <shd/shd.h>

static shd_context *g_context;
static shd_light *g_light;
static shd_texture *g_texture;
static shd_sampler *g_ripmap;

static void program(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    (void)in;
    (void)out;
    (void)user_data;
}

static void edit_nothing(shd_material_desc *d) { (void)d; }
static void edit_size(shd_material_desc *d) { d->struct_size = 4; }
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
static void edit_flags(shd_material_desc *d)
{
    d->flags = SHD_MATERIAL_SPECULAR_UNGATED | SHD_MATERIAL_AMBIENT_PER_LIGHT;
}
static void edit_flags_unknown(shd_material_desc *d) { d->flags = SHD_MATERIAL_SPECULAR_UNGATED | 64; }
static void edit_black(shd_material_desc *d)
{
    memset(d->ambient, 0, sizeof d->ambient);
    memset(d->diffuse, 0, sizeof d->diffuse);
    memset(d->specular, 0, sizeof d->specular);
    d->exponent = 0;
}
static void edit_largest(shd_material_desc *d)
{
    d->ambient[0] = d->ambient[1] = d->ambient[2] = 1e6f;
    d->diffuse[1] = d->specular[2] = d->exponent = 1e6f;
}
static void set_ambient(shd_material_desc *d, float r, float g, float b)
{
    d->ambient[0] = r;
    d->ambient[1] = g;
    d->ambient[2] = b;
}
static void edit_ambient_minus_1(shd_material_desc *d) { set_ambient(d, -1, -1, -1); }
static void edit_ambient_minus_0(shd_material_desc *d) { set_ambient(d, -0.0f, 0, 1); }
static void edit_ambient_negative(shd_material_desc *d) { set_ambient(d, 0, 0.5f, -0.5f); }
static void edit_ambient_minus_2(shd_material_desc *d) { set_ambient(d, -2, -2, -2); }
static void edit_ambient_mixed(shd_material_desc *d) { d->ambient[1] = 0.2f; }
static void edit_ambient_mixed_last(shd_material_desc *d) { set_ambient(d, 0.2f, 0.2f, -1); }
static void edit_ambient_above(shd_material_desc *d) { set_ambient(d, 0, 2e6f, 0); }
static void edit_ambient_share_0(shd_material_desc *d) { d->ambient_share = 0; }
static void edit_ambient_share_above(shd_material_desc *d) { d->ambient_share = 1.5f; }
static void edit_ambient_share_nan(shd_material_desc *d) { d->ambient_share = (float)NAN; }
static void edit_ambient_nan(shd_material_desc *d) { set_ambient(d, 0, 0, (float)NAN); }
static void edit_diffuse_above(shd_material_desc *d) { d->diffuse[1] = 1.5e6f; }
static void edit_diffuse_inf(shd_material_desc *d) { d->diffuse[2] = INFINITY; }
static void edit_specular_nan(shd_material_desc *d) { d->specular[0] = (float)NAN; }
static void edit_specular_minus_inf(shd_material_desc *d) { d->specular[1] = -INFINITY; }
static void edit_exponent_negative(shd_material_desc *d) { d->exponent = -0.5f; }
static void edit_exponent_nan(shd_material_desc *d) { d->exponent = (float)NAN; }
static void edit_exponent_above(shd_material_desc *d) { d->exponent = 2e6f; }
static void edit_opacity(shd_material_desc *d) { d->opacity = 1.5f; }
static void edit_opacity_nan(shd_material_desc *d) { d->opacity = NAN; }
static void edit_blend(shd_material_desc *d) { d->blend = (shd_blend)7; }
static void edit_blends(shd_material_desc *d)
{
    d->blend = SHD_BLEND_SORTED;
    d->opacity = 0;
    d->alpha_cutoff = 1;
    d->flags = SHD_MATERIAL_ALPHA_TO_COVERAGE;
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
static shd_interpolation g_interpolation[16];
static void edit_varyings(shd_material_desc *d)
{
    edit_vertex(d);
    d->varying_count = 16;
    memset(g_interpolation, 0, sizeof g_interpolation);
    g_interpolation[0] = SHD_INTERPOLATION_AFFINE;
    g_interpolation[15] = SHD_INTERPOLATION_FLAT;
    d->interpolation = g_interpolation;
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
    edit_varyings(d);
    g_interpolation[15] = (shd_interpolation)3;
}
static void edit_interpolation_negative(shd_material_desc *d)
{
    edit_varyings(d);
    g_interpolation[2] = (shd_interpolation)-1;
}
static void edit_interpolation_missing(shd_material_desc *d)
{
    edit_varyings(d);
    d->interpolation = NULL;
}
/* Entries beyond the count are not read. */
static void edit_interpolation_beyond(shd_material_desc *d)
{
    edit_interpolation(d);
    d->varying_count = 15;
}

static shd_slot_list g_slots;
static shd_slot constant(shd_slot_target target)
{
    shd_slot slot = shd_slot_default();
    slot.target = target;
    return slot;
}
static shd_slot *add_slot(shd_material_desc *d, shd_slot slot) { return shd_slot_list_add(&g_slots, d, slot); }
static shd_slot *add_texture(shd_material_desc *d, shd_slot_target target)
{
    add_slot(d, constant(SHD_SLOT_OPACITY));
    return add_slot(d, shd_slot_texture(target, g_texture, NULL));
}
static void edit_light_as_texture(shd_material_desc *d)
{
    add_slot(d, shd_slot_texture(SHD_SLOT_DIFFUSE, (shd_texture *)(void *)g_light, NULL));
}
static void edit_light_as_sampler(shd_material_desc *d)
{
    add_texture(d, SHD_SLOT_DIFFUSE)->sampler = (shd_sampler *)(void *)g_light;
}

static void edit_last_model(shd_material_desc *d) { d->model = SHD_MODEL_MATCAP; }
static void edit_last_view(shd_material_desc *d) { d->debug_view = SHD_DEBUG_VIEW_BARYCENTRICS; }
static void edit_debug_view_5(shd_material_desc *d) { d->debug_view = (shd_debug_view)5; }
static void edit_view_of_program(shd_material_desc *d)
{
    edit_program(d);
    d->flags = SHD_MATERIAL_DISCARDS;
    d->debug_view = SHD_DEBUG_VIEW_NORMAL;
}
static void edit_exponent_0(shd_material_desc *d) { d->exponent = 0; }
static void edit_exponent_1e6_of_metal(shd_material_desc *d)
{
    d->exponent = 1e6f;
    d->model = SHD_MODEL_METALLIC_ROUGHNESS;
}
static void edit_emission_1e12(shd_material_desc *d) { d->emission[2] = 1e12f; }
static void edit_emission_negative(shd_material_desc *d) { d->emission[1] = -1e-6f; }
static void edit_emission_nan(shd_material_desc *d) { d->emission[0] = (float)NAN; }
static void edit_metallic_1(shd_material_desc *d) { d->metallic = 1; }
static void edit_metallic_above(shd_material_desc *d) { d->metallic = 1.001f; }
static void edit_metallic_nan(shd_material_desc *d) { d->metallic = (float)NAN; }
static void edit_roughness_0(shd_material_desc *d) { d->roughness = 0; }
static void edit_roughness_negative(shd_material_desc *d) { d->roughness = -0.5f; }
static void edit_roughness_inf(shd_material_desc *d) { d->roughness = INFINITY; }
static void edit_ior_1(shd_material_desc *d) { d->ior = 1; }
static void edit_ior_0(shd_material_desc *d) { d->ior = 0; }
static void edit_ior_nan(shd_material_desc *d) { d->ior = (float)NAN; }
static void edit_occlusion_strength_2(shd_material_desc *d) { d->occlusion_strength = 2; }
static void edit_warm_negative(shd_material_desc *d) { d->warm[0] = -1; }
static void edit_cool_inf(shd_material_desc *d) { d->cool[2] = INFINITY; }
static void edit_warm_mix_2(shd_material_desc *d) { d->warm_mix = 2; }
static void edit_cool_mix_nan(shd_material_desc *d) { d->cool_mix = (float)NAN; }
static void edit_toon_steps_1(shd_material_desc *d) { d->toon_steps = 1; }
static void edit_toon_steps_0(shd_material_desc *d) { d->toon_steps = 0; }
static void edit_toon_steps_257(shd_material_desc *d) { d->toon_steps = 257; }
static void edit_normal_encoding_4(shd_material_desc *d) { d->normal_encoding = (shd_normal_encoding)4; }
static void edit_normal_scale_negative(shd_material_desc *d) { d->normal_scale = -1; }
static void edit_normal_scale_nan(shd_material_desc *d) { d->normal_scale = (float)NAN; }
static void edit_normal_scale_2e3(shd_material_desc *d) { d->normal_scale = 2e3f; }
static void edit_bump_3(shd_material_desc *d) { d->bump = (shd_bump)3; }
static void edit_bump_scale_1e30(shd_material_desc *d) { d->bump_scale = 1e30f; }
static void edit_bump_scale_nan(shd_material_desc *d) { d->bump_scale = (float)NAN; }
static void edit_parallax_depth_negative(shd_material_desc *d) { d->parallax_depth = -1; }
static void edit_parallax_steps_1(shd_material_desc *d) { d->parallax_steps = 1; }
static void edit_parallax_steps_257(shd_material_desc *d) { d->parallax_steps = 257; }
static void edit_slot_source_5(shd_material_desc *d)
{
    add_slot(d, constant(SHD_SLOT_EXPONENT))->source = (shd_slot_source)5;
}
static void edit_slot_texture_missing(shd_material_desc *d) { add_texture(d, SHD_SLOT_NORMAL)->texture = NULL; }
static void edit_slot_texture_of_constant(shd_material_desc *d)
{
    add_slot(d, constant(SHD_SLOT_AMBIENT))->texture = g_texture;
}
static void edit_slot_sampler_of_constant(shd_material_desc *d)
{
    add_slot(d, constant(SHD_SLOT_AMBIENT))->sampler = g_ripmap;
}
static void edit_slot_sampler_of_vertex(shd_material_desc *d)
{
    add_slot(d, shd_slot_vertex(SHD_SLOT_DIFFUSE, 0))->sampler = g_ripmap;
}
static void edit_slot_procedure_missing(shd_material_desc *d)
{
    add_slot(d, shd_slot_procedure(SHD_SLOT_SPECULAR, NULL, NULL));
}
static void edit_slot_attribute_7(shd_material_desc *d) { add_slot(d, shd_slot_vertex(SHD_SLOT_SPECULAR, 7)); }
static void edit_slot_attribute_8(shd_material_desc *d) { add_slot(d, shd_slot_vertex(SHD_SLOT_SPECULAR, 8)); }
static void edit_slot_uv_set_1(shd_material_desc *d) { add_texture(d, SHD_SLOT_EMISSION)->uv_set = 1; }
static void edit_slot_uv_set_2(shd_material_desc *d) { add_texture(d, SHD_SLOT_EMISSION)->uv_set = 2; }
static void edit_slot_channel_4(shd_material_desc *d) { add_texture(d, SHD_SLOT_EMISSION)->channel = 4; }
static void edit_slot_transform_nan(shd_material_desc *d)
{
    add_texture(d, SHD_SLOT_EMISSION)->uv_transform[4] = (float)NAN;
}
static shd_slot *add_solid(shd_material_desc *d, shd_slot_target target)
{
    static shd_solid_desc solid;
    solid = shd_solid_desc_default();
    return add_slot(d, shd_slot_solid(target, &solid));
}
static void edit_slot_solid(shd_material_desc *d) { add_solid(d, SHD_SLOT_DIFFUSE); }
static void edit_slot_solid_missing(shd_material_desc *d) { add_solid(d, SHD_SLOT_DIFFUSE)->solid = NULL; }
static void edit_slot_solid_of_vertex(shd_material_desc *d)
{
    add_solid(d, SHD_SLOT_DIFFUSE)->source = SHD_SLOT_SOURCE_VERTEX;
}
static void edit_slot_solid_texture(shd_material_desc *d) { add_solid(d, SHD_SLOT_DIFFUSE)->texture = g_texture; }
static void edit_slot_solid_octaves_0(shd_material_desc *d)
{
    static shd_solid_desc solid;
    solid = shd_solid_desc_default();
    solid.octaves = 0;
    add_slot(d, shd_slot_solid(SHD_SLOT_AMBIENT, &solid));
}
static void edit_slot_solid_channel_4(shd_material_desc *d) { add_solid(d, SHD_SLOT_OPACITY)->channel = 4; }
static void edit_slot_place_space_2(shd_material_desc *d)
{
    add_solid(d, SHD_SLOT_DIFFUSE)->place_space = (shd_place_space)2;
}
static void edit_slot_place_nan(shd_material_desc *d)
{
    add_solid(d, SHD_SLOT_DIFFUSE)->place_transform[13] = (float)NAN;
}
static void edit_slot_place_projects(shd_material_desc *d) { add_solid(d, SHD_SLOT_DIFFUSE)->place_transform[11] = 1; }
static void edit_slot_place_width(shd_material_desc *d) { add_solid(d, SHD_SLOT_DIFFUSE)->place_width = -1; }
static void edit_height_as_solid(shd_material_desc *d) { add_solid(d, SHD_SLOT_HEIGHT); }
static void edit_height_of_vertices(shd_material_desc *d) { add_slot(d, shd_slot_vertex(SHD_SLOT_HEIGHT, 0)); }
static void edit_matcap_as_procedure(shd_material_desc *d)
{
    add_slot(d, shd_slot_procedure(SHD_SLOT_MATCAP, NULL, NULL));
}
static void edit_slot_sampler_without_table(shd_material_desc *d)
{
    add_texture(d, SHD_SLOT_EMISSION)->sampler = g_ripmap;
}
static void edit_slots_missing(shd_material_desc *d) { d->slot_count = 1; }
static void edit_slots_all(shd_material_desc *d)
{
    int target;
    for (target = SHD_SLOT_TINT; target >= 0; --target) add_slot(d, constant((shd_slot_target)target));
}
static void edit_clearcoat_2(shd_material_desc *d) { d->clearcoat = 2.0f; }
static void edit_clearcoat_nan(shd_material_desc *d) { d->clearcoat = (float)NAN; }
static void edit_clearcoat_roughness(shd_material_desc *d) { d->clearcoat_roughness = -0.1f; }
static void edit_slots_18(shd_material_desc *d)
{
    edit_slots_all(d);
    d->slot_count = 18;
}
static void edit_slot_target_17(shd_material_desc *d) { add_texture(d, (shd_slot_target)17); }
static void edit_slot_target_twice(shd_material_desc *d)
{
    add_texture(d, SHD_SLOT_DIFFUSE);
    add_slot(d, constant(SHD_SLOT_DIFFUSE));
}
static void edit_slot_size_0(shd_material_desc *d) { add_slot(d, constant(SHD_SLOT_DIFFUSE))->struct_size = 0; }
static void edit_slot_sizes_differ(shd_material_desc *d) { --add_texture(d, SHD_SLOT_DIFFUSE)->struct_size; }

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
    {"create/struct_size_4", edit_size, BAD, "material.struct_size: 4"},
    {"create/unlit", edit_unlit, SHD_OK, ""},
    {"create/model_15", edit_model, BAD, "material.model: 15 is not in 0..11"},
    {"create/model_negative", edit_model_negative, BAD, "material.model: "},
    {"create/program_without_fragment", edit_program_missing, BAD,
     "material.program.fragment: NULL, but the model is SHD_MODEL_PROGRAM"},
    {"create/fragment_without_program", edit_program_unused, BAD,
     "material.program.fragment: set, but the model is not SHD_MODEL_PROGRAM"},
    {"create/flags_unknown", edit_flags_unknown, SHD_ERROR_UNSUPPORTED, "material.flags: bits 0x40 "},
    {"create/ambient_minus_1", edit_ambient_minus_1, SHD_OK, ""},
    {"create/ambient_minus_0", edit_ambient_minus_0, SHD_OK, ""},
    {"create/ambient_negative", edit_ambient_negative, BAD, "material.ambient[2]: -0.5 is not in 0..1e+06"},
    {"create/ambient_minus_2", edit_ambient_minus_2, BAD,
     "material.ambient[0]: -2 is not in 0..1e+06, and the channels are not all -1"},
    {"create/ambient_mixed", edit_ambient_mixed, BAD,
     "material.ambient[0]: -1 is not in 0..1e+06, and the channels are not all -1"},
    {"create/ambient_mixed_last", edit_ambient_mixed_last, BAD, "material.ambient[2]: -1 is not in 0..1e+06"},
    {"create/ambient_2e6", edit_ambient_above, BAD, "material.ambient[1]: 2e+06"},
    {"create/ambient_share_0", edit_ambient_share_0, SHD_OK, ""},
    {"create/ambient_share_1.5", edit_ambient_share_above, BAD, "material.ambient_share: 1.5 is not in 0..1"},
    {"create/ambient_share_nan", edit_ambient_share_nan, BAD, "material.ambient_share: "},
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
    {"create/interpolation_missing", edit_interpolation_missing, SHD_OK, ""},
    {"create/interpolation_beyond", edit_interpolation_beyond, SHD_OK, ""},
    {"create/light_as_texture", edit_light_as_texture, BAD, "material.slots[0].texture: not a live handle of its type"},
    {"create/light_as_sampler", edit_light_as_sampler, BAD, "material.slots[1].sampler: not a live handle of its type"},
    {"create/last_model", edit_last_model, SHD_OK, ""},
    {"create/last_view", edit_last_view, SHD_OK, ""},
    {"create/debug_view_5", edit_debug_view_5, BAD, "material.debug_view: 5 is not in 0..4"},
    {"create/view_of_program", edit_view_of_program, SHD_OK, ""},
    {"create/exponent_0", edit_exponent_0, SHD_OK, ""},
    {"create/exponent_1e6_of_metal", edit_exponent_1e6_of_metal, SHD_OK, ""},
    {"create/emission_1e12", edit_emission_1e12, SHD_OK, ""},
    {"create/emission_negative", edit_emission_negative, BAD, "material.emission[1]: -1e-06 is not in 0..1e+12"},
    {"create/emission_nan", edit_emission_nan, BAD, "material.emission[0]: "},
    {"create/metallic_1", edit_metallic_1, SHD_OK, ""},
    {"create/metallic_above", edit_metallic_above, BAD, "material.metallic: 1.001 is not in 0..1"},
    {"create/metallic_nan", edit_metallic_nan, BAD, "material.metallic: "},
    {"create/roughness_0", edit_roughness_0, SHD_OK, ""},
    {"create/roughness_negative", edit_roughness_negative, BAD, "material.roughness: -0.5 is not in 0..1"},
    {"create/roughness_inf", edit_roughness_inf, BAD, "material.roughness: inf"},
    {"create/ior_1", edit_ior_1, SHD_OK, ""},
    {"create/ior_0", edit_ior_0, BAD, "material.ior: 0 is not in 1..10"},
    {"create/ior_nan", edit_ior_nan, BAD, "material.ior: "},
    {"create/occlusion_strength_2", edit_occlusion_strength_2, BAD, "material.occlusion_strength: 2 is not in 0..1"},
    {"create/warm_negative", edit_warm_negative, BAD, "material.warm[0]: -1"},
    {"create/cool_inf", edit_cool_inf, BAD, "material.cool[2]: inf"},
    {"create/warm_mix_2", edit_warm_mix_2, BAD, "material.warm_mix: 2 is not in 0..1"},
    {"create/cool_mix_nan", edit_cool_mix_nan, BAD, "material.cool_mix: "},
    {"create/toon_steps_1", edit_toon_steps_1, SHD_OK, ""},
    {"create/toon_steps_0", edit_toon_steps_0, BAD, "material.toon_steps: 0 is not in 1..256"},
    {"create/toon_steps_257", edit_toon_steps_257, BAD, "material.toon_steps: 257"},
    {"create/normal_encoding_4", edit_normal_encoding_4, BAD, "material.normal_encoding: 4 is not in 0..3"},
    {"create/normal_scale_negative", edit_normal_scale_negative, SHD_OK, ""},
    {"create/normal_scale_nan", edit_normal_scale_nan, BAD, "material.normal_scale: "},
    {"create/normal_scale_2e3", edit_normal_scale_2e3, BAD, "material.normal_scale: 2000 is not in -1000..1000"},
    {"create/bump_3", edit_bump_3, BAD, "material.bump: 3 is not in 0..2"},
    {"create/bump_scale_1e30", edit_bump_scale_1e30, BAD, "material.bump_scale: 1e+30"},
    {"create/bump_scale_nan", edit_bump_scale_nan, BAD, "material.bump_scale: "},
    {"create/parallax_depth_negative", edit_parallax_depth_negative, BAD, "material.parallax_depth: -1"},
    {"create/parallax_steps_1", edit_parallax_steps_1, BAD, "material.parallax_steps: 1 is not in 2..256"},
    {"create/parallax_steps_257", edit_parallax_steps_257, BAD, "material.parallax_steps: 257"},
    {"create/slot_source_5", edit_slot_source_5, BAD, "material.slots[0].source: 5 is not in 0..4"},
    {"create/slot_texture_missing", edit_slot_texture_missing, BAD,
     "material.slots[1].texture: NULL, but the source is a texture"},
    {"create/slot_texture_of_constant", edit_slot_texture_of_constant, BAD,
     "material.slots[0].source: 0, but a texture or sampler is set"},
    {"create/slot_sampler_of_constant", edit_slot_sampler_of_constant, BAD,
     "material.slots[0].source: 0, but a texture or sampler is set"},
    {"create/slot_sampler_of_vertex", edit_slot_sampler_of_vertex, BAD,
     "material.slots[0].source: 2, but a texture or sampler is set"},
    {"create/slot_procedure_missing", edit_slot_procedure_missing, BAD, "material.slots[0].procedure: NULL"},
    {"create/slot_attribute_7", edit_slot_attribute_7, SHD_OK, ""},
    {"create/slot_attribute_8", edit_slot_attribute_8, BAD, "material.slots[0].attribute: 8 is not in 0..7"},
    {"create/slot_uv_set_1", edit_slot_uv_set_1, SHD_OK, ""},
    {"create/slot_uv_set_2", edit_slot_uv_set_2, BAD, "material.slots[1].uv_set: 2 is not in 0..1"},
    {"create/slot_channel_4", edit_slot_channel_4, BAD, "material.slots[1].channel: 4 is not in 0..3"},
    {"create/slot_transform_nan", edit_slot_transform_nan, BAD, "material.slots[1].uv_transform[4]: "},
    {"create/slot_solid", edit_slot_solid, SHD_OK, ""},
    {"create/slot_solid_missing", edit_slot_solid_missing, BAD, "material.slots[0].solid: NULL"},
    {"create/slot_solid_of_vertex", edit_slot_solid_of_vertex, BAD,
     "material.slots[0].source: 2, but a solid texture is set"},
    {"create/slot_solid_texture", edit_slot_solid_texture, BAD,
     "material.slots[0].source: 4, but a texture or sampler is set"},
    {"create/slot_solid_octaves_0", edit_slot_solid_octaves_0, BAD,
     "material.slots[0].solid.octaves: 0 is not in 1..32"},
    {"create/slot_solid_channel_4", edit_slot_solid_channel_4, BAD, "material.slots[0].channel: 4 is not in 0..3"},
    {"create/slot_place_space_2", edit_slot_place_space_2, BAD, "material.slots[0].place_space: 2 is not in 0..1"},
    {"create/slot_place_nan", edit_slot_place_nan, BAD, "material.slots[0].place_transform[13]: "},
    {"create/slot_place_projects", edit_slot_place_projects, BAD,
     "material.slots[0].place_transform: last row is (0, 0, 1, 1), not (0, 0, 0, 1)"},
    {"create/slot_place_width", edit_slot_place_width, BAD, "material.slots[0].place_width: -1 is not in 0..1000"},
    {"create/height_as_solid", edit_height_as_solid, BAD,
     "material.slots[0].source: 4, but this slot takes textures only"},
    {"create/height_of_vertices", edit_height_of_vertices, BAD,
     "material.slots[0].source: 2, but this slot takes textures only"},
    {"create/matcap_as_procedure", edit_matcap_as_procedure, BAD,
     "material.slots[0].source: 3, but this slot takes textures only"},
    {"create/slot_sampler_without_table", edit_slot_sampler_without_table, BAD,
     "material.slots[1].sampler.filter: RIPMAP, but the texture has no SHD_TABLE_RIPMAP"},
    {"create/slots_missing", edit_slots_missing, BAD, "material.slots: NULL"},
    {"create/slots_all", edit_slots_all, SHD_OK, ""},
    {"create/clearcoat_2", edit_clearcoat_2, BAD, "material.clearcoat: 2 is not in 0..1"},
    {"create/clearcoat_nan", edit_clearcoat_nan, BAD, "material.clearcoat: "},
    {"create/clearcoat_roughness", edit_clearcoat_roughness, BAD, "material.clearcoat_roughness: -0.1 is not in 0..1"},
    {"create/slots_18", edit_slots_18, BAD, "material.slot_count: 18 is not in 0..17"},
    {"create/slot_target_17", edit_slot_target_17, BAD, "material.slots[1].target: 17 is not in 0..16"},
    {"create/slot_target_twice", edit_slot_target_twice, BAD,
     "material.slots[2].target: 0 is that of material.slots[1] too"},
    {"create/slot_size_0", edit_slot_size_0, BAD, "material.slots[0].struct_size: 0 is below"},
    {"create/slot_sizes_differ", edit_slot_sizes_differ, BAD, "material.slots[1].struct_size: "},
};

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = (shd_material *)&desc;
    g_slots.count = 0;
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

/* The material keeps both alive, and releases both when its last reference is dropped. */
static void test_parts_retained(void **state)
{
    struct parts p;
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    shd_slot slot;
    (void)state;
    open_parts(&p);
    slot = shd_slot_texture(SHD_SLOT_DIFFUSE, p.texture, p.sampler);
    desc.slots = &slot;
    desc.slot_count = 1;
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

/* If the sampler is refused, a valid texture has one reference again. */
static void test_parts_after_refusal(void **state)
{
    struct parts p;
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = (shd_material *)&p;
    shd_slot slot;
    size_t before;
    (void)state;
    open_parts(&p);
    before = p.memory.live_bytes;
    slot = shd_slot_texture(SHD_SLOT_DIFFUSE, p.texture, (shd_sampler *)(void *)p.texture);
    desc.slots = &slot;
    desc.slot_count = 1;
    shd_assert_result("sampler", shd_material_create(p.context, &desc, &material), BAD,
                      "material.slots[0].sampler: not a live handle of its type");
    assert_null(material);
    assert_int_equal(p.memory.live_bytes, before);
    shd_assert_ok(look_up(&p));
    shd_texture_release(p.texture);
    shd_assert_result("texture", look_up(&p), BAD, "texture: not a live handle of its type");
    slot.sampler = p.sampler;
    shd_assert_result("released", shd_material_create(p.context, &desc, &material), BAD,
                      "material.slots[0].texture: not a live handle of its type");
    shd_sampler_release(p.sampler);
    shd_context_release(p.context);
    shd_assert_all_freed("parts_after_refusal", &p.memory);
}

/* A texture without a sampler is valid. */
static void test_one_part(void **state)
{
    struct parts p;
    shd_material_desc textured = shd_material_desc_default();
    shd_material *a = NULL;
    shd_slot slot;
    (void)state;
    open_parts(&p);
    slot = shd_slot_texture(SHD_SLOT_DIFFUSE, p.texture, NULL);
    textured.slots = &slot;
    textured.slot_count = 1;
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
    shd_sampler_desc ripmap = shd_sampler_desc_default();
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    if (shd_light_create(g_context, NULL, &g_light) != SHD_OK) return 1;
    if (make_texture(&g_texture) != SHD_OK) return 1;
    ripmap.filter = SHD_FILTER_RIPMAP;
    if (shd_sampler_create(g_context, &ripmap, &g_ripmap) != SHD_OK) return 1;
    for (i = 0; i < COUNT(k_create); ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    tests[n++] = (struct CMUnitTest){"create/null_desc", test_null_desc, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"parts/retained", test_parts_retained, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"parts/after_refusal", test_parts_after_refusal, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"parts/one_of_two", test_one_part, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.material", tests, n, NULL, NULL);
    shd_sampler_release(g_ripmap);
    shd_texture_release(g_texture);
    shd_light_release(g_light);
    shd_context_release(g_context);
    return failed;
}
