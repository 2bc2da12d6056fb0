// SPDX-License-Identifier: MIT
// Comparison lookups through the public headers: values, swizzles, explanations, bounds, tiles and messages.
// tests/unit/texture/test_comparison.cpp compares every filter, format and target with the definition.
#include <cmath>
#include <cstring>
#include <vector>

#include <shd/shd.h>

#include "support/check.h"
#include "support/context.h"
#include "support/random.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

constexpr uint8_t kTexels[] = {0, 51, 102, 255};  // 0, 0.2, 0.4, 1

/// A texture of 4 x 1 texels, a sampler that compares, and lookups at the texels.
struct Fixture {
    shd_texture *texture = nullptr;
    shd_sampler *sampler = nullptr;
    float u[4] = {0.125f, 0.375f, 0.625f, 0.875f}, v[4] = {0.5f, 0.5f, 0.5f, 0.5f}, reference[4] = {};
    float out[4][4] = {}, low[4][4] = {}, high[4][4] = {};

    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();

    Fixture()
    {
        texture_desc.format = SHD_FORMAT_R8;
        texture_desc.width = 4, texture_desc.height = 1;
        texture_desc.texels = kTexels;
        sampler_desc.filter = SHD_FILTER_NEAREST;
        sampler_desc.wrap_u = sampler_desc.wrap_v = SHD_WRAP_CLAMP;
        sampler_desc.compares = 1;
    }
    void open()
    {
        shd_assert_ok(shd_texture_create(g_context, &texture_desc, &texture));
        shd_assert_ok(shd_sampler_create(g_context, &sampler_desc, &sampler));
    }
    void close()
    {
        shd_texture_release(texture);
        shd_sampler_release(sampler);
    }
    shd_lookups lookups() const
    {
        shd_lookups in = shd_lookups_default();
        in.count = 4;
        in.u = shd_f32_column(u, 0), in.v = shd_f32_column(v, 0), in.reference = shd_f32_column(reference, 0);
        return in;
    }
    static shd_texels texels(float (&to)[4][4])
    {
        shd_texels out = shd_texels_default();
        for (int c = 0; c < 4; ++c) out.channel[c] = shd_f32_out_column(to[c], 0);
        return out;
    }
    shd_result sample()
    {
        const shd_lookups in = lookups();
        shd_texels to = texels(out);
        return shd_texture_sample(texture, sampler, &in, &to);
    }
    shd_result bounds(const shd_bounds_desc *desc)
    {
        const shd_lookups in = lookups();
        shd_texels lower = texels(low), upper = texels(high);
        return shd_texture_bounds(texture, sampler, &in, desc, &lower, &upper);
    }
};

struct Operation {
    shd_compare compare;
    float want[4];  // reference 0.4f against 0, 0.2, 0.4 and 1
    float nan;
};
constexpr Operation kOperations[] = {
    {SHD_COMPARE_LESS, {0, 0, 0, 1}, 0},    {SHD_COMPARE_LESS_EQUAL, {0, 0, 1, 1}, 0},
    {SHD_COMPARE_EQUAL, {0, 0, 1, 0}, 0},   {SHD_COMPARE_GREATER_EQUAL, {1, 1, 1, 0}, 0},
    {SHD_COMPARE_GREATER, {1, 1, 0, 0}, 0}, {SHD_COMPARE_NOT_EQUAL, {1, 1, 0, 1}, 0},
    {SHD_COMPARE_ALWAYS, {1, 1, 1, 1}, 1},  {SHD_COMPARE_NEVER, {0, 0, 0, 0}, 0},
};

void test_operations(void **)
{
    for (const Operation &row : kOperations) {
        Fixture f;
        f.sampler_desc.compare = row.compare;
        f.open();
        for (float &reference : f.reference) reference = 0.4f;
        shd_assert_ok(f.sample());
        assert_memory_equal(f.out[0], row.want, sizeof row.want);
        for (int i = 0; i < 4; ++i) assert_true(f.out[1][i] == 0 && f.out[2][i] == 0 && f.out[3][i] == 1);
        for (float &reference : f.reference) reference = NAN;
        shd_assert_ok(f.sample());
        for (float value : f.out[0]) assert_true(value == row.nan);
        f.close();
    }
}

