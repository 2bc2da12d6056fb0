// SPDX-License-Identifier: MIT
// shd_texture_read_table against the oracles, texel by texel: formats x sizes x tables, layers, swizzles, texels that
// are not finite, the layout of pictures, strided columns, refusals.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "ref/texture_ref.h"
#include "support/random.h"
#include "support/tables.h"

namespace shd::tests
{
namespace
{

constexpr uint32_t kLayers = 2;
constexpr shd_table_flags kAll = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;

struct Size {
    uint32_t width, height;
};
const Size kSizes[] = {{1, 1}, {7, 5}, {16, 4}, {1, 9}, {13, 1}};

/// Finite texels.
std::vector<uint8_t> random_texels(shd_format format, size_t count)
{
    Random random{format * 977u + count};
    std::vector<uint8_t> texels(count * shd_format_size(format) + SHD_TEXTURE_PADDING);
    const auto layout = ref::layout(format);
    const size_t numbers = count * shd_format_size(format) / static_cast<size_t>(layout.size);
    for (size_t i = 0; i < numbers; ++i) {
        const uint64_t bits = random.bits();
        const float value = random.real(-4, 4);
        const auto half = static_cast<uint16_t>((bits & 0x83ff) | (8 + bits % 10) << 10);
        const auto word = static_cast<uint32_t>((bits & 0x07ffffff) | (12 + bits % 6) << 27);
        uint8_t *const to = &texels[i * static_cast<size_t>(layout.size)];
        switch (layout.component) {
            case ref::Layout::kFloat32: std::memcpy(to, &value, 4); break;
            case ref::Layout::kFloat16: std::memcpy(to, &half, 2); break;
            case ref::Layout::kRgb9e5: std::memcpy(to, &word, 4); break;
            default: std::memcpy(to, &bits, static_cast<size_t>(layout.size));
        }
    }
    return texels;
}

/// A texture of random texels with all tables, and the base of a layer.
struct Case {
    shd_texture_desc desc;
    std::vector<uint8_t> texels;
    shd_texture *texture = nullptr;

    Case(shd_context *context, shd_format format, Size size) : desc(shd_texture_desc_default())
    {
        desc.format = format;
        desc.width = size.width, desc.height = size.height, desc.layer_count = kLayers;
        texels = random_texels(format, size_t{size.width} * size.height * kLayers);
        desc.texels = texels.data();
        desc.tables = kAll;
        shd_assert_ok(shd_texture_create(context, &desc, &texture));
    }
    ~Case() { shd_texture_release(texture); }
    Case(const Case &) = delete;
    Case &operator=(const Case &) = delete;

