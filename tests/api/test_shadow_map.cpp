// SPDX-License-Identifier: MIT
// shd_shadow_read_map: depths of known planes, moments and sums from the depths of a map with the same margin,
// refusals.
#include <algorithm>
#include <cmath>
#include <vector>

#include "support/shadow_scene.h"

namespace shd::tests
{
namespace
{

constexpr uint32_t kSize = 37, kTaps = 4;
constexpr float kTop = 0.25f;

struct {
    shd_context *context;
    shd_boxes boxes;
} g;

int set_up(void **)
{
    const float low[3] = {-1, -1, -1}, high[3] = {1, kTop, 1};
    shd_assert_ok(shd_context_create(nullptr, &g.context));
    shd_boxes_open(&g.boxes, g.context);
    shd_boxes_add(&g.boxes, low, high);
    return 0;
}

int tear_down(void **)
{
    shd_boxes_close(&g.boxes);
    shd_context_release(g.context);
    return 0;
}

/// A map of the box from above, or from a point above it.
struct Map {
    shd_light *light = nullptr;
    shd_shadow *shadow = nullptr;
    shd_shadow_info info = shd_shadow_info_default();
    std::vector<float> column[2];  // results of the last read

    Map(shd_shadow_filter filter, shd_light_kind kind)
    {
        shd_light_desc desc = shd_light_desc_default();
        desc.kind = kind;
        desc.position[1] = 3.0f;
        desc.direction[0] = desc.direction[2] = 0.0f, desc.direction[1] = -1.0f;
        shd_assert_ok(shd_light_create(g.context, &desc, &light));
        shd_shadow_desc options = shd_shadow_desc_default();
        options.size = kSize;
        options.filter = filter;
        options.taps = kTaps;
        shadow = shd_boxes_shadow(&g.boxes, g.context, &options, light);
        shd_assert_ok(shd_shadow_get_info(shadow, &info));
        assert_int_equal(info.filter, filter);
        assert_int_equal(info.face_count, kind == SHD_LIGHT_KIND_POINT ? 6 : 1);
        assert_true(info.near_plane < info.far_plane && info.byte_size >= 4 * kSize * kSize * info.face_count);
    }
    ~Map()
    {
        shd_shadow_release(shadow);
        shd_light_release(light);
    }
    Map(const Map &) = delete;
    Map &operator=(const Map &) = delete;

