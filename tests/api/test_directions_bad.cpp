// SPDX-License-Identifier: MIT
// Textures of directions: descs that are refused, directions and derivatives that are not finite, NaN texels.
#include "support/directions.h"

namespace shd::tests
{
namespace
{

struct CreateCase {
    const char *name;
    shd_projection projection;
    uint32_t width, height, layers, tables, depth;
    const char *message;
};
const CreateCase kCreate[] = {
    {"create/lat_long", SHD_PROJECTION_LAT_LONG, 5, 3, 1, SHD_TABLE_MIPMAP, 0, ""},
    {"create/cube", SHD_PROJECTION_CUBE, 4, 4, 6, 0, 0, ""},
    {"create/unknown", static_cast<shd_projection>(6), 4, 4, 1, 0, 0, "texture.projection: 6 is not in 1..5"},
    {"create/ball_not_square", SHD_PROJECTION_MIRROR_BALL, 4, 5, 1, 0, 0, "texture.height: 5"},
    {"create/angular_not_square", SHD_PROJECTION_ANGULAR, 5, 4, 1, 0, 0, "texture.height: 4"},
    {"create/ball_array", SHD_PROJECTION_MIRROR_BALL, 4, 4, 3, 0, 0, ""},
    {"create/cube_not_square", SHD_PROJECTION_CUBE, 4, 5, 6, 0, 0, "texture.height: 5"},
    {"create/octahedral_not_square", SHD_PROJECTION_OCTAHEDRAL, 4, 5, 1, 0, 0, "texture.height: 5"},
    {"create/cube_one_layer", SHD_PROJECTION_CUBE, 4, 4, 1, 0, 0, ""},
    {"create/cube_twelve_layers", SHD_PROJECTION_CUBE, 4, 4, 12, 0, 0,
     "texture.layer_count: 12, but images of projection 4 have 6 faces"},
    {"create/ripmap", SHD_PROJECTION_LAT_LONG, 4, 4, 1, SHD_TABLE_RIPMAP, 0, "texture.tables: 0x2"},
    {"create/summed_area", SHD_PROJECTION_LAT_LONG, 4, 4, 1, SHD_TABLE_SUMMED_AREA, 0, "texture.tables: 0x4"},
    {"create/none", SHD_PROJECTION_NONE, 4, 4, 1, 0, 0, "texture.projection: 0 is not in 1..5"},
    {"create/depth", SHD_PROJECTION_LAT_LONG, 4, 4, 1, 0, 2,
     "texture.depth: 2, but texture.kind is not SHD_TEXTURE_KIND_3D"},
};

void test_create(void **state)
{
    const auto &row = *static_cast<const CreateCase *>(*state);
    static const float texels[16 * 16] = {};
    shd_texture_desc desc = shd_texture_desc_default();
    desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
    desc.format = SHD_FORMAT_R32F;
    desc.width = row.width, desc.height = row.height, desc.layer_count = row.layers, desc.depth = row.depth;
    desc.tables = row.tables;
    desc.projection = row.projection;
    desc.texels = texels;
    shd_texture *texture = nullptr;
    const bool fine = row.message[0] == 0;
    shd_assert_result(row.name, shd_texture_create(g_context, &desc, &texture),
                      fine ? SHD_OK : SHD_ERROR_INVALID_ARGUMENT, row.message);
    assert_true((texture != nullptr) == fine);
    if (fine) {
        shd_texture_info info = {};
        info.struct_size = sizeof info;
        shd_assert_ok(shd_texture_get_info(texture, &info));
        assert_int_equal(row.projection, info.projection);
        assert_int_equal(info.kind, SHD_TEXTURE_KIND_DIRECTIONS);
        assert_int_equal(info.layer_count, row.projection == SHD_PROJECTION_CUBE ? 6 : row.layers);
    }
    shd_texture_release(texture);
}

void test_refused_calls(void **)
{
    DirectionImage image(SHD_PROJECTION_OCTAHEDRAL, 4, 4);
    image.fill_noise(1);
    shd_texture *texture = image.texture(g_context);
    DirectionLookups at;
    const double n[3] = {0.3, -0.4, 0.5};
    at.add(n);
    float value[4];
    shd_lookups in = at.lookups();
    shd_texels out = shd_texels_default();
    out.channel[0] = shd_f32_out_column(value, 0);
    const struct {
        shd_filter filter;
        const char *message;
    } filters[] = {{SHD_FILTER_RIPMAP, "sampler.filter: RIPMAP, but the texture has projection OCTAHEDRAL"},
                   {SHD_FILTER_SUMMED_AREA, "sampler.filter: SUMMED_AREA, but"}};
    for (const auto &row : filters) {
        shd_sampler *sampler = make_sampler(g_context, row.filter);
        shd_assert_result(row.message, shd_texture_sample(texture, sampler, &in, &out), SHD_ERROR_UNSUPPORTED,
                          row.message);
        shd_sampler_release(sampler);
    }
    shd_sampler *sampler = make_sampler(g_context, SHD_FILTER_NEAREST);
    out.dw[0] = shd_f32_out_column(value + 1, 0);
    shd_assert_result("dw", shd_texture_sample(texture, sampler, &in, &out), SHD_ERROR_UNSUPPORTED,
                      "NEAREST has no derivatives (the texture has projection");
    out.dw[0].data = nullptr;
    in.w.data = nullptr;
    shd_assert_result("w", shd_texture_sample(texture, sampler, &in, &out), SHD_ERROR_INVALID_ARGUMENT,
                      "lookups.w.data: NULL, but the texture is one of directions");
    shd_sampler_release(sampler);
    shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, nullptr);
    shd_material_desc material_desc = shd_material_desc_default();
    shd_material *material = nullptr;
    material_desc.slots = &slot;
    material_desc.slot_count = 1;
    shd_assert_result("slot", shd_material_create(g_context, &material_desc, &material), SHD_ERROR_UNSUPPORTED,
                      "material.slots[0].texture: a texture of directions, not a 2D one");
    shd_texture_release(texture);
}

/// Every combination of bad components in directions and derivatives, for every filter. `state` is the projection.
void test_special(void **state)
{
    const auto projection = *static_cast<const shd_projection *>(*state);
    const double special[] = {0.0, -0.0, 1.0, -1.0, 1e-30, 3e38, 1e-44, NAN, INFINITY, -INFINITY};
    constexpr size_t kCount = sizeof special / sizeof *special;
    DirectionLookups at;
    size_t without = 0, derivatives = 0;
    std::vector<bool> is_front;
    for (size_t i = 0; i < 3 * kCount * kCount * kCount; ++i) {
        const size_t k = i / 3;
        const double n[3] = {special[k % kCount], special[k / kCount % kCount], special[k / kCount / kCount]};
        const double dx[3] = {special[(i * 7) % kCount], special[(i * 3 + 1) % kCount], special[i % kCount]};
        const double dy[3] = {special[(i + 5) % kCount], special[(i * 9) % kCount], special[(i / 7) % kCount]};
        const double usual[3] = {0.01, 0.0, -0.02};
        const bool given = i % 3 != 0;
        at.add(n, given ? dx : usual, given ? dy : usual);
        const bool none = !std::isfinite(n[0] + n[1] + n[2]) || (n[0] == 0.0 && n[1] == 0.0 && n[2] == 0.0);
        bool finite = true;
        for (int c = 0; c < 3; ++c) finite = finite && (!given || std::isfinite(dx[c] + dy[c]));
        without += none;
        derivatives += none || !finite;
        is_front.push_back(none);
    }
    DirectionImage image(projection, projection == SHD_PROJECTION_LAT_LONG ? 14 : 7, 7);
    image.fill_noise(4);
    shd_texture *texture = image.texture(g_context);
    const double front[3] = {0.0, 0.0, 1.0};
    for (const DirectionFilter &filter : kDirectionFilters) {
        shd_sampler *sampler = make_sampler(g_context, filter.filter);
        at.sample(texture, sampler);
        assert_int_equal(derivatives, at.nonfinite);
        for (float value : at.value) assert_true(value >= 0.0f && value <= 1.0f);
        at.lod.assign(at.count(), 0.5f);
        at.sample(texture, sampler);
        assert_int_equal(without, at.nonfinite);
        DirectionLookups one;
        one.add(front);
        one.lod.assign(1, 0.5f);
        const float want = one.sample(texture, sampler)[0];
        for (size_t i = 0; i < at.count(); ++i) assert_true(!is_front[i] || at.value[i] == want);
        if (filter.filter != SHD_FILTER_NEAREST && filter.filter != SHD_FILTER_NEAREST_MIP &&
            filter.filter != SHD_FILTER_NEAREST_MIP_LINEAR) {
            at.sample_slopes(texture, sampler);
            assert_int_equal(without, at.nonfinite);
            for (const auto &slope : at.slope) {
                for (size_t i = 0; i < at.count(); ++i)
                    assert_true(is_front[i] ? slope[i] == 0.0f : std::isfinite(slope[i]));
            }
        }
        at.lod.clear();
        shd_sampler_release(sampler);
    }
    shd_texture_release(texture);
}

/// NaN and infinite texels of one face do not reach lookups whose footprint lies on another.
void test_nan_face(void **)
{
    DirectionImage image(SHD_PROJECTION_CUBE, 8, 8);
    image.fill_noise(9);
    for (size_t i = 0; i < 64; ++i) image.texels[i] = i % 2 ? NAN : INFINITY;  // +X
    shd_texture *texture = image.texture(g_context);
    DirectionLookups at;
    Random random{1};
    for (int i = 0; i < 500; ++i) {
        double n[3];
        random_direction(&random, n);
        if (i % 2) n[0] = -1.2 * std::fmax(std::fabs(n[1]), std::fabs(n[2]));  // on -X
        if (n[0] > 0.5 * std::fmax(std::fabs(n[1]), std::fabs(n[2]))) n[0] = 0.0;
        at.add(n);
    }
    for (const DirectionFilter &filter : kDirectionFilters) {
        shd_sampler *sampler = make_sampler(g_context, filter.filter);
        for (float value : at.sample(texture, sampler)) assert_true(value >= 0.0f && value <= 1.0f);
        const double edge[3] = {1.0, 0.1, 0.2};
        DirectionLookups on_face;
        on_face.add(edge);
        assert_false(std::isfinite(on_face.sample(texture, sampler)[0]));
        shd_sampler_release(sampler);
    }
    shd_texture_release(texture);
}

/// Texels outside the disc do not reach bilinear lookups on level 0.
void test_nan_outside(void **)
{
    for (shd_projection projection : {SHD_PROJECTION_MIRROR_BALL, SHD_PROJECTION_ANGULAR}) {
        for (uint32_t size : {1u, 2u, 3u, 8u, 15u}) {
            DirectionImage image(projection, size, size);
            image.fill_noise(size);
            for (uint32_t i = 0; i < size * size; ++i) {
                const double p = (2.0 * (i % size) + 1.0) / size - 1.0, q = (2.0 * (i / size) + 1.0) / size - 1.0;
                if (p * p + q * q > 1.0) image.texels[i] = NAN;
            }
            shd_texture *texture = image.texture(g_context);
            DirectionLookups at;
            Random random{1};
            for (int i = 0; i < 600; ++i) {
                double n[3];
                random_direction(&random, n);
                if (i % 3 == 0) n[2] = -1.0 - n[2];  // near the rim
                at.add(n);
            }
            shd_sampler *sampler = make_sampler(g_context, SHD_FILTER_BILINEAR);
            for (float value : at.sample(texture, sampler)) assert_true(value >= 0.0f && value <= 1.0f);
            shd_sampler_release(sampler);
            shd_texture_release(texture);
        }
    }
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    std::vector<CMUnitTest> tests;
    static const char *const special[] = {
        "", "special/lat_long", "special/mirror_ball", "special/angular", "special/cube", "special/octahedral"};
    for (const CreateCase &row : kCreate) {
        tests.push_back({row.name, test_create, nullptr, nullptr, const_cast<CreateCase *>(&row)});
    }
    for (const shd_projection &projection : kProjections) {
        tests.push_back(
            {special[projection], test_special, nullptr, nullptr, const_cast<shd_projection *>(&projection)});
    }
    tests.push_back({"refused_calls", test_refused_calls, nullptr, nullptr, nullptr});
    tests.push_back({"nan_face", test_nan_face, nullptr, nullptr, nullptr});
    tests.push_back({"nan_outside", test_nan_outside, nullptr, nullptr, nullptr});
    return _cmocka_run_group_tests("api.directions_bad", tests.data(), tests.size(), set_up, tear_down);
}
