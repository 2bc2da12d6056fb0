// SPDX-License-Identifier: MIT
// Bounds of lookups: every legal texture unit is inside, units at the limits reach most of the interval, and shd's own
// filters are inside on every SIMD target.
#include "support/bounds_scene.h"
#include "support/simd.h"

namespace shd::tests
{
namespace
{

constexpr shd_rules kAllRules[] = {SHD_RULES_VULKAN, SHD_RULES_D3D11, SHD_RULES_WEBGPU, SHD_RULES_OPENGL};

void assert_inside(const Scene &scene, const SceneBounds &bounds, size_t i, const double (&value)[4], const char *who,
                   int rules)
{
    const int c = bounds.illegal(i, value);
    if (c < 0) return;
    const ref::UnitLookup at = scene.lookups.at(i);
    fail_msg(
        "%s, rules %d, format %d, filter %d, lookup %zu (%.9g %.9g %.9g, %g %g %g, %g %g %g, lod %g): channel %d is "
        "%.9g, not in %.9g..%.9g",
        who, rules, scene.kind.format, scene.image.sampler.filter, i, at.p[0], at.p[1], at.p[2], at.dx[0], at.dx[1],
        at.dx[2], at.dy[0], at.dy[1], at.dy[2], at.lod, c, value[c], double{bounds.lower.channel[c][i]},
        double{bounds.upper.channel[c][i]});
}

void sample_unit(const Scene &scene, const ref::Unit &unit, size_t i, double (&value)[4])
{
    const ref::Value out = ref::unit_sample(scene.image, unit, scene.lookups.at(i));
    for (size_t c = 0; c < 4; ++c) value[c] = out[c];
}

void test_legal(void **)
{
    Random random{11};
    for (shd_rules rules : kAllRules) {
        const shd_bounds_desc desc = preset(rules);
        const Scenes scenes(g_context, 96, 1 + static_cast<uint64_t>(rules));
        for (const Scene &scene : scenes.list) {
            const SceneBounds bounds(g_context, scene, desc);
            for (int k = 0; k < 24 / SHD_ORACLE_STRIDE; ++k) {
                const ref::Unit unit = legal_unit(desc, &random);
                for (size_t i = 0; i < scene.lookups.count(); ++i) {
                    double value[4];
                    sample_unit(scene, unit, i, value);
                    assert_inside(scene, bounds, i, value, "unit", rules);
                }
            }
        }
    }
}

/// Widths of bounds and of the values that random legal units reach, summed over lookups.
struct Widths {
    double bounds, reached;
};

void add_widths(const Scene &scene, const shd_bounds_desc &desc, int units, Random *random, Widths *sum)
{
    const SceneBounds bounds(g_context, scene, desc);
    std::vector<double> low(4 * scene.lookups.count(), HUGE_VAL), high(4 * scene.lookups.count(), -HUGE_VAL);
    for (int k = 0; k < units; ++k) {
        const ref::Unit unit = legal_unit(desc, random);
        for (size_t i = 0; i < scene.lookups.count(); ++i) {
            double value[4];
            sample_unit(scene, unit, i, value);
            for (size_t c = 0; c < 4; ++c) {
                low[4 * i + c] = fmin(low[4 * i + c], value[c]);
                high[4 * i + c] = fmax(high[4 * i + c], value[c]);
            }
        }
    }
    for (size_t i = 0; i < scene.lookups.count(); ++i) {
        for (size_t c = 0; c < 4; ++c) {
            sum->bounds += double{bounds.upper.channel[c][i]} - double{bounds.lower.channel[c][i]};
            sum->reached += high[4 * i + c] - low[4 * i + c];
        }
    }
}

struct Tight {
    shd_filter filter;
    double limit[4];  // by rules
};

void test_tight(void **)
{
    constexpr Tight kTight[] = {
        {SHD_FILTER_NEAREST, {1.1, 1.2, 1.1, 1.1}},       {SHD_FILTER_BILINEAR, {1.15, 1.6, 1.15, 1.15}},
        {SHD_FILTER_NEAREST_MIP, {1.1, 1.1, 1.1, 1.1}},   {SHD_FILTER_BILINEAR_MIP, {1.1, 1.1, 1.1, 1.1}},
        {SHD_FILTER_TRILINEAR, {1.15, 1.25, 1.15, 1.15}}, {SHD_FILTER_ANISOTROPIC, {1.7, 1.7, 1.7, 1.9}},
    };
    Random random{12};
    const Scenes scenes(g_context, 24, 9);
    for (shd_rules rules : kAllRules) {
        for (const Tight &row : kTight) {
            // Results are not rounded here: rounding adds a constant to the width, which no unit reaches everywhere.
            shd_bounds_desc desc = preset(rules);
            desc.result_bits = 0, desc.relative_error = 0;
            Widths sum = {0, 0};
            for (const Scene &scene : scenes.list) {
                if (scene.image.sampler.filter == row.filter) add_widths(scene, desc, 150, &random, &sum);
            }
            const double ratio = sum.bounds / sum.reached;
            print_message("rules %d, filter %d: bounds are %.3f times the reached values\n", rules, row.filter, ratio);
            if (!(ratio <= row.limit[rules])) fail_msg("rules %d, filter %d: ratio %g", rules, row.filter, ratio);
        }
    }
}

/// shd's own lookups. Profiles without 8-bit weights need no more room than units with 8 bits.
struct Own {
    shd_profile profile;
    shd_rules rules;
    shd_level_rules level_rules;
};

void check_own(shd_context *context, const Scene &scene, const Own &own, shd_precision precision,
               shd_magnification magnification)
{
    if (scene.image.sampler.filter == SHD_FILTER_ANISOTROPIC && magnification == SHD_MAGNIFICATION_NEAREST) return;
    Scene copy = {scene.kind, scene.pixels, scene.image, scene.lookups};
    copy.image.sampler.profile = own.profile;
    copy.image.sampler.precision = precision;
    copy.image.sampler.magnification = magnification;
    shd_bounds_desc desc = preset(own.rules);
    if (own.level_rules) desc.level_rules = own.level_rules;
    const SceneBounds bounds(g_context, copy, desc);
    shd_sampler *sampler = copy.sampler(context);
    const shd_lookups in = copy.lookups.columns();
    SceneValues values;
    shd_texels out = values.columns(in.count);
    shd_assert_ok(shd_texture_sample(scene.pixels->texture, sampler, &in, &out));
    shd_sampler_release(sampler);
    for (size_t i = 0; i < in.count; ++i) {
        double value[4];
        for (int c = 0; c < 4; ++c) value[c] = double{values.channel[c][i]};
        assert_inside(copy, bounds, i, value, precision ? "shd FAST" : "shd FULL", 10 * own.profile + own.rules);
    }
}

void test_own(void **)
{
    constexpr Own kOwn[] = {
        {SHD_PROFILE_VULKAN, SHD_RULES_VULKAN, 0},
        {SHD_PROFILE_VULKAN, SHD_RULES_WEBGPU, 0},
        {SHD_PROFILE_D3D11, SHD_RULES_VULKAN, 0},
        {SHD_PROFILE_D3D11, SHD_RULES_D3D11, 0},
        {SHD_PROFILE_D3D11, SHD_RULES_WEBGPU, 0},
        {SHD_PROFILE_EXACT, SHD_RULES_VULKAN, 0},
        {SHD_PROFILE_EXACT, SHD_RULES_D3D11, 0},
        {SHD_PROFILE_VULKAN, SHD_RULES_OPENGL, 0},
        {SHD_PROFILE_LEAST_ERROR, SHD_RULES_D3D11, SHD_LEVEL_RULE_PROFILE},
        {SHD_PROFILE_EXACT, SHD_RULES_D3D11, SHD_LEVEL_RULE_PROFILE},
        {SHD_PROFILE_VULKAN, SHD_RULES_D3D11, SHD_LEVEL_RULE_PROFILE},
        {SHD_PROFILE_D3D11, SHD_RULES_D3D11, SHD_LEVEL_RULE_PROFILE},
    };
    for (int simd = SHD_SIMD_BEST; simd < 32; ++simd) {
        if (!shd_simd_can_run(simd)) continue;
        shd_context_desc desc = shd_context_desc_default();
        desc.simd = static_cast<shd_simd>(simd);
        shd_context *context = nullptr;
        shd_assert_ok(shd_context_create(&desc, &context));
        {
            const Scenes scenes(context, SHD_IS_SANITIZED ? 24 : 96, 5);
            for (const Scene &scene : scenes.list) {
                for (const Own &own : kOwn) {
                    check_own(context, scene, own, SHD_PRECISION_FULL, SHD_MAGNIFICATION_DEFAULT);
                    check_own(context, scene, own, SHD_PRECISION_FAST, SHD_MAGNIFICATION_DEFAULT);
                    check_own(context, scene, own, SHD_PRECISION_FULL, SHD_MAGNIFICATION_NEAREST);
                    check_own(context, scene, own, SHD_PRECISION_FULL, SHD_MAGNIFICATION_BILINEAR);
                }
            }
        }
        shd_context_release(context);
    }
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_legal), cmocka_unit_test(test_tight),
                                       cmocka_unit_test(test_own)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
