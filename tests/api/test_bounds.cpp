// SPDX-License-Identifier: MIT
// Bounds of lookups: every legal texture unit is inside, units at the limits reach most of the interval, and shd's own
// filters are inside on every SIMD target.
#include "support/bounds_scene.h"
#include "support/level_texture.h"
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

/// Textures of one limit: 2D and cubes, 3D, or images of directions that fold at their edges. Few random units are at
/// the limits of all three axes of a 3D texture.
enum class Kind { kFlat, kDeep, kFolded };

Kind kind_of(const SceneTexture &texture)
{
    if (texture.depth) return Kind::kDeep;
    return texture.has_directions() && texture.projection != SHD_PROJECTION_CUBE ? Kind::kFolded : Kind::kFlat;
}

struct Tight {
    Kind kind;
    shd_filter filter;
    double limit[4];  // by rules
};

void test_tight(void **)
{
    constexpr Tight kTight[] = {
        {Kind::kFlat, SHD_FILTER_NEAREST, {1.05, 1.05, 1.05, 1.05}},
        {Kind::kFlat, SHD_FILTER_BILINEAR, {1.15, 1.6, 1.15, 1.15}},
        {Kind::kFlat, SHD_FILTER_NEAREST_MIP, {1.1, 1.1, 1.1, 1.1}},
        {Kind::kFlat, SHD_FILTER_BILINEAR_MIP, {1.1, 1.1, 1.1, 1.1}},
        {Kind::kFlat, SHD_FILTER_TRILINEAR, {1.15, 1.25, 1.15, 1.15}},
        {Kind::kFlat, SHD_FILTER_ANISOTROPIC, {1.7, 1.7, 1.7, 1.9}},
        {Kind::kDeep, SHD_FILTER_NEAREST, {1.1, 1.1, 1.1, 1.1}},
        {Kind::kDeep, SHD_FILTER_BILINEAR, {1.2, 1.9, 1.2, 1.2}},
        {Kind::kDeep, SHD_FILTER_NEAREST_MIP, {1.1, 1.1, 1.1, 1.1}},
        {Kind::kDeep, SHD_FILTER_BILINEAR_MIP, {1.1, 1.1, 1.1, 1.1}},
        {Kind::kDeep, SHD_FILTER_TRILINEAR, {1.15, 1.25, 1.15, 1.15}},
        {Kind::kDeep, SHD_FILTER_ANISOTROPIC, {1.7, 1.7, 1.75, 2.1}},
        {Kind::kFolded, SHD_FILTER_NEAREST, {1.05, 1.05, 1.05, 1.05}},
        {Kind::kFolded, SHD_FILTER_BILINEAR, {1.15, 1.9, 1.15, 1.15}},
        {Kind::kFolded, SHD_FILTER_NEAREST_MIP, {1.1, 1.1, 1.1, 1.1}},
        {Kind::kFolded, SHD_FILTER_BILINEAR_MIP, {1.1, 1.1, 1.1, 1.1}},
        {Kind::kFolded, SHD_FILTER_TRILINEAR, {1.15, 1.45, 1.15, 1.2}},
        {Kind::kFolded, SHD_FILTER_ANISOTROPIC, {2.0, 2.3, 2.1, 2.3}},
    };
    const Scenes scenes(g_context, 24, 9);
    for (const Tight &row : kTight) {
        Random random{12};
        for (shd_rules rules : kAllRules) {
            // Results are not rounded here: rounding adds a constant to the width, which no unit reaches everywhere.
            shd_bounds_desc desc = preset(rules);
            desc.result_bits = 0, desc.relative_error = 0;
            Widths sum = {0, 0};
            for (const Scene &scene : scenes.list) {
                if (kind_of(scene.kind) != row.kind || scene.image.sampler.filter != row.filter) continue;
                add_widths(scene, desc, 150, &random, &sum);
            }
            const double ratio = sum.bounds / sum.reached;
            print_message("kind %d, filter %d, rules %d: bounds are %.3f times the reached values\n",
                          static_cast<int>(row.kind), row.filter, rules, ratio);
            if (!(ratio <= row.limit[rules])) fail_msg("rules %d, filter %d: ratio %g", rules, row.filter, ratio);
        }
    }
}

/// Legal levels of one trilinear lookup of a cube of 16 x 16 texels, whose coarsest level is 4.
struct LevelCase {
    const char *name;
    double x[2], y[2];  // derivatives in texels of the face
    float lod;          // level in place of them, or -1
    float bias;
    shd_level_rule_flags rules;
    float level_error;
    double low, high;
};
constexpr float kDefaultError = 1.0f / 1024.0f;
constexpr shd_level_rule_flags kLengths = SHD_LEVEL_RULE_LENGTHS,
                               kVulkan = kLengths | SHD_LEVEL_RULE_ELLIPSE | SHD_LEVEL_RULE_VULKAN;