    ref::Level base(uint32_t layer) const
    {
        const size_t size = size_t{desc.width} * desc.height * shd_format_size(desc.format);
        return {texels.data() + layer * size, desc.width, desc.height};
    }
    double value(uint32_t layer, uint32_t x, uint32_t y, int c) const
    {
        const size_t texel = size_t{y} * desc.width + x;
        return ref::decode(desc.format, base(layer).texels + texel * shd_format_size(desc.format), c);
    }
};

/// Half the distance of stored values around `value`, rounded up; `largest` of the texel's channels.
double rounding(shd_format format, int c, double value, double largest)
{
    switch (ref::layout(format).component) {
        case ref::Layout::kFloat32: return std::fabs(value) * 1.2e-7 + 1e-13;
        case ref::Layout::kFloat16: return std::max(0x1p-25, std::fabs(value) * 0x1p-11) + 1e-7;
        case ref::Layout::kUnorm16: return 0.5 / 65535 + 1e-7;
        case ref::Layout::kRgb9e5: return largest * 0x1p-9 + 1e-7;
        default: return c == 3 ? 0.51 / 255 : 0.0051 + 1e-7;  // the widest step of sRGB is 2.4 of 255
    }
}

void check_level(const Case &of, const TableRead &read)
{
    const shd_format format = of.desc.format;
    for (uint32_t i = 0; i < read.info.width * read.info.height; ++i) {
        const uint32_t x = i % read.info.width, y = i / read.info.width;
        double want[4], largest = 0;
        for (int c = 0; c < 4; ++c) {
            want[c] = ref::box(format, of.base(read.desc.layer), read.info.width, read.info.height, x, y, c);
            if (c < ref::layout(format).channels) largest = std::max(largest, std::fabs(want[c]));
        }
        const bool is_base = read.desc.level_u == 0 && read.desc.level_v == 0;
        for (int c = 0; c < 4; ++c) {
            const double base = is_base ? std::fabs(want[c]) * 1.2e-7 : 1.0;
            const double allowed = std::min(base, rounding(format, c, want[c], largest));
            shd_assert_close("level", i, double{read.column[c][i]}, want[c], allowed, 0);
        }
    }
}

/// Levels of the mipmap have the bits of nearest lookups.
void check_lookups(const shd_texture *texture, const shd_sampler *sampler, const TableRead &read)
{
    const size_t count = read.column[0].size();
    std::vector<float> u(count), v(count), lod(count, static_cast<float>(read.desc.level_u)), out[4];
    std::vector<uint32_t> layer(count, read.desc.layer);
    for (size_t i = 0; i < count; ++i) {
        u[i] = (static_cast<float>(i % read.info.width) + 0.5f) / static_cast<float>(read.info.width);
        v[i] = (static_cast<float>(i / read.info.width) + 0.5f) / static_cast<float>(read.info.height);
    }
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    lookups.count = count;
    lookups.u.data = u.data(), lookups.v.data = v.data(), lookups.lod.data = lod.data();
    lookups.layer.data = layer.data();
    for (int c = 0; c < 4; ++c) {
        out[c].resize(count);
        texels.channel[c].data = out[c].data();
    }
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    for (const auto &column : out) assert_memory_equal(column.data(), read.column[&column - out].data(), 4 * count);
}

void check_sums(const Case &of, const TableRead &read, bool is_picture)
{
    const uint32_t width = of.desc.width, corner = is_picture ? 1 : 0;
    for (int c = 0; c < 4; ++c) {
        for (uint32_t i = 0; i < read.column[0].size(); ++i) {
            const uint32_t x = i % read.info.width + corner, y = i / read.info.width + corner;
            double sum = 0, size = 0;
            for (uint32_t k = 0; k < width * y; ++k) {
                if (k % width >= x) continue;
                const double value = of.value(read.desc.layer, k % width, k / width, c);
                sum += value, size += std::fabs(value);
            }
            const double area = is_picture ? static_cast<double>(x * y) : 1.0;
            shd_assert_close("sum", i, double{read.column[c][i]}, sum / area, size / area * 1e-14 + 1e-30, 1.2e-7);
        }
    }
}

void test_format(void **state)
{
    const auto format = static_cast<shd_format>(reinterpret_cast<uintptr_t>(*state));
    shd_context *context = nullptr;
    shd_sampler *sampler = nullptr;
    shd_sampler_desc nearest = shd_sampler_desc_default();
    nearest.filter = SHD_FILTER_NEAREST_MIP;
    shd_assert_ok(shd_context_create(nullptr, &context));
    shd_assert_ok(shd_sampler_create(context, &nearest, &sampler));
    for (const Size &size : kSizes) {
        const Case of(context, format, size);
        const shd_table_info levels = table_info(of.texture, {SHD_TABLE_RIPMAP});
        for (uint32_t i = 0; i < kLayers * levels.level_count_u * levels.level_count_v; ++i) {
            const uint32_t level = i / kLayers;
            TablePart part = {SHD_TABLE_RIPMAP, SHD_TABLE_VIEW_LEVEL, i % kLayers};
            part.level_u = level % levels.level_count_u, part.level_v = level / levels.level_count_u;
            check_level(of, TableRead(of.texture, part));
        }
        const uint32_t mips = table_info(of.texture, {SHD_TABLE_MIPMAP}).level_count_u;
        for (uint32_t l = 0; l < mips; ++l) {
            const TableRead read(of.texture, {SHD_TABLE_MIPMAP, SHD_TABLE_VIEW_LEVEL, 1, l, l});
            check_level(of, read);
            check_lookups(of.texture, sampler, read);
        }
        check_sums(of, TableRead(of.texture, {SHD_TABLE_SUMMED_AREA, SHD_TABLE_VIEW_LEVEL, 1}), false);
        check_sums(of, TableRead(of.texture, {SHD_TABLE_SUMMED_AREA, SHD_TABLE_VIEW_PICTURE, 1}), true);
    }
    shd_sampler_release(sampler);
    shd_context_release(context);
}

/// Every element of a picture is a texel of one level, or 0 beside the levels.
void check_picture(const shd_texture *texture, shd_table table, uint32_t width, uint32_t height)
{
    const TableRead picture(texture, {table, SHD_TABLE_VIEW_PICTURE, 1});
    assert_int_equal(picture.info.width, width);
    assert_int_equal(picture.info.height, height);
    std::vector<float> rest = picture.column[2];
    for (uint32_t i = 0; i < picture.info.level_count_u * picture.info.level_count_v; ++i) {
        const uint32_t level_u = i % picture.info.level_count_u, level_v = i / picture.info.level_count_u;
        if (table == SHD_TABLE_MIPMAP && level_u != level_v) continue;
        const TableRead level(texture, {table, SHD_TABLE_VIEW_LEVEL, 1, level_u, level_v});
        const shd_table_info place = table_info(texture, {table, SHD_TABLE_VIEW_PICTURE, 1, level_u, level_v});
        for (uint32_t k = 0; k < level.column[2].size(); ++k) {
            const uint32_t x = place.x + k % level.info.width, y = place.y + k / level.info.width;
            assert_true(picture.at(2, x, y) == level.column[2][k]);
            assert_true(rest[size_t{y} * width + x] != 0.0f);  // no other level has it
            rest[size_t{y} * width + x] = 0.0f;
        }
    }
    assert_true(std::all_of(rest.begin(), rest.end(), [](float value) { return value == 0.0f; }));
}

void test_picture(void **)
{
    shd_context *context = nullptr;
    shd_assert_ok(shd_context_create(nullptr, &context));
    const Case of(context, SHD_FORMAT_RGBA32F, {13, 6});
    check_picture(of.texture, SHD_TABLE_MIPMAP, 13 + 6, 6);  // 6 x 3, 3 x 1, 1 x 1
    check_picture(of.texture, SHD_TABLE_RIPMAP, 13 + 6 + 3 + 1, 6 + 3 + 1);
    const Case row(context, SHD_FORMAT_RGBA32F, {16, 1});
    check_picture(row.texture, SHD_TABLE_MIPMAP, 16 + 8, 4);
    const Case texel(context, SHD_FORMAT_RGBA32F, {1, 1});
    check_picture(texel.texture, SHD_TABLE_MIPMAP, 1, 1);
    check_picture(texel.texture, SHD_TABLE_RIPMAP, 1, 1);
    const TableRead picture(of.texture, {SHD_TABLE_MIPMAP, SHD_TABLE_VIEW_PICTURE, 0});
    const TableRead base(of.texture, {SHD_TABLE_MIPMAP}), last(of.texture, {SHD_TABLE_MIPMAP, {}, 0, 3, 3});
    assert_true(picture.at(0, 12, 5) == base.at(0, 12, 5) && picture.at(3, 13, 4) == last.at(3, 0, 0));
    assert_true(picture.at(3, 14, 4) == 0.0f && picture.at(3, 13, 5) == 0.0f);
    shd_context_release(context);
}

/// Channels come from the swizzle, and constants count in sums as often as there are texels.
void test_swizzle(void **)
{
    const uint8_t texels[3] = {51, 102, 255};
    shd_context *context = nullptr;
    shd_texture *texture = nullptr;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_assert_ok(shd_context_create(nullptr, &context));
    desc.format = SHD_FORMAT_R8, desc.width = 3, desc.height = 1, desc.texels = texels, desc.tables = kAll;
    desc.swizzle[0] = SHD_CHANNEL_FILL, desc.swizzle[2] = SHD_CHANNEL_R;
    desc.fill[0] = 0.5f, desc.fill[1] = -2.0f;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    const TableRead base(texture, {SHD_TABLE_RIPMAP}), sums(texture, {SHD_TABLE_SUMMED_AREA});
    const TableRead means(texture, {SHD_TABLE_SUMMED_AREA, SHD_TABLE_VIEW_PICTURE});
    const float want[4] = {0.5f, -2.0f, 0.4f, 1.0f}, sum[4] = {1.0f, -4.0f, 0.6f, 2.0f};
    const float mean[4] = {0.5f, -2.0f, 0.3f, 1.0f};
    for (int c = 0; c < 4; ++c) {
        assert_true(base.at(c, 1, 0) == want[c] && sums.at(c, 2, 1) == sum[c] && means.at(c, 1, 0) == mean[c]);
        assert_true(sums.at(c, 3, 0) == 0.0f && sums.at(c, 0, 1) == 0.0f);
    }
    shd_texture_release(texture);
    shd_context_release(context);
}

/// Texels that are not finite are in levels as they are, and count as 0 in sums. Means leave them out.
void test_nonfinite(void **)
{
    for (const float first : {8.0f, NAN}) {
        const float texels[2][3] = {{first, NAN, 2.0f}, {-1.0f, INFINITY, 4.0f}};
        shd_context *context = nullptr;
        shd_texture *texture = nullptr;
        shd_texture_desc desc = shd_texture_desc_default();
        shd_assert_ok(shd_context_create(nullptr, &context));
        desc.format = SHD_FORMAT_R32F, desc.width = 3, desc.height = 2, desc.texels = texels, desc.tables = kAll;
        shd_assert_ok(shd_texture_create(context, &desc, &texture));
        const TableRead base(texture, {SHD_TABLE_RIPMAP}), sums(texture, {SHD_TABLE_SUMMED_AREA});
        const TableRead means(texture, {SHD_TABLE_SUMMED_AREA, SHD_TABLE_VIEW_PICTURE});
        const bool is_nan = std::isnan(first);
        const float part = is_nan ? 0.0f : first;
        assert_true(std::isnan(base.at(0, 1, 0)) && base.at(0, 1, 1) == INFINITY && base.at(0, 2, 1) == 4.0f);
        assert_true(sums.at(0, 1, 1) == part && sums.at(0, 2, 1) == part && sums.at(0, 3, 2) == part + 5.0f);
        assert_true(is_nan ? std::isnan(means.at(0, 1, 0)) : means.at(0, 1, 0) == part);
        assert_true(means.at(0, 1, 1) == (is_nan ? -1.0f : 3.5f));
        shd_assert_close("mean", 0, double{means.at(0, 2, 1)}, is_nan ? 5.0 / 3 : 13.0 / 4, 0, 1e-7);
        shd_texture_release(texture);
        shd_context_release(context);
    }
}

/// Columns with strides and columns that are not wanted; nothing else is written.
void test_columns(void **)
{
    shd_context *context = nullptr;
    shd_assert_ok(shd_context_create(nullptr, &context));
    const Case of(context, SHD_FORMAT_RGBA16, {7, 5});
    for (const shd_table table : {SHD_TABLE_MIPMAP, SHD_TABLE_RIPMAP, SHD_TABLE_SUMMED_AREA}) {
        const TablePart part = {table, SHD_TABLE_VIEW_PICTURE, 1};
        const TableRead whole(of.texture, part);
        const size_t count = whole.column[0].size();
        std::vector<float> records(3 * count + 1, -7.0f);
        const shd_table_desc desc = table_desc(part);
        const shd_f32_out out[4] = {{&records[0], 12}, {nullptr, 0}, {&records[2], 12}, {nullptr, 0}};
        shd_assert_ok(shd_texture_read_table(of.texture, &desc, out));
        for (size_t i = 0; i < count; ++i) {
            assert_true(records[3 * i] == whole.column[0][i] && records[3 * i + 2] == whole.column[2][i]);
            assert_true(records[3 * i + 1] == -7.0f);
        }
        assert_true(records[3 * count] == -7.0f);
    }
    shd_context_release(context);
}

struct Refusal {
    const char *name;
    shd_table_flags tables;
    TablePart part;
    const char *message;
};
const Refusal kRefusals[] = {
    {"no_mipmap", SHD_TABLE_RIPMAP, {SHD_TABLE_MIPMAP}, "table.table: SHD_TABLE_MIPMAP, but the texture does not"},
    {"no_ripmap", SHD_TABLE_MIPMAP, {SHD_TABLE_RIPMAP}, "table.table: SHD_TABLE_RIPMAP, but"},
    {"no_sums", SHD_TABLE_RIPMAP, {SHD_TABLE_SUMMED_AREA}, "table.table: SHD_TABLE_SUMMED_AREA, but"},
    {"none", kAll, {SHD_TABLE_NONE}, "table.table: 0 is not SHD_TABLE_MIPMAP, SHD_TABLE_RIPMAP or"},
    {"two", kAll, {static_cast<shd_table>(3)}, "table.table: 3 is not"},
    {"view", kAll, {SHD_TABLE_MIPMAP, static_cast<shd_table_view>(2)}, "table.view: 2 is not in 0..1"},
    {"layer", kAll, {SHD_TABLE_RIPMAP, {}, 2}, "table.layer: 2 is not in 0..1"},
    {"ripmap_u", kAll, {SHD_TABLE_RIPMAP, {}, 0, 4, 0}, "table.level_u: 4 is not in 0..3"},
    {"ripmap_v", kAll, {SHD_TABLE_RIPMAP, {}, 0, 0, 3}, "table.level_v: 3 is not in 0..2"},
    {"mip_u", kAll, {SHD_TABLE_MIPMAP, {}, 0, 4, 4}, "table.level_u: 4 is not in 0..3"},
    {"mip_v", kAll, {SHD_TABLE_MIPMAP, {}, 0, 2, 1}, "table.level_v: 1 is not level_u, 2, of SHD_TABLE_MIPMAP"},
    {"sums", kAll, {SHD_TABLE_SUMMED_AREA, {}, 0, 1, 0}, "table.level_u: 1 is not in 0..0"},
};

void test_refusal(void **state)
{
    const auto &refusal = *static_cast<const Refusal *>(*state);
    shd_context *context = nullptr;
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_context_create(nullptr, &context));
    const Case of(context, SHD_FORMAT_R8, {9, 6});
    shd_texture_desc made = of.desc;
    made.tables = refusal.tables;
    shd_assert_ok(shd_texture_create(context, &made, &texture));
    std::vector<float> values(512, -7.0f);
    const shd_f32_out out[4] = {{values.data(), 0}, {nullptr, 0}, {nullptr, 0}, {nullptr, 0}};
    const shd_table_desc desc = table_desc(refusal.part);
    shd_table_info info = shd_table_info_default();
    info.width = 9;
    shd_assert_result(refusal.name, shd_texture_get_table_info(texture, &desc, &info), SHD_ERROR_INVALID_ARGUMENT,
                      refusal.message);
    assert_int_equal(info.width, 0);
    shd_assert_result(refusal.name, shd_texture_read_table(texture, &desc, out), SHD_ERROR_INVALID_ARGUMENT,
                      refusal.message);
    assert_true(values[0] == -7.0f);
    shd_texture_release(texture);
    shd_context_release(context);
}

void test_arguments(void **)
{
    shd_context *context = nullptr;
    shd_assert_ok(shd_context_create(nullptr, &context));
    const Case of(context, SHD_FORMAT_R8, {9, 6});
    shd_table_desc desc = table_desc({SHD_TABLE_SUMMED_AREA});
    shd_table_info info = shd_table_info_default();
    std::vector<float> values(512, -7.0f);
    shd_f32_out out[4] = {{values.data(), 0}, {values.data() + 69, 0}, {nullptr, 0}, {nullptr, 0}};  // 10 x 7
    const auto refuse = [&](const char *what, const shd_texture *texture, const shd_table_desc *from,
                            const shd_f32_out *to, const char *message) {
        shd_assert_result(what, shd_texture_read_table(texture, from, to), SHD_ERROR_INVALID_ARGUMENT, message);
        assert_true(values[0] == -7.0f && values[100] == -7.0f);
    };
    refuse("texture", nullptr, &desc, out, "texture");
    refuse("desc", of.texture, nullptr, out, "table: NULL");
    refuse("out", of.texture, &desc, nullptr, "out: NULL");
    refuse("overlap", of.texture, &desc, out, "out[1]: overlaps out[0]");
    out[1].stride = 6;
    refuse("stride", of.texture, &desc, out, "out[1].stride: 6");
    shd_assert_result("info", shd_texture_get_table_info(of.texture, &desc, nullptr), SHD_ERROR_INVALID_ARGUMENT,
                      "out_info: NULL");
    shd_assert_result("info", shd_texture_get_table_info(nullptr, &desc, &info), SHD_ERROR_INVALID_ARGUMENT, "texture");
    shd_context_release(context);
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    static const shd_format formats[] = {
        SHD_FORMAT_R8,       SHD_FORMAT_RG8,        SHD_FORMAT_RGBA8,   SHD_FORMAT_R8_SRGB,
        SHD_FORMAT_RG8_SRGB, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_R16,     SHD_FORMAT_RG16,
        SHD_FORMAT_RGBA16,   SHD_FORMAT_R16F,       SHD_FORMAT_RG16F,   SHD_FORMAT_RGBA16F,
        SHD_FORMAT_R32F,     SHD_FORMAT_RG32F,      SHD_FORMAT_RGBA32F, SHD_FORMAT_RGB9E5};
    std::vector<std::string> names;
    std::vector<CMUnitTest> tests;
    names.reserve(64);
    for (const shd_format format : formats) {
        names.push_back("format/" + std::string(shd_format_name(format)));
        tests.push_back({names.back().c_str(), test_format, nullptr, nullptr,
                         reinterpret_cast<void *>(static_cast<uintptr_t>(format))});
    }
    for (const Refusal &refusal : kRefusals) {
        names.push_back("refuse/" + std::string(refusal.name));
        tests.push_back({names.back().c_str(), test_refusal, nullptr, nullptr, const_cast<Refusal *>(&refusal)});
    }
    tests.push_back(cmocka_unit_test(test_picture));
    tests.push_back(cmocka_unit_test(test_swizzle));
    tests.push_back(cmocka_unit_test(test_nonfinite));
    tests.push_back(cmocka_unit_test(test_columns));
    tests.push_back(cmocka_unit_test(test_arguments));
    return _cmocka_run_group_tests("texture_table", tests.data(), tests.size(), nullptr, nullptr);
}
