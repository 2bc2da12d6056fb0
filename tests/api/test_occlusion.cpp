// SPDX-License-Identifier: MIT
// Ambient occlusion against form factors and rays in double: by a tracer and by depth maps.
#include "support/occlusion_scene.h"
#include "support/random.h"

namespace shd::tests
{
namespace
{

constexpr double kPi = 3.14159265358979323846;

// ---- form factors ----

struct factor_case {
    const char *name;
    Method method;
    uint32_t rays;
    double tolerance;  // largest error of a point
};
constexpr factor_case k_factors[] = {
    {"factors/tracer", kTracer, 2048, 0.015},
    {"factors/maps", kMaps, 100, 0.03},
};

/// A floor alone is open everywhere, exactly.
void test_open(void **state)
{
    const auto &c = *static_cast<const factor_case *>(*state);
    Solid solid;
    Columns columns;
    Random random = {3};
    add_quad(&solid, {-10, 0, 10}, {20, 0, 0}, {0, 0, -20});
    finish(&solid);
    for (int i = 0; i < 300; ++i) add_point(columns, {random.in(-9, 9), 0, random.in(-9, 9)}, {0, 3, 0});
    for (float value : compute(desc_of(&solid, c.method, c.rays / 16), columns)) assert_true(value == 1.0f);
    close(&solid);
}

/// A wide wall of height h hides (1 - d / sqrt(d^2 + h^2)) / 2 of the sky at the distance d: one half at its foot.
void test_wall(void **state)
{
    const auto &c = *static_cast<const factor_case *>(*state);
    Solid solid;
    Columns columns;
    // Nearer than a few texels of a map, light leaks through the contact.
    const double distance[] = {c.method == kTracer ? 0.001 : 0.5, 1, 2, 5};
    add_quad(&solid, {-30, 0, 10}, {60, 0, 0}, {0, 0, -20});
    add_quad(&solid, {-30, 0, -10}, {60, 0, 0}, {0, 2, 0});
    finish(&solid);
    for (double d : distance) add_point(columns, {0.3, 0, d - 10}, {0, 1, 0});
    shd_occlusion_desc desc = desc_of(&solid, c.method, c.rays);
    desc.map_size = 768;
    const std::vector<float> values = compute(desc, columns);
    for (size_t i = 0; i < values.size(); ++i) {
        const double want = 1 - (1 - distance[i] / std::hypot(distance[i], 2.0)) / 2;
        shd_assert_close("wall", i, values[i], want, c.tolerance, 0);
    }
    close(&solid);
}

/// A sphere of radius r at distance d hides cos(a) (r / d)^2 of the sky, if it is above the horizon.
void test_sphere(void **state)
{
    const auto &c = *static_cast<const factor_case *>(*state);
    Solid solid;
    Columns columns;
    shd_shape_desc sphere = shd_shape_desc_default();
    sphere.segments[0] = 96;
    sphere.segments[1] = 48;
    add_shape(&solid, sphere, {0, 3, 0});
    add_quad(&solid, {-8, 0, 8}, {16, 0, 0}, {0, 0, -16});
    finish(&solid);
    for (int i = 0; i < 20; ++i) add_point(columns, {0.35 * i, 0, 0.1 * i}, {0, 1, 0});
    const std::vector<float> values = compute(desc_of(&solid, c.method, c.rays), columns);
    for (size_t i = 0; i < values.size(); ++i) {
        const double x = columns[0][i], z = columns[2][i], d = std::sqrt(x * x + z * z + 9);
        shd_assert_close("sphere", i, values[i], 1 - 3 / d / (d * d), c.tolerance, 0);
    }
    close(&solid);
}

/// Occluders beyond the radius do not count, those within it do.
void test_radius(void **state)
{
    const auto &c = *static_cast<const factor_case *>(*state);
    Solid solid;
    Columns columns;
    add_quad(&solid, {-20, 2, 20}, {40, 0, 0}, {0, 0, -40});
    finish(&solid);
    add_point(columns, {0, 0, 0}, {0, 1, 0});
    add_point(columns, {1, 1, 3}, {0, 1, 0});
    shd_occlusion_desc desc = desc_of(&solid, c.method, c.method == kMaps ? 40 : c.rays / 4);
    const float radius[] = {FLT_MAX, INFINITY, 0.75f, 1.75f, 2 * 1.41421356f};
    for (float r : radius) {
        desc.radius = r;
        const std::vector<float> values = compute(desc, columns);
        // Directions at an angle a with height / cos a below the radius are blocked: 1 - (h / r)^2 of the weight.
        for (size_t i = 0; i < 2; ++i) {
            const double h = i ? 1 : 2, ratio = r > 1e9f ? 0 : h / double{r};
            const double horizon = r > 1e9f ? 0.015 : 0;
            shd_assert_close("radius", i, values[i], ratio < 1 ? ratio * ratio : 1, 2 * c.tolerance + horizon, 0);
        }
    }
    close(&solid);
}

// ---- the oracle ----

/// The part of the sky that is open above a point, from n x n stratified rays in double.
double open_sky(const Solid &solid, const Vec3 &p, const Vec3 &n, double radius, int count)
{
    const Vec3 axis = std::fabs(n[0]) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 t = ref::unit(ref::cross(axis, n)), b = ref::cross(n, t), from = p + 1e-5 * n;
    int open = 0;
    for (int i = 0; i < count * count; ++i) {
        const double u = (i % count + 0.5) / count, v = 2 * kPi * (i / count + 0.5) / count, r = std::sqrt(u);
        const Vec3 way = r * std::cos(v) * t + r * std::sin(v) * b + std::sqrt(1 - u) * n;
        open += !solid.rays->is_blocked(from, radius * way);
    }
    return double(open) / (count * count);
}

/// The vertices of a teapot, with unlimited and small radius: mean and largest difference from the oracle.
void test_teapot(void **state)
{
    const auto &c = *static_cast<const factor_case *>(*state);
    Solid solid;
    shd_shape_desc teapot = shd_shape_desc_default();
    teapot.kind = SHD_SHAPE_TEAPOT;
    teapot.segments[0] = 6;
    add_shape(&solid, teapot, {0, 0, 0});
    finish(&solid);
    shd_mesh_info info = shd_mesh_info_default();
    shd_assert_ok(shd_mesh_get_info(solid.mesh, &info));
    std::vector<float> normal[3], value(info.vertex_count);
    shd_f32_out out[3];
    for (size_t k = 0; k < 3; ++k) {
        normal[k].resize(info.vertex_count);
        out[k] = {normal[k].data(), 0};
    }
    shd_assert_ok(shd_mesh_read_normals(solid.mesh, out));
    shd_occlusion_desc desc = desc_of(&solid, c.method, c.method == kTracer ? 256 : 64);
    const shd_f32_out column = {value.data(), 0};
    shd_assert_ok(shd_occlusion_compute_vertices(g_context, &desc, &solid.draw, &column));
    double sum = 0, square = 0, lowest = 1;
    size_t count = 0;
    for (size_t i = 0; i < value.size(); i += 11 * SHD_ORACLE_STRIDE, ++count) {
        const Vec3 p = {solid.position[3 * i], solid.position[3 * i + 1], solid.position[3 * i + 2]};
        const double want = open_sky(solid, p, {normal[0][i], normal[1][i], normal[2][i]}, 1e3, 24);
        const double error = double{value[i]} - want;
        sum += error;
        square += error * error;
        lowest = std::fmin(lowest, want);
        shd_assert_close("vertex", i, value[i], want, c.method == kTracer ? 0.08 : 0.5, 0);
    }
    const double mean = sum / double(count), rms = std::sqrt(square / double(count));
    print_message("%zu vertices: mean error %.4f, rms %.4f\n", count, mean, rms);
    assert_true(lowest < 0.3);  // enclosed vertices are among them
    assert_true(std::fabs(mean) < (c.method == kTracer ? 0.01 : 0.04) && rms < (c.method == kTracer ? 0.03 : 0.09));
    close(&solid);
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    CMUnitTest tests[16];
    size_t n = 0;
    const auto add = [&](const char *name, CMUnitTestFunction body, const void *row) {
        tests[n++] = {name, body, nullptr, nullptr, const_cast<void *>(row)};
    };
    for (const factor_case &c : k_factors) {
        add(c.method == kTracer ? "open/tracer" : "open/maps", test_open, &c);
        add(c.method == kTracer ? "wall/tracer" : "wall/maps", test_wall, &c);
        add(c.method == kTracer ? "sphere/tracer" : "sphere/maps", test_sphere, &c);
        add(c.method == kTracer ? "radius/tracer" : "radius/maps", test_radius, &c);
        add(c.method == kTracer ? "teapot/tracer" : "teapot/maps", test_teapot, &c);
    }
    return _cmocka_run_group_tests("api.occlusion", tests, n, set_up, tear_down);
}
