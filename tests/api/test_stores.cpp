// SPDX-License-Identifier: MIT
// Stores: compressed blocks, borrowed blocks, tiles, and tiles of compressed blocks have the bits of the same texels in
// memory, for every domain, filter, wrap and target, with derivatives and explanations. Blocks can be copied out, and
// tables are read as equal columns.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/stored_textures.h"
#include "support/tables.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

const TextureShape kDomains[] = {
    {"2D", 37, 21, 3, 0, SHD_PROJECTION_NONE},
    {"1x1", 1, 1, 1, 0, SHD_PROJECTION_NONE},
    {"3D", 19, 34, 1, 13, SHD_PROJECTION_NONE},
    {"3D/1", 1, 5, 1, 3, SHD_PROJECTION_NONE},
    {"3D/deep", 40, 33, 1, 40, SHD_PROJECTION_NONE},
    {"LAT_LONG", 64, 33, 1, 0, SHD_PROJECTION_LAT_LONG},
    {"CUBE", 23, 23, 6, 0, SHD_PROJECTION_CUBE},
    {"CUBE/1", 1, 1, 6, 0, SHD_PROJECTION_CUBE},
    {"OCTAHEDRAL", 45, 45, 1, 0, SHD_PROJECTION_OCTAHEDRAL},
    {"MIRROR_BALL", 38, 38, 1, 0, SHD_PROJECTION_MIRROR_BALL},
    {"ANGULAR", 31, 31, 1, 0, SHD_PROJECTION_ANGULAR},
};
constexpr size_t kCount = 197;

enum Store { kMemory, kBlocks, kBorrowedBlocks, kTiles, kTilesOfBlocks };
const StoredForm kForms[] = {{"memory", false, false, false},
                             {"blocks", true, false, false},
                             {"borrowed blocks", true, true, false},
                             {"tiles", false, false, true},
                             {"tiles of blocks", true, false, true}};

/// Lookups near each other, anywhere, at the edges, of every footprint, and with inputs that are not finite.
struct Batch {
    std::vector<float> column[9], out[16];
    std::vector<uint32_t> layer, coarser;

    Batch(const TextureShape &shape, uint64_t seed) : layer(kCount), coarser(kCount)
    {
        Random random{seed};
        const bool directions = shape.projection != SHD_PROJECTION_NONE;
        for (auto &values : column) values.resize(kCount);
        for (auto &values : out) values.resize(kCount);
        float at[3] = {};
        for (size_t i = 0; i < kCount; ++i) {
            for (int c = 0; c < 3; ++c) {
                const bool far = i % 31 == 0 || i >= 120;
                at[c] = far ? random.real(directions ? -1.0 : -1.6, directions ? 1.0 : 2.6) : at[c] + 0.4f / 37.0f;
                column[c][i] = at[c];
            }
            for (int c = 3; c < 9; ++c) column[c][i] = random.scaled(-9.0, i < 160 ? -3.0 : 3.0);
            layer[i] = i / 23 % (shape.layers + 1);
        }
        column[0][5] = NAN, column[1][6] = INFINITY, column[4][7] = INFINITY, column[3][8] = NAN;
        column[0][9] = 1e30f, column[5][10] = 1e30f;
        if (directions) column[0][11] = column[1][11] = column[2][11] = 0.0f;
    }

    shd_lookups lookups()
    {
        shd_lookups in = shd_lookups_default();
        in.count = kCount;
        shd_f32_in *const ins[9] = {&in.u, &in.v, &in.w, &in.dudx, &in.dvdx, &in.dwdx, &in.dudy, &in.dvdy, &in.dwdy};
        for (int c = 0; c < 9; ++c) *ins[c] = shd_f32_column(column[c].data(), 0);
        in.layer.data = layer.data();
        return in;
    }
    shd_result sample(const shd_texture *texture, const shd_sampler *sampler, bool gradient)
    {
        shd_texture_info info = {};
        info.struct_size = sizeof info;
        shd_assert_ok(shd_texture_get_info(texture, &info));
        const bool deep = gradient && (info.depth != 0 || info.projection != SHD_PROJECTION_NONE);
        const shd_lookups in = lookups();
        shd_texels to = shd_texels_default();
        for (auto &values : out) std::fill(values.begin(), values.end(), -1.0f);
        std::fill(coarser.begin(), coarser.end(), 77u);
        to.coarser.data = coarser.data();
        for (size_t c = 0; c < 4; ++c) {
            to.channel[c].data = out[c].data();
            if (gradient) to.du[c].data = out[4 + c].data(), to.dv[c].data = out[8 + c].data();
            if (deep) to.dw[c].data = out[12 + c].data();
        }
        return shd_texture_sample(texture, sampler, &in, &to);
    }
};