    bool has_two() const
    {
        return info.filter == SHD_SHADOW_FILTER_VARIANCE || info.filter == SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE;
    }
    void read(uint32_t face)
    {
        const size_t count = size_t{info.width} * info.height;
        for (auto &values : column) values.assign(count + 1, -7.0f);
        const shd_f32_out out[2] = {{column[0].data(), 0}, {has_two() ? column[1].data() : nullptr, 0}};
        shd_assert_ok(shd_shadow_read_map(shadow, face, out));
        assert_true(column[0][count] == -7.0f && column[1][count] == -7.0f);
    }
    float at(int c, uint32_t x, uint32_t y) const { return column[c][size_t{y} * info.width + x]; }
};

void test_depths(void **)
{
    for (const shd_shadow_filter filter : {SHD_SHADOW_FILTER_HARD, SHD_SHADOW_FILTER_PCF, SHD_SHADOW_FILTER_PCSS}) {
        Map sun(filter, SHD_LIGHT_KIND_DIRECTIONAL), lamp(filter, SHD_LIGHT_KIND_POINT);
        assert_int_equal(sun.info.width, kSize);
        sun.read(0);
        size_t empty = 0;
        for (uint32_t i = 0; i < kSize * kSize; ++i) {
            const double depth = double{sun.column[0][i]};
            empty += std::isinf(depth);
            if (!std::isinf(depth)) shd_assert_close("sun", i, depth, double{-kTop}, 1e-5, 0);
        }
        assert_true(empty > 0 && empty < kSize * kSize);
        assert_true(std::isinf(sun.at(0, 0, 0)) && !std::isinf(sun.at(0, kSize / 2, kSize / 2)));
        for (uint32_t face = 0; face < 6; ++face) {
            lamp.read(face);
            const bool down = face == 3;  // -Y
            const double depth = double{lamp.at(0, kSize / 2, kSize / 2)};
            shd_assert_close("lamp", face, depth, down ? 3.0 - double{kTop} : INFINITY, 1e-4, 0);
        }
    }
}

/// Depths of another map with the same margin; empty texels have the far depth.
std::vector<double> depths(shd_shadow_filter filter, shd_light_kind kind, uint32_t face)
{
    Map map(filter, kind);
    map.read(face);
    std::vector<double> out(kSize * kSize);
    for (size_t i = 0; i < out.size(); ++i) out[i] = std::fmin(double{map.column[0][i]}, double{map.info.far_plane});
    return out;
}

void test_moments(void **)
{
    for (const shd_light_kind kind : {SHD_LIGHT_KIND_DIRECTIONAL, SHD_LIGHT_KIND_POINT}) {
        const uint32_t face = kind == SHD_LIGHT_KIND_POINT ? 3 : 0;
        const std::vector<double> depth = depths(SHD_SHADOW_FILTER_PCF, kind, face);
        Map map(SHD_SHADOW_FILTER_VARIANCE, kind);
        map.read(face);
        const auto at = [&](int32_t x, int32_t y) {
            const auto size = static_cast<int32_t>(kSize);
            const bool inside = x >= 0 && y >= 0 && x < size && y < size;
            return inside ? depth[static_cast<size_t>(y * size + x)] : double{map.info.far_plane};
        };
        for (uint32_t i = 0; i < kSize * kSize; ++i) {
            const int32_t before = (kTaps - 1) / 2, x = static_cast<int32_t>(i % kSize) - before;
            const int32_t y = static_cast<int32_t>(i / kSize) - before;
            double mean = 0, variance = 0;
            for (int32_t k = 0; k < 16; ++k) mean += at(x + k % 4, y + k / 4) / 16;
            for (int32_t k = 0; k < 16; ++k) variance += std::pow(at(x + k % 4, y + k / 4) - mean, 2) / 16;
            shd_assert_close("mean", i, double{map.column[0][i]}, mean, 1e-6, 2e-7);
            shd_assert_close("variance", i, double{map.column[1][i]}, variance, 1e-9, 1e-6);
        }
    }
}

void test_sums(void **)
{
    const std::vector<double> depth = depths(SHD_SHADOW_FILTER_PCSS, SHD_LIGHT_KIND_POINT, 3);
    Map map(SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, SHD_LIGHT_KIND_POINT);
    map.read(3);
    assert_int_equal(map.info.width, kSize + 1);
    const double near = double{map.info.near_plane}, far = double{map.info.far_plane};
    for (uint32_t y = 0; y <= kSize; ++y) {
        for (uint32_t x = 0; x <= kSize; ++x) {
            double sum = 0, squares = 0;
            for (uint32_t k = 0; k < y * kSize; ++k) {
                if (k % kSize >= x) continue;
                const double s = (depth[k] - (near + far) / 2) / (far - near);
                sum += s, squares += s * s;
            }
            const double texels = x * y;  // a texel is rounded to 2^-25, its square to 2^-28
            shd_assert_close("sum", y * kSize + x, double{map.at(0, x, y)}, sum, texels * 0x1p-25, 1e-7);
            shd_assert_close("squares", y * kSize + x, double{map.at(1, x, y)}, squares, texels * 0x1p-25, 1e-7);
        }
    }
}

void test_refusals(void **)
{
    constexpr shd_result kBad = SHD_ERROR_INVALID_ARGUMENT;
    std::vector<float> values(3 * kSize * kSize, -7.0f);
    const shd_f32_out one[2] = {{values.data(), 0}, {nullptr, 0}};
    const shd_f32_out two[2] = {{values.data(), 12}, {values.data() + 2, 12}};
    const shd_f32_out same[2] = {{values.data(), 0}, {values.data() + 1, 0}};
    shd_shadow *empty = nullptr;
    shd_shadow_info info = shd_shadow_info_default();
    shd_assert_ok(shd_shadow_create(g.context, nullptr, &empty));
    shd_assert_result("not rendered", shd_shadow_read_map(empty, 0, one), kBad, "shadow: it was not rendered yet");
    shd_assert_ok(shd_shadow_get_info(empty, &info));
    assert_true(info.width == 1024 && info.face_count == 0 && info.byte_size == 0);
    shd_shadow_release(empty);
    shd_assert_result("info", shd_shadow_get_info(nullptr, &info), kBad, "shadow");
    assert_int_equal(info.width, 0);
    Map hard(SHD_SHADOW_FILTER_HARD, SHD_LIGHT_KIND_DIRECTIONAL),
        moments(SHD_SHADOW_FILTER_VARIANCE, SHD_LIGHT_KIND_DIRECTIONAL);
    shd_assert_result("info", shd_shadow_get_info(hard.shadow, nullptr), kBad, "out_info: NULL");
    shd_assert_result("face", shd_shadow_read_map(hard.shadow, 1, one), kBad, "face: 1 is not in 0..0");
    shd_assert_result("out", shd_shadow_read_map(hard.shadow, 0, nullptr), kBad, "out: NULL");
    shd_assert_result("second", shd_shadow_read_map(hard.shadow, 0, two), kBad, "out[1].data: not NULL, but filter 0");
    shd_assert_result("overlap", shd_shadow_read_map(moments.shadow, 0, same), kBad, "out[1]: overlaps out[0]");
    assert_true(std::all_of(values.begin(), values.end(), [](float value) { return value == -7.0f; }));
    moments.read(0);
    shd_assert_ok(shd_shadow_read_map(moments.shadow, 0, two));
    for (size_t i = 0; i < kSize * kSize; ++i) {
        assert_true(values[3 * i] == moments.column[0][i] && values[3 * i + 1] == -7.0f);
        assert_true(values[3 * i + 2] == moments.column[1][i]);
    }
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    const CMUnitTest tests[] = {cmocka_unit_test(test_depths), cmocka_unit_test(test_moments),
                                cmocka_unit_test(test_sums), cmocka_unit_test(test_refusals)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
