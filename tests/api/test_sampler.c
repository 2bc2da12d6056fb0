/* SPDX-License-Identifier: MIT */
/* Sampler: every field's range, defaults, lifetime. */
#include "support/check.h"

#include <shd/shd.h>

struct create_case {
    const char *name;
    void (*edit)(shd_sampler_desc *desc);
    shd_result expected;
    const char *message;
};

static void edit_nothing(shd_sampler_desc *d) { (void)d; }
static void edit_size_zero(shd_sampler_desc *d) { d->struct_size = 0; }
static void edit_size_small(shd_sampler_desc *d) { d->struct_size = 7; }
static void edit_size_huge(shd_sampler_desc *d) { d->struct_size = 0x7fffffffu; }
static void edit_filter(shd_sampler_desc *d) { d->filter = (shd_filter)14; }
static void edit_filter_negative(shd_sampler_desc *d) { d->filter = (shd_filter)-1; }
static void edit_wrap_u(shd_sampler_desc *d) { d->wrap_u = (shd_wrap)5; }
static void edit_wrap_v(shd_sampler_desc *d) { d->wrap_v = SHD_WRAP_MAX_ENUM; }
static void edit_wrap_w(shd_sampler_desc *d) { d->wrap_w = SHD_WRAP_MIRROR_ONCE + 1; }
static void edit_all_border(shd_sampler_desc *d) { d->wrap_u = d->wrap_v = SHD_WRAP_BORDER; }
static void edit_border_nan(shd_sampler_desc *d) { d->border[0] = NAN; }
static void edit_border_infinite(shd_sampler_desc *d) { d->border[3] = -INFINITY; }
static void edit_border_large(shd_sampler_desc *d) { d->border[1] = 3e38f; }
static void edit_bias_15(shd_sampler_desc *d) { d->lod_bias = 15; }
static void edit_bias_16(shd_sampler_desc *d) { d->lod_bias = 16; }
static void edit_bias_1e30(shd_sampler_desc *d) { d->lod_bias = -1e30f; }
static void edit_bias_nan(shd_sampler_desc *d) { d->lod_bias = NAN; }
static void edit_min_negative(shd_sampler_desc *d) { d->lod_min = -0.5f; }
static void edit_min_33(shd_sampler_desc *d) { d->lod_min = 33; }
static void edit_max_infinite(shd_sampler_desc *d) { d->lod_max = INFINITY; }
static void edit_max_nan(shd_sampler_desc *d) { d->lod_max = NAN; }
static void edit_min_above_max(shd_sampler_desc *d)
{
    d->lod_min = 5;
    d->lod_max = 2;
}
static void edit_mirror_once(shd_sampler_desc *d) { d->wrap_u = d->wrap_v = SHD_WRAP_MIRROR_ONCE; }
static void edit_magnification(shd_sampler_desc *d) { d->magnification = (shd_magnification)5; }
static void edit_width_x_negative(shd_sampler_desc *d) { d->width_x = -1; }
static void edit_width_y_65(shd_sampler_desc *d) { d->width_y = 65; }
static void edit_width_nan(shd_sampler_desc *d) { d->width_x = NAN; }
static void edit_blur_u_2(shd_sampler_desc *d) { d->blur_u = 2; }
static void edit_blur_v_negative(shd_sampler_desc *d) { d->blur_v = -1e-9f; }
static void edit_anisotropy_0(shd_sampler_desc *d) { d->max_anisotropy = 0; }
static void edit_anisotropy_1(shd_sampler_desc *d) { d->max_anisotropy = 1; }
static void edit_anisotropy_64(shd_sampler_desc *d) { d->max_anisotropy = 64; }
static void edit_anisotropy_negative(shd_sampler_desc *d) { d->max_anisotropy = -16; }
static void edit_anisotropy_nan(shd_sampler_desc *d) { d->max_anisotropy = NAN; }
static void edit_anisotropy_1e9(shd_sampler_desc *d) { d->max_anisotropy = 1e9f; }
static void edit_max_texels_31(shd_sampler_desc *d) { d->max_texels = 31; }
static void edit_max_texels_32(shd_sampler_desc *d) { d->max_texels = 32; }
static void edit_max_texels_most(shd_sampler_desc *d) { d->max_texels = 0xffffffffu; }
static void edit_probe_slack_negative(shd_sampler_desc *d) { d->probe_slack = -0.25f; }
static void edit_probe_slack_nan(shd_sampler_desc *d) { d->probe_slack = NAN; }
static void edit_probe_slack_1(shd_sampler_desc *d) { d->probe_slack = 1; }
static void edit_level_blend_0(shd_sampler_desc *d) { d->level_blend = 0; }
static void edit_level_blend_1_5(shd_sampler_desc *d) { d->level_blend = 1.5f; }
static void edit_level_blend_nan(shd_sampler_desc *d) { d->level_blend = NAN; }
static void edit_probe_weights(shd_sampler_desc *d) { d->probe_weights = (shd_probe_weights)2; }
static void edit_cubic(shd_sampler_desc *d) { d->cubic = (shd_cubic)3; }
static void edit_box(shd_sampler_desc *d) { d->box = (shd_box)-1; }
static void edit_stochastic_cubic(shd_sampler_desc *d)
{
    d->filter = SHD_FILTER_STOCHASTIC;
    d->stochastic_filter = SHD_FILTER_BICUBIC;
}
static void edit_stochastic_ripmap(shd_sampler_desc *d) { d->stochastic_filter = SHD_FILTER_RIPMAP; }
static void edit_stochastic_quad(shd_sampler_desc *d)
{
    d->filter = SHD_FILTER_STOCHASTIC;
    d->stochastic = SHD_STOCHASTIC_QUAD;
    d->stochastic_filter = SHD_FILTER_ANISOTROPIC;
}
static void edit_stochastic_quad_ewa(shd_sampler_desc *d)
{
    edit_stochastic_quad(d);
    d->stochastic_filter = SHD_FILTER_EWA;
}
static void edit_stochastic_unknown(shd_sampler_desc *d) { d->stochastic = (shd_stochastic)2; }
static void edit_profile(shd_sampler_desc *d) { d->profile = SHD_PROFILE_OIIO; }
static void edit_profile_unknown(shd_sampler_desc *d) { d->profile = (shd_profile)5; }
static void edit_profile_negative(shd_sampler_desc *d) { d->profile = (shd_profile)-1; }
static void edit_tolerance_0(shd_sampler_desc *d) { d->tolerance = 0; }
static void edit_precision_fast(shd_sampler_desc *d) { d->precision = SHD_PRECISION_FAST; }
static void edit_precision_unknown(shd_sampler_desc *d) { d->precision = (shd_precision)2; }
static void edit_precision_negative(shd_sampler_desc *d) { d->precision = (shd_precision)-1; }
static void edit_tolerance_2(shd_sampler_desc *d) { d->tolerance = 2; }