const shd_filter kFilters[] = {SHD_FILTER_NEAREST,
                               SHD_FILTER_BILINEAR,
                               SHD_FILTER_BICUBIC,
                               SHD_FILTER_NEAREST_MIP,
                               SHD_FILTER_TRILINEAR,
                               SHD_FILTER_ANISOTROPIC,
                               SHD_FILTER_BILINEAR_MIP,
                               SHD_FILTER_EWA,
                               SHD_FILTER_STOCHASTIC,
                               SHD_FILTER_EXACT,
                               SHD_FILTER_NEAREST_MIP_LINEAR,
                               SHD_FILTER_HERMITE};
const shd_wrap kWraps[] = {SHD_WRAP_REPEAT, SHD_WRAP_MIRROR, SHD_WRAP_CLAMP, SHD_WRAP_BORDER, SHD_WRAP_MIRROR_ONCE};

shd_sampler *make_sampler(shd_context *context, shd_filter filter, shd_wrap wrap)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    desc.wrap_u = desc.wrap_v = desc.wrap_w = wrap;
    desc.border[0] = 0.25f, desc.border[3] = 0.75f;
    desc.tolerance = 0.5f;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    return sampler;
}

void compare(const Batch &want, const Batch &got, const char *what)
{
    assert_true(want.coarser == std::vector<uint32_t>(kCount, 0) && got.coarser == want.coarser);
    for (size_t c = 0; c < 16; ++c) {
        for (size_t i = 0; i < kCount; ++i) {
            if (std::memcmp(&want.out[c][i], &got.out[c][i], 4) == 0) continue;
            fail_msg("%s: column %zu of lookup %zu is %.9g, not %.9g", what, c, i, double{got.out[c][i]},
                     double{want.out[c][i]});
        }
    }
}

void compare_explanations(Batch *batch, const shd_texture *memory, const shd_texture *other, const shd_sampler *sampler,
                          const char *what)
{
    const shd_lookups in = batch->lookups();
    for (size_t i = 0; i < kCount; i += 17) {
        static shd_tap taps[2][4096];
        shd_explanation explanation[2];
        shd_result result[2];
        for (int k = 0; k < 2; ++k) {
            explanation[k] = shd_explanation_default();
            explanation[k].taps = taps[k], explanation[k].tap_capacity = 4096;
            result[k] = shd_texture_explain(k == 0 ? memory : other, sampler, &in, i, &explanation[k]);
        }
        assert_int_equal(result[0], result[1]);
        if (result[0] != SHD_OK) return;
        assert_int_equal(explanation[0].tap_count, explanation[1].tap_count);
        if (std::memcmp(taps[0], taps[1], explanation[0].tap_count * sizeof(shd_tap)) != 0 ||
            std::memcmp(explanation[0].result, explanation[1].result, sizeof explanation[0].result) != 0)
            fail_msg("%s: lookup %zu has another explanation", what, i);
    }
}

void check_filter(shd_context *context, const TextureShape &shape, shd_texture *const *textures, shd_filter filter,
                  shd_wrap wrap)
{
    shd_sampler *const sampler = make_sampler(context, filter, wrap);
    Batch want(shape, 7), got(shape, 7);
    const bool gradient = want.sample(textures[kMemory], sampler, true) == SHD_OK;
    const shd_result result = want.sample(textures[kMemory], sampler, gradient);
    for (int store = kBlocks; store <= kTilesOfBlocks; ++store) {
        char what[96];
        std::snprintf(what, sizeof what, "%s, %s, filter %d, wrap %d", shape.name, kForms[store].name, filter, wrap);
        const shd_result other = got.sample(textures[store], sampler, gradient);
        if (other != result) fail_msg("%s: %s, not %s", what, shd_result_name(other), shd_result_name(result));
        if (result != SHD_OK) continue;
        compare(want, got, what);
        if (wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_BORDER)
            compare_explanations(&got, textures[kMemory], textures[store], sampler, what);
    }
    shd_sampler_release(sampler);
}