/// The reference is clamped to [0, 1] before it is compared with 1, 0 and the border.
void test_clamp(void **)
{
    Fixture f;
    f.sampler_desc.compare = SHD_COMPARE_EQUAL;
    f.sampler_desc.wrap_u = SHD_WRAP_BORDER;
    f.sampler_desc.border[0] = 1.5f;
    f.open();
    const float references[] = {-3.0f, 0.2f, 7.0f, INFINITY};
    f.u[2] = 0.875f, f.u[3] = 2.0f;  // the border
    std::memcpy(f.reference, references, sizeof references);
    shd_assert_ok(f.sample());
    assert_true(f.out[0][0] == 1 && f.out[0][1] == 1 && f.out[0][2] == 1 && f.out[0][3] == 0);
    f.close();
    f.texture_desc.format = SHD_FORMAT_R32F;
    const float floats[] = {-3, 0.2f, 1, INFINITY};
    f.texture_desc.texels = floats;
    f.open();
    f.u[3] = 0.875f;
    shd_assert_ok(f.sample());
    assert_true(f.out[0][0] == 1 && f.out[0][1] == 1 && f.out[0][2] == 0 && f.out[0][3] == 1);
    f.close();
}

/// Bilinear lookups blend the comparisons, not the texels.
void test_blend(void **)
{
    Fixture f;
    f.sampler_desc.filter = SHD_FILTER_BILINEAR;
    f.open();
    for (int i = 0; i < 4; ++i) f.reference[i] = 0.3f, f.u[i] = 0.375f + 0.0625f * static_cast<float>(i);
    shd_assert_ok(f.sample());  // 0.3 < 0.2 is false, 0.3 < 0.4 is true
    for (int i = 0; i < 4; ++i) assert_true(f.out[0][i] == 0.25f * static_cast<float>(i));
    f.close();
}

/// r is the swizzled channel, or a constant.
void test_swizzle(void **)
{
    const uint8_t texels[] = {0, 255, 51, 204, 102, 153, 255, 0};
    Fixture f;
    f.texture_desc.format = SHD_FORMAT_RG8;
    f.texture_desc.texels = texels;
    f.texture_desc.swizzle[0] = SHD_CHANNEL_G;
    for (float &reference : f.reference) reference = 0.7f;
    f.open();
    shd_assert_ok(f.sample());
    assert_true(f.out[0][0] == 1 && f.out[0][1] == 1 && f.out[0][2] == 0 && f.out[0][3] == 0);
    assert_true(f.out[3][0] == 1);
    f.close();
    f.texture_desc.swizzle[0] = SHD_CHANNEL_FILL;
    f.texture_desc.fill[0] = 0.5f;
    f.reference[0] = 0.25f;
    f.open();
    shd_assert_ok(f.sample());
    assert_true(f.out[0][0] == 1 && f.out[0][1] == 0 && f.out[0][2] == 0 && f.out[0][3] == 0);
    shd_assert_ok(f.bounds(nullptr));
    assert_true(f.low[0][0] == 1 && f.high[0][0] == 1 && f.low[0][1] == 0 && f.high[0][1] == 0);
    f.close();
}

/// The taps of an explanation are 0 or 1, and their blends give the result.
void test_explanation(void **)
{
    Fixture f;
    f.sampler_desc.filter = SHD_FILTER_BILINEAR;
    f.open();
    for (int i = 0; i < 4; ++i) f.reference[i] = 0.15f * static_cast<float>(i), f.u[i] = 0.3f + 0.1f * f.u[i];
    shd_assert_ok(f.sample());
    const shd_lookups in = f.lookups();
    for (size_t i = 0; i < 4; ++i) {
        shd_tap taps[4];
        shd_explanation e = shd_explanation_default();
        e.taps = taps, e.tap_capacity = 4;
        shd_assert_ok(shd_texture_explain(f.texture, f.sampler, &in, i, &e));
        assert_int_equal(e.tap_count, 4);
        float sum = 0;
        for (const shd_tap &tap : taps) {
            assert_true(tap.value[0] == (f.reference[i] < kTexels[tap.x] / 255.0f ? 1.0f : 0.0f));
            sum += tap.weight * tap.value[0];
        }
        shd_assert_close("explanation", i, double{sum}, double{f.out[0][i]}, 1e-6, 0);
        assert_true(e.result[0] == f.out[0][i] && e.result[1] == 0 && e.result[2] == 0 && e.result[3] == 1);
        assert_true(e.channel_source[0] == 0 && e.channel_source[3] == 4 && e.scale_high[0] == 1 &&
                    e.scale_low[0] == 0);
    }
    f.close();
}