static const struct create_case k_create[] = {
    {"create/defaults", edit_nothing, SHD_OK, ""},
    {"create/border", edit_all_border, SHD_OK, ""},
    {"create/border_3e38", edit_border_large, SHD_OK, ""},
    {"create/bias_15", edit_bias_15, SHD_OK, ""},
    {"create/lod_min_above_lod_max", edit_min_above_max, SHD_OK, ""},
    {"create/struct_size_zero", edit_size_zero, SHD_ERROR_INVALID_ARGUMENT, "sampler.struct_size: 0"},
    {"create/struct_size_small", edit_size_small, SHD_ERROR_INVALID_ARGUMENT, "sampler.struct_size"},
    {"create/struct_size_huge", edit_size_huge, SHD_ERROR_INVALID_ARGUMENT, "sampler.struct_size: 2147483647"},
    {"create/filter_unknown", edit_filter, SHD_ERROR_INVALID_ARGUMENT, "sampler.filter: 14 is not in 0..13"},
    {"create/filter_negative", edit_filter_negative, SHD_ERROR_INVALID_ARGUMENT, "sampler.filter: 4294967295"},
    {"create/wrap_u_unknown", edit_wrap_u, SHD_ERROR_INVALID_ARGUMENT, "sampler.wrap_u: 5 is not in 0..4"},
    {"create/wrap_v_unknown", edit_wrap_v, SHD_ERROR_INVALID_ARGUMENT, "sampler.wrap_v: 2147483647"},
    {"create/wrap_w_unknown", edit_wrap_w, SHD_ERROR_INVALID_ARGUMENT, "sampler.wrap_w: 5 is not in 0..4"},
    {"create/border_nan", edit_border_nan, SHD_ERROR_INVALID_ARGUMENT, "sampler.border[0]: nan is not finite"},
    {"create/border_infinite", edit_border_infinite, SHD_ERROR_INVALID_ARGUMENT, "sampler.border[3]: -inf"},
    {"create/bias_16", edit_bias_16, SHD_ERROR_INVALID_ARGUMENT, "sampler.lod_bias: 16 is not in -15..15"},
    {"create/bias_1e30", edit_bias_1e30, SHD_ERROR_INVALID_ARGUMENT, "sampler.lod_bias: -1e+30"},
    {"create/bias_nan", edit_bias_nan, SHD_ERROR_INVALID_ARGUMENT, "sampler.lod_bias: nan"},
    {"create/lod_min_negative", edit_min_negative, SHD_ERROR_INVALID_ARGUMENT, "sampler.lod_min: -0.5 is not in 0..32"},
    {"create/lod_min_33", edit_min_33, SHD_ERROR_INVALID_ARGUMENT, "sampler.lod_min: 33"},
    {"create/lod_max_infinite", edit_max_infinite, SHD_ERROR_INVALID_ARGUMENT, "sampler.lod_max: inf"},
    {"create/lod_max_nan", edit_max_nan, SHD_ERROR_INVALID_ARGUMENT, "sampler.lod_max: nan"},
    {"create/mirror_once", edit_mirror_once, SHD_OK, ""},
    {"create/anisotropy_1", edit_anisotropy_1, SHD_OK, ""},
    {"create/anisotropy_64", edit_anisotropy_64, SHD_OK, ""},
    {"create/magnification_unknown", edit_magnification, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.magnification: 5 is not in 0..4"},
    {"create/width_x_negative", edit_width_x_negative, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.width_x: -1 is not in 0..64"},
    {"create/width_y_65", edit_width_y_65, SHD_ERROR_INVALID_ARGUMENT, "sampler.width_y: 65"},
    {"create/width_nan", edit_width_nan, SHD_ERROR_INVALID_ARGUMENT, "sampler.width_x: nan"},
    {"create/blur_u_2", edit_blur_u_2, SHD_ERROR_INVALID_ARGUMENT, "sampler.blur_u: 2 is not in 0..1"},
    {"create/blur_v_negative", edit_blur_v_negative, SHD_ERROR_INVALID_ARGUMENT, "sampler.blur_v: -1e-09"},
    {"create/anisotropy_0", edit_anisotropy_0, SHD_ERROR_INVALID_ARGUMENT, "sampler.max_anisotropy: 0 is not in 1..64"},
    {"create/anisotropy_negative", edit_anisotropy_negative, SHD_ERROR_INVALID_ARGUMENT, "sampler.max_anisotropy: -16"},
    {"create/anisotropy_nan", edit_anisotropy_nan, SHD_ERROR_INVALID_ARGUMENT, "sampler.max_anisotropy: nan"},
    {"create/max_texels_31", edit_max_texels_31, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.max_texels: 31 is neither 0 nor 32 or more"},
    {"create/max_texels_32", edit_max_texels_32, SHD_OK, ""},
    {"create/max_texels_most", edit_max_texels_most, SHD_OK, ""},
    {"create/probe_slack_negative", edit_probe_slack_negative, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.probe_slack: -0.25 is not in 0..1"},
    {"create/probe_slack_nan", edit_probe_slack_nan, SHD_ERROR_INVALID_ARGUMENT, "sampler.probe_slack: nan"},
    {"create/probe_slack_1", edit_probe_slack_1, SHD_OK, ""},
    {"create/level_blend_0", edit_level_blend_0, SHD_OK, ""},
    {"create/level_blend_1.5", edit_level_blend_1_5, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.level_blend: 1.5 is not in 0..1"},
    {"create/level_blend_nan", edit_level_blend_nan, SHD_ERROR_INVALID_ARGUMENT, "sampler.level_blend: nan"},
    {"create/anisotropy_1e9", edit_anisotropy_1e9, SHD_ERROR_INVALID_ARGUMENT, "sampler.max_anisotropy: 1e+09"},
    {"create/probe_weights_unknown", edit_probe_weights, SHD_ERROR_INVALID_ARGUMENT, "sampler.probe_weights: 2"},
    {"create/cubic_unknown", edit_cubic, SHD_ERROR_INVALID_ARGUMENT, "sampler.cubic: 3 is not in 0..2"},
    {"create/box_unknown", edit_box, SHD_ERROR_INVALID_ARGUMENT, "sampler.box: 4294967295"},
    {"create/stochastic_catmull_rom", edit_stochastic_cubic, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.cubic: 0 is not SHD_CUBIC_B_SPLINE"},
    {"create/stochastic_quad", edit_stochastic_quad, SHD_OK, ""},
    {"create/stochastic_quad_ewa", edit_stochastic_quad_ewa, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.stochastic: SHD_STOCHASTIC_QUAD needs SHD_FILTER_TRILINEAR or SHD_FILTER_ANISOTROPIC, not "
     "sampler.stochastic_filter: 9"},
    {"create/stochastic_unknown", edit_stochastic_unknown, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.stochastic: 2 is not in 0..1"},
    {"create/stochastic_ripmap", edit_stochastic_ripmap, SHD_ERROR_INVALID_ARGUMENT, "sampler.stochastic_filter: 6"},
    {"create/profile_oiio", edit_profile, SHD_OK, ""},
    {"create/profile_unknown", edit_profile_unknown, SHD_ERROR_INVALID_ARGUMENT, "sampler.profile: 5 is not in 0..4"},
    {"create/profile_negative", edit_profile_negative, SHD_ERROR_INVALID_ARGUMENT, "sampler.profile: 4294967295"},
    {"create/tolerance_0", edit_tolerance_0, SHD_ERROR_INVALID_ARGUMENT, "sampler.tolerance: 0 is not in"},
    {"create/tolerance_2", edit_tolerance_2, SHD_ERROR_INVALID_ARGUMENT, "sampler.tolerance: 2"},
    {"create/precision_fast", edit_precision_fast, SHD_OK, ""},
    {"create/precision_unknown", edit_precision_unknown, SHD_ERROR_INVALID_ARGUMENT,
     "sampler.precision: 2 is not in 0..1"},
    {"create/precision_negative", edit_precision_negative, SHD_ERROR_INVALID_ARGUMENT, "sampler.precision: 4294967295"},
};

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_context *context = NULL;
    shd_sampler *sampler = (shd_sampler *)&desc;
    shd_assert_ok(shd_context_create(NULL, &context));
    c->edit(&desc);
    shd_assert_result(c->name, shd_sampler_create(context, &desc, &sampler), c->expected, c->message);
    if (c->expected == SHD_OK) {
        assert_non_null(sampler);
    } else {
        assert_null(sampler);
    }
    shd_sampler_release(sampler);
    shd_context_release(context);
}

static void test_null_arguments(void **state)
{
    shd_context *context = NULL;
    shd_sampler *sampler = (shd_sampler *)&context;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_result("out", shd_sampler_create(context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_sampler: NULL");
    shd_assert_result("context", shd_sampler_create(NULL, NULL, &sampler), SHD_ERROR_INVALID_ARGUMENT, "context: NULL");
    assert_null(sampler);
    shd_sampler_retain(NULL);
    shd_sampler_release(NULL);
    shd_context_release(context);
}

static void test_null_desc_and_lifetime(void **state)
{
    shd_context *context = NULL;
    shd_sampler *sampler = NULL;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_ok(shd_sampler_create(context, NULL, &sampler));
    shd_sampler_retain(sampler);
    shd_sampler_release(sampler);
    shd_context_release(context); /* the sampler retains the context */
    shd_sampler_release(sampler);
}

static void test_newer_desc(void **state)
{
    struct {
        shd_sampler_desc desc;
        uint32_t later;
    } newer = {shd_sampler_desc_default(), 0};
    shd_context *context = NULL;
    shd_sampler *sampler = NULL;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    newer.desc.struct_size = (uint32_t)sizeof newer;
    shd_assert_ok(shd_sampler_create(context, &newer.desc, &sampler));
    shd_sampler_release(sampler);
    newer.later = 1;
    shd_assert_result("tail", shd_sampler_create(context, &newer.desc, &sampler), SHD_ERROR_UNSUPPORTED,
                      "sampler: byte");
    assert_null(sampler);
    shd_context_release(context);
}

int main(void)
{
    struct CMUnitTest tests[64];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_create / sizeof k_create[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null_arguments, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"null_desc_and_lifetime", test_null_desc_and_lifetime, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"newer_desc", test_newer_desc, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.sampler", tests, n, NULL, NULL);
}