/// Renders a volume of a 3D texture. Half of the densities have no extinction.
std::vector<float> render_volume(shd_context *context, shd_texture *texture)
{
    constexpr uint32_t kWidth = 31, kHeight = 19;
    const float density[2] = {0.5f, 1.0f}, extinction[2] = {0.0f, 9.0f};
    shd_volume_desc desc = shd_volume_desc_default();
    desc.texture = texture;
    desc.point_count = 2;
    desc.density = shd_f32_column(density, 0), desc.extinction = shd_f32_column(extinction, 0);
    desc.bounds_min[0] = desc.bounds_min[1] = desc.bounds_min[2] = -1.0f;
    desc.step = 0.05f;
    shd_volume_draw draw = shd_volume_draw_default();
    shd_volume *volume = nullptr;
    shd_assert_ok(shd_volume_create(context, &desc, &volume));
    draw.volume = volume;
    shd_framebuffer_desc size = shd_framebuffer_desc_default();
    size.width = kWidth, size.height = kHeight;
    shd_framebuffer *framebuffer = nullptr;
    shd_assert_ok(shd_framebuffer_create(context, &size, &framebuffer));
    shd_camera camera = shd_camera_default();
    camera.eye[0] = 1.5f, camera.eye[1] = 1.0f, camera.eye[2] = 3.2f;
    shd_render_desc frame = shd_render_desc_default();
    frame.framebuffer = framebuffer;
    frame.camera = &camera;
    frame.volumes = &draw, frame.volume_count = 1;
    shd_assert_ok(shd_render(context, &frame));
    std::vector<float> alpha(kWidth * kHeight);
    const shd_f32_out column = {alpha.data(), 0};
    shd_assert_ok(shd_framebuffer_read_plane(framebuffer, SHD_PLANE_A, &column));
    shd_framebuffer_release(framebuffer);
    shd_volume_release(volume);
    return alpha;
}

/// Blocks are copied out as the callback gives them, and nothing beside them is written.
void check_blocks(const shd_texture *texture, const StoredLevels &levels)
{
    for (uint32_t l = 0; l < levels.count; ++l) {
        for (uint32_t i = 0; i < levels.images(l); ++i) {
            const StoredLevel &level = levels.at(i, l);
            const size_t row = (level.width + 3) / 4 * 8, rows = (level.height + 3) / 4, stride = row + 5;
            std::vector<unsigned char> want(rows * stride + 64, 0xcd), got = want;
            for (size_t y = 0; y < rows; ++y) std::memcpy(&want[y * stride], &level.blocks[y * row], row);
            shd_image image = shd_image_default();
            image.format = SHD_FORMAT_BC1_RGBA, image.width = level.width, image.height = level.height;
            image.pixels = got.data(), image.row_stride = stride;
            shd_assert_ok(shd_texture_read_level(texture, i, l, &image));
            assert_memory_equal(got.data(), want.data(), want.size());
        }
    }
}