const LevelCase kLevelCases[] = {
    {"lod_on_grid", {}, {}, 3.0f, 0.0f, kVulkan, 0.0f, 3.0, 3.0},
    {"lod_below_grid", {}, {}, 2.9999998f, 0.0f, kVulkan, 0.0f, 2.9375, 3.0},
    {"lod_above_grid", {}, {}, 3.0000002f, 0.0f, kVulkan, 0.0f, 3.0, 3.0625},
    {"lod_error", {}, {}, 3.0f, 0.0f, kVulkan, kDefaultError, 2.9375, 3.0625},
    {"lengths_on_grid", {4, 0}, {0, -2}, -1.0f, 0.0f, kLengths, 0.0f, 2.0, 2.0},
    {"lengths_below_grid", {3.999999, 0}, {0, 2}, -1.0f, 0.0f, kLengths, 0.0f, 1.9375, 2.0},
    {"ellipse_on_grid", {4, 0}, {0, 4}, -1.0f, 0.0f, SHD_LEVEL_RULE_ELLIPSE, 0.0f, 2.0, 2.0},
    {"approximations_on_grid", {0, 4}, {4, 0}, -1.0f, 0.0f, kVulkan, 0.0f, 2.0, 2.5},
    {"longer_than_face", {32, 0}, {0, 0}, -1.0f, -2.0f, kLengths, kDefaultError, 2.9375, 3.0625},
    {"longer_than_faces", {0, 0}, {0, 256}, -1.0f, -4.0f, kLengths, 0.0f, 4.0, 4.0},
    {"approximations_of_face", {16, 0}, {0, 0}, -1.0f, -1.0f, kVulkan, kDefaultError, 2.9375, 3.5625},
    {"far", {1e30, 0}, {0, 0}, -1.0f, -15.0f, kVulkan, kDefaultError, 4.0, 4.0},
    {"infinite", {0, 0}, {0, HUGE_VAL}, -1.0f, -15.0f, kVulkan, kDefaultError, 4.0, 4.0},
};

void test_levels(void **)
{
    const LevelTexture texture(g_context, SHD_PROJECTION_CUBE, 16);
    for (const LevelCase &row : kLevelCases) {
        shd_sampler_desc sampler_desc = shd_sampler_desc_default();
        sampler_desc.lod_bias = row.bias;
        shd_sampler *sampler = nullptr;
        shd_assert_ok(shd_sampler_create(g_context, &sampler_desc, &sampler));
        // On +X, u = (1 - z / x) / 2 and v = (1 - y / x) / 2.
        const float n[3] = {1.0f, 0.25f, -0.5f};
        const float y[2] = {static_cast<float>(-row.x[1] / 8), static_cast<float>(-row.y[1] / 8)};
        const float z[2] = {static_cast<float>(-row.x[0] / 8), static_cast<float>(-row.y[0] / 8)};
        shd_lookups in = shd_lookups_default();
        in.count = 1;
        in.u = shd_f32_column(n, 0), in.v = shd_f32_column(n + 1, 0), in.w = shd_f32_column(n + 2, 0);
        in.dvdx = shd_f32_column(y, 0), in.dvdy = shd_f32_column(y + 1, 0);
        in.dwdx = shd_f32_column(z, 0), in.dwdy = shd_f32_column(z + 1, 0);
        if (row.lod >= 0.0f) in.lod = shd_f32_column(&row.lod, 0);
        shd_bounds_desc desc = shd_bounds_desc_default();
        desc.level_rules = row.rules, desc.level_error = row.level_error;
        desc.relative_error = 0.0f;
        float low, high;
        shd_texels lower = shd_texels_default(), upper = shd_texels_default();
        lower.channel[0] = shd_f32_out_column(&low, 0), upper.channel[0] = shd_f32_out_column(&high, 0);
        shd_assert_ok(shd_texture_bounds(texture.texture, sampler, &in, &desc, &lower, &upper));
        shd_sampler_release(sampler);
        if (fabs(double{low} - row.low) < 1e-6 && fabs(double{high} - row.high) < 1e-6) continue;
        fail_msg("%s: %.9g..%.9g instead of %g..%g", row.name, double{low}, double{high}, row.low, row.high);
    }
}