/// Bounds of comparisons are those of a texture of the numbers, except where the reference may round to a texel.
void test_bounds(void **)
{
    Random random{3};
    for (shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR}) {
        for (const Operation &row : kOperations) {
            Fixture f, numbers;
            float number[4];
            f.sampler_desc.filter = numbers.sampler_desc.filter = filter;
            f.sampler_desc.compare = row.compare;
            numbers.sampler_desc.compares = 0;
            for (int i = 0; i < 4; ++i) f.u[i] = numbers.u[i] = random.real(0, 1);
            for (float &reference : f.reference) reference = 0.3f;
            const bool less = row.want[3] != 0, greater = row.want[0] != 0;
            for (int i = 0; i < 4; ++i) number[i] = (i < 2 ? greater : less) ? 1.0f : 0.0f;
            numbers.texture_desc.format = SHD_FORMAT_R32F;
            numbers.texture_desc.texels = number;
            f.open();
            numbers.open();
            shd_bounds_desc desc = shd_bounds_desc_default();
            desc.result_bits = 0;
            shd_assert_ok(f.bounds(&desc));
            shd_assert_ok(numbers.bounds(&desc));
            assert_memory_equal(f.low, numbers.low, sizeof f.low);
            assert_memory_equal(f.high, numbers.high, sizeof f.high);
            shd_assert_ok(f.sample());
            for (int i = 0; i < 4; ++i) assert_true(f.low[0][i] <= f.out[0][i] && f.out[0][i] <= f.high[0][i]);
            f.close();
            numbers.close();
        }
    }
}

/// Within half a step of a texel, and for NaN, both results are legal, except of ALWAYS and NEVER.
void test_bounds_of_reference(void **)
{
    for (const Operation &row : kOperations) {
        Fixture f;
        f.sampler_desc.compare = row.compare;
        f.open();
        f.u[1] = f.u[2] = f.u[3] = f.u[0] = 0.375f;  // 51
        const float references[] = {51.4f / 255, 50.6f / 255, NAN, 51.6f / 255};
        std::memcpy(f.reference, references, sizeof references);
        shd_bounds_desc desc = shd_bounds_desc_default();
        desc.result_bits = 0, desc.relative_error = 0;
        shd_assert_ok(f.bounds(&desc));
        const bool less = row.want[3] != 0, equal = row.want[2] != 0, greater = row.want[0] != 0;
        const auto check = [&](int i, bool a, bool b, bool c) {
            const float low = a && b && c ? 1.0f : 0.0f, high = a || b || c ? 1.0f : 0.0f;
            assert_true(std::fabs(f.low[0][i] - low) < 1e-6f && std::fabs(f.high[0][i] - high) < 1e-6f);
        };
        check(0, greater, equal, less);
        check(1, greater, equal, less);
        check(2, greater, equal, less);
        check(3, greater, greater, greater);
        f.close();
    }
}

/// Tiles have the bits of a texture in memory; where no tile is resident, r is 0.
void test_tiles(void **)
{
    Random random{9};
    std::vector<uint8_t> texels(70 * 33 * 2);
    for (uint8_t &texel : texels) texel = static_cast<uint8_t>(random.whole(0, 255));
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_R16;
    desc.width = 70, desc.height = 33;
    desc.texels = texels.data();
    desc.tables = SHD_TABLE_MIPMAP;
    shd_texture *texture = nullptr, *tiled = nullptr;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    TileSource source(texture);
    shd_tile_cache *cache = make_tile_cache(g_context, 1024, 1 << 20);
    const shd_texture_desc tiled_desc = source.desc(desc, texture, cache);
    shd_assert_ok(shd_texture_create(g_context, &tiled_desc, &tiled));
    constexpr size_t kCount = 293;
    std::vector<float> column[5], got(kCount), want(kCount);
    for (auto &values : column) {
        for (size_t i = 0; i < kCount; ++i) values.push_back(random.real(0, 1));
    }
    for (float &x : column[3]) x *= 0.1f;
    shd_lookups in = shd_lookups_default();
    in.count = kCount;
    in.u = shd_f32_column(column[0].data(), 0), in.v = shd_f32_column(column[1].data(), 0);
    in.reference = shd_f32_column(column[2].data(), 0);
    in.dudx = in.dvdy = shd_f32_column(column[3].data(), 0);
    for (shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_NEAREST_MIP_LINEAR, SHD_FILTER_BILINEAR_MIP,
                              SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC}) {
        for (const bool coarser : {true, false}) {
            shd_sampler_desc sd = shd_sampler_desc_default();
            sd.filter = filter;
            sd.compares = 1;
            sd.missing_tiles = coarser ? SHD_MISSING_TILES_COARSER : SHD_MISSING_TILES_WAIT;
            shd_sampler *sampler = nullptr;
            shd_assert_ok(shd_sampler_create(g_context, &sd, &sampler));
            shd_texels out = shd_texels_default();
            out.channel[0] = shd_f32_out_column(want.data(), 0);
            shd_assert_ok(shd_texture_sample(texture, sampler, &in, &out));
            std::vector<uint32_t> level(kCount);
            out.channel[0] = shd_f32_out_column(got.data(), 0);
            out.coarser.data = level.data();
            shd_assert_ok(shd_texture_sample(tiled, sampler, &in, &out));
            for (size_t i = 0; i < kCount; ++i) {
                if (level[i] == 0) assert_memory_equal(&got[i], &want[i], sizeof(float));
                if (filter == SHD_FILTER_NEAREST && coarser) assert_true(level[i] > 0 && got[i] == 0);
                if (!coarser) assert_int_equal(level[i], 0);
            }
            shd_sampler_release(sampler);
        }
    }
    shd_texture_release(tiled);
    shd_texture_release(texture);
    shd_tile_cache_release(cache);
}