void test_domain(void **state)
{
    const auto &shape = *static_cast<const TextureShape *>(*state);
    for (int simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        desc.simd = static_cast<shd_simd>(simd);
        shd_context *context = nullptr;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        StoredLevels levels(shape), blocks(shape);
        shd_tile_cache_desc cache_desc = shd_tile_cache_desc_default();
        cache_desc.tile_bytes = 1024;
        cache_desc.budget_bytes = 1 << 20;
        shd_tile_cache *cache = nullptr;
        shd_assert_ok(shd_tile_cache_create(context, &cache_desc, &cache));
        shd_texture *textures[5];
        for (int store = kMemory; store <= kTilesOfBlocks; ++store) {
            textures[store] =
                create(context, store == kTilesOfBlocks ? &blocks : &levels, kForms[store], SHD_TABLE_MIPMAP, cache);
        }
        for (int store : {kBlocks, kBorrowedBlocks, kTilesOfBlocks}) check_blocks(textures[store], blocks);
        const bool wraps = shape.projection == SHD_PROJECTION_NONE;
        for (shd_filter filter : kFilters) {
            for (size_t w = 0; w < (wraps ? sizeof kWraps / sizeof *kWraps : 1); ++w)
                check_filter(context, shape, textures, filter, kWraps[w]);
        }
        for (int store = kBlocks; shape.depth != 0 && store <= kTilesOfBlocks; ++store) {
            const std::vector<float> want = render_volume(context, textures[kMemory]);
            assert_true(*std::max_element(want.begin(), want.end()) > 0.5f);
            if (want != render_volume(context, textures[store]))
                fail_msg("%s, %s: another picture of the volume", shape.name, kForms[store].name);
        }
        for (shd_texture *texture : textures) shd_texture_release(texture);
        shd_tile_cache_release(cache);
        shd_context_release(context);
    }
}

/// Every level, sum and picture of a table. The pictures of slices show the slices below.
void check_table(const shd_texture *memory, const shd_texture *other, const TextureShape &shape, shd_table table)
{
    const shd_table_info levels = table_info(memory, {table});
    const auto equal = [&](const TablePart &part) {
        const TableRead want(memory, part), got(other, part);
        for (int c = 0; c < 4; ++c) assert_true(want.column[c] == got.column[c]);
        return want;
    };
    for (uint32_t i = 0; i < levels.level_count_u * levels.level_count_v; ++i) {
        const uint32_t u = i % levels.level_count_u, v = i / levels.level_count_u;
        if (table == SHD_TABLE_MIPMAP && u != v) continue;
        const uint32_t images = shape.depth ? std::max(1u, shape.depth >> u) : shape.layers;
        for (uint32_t image = 0; image < images; ++image) equal({table, SHD_TABLE_VIEW_LEVEL, image, u, v});
    }
    const uint32_t last = std::max(shape.layers, shape.depth) - 1;
    const TableRead picture = equal({table, SHD_TABLE_VIEW_PICTURE, last});
    if (!shape.depth || levels.level_count_u < 2) return;
    const uint32_t slice = std::min(last >> 1, std::max(1u, shape.depth >> 1) - 1);
    const TableRead below(memory, {table, SHD_TABLE_VIEW_LEVEL, slice, 1, 1});
    assert_true(picture.at(1, shape.width, 0) == below.at(1, 0, 0));
}

void test_tables(void **)
{
    shd_context *context = nullptr;
    shd_assert_ok(shd_context_create(nullptr, &context));
    for (const TextureShape &shape : kDomains) {
        StoredLevels levels(shape), blocks(shape);
        shd_tile_cache *const cache = make_tile_cache(context, 1024, 1 << 20);
        shd_table_flags tables = SHD_TABLE_MIPMAP;
        if (!shape.depth && !shape.projection) tables |= SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
        shd_texture *const memory = create(context, &levels, kForms[kMemory], tables, cache);
        for (int store = kBlocks; store <= kTilesOfBlocks; ++store) {
            shd_texture *const other =
                create(context, store == kTilesOfBlocks ? &blocks : &levels, kForms[store], tables, cache);
            for (const shd_table table : {SHD_TABLE_MIPMAP, SHD_TABLE_RIPMAP, SHD_TABLE_SUMMED_AREA}) {
                if (tables & table) check_table(memory, other, shape, table);
            }
            shd_texture_release(other);
        }
        shd_texture_release(memory);
        shd_tile_cache_release(cache);
    }
    shd_context_release(context);
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    CMUnitTest tests[sizeof kDomains / sizeof *kDomains + 1];
    size_t count = 0;
    for (const TextureShape &shape : kDomains)
        tests[count++] = {shape.name, test_domain, nullptr, nullptr, const_cast<TextureShape *>(&shape)};
    tests[count++] = cmocka_unit_test(test_tables);
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