/// Legal levels of one trilinear lookup of a 3D texture of 16 x 8 x 32 texels.
struct DeepLevelCase {
    const char *name;
    double x[3], y[3];  // derivatives in texels
    shd_level_rule_flags rules;
    double low, high;
};
const DeepLevelCase kDeepLevelCases[] = {
    {"lengths_of_w", {0, 0, 4}, {1, 0, 0}, kLengths, 2.0, 2.0},
    {"lengths_of_all", {2, 4, 4}, {0, 0, 0}, kLengths, 2.5625, 2.625},  // log2 6
    {"ellipse_of_w", {0, 0, -4}, {0, 4, 0}, SHD_LEVEL_RULE_ELLIPSE, 2.0, 2.0},
    {"ellipse_of_all", {2, 2, 0}, {2, 0, 2}, SHD_LEVEL_RULE_ELLIPSE, 1.75, 1.8125},  // log2 sqrt(12)
    {"vulkan_of_all", {2, 2, 2}, {0, 0, 0}, SHD_LEVEL_RULE_VULKAN, 1.0, 3.125},      // 2..6 sqrt(2)
    {"opengl_of_all", {4, 0, 1}, {0, 2, 2}, SHD_LEVEL_RULE_OPENGL, 2.0, 3.0},        // 4..8
    {"profile_of_all", {0, 0, 8}, {0, 0, 0}, SHD_LEVEL_RULE_PROFILE, 3.0, 3.0},
    {"infinite_w", {0, 0, HUGE_VAL}, {0, 0, 0}, kVulkan, 5.0, 5.0},
};

/// A 3D texture whose texels have the number of their level.
struct DeepLevels {
    shd_texture *texture = nullptr;

    DeepLevels()
    {
        std::vector<std::vector<float>> pixels;
        std::vector<shd_image> images;
        for (uint32_t l = 0; l < 6; ++l) {
            pixels.emplace_back(16 * 8 * 32, static_cast<float>(l));
            for (uint32_t z = 0; l > 0 && z < 32u >> l; ++z) {
                shd_image image = shd_image_default();
                image.format = SHD_FORMAT_R32F, image.pixels = pixels.back().data();
                image.width = std::max(16u >> l, 1u), image.height = std::max(8u >> l, 1u);
                images.push_back(image);
            }
        }
        shd_texture_desc desc = shd_texture_desc_default();
        desc.format = SHD_FORMAT_R32F, desc.width = 16, desc.height = 8, desc.depth = 32;
        desc.kind = SHD_TEXTURE_KIND_3D;
        desc.texels = pixels[0].data(), desc.tables = SHD_TABLE_MIPMAP;
        desc.level_images = images.data(), desc.level_count = 5;
        shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    }
    ~DeepLevels() { shd_texture_release(texture); }
};

void test_deep_levels(void **)
{
    const DeepLevels levels;
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    sampler_desc.profile = SHD_PROFILE_EXACT;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(g_context, &sampler_desc, &sampler));
    const float point[3] = {0.3f, 0.4f, 0.6f}, size[3] = {16, 8, 32};
    for (const DeepLevelCase &row : kDeepLevelCases) {
        float x[3], y[3];
        for (int c = 0; c < 3; ++c) {
            x[c] = static_cast<float>(row.x[c]) / size[c];
            y[c] = static_cast<float>(row.y[c]) / size[c];
        }
        shd_lookups in = shd_lookups_default();
        in.count = 1;
        in.u = shd_f32_column(point, 0), in.v = shd_f32_column(point + 1, 0), in.w = shd_f32_column(point + 2, 0);
        in.dudx = shd_f32_column(x, 0), in.dvdx = shd_f32_column(x + 1, 0), in.dwdx = shd_f32_column(x + 2, 0);
        in.dudy = shd_f32_column(y, 0), in.dvdy = shd_f32_column(y + 1, 0), in.dwdy = shd_f32_column(y + 2, 0);
        shd_bounds_desc desc = shd_bounds_desc_default();
        desc.level_rules = row.rules, desc.level_error = desc.relative_error = 0.0f;
        float low, high;
        shd_texels lower = shd_texels_default(), upper = shd_texels_default();
        lower.channel[0] = shd_f32_out_column(&low, 0), upper.channel[0] = shd_f32_out_column(&high, 0);
        shd_assert_ok(shd_texture_bounds(levels.texture, sampler, &in, &desc, &lower, &upper));
        if (fabs(double{low} - row.low) < 1e-6 && fabs(double{high} - row.high) < 1e-6) continue;
        fail_msg("%s: %.9g..%.9g instead of %g..%g", row.name, double{low}, double{high}, row.low, row.high);
    }
    shd_sampler_release(sampler);
}

/// shd's own lookups. Profiles without 8-bit weights need no more room than units with 8 bits.
struct Own {
    shd_profile profile;
    shd_rules rules;
    shd_level_rule_flags level_rules;
};

void check_own(shd_context *context, const Scene &scene, const Own &own, shd_precision precision,
               shd_magnification magnification)
{
    if (scene.image.sampler.filter == SHD_FILTER_ANISOTROPIC && magnification == SHD_MAGNIFICATION_NEAREST) return;
    const bool foreign = own.profile != SHD_PROFILE_LEAST_ERROR && own.profile != SHD_PROFILE_EXACT;
    if (scene.kind.depth && foreign) return;
    if (scene.image.sampler.filter == SHD_FILTER_ANISOTROPIC && precision == SHD_PRECISION_FAST && !foreign) return;
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
                                       cmocka_unit_test(test_levels), cmocka_unit_test(test_deep_levels),
                                       cmocka_unit_test(test_own)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