void test_refused(void **)
{
    const struct {
        const char *name;
        void (*edit)(shd_sampler_desc *);
        const char *message;
    } rows[] = {
        {"bicubic", [](auto *s) { s->filter = SHD_FILTER_BICUBIC; },
         "sampler.filter: BICUBIC has no comparison (the texture is in memory): no standard defines the filter"},
        {"ewa", [](auto *s) { s->filter = SHD_FILTER_EWA; }, "sampler.filter: EWA has no comparison"},
        {"stochastic", [](auto *s) { s->filter = SHD_FILTER_STOCHASTIC; }, "sampler.filter: STOCHASTIC has no comp"},
        {"exact", [](auto *s) { s->filter = SHD_FILTER_EXACT; }, "sampler.filter: EXACT has no comparison"},
        {"hermite", [](auto *s) { s->filter = SHD_FILTER_HERMITE; }, "sampler.filter: HERMITE has no comparison"},
        {"magnification", [](auto *s) { s->magnification = SHD_MAGNIFICATION_BICUBIC; },
         "sampler.magnification: BICUBIC has no comparison"},
    };
    for (const auto &row : rows) {
        Fixture f;
        row.edit(&f.sampler_desc);
        f.open();
        shd_assert_result(row.name, f.sample(), SHD_ERROR_UNSUPPORTED, row.message);
        f.close();
    }
    Fixture f;
    f.sampler_desc.filter = SHD_FILTER_BILINEAR;
    f.open();
    const shd_lookups in = f.lookups();
    shd_texels out = shd_texels_default();
    out.du[0] = shd_f32_out_column(f.out[0], 0);
    shd_assert_result("derivatives", shd_texture_sample(f.texture, f.sampler, &in, &out), SHD_ERROR_UNSUPPORTED,
                      "sampler.compares: 1, but comparisons have no derivatives");
    shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, f.texture, f.sampler);
    shd_material_desc material_desc = shd_material_desc_default();
    material_desc.slots = &slot, material_desc.slot_count = 1;
    shd_material *material = nullptr;
    shd_assert_result("material", shd_material_create(g_context, &material_desc, &material), SHD_ERROR_UNSUPPORTED,
                      "sampler.compares: 1, but only lookups have a reference");
    shd_sampler *sampler = nullptr;
    f.sampler_desc.compares = 2;
    shd_assert_result("compares", shd_sampler_create(g_context, &f.sampler_desc, &sampler), SHD_ERROR_INVALID_ARGUMENT,
                      "sampler.compares: 2 is not in 0..1");
    f.sampler_desc.compares = 1, f.sampler_desc.compare = static_cast<shd_compare>(8);
    shd_assert_result("compare", shd_sampler_create(g_context, &f.sampler_desc, &sampler), SHD_ERROR_INVALID_ARGUMENT,
                      "sampler.compare: 8 is not in 0..7");
    f.close();
}

/// A strided column of references is that of a packed one; it must not overlap results.
void test_columns(void **)
{
    Fixture f;
    f.open();
    const float strided[] = {0.1f, 9, 0.3f, 9, 0.3f, 9, 0.1f, 9};
    shd_lookups in = f.lookups();
    in.reference = {strided, 2 * sizeof(float)};
    shd_texels out = Fixture::texels(f.out);
    shd_assert_ok(shd_texture_sample(f.texture, f.sampler, &in, &out));
    assert_true(f.out[0][0] == 0 && f.out[0][1] == 0 && f.out[0][2] == 1 && f.out[0][3] == 1);
    in.reference = shd_f32_column(f.out[0], 0);
    shd_assert_result("overlap", shd_texture_sample(f.texture, f.sampler, &in, &out), SHD_ERROR_INVALID_ARGUMENT,
                      "lookups.reference");
    f.close();
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_operations),
        cmocka_unit_test(test_clamp),
        cmocka_unit_test(test_blend),
        cmocka_unit_test(test_swizzle),
        cmocka_unit_test(test_explanation),
        cmocka_unit_test(test_bounds),
        cmocka_unit_test(test_bounds_of_reference),
        cmocka_unit_test(test_tiles),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_columns),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
